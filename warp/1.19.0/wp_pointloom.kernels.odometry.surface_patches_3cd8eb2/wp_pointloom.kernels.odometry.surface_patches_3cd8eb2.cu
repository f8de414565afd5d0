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


// <pointloom.kernels.odometry.surface_patches.sectors_in_map>:1
static CUDA_CALLABLE wp::int32 sectors_in_map_0(
    wp::vec_t<3, wp::float64> var_center,
    wp::float32 var_radius,
    wp::vec_t<3, wp::float64> var_u,
    wp::vec_t<3, wp::float64> var_v,
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
    const wp::int32 var_2 = 1;
    const wp::int32 var_3 = 1;
    const wp::int32 var_4 = 1;
    wp::vec_t<3, wp::int32> var_5;
    wp::float32 var_6;
    const wp::int32 var_7 = 0;
    wp::int32 var_8;
    wp::float32 var_9;
    const wp::int32 var_10 = 0;
    const wp::int32 var_11 = 2;
    wp::int32 var_12;
    wp::int32 var_13;
    const wp::int32 var_14 = 2;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    bool var_18;
    const wp::int32 var_19 = 0;
    const wp::int32 var_20 = 1;
    wp::int32 var_21;
    wp::int32 var_22;
    const wp::int32 var_23 = 1;
    wp::float32 var_24;
    wp::float32 var_25;
    wp::float32 var_26;
    wp::float32 var_27;
    wp::float32 var_28;
    bool var_29;
    const wp::int32 var_30 = 0;
    const wp::int32 var_31 = 0;
    wp::int32 var_32;
    wp::int32 var_33;
    const wp::int32 var_34 = 0;
    wp::float32 var_35;
    wp::float32 var_36;
    wp::float32 var_37;
    wp::float32 var_38;
    wp::float32 var_39;
    wp::float32 var_40;
    wp::float32 var_41;
    bool var_42;
    const wp::int32 var_43 = 0;
    wp::int32 var_44;
    wp::int32 var_45;
    const wp::int32 var_46 = 1;
    wp::int32 var_47;
    wp::int32 var_48;
    const wp::int32 var_49 = 2;
    wp::int32 var_50;
    wp::int32 var_51;
    wp::int64 var_52;
    wp::int32 var_53;
    const wp::int32 var_54 = 0;
    bool var_55;
    wp::float32 var_56;
    wp::float32 var_57;
    wp::float32 var_58;
    wp::float32 var_59;
    wp::float32 var_60;
    wp::float32 var_61;
    wp::vec_t<3, wp::float32> var_62;
    wp::int32 var_63;
    wp::int32* var_64;
    wp::int32 var_65;
    wp::int32 var_66;
    wp::range_t var_67;
    wp::int32 var_68;
    wp::vec_t<3, wp::float32>* var_69;
    wp::vec_t<3, wp::float32> var_70;
    wp::vec_t<3, wp::float32> var_71;
    wp::vec_t<3, wp::float32> var_72;
    wp::vec_t<3, wp::float64> var_73;
    wp::float64 var_74;
    wp::float32 var_75;
    bool var_76;
    bool var_77;
    const wp::float32 var_78 = 0.0625;
    wp::float32 var_79;
    bool var_80;
    wp::float64 var_81;
    wp::float64 var_82;
    const wp::int32 var_83 = 0;
    wp::int32 var_84;
    wp::float64 var_85;
    bool var_86;
    const wp::int32 var_87 = 1;
    wp::int32 var_88;
    wp::int32 var_89;
    wp::float64 var_90;
    bool var_91;
    const wp::int32 var_92 = 2;
    wp::int32 var_93;
    wp::int32 var_94;
    wp::float64 var_95;
    wp::float64 var_96;
    bool var_97;
    const wp::int32 var_98 = 4;
    wp::int32 var_99;
    wp::int32 var_100;
    const wp::int32 var_101 = 1;
    wp::int32 var_102;
    wp::int32 var_103;
    wp::int32 var_104;
    const wp::int32 var_105 = 1;
    const wp::int32 var_106 = 0;
    wp::int32 var_107;
    wp::int32 var_108;
    const wp::int32 var_109 = 0;
    wp::float32 var_110;
    wp::float32 var_111;
    wp::float32 var_112;
    wp::float32 var_113;
    wp::float32 var_114;
    wp::float32 var_115;
    wp::float32 var_116;
    bool var_117;
    const wp::int32 var_118 = 0;
    wp::int32 var_119;
    wp::int32 var_120;
    const wp::int32 var_121 = 1;
    wp::int32 var_122;
    wp::int32 var_123;
    const wp::int32 var_124 = 2;
    wp::int32 var_125;
    wp::int32 var_126;
    wp::int64 var_127;
    wp::int32 var_128;
    const wp::int32 var_129 = 0;
    bool var_130;
    wp::float32 var_131;
    wp::float32 var_132;
    wp::float32 var_133;
    wp::float32 var_134;
    wp::float32 var_135;
    wp::float32 var_136;
    wp::vec_t<3, wp::float32> var_137;
    wp::int32 var_138;
    wp::int32* var_139;
    wp::int32 var_140;
    wp::int32 var_141;
    wp::range_t var_142;
    wp::int32 var_143;
    wp::vec_t<3, wp::float32>* var_144;
    wp::vec_t<3, wp::float32> var_145;
    wp::vec_t<3, wp::float32> var_146;
    wp::vec_t<3, wp::float32> var_147;
    wp::vec_t<3, wp::float64> var_148;
    wp::float64 var_149;
    wp::float32 var_150;
    bool var_151;
    bool var_152;
    wp::float32 var_153;
    bool var_154;
    wp::float64 var_155;
    wp::float64 var_156;
    const wp::int32 var_157 = 0;
    wp::int32 var_158;
    wp::float64 var_159;
    bool var_160;
    const wp::int32 var_161 = 1;
    wp::int32 var_162;
    wp::int32 var_163;
    wp::float64 var_164;
    bool var_165;
    const wp::int32 var_166 = 2;
    wp::int32 var_167;
    wp::int32 var_168;
    wp::float64 var_169;
    wp::float64 var_170;
    bool var_171;
    const wp::int32 var_172 = 4;
    wp::int32 var_173;
    wp::int32 var_174;
    const wp::int32 var_175 = 1;
    wp::int32 var_176;
    wp::int32 var_177;
    wp::int32 var_178;
    wp::float64 var_179;
    wp::float64 var_180;
    wp::int32 var_181;
    wp::vec_t<3, wp::float32> var_182;
    wp::int32 var_183;
    wp::int32 var_184;
    wp::int32 var_185;
    wp::vec_t<3, wp::float32> var_186;
    wp::int32 var_187;
    wp::int32 var_188;
    const wp::int32 var_189 = 2;
    const wp::int32 var_190 = 0;
    wp::int32 var_191;
    wp::int32 var_192;
    const wp::int32 var_193 = 0;
    wp::float32 var_194;
    wp::float32 var_195;
    wp::float32 var_196;
    wp::float32 var_197;
    wp::float32 var_198;
    wp::float32 var_199;
    wp::float32 var_200;
    bool var_201;
    const wp::int32 var_202 = 0;
    wp::int32 var_203;
    wp::int32 var_204;
    const wp::int32 var_205 = 1;
    wp::int32 var_206;
    wp::int32 var_207;
    const wp::int32 var_208 = 2;
    wp::int32 var_209;
    wp::int32 var_210;
    wp::int64 var_211;
    wp::int32 var_212;
    const wp::int32 var_213 = 0;
    bool var_214;
    wp::float32 var_215;
    wp::float32 var_216;
    wp::float32 var_217;
    wp::float32 var_218;
    wp::float32 var_219;
    wp::float32 var_220;
    wp::vec_t<3, wp::float32> var_221;
    wp::int32 var_222;
    wp::int32* var_223;
    wp::int32 var_224;
    wp::int32 var_225;
    wp::range_t var_226;
    wp::int32 var_227;
    wp::vec_t<3, wp::float32>* var_228;
    wp::vec_t<3, wp::float32> var_229;
    wp::vec_t<3, wp::float32> var_230;
    wp::vec_t<3, wp::float32> var_231;
    wp::vec_t<3, wp::float64> var_232;
    wp::float64 var_233;
    wp::float32 var_234;
    bool var_235;
    bool var_236;
    wp::float32 var_237;
    bool var_238;
    wp::float64 var_239;
    wp::float64 var_240;
    const wp::int32 var_241 = 0;
    wp::int32 var_242;
    wp::float64 var_243;
    bool var_244;
    const wp::int32 var_245 = 1;
    wp::int32 var_246;
    wp::int32 var_247;
    wp::float64 var_248;
    bool var_249;
    const wp::int32 var_250 = 2;
    wp::int32 var_251;
    wp::int32 var_252;
    wp::float64 var_253;
    wp::float64 var_254;
    bool var_255;
    const wp::int32 var_256 = 4;
    wp::int32 var_257;
    wp::int32 var_258;
    const wp::int32 var_259 = 1;
    wp::int32 var_260;
    wp::int32 var_261;
    wp::int32 var_262;
    wp::float64 var_263;
    wp::float64 var_264;
    wp::int32 var_265;
    wp::vec_t<3, wp::float32> var_266;
    wp::int32 var_267;
    wp::int32 var_268;
    wp::int32 var_269;
    wp::vec_t<3, wp::float32> var_270;
    wp::int32 var_271;
    wp::int32 var_272;
    const wp::int32 var_273 = 1;
    const wp::int32 var_274 = 1;
    wp::int32 var_275;
    wp::int32 var_276;
    const wp::int32 var_277 = 1;
    wp::float32 var_278;
    wp::float32 var_279;
    wp::float32 var_280;
    wp::float32 var_281;
    wp::float32 var_282;
    bool var_283;
    const wp::int32 var_284 = 0;
    const wp::int32 var_285 = 0;
    wp::int32 var_286;
    wp::int32 var_287;
    const wp::int32 var_288 = 0;
    wp::float32 var_289;
    wp::float32 var_290;
    wp::float32 var_291;
    wp::float32 var_292;
    wp::float32 var_293;
    wp::float32 var_294;
    wp::float32 var_295;
    bool var_296;
    const wp::int32 var_297 = 0;
    wp::int32 var_298;
    wp::int32 var_299;
    const wp::int32 var_300 = 1;
    wp::int32 var_301;
    wp::int32 var_302;
    const wp::int32 var_303 = 2;
    wp::int32 var_304;
    wp::int32 var_305;
    wp::int64 var_306;
    wp::int32 var_307;
    const wp::int32 var_308 = 0;
    bool var_309;
    wp::float32 var_310;
    wp::float32 var_311;
    wp::float32 var_312;
    wp::float32 var_313;
    wp::float32 var_314;
    wp::float32 var_315;
    wp::vec_t<3, wp::float32> var_316;
    wp::int32 var_317;
    wp::int32* var_318;
    wp::int32 var_319;
    wp::int32 var_320;
    wp::range_t var_321;
    wp::int32 var_322;
    wp::vec_t<3, wp::float32>* var_323;
    wp::vec_t<3, wp::float32> var_324;
    wp::vec_t<3, wp::float32> var_325;
    wp::vec_t<3, wp::float32> var_326;
    wp::vec_t<3, wp::float64> var_327;
    wp::float64 var_328;
    wp::float32 var_329;
    bool var_330;
    bool var_331;
    wp::float32 var_332;
    bool var_333;
    wp::float64 var_334;
    wp::float64 var_335;
    const wp::int32 var_336 = 0;
    wp::int32 var_337;
    wp::float64 var_338;
    bool var_339;
    const wp::int32 var_340 = 1;
    wp::int32 var_341;
    wp::int32 var_342;
    wp::float64 var_343;
    bool var_344;
    const wp::int32 var_345 = 2;
    wp::int32 var_346;
    wp::int32 var_347;
    wp::float64 var_348;
    wp::float64 var_349;
    bool var_350;
    const wp::int32 var_351 = 4;
    wp::int32 var_352;
    wp::int32 var_353;
    const wp::int32 var_354 = 1;
    wp::int32 var_355;
    wp::int32 var_356;
    wp::int32 var_357;
    wp::float64 var_358;
    wp::float64 var_359;
    wp::int32 var_360;
    wp::vec_t<3, wp::float32> var_361;
    wp::int32 var_362;
    wp::int32 var_363;
    wp::int32 var_364;
    wp::vec_t<3, wp::float32> var_365;
    wp::int32 var_366;
    wp::int32 var_367;
    const wp::int32 var_368 = 1;
    const wp::int32 var_369 = 0;
    wp::int32 var_370;
    wp::int32 var_371;
    const wp::int32 var_372 = 0;
    wp::float32 var_373;
    wp::float32 var_374;
    wp::float32 var_375;
    wp::float32 var_376;
    wp::float32 var_377;
    wp::float32 var_378;
    wp::float32 var_379;
    bool var_380;
    const wp::int32 var_381 = 0;
    wp::int32 var_382;
    wp::int32 var_383;
    const wp::int32 var_384 = 1;
    wp::int32 var_385;
    wp::int32 var_386;
    const wp::int32 var_387 = 2;
    wp::int32 var_388;
    wp::int32 var_389;
    wp::int64 var_390;
    wp::int32 var_391;
    const wp::int32 var_392 = 0;
    bool var_393;
    wp::float32 var_394;
    wp::float32 var_395;
    wp::float32 var_396;
    wp::float32 var_397;
    wp::float32 var_398;
    wp::float32 var_399;
    wp::vec_t<3, wp::float32> var_400;
    wp::int32 var_401;
    wp::int32* var_402;
    wp::int32 var_403;
    wp::int32 var_404;
    wp::range_t var_405;
    wp::int32 var_406;
    wp::vec_t<3, wp::float32>* var_407;
    wp::vec_t<3, wp::float32> var_408;
    wp::vec_t<3, wp::float32> var_409;
    wp::vec_t<3, wp::float32> var_410;
    wp::vec_t<3, wp::float64> var_411;
    wp::float64 var_412;
    wp::float32 var_413;
    bool var_414;
    bool var_415;
    wp::float32 var_416;
    bool var_417;
    wp::float64 var_418;
    wp::float64 var_419;
    const wp::int32 var_420 = 0;
    wp::int32 var_421;
    wp::float64 var_422;
    bool var_423;
    const wp::int32 var_424 = 1;
    wp::int32 var_425;
    wp::int32 var_426;
    wp::float64 var_427;
    bool var_428;
    const wp::int32 var_429 = 2;
    wp::int32 var_430;
    wp::int32 var_431;
    wp::float64 var_432;
    wp::float64 var_433;
    bool var_434;
    const wp::int32 var_435 = 4;
    wp::int32 var_436;
    wp::int32 var_437;
    const wp::int32 var_438 = 1;
    wp::int32 var_439;
    wp::int32 var_440;
    wp::int32 var_441;
    wp::float64 var_442;
    wp::float64 var_443;
    wp::int32 var_444;
    wp::vec_t<3, wp::float32> var_445;
    wp::int32 var_446;
    wp::int32 var_447;
    wp::int32 var_448;
    wp::vec_t<3, wp::float32> var_449;
    wp::int32 var_450;
    wp::int32 var_451;
    const wp::int32 var_452 = 2;
    const wp::int32 var_453 = 0;
    wp::int32 var_454;
    wp::int32 var_455;
    const wp::int32 var_456 = 0;
    wp::float32 var_457;
    wp::float32 var_458;
    wp::float32 var_459;
    wp::float32 var_460;
    wp::float32 var_461;
    wp::float32 var_462;
    wp::float32 var_463;
    bool var_464;
    const wp::int32 var_465 = 0;
    wp::int32 var_466;
    wp::int32 var_467;
    const wp::int32 var_468 = 1;
    wp::int32 var_469;
    wp::int32 var_470;
    const wp::int32 var_471 = 2;
    wp::int32 var_472;
    wp::int32 var_473;
    wp::int64 var_474;
    wp::int32 var_475;
    const wp::int32 var_476 = 0;
    bool var_477;
    wp::float32 var_478;
    wp::float32 var_479;
    wp::float32 var_480;
    wp::float32 var_481;
    wp::float32 var_482;
    wp::float32 var_483;
    wp::vec_t<3, wp::float32> var_484;
    wp::int32 var_485;
    wp::int32* var_486;
    wp::int32 var_487;
    wp::int32 var_488;
    wp::range_t var_489;
    wp::int32 var_490;
    wp::vec_t<3, wp::float32>* var_491;
    wp::vec_t<3, wp::float32> var_492;
    wp::vec_t<3, wp::float32> var_493;
    wp::vec_t<3, wp::float32> var_494;
    wp::vec_t<3, wp::float64> var_495;
    wp::float64 var_496;
    wp::float32 var_497;
    bool var_498;
    bool var_499;
    wp::float32 var_500;
    bool var_501;
    wp::float64 var_502;
    wp::float64 var_503;
    const wp::int32 var_504 = 0;
    wp::int32 var_505;
    wp::float64 var_506;
    bool var_507;
    const wp::int32 var_508 = 1;
    wp::int32 var_509;
    wp::int32 var_510;
    wp::float64 var_511;
    bool var_512;
    const wp::int32 var_513 = 2;
    wp::int32 var_514;
    wp::int32 var_515;
    wp::float64 var_516;
    wp::float64 var_517;
    bool var_518;
    const wp::int32 var_519 = 4;
    wp::int32 var_520;
    wp::int32 var_521;
    const wp::int32 var_522 = 1;
    wp::int32 var_523;
    wp::int32 var_524;
    wp::int32 var_525;
    wp::float64 var_526;
    wp::float64 var_527;
    wp::int32 var_528;
    wp::vec_t<3, wp::float32> var_529;
    wp::int32 var_530;
    wp::int32 var_531;
    wp::int32 var_532;
    wp::vec_t<3, wp::float32> var_533;
    wp::int32 var_534;
    wp::int32 var_535;
    wp::int32 var_536;
    wp::int32 var_537;
    wp::float32 var_538;
    wp::int32 var_539;
    wp::vec_t<3, wp::float32> var_540;
    wp::int32 var_541;
    wp::int32 var_542;
    const wp::int32 var_543 = 2;
    const wp::int32 var_544 = 1;
    wp::int32 var_545;
    wp::int32 var_546;
    const wp::int32 var_547 = 1;
    wp::float32 var_548;
    wp::float32 var_549;
    wp::float32 var_550;
    wp::float32 var_551;
    wp::float32 var_552;
    bool var_553;
    const wp::int32 var_554 = 0;
    const wp::int32 var_555 = 0;
    wp::int32 var_556;
    wp::int32 var_557;
    const wp::int32 var_558 = 0;
    wp::float32 var_559;
    wp::float32 var_560;
    wp::float32 var_561;
    wp::float32 var_562;
    wp::float32 var_563;
    wp::float32 var_564;
    wp::float32 var_565;
    bool var_566;
    const wp::int32 var_567 = 0;
    wp::int32 var_568;
    wp::int32 var_569;
    const wp::int32 var_570 = 1;
    wp::int32 var_571;
    wp::int32 var_572;
    const wp::int32 var_573 = 2;
    wp::int32 var_574;
    wp::int32 var_575;
    wp::int64 var_576;
    wp::int32 var_577;
    const wp::int32 var_578 = 0;
    bool var_579;
    wp::float32 var_580;
    wp::float32 var_581;
    wp::float32 var_582;
    wp::float32 var_583;
    wp::float32 var_584;
    wp::float32 var_585;
    wp::vec_t<3, wp::float32> var_586;
    wp::int32 var_587;
    wp::int32* var_588;
    wp::int32 var_589;
    wp::int32 var_590;
    wp::range_t var_591;
    wp::int32 var_592;
    wp::vec_t<3, wp::float32>* var_593;
    wp::vec_t<3, wp::float32> var_594;
    wp::vec_t<3, wp::float32> var_595;
    wp::vec_t<3, wp::float32> var_596;
    wp::vec_t<3, wp::float64> var_597;
    wp::float64 var_598;
    wp::float32 var_599;
    bool var_600;
    bool var_601;
    wp::float32 var_602;
    bool var_603;
    wp::float64 var_604;
    wp::float64 var_605;
    const wp::int32 var_606 = 0;
    wp::int32 var_607;
    wp::float64 var_608;
    bool var_609;
    const wp::int32 var_610 = 1;
    wp::int32 var_611;
    wp::int32 var_612;
    wp::float64 var_613;
    bool var_614;
    const wp::int32 var_615 = 2;
    wp::int32 var_616;
    wp::int32 var_617;
    wp::float64 var_618;
    wp::float64 var_619;
    bool var_620;
    const wp::int32 var_621 = 4;
    wp::int32 var_622;
    wp::int32 var_623;
    const wp::int32 var_624 = 1;
    wp::int32 var_625;
    wp::int32 var_626;
    wp::int32 var_627;
    wp::float64 var_628;
    wp::float64 var_629;
    wp::int32 var_630;
    wp::vec_t<3, wp::float32> var_631;
    wp::int32 var_632;
    wp::int32 var_633;
    wp::int32 var_634;
    wp::vec_t<3, wp::float32> var_635;
    wp::int32 var_636;
    wp::int32 var_637;
    const wp::int32 var_638 = 1;
    const wp::int32 var_639 = 0;
    wp::int32 var_640;
    wp::int32 var_641;
    const wp::int32 var_642 = 0;
    wp::float32 var_643;
    wp::float32 var_644;
    wp::float32 var_645;
    wp::float32 var_646;
    wp::float32 var_647;
    wp::float32 var_648;
    wp::float32 var_649;
    bool var_650;
    const wp::int32 var_651 = 0;
    wp::int32 var_652;
    wp::int32 var_653;
    const wp::int32 var_654 = 1;
    wp::int32 var_655;
    wp::int32 var_656;
    const wp::int32 var_657 = 2;
    wp::int32 var_658;
    wp::int32 var_659;
    wp::int64 var_660;
    wp::int32 var_661;
    const wp::int32 var_662 = 0;
    bool var_663;
    wp::float32 var_664;
    wp::float32 var_665;
    wp::float32 var_666;
    wp::float32 var_667;
    wp::float32 var_668;
    wp::float32 var_669;
    wp::vec_t<3, wp::float32> var_670;
    wp::int32 var_671;
    wp::int32* var_672;
    wp::int32 var_673;
    wp::int32 var_674;
    wp::range_t var_675;
    wp::int32 var_676;
    wp::vec_t<3, wp::float32>* var_677;
    wp::vec_t<3, wp::float32> var_678;
    wp::vec_t<3, wp::float32> var_679;
    wp::vec_t<3, wp::float32> var_680;
    wp::vec_t<3, wp::float64> var_681;
    wp::float64 var_682;
    wp::float32 var_683;
    bool var_684;
    bool var_685;
    wp::float32 var_686;
    bool var_687;
    wp::float64 var_688;
    wp::float64 var_689;
    const wp::int32 var_690 = 0;
    wp::int32 var_691;
    wp::float64 var_692;
    bool var_693;
    const wp::int32 var_694 = 1;
    wp::int32 var_695;
    wp::int32 var_696;
    wp::float64 var_697;
    bool var_698;
    const wp::int32 var_699 = 2;
    wp::int32 var_700;
    wp::int32 var_701;
    wp::float64 var_702;
    wp::float64 var_703;
    bool var_704;
    const wp::int32 var_705 = 4;
    wp::int32 var_706;
    wp::int32 var_707;
    const wp::int32 var_708 = 1;
    wp::int32 var_709;
    wp::int32 var_710;
    wp::int32 var_711;
    wp::float64 var_712;
    wp::float64 var_713;
    wp::int32 var_714;
    wp::vec_t<3, wp::float32> var_715;
    wp::int32 var_716;
    wp::int32 var_717;
    wp::int32 var_718;
    wp::vec_t<3, wp::float32> var_719;
    wp::int32 var_720;
    wp::int32 var_721;
    const wp::int32 var_722 = 2;
    const wp::int32 var_723 = 0;
    wp::int32 var_724;
    wp::int32 var_725;
    const wp::int32 var_726 = 0;
    wp::float32 var_727;
    wp::float32 var_728;
    wp::float32 var_729;
    wp::float32 var_730;
    wp::float32 var_731;
    wp::float32 var_732;
    wp::float32 var_733;
    bool var_734;
    const wp::int32 var_735 = 0;
    wp::int32 var_736;
    wp::int32 var_737;
    const wp::int32 var_738 = 1;
    wp::int32 var_739;
    wp::int32 var_740;
    const wp::int32 var_741 = 2;
    wp::int32 var_742;
    wp::int32 var_743;
    wp::int64 var_744;
    wp::int32 var_745;
    const wp::int32 var_746 = 0;
    bool var_747;
    wp::float32 var_748;
    wp::float32 var_749;
    wp::float32 var_750;
    wp::float32 var_751;
    wp::float32 var_752;
    wp::float32 var_753;
    wp::vec_t<3, wp::float32> var_754;
    wp::int32 var_755;
    wp::int32* var_756;
    wp::int32 var_757;
    wp::int32 var_758;
    wp::range_t var_759;
    wp::int32 var_760;
    wp::vec_t<3, wp::float32>* var_761;
    wp::vec_t<3, wp::float32> var_762;
    wp::vec_t<3, wp::float32> var_763;
    wp::vec_t<3, wp::float32> var_764;
    wp::vec_t<3, wp::float64> var_765;
    wp::float64 var_766;
    wp::float32 var_767;
    bool var_768;
    bool var_769;
    wp::float32 var_770;
    bool var_771;
    wp::float64 var_772;
    wp::float64 var_773;
    const wp::int32 var_774 = 0;
    wp::int32 var_775;
    wp::float64 var_776;
    bool var_777;
    const wp::int32 var_778 = 1;
    wp::int32 var_779;
    wp::int32 var_780;
    wp::float64 var_781;
    bool var_782;
    const wp::int32 var_783 = 2;
    wp::int32 var_784;
    wp::int32 var_785;
    wp::float64 var_786;
    wp::float64 var_787;
    bool var_788;
    const wp::int32 var_789 = 4;
    wp::int32 var_790;
    wp::int32 var_791;
    const wp::int32 var_792 = 1;
    wp::int32 var_793;
    wp::int32 var_794;
    wp::int32 var_795;
    wp::float64 var_796;
    wp::float64 var_797;
    wp::int32 var_798;
    wp::vec_t<3, wp::float32> var_799;
    wp::int32 var_800;
    wp::int32 var_801;
    wp::int32 var_802;
    wp::vec_t<3, wp::float32> var_803;
    wp::int32 var_804;
    wp::int32 var_805;
    wp::int32 var_806;
    wp::int32 var_807;
    wp::float32 var_808;
    wp::int32 var_809;
    wp::vec_t<3, wp::float32> var_810;
    wp::int32 var_811;
    wp::int32 var_812;
    const wp::int32 var_813 = 1;
    const wp::int32 var_814 = 2;
    wp::int32 var_815;
    wp::int32 var_816;
    const wp::int32 var_817 = 2;
    wp::float32 var_818;
    wp::float32 var_819;
    wp::float32 var_820;
    bool var_821;
    const wp::int32 var_822 = 0;
    const wp::int32 var_823 = 1;
    wp::int32 var_824;
    wp::int32 var_825;
    const wp::int32 var_826 = 1;
    wp::float32 var_827;
    wp::float32 var_828;
    wp::float32 var_829;
    wp::float32 var_830;
    wp::float32 var_831;
    bool var_832;
    const wp::int32 var_833 = 0;
    const wp::int32 var_834 = 0;
    wp::int32 var_835;
    wp::int32 var_836;
    const wp::int32 var_837 = 0;
    wp::float32 var_838;
    wp::float32 var_839;
    wp::float32 var_840;
    wp::float32 var_841;
    wp::float32 var_842;
    wp::float32 var_843;
    wp::float32 var_844;
    bool var_845;
    const wp::int32 var_846 = 0;
    wp::int32 var_847;
    wp::int32 var_848;
    const wp::int32 var_849 = 1;
    wp::int32 var_850;
    wp::int32 var_851;
    const wp::int32 var_852 = 2;
    wp::int32 var_853;
    wp::int32 var_854;
    wp::int64 var_855;
    wp::int32 var_856;
    const wp::int32 var_857 = 0;
    bool var_858;
    wp::float32 var_859;
    wp::float32 var_860;
    wp::float32 var_861;
    wp::float32 var_862;
    wp::float32 var_863;
    wp::float32 var_864;
    wp::vec_t<3, wp::float32> var_865;
    wp::int32 var_866;
    wp::int32* var_867;
    wp::int32 var_868;
    wp::int32 var_869;
    wp::range_t var_870;
    wp::int32 var_871;
    wp::vec_t<3, wp::float32>* var_872;
    wp::vec_t<3, wp::float32> var_873;
    wp::vec_t<3, wp::float32> var_874;
    wp::vec_t<3, wp::float32> var_875;
    wp::vec_t<3, wp::float64> var_876;
    wp::float64 var_877;
    wp::float32 var_878;
    bool var_879;
    bool var_880;
    wp::float32 var_881;
    bool var_882;
    wp::float64 var_883;
    wp::float64 var_884;
    const wp::int32 var_885 = 0;
    wp::int32 var_886;
    wp::float64 var_887;
    bool var_888;
    const wp::int32 var_889 = 1;
    wp::int32 var_890;
    wp::int32 var_891;
    wp::float64 var_892;
    bool var_893;
    const wp::int32 var_894 = 2;
    wp::int32 var_895;
    wp::int32 var_896;
    wp::float64 var_897;
    wp::float64 var_898;
    bool var_899;
    const wp::int32 var_900 = 4;
    wp::int32 var_901;
    wp::int32 var_902;
    const wp::int32 var_903 = 1;
    wp::int32 var_904;
    wp::int32 var_905;
    wp::int32 var_906;
    wp::float64 var_907;
    wp::float64 var_908;
    wp::int32 var_909;
    wp::vec_t<3, wp::float32> var_910;
    wp::int32 var_911;
    wp::int32 var_912;
    wp::int32 var_913;
    wp::vec_t<3, wp::float32> var_914;
    wp::int32 var_915;
    wp::int32 var_916;
    const wp::int32 var_917 = 1;
    const wp::int32 var_918 = 0;
    wp::int32 var_919;
    wp::int32 var_920;
    const wp::int32 var_921 = 0;
    wp::float32 var_922;
    wp::float32 var_923;
    wp::float32 var_924;
    wp::float32 var_925;
    wp::float32 var_926;
    wp::float32 var_927;
    wp::float32 var_928;
    bool var_929;
    const wp::int32 var_930 = 0;
    wp::int32 var_931;
    wp::int32 var_932;
    const wp::int32 var_933 = 1;
    wp::int32 var_934;
    wp::int32 var_935;
    const wp::int32 var_936 = 2;
    wp::int32 var_937;
    wp::int32 var_938;
    wp::int64 var_939;
    wp::int32 var_940;
    const wp::int32 var_941 = 0;
    bool var_942;
    wp::float32 var_943;
    wp::float32 var_944;
    wp::float32 var_945;
    wp::float32 var_946;
    wp::float32 var_947;
    wp::float32 var_948;
    wp::vec_t<3, wp::float32> var_949;
    wp::int32 var_950;
    wp::int32* var_951;
    wp::int32 var_952;
    wp::int32 var_953;
    wp::range_t var_954;
    wp::int32 var_955;
    wp::vec_t<3, wp::float32>* var_956;
    wp::vec_t<3, wp::float32> var_957;
    wp::vec_t<3, wp::float32> var_958;
    wp::vec_t<3, wp::float32> var_959;
    wp::vec_t<3, wp::float64> var_960;
    wp::float64 var_961;
    wp::float32 var_962;
    bool var_963;
    bool var_964;
    wp::float32 var_965;
    bool var_966;
    wp::float64 var_967;
    wp::float64 var_968;
    const wp::int32 var_969 = 0;
    wp::int32 var_970;
    wp::float64 var_971;
    bool var_972;
    const wp::int32 var_973 = 1;
    wp::int32 var_974;
    wp::int32 var_975;
    wp::float64 var_976;
    bool var_977;
    const wp::int32 var_978 = 2;
    wp::int32 var_979;
    wp::int32 var_980;
    wp::float64 var_981;
    wp::float64 var_982;
    bool var_983;
    const wp::int32 var_984 = 4;
    wp::int32 var_985;
    wp::int32 var_986;
    const wp::int32 var_987 = 1;
    wp::int32 var_988;
    wp::int32 var_989;
    wp::int32 var_990;
    wp::float64 var_991;
    wp::float64 var_992;
    wp::int32 var_993;
    wp::vec_t<3, wp::float32> var_994;
    wp::int32 var_995;
    wp::int32 var_996;
    wp::int32 var_997;
    wp::vec_t<3, wp::float32> var_998;
    wp::int32 var_999;
    wp::int32 var_1000;
    const wp::int32 var_1001 = 2;
    const wp::int32 var_1002 = 0;
    wp::int32 var_1003;
    wp::int32 var_1004;
    const wp::int32 var_1005 = 0;
    wp::float32 var_1006;
    wp::float32 var_1007;
    wp::float32 var_1008;
    wp::float32 var_1009;
    wp::float32 var_1010;
    wp::float32 var_1011;
    wp::float32 var_1012;
    bool var_1013;
    const wp::int32 var_1014 = 0;
    wp::int32 var_1015;
    wp::int32 var_1016;
    const wp::int32 var_1017 = 1;
    wp::int32 var_1018;
    wp::int32 var_1019;
    const wp::int32 var_1020 = 2;
    wp::int32 var_1021;
    wp::int32 var_1022;
    wp::int64 var_1023;
    wp::int32 var_1024;
    const wp::int32 var_1025 = 0;
    bool var_1026;
    wp::float32 var_1027;
    wp::float32 var_1028;
    wp::float32 var_1029;
    wp::float32 var_1030;
    wp::float32 var_1031;
    wp::float32 var_1032;
    wp::vec_t<3, wp::float32> var_1033;
    wp::int32 var_1034;
    wp::int32* var_1035;
    wp::int32 var_1036;
    wp::int32 var_1037;
    wp::range_t var_1038;
    wp::int32 var_1039;
    wp::vec_t<3, wp::float32>* var_1040;
    wp::vec_t<3, wp::float32> var_1041;
    wp::vec_t<3, wp::float32> var_1042;
    wp::vec_t<3, wp::float32> var_1043;
    wp::vec_t<3, wp::float64> var_1044;
    wp::float64 var_1045;
    wp::float32 var_1046;
    bool var_1047;
    bool var_1048;
    wp::float32 var_1049;
    bool var_1050;
    wp::float64 var_1051;
    wp::float64 var_1052;
    const wp::int32 var_1053 = 0;
    wp::int32 var_1054;
    wp::float64 var_1055;
    bool var_1056;
    const wp::int32 var_1057 = 1;
    wp::int32 var_1058;
    wp::int32 var_1059;
    wp::float64 var_1060;
    bool var_1061;
    const wp::int32 var_1062 = 2;
    wp::int32 var_1063;
    wp::int32 var_1064;
    wp::float64 var_1065;
    wp::float64 var_1066;
    bool var_1067;
    const wp::int32 var_1068 = 4;
    wp::int32 var_1069;
    wp::int32 var_1070;
    const wp::int32 var_1071 = 1;
    wp::int32 var_1072;
    wp::int32 var_1073;
    wp::int32 var_1074;
    wp::float64 var_1075;
    wp::float64 var_1076;
    wp::int32 var_1077;
    wp::vec_t<3, wp::float32> var_1078;
    wp::int32 var_1079;
    wp::int32 var_1080;
    wp::int32 var_1081;
    wp::vec_t<3, wp::float32> var_1082;
    wp::int32 var_1083;
    wp::int32 var_1084;
    wp::int32 var_1085;
    wp::int32 var_1086;
    wp::float32 var_1087;
    wp::int32 var_1088;
    wp::vec_t<3, wp::float32> var_1089;
    wp::int32 var_1090;
    wp::int32 var_1091;
    const wp::int32 var_1092 = 1;
    const wp::int32 var_1093 = 1;
    wp::int32 var_1094;
    wp::int32 var_1095;
    const wp::int32 var_1096 = 1;
    wp::float32 var_1097;
    wp::float32 var_1098;
    wp::float32 var_1099;
    wp::float32 var_1100;
    wp::float32 var_1101;
    bool var_1102;
    const wp::int32 var_1103 = 0;
    const wp::int32 var_1104 = 0;
    wp::int32 var_1105;
    wp::int32 var_1106;
    const wp::int32 var_1107 = 0;
    wp::float32 var_1108;
    wp::float32 var_1109;
    wp::float32 var_1110;
    wp::float32 var_1111;
    wp::float32 var_1112;
    wp::float32 var_1113;
    wp::float32 var_1114;
    bool var_1115;
    const wp::int32 var_1116 = 0;
    wp::int32 var_1117;
    wp::int32 var_1118;
    const wp::int32 var_1119 = 1;
    wp::int32 var_1120;
    wp::int32 var_1121;
    const wp::int32 var_1122 = 2;
    wp::int32 var_1123;
    wp::int32 var_1124;
    wp::int64 var_1125;
    wp::int32 var_1126;
    const wp::int32 var_1127 = 0;
    bool var_1128;
    wp::float32 var_1129;
    wp::float32 var_1130;
    wp::float32 var_1131;
    wp::float32 var_1132;
    wp::float32 var_1133;
    wp::float32 var_1134;
    wp::vec_t<3, wp::float32> var_1135;
    wp::int32 var_1136;
    wp::int32* var_1137;
    wp::int32 var_1138;
    wp::int32 var_1139;
    wp::range_t var_1140;
    wp::int32 var_1141;
    wp::vec_t<3, wp::float32>* var_1142;
    wp::vec_t<3, wp::float32> var_1143;
    wp::vec_t<3, wp::float32> var_1144;
    wp::vec_t<3, wp::float32> var_1145;
    wp::vec_t<3, wp::float64> var_1146;
    wp::float64 var_1147;
    wp::float32 var_1148;
    bool var_1149;
    bool var_1150;
    wp::float32 var_1151;
    bool var_1152;
    wp::float64 var_1153;
    wp::float64 var_1154;
    const wp::int32 var_1155 = 0;
    wp::int32 var_1156;
    wp::float64 var_1157;
    bool var_1158;
    const wp::int32 var_1159 = 1;
    wp::int32 var_1160;
    wp::int32 var_1161;
    wp::float64 var_1162;
    bool var_1163;
    const wp::int32 var_1164 = 2;
    wp::int32 var_1165;
    wp::int32 var_1166;
    wp::float64 var_1167;
    wp::float64 var_1168;
    bool var_1169;
    const wp::int32 var_1170 = 4;
    wp::int32 var_1171;
    wp::int32 var_1172;
    const wp::int32 var_1173 = 1;
    wp::int32 var_1174;
    wp::int32 var_1175;
    wp::int32 var_1176;
    wp::float64 var_1177;
    wp::float64 var_1178;
    wp::int32 var_1179;
    wp::vec_t<3, wp::float32> var_1180;
    wp::int32 var_1181;
    wp::int32 var_1182;
    wp::int32 var_1183;
    wp::vec_t<3, wp::float32> var_1184;
    wp::int32 var_1185;
    wp::int32 var_1186;
    const wp::int32 var_1187 = 1;
    const wp::int32 var_1188 = 0;
    wp::int32 var_1189;
    wp::int32 var_1190;
    const wp::int32 var_1191 = 0;
    wp::float32 var_1192;
    wp::float32 var_1193;
    wp::float32 var_1194;
    wp::float32 var_1195;
    wp::float32 var_1196;
    wp::float32 var_1197;
    wp::float32 var_1198;
    bool var_1199;
    const wp::int32 var_1200 = 0;
    wp::int32 var_1201;
    wp::int32 var_1202;
    const wp::int32 var_1203 = 1;
    wp::int32 var_1204;
    wp::int32 var_1205;
    const wp::int32 var_1206 = 2;
    wp::int32 var_1207;
    wp::int32 var_1208;
    wp::int64 var_1209;
    wp::int32 var_1210;
    const wp::int32 var_1211 = 0;
    bool var_1212;
    wp::float32 var_1213;
    wp::float32 var_1214;
    wp::float32 var_1215;
    wp::float32 var_1216;
    wp::float32 var_1217;
    wp::float32 var_1218;
    wp::vec_t<3, wp::float32> var_1219;
    wp::int32 var_1220;
    wp::int32* var_1221;
    wp::int32 var_1222;
    wp::int32 var_1223;
    wp::range_t var_1224;
    wp::int32 var_1225;
    wp::vec_t<3, wp::float32>* var_1226;
    wp::vec_t<3, wp::float32> var_1227;
    wp::vec_t<3, wp::float32> var_1228;
    wp::vec_t<3, wp::float32> var_1229;
    wp::vec_t<3, wp::float64> var_1230;
    wp::float64 var_1231;
    wp::float32 var_1232;
    bool var_1233;
    bool var_1234;
    wp::float32 var_1235;
    bool var_1236;
    wp::float64 var_1237;
    wp::float64 var_1238;
    const wp::int32 var_1239 = 0;
    wp::int32 var_1240;
    wp::float64 var_1241;
    bool var_1242;
    const wp::int32 var_1243 = 1;
    wp::int32 var_1244;
    wp::int32 var_1245;
    wp::float64 var_1246;
    bool var_1247;
    const wp::int32 var_1248 = 2;
    wp::int32 var_1249;
    wp::int32 var_1250;
    wp::float64 var_1251;
    wp::float64 var_1252;
    bool var_1253;
    const wp::int32 var_1254 = 4;
    wp::int32 var_1255;
    wp::int32 var_1256;
    const wp::int32 var_1257 = 1;
    wp::int32 var_1258;
    wp::int32 var_1259;
    wp::int32 var_1260;
    wp::float64 var_1261;
    wp::float64 var_1262;
    wp::int32 var_1263;
    wp::vec_t<3, wp::float32> var_1264;
    wp::int32 var_1265;
    wp::int32 var_1266;
    wp::int32 var_1267;
    wp::vec_t<3, wp::float32> var_1268;
    wp::int32 var_1269;
    wp::int32 var_1270;
    const wp::int32 var_1271 = 2;
    const wp::int32 var_1272 = 0;
    wp::int32 var_1273;
    wp::int32 var_1274;
    const wp::int32 var_1275 = 0;
    wp::float32 var_1276;
    wp::float32 var_1277;
    wp::float32 var_1278;
    wp::float32 var_1279;
    wp::float32 var_1280;
    wp::float32 var_1281;
    wp::float32 var_1282;
    bool var_1283;
    const wp::int32 var_1284 = 0;
    wp::int32 var_1285;
    wp::int32 var_1286;
    const wp::int32 var_1287 = 1;
    wp::int32 var_1288;
    wp::int32 var_1289;
    const wp::int32 var_1290 = 2;
    wp::int32 var_1291;
    wp::int32 var_1292;
    wp::int64 var_1293;
    wp::int32 var_1294;
    const wp::int32 var_1295 = 0;
    bool var_1296;
    wp::float32 var_1297;
    wp::float32 var_1298;
    wp::float32 var_1299;
    wp::float32 var_1300;
    wp::float32 var_1301;
    wp::float32 var_1302;
    wp::vec_t<3, wp::float32> var_1303;
    wp::int32 var_1304;
    wp::int32* var_1305;
    wp::int32 var_1306;
    wp::int32 var_1307;
    wp::range_t var_1308;
    wp::int32 var_1309;
    wp::vec_t<3, wp::float32>* var_1310;
    wp::vec_t<3, wp::float32> var_1311;
    wp::vec_t<3, wp::float32> var_1312;
    wp::vec_t<3, wp::float32> var_1313;
    wp::vec_t<3, wp::float64> var_1314;
    wp::float64 var_1315;
    wp::float32 var_1316;
    bool var_1317;
    bool var_1318;
    wp::float32 var_1319;
    bool var_1320;
    wp::float64 var_1321;
    wp::float64 var_1322;
    const wp::int32 var_1323 = 0;
    wp::int32 var_1324;
    wp::float64 var_1325;
    bool var_1326;
    const wp::int32 var_1327 = 1;
    wp::int32 var_1328;
    wp::int32 var_1329;
    wp::float64 var_1330;
    bool var_1331;
    const wp::int32 var_1332 = 2;
    wp::int32 var_1333;
    wp::int32 var_1334;
    wp::float64 var_1335;
    wp::float64 var_1336;
    bool var_1337;
    const wp::int32 var_1338 = 4;
    wp::int32 var_1339;
    wp::int32 var_1340;
    const wp::int32 var_1341 = 1;
    wp::int32 var_1342;
    wp::int32 var_1343;
    wp::int32 var_1344;
    wp::float64 var_1345;
    wp::float64 var_1346;
    wp::int32 var_1347;
    wp::vec_t<3, wp::float32> var_1348;
    wp::int32 var_1349;
    wp::int32 var_1350;
    wp::int32 var_1351;
    wp::vec_t<3, wp::float32> var_1352;
    wp::int32 var_1353;
    wp::int32 var_1354;
    wp::int32 var_1355;
    wp::int32 var_1356;
    wp::float32 var_1357;
    wp::int32 var_1358;
    wp::vec_t<3, wp::float32> var_1359;
    wp::int32 var_1360;
    wp::int32 var_1361;
    const wp::int32 var_1362 = 2;
    const wp::int32 var_1363 = 1;
    wp::int32 var_1364;
    wp::int32 var_1365;
    const wp::int32 var_1366 = 1;
    wp::float32 var_1367;
    wp::float32 var_1368;
    wp::float32 var_1369;
    wp::float32 var_1370;
    wp::float32 var_1371;
    bool var_1372;
    const wp::int32 var_1373 = 0;
    const wp::int32 var_1374 = 0;
    wp::int32 var_1375;
    wp::int32 var_1376;
    const wp::int32 var_1377 = 0;
    wp::float32 var_1378;
    wp::float32 var_1379;
    wp::float32 var_1380;
    wp::float32 var_1381;
    wp::float32 var_1382;
    wp::float32 var_1383;
    wp::float32 var_1384;
    bool var_1385;
    const wp::int32 var_1386 = 0;
    wp::int32 var_1387;
    wp::int32 var_1388;
    const wp::int32 var_1389 = 1;
    wp::int32 var_1390;
    wp::int32 var_1391;
    const wp::int32 var_1392 = 2;
    wp::int32 var_1393;
    wp::int32 var_1394;
    wp::int64 var_1395;
    wp::int32 var_1396;
    const wp::int32 var_1397 = 0;
    bool var_1398;
    wp::float32 var_1399;
    wp::float32 var_1400;
    wp::float32 var_1401;
    wp::float32 var_1402;
    wp::float32 var_1403;
    wp::float32 var_1404;
    wp::vec_t<3, wp::float32> var_1405;
    wp::int32 var_1406;
    wp::int32* var_1407;
    wp::int32 var_1408;
    wp::int32 var_1409;
    wp::range_t var_1410;
    wp::int32 var_1411;
    wp::vec_t<3, wp::float32>* var_1412;
    wp::vec_t<3, wp::float32> var_1413;
    wp::vec_t<3, wp::float32> var_1414;
    wp::vec_t<3, wp::float32> var_1415;
    wp::vec_t<3, wp::float64> var_1416;
    wp::float64 var_1417;
    wp::float32 var_1418;
    bool var_1419;
    bool var_1420;
    wp::float32 var_1421;
    bool var_1422;
    wp::float64 var_1423;
    wp::float64 var_1424;
    const wp::int32 var_1425 = 0;
    wp::int32 var_1426;
    wp::float64 var_1427;
    bool var_1428;
    const wp::int32 var_1429 = 1;
    wp::int32 var_1430;
    wp::int32 var_1431;
    wp::float64 var_1432;
    bool var_1433;
    const wp::int32 var_1434 = 2;
    wp::int32 var_1435;
    wp::int32 var_1436;
    wp::float64 var_1437;
    wp::float64 var_1438;
    bool var_1439;
    const wp::int32 var_1440 = 4;
    wp::int32 var_1441;
    wp::int32 var_1442;
    const wp::int32 var_1443 = 1;
    wp::int32 var_1444;
    wp::int32 var_1445;
    wp::int32 var_1446;
    wp::float64 var_1447;
    wp::float64 var_1448;
    wp::int32 var_1449;
    wp::vec_t<3, wp::float32> var_1450;
    wp::int32 var_1451;
    wp::int32 var_1452;
    wp::int32 var_1453;
    wp::vec_t<3, wp::float32> var_1454;
    wp::int32 var_1455;
    wp::int32 var_1456;
    const wp::int32 var_1457 = 1;
    const wp::int32 var_1458 = 0;
    wp::int32 var_1459;
    wp::int32 var_1460;
    const wp::int32 var_1461 = 0;
    wp::float32 var_1462;
    wp::float32 var_1463;
    wp::float32 var_1464;
    wp::float32 var_1465;
    wp::float32 var_1466;
    wp::float32 var_1467;
    wp::float32 var_1468;
    bool var_1469;
    const wp::int32 var_1470 = 0;
    wp::int32 var_1471;
    wp::int32 var_1472;
    const wp::int32 var_1473 = 1;
    wp::int32 var_1474;
    wp::int32 var_1475;
    const wp::int32 var_1476 = 2;
    wp::int32 var_1477;
    wp::int32 var_1478;
    wp::int64 var_1479;
    wp::int32 var_1480;
    const wp::int32 var_1481 = 0;
    bool var_1482;
    wp::float32 var_1483;
    wp::float32 var_1484;
    wp::float32 var_1485;
    wp::float32 var_1486;
    wp::float32 var_1487;
    wp::float32 var_1488;
    wp::vec_t<3, wp::float32> var_1489;
    wp::int32 var_1490;
    wp::int32* var_1491;
    wp::int32 var_1492;
    wp::int32 var_1493;
    wp::range_t var_1494;
    wp::int32 var_1495;
    wp::vec_t<3, wp::float32>* var_1496;
    wp::vec_t<3, wp::float32> var_1497;
    wp::vec_t<3, wp::float32> var_1498;
    wp::vec_t<3, wp::float32> var_1499;
    wp::vec_t<3, wp::float64> var_1500;
    wp::float64 var_1501;
    wp::float32 var_1502;
    bool var_1503;
    bool var_1504;
    wp::float32 var_1505;
    bool var_1506;
    wp::float64 var_1507;
    wp::float64 var_1508;
    const wp::int32 var_1509 = 0;
    wp::int32 var_1510;
    wp::float64 var_1511;
    bool var_1512;
    const wp::int32 var_1513 = 1;
    wp::int32 var_1514;
    wp::int32 var_1515;
    wp::float64 var_1516;
    bool var_1517;
    const wp::int32 var_1518 = 2;
    wp::int32 var_1519;
    wp::int32 var_1520;
    wp::float64 var_1521;
    wp::float64 var_1522;
    bool var_1523;
    const wp::int32 var_1524 = 4;
    wp::int32 var_1525;
    wp::int32 var_1526;
    const wp::int32 var_1527 = 1;
    wp::int32 var_1528;
    wp::int32 var_1529;
    wp::int32 var_1530;
    wp::float64 var_1531;
    wp::float64 var_1532;
    wp::int32 var_1533;
    wp::vec_t<3, wp::float32> var_1534;
    wp::int32 var_1535;
    wp::int32 var_1536;
    wp::int32 var_1537;
    wp::vec_t<3, wp::float32> var_1538;
    wp::int32 var_1539;
    wp::int32 var_1540;
    const wp::int32 var_1541 = 2;
    const wp::int32 var_1542 = 0;
    wp::int32 var_1543;
    wp::int32 var_1544;
    const wp::int32 var_1545 = 0;
    wp::float32 var_1546;
    wp::float32 var_1547;
    wp::float32 var_1548;
    wp::float32 var_1549;
    wp::float32 var_1550;
    wp::float32 var_1551;
    wp::float32 var_1552;
    bool var_1553;
    const wp::int32 var_1554 = 0;
    wp::int32 var_1555;
    wp::int32 var_1556;
    const wp::int32 var_1557 = 1;
    wp::int32 var_1558;
    wp::int32 var_1559;
    const wp::int32 var_1560 = 2;
    wp::int32 var_1561;
    wp::int32 var_1562;
    wp::int64 var_1563;
    wp::int32 var_1564;
    const wp::int32 var_1565 = 0;
    bool var_1566;
    wp::float32 var_1567;
    wp::float32 var_1568;
    wp::float32 var_1569;
    wp::float32 var_1570;
    wp::float32 var_1571;
    wp::float32 var_1572;
    wp::vec_t<3, wp::float32> var_1573;
    wp::int32 var_1574;
    wp::int32* var_1575;
    wp::int32 var_1576;
    wp::int32 var_1577;
    wp::range_t var_1578;
    wp::int32 var_1579;
    wp::vec_t<3, wp::float32>* var_1580;
    wp::vec_t<3, wp::float32> var_1581;
    wp::vec_t<3, wp::float32> var_1582;
    wp::vec_t<3, wp::float32> var_1583;
    wp::vec_t<3, wp::float64> var_1584;
    wp::float64 var_1585;
    wp::float32 var_1586;
    bool var_1587;
    bool var_1588;
    wp::float32 var_1589;
    bool var_1590;
    wp::float64 var_1591;
    wp::float64 var_1592;
    const wp::int32 var_1593 = 0;
    wp::int32 var_1594;
    wp::float64 var_1595;
    bool var_1596;
    const wp::int32 var_1597 = 1;
    wp::int32 var_1598;
    wp::int32 var_1599;
    wp::float64 var_1600;
    bool var_1601;
    const wp::int32 var_1602 = 2;
    wp::int32 var_1603;
    wp::int32 var_1604;
    wp::float64 var_1605;
    wp::float64 var_1606;
    bool var_1607;
    const wp::int32 var_1608 = 4;
    wp::int32 var_1609;
    wp::int32 var_1610;
    const wp::int32 var_1611 = 1;
    wp::int32 var_1612;
    wp::int32 var_1613;
    wp::int32 var_1614;
    wp::float64 var_1615;
    wp::float64 var_1616;
    wp::int32 var_1617;
    wp::vec_t<3, wp::float32> var_1618;
    wp::int32 var_1619;
    wp::int32 var_1620;
    wp::int32 var_1621;
    wp::vec_t<3, wp::float32> var_1622;
    wp::int32 var_1623;
    wp::int32 var_1624;
    wp::int32 var_1625;
    wp::int32 var_1626;
    wp::float32 var_1627;
    wp::int32 var_1628;
    wp::vec_t<3, wp::float32> var_1629;
    wp::int32 var_1630;
    wp::int32 var_1631;
    wp::int32 var_1632;
    wp::int32 var_1633;
    wp::float32 var_1634;
    wp::int32 var_1635;
    wp::int32 var_1636;
    wp::float32 var_1637;
    wp::int32 var_1638;
    wp::vec_t<3, wp::float32> var_1639;
    wp::int32 var_1640;
    wp::int32 var_1641;
    const wp::int32 var_1642 = 2;
    const wp::int32 var_1643 = 2;
    wp::int32 var_1644;
    wp::int32 var_1645;
    const wp::int32 var_1646 = 2;
    wp::float32 var_1647;
    wp::float32 var_1648;
    wp::float32 var_1649;
    bool var_1650;
    const wp::int32 var_1651 = 0;
    const wp::int32 var_1652 = 1;
    wp::int32 var_1653;
    wp::int32 var_1654;
    const wp::int32 var_1655 = 1;
    wp::float32 var_1656;
    wp::float32 var_1657;
    wp::float32 var_1658;
    wp::float32 var_1659;
    wp::float32 var_1660;
    bool var_1661;
    const wp::int32 var_1662 = 0;
    const wp::int32 var_1663 = 0;
    wp::int32 var_1664;
    wp::int32 var_1665;
    const wp::int32 var_1666 = 0;
    wp::float32 var_1667;
    wp::float32 var_1668;
    wp::float32 var_1669;
    wp::float32 var_1670;
    wp::float32 var_1671;
    wp::float32 var_1672;
    wp::float32 var_1673;
    bool var_1674;
    const wp::int32 var_1675 = 0;
    wp::int32 var_1676;
    wp::int32 var_1677;
    const wp::int32 var_1678 = 1;
    wp::int32 var_1679;
    wp::int32 var_1680;
    const wp::int32 var_1681 = 2;
    wp::int32 var_1682;
    wp::int32 var_1683;
    wp::int64 var_1684;
    wp::int32 var_1685;
    const wp::int32 var_1686 = 0;
    bool var_1687;
    wp::float32 var_1688;
    wp::float32 var_1689;
    wp::float32 var_1690;
    wp::float32 var_1691;
    wp::float32 var_1692;
    wp::float32 var_1693;
    wp::vec_t<3, wp::float32> var_1694;
    wp::int32 var_1695;
    wp::int32* var_1696;
    wp::int32 var_1697;
    wp::int32 var_1698;
    wp::range_t var_1699;
    wp::int32 var_1700;
    wp::vec_t<3, wp::float32>* var_1701;
    wp::vec_t<3, wp::float32> var_1702;
    wp::vec_t<3, wp::float32> var_1703;
    wp::vec_t<3, wp::float32> var_1704;
    wp::vec_t<3, wp::float64> var_1705;
    wp::float64 var_1706;
    wp::float32 var_1707;
    bool var_1708;
    bool var_1709;
    wp::float32 var_1710;
    bool var_1711;
    wp::float64 var_1712;
    wp::float64 var_1713;
    const wp::int32 var_1714 = 0;
    wp::int32 var_1715;
    wp::float64 var_1716;
    bool var_1717;
    const wp::int32 var_1718 = 1;
    wp::int32 var_1719;
    wp::int32 var_1720;
    wp::float64 var_1721;
    bool var_1722;
    const wp::int32 var_1723 = 2;
    wp::int32 var_1724;
    wp::int32 var_1725;
    wp::float64 var_1726;
    wp::float64 var_1727;
    bool var_1728;
    const wp::int32 var_1729 = 4;
    wp::int32 var_1730;
    wp::int32 var_1731;
    const wp::int32 var_1732 = 1;
    wp::int32 var_1733;
    wp::int32 var_1734;
    wp::int32 var_1735;
    wp::float64 var_1736;
    wp::float64 var_1737;
    wp::int32 var_1738;
    wp::vec_t<3, wp::float32> var_1739;
    wp::int32 var_1740;
    wp::int32 var_1741;
    wp::int32 var_1742;
    wp::vec_t<3, wp::float32> var_1743;
    wp::int32 var_1744;
    wp::int32 var_1745;
    const wp::int32 var_1746 = 1;
    const wp::int32 var_1747 = 0;
    wp::int32 var_1748;
    wp::int32 var_1749;
    const wp::int32 var_1750 = 0;
    wp::float32 var_1751;
    wp::float32 var_1752;
    wp::float32 var_1753;
    wp::float32 var_1754;
    wp::float32 var_1755;
    wp::float32 var_1756;
    wp::float32 var_1757;
    bool var_1758;
    const wp::int32 var_1759 = 0;
    wp::int32 var_1760;
    wp::int32 var_1761;
    const wp::int32 var_1762 = 1;
    wp::int32 var_1763;
    wp::int32 var_1764;
    const wp::int32 var_1765 = 2;
    wp::int32 var_1766;
    wp::int32 var_1767;
    wp::int64 var_1768;
    wp::int32 var_1769;
    const wp::int32 var_1770 = 0;
    bool var_1771;
    wp::float32 var_1772;
    wp::float32 var_1773;
    wp::float32 var_1774;
    wp::float32 var_1775;
    wp::float32 var_1776;
    wp::float32 var_1777;
    wp::vec_t<3, wp::float32> var_1778;
    wp::int32 var_1779;
    wp::int32* var_1780;
    wp::int32 var_1781;
    wp::int32 var_1782;
    wp::range_t var_1783;
    wp::int32 var_1784;
    wp::vec_t<3, wp::float32>* var_1785;
    wp::vec_t<3, wp::float32> var_1786;
    wp::vec_t<3, wp::float32> var_1787;
    wp::vec_t<3, wp::float32> var_1788;
    wp::vec_t<3, wp::float64> var_1789;
    wp::float64 var_1790;
    wp::float32 var_1791;
    bool var_1792;
    bool var_1793;
    wp::float32 var_1794;
    bool var_1795;
    wp::float64 var_1796;
    wp::float64 var_1797;
    const wp::int32 var_1798 = 0;
    wp::int32 var_1799;
    wp::float64 var_1800;
    bool var_1801;
    const wp::int32 var_1802 = 1;
    wp::int32 var_1803;
    wp::int32 var_1804;
    wp::float64 var_1805;
    bool var_1806;
    const wp::int32 var_1807 = 2;
    wp::int32 var_1808;
    wp::int32 var_1809;
    wp::float64 var_1810;
    wp::float64 var_1811;
    bool var_1812;
    const wp::int32 var_1813 = 4;
    wp::int32 var_1814;
    wp::int32 var_1815;
    const wp::int32 var_1816 = 1;
    wp::int32 var_1817;
    wp::int32 var_1818;
    wp::int32 var_1819;
    wp::float64 var_1820;
    wp::float64 var_1821;
    wp::int32 var_1822;
    wp::vec_t<3, wp::float32> var_1823;
    wp::int32 var_1824;
    wp::int32 var_1825;
    wp::int32 var_1826;
    wp::vec_t<3, wp::float32> var_1827;
    wp::int32 var_1828;
    wp::int32 var_1829;
    const wp::int32 var_1830 = 2;
    const wp::int32 var_1831 = 0;
    wp::int32 var_1832;
    wp::int32 var_1833;
    const wp::int32 var_1834 = 0;
    wp::float32 var_1835;
    wp::float32 var_1836;
    wp::float32 var_1837;
    wp::float32 var_1838;
    wp::float32 var_1839;
    wp::float32 var_1840;
    wp::float32 var_1841;
    bool var_1842;
    const wp::int32 var_1843 = 0;
    wp::int32 var_1844;
    wp::int32 var_1845;
    const wp::int32 var_1846 = 1;
    wp::int32 var_1847;
    wp::int32 var_1848;
    const wp::int32 var_1849 = 2;
    wp::int32 var_1850;
    wp::int32 var_1851;
    wp::int64 var_1852;
    wp::int32 var_1853;
    const wp::int32 var_1854 = 0;
    bool var_1855;
    wp::float32 var_1856;
    wp::float32 var_1857;
    wp::float32 var_1858;
    wp::float32 var_1859;
    wp::float32 var_1860;
    wp::float32 var_1861;
    wp::vec_t<3, wp::float32> var_1862;
    wp::int32 var_1863;
    wp::int32* var_1864;
    wp::int32 var_1865;
    wp::int32 var_1866;
    wp::range_t var_1867;
    wp::int32 var_1868;
    wp::vec_t<3, wp::float32>* var_1869;
    wp::vec_t<3, wp::float32> var_1870;
    wp::vec_t<3, wp::float32> var_1871;
    wp::vec_t<3, wp::float32> var_1872;
    wp::vec_t<3, wp::float64> var_1873;
    wp::float64 var_1874;
    wp::float32 var_1875;
    bool var_1876;
    bool var_1877;
    wp::float32 var_1878;
    bool var_1879;
    wp::float64 var_1880;
    wp::float64 var_1881;
    const wp::int32 var_1882 = 0;
    wp::int32 var_1883;
    wp::float64 var_1884;
    bool var_1885;
    const wp::int32 var_1886 = 1;
    wp::int32 var_1887;
    wp::int32 var_1888;
    wp::float64 var_1889;
    bool var_1890;
    const wp::int32 var_1891 = 2;
    wp::int32 var_1892;
    wp::int32 var_1893;
    wp::float64 var_1894;
    wp::float64 var_1895;
    bool var_1896;
    const wp::int32 var_1897 = 4;
    wp::int32 var_1898;
    wp::int32 var_1899;
    const wp::int32 var_1900 = 1;
    wp::int32 var_1901;
    wp::int32 var_1902;
    wp::int32 var_1903;
    wp::float64 var_1904;
    wp::float64 var_1905;
    wp::int32 var_1906;
    wp::vec_t<3, wp::float32> var_1907;
    wp::int32 var_1908;
    wp::int32 var_1909;
    wp::int32 var_1910;
    wp::vec_t<3, wp::float32> var_1911;
    wp::int32 var_1912;
    wp::int32 var_1913;
    wp::int32 var_1914;
    wp::int32 var_1915;
    wp::float32 var_1916;
    wp::int32 var_1917;
    wp::vec_t<3, wp::float32> var_1918;
    wp::int32 var_1919;
    wp::int32 var_1920;
    const wp::int32 var_1921 = 1;
    const wp::int32 var_1922 = 1;
    wp::int32 var_1923;
    wp::int32 var_1924;
    const wp::int32 var_1925 = 1;
    wp::float32 var_1926;
    wp::float32 var_1927;
    wp::float32 var_1928;
    wp::float32 var_1929;
    wp::float32 var_1930;
    bool var_1931;
    const wp::int32 var_1932 = 0;
    const wp::int32 var_1933 = 0;
    wp::int32 var_1934;
    wp::int32 var_1935;
    const wp::int32 var_1936 = 0;
    wp::float32 var_1937;
    wp::float32 var_1938;
    wp::float32 var_1939;
    wp::float32 var_1940;
    wp::float32 var_1941;
    wp::float32 var_1942;
    wp::float32 var_1943;
    bool var_1944;
    const wp::int32 var_1945 = 0;
    wp::int32 var_1946;
    wp::int32 var_1947;
    const wp::int32 var_1948 = 1;
    wp::int32 var_1949;
    wp::int32 var_1950;
    const wp::int32 var_1951 = 2;
    wp::int32 var_1952;
    wp::int32 var_1953;
    wp::int64 var_1954;
    wp::int32 var_1955;
    const wp::int32 var_1956 = 0;
    bool var_1957;
    wp::float32 var_1958;
    wp::float32 var_1959;
    wp::float32 var_1960;
    wp::float32 var_1961;
    wp::float32 var_1962;
    wp::float32 var_1963;
    wp::vec_t<3, wp::float32> var_1964;
    wp::int32 var_1965;
    wp::int32* var_1966;
    wp::int32 var_1967;
    wp::int32 var_1968;
    wp::range_t var_1969;
    wp::int32 var_1970;
    wp::vec_t<3, wp::float32>* var_1971;
    wp::vec_t<3, wp::float32> var_1972;
    wp::vec_t<3, wp::float32> var_1973;
    wp::vec_t<3, wp::float32> var_1974;
    wp::vec_t<3, wp::float64> var_1975;
    wp::float64 var_1976;
    wp::float32 var_1977;
    bool var_1978;
    bool var_1979;
    wp::float32 var_1980;
    bool var_1981;
    wp::float64 var_1982;
    wp::float64 var_1983;
    const wp::int32 var_1984 = 0;
    wp::int32 var_1985;
    wp::float64 var_1986;
    bool var_1987;
    const wp::int32 var_1988 = 1;
    wp::int32 var_1989;
    wp::int32 var_1990;
    wp::float64 var_1991;
    bool var_1992;
    const wp::int32 var_1993 = 2;
    wp::int32 var_1994;
    wp::int32 var_1995;
    wp::float64 var_1996;
    wp::float64 var_1997;
    bool var_1998;
    const wp::int32 var_1999 = 4;
    wp::int32 var_2000;
    wp::int32 var_2001;
    const wp::int32 var_2002 = 1;
    wp::int32 var_2003;
    wp::int32 var_2004;
    wp::int32 var_2005;
    wp::float64 var_2006;
    wp::float64 var_2007;
    wp::int32 var_2008;
    wp::vec_t<3, wp::float32> var_2009;
    wp::int32 var_2010;
    wp::int32 var_2011;
    wp::int32 var_2012;
    wp::vec_t<3, wp::float32> var_2013;
    wp::int32 var_2014;
    wp::int32 var_2015;
    const wp::int32 var_2016 = 1;
    const wp::int32 var_2017 = 0;
    wp::int32 var_2018;
    wp::int32 var_2019;
    const wp::int32 var_2020 = 0;
    wp::float32 var_2021;
    wp::float32 var_2022;
    wp::float32 var_2023;
    wp::float32 var_2024;
    wp::float32 var_2025;
    wp::float32 var_2026;
    wp::float32 var_2027;
    bool var_2028;
    const wp::int32 var_2029 = 0;
    wp::int32 var_2030;
    wp::int32 var_2031;
    const wp::int32 var_2032 = 1;
    wp::int32 var_2033;
    wp::int32 var_2034;
    const wp::int32 var_2035 = 2;
    wp::int32 var_2036;
    wp::int32 var_2037;
    wp::int64 var_2038;
    wp::int32 var_2039;
    const wp::int32 var_2040 = 0;
    bool var_2041;
    wp::float32 var_2042;
    wp::float32 var_2043;
    wp::float32 var_2044;
    wp::float32 var_2045;
    wp::float32 var_2046;
    wp::float32 var_2047;
    wp::vec_t<3, wp::float32> var_2048;
    wp::int32 var_2049;
    wp::int32* var_2050;
    wp::int32 var_2051;
    wp::int32 var_2052;
    wp::range_t var_2053;
    wp::int32 var_2054;
    wp::vec_t<3, wp::float32>* var_2055;
    wp::vec_t<3, wp::float32> var_2056;
    wp::vec_t<3, wp::float32> var_2057;
    wp::vec_t<3, wp::float32> var_2058;
    wp::vec_t<3, wp::float64> var_2059;
    wp::float64 var_2060;
    wp::float32 var_2061;
    bool var_2062;
    bool var_2063;
    wp::float32 var_2064;
    bool var_2065;
    wp::float64 var_2066;
    wp::float64 var_2067;
    const wp::int32 var_2068 = 0;
    wp::int32 var_2069;
    wp::float64 var_2070;
    bool var_2071;
    const wp::int32 var_2072 = 1;
    wp::int32 var_2073;
    wp::int32 var_2074;
    wp::float64 var_2075;
    bool var_2076;
    const wp::int32 var_2077 = 2;
    wp::int32 var_2078;
    wp::int32 var_2079;
    wp::float64 var_2080;
    wp::float64 var_2081;
    bool var_2082;
    const wp::int32 var_2083 = 4;
    wp::int32 var_2084;
    wp::int32 var_2085;
    const wp::int32 var_2086 = 1;
    wp::int32 var_2087;
    wp::int32 var_2088;
    wp::int32 var_2089;
    wp::float64 var_2090;
    wp::float64 var_2091;
    wp::int32 var_2092;
    wp::vec_t<3, wp::float32> var_2093;
    wp::int32 var_2094;
    wp::int32 var_2095;
    wp::int32 var_2096;
    wp::vec_t<3, wp::float32> var_2097;
    wp::int32 var_2098;
    wp::int32 var_2099;
    const wp::int32 var_2100 = 2;
    const wp::int32 var_2101 = 0;
    wp::int32 var_2102;
    wp::int32 var_2103;
    const wp::int32 var_2104 = 0;
    wp::float32 var_2105;
    wp::float32 var_2106;
    wp::float32 var_2107;
    wp::float32 var_2108;
    wp::float32 var_2109;
    wp::float32 var_2110;
    wp::float32 var_2111;
    bool var_2112;
    const wp::int32 var_2113 = 0;
    wp::int32 var_2114;
    wp::int32 var_2115;
    const wp::int32 var_2116 = 1;
    wp::int32 var_2117;
    wp::int32 var_2118;
    const wp::int32 var_2119 = 2;
    wp::int32 var_2120;
    wp::int32 var_2121;
    wp::int64 var_2122;
    wp::int32 var_2123;
    const wp::int32 var_2124 = 0;
    bool var_2125;
    wp::float32 var_2126;
    wp::float32 var_2127;
    wp::float32 var_2128;
    wp::float32 var_2129;
    wp::float32 var_2130;
    wp::float32 var_2131;
    wp::vec_t<3, wp::float32> var_2132;
    wp::int32 var_2133;
    wp::int32* var_2134;
    wp::int32 var_2135;
    wp::int32 var_2136;
    wp::range_t var_2137;
    wp::int32 var_2138;
    wp::vec_t<3, wp::float32>* var_2139;
    wp::vec_t<3, wp::float32> var_2140;
    wp::vec_t<3, wp::float32> var_2141;
    wp::vec_t<3, wp::float32> var_2142;
    wp::vec_t<3, wp::float64> var_2143;
    wp::float64 var_2144;
    wp::float32 var_2145;
    bool var_2146;
    bool var_2147;
    wp::float32 var_2148;
    bool var_2149;
    wp::float64 var_2150;
    wp::float64 var_2151;
    const wp::int32 var_2152 = 0;
    wp::int32 var_2153;
    wp::float64 var_2154;
    bool var_2155;
    const wp::int32 var_2156 = 1;
    wp::int32 var_2157;
    wp::int32 var_2158;
    wp::float64 var_2159;
    bool var_2160;
    const wp::int32 var_2161 = 2;
    wp::int32 var_2162;
    wp::int32 var_2163;
    wp::float64 var_2164;
    wp::float64 var_2165;
    bool var_2166;
    const wp::int32 var_2167 = 4;
    wp::int32 var_2168;
    wp::int32 var_2169;
    const wp::int32 var_2170 = 1;
    wp::int32 var_2171;
    wp::int32 var_2172;
    wp::int32 var_2173;
    wp::float64 var_2174;
    wp::float64 var_2175;
    wp::int32 var_2176;
    wp::vec_t<3, wp::float32> var_2177;
    wp::int32 var_2178;
    wp::int32 var_2179;
    wp::int32 var_2180;
    wp::vec_t<3, wp::float32> var_2181;
    wp::int32 var_2182;
    wp::int32 var_2183;
    wp::int32 var_2184;
    wp::int32 var_2185;
    wp::float32 var_2186;
    wp::int32 var_2187;
    wp::vec_t<3, wp::float32> var_2188;
    wp::int32 var_2189;
    wp::int32 var_2190;
    const wp::int32 var_2191 = 2;
    const wp::int32 var_2192 = 1;
    wp::int32 var_2193;
    wp::int32 var_2194;
    const wp::int32 var_2195 = 1;
    wp::float32 var_2196;
    wp::float32 var_2197;
    wp::float32 var_2198;
    wp::float32 var_2199;
    wp::float32 var_2200;
    bool var_2201;
    const wp::int32 var_2202 = 0;
    const wp::int32 var_2203 = 0;
    wp::int32 var_2204;
    wp::int32 var_2205;
    const wp::int32 var_2206 = 0;
    wp::float32 var_2207;
    wp::float32 var_2208;
    wp::float32 var_2209;
    wp::float32 var_2210;
    wp::float32 var_2211;
    wp::float32 var_2212;
    wp::float32 var_2213;
    bool var_2214;
    const wp::int32 var_2215 = 0;
    wp::int32 var_2216;
    wp::int32 var_2217;
    const wp::int32 var_2218 = 1;
    wp::int32 var_2219;
    wp::int32 var_2220;
    const wp::int32 var_2221 = 2;
    wp::int32 var_2222;
    wp::int32 var_2223;
    wp::int64 var_2224;
    wp::int32 var_2225;
    const wp::int32 var_2226 = 0;
    bool var_2227;
    wp::float32 var_2228;
    wp::float32 var_2229;
    wp::float32 var_2230;
    wp::float32 var_2231;
    wp::float32 var_2232;
    wp::float32 var_2233;
    wp::vec_t<3, wp::float32> var_2234;
    wp::int32 var_2235;
    wp::int32* var_2236;
    wp::int32 var_2237;
    wp::int32 var_2238;
    wp::range_t var_2239;
    wp::int32 var_2240;
    wp::vec_t<3, wp::float32>* var_2241;
    wp::vec_t<3, wp::float32> var_2242;
    wp::vec_t<3, wp::float32> var_2243;
    wp::vec_t<3, wp::float32> var_2244;
    wp::vec_t<3, wp::float64> var_2245;
    wp::float64 var_2246;
    wp::float32 var_2247;
    bool var_2248;
    bool var_2249;
    wp::float32 var_2250;
    bool var_2251;
    wp::float64 var_2252;
    wp::float64 var_2253;
    const wp::int32 var_2254 = 0;
    wp::int32 var_2255;
    wp::float64 var_2256;
    bool var_2257;
    const wp::int32 var_2258 = 1;
    wp::int32 var_2259;
    wp::int32 var_2260;
    wp::float64 var_2261;
    bool var_2262;
    const wp::int32 var_2263 = 2;
    wp::int32 var_2264;
    wp::int32 var_2265;
    wp::float64 var_2266;
    wp::float64 var_2267;
    bool var_2268;
    const wp::int32 var_2269 = 4;
    wp::int32 var_2270;
    wp::int32 var_2271;
    const wp::int32 var_2272 = 1;
    wp::int32 var_2273;
    wp::int32 var_2274;
    wp::int32 var_2275;
    wp::float64 var_2276;
    wp::float64 var_2277;
    wp::int32 var_2278;
    wp::vec_t<3, wp::float32> var_2279;
    wp::int32 var_2280;
    wp::int32 var_2281;
    wp::int32 var_2282;
    wp::vec_t<3, wp::float32> var_2283;
    wp::int32 var_2284;
    wp::int32 var_2285;
    const wp::int32 var_2286 = 1;
    const wp::int32 var_2287 = 0;
    wp::int32 var_2288;
    wp::int32 var_2289;
    const wp::int32 var_2290 = 0;
    wp::float32 var_2291;
    wp::float32 var_2292;
    wp::float32 var_2293;
    wp::float32 var_2294;
    wp::float32 var_2295;
    wp::float32 var_2296;
    wp::float32 var_2297;
    bool var_2298;
    const wp::int32 var_2299 = 0;
    wp::int32 var_2300;
    wp::int32 var_2301;
    const wp::int32 var_2302 = 1;
    wp::int32 var_2303;
    wp::int32 var_2304;
    const wp::int32 var_2305 = 2;
    wp::int32 var_2306;
    wp::int32 var_2307;
    wp::int64 var_2308;
    wp::int32 var_2309;
    const wp::int32 var_2310 = 0;
    bool var_2311;
    wp::float32 var_2312;
    wp::float32 var_2313;
    wp::float32 var_2314;
    wp::float32 var_2315;
    wp::float32 var_2316;
    wp::float32 var_2317;
    wp::vec_t<3, wp::float32> var_2318;
    wp::int32 var_2319;
    wp::int32* var_2320;
    wp::int32 var_2321;
    wp::int32 var_2322;
    wp::range_t var_2323;
    wp::int32 var_2324;
    wp::vec_t<3, wp::float32>* var_2325;
    wp::vec_t<3, wp::float32> var_2326;
    wp::vec_t<3, wp::float32> var_2327;
    wp::vec_t<3, wp::float32> var_2328;
    wp::vec_t<3, wp::float64> var_2329;
    wp::float64 var_2330;
    wp::float32 var_2331;
    bool var_2332;
    bool var_2333;
    wp::float32 var_2334;
    bool var_2335;
    wp::float64 var_2336;
    wp::float64 var_2337;
    const wp::int32 var_2338 = 0;
    wp::int32 var_2339;
    wp::float64 var_2340;
    bool var_2341;
    const wp::int32 var_2342 = 1;
    wp::int32 var_2343;
    wp::int32 var_2344;
    wp::float64 var_2345;
    bool var_2346;
    const wp::int32 var_2347 = 2;
    wp::int32 var_2348;
    wp::int32 var_2349;
    wp::float64 var_2350;
    wp::float64 var_2351;
    bool var_2352;
    const wp::int32 var_2353 = 4;
    wp::int32 var_2354;
    wp::int32 var_2355;
    const wp::int32 var_2356 = 1;
    wp::int32 var_2357;
    wp::int32 var_2358;
    wp::int32 var_2359;
    wp::float64 var_2360;
    wp::float64 var_2361;
    wp::int32 var_2362;
    wp::vec_t<3, wp::float32> var_2363;
    wp::int32 var_2364;
    wp::int32 var_2365;
    wp::int32 var_2366;
    wp::vec_t<3, wp::float32> var_2367;
    wp::int32 var_2368;
    wp::int32 var_2369;
    const wp::int32 var_2370 = 2;
    const wp::int32 var_2371 = 0;
    wp::int32 var_2372;
    wp::int32 var_2373;
    const wp::int32 var_2374 = 0;
    wp::float32 var_2375;
    wp::float32 var_2376;
    wp::float32 var_2377;
    wp::float32 var_2378;
    wp::float32 var_2379;
    wp::float32 var_2380;
    wp::float32 var_2381;
    bool var_2382;
    const wp::int32 var_2383 = 0;
    wp::int32 var_2384;
    wp::int32 var_2385;
    const wp::int32 var_2386 = 1;
    wp::int32 var_2387;
    wp::int32 var_2388;
    const wp::int32 var_2389 = 2;
    wp::int32 var_2390;
    wp::int32 var_2391;
    wp::int64 var_2392;
    wp::int32 var_2393;
    const wp::int32 var_2394 = 0;
    bool var_2395;
    wp::float32 var_2396;
    wp::float32 var_2397;
    wp::float32 var_2398;
    wp::float32 var_2399;
    wp::float32 var_2400;
    wp::float32 var_2401;
    wp::vec_t<3, wp::float32> var_2402;
    wp::int32 var_2403;
    wp::int32* var_2404;
    wp::int32 var_2405;
    wp::int32 var_2406;
    wp::range_t var_2407;
    wp::int32 var_2408;
    wp::vec_t<3, wp::float32>* var_2409;
    wp::vec_t<3, wp::float32> var_2410;
    wp::vec_t<3, wp::float32> var_2411;
    wp::vec_t<3, wp::float32> var_2412;
    wp::vec_t<3, wp::float64> var_2413;
    wp::float64 var_2414;
    wp::float32 var_2415;
    bool var_2416;
    bool var_2417;
    wp::float32 var_2418;
    bool var_2419;
    wp::float64 var_2420;
    wp::float64 var_2421;
    const wp::int32 var_2422 = 0;
    wp::int32 var_2423;
    wp::float64 var_2424;
    bool var_2425;
    const wp::int32 var_2426 = 1;
    wp::int32 var_2427;
    wp::int32 var_2428;
    wp::float64 var_2429;
    bool var_2430;
    const wp::int32 var_2431 = 2;
    wp::int32 var_2432;
    wp::int32 var_2433;
    wp::float64 var_2434;
    wp::float64 var_2435;
    bool var_2436;
    const wp::int32 var_2437 = 4;
    wp::int32 var_2438;
    wp::int32 var_2439;
    const wp::int32 var_2440 = 1;
    wp::int32 var_2441;
    wp::int32 var_2442;
    wp::int32 var_2443;
    wp::float64 var_2444;
    wp::float64 var_2445;
    wp::int32 var_2446;
    wp::vec_t<3, wp::float32> var_2447;
    wp::int32 var_2448;
    wp::int32 var_2449;
    wp::int32 var_2450;
    wp::vec_t<3, wp::float32> var_2451;
    wp::int32 var_2452;
    wp::int32 var_2453;
    wp::int32 var_2454;
    wp::int32 var_2455;
    wp::float32 var_2456;
    wp::int32 var_2457;
    wp::vec_t<3, wp::float32> var_2458;
    wp::int32 var_2459;
    wp::int32 var_2460;
    wp::int32 var_2461;
    wp::int32 var_2462;
    wp::float32 var_2463;
    wp::int32 var_2464;
    wp::int32 var_2465;
    wp::float32 var_2466;
    wp::int32 var_2467;
    wp::vec_t<3, wp::float32> var_2468;
    wp::int32 var_2469;
    wp::int32 var_2470;
    const wp::int32 var_2471 = 0;
    wp::int32 var_2472;
    const wp::int32 var_2473 = 0;
    wp::int32 var_2474;
    const wp::int32 var_2475 = 1;
    wp::int32 var_2476;
    wp::int32 var_2477;
    const wp::int32 var_2478 = 1;
    wp::int32 var_2479;
    const wp::int32 var_2480 = 1;
    wp::int32 var_2481;
    wp::int32 var_2482;
    const wp::int32 var_2483 = 2;
    wp::int32 var_2484;
    const wp::int32 var_2485 = 1;
    wp::int32 var_2486;
    wp::int32 var_2487;
    const wp::int32 var_2488 = 3;
    wp::int32 var_2489;
    const wp::int32 var_2490 = 1;
    wp::int32 var_2491;
    wp::int32 var_2492;
    const wp::int32 var_2493 = 4;
    wp::int32 var_2494;
    const wp::int32 var_2495 = 1;
    wp::int32 var_2496;
    wp::int32 var_2497;
    const wp::int32 var_2498 = 5;
    wp::int32 var_2499;
    const wp::int32 var_2500 = 1;
    wp::int32 var_2501;
    wp::int32 var_2502;
    const wp::int32 var_2503 = 6;
    wp::int32 var_2504;
    const wp::int32 var_2505 = 1;
    wp::int32 var_2506;
    wp::int32 var_2507;
    const wp::int32 var_2508 = 7;
    wp::int32 var_2509;
    const wp::int32 var_2510 = 1;
    wp::int32 var_2511;
    wp::int32 var_2512;
    //---------
    // forward
    // def sectors_in_map(center, radius, u, v, voxel_map__voxel_size, voxel_map__room, voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask, voxel_map__counts, voxel_map__offsets):       <L 1>
    // cell = cell_holding(center, voxel_map__voxel_size)                                     <L 3>
    var_0 = cell_holding_0(var_center, var_voxel_map__voxel_size);
    // position = offset_in_cell(center, cell, voxel_map__voxel_size)                         <L 4>
    var_1 = offset_in_cell_0(var_center, var_0, var_voxel_map__voxel_size);
    // near = vec3i(1, 1, 1)                                                                  <L 5>
    var_5 = wp::vec_t<3, wp::int32>(var_2, var_3, var_4);
    // sqradius = radius * radius                                                             <L 6>
    var_6 = wp::mul(var_radius, var_radius);
    // octants = int(0)                                                                       <L 7>
    var_8 = wp::int(var_7);
    // edge__voxels_around__1 = float(voxel_map__voxel_size)                                  <L 8>
    var_9 = wp::float(var_voxel_map__voxel_size);
    // for z__voxels_around__1 in range(3):                                                   <L 9>
    // sz__voxels_around__1 = side_in_order(z__voxels_around__1, near[2])                     <L 10>
    var_12 = wp::extract(var_5, var_11);
    var_13 = side_in_order_0(var_10, var_12);
    // gz__voxels_around__1 = gap_to__voxels_around(position[2], sz__voxels_around__1, edge__voxels_around__1)       <L 11>
    var_15 = wp::extract(var_1, var_14);
    var_16 = gap_to_0(var_15, var_13, var_9);
    // if gz__voxels_around__1 * gz__voxels_around__1 < sqradius:                             <L 12>
    var_17 = wp::mul(var_16, var_16);
    var_18 = (var_17 < var_6);
    if (var_18) {
        // for y__voxels_around__1 in range(3):                                               <L 13>
        // sy__voxels_around__1 = side_in_order(y__voxels_around__1, near[1])                 <L 14>
        var_21 = wp::extract(var_5, var_20);
        var_22 = side_in_order_0(var_19, var_21);
        // gy__voxels_around__1 = gap_to__voxels_around(position[1], sy__voxels_around__1, edge__voxels_around__1)       <L 15>
        var_24 = wp::extract(var_1, var_23);
        var_25 = gap_to_0(var_24, var_22, var_9);
        // if gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 16>
        var_26 = wp::mul(var_25, var_25);
        var_27 = wp::mul(var_16, var_16);
        var_28 = wp::add(var_26, var_27);
        var_29 = (var_28 < var_6);
        if (var_29) {
            // for x__voxels_around__1 in range(3):                                           <L 17>
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_32 = wp::extract(var_5, var_31);
            var_33 = side_in_order_0(var_30, var_32);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_35 = wp::extract(var_1, var_34);
            var_36 = gap_to_0(var_35, var_33, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_37 = wp::mul(var_36, var_36);
            var_38 = wp::mul(var_25, var_25);
            var_39 = wp::add(var_37, var_38);
            var_40 = wp::mul(var_16, var_16);
            var_41 = wp::add(var_39, var_40);
            var_42 = (var_41 < var_6);
            if (var_42) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_44 = wp::extract(var_0, var_43);
                var_45 = wp::add(var_44, var_33);
                var_47 = wp::extract(var_0, var_46);
                var_48 = wp::add(var_47, var_22);
                var_50 = wp::extract(var_0, var_49);
                var_51 = wp::add(var_50, var_13);
                var_52 = block_key_0(var_45, var_48, var_51);
                var_53 = find_position_0(var_52, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_55 = (var_53 >= var_54);
                if (var_55) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_56 = wp::float(var_33);
                    var_57 = wp::mul(var_56, var_9);
                    var_58 = wp::float(var_22);
                    var_59 = wp::mul(var_58, var_9);
                    var_60 = wp::float(var_13);
                    var_61 = wp::mul(var_60, var_9);
                    var_62 = wp::vec_t<3, wp::float32>(var_57, var_59, var_61);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_63 = wp::mul(var_53, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_64 = wp::address(var_voxel_map__counts, var_53);
                    var_66 = wp::load(var_64);
                    var_65 = wp::add(var_63, var_66);
                    var_67 = wp::range(var_63, var_65);
                    start_for_0:;
                        if (iter_cmp(var_67) == 0) goto end_for_0;
                        var_68 = wp::iter_next(var_67);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_69 = wp::address(var_voxel_map__offsets, var_68);
                        var_71 = wp::load(var_69);
                        var_70 = wp::add(var_71, var_62);
                        var_72 = wp::sub(var_70, var_1);
                        var_73 = widen_0(var_72);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_74 = wp::dot(var_73, var_73);
                        var_75 = wp::float(var_74);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_77 = (var_75 < var_6);
                        var_76 = var_77;
                        if (var_76) {
                            var_79 = wp::mul(var_78, var_6);
                            var_80 = (var_75 > var_79);
                            var_76 = var_76 && var_80;
                        }
                        if (var_76) {
                            // a = dot(d, u)                                                  <L 29>
                            var_81 = wp::dot(var_73, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_82 = wp::dot(var_73, var_v);
                            // octant = int(0)                                                <L 31>
                            var_84 = wp::int(var_83);
                            // if a > float64(0.0):                                           <L 32>
                            var_85 = 0.0;
                            var_86 = (var_81 > var_85);
                            if (var_86) {
                                // octant += 1                                                <L 33>
                                var_88 = wp::add(var_84, var_87);
                            }
                            var_89 = wp::where(var_86, var_88, var_84);
                            // if b > float64(0.0):                                           <L 34>
                            var_90 = 0.0;
                            var_91 = (var_82 > var_90);
                            if (var_91) {
                                // octant += 2                                                <L 35>
                                var_93 = wp::add(var_89, var_92);
                            }
                            var_94 = wp::where(var_91, var_93, var_89);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_95 = wp::abs(var_81);
                            var_96 = wp::abs(var_82);
                            var_97 = (var_95 > var_96);
                            if (var_97) {
                                // octant += 4                                                <L 37>
                                var_99 = wp::add(var_94, var_98);
                            }
                            var_100 = wp::where(var_97, var_99, var_94);
                            // octants = octants | 1 << octant                                <L 38>
                            var_102 = wp::lshift(var_101, var_100);
                            var_103 = wp::bit_or(var_8, var_102);
                        }
                        var_104 = wp::where(var_76, var_103, var_8);
                        wp::assign(var_8, var_104);
                        goto start_for_0;
                    end_for_0:;
                }
            }
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_107 = wp::extract(var_5, var_106);
            var_108 = side_in_order_0(var_105, var_107);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_110 = wp::extract(var_1, var_109);
            var_111 = gap_to_0(var_110, var_108, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_112 = wp::mul(var_111, var_111);
            var_113 = wp::mul(var_25, var_25);
            var_114 = wp::add(var_112, var_113);
            var_115 = wp::mul(var_16, var_16);
            var_116 = wp::add(var_114, var_115);
            var_117 = (var_116 < var_6);
            if (var_117) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_119 = wp::extract(var_0, var_118);
                var_120 = wp::add(var_119, var_108);
                var_122 = wp::extract(var_0, var_121);
                var_123 = wp::add(var_122, var_22);
                var_125 = wp::extract(var_0, var_124);
                var_126 = wp::add(var_125, var_13);
                var_127 = block_key_0(var_120, var_123, var_126);
                var_128 = find_position_0(var_127, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_130 = (var_128 >= var_129);
                if (var_130) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_131 = wp::float(var_108);
                    var_132 = wp::mul(var_131, var_9);
                    var_133 = wp::float(var_22);
                    var_134 = wp::mul(var_133, var_9);
                    var_135 = wp::float(var_13);
                    var_136 = wp::mul(var_135, var_9);
                    var_137 = wp::vec_t<3, wp::float32>(var_132, var_134, var_136);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_138 = wp::mul(var_128, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_139 = wp::address(var_voxel_map__counts, var_128);
                    var_141 = wp::load(var_139);
                    var_140 = wp::add(var_138, var_141);
                    var_142 = wp::range(var_138, var_140);
                    start_for_2:;
                        if (iter_cmp(var_142) == 0) goto end_for_2;
                        var_143 = wp::iter_next(var_142);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_144 = wp::address(var_voxel_map__offsets, var_143);
                        var_146 = wp::load(var_144);
                        var_145 = wp::add(var_146, var_137);
                        var_147 = wp::sub(var_145, var_1);
                        var_148 = widen_0(var_147);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_149 = wp::dot(var_148, var_148);
                        var_150 = wp::float(var_149);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_152 = (var_150 < var_6);
                        var_151 = var_152;
                        if (var_151) {
                            var_153 = wp::mul(var_78, var_6);
                            var_154 = (var_150 > var_153);
                            var_151 = var_151 && var_154;
                        }
                        if (var_151) {
                            // a = dot(d, u)                                                  <L 29>
                            var_155 = wp::dot(var_148, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_156 = wp::dot(var_148, var_v);
                            // octant = int(0)                                                <L 31>
                            var_158 = wp::int(var_157);
                            // if a > float64(0.0):                                           <L 32>
                            var_159 = 0.0;
                            var_160 = (var_155 > var_159);
                            if (var_160) {
                                // octant += 1                                                <L 33>
                                var_162 = wp::add(var_158, var_161);
                            }
                            var_163 = wp::where(var_160, var_162, var_158);
                            // if b > float64(0.0):                                           <L 34>
                            var_164 = 0.0;
                            var_165 = (var_156 > var_164);
                            if (var_165) {
                                // octant += 2                                                <L 35>
                                var_167 = wp::add(var_163, var_166);
                            }
                            var_168 = wp::where(var_165, var_167, var_163);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_169 = wp::abs(var_155);
                            var_170 = wp::abs(var_156);
                            var_171 = (var_169 > var_170);
                            if (var_171) {
                                // octant += 4                                                <L 37>
                                var_173 = wp::add(var_168, var_172);
                            }
                            var_174 = wp::where(var_171, var_173, var_168);
                            // octants = octants | 1 << octant                                <L 38>
                            var_176 = wp::lshift(var_175, var_174);
                            var_177 = wp::bit_or(var_8, var_176);
                        }
                        var_178 = wp::where(var_151, var_177, var_8);
                        var_179 = wp::where(var_151, var_155, var_81);
                        var_180 = wp::where(var_151, var_156, var_82);
                        var_181 = wp::where(var_151, var_174, var_100);
                        wp::assign(var_8, var_178);
                        wp::assign(var_73, var_148);
                        wp::assign(var_75, var_150);
                        wp::assign(var_81, var_179);
                        wp::assign(var_82, var_180);
                        wp::assign(var_100, var_181);
                        goto start_for_2;
                    end_for_2:;
                }
                var_182 = wp::where(var_130, var_137, var_62);
                var_183 = wp::where(var_130, var_138, var_63);
                var_184 = wp::where(var_130, var_143, var_68);
            }
            var_185 = wp::where(var_117, var_128, var_53);
            var_186 = wp::where(var_117, var_182, var_62);
            var_187 = wp::where(var_117, var_183, var_63);
            var_188 = wp::where(var_117, var_184, var_68);
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_191 = wp::extract(var_5, var_190);
            var_192 = side_in_order_0(var_189, var_191);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_194 = wp::extract(var_1, var_193);
            var_195 = gap_to_0(var_194, var_192, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_196 = wp::mul(var_195, var_195);
            var_197 = wp::mul(var_25, var_25);
            var_198 = wp::add(var_196, var_197);
            var_199 = wp::mul(var_16, var_16);
            var_200 = wp::add(var_198, var_199);
            var_201 = (var_200 < var_6);
            if (var_201) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_203 = wp::extract(var_0, var_202);
                var_204 = wp::add(var_203, var_192);
                var_206 = wp::extract(var_0, var_205);
                var_207 = wp::add(var_206, var_22);
                var_209 = wp::extract(var_0, var_208);
                var_210 = wp::add(var_209, var_13);
                var_211 = block_key_0(var_204, var_207, var_210);
                var_212 = find_position_0(var_211, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_214 = (var_212 >= var_213);
                if (var_214) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_215 = wp::float(var_192);
                    var_216 = wp::mul(var_215, var_9);
                    var_217 = wp::float(var_22);
                    var_218 = wp::mul(var_217, var_9);
                    var_219 = wp::float(var_13);
                    var_220 = wp::mul(var_219, var_9);
                    var_221 = wp::vec_t<3, wp::float32>(var_216, var_218, var_220);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_222 = wp::mul(var_212, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_223 = wp::address(var_voxel_map__counts, var_212);
                    var_225 = wp::load(var_223);
                    var_224 = wp::add(var_222, var_225);
                    var_226 = wp::range(var_222, var_224);
                    start_for_4:;
                        if (iter_cmp(var_226) == 0) goto end_for_4;
                        var_227 = wp::iter_next(var_226);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_228 = wp::address(var_voxel_map__offsets, var_227);
                        var_230 = wp::load(var_228);
                        var_229 = wp::add(var_230, var_221);
                        var_231 = wp::sub(var_229, var_1);
                        var_232 = widen_0(var_231);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_233 = wp::dot(var_232, var_232);
                        var_234 = wp::float(var_233);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_236 = (var_234 < var_6);
                        var_235 = var_236;
                        if (var_235) {
                            var_237 = wp::mul(var_78, var_6);
                            var_238 = (var_234 > var_237);
                            var_235 = var_235 && var_238;
                        }
                        if (var_235) {
                            // a = dot(d, u)                                                  <L 29>
                            var_239 = wp::dot(var_232, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_240 = wp::dot(var_232, var_v);
                            // octant = int(0)                                                <L 31>
                            var_242 = wp::int(var_241);
                            // if a > float64(0.0):                                           <L 32>
                            var_243 = 0.0;
                            var_244 = (var_239 > var_243);
                            if (var_244) {
                                // octant += 1                                                <L 33>
                                var_246 = wp::add(var_242, var_245);
                            }
                            var_247 = wp::where(var_244, var_246, var_242);
                            // if b > float64(0.0):                                           <L 34>
                            var_248 = 0.0;
                            var_249 = (var_240 > var_248);
                            if (var_249) {
                                // octant += 2                                                <L 35>
                                var_251 = wp::add(var_247, var_250);
                            }
                            var_252 = wp::where(var_249, var_251, var_247);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_253 = wp::abs(var_239);
                            var_254 = wp::abs(var_240);
                            var_255 = (var_253 > var_254);
                            if (var_255) {
                                // octant += 4                                                <L 37>
                                var_257 = wp::add(var_252, var_256);
                            }
                            var_258 = wp::where(var_255, var_257, var_252);
                            // octants = octants | 1 << octant                                <L 38>
                            var_260 = wp::lshift(var_259, var_258);
                            var_261 = wp::bit_or(var_8, var_260);
                        }
                        var_262 = wp::where(var_235, var_261, var_8);
                        var_263 = wp::where(var_235, var_239, var_81);
                        var_264 = wp::where(var_235, var_240, var_82);
                        var_265 = wp::where(var_235, var_258, var_100);
                        wp::assign(var_8, var_262);
                        wp::assign(var_73, var_232);
                        wp::assign(var_75, var_234);
                        wp::assign(var_81, var_263);
                        wp::assign(var_82, var_264);
                        wp::assign(var_100, var_265);
                        goto start_for_4;
                    end_for_4:;
                }
                var_266 = wp::where(var_214, var_221, var_186);
                var_267 = wp::where(var_214, var_222, var_187);
                var_268 = wp::where(var_214, var_227, var_188);
            }
            var_269 = wp::where(var_201, var_212, var_185);
            var_270 = wp::where(var_201, var_266, var_186);
            var_271 = wp::where(var_201, var_267, var_187);
            var_272 = wp::where(var_201, var_268, var_188);
        }
        // sy__voxels_around__1 = side_in_order(y__voxels_around__1, near[1])                 <L 14>
        var_275 = wp::extract(var_5, var_274);
        var_276 = side_in_order_0(var_273, var_275);
        // gy__voxels_around__1 = gap_to__voxels_around(position[1], sy__voxels_around__1, edge__voxels_around__1)       <L 15>
        var_278 = wp::extract(var_1, var_277);
        var_279 = gap_to_0(var_278, var_276, var_9);
        // if gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 16>
        var_280 = wp::mul(var_279, var_279);
        var_281 = wp::mul(var_16, var_16);
        var_282 = wp::add(var_280, var_281);
        var_283 = (var_282 < var_6);
        if (var_283) {
            // for x__voxels_around__1 in range(3):                                           <L 17>
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_286 = wp::extract(var_5, var_285);
            var_287 = side_in_order_0(var_284, var_286);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_289 = wp::extract(var_1, var_288);
            var_290 = gap_to_0(var_289, var_287, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_291 = wp::mul(var_290, var_290);
            var_292 = wp::mul(var_279, var_279);
            var_293 = wp::add(var_291, var_292);
            var_294 = wp::mul(var_16, var_16);
            var_295 = wp::add(var_293, var_294);
            var_296 = (var_295 < var_6);
            if (var_296) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_298 = wp::extract(var_0, var_297);
                var_299 = wp::add(var_298, var_287);
                var_301 = wp::extract(var_0, var_300);
                var_302 = wp::add(var_301, var_276);
                var_304 = wp::extract(var_0, var_303);
                var_305 = wp::add(var_304, var_13);
                var_306 = block_key_0(var_299, var_302, var_305);
                var_307 = find_position_0(var_306, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_309 = (var_307 >= var_308);
                if (var_309) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_310 = wp::float(var_287);
                    var_311 = wp::mul(var_310, var_9);
                    var_312 = wp::float(var_276);
                    var_313 = wp::mul(var_312, var_9);
                    var_314 = wp::float(var_13);
                    var_315 = wp::mul(var_314, var_9);
                    var_316 = wp::vec_t<3, wp::float32>(var_311, var_313, var_315);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_317 = wp::mul(var_307, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_318 = wp::address(var_voxel_map__counts, var_307);
                    var_320 = wp::load(var_318);
                    var_319 = wp::add(var_317, var_320);
                    var_321 = wp::range(var_317, var_319);
                    start_for_6:;
                        if (iter_cmp(var_321) == 0) goto end_for_6;
                        var_322 = wp::iter_next(var_321);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_323 = wp::address(var_voxel_map__offsets, var_322);
                        var_325 = wp::load(var_323);
                        var_324 = wp::add(var_325, var_316);
                        var_326 = wp::sub(var_324, var_1);
                        var_327 = widen_0(var_326);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_328 = wp::dot(var_327, var_327);
                        var_329 = wp::float(var_328);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_331 = (var_329 < var_6);
                        var_330 = var_331;
                        if (var_330) {
                            var_332 = wp::mul(var_78, var_6);
                            var_333 = (var_329 > var_332);
                            var_330 = var_330 && var_333;
                        }
                        if (var_330) {
                            // a = dot(d, u)                                                  <L 29>
                            var_334 = wp::dot(var_327, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_335 = wp::dot(var_327, var_v);
                            // octant = int(0)                                                <L 31>
                            var_337 = wp::int(var_336);
                            // if a > float64(0.0):                                           <L 32>
                            var_338 = 0.0;
                            var_339 = (var_334 > var_338);
                            if (var_339) {
                                // octant += 1                                                <L 33>
                                var_341 = wp::add(var_337, var_340);
                            }
                            var_342 = wp::where(var_339, var_341, var_337);
                            // if b > float64(0.0):                                           <L 34>
                            var_343 = 0.0;
                            var_344 = (var_335 > var_343);
                            if (var_344) {
                                // octant += 2                                                <L 35>
                                var_346 = wp::add(var_342, var_345);
                            }
                            var_347 = wp::where(var_344, var_346, var_342);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_348 = wp::abs(var_334);
                            var_349 = wp::abs(var_335);
                            var_350 = (var_348 > var_349);
                            if (var_350) {
                                // octant += 4                                                <L 37>
                                var_352 = wp::add(var_347, var_351);
                            }
                            var_353 = wp::where(var_350, var_352, var_347);
                            // octants = octants | 1 << octant                                <L 38>
                            var_355 = wp::lshift(var_354, var_353);
                            var_356 = wp::bit_or(var_8, var_355);
                        }
                        var_357 = wp::where(var_330, var_356, var_8);
                        var_358 = wp::where(var_330, var_334, var_81);
                        var_359 = wp::where(var_330, var_335, var_82);
                        var_360 = wp::where(var_330, var_353, var_100);
                        wp::assign(var_8, var_357);
                        wp::assign(var_73, var_327);
                        wp::assign(var_75, var_329);
                        wp::assign(var_81, var_358);
                        wp::assign(var_82, var_359);
                        wp::assign(var_100, var_360);
                        goto start_for_6;
                    end_for_6:;
                }
                var_361 = wp::where(var_309, var_316, var_270);
                var_362 = wp::where(var_309, var_317, var_271);
                var_363 = wp::where(var_309, var_322, var_272);
            }
            var_364 = wp::where(var_296, var_307, var_269);
            var_365 = wp::where(var_296, var_361, var_270);
            var_366 = wp::where(var_296, var_362, var_271);
            var_367 = wp::where(var_296, var_363, var_272);
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_370 = wp::extract(var_5, var_369);
            var_371 = side_in_order_0(var_368, var_370);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_373 = wp::extract(var_1, var_372);
            var_374 = gap_to_0(var_373, var_371, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_375 = wp::mul(var_374, var_374);
            var_376 = wp::mul(var_279, var_279);
            var_377 = wp::add(var_375, var_376);
            var_378 = wp::mul(var_16, var_16);
            var_379 = wp::add(var_377, var_378);
            var_380 = (var_379 < var_6);
            if (var_380) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_382 = wp::extract(var_0, var_381);
                var_383 = wp::add(var_382, var_371);
                var_385 = wp::extract(var_0, var_384);
                var_386 = wp::add(var_385, var_276);
                var_388 = wp::extract(var_0, var_387);
                var_389 = wp::add(var_388, var_13);
                var_390 = block_key_0(var_383, var_386, var_389);
                var_391 = find_position_0(var_390, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_393 = (var_391 >= var_392);
                if (var_393) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_394 = wp::float(var_371);
                    var_395 = wp::mul(var_394, var_9);
                    var_396 = wp::float(var_276);
                    var_397 = wp::mul(var_396, var_9);
                    var_398 = wp::float(var_13);
                    var_399 = wp::mul(var_398, var_9);
                    var_400 = wp::vec_t<3, wp::float32>(var_395, var_397, var_399);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_401 = wp::mul(var_391, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_402 = wp::address(var_voxel_map__counts, var_391);
                    var_404 = wp::load(var_402);
                    var_403 = wp::add(var_401, var_404);
                    var_405 = wp::range(var_401, var_403);
                    start_for_8:;
                        if (iter_cmp(var_405) == 0) goto end_for_8;
                        var_406 = wp::iter_next(var_405);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_407 = wp::address(var_voxel_map__offsets, var_406);
                        var_409 = wp::load(var_407);
                        var_408 = wp::add(var_409, var_400);
                        var_410 = wp::sub(var_408, var_1);
                        var_411 = widen_0(var_410);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_412 = wp::dot(var_411, var_411);
                        var_413 = wp::float(var_412);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_415 = (var_413 < var_6);
                        var_414 = var_415;
                        if (var_414) {
                            var_416 = wp::mul(var_78, var_6);
                            var_417 = (var_413 > var_416);
                            var_414 = var_414 && var_417;
                        }
                        if (var_414) {
                            // a = dot(d, u)                                                  <L 29>
                            var_418 = wp::dot(var_411, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_419 = wp::dot(var_411, var_v);
                            // octant = int(0)                                                <L 31>
                            var_421 = wp::int(var_420);
                            // if a > float64(0.0):                                           <L 32>
                            var_422 = 0.0;
                            var_423 = (var_418 > var_422);
                            if (var_423) {
                                // octant += 1                                                <L 33>
                                var_425 = wp::add(var_421, var_424);
                            }
                            var_426 = wp::where(var_423, var_425, var_421);
                            // if b > float64(0.0):                                           <L 34>
                            var_427 = 0.0;
                            var_428 = (var_419 > var_427);
                            if (var_428) {
                                // octant += 2                                                <L 35>
                                var_430 = wp::add(var_426, var_429);
                            }
                            var_431 = wp::where(var_428, var_430, var_426);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_432 = wp::abs(var_418);
                            var_433 = wp::abs(var_419);
                            var_434 = (var_432 > var_433);
                            if (var_434) {
                                // octant += 4                                                <L 37>
                                var_436 = wp::add(var_431, var_435);
                            }
                            var_437 = wp::where(var_434, var_436, var_431);
                            // octants = octants | 1 << octant                                <L 38>
                            var_439 = wp::lshift(var_438, var_437);
                            var_440 = wp::bit_or(var_8, var_439);
                        }
                        var_441 = wp::where(var_414, var_440, var_8);
                        var_442 = wp::where(var_414, var_418, var_81);
                        var_443 = wp::where(var_414, var_419, var_82);
                        var_444 = wp::where(var_414, var_437, var_100);
                        wp::assign(var_8, var_441);
                        wp::assign(var_73, var_411);
                        wp::assign(var_75, var_413);
                        wp::assign(var_81, var_442);
                        wp::assign(var_82, var_443);
                        wp::assign(var_100, var_444);
                        goto start_for_8;
                    end_for_8:;
                }
                var_445 = wp::where(var_393, var_400, var_365);
                var_446 = wp::where(var_393, var_401, var_366);
                var_447 = wp::where(var_393, var_406, var_367);
            }
            var_448 = wp::where(var_380, var_391, var_364);
            var_449 = wp::where(var_380, var_445, var_365);
            var_450 = wp::where(var_380, var_446, var_366);
            var_451 = wp::where(var_380, var_447, var_367);
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_454 = wp::extract(var_5, var_453);
            var_455 = side_in_order_0(var_452, var_454);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_457 = wp::extract(var_1, var_456);
            var_458 = gap_to_0(var_457, var_455, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_459 = wp::mul(var_458, var_458);
            var_460 = wp::mul(var_279, var_279);
            var_461 = wp::add(var_459, var_460);
            var_462 = wp::mul(var_16, var_16);
            var_463 = wp::add(var_461, var_462);
            var_464 = (var_463 < var_6);
            if (var_464) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_466 = wp::extract(var_0, var_465);
                var_467 = wp::add(var_466, var_455);
                var_469 = wp::extract(var_0, var_468);
                var_470 = wp::add(var_469, var_276);
                var_472 = wp::extract(var_0, var_471);
                var_473 = wp::add(var_472, var_13);
                var_474 = block_key_0(var_467, var_470, var_473);
                var_475 = find_position_0(var_474, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_477 = (var_475 >= var_476);
                if (var_477) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_478 = wp::float(var_455);
                    var_479 = wp::mul(var_478, var_9);
                    var_480 = wp::float(var_276);
                    var_481 = wp::mul(var_480, var_9);
                    var_482 = wp::float(var_13);
                    var_483 = wp::mul(var_482, var_9);
                    var_484 = wp::vec_t<3, wp::float32>(var_479, var_481, var_483);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_485 = wp::mul(var_475, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_486 = wp::address(var_voxel_map__counts, var_475);
                    var_488 = wp::load(var_486);
                    var_487 = wp::add(var_485, var_488);
                    var_489 = wp::range(var_485, var_487);
                    start_for_10:;
                        if (iter_cmp(var_489) == 0) goto end_for_10;
                        var_490 = wp::iter_next(var_489);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_491 = wp::address(var_voxel_map__offsets, var_490);
                        var_493 = wp::load(var_491);
                        var_492 = wp::add(var_493, var_484);
                        var_494 = wp::sub(var_492, var_1);
                        var_495 = widen_0(var_494);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_496 = wp::dot(var_495, var_495);
                        var_497 = wp::float(var_496);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_499 = (var_497 < var_6);
                        var_498 = var_499;
                        if (var_498) {
                            var_500 = wp::mul(var_78, var_6);
                            var_501 = (var_497 > var_500);
                            var_498 = var_498 && var_501;
                        }
                        if (var_498) {
                            // a = dot(d, u)                                                  <L 29>
                            var_502 = wp::dot(var_495, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_503 = wp::dot(var_495, var_v);
                            // octant = int(0)                                                <L 31>
                            var_505 = wp::int(var_504);
                            // if a > float64(0.0):                                           <L 32>
                            var_506 = 0.0;
                            var_507 = (var_502 > var_506);
                            if (var_507) {
                                // octant += 1                                                <L 33>
                                var_509 = wp::add(var_505, var_508);
                            }
                            var_510 = wp::where(var_507, var_509, var_505);
                            // if b > float64(0.0):                                           <L 34>
                            var_511 = 0.0;
                            var_512 = (var_503 > var_511);
                            if (var_512) {
                                // octant += 2                                                <L 35>
                                var_514 = wp::add(var_510, var_513);
                            }
                            var_515 = wp::where(var_512, var_514, var_510);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_516 = wp::abs(var_502);
                            var_517 = wp::abs(var_503);
                            var_518 = (var_516 > var_517);
                            if (var_518) {
                                // octant += 4                                                <L 37>
                                var_520 = wp::add(var_515, var_519);
                            }
                            var_521 = wp::where(var_518, var_520, var_515);
                            // octants = octants | 1 << octant                                <L 38>
                            var_523 = wp::lshift(var_522, var_521);
                            var_524 = wp::bit_or(var_8, var_523);
                        }
                        var_525 = wp::where(var_498, var_524, var_8);
                        var_526 = wp::where(var_498, var_502, var_81);
                        var_527 = wp::where(var_498, var_503, var_82);
                        var_528 = wp::where(var_498, var_521, var_100);
                        wp::assign(var_8, var_525);
                        wp::assign(var_73, var_495);
                        wp::assign(var_75, var_497);
                        wp::assign(var_81, var_526);
                        wp::assign(var_82, var_527);
                        wp::assign(var_100, var_528);
                        goto start_for_10;
                    end_for_10:;
                }
                var_529 = wp::where(var_477, var_484, var_449);
                var_530 = wp::where(var_477, var_485, var_450);
                var_531 = wp::where(var_477, var_490, var_451);
            }
            var_532 = wp::where(var_464, var_475, var_448);
            var_533 = wp::where(var_464, var_529, var_449);
            var_534 = wp::where(var_464, var_530, var_450);
            var_535 = wp::where(var_464, var_531, var_451);
        }
        var_536 = wp::where(var_283, var_452, var_189);
        var_537 = wp::where(var_283, var_455, var_192);
        var_538 = wp::where(var_283, var_458, var_195);
        var_539 = wp::where(var_283, var_532, var_269);
        var_540 = wp::where(var_283, var_533, var_270);
        var_541 = wp::where(var_283, var_534, var_271);
        var_542 = wp::where(var_283, var_535, var_272);
        // sy__voxels_around__1 = side_in_order(y__voxels_around__1, near[1])                 <L 14>
        var_545 = wp::extract(var_5, var_544);
        var_546 = side_in_order_0(var_543, var_545);
        // gy__voxels_around__1 = gap_to__voxels_around(position[1], sy__voxels_around__1, edge__voxels_around__1)       <L 15>
        var_548 = wp::extract(var_1, var_547);
        var_549 = gap_to_0(var_548, var_546, var_9);
        // if gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 16>
        var_550 = wp::mul(var_549, var_549);
        var_551 = wp::mul(var_16, var_16);
        var_552 = wp::add(var_550, var_551);
        var_553 = (var_552 < var_6);
        if (var_553) {
            // for x__voxels_around__1 in range(3):                                           <L 17>
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_556 = wp::extract(var_5, var_555);
            var_557 = side_in_order_0(var_554, var_556);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_559 = wp::extract(var_1, var_558);
            var_560 = gap_to_0(var_559, var_557, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_561 = wp::mul(var_560, var_560);
            var_562 = wp::mul(var_549, var_549);
            var_563 = wp::add(var_561, var_562);
            var_564 = wp::mul(var_16, var_16);
            var_565 = wp::add(var_563, var_564);
            var_566 = (var_565 < var_6);
            if (var_566) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_568 = wp::extract(var_0, var_567);
                var_569 = wp::add(var_568, var_557);
                var_571 = wp::extract(var_0, var_570);
                var_572 = wp::add(var_571, var_546);
                var_574 = wp::extract(var_0, var_573);
                var_575 = wp::add(var_574, var_13);
                var_576 = block_key_0(var_569, var_572, var_575);
                var_577 = find_position_0(var_576, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_579 = (var_577 >= var_578);
                if (var_579) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_580 = wp::float(var_557);
                    var_581 = wp::mul(var_580, var_9);
                    var_582 = wp::float(var_546);
                    var_583 = wp::mul(var_582, var_9);
                    var_584 = wp::float(var_13);
                    var_585 = wp::mul(var_584, var_9);
                    var_586 = wp::vec_t<3, wp::float32>(var_581, var_583, var_585);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_587 = wp::mul(var_577, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_588 = wp::address(var_voxel_map__counts, var_577);
                    var_590 = wp::load(var_588);
                    var_589 = wp::add(var_587, var_590);
                    var_591 = wp::range(var_587, var_589);
                    start_for_12:;
                        if (iter_cmp(var_591) == 0) goto end_for_12;
                        var_592 = wp::iter_next(var_591);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_593 = wp::address(var_voxel_map__offsets, var_592);
                        var_595 = wp::load(var_593);
                        var_594 = wp::add(var_595, var_586);
                        var_596 = wp::sub(var_594, var_1);
                        var_597 = widen_0(var_596);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_598 = wp::dot(var_597, var_597);
                        var_599 = wp::float(var_598);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_601 = (var_599 < var_6);
                        var_600 = var_601;
                        if (var_600) {
                            var_602 = wp::mul(var_78, var_6);
                            var_603 = (var_599 > var_602);
                            var_600 = var_600 && var_603;
                        }
                        if (var_600) {
                            // a = dot(d, u)                                                  <L 29>
                            var_604 = wp::dot(var_597, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_605 = wp::dot(var_597, var_v);
                            // octant = int(0)                                                <L 31>
                            var_607 = wp::int(var_606);
                            // if a > float64(0.0):                                           <L 32>
                            var_608 = 0.0;
                            var_609 = (var_604 > var_608);
                            if (var_609) {
                                // octant += 1                                                <L 33>
                                var_611 = wp::add(var_607, var_610);
                            }
                            var_612 = wp::where(var_609, var_611, var_607);
                            // if b > float64(0.0):                                           <L 34>
                            var_613 = 0.0;
                            var_614 = (var_605 > var_613);
                            if (var_614) {
                                // octant += 2                                                <L 35>
                                var_616 = wp::add(var_612, var_615);
                            }
                            var_617 = wp::where(var_614, var_616, var_612);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_618 = wp::abs(var_604);
                            var_619 = wp::abs(var_605);
                            var_620 = (var_618 > var_619);
                            if (var_620) {
                                // octant += 4                                                <L 37>
                                var_622 = wp::add(var_617, var_621);
                            }
                            var_623 = wp::where(var_620, var_622, var_617);
                            // octants = octants | 1 << octant                                <L 38>
                            var_625 = wp::lshift(var_624, var_623);
                            var_626 = wp::bit_or(var_8, var_625);
                        }
                        var_627 = wp::where(var_600, var_626, var_8);
                        var_628 = wp::where(var_600, var_604, var_81);
                        var_629 = wp::where(var_600, var_605, var_82);
                        var_630 = wp::where(var_600, var_623, var_100);
                        wp::assign(var_8, var_627);
                        wp::assign(var_73, var_597);
                        wp::assign(var_75, var_599);
                        wp::assign(var_81, var_628);
                        wp::assign(var_82, var_629);
                        wp::assign(var_100, var_630);
                        goto start_for_12;
                    end_for_12:;
                }
                var_631 = wp::where(var_579, var_586, var_540);
                var_632 = wp::where(var_579, var_587, var_541);
                var_633 = wp::where(var_579, var_592, var_542);
            }
            var_634 = wp::where(var_566, var_577, var_539);
            var_635 = wp::where(var_566, var_631, var_540);
            var_636 = wp::where(var_566, var_632, var_541);
            var_637 = wp::where(var_566, var_633, var_542);
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_640 = wp::extract(var_5, var_639);
            var_641 = side_in_order_0(var_638, var_640);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_643 = wp::extract(var_1, var_642);
            var_644 = gap_to_0(var_643, var_641, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_645 = wp::mul(var_644, var_644);
            var_646 = wp::mul(var_549, var_549);
            var_647 = wp::add(var_645, var_646);
            var_648 = wp::mul(var_16, var_16);
            var_649 = wp::add(var_647, var_648);
            var_650 = (var_649 < var_6);
            if (var_650) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_652 = wp::extract(var_0, var_651);
                var_653 = wp::add(var_652, var_641);
                var_655 = wp::extract(var_0, var_654);
                var_656 = wp::add(var_655, var_546);
                var_658 = wp::extract(var_0, var_657);
                var_659 = wp::add(var_658, var_13);
                var_660 = block_key_0(var_653, var_656, var_659);
                var_661 = find_position_0(var_660, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_663 = (var_661 >= var_662);
                if (var_663) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_664 = wp::float(var_641);
                    var_665 = wp::mul(var_664, var_9);
                    var_666 = wp::float(var_546);
                    var_667 = wp::mul(var_666, var_9);
                    var_668 = wp::float(var_13);
                    var_669 = wp::mul(var_668, var_9);
                    var_670 = wp::vec_t<3, wp::float32>(var_665, var_667, var_669);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_671 = wp::mul(var_661, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_672 = wp::address(var_voxel_map__counts, var_661);
                    var_674 = wp::load(var_672);
                    var_673 = wp::add(var_671, var_674);
                    var_675 = wp::range(var_671, var_673);
                    start_for_14:;
                        if (iter_cmp(var_675) == 0) goto end_for_14;
                        var_676 = wp::iter_next(var_675);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_677 = wp::address(var_voxel_map__offsets, var_676);
                        var_679 = wp::load(var_677);
                        var_678 = wp::add(var_679, var_670);
                        var_680 = wp::sub(var_678, var_1);
                        var_681 = widen_0(var_680);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_682 = wp::dot(var_681, var_681);
                        var_683 = wp::float(var_682);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_685 = (var_683 < var_6);
                        var_684 = var_685;
                        if (var_684) {
                            var_686 = wp::mul(var_78, var_6);
                            var_687 = (var_683 > var_686);
                            var_684 = var_684 && var_687;
                        }
                        if (var_684) {
                            // a = dot(d, u)                                                  <L 29>
                            var_688 = wp::dot(var_681, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_689 = wp::dot(var_681, var_v);
                            // octant = int(0)                                                <L 31>
                            var_691 = wp::int(var_690);
                            // if a > float64(0.0):                                           <L 32>
                            var_692 = 0.0;
                            var_693 = (var_688 > var_692);
                            if (var_693) {
                                // octant += 1                                                <L 33>
                                var_695 = wp::add(var_691, var_694);
                            }
                            var_696 = wp::where(var_693, var_695, var_691);
                            // if b > float64(0.0):                                           <L 34>
                            var_697 = 0.0;
                            var_698 = (var_689 > var_697);
                            if (var_698) {
                                // octant += 2                                                <L 35>
                                var_700 = wp::add(var_696, var_699);
                            }
                            var_701 = wp::where(var_698, var_700, var_696);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_702 = wp::abs(var_688);
                            var_703 = wp::abs(var_689);
                            var_704 = (var_702 > var_703);
                            if (var_704) {
                                // octant += 4                                                <L 37>
                                var_706 = wp::add(var_701, var_705);
                            }
                            var_707 = wp::where(var_704, var_706, var_701);
                            // octants = octants | 1 << octant                                <L 38>
                            var_709 = wp::lshift(var_708, var_707);
                            var_710 = wp::bit_or(var_8, var_709);
                        }
                        var_711 = wp::where(var_684, var_710, var_8);
                        var_712 = wp::where(var_684, var_688, var_81);
                        var_713 = wp::where(var_684, var_689, var_82);
                        var_714 = wp::where(var_684, var_707, var_100);
                        wp::assign(var_8, var_711);
                        wp::assign(var_73, var_681);
                        wp::assign(var_75, var_683);
                        wp::assign(var_81, var_712);
                        wp::assign(var_82, var_713);
                        wp::assign(var_100, var_714);
                        goto start_for_14;
                    end_for_14:;
                }
                var_715 = wp::where(var_663, var_670, var_635);
                var_716 = wp::where(var_663, var_671, var_636);
                var_717 = wp::where(var_663, var_676, var_637);
            }
            var_718 = wp::where(var_650, var_661, var_634);
            var_719 = wp::where(var_650, var_715, var_635);
            var_720 = wp::where(var_650, var_716, var_636);
            var_721 = wp::where(var_650, var_717, var_637);
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_724 = wp::extract(var_5, var_723);
            var_725 = side_in_order_0(var_722, var_724);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_727 = wp::extract(var_1, var_726);
            var_728 = gap_to_0(var_727, var_725, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_729 = wp::mul(var_728, var_728);
            var_730 = wp::mul(var_549, var_549);
            var_731 = wp::add(var_729, var_730);
            var_732 = wp::mul(var_16, var_16);
            var_733 = wp::add(var_731, var_732);
            var_734 = (var_733 < var_6);
            if (var_734) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_736 = wp::extract(var_0, var_735);
                var_737 = wp::add(var_736, var_725);
                var_739 = wp::extract(var_0, var_738);
                var_740 = wp::add(var_739, var_546);
                var_742 = wp::extract(var_0, var_741);
                var_743 = wp::add(var_742, var_13);
                var_744 = block_key_0(var_737, var_740, var_743);
                var_745 = find_position_0(var_744, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_747 = (var_745 >= var_746);
                if (var_747) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_748 = wp::float(var_725);
                    var_749 = wp::mul(var_748, var_9);
                    var_750 = wp::float(var_546);
                    var_751 = wp::mul(var_750, var_9);
                    var_752 = wp::float(var_13);
                    var_753 = wp::mul(var_752, var_9);
                    var_754 = wp::vec_t<3, wp::float32>(var_749, var_751, var_753);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_755 = wp::mul(var_745, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_756 = wp::address(var_voxel_map__counts, var_745);
                    var_758 = wp::load(var_756);
                    var_757 = wp::add(var_755, var_758);
                    var_759 = wp::range(var_755, var_757);
                    start_for_16:;
                        if (iter_cmp(var_759) == 0) goto end_for_16;
                        var_760 = wp::iter_next(var_759);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_761 = wp::address(var_voxel_map__offsets, var_760);
                        var_763 = wp::load(var_761);
                        var_762 = wp::add(var_763, var_754);
                        var_764 = wp::sub(var_762, var_1);
                        var_765 = widen_0(var_764);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_766 = wp::dot(var_765, var_765);
                        var_767 = wp::float(var_766);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_769 = (var_767 < var_6);
                        var_768 = var_769;
                        if (var_768) {
                            var_770 = wp::mul(var_78, var_6);
                            var_771 = (var_767 > var_770);
                            var_768 = var_768 && var_771;
                        }
                        if (var_768) {
                            // a = dot(d, u)                                                  <L 29>
                            var_772 = wp::dot(var_765, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_773 = wp::dot(var_765, var_v);
                            // octant = int(0)                                                <L 31>
                            var_775 = wp::int(var_774);
                            // if a > float64(0.0):                                           <L 32>
                            var_776 = 0.0;
                            var_777 = (var_772 > var_776);
                            if (var_777) {
                                // octant += 1                                                <L 33>
                                var_779 = wp::add(var_775, var_778);
                            }
                            var_780 = wp::where(var_777, var_779, var_775);
                            // if b > float64(0.0):                                           <L 34>
                            var_781 = 0.0;
                            var_782 = (var_773 > var_781);
                            if (var_782) {
                                // octant += 2                                                <L 35>
                                var_784 = wp::add(var_780, var_783);
                            }
                            var_785 = wp::where(var_782, var_784, var_780);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_786 = wp::abs(var_772);
                            var_787 = wp::abs(var_773);
                            var_788 = (var_786 > var_787);
                            if (var_788) {
                                // octant += 4                                                <L 37>
                                var_790 = wp::add(var_785, var_789);
                            }
                            var_791 = wp::where(var_788, var_790, var_785);
                            // octants = octants | 1 << octant                                <L 38>
                            var_793 = wp::lshift(var_792, var_791);
                            var_794 = wp::bit_or(var_8, var_793);
                        }
                        var_795 = wp::where(var_768, var_794, var_8);
                        var_796 = wp::where(var_768, var_772, var_81);
                        var_797 = wp::where(var_768, var_773, var_82);
                        var_798 = wp::where(var_768, var_791, var_100);
                        wp::assign(var_8, var_795);
                        wp::assign(var_73, var_765);
                        wp::assign(var_75, var_767);
                        wp::assign(var_81, var_796);
                        wp::assign(var_82, var_797);
                        wp::assign(var_100, var_798);
                        goto start_for_16;
                    end_for_16:;
                }
                var_799 = wp::where(var_747, var_754, var_719);
                var_800 = wp::where(var_747, var_755, var_720);
                var_801 = wp::where(var_747, var_760, var_721);
            }
            var_802 = wp::where(var_734, var_745, var_718);
            var_803 = wp::where(var_734, var_799, var_719);
            var_804 = wp::where(var_734, var_800, var_720);
            var_805 = wp::where(var_734, var_801, var_721);
        }
        var_806 = wp::where(var_553, var_722, var_536);
        var_807 = wp::where(var_553, var_725, var_537);
        var_808 = wp::where(var_553, var_728, var_538);
        var_809 = wp::where(var_553, var_802, var_539);
        var_810 = wp::where(var_553, var_803, var_540);
        var_811 = wp::where(var_553, var_804, var_541);
        var_812 = wp::where(var_553, var_805, var_542);
    }
    // sz__voxels_around__1 = side_in_order(z__voxels_around__1, near[2])                     <L 10>
    var_815 = wp::extract(var_5, var_814);
    var_816 = side_in_order_0(var_813, var_815);
    // gz__voxels_around__1 = gap_to__voxels_around(position[2], sz__voxels_around__1, edge__voxels_around__1)       <L 11>
    var_818 = wp::extract(var_1, var_817);
    var_819 = gap_to_0(var_818, var_816, var_9);
    // if gz__voxels_around__1 * gz__voxels_around__1 < sqradius:                             <L 12>
    var_820 = wp::mul(var_819, var_819);
    var_821 = (var_820 < var_6);
    if (var_821) {
        // for y__voxels_around__1 in range(3):                                               <L 13>
        // sy__voxels_around__1 = side_in_order(y__voxels_around__1, near[1])                 <L 14>
        var_824 = wp::extract(var_5, var_823);
        var_825 = side_in_order_0(var_822, var_824);
        // gy__voxels_around__1 = gap_to__voxels_around(position[1], sy__voxels_around__1, edge__voxels_around__1)       <L 15>
        var_827 = wp::extract(var_1, var_826);
        var_828 = gap_to_0(var_827, var_825, var_9);
        // if gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 16>
        var_829 = wp::mul(var_828, var_828);
        var_830 = wp::mul(var_819, var_819);
        var_831 = wp::add(var_829, var_830);
        var_832 = (var_831 < var_6);
        if (var_832) {
            // for x__voxels_around__1 in range(3):                                           <L 17>
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_835 = wp::extract(var_5, var_834);
            var_836 = side_in_order_0(var_833, var_835);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_838 = wp::extract(var_1, var_837);
            var_839 = gap_to_0(var_838, var_836, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_840 = wp::mul(var_839, var_839);
            var_841 = wp::mul(var_828, var_828);
            var_842 = wp::add(var_840, var_841);
            var_843 = wp::mul(var_819, var_819);
            var_844 = wp::add(var_842, var_843);
            var_845 = (var_844 < var_6);
            if (var_845) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_847 = wp::extract(var_0, var_846);
                var_848 = wp::add(var_847, var_836);
                var_850 = wp::extract(var_0, var_849);
                var_851 = wp::add(var_850, var_825);
                var_853 = wp::extract(var_0, var_852);
                var_854 = wp::add(var_853, var_816);
                var_855 = block_key_0(var_848, var_851, var_854);
                var_856 = find_position_0(var_855, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_858 = (var_856 >= var_857);
                if (var_858) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_859 = wp::float(var_836);
                    var_860 = wp::mul(var_859, var_9);
                    var_861 = wp::float(var_825);
                    var_862 = wp::mul(var_861, var_9);
                    var_863 = wp::float(var_816);
                    var_864 = wp::mul(var_863, var_9);
                    var_865 = wp::vec_t<3, wp::float32>(var_860, var_862, var_864);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_866 = wp::mul(var_856, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_867 = wp::address(var_voxel_map__counts, var_856);
                    var_869 = wp::load(var_867);
                    var_868 = wp::add(var_866, var_869);
                    var_870 = wp::range(var_866, var_868);
                    start_for_18:;
                        if (iter_cmp(var_870) == 0) goto end_for_18;
                        var_871 = wp::iter_next(var_870);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_872 = wp::address(var_voxel_map__offsets, var_871);
                        var_874 = wp::load(var_872);
                        var_873 = wp::add(var_874, var_865);
                        var_875 = wp::sub(var_873, var_1);
                        var_876 = widen_0(var_875);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_877 = wp::dot(var_876, var_876);
                        var_878 = wp::float(var_877);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_880 = (var_878 < var_6);
                        var_879 = var_880;
                        if (var_879) {
                            var_881 = wp::mul(var_78, var_6);
                            var_882 = (var_878 > var_881);
                            var_879 = var_879 && var_882;
                        }
                        if (var_879) {
                            // a = dot(d, u)                                                  <L 29>
                            var_883 = wp::dot(var_876, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_884 = wp::dot(var_876, var_v);
                            // octant = int(0)                                                <L 31>
                            var_886 = wp::int(var_885);
                            // if a > float64(0.0):                                           <L 32>
                            var_887 = 0.0;
                            var_888 = (var_883 > var_887);
                            if (var_888) {
                                // octant += 1                                                <L 33>
                                var_890 = wp::add(var_886, var_889);
                            }
                            var_891 = wp::where(var_888, var_890, var_886);
                            // if b > float64(0.0):                                           <L 34>
                            var_892 = 0.0;
                            var_893 = (var_884 > var_892);
                            if (var_893) {
                                // octant += 2                                                <L 35>
                                var_895 = wp::add(var_891, var_894);
                            }
                            var_896 = wp::where(var_893, var_895, var_891);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_897 = wp::abs(var_883);
                            var_898 = wp::abs(var_884);
                            var_899 = (var_897 > var_898);
                            if (var_899) {
                                // octant += 4                                                <L 37>
                                var_901 = wp::add(var_896, var_900);
                            }
                            var_902 = wp::where(var_899, var_901, var_896);
                            // octants = octants | 1 << octant                                <L 38>
                            var_904 = wp::lshift(var_903, var_902);
                            var_905 = wp::bit_or(var_8, var_904);
                        }
                        var_906 = wp::where(var_879, var_905, var_8);
                        var_907 = wp::where(var_879, var_883, var_81);
                        var_908 = wp::where(var_879, var_884, var_82);
                        var_909 = wp::where(var_879, var_902, var_100);
                        wp::assign(var_8, var_906);
                        wp::assign(var_73, var_876);
                        wp::assign(var_75, var_878);
                        wp::assign(var_81, var_907);
                        wp::assign(var_82, var_908);
                        wp::assign(var_100, var_909);
                        goto start_for_18;
                    end_for_18:;
                }
                var_910 = wp::where(var_858, var_865, var_810);
                var_911 = wp::where(var_858, var_866, var_811);
                var_912 = wp::where(var_858, var_871, var_812);
            }
            var_913 = wp::where(var_845, var_856, var_809);
            var_914 = wp::where(var_845, var_910, var_810);
            var_915 = wp::where(var_845, var_911, var_811);
            var_916 = wp::where(var_845, var_912, var_812);
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_919 = wp::extract(var_5, var_918);
            var_920 = side_in_order_0(var_917, var_919);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_922 = wp::extract(var_1, var_921);
            var_923 = gap_to_0(var_922, var_920, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_924 = wp::mul(var_923, var_923);
            var_925 = wp::mul(var_828, var_828);
            var_926 = wp::add(var_924, var_925);
            var_927 = wp::mul(var_819, var_819);
            var_928 = wp::add(var_926, var_927);
            var_929 = (var_928 < var_6);
            if (var_929) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_931 = wp::extract(var_0, var_930);
                var_932 = wp::add(var_931, var_920);
                var_934 = wp::extract(var_0, var_933);
                var_935 = wp::add(var_934, var_825);
                var_937 = wp::extract(var_0, var_936);
                var_938 = wp::add(var_937, var_816);
                var_939 = block_key_0(var_932, var_935, var_938);
                var_940 = find_position_0(var_939, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_942 = (var_940 >= var_941);
                if (var_942) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_943 = wp::float(var_920);
                    var_944 = wp::mul(var_943, var_9);
                    var_945 = wp::float(var_825);
                    var_946 = wp::mul(var_945, var_9);
                    var_947 = wp::float(var_816);
                    var_948 = wp::mul(var_947, var_9);
                    var_949 = wp::vec_t<3, wp::float32>(var_944, var_946, var_948);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_950 = wp::mul(var_940, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_951 = wp::address(var_voxel_map__counts, var_940);
                    var_953 = wp::load(var_951);
                    var_952 = wp::add(var_950, var_953);
                    var_954 = wp::range(var_950, var_952);
                    start_for_20:;
                        if (iter_cmp(var_954) == 0) goto end_for_20;
                        var_955 = wp::iter_next(var_954);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_956 = wp::address(var_voxel_map__offsets, var_955);
                        var_958 = wp::load(var_956);
                        var_957 = wp::add(var_958, var_949);
                        var_959 = wp::sub(var_957, var_1);
                        var_960 = widen_0(var_959);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_961 = wp::dot(var_960, var_960);
                        var_962 = wp::float(var_961);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_964 = (var_962 < var_6);
                        var_963 = var_964;
                        if (var_963) {
                            var_965 = wp::mul(var_78, var_6);
                            var_966 = (var_962 > var_965);
                            var_963 = var_963 && var_966;
                        }
                        if (var_963) {
                            // a = dot(d, u)                                                  <L 29>
                            var_967 = wp::dot(var_960, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_968 = wp::dot(var_960, var_v);
                            // octant = int(0)                                                <L 31>
                            var_970 = wp::int(var_969);
                            // if a > float64(0.0):                                           <L 32>
                            var_971 = 0.0;
                            var_972 = (var_967 > var_971);
                            if (var_972) {
                                // octant += 1                                                <L 33>
                                var_974 = wp::add(var_970, var_973);
                            }
                            var_975 = wp::where(var_972, var_974, var_970);
                            // if b > float64(0.0):                                           <L 34>
                            var_976 = 0.0;
                            var_977 = (var_968 > var_976);
                            if (var_977) {
                                // octant += 2                                                <L 35>
                                var_979 = wp::add(var_975, var_978);
                            }
                            var_980 = wp::where(var_977, var_979, var_975);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_981 = wp::abs(var_967);
                            var_982 = wp::abs(var_968);
                            var_983 = (var_981 > var_982);
                            if (var_983) {
                                // octant += 4                                                <L 37>
                                var_985 = wp::add(var_980, var_984);
                            }
                            var_986 = wp::where(var_983, var_985, var_980);
                            // octants = octants | 1 << octant                                <L 38>
                            var_988 = wp::lshift(var_987, var_986);
                            var_989 = wp::bit_or(var_8, var_988);
                        }
                        var_990 = wp::where(var_963, var_989, var_8);
                        var_991 = wp::where(var_963, var_967, var_81);
                        var_992 = wp::where(var_963, var_968, var_82);
                        var_993 = wp::where(var_963, var_986, var_100);
                        wp::assign(var_8, var_990);
                        wp::assign(var_73, var_960);
                        wp::assign(var_75, var_962);
                        wp::assign(var_81, var_991);
                        wp::assign(var_82, var_992);
                        wp::assign(var_100, var_993);
                        goto start_for_20;
                    end_for_20:;
                }
                var_994 = wp::where(var_942, var_949, var_914);
                var_995 = wp::where(var_942, var_950, var_915);
                var_996 = wp::where(var_942, var_955, var_916);
            }
            var_997 = wp::where(var_929, var_940, var_913);
            var_998 = wp::where(var_929, var_994, var_914);
            var_999 = wp::where(var_929, var_995, var_915);
            var_1000 = wp::where(var_929, var_996, var_916);
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_1003 = wp::extract(var_5, var_1002);
            var_1004 = side_in_order_0(var_1001, var_1003);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_1006 = wp::extract(var_1, var_1005);
            var_1007 = gap_to_0(var_1006, var_1004, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_1008 = wp::mul(var_1007, var_1007);
            var_1009 = wp::mul(var_828, var_828);
            var_1010 = wp::add(var_1008, var_1009);
            var_1011 = wp::mul(var_819, var_819);
            var_1012 = wp::add(var_1010, var_1011);
            var_1013 = (var_1012 < var_6);
            if (var_1013) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_1015 = wp::extract(var_0, var_1014);
                var_1016 = wp::add(var_1015, var_1004);
                var_1018 = wp::extract(var_0, var_1017);
                var_1019 = wp::add(var_1018, var_825);
                var_1021 = wp::extract(var_0, var_1020);
                var_1022 = wp::add(var_1021, var_816);
                var_1023 = block_key_0(var_1016, var_1019, var_1022);
                var_1024 = find_position_0(var_1023, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_1026 = (var_1024 >= var_1025);
                if (var_1026) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_1027 = wp::float(var_1004);
                    var_1028 = wp::mul(var_1027, var_9);
                    var_1029 = wp::float(var_825);
                    var_1030 = wp::mul(var_1029, var_9);
                    var_1031 = wp::float(var_816);
                    var_1032 = wp::mul(var_1031, var_9);
                    var_1033 = wp::vec_t<3, wp::float32>(var_1028, var_1030, var_1032);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_1034 = wp::mul(var_1024, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_1035 = wp::address(var_voxel_map__counts, var_1024);
                    var_1037 = wp::load(var_1035);
                    var_1036 = wp::add(var_1034, var_1037);
                    var_1038 = wp::range(var_1034, var_1036);
                    start_for_22:;
                        if (iter_cmp(var_1038) == 0) goto end_for_22;
                        var_1039 = wp::iter_next(var_1038);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_1040 = wp::address(var_voxel_map__offsets, var_1039);
                        var_1042 = wp::load(var_1040);
                        var_1041 = wp::add(var_1042, var_1033);
                        var_1043 = wp::sub(var_1041, var_1);
                        var_1044 = widen_0(var_1043);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_1045 = wp::dot(var_1044, var_1044);
                        var_1046 = wp::float(var_1045);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_1048 = (var_1046 < var_6);
                        var_1047 = var_1048;
                        if (var_1047) {
                            var_1049 = wp::mul(var_78, var_6);
                            var_1050 = (var_1046 > var_1049);
                            var_1047 = var_1047 && var_1050;
                        }
                        if (var_1047) {
                            // a = dot(d, u)                                                  <L 29>
                            var_1051 = wp::dot(var_1044, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_1052 = wp::dot(var_1044, var_v);
                            // octant = int(0)                                                <L 31>
                            var_1054 = wp::int(var_1053);
                            // if a > float64(0.0):                                           <L 32>
                            var_1055 = 0.0;
                            var_1056 = (var_1051 > var_1055);
                            if (var_1056) {
                                // octant += 1                                                <L 33>
                                var_1058 = wp::add(var_1054, var_1057);
                            }
                            var_1059 = wp::where(var_1056, var_1058, var_1054);
                            // if b > float64(0.0):                                           <L 34>
                            var_1060 = 0.0;
                            var_1061 = (var_1052 > var_1060);
                            if (var_1061) {
                                // octant += 2                                                <L 35>
                                var_1063 = wp::add(var_1059, var_1062);
                            }
                            var_1064 = wp::where(var_1061, var_1063, var_1059);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_1065 = wp::abs(var_1051);
                            var_1066 = wp::abs(var_1052);
                            var_1067 = (var_1065 > var_1066);
                            if (var_1067) {
                                // octant += 4                                                <L 37>
                                var_1069 = wp::add(var_1064, var_1068);
                            }
                            var_1070 = wp::where(var_1067, var_1069, var_1064);
                            // octants = octants | 1 << octant                                <L 38>
                            var_1072 = wp::lshift(var_1071, var_1070);
                            var_1073 = wp::bit_or(var_8, var_1072);
                        }
                        var_1074 = wp::where(var_1047, var_1073, var_8);
                        var_1075 = wp::where(var_1047, var_1051, var_81);
                        var_1076 = wp::where(var_1047, var_1052, var_82);
                        var_1077 = wp::where(var_1047, var_1070, var_100);
                        wp::assign(var_8, var_1074);
                        wp::assign(var_73, var_1044);
                        wp::assign(var_75, var_1046);
                        wp::assign(var_81, var_1075);
                        wp::assign(var_82, var_1076);
                        wp::assign(var_100, var_1077);
                        goto start_for_22;
                    end_for_22:;
                }
                var_1078 = wp::where(var_1026, var_1033, var_998);
                var_1079 = wp::where(var_1026, var_1034, var_999);
                var_1080 = wp::where(var_1026, var_1039, var_1000);
            }
            var_1081 = wp::where(var_1013, var_1024, var_997);
            var_1082 = wp::where(var_1013, var_1078, var_998);
            var_1083 = wp::where(var_1013, var_1079, var_999);
            var_1084 = wp::where(var_1013, var_1080, var_1000);
        }
        var_1085 = wp::where(var_832, var_1001, var_806);
        var_1086 = wp::where(var_832, var_1004, var_807);
        var_1087 = wp::where(var_832, var_1007, var_808);
        var_1088 = wp::where(var_832, var_1081, var_809);
        var_1089 = wp::where(var_832, var_1082, var_810);
        var_1090 = wp::where(var_832, var_1083, var_811);
        var_1091 = wp::where(var_832, var_1084, var_812);
        // sy__voxels_around__1 = side_in_order(y__voxels_around__1, near[1])                 <L 14>
        var_1094 = wp::extract(var_5, var_1093);
        var_1095 = side_in_order_0(var_1092, var_1094);
        // gy__voxels_around__1 = gap_to__voxels_around(position[1], sy__voxels_around__1, edge__voxels_around__1)       <L 15>
        var_1097 = wp::extract(var_1, var_1096);
        var_1098 = gap_to_0(var_1097, var_1095, var_9);
        // if gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 16>
        var_1099 = wp::mul(var_1098, var_1098);
        var_1100 = wp::mul(var_819, var_819);
        var_1101 = wp::add(var_1099, var_1100);
        var_1102 = (var_1101 < var_6);
        if (var_1102) {
            // for x__voxels_around__1 in range(3):                                           <L 17>
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_1105 = wp::extract(var_5, var_1104);
            var_1106 = side_in_order_0(var_1103, var_1105);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_1108 = wp::extract(var_1, var_1107);
            var_1109 = gap_to_0(var_1108, var_1106, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_1110 = wp::mul(var_1109, var_1109);
            var_1111 = wp::mul(var_1098, var_1098);
            var_1112 = wp::add(var_1110, var_1111);
            var_1113 = wp::mul(var_819, var_819);
            var_1114 = wp::add(var_1112, var_1113);
            var_1115 = (var_1114 < var_6);
            if (var_1115) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_1117 = wp::extract(var_0, var_1116);
                var_1118 = wp::add(var_1117, var_1106);
                var_1120 = wp::extract(var_0, var_1119);
                var_1121 = wp::add(var_1120, var_1095);
                var_1123 = wp::extract(var_0, var_1122);
                var_1124 = wp::add(var_1123, var_816);
                var_1125 = block_key_0(var_1118, var_1121, var_1124);
                var_1126 = find_position_0(var_1125, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_1128 = (var_1126 >= var_1127);
                if (var_1128) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_1129 = wp::float(var_1106);
                    var_1130 = wp::mul(var_1129, var_9);
                    var_1131 = wp::float(var_1095);
                    var_1132 = wp::mul(var_1131, var_9);
                    var_1133 = wp::float(var_816);
                    var_1134 = wp::mul(var_1133, var_9);
                    var_1135 = wp::vec_t<3, wp::float32>(var_1130, var_1132, var_1134);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_1136 = wp::mul(var_1126, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_1137 = wp::address(var_voxel_map__counts, var_1126);
                    var_1139 = wp::load(var_1137);
                    var_1138 = wp::add(var_1136, var_1139);
                    var_1140 = wp::range(var_1136, var_1138);
                    start_for_24:;
                        if (iter_cmp(var_1140) == 0) goto end_for_24;
                        var_1141 = wp::iter_next(var_1140);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_1142 = wp::address(var_voxel_map__offsets, var_1141);
                        var_1144 = wp::load(var_1142);
                        var_1143 = wp::add(var_1144, var_1135);
                        var_1145 = wp::sub(var_1143, var_1);
                        var_1146 = widen_0(var_1145);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_1147 = wp::dot(var_1146, var_1146);
                        var_1148 = wp::float(var_1147);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_1150 = (var_1148 < var_6);
                        var_1149 = var_1150;
                        if (var_1149) {
                            var_1151 = wp::mul(var_78, var_6);
                            var_1152 = (var_1148 > var_1151);
                            var_1149 = var_1149 && var_1152;
                        }
                        if (var_1149) {
                            // a = dot(d, u)                                                  <L 29>
                            var_1153 = wp::dot(var_1146, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_1154 = wp::dot(var_1146, var_v);
                            // octant = int(0)                                                <L 31>
                            var_1156 = wp::int(var_1155);
                            // if a > float64(0.0):                                           <L 32>
                            var_1157 = 0.0;
                            var_1158 = (var_1153 > var_1157);
                            if (var_1158) {
                                // octant += 1                                                <L 33>
                                var_1160 = wp::add(var_1156, var_1159);
                            }
                            var_1161 = wp::where(var_1158, var_1160, var_1156);
                            // if b > float64(0.0):                                           <L 34>
                            var_1162 = 0.0;
                            var_1163 = (var_1154 > var_1162);
                            if (var_1163) {
                                // octant += 2                                                <L 35>
                                var_1165 = wp::add(var_1161, var_1164);
                            }
                            var_1166 = wp::where(var_1163, var_1165, var_1161);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_1167 = wp::abs(var_1153);
                            var_1168 = wp::abs(var_1154);
                            var_1169 = (var_1167 > var_1168);
                            if (var_1169) {
                                // octant += 4                                                <L 37>
                                var_1171 = wp::add(var_1166, var_1170);
                            }
                            var_1172 = wp::where(var_1169, var_1171, var_1166);
                            // octants = octants | 1 << octant                                <L 38>
                            var_1174 = wp::lshift(var_1173, var_1172);
                            var_1175 = wp::bit_or(var_8, var_1174);
                        }
                        var_1176 = wp::where(var_1149, var_1175, var_8);
                        var_1177 = wp::where(var_1149, var_1153, var_81);
                        var_1178 = wp::where(var_1149, var_1154, var_82);
                        var_1179 = wp::where(var_1149, var_1172, var_100);
                        wp::assign(var_8, var_1176);
                        wp::assign(var_73, var_1146);
                        wp::assign(var_75, var_1148);
                        wp::assign(var_81, var_1177);
                        wp::assign(var_82, var_1178);
                        wp::assign(var_100, var_1179);
                        goto start_for_24;
                    end_for_24:;
                }
                var_1180 = wp::where(var_1128, var_1135, var_1089);
                var_1181 = wp::where(var_1128, var_1136, var_1090);
                var_1182 = wp::where(var_1128, var_1141, var_1091);
            }
            var_1183 = wp::where(var_1115, var_1126, var_1088);
            var_1184 = wp::where(var_1115, var_1180, var_1089);
            var_1185 = wp::where(var_1115, var_1181, var_1090);
            var_1186 = wp::where(var_1115, var_1182, var_1091);
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_1189 = wp::extract(var_5, var_1188);
            var_1190 = side_in_order_0(var_1187, var_1189);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_1192 = wp::extract(var_1, var_1191);
            var_1193 = gap_to_0(var_1192, var_1190, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_1194 = wp::mul(var_1193, var_1193);
            var_1195 = wp::mul(var_1098, var_1098);
            var_1196 = wp::add(var_1194, var_1195);
            var_1197 = wp::mul(var_819, var_819);
            var_1198 = wp::add(var_1196, var_1197);
            var_1199 = (var_1198 < var_6);
            if (var_1199) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_1201 = wp::extract(var_0, var_1200);
                var_1202 = wp::add(var_1201, var_1190);
                var_1204 = wp::extract(var_0, var_1203);
                var_1205 = wp::add(var_1204, var_1095);
                var_1207 = wp::extract(var_0, var_1206);
                var_1208 = wp::add(var_1207, var_816);
                var_1209 = block_key_0(var_1202, var_1205, var_1208);
                var_1210 = find_position_0(var_1209, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_1212 = (var_1210 >= var_1211);
                if (var_1212) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_1213 = wp::float(var_1190);
                    var_1214 = wp::mul(var_1213, var_9);
                    var_1215 = wp::float(var_1095);
                    var_1216 = wp::mul(var_1215, var_9);
                    var_1217 = wp::float(var_816);
                    var_1218 = wp::mul(var_1217, var_9);
                    var_1219 = wp::vec_t<3, wp::float32>(var_1214, var_1216, var_1218);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_1220 = wp::mul(var_1210, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_1221 = wp::address(var_voxel_map__counts, var_1210);
                    var_1223 = wp::load(var_1221);
                    var_1222 = wp::add(var_1220, var_1223);
                    var_1224 = wp::range(var_1220, var_1222);
                    start_for_26:;
                        if (iter_cmp(var_1224) == 0) goto end_for_26;
                        var_1225 = wp::iter_next(var_1224);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_1226 = wp::address(var_voxel_map__offsets, var_1225);
                        var_1228 = wp::load(var_1226);
                        var_1227 = wp::add(var_1228, var_1219);
                        var_1229 = wp::sub(var_1227, var_1);
                        var_1230 = widen_0(var_1229);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_1231 = wp::dot(var_1230, var_1230);
                        var_1232 = wp::float(var_1231);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_1234 = (var_1232 < var_6);
                        var_1233 = var_1234;
                        if (var_1233) {
                            var_1235 = wp::mul(var_78, var_6);
                            var_1236 = (var_1232 > var_1235);
                            var_1233 = var_1233 && var_1236;
                        }
                        if (var_1233) {
                            // a = dot(d, u)                                                  <L 29>
                            var_1237 = wp::dot(var_1230, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_1238 = wp::dot(var_1230, var_v);
                            // octant = int(0)                                                <L 31>
                            var_1240 = wp::int(var_1239);
                            // if a > float64(0.0):                                           <L 32>
                            var_1241 = 0.0;
                            var_1242 = (var_1237 > var_1241);
                            if (var_1242) {
                                // octant += 1                                                <L 33>
                                var_1244 = wp::add(var_1240, var_1243);
                            }
                            var_1245 = wp::where(var_1242, var_1244, var_1240);
                            // if b > float64(0.0):                                           <L 34>
                            var_1246 = 0.0;
                            var_1247 = (var_1238 > var_1246);
                            if (var_1247) {
                                // octant += 2                                                <L 35>
                                var_1249 = wp::add(var_1245, var_1248);
                            }
                            var_1250 = wp::where(var_1247, var_1249, var_1245);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_1251 = wp::abs(var_1237);
                            var_1252 = wp::abs(var_1238);
                            var_1253 = (var_1251 > var_1252);
                            if (var_1253) {
                                // octant += 4                                                <L 37>
                                var_1255 = wp::add(var_1250, var_1254);
                            }
                            var_1256 = wp::where(var_1253, var_1255, var_1250);
                            // octants = octants | 1 << octant                                <L 38>
                            var_1258 = wp::lshift(var_1257, var_1256);
                            var_1259 = wp::bit_or(var_8, var_1258);
                        }
                        var_1260 = wp::where(var_1233, var_1259, var_8);
                        var_1261 = wp::where(var_1233, var_1237, var_81);
                        var_1262 = wp::where(var_1233, var_1238, var_82);
                        var_1263 = wp::where(var_1233, var_1256, var_100);
                        wp::assign(var_8, var_1260);
                        wp::assign(var_73, var_1230);
                        wp::assign(var_75, var_1232);
                        wp::assign(var_81, var_1261);
                        wp::assign(var_82, var_1262);
                        wp::assign(var_100, var_1263);
                        goto start_for_26;
                    end_for_26:;
                }
                var_1264 = wp::where(var_1212, var_1219, var_1184);
                var_1265 = wp::where(var_1212, var_1220, var_1185);
                var_1266 = wp::where(var_1212, var_1225, var_1186);
            }
            var_1267 = wp::where(var_1199, var_1210, var_1183);
            var_1268 = wp::where(var_1199, var_1264, var_1184);
            var_1269 = wp::where(var_1199, var_1265, var_1185);
            var_1270 = wp::where(var_1199, var_1266, var_1186);
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_1273 = wp::extract(var_5, var_1272);
            var_1274 = side_in_order_0(var_1271, var_1273);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_1276 = wp::extract(var_1, var_1275);
            var_1277 = gap_to_0(var_1276, var_1274, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_1278 = wp::mul(var_1277, var_1277);
            var_1279 = wp::mul(var_1098, var_1098);
            var_1280 = wp::add(var_1278, var_1279);
            var_1281 = wp::mul(var_819, var_819);
            var_1282 = wp::add(var_1280, var_1281);
            var_1283 = (var_1282 < var_6);
            if (var_1283) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_1285 = wp::extract(var_0, var_1284);
                var_1286 = wp::add(var_1285, var_1274);
                var_1288 = wp::extract(var_0, var_1287);
                var_1289 = wp::add(var_1288, var_1095);
                var_1291 = wp::extract(var_0, var_1290);
                var_1292 = wp::add(var_1291, var_816);
                var_1293 = block_key_0(var_1286, var_1289, var_1292);
                var_1294 = find_position_0(var_1293, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_1296 = (var_1294 >= var_1295);
                if (var_1296) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_1297 = wp::float(var_1274);
                    var_1298 = wp::mul(var_1297, var_9);
                    var_1299 = wp::float(var_1095);
                    var_1300 = wp::mul(var_1299, var_9);
                    var_1301 = wp::float(var_816);
                    var_1302 = wp::mul(var_1301, var_9);
                    var_1303 = wp::vec_t<3, wp::float32>(var_1298, var_1300, var_1302);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_1304 = wp::mul(var_1294, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_1305 = wp::address(var_voxel_map__counts, var_1294);
                    var_1307 = wp::load(var_1305);
                    var_1306 = wp::add(var_1304, var_1307);
                    var_1308 = wp::range(var_1304, var_1306);
                    start_for_28:;
                        if (iter_cmp(var_1308) == 0) goto end_for_28;
                        var_1309 = wp::iter_next(var_1308);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_1310 = wp::address(var_voxel_map__offsets, var_1309);
                        var_1312 = wp::load(var_1310);
                        var_1311 = wp::add(var_1312, var_1303);
                        var_1313 = wp::sub(var_1311, var_1);
                        var_1314 = widen_0(var_1313);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_1315 = wp::dot(var_1314, var_1314);
                        var_1316 = wp::float(var_1315);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_1318 = (var_1316 < var_6);
                        var_1317 = var_1318;
                        if (var_1317) {
                            var_1319 = wp::mul(var_78, var_6);
                            var_1320 = (var_1316 > var_1319);
                            var_1317 = var_1317 && var_1320;
                        }
                        if (var_1317) {
                            // a = dot(d, u)                                                  <L 29>
                            var_1321 = wp::dot(var_1314, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_1322 = wp::dot(var_1314, var_v);
                            // octant = int(0)                                                <L 31>
                            var_1324 = wp::int(var_1323);
                            // if a > float64(0.0):                                           <L 32>
                            var_1325 = 0.0;
                            var_1326 = (var_1321 > var_1325);
                            if (var_1326) {
                                // octant += 1                                                <L 33>
                                var_1328 = wp::add(var_1324, var_1327);
                            }
                            var_1329 = wp::where(var_1326, var_1328, var_1324);
                            // if b > float64(0.0):                                           <L 34>
                            var_1330 = 0.0;
                            var_1331 = (var_1322 > var_1330);
                            if (var_1331) {
                                // octant += 2                                                <L 35>
                                var_1333 = wp::add(var_1329, var_1332);
                            }
                            var_1334 = wp::where(var_1331, var_1333, var_1329);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_1335 = wp::abs(var_1321);
                            var_1336 = wp::abs(var_1322);
                            var_1337 = (var_1335 > var_1336);
                            if (var_1337) {
                                // octant += 4                                                <L 37>
                                var_1339 = wp::add(var_1334, var_1338);
                            }
                            var_1340 = wp::where(var_1337, var_1339, var_1334);
                            // octants = octants | 1 << octant                                <L 38>
                            var_1342 = wp::lshift(var_1341, var_1340);
                            var_1343 = wp::bit_or(var_8, var_1342);
                        }
                        var_1344 = wp::where(var_1317, var_1343, var_8);
                        var_1345 = wp::where(var_1317, var_1321, var_81);
                        var_1346 = wp::where(var_1317, var_1322, var_82);
                        var_1347 = wp::where(var_1317, var_1340, var_100);
                        wp::assign(var_8, var_1344);
                        wp::assign(var_73, var_1314);
                        wp::assign(var_75, var_1316);
                        wp::assign(var_81, var_1345);
                        wp::assign(var_82, var_1346);
                        wp::assign(var_100, var_1347);
                        goto start_for_28;
                    end_for_28:;
                }
                var_1348 = wp::where(var_1296, var_1303, var_1268);
                var_1349 = wp::where(var_1296, var_1304, var_1269);
                var_1350 = wp::where(var_1296, var_1309, var_1270);
            }
            var_1351 = wp::where(var_1283, var_1294, var_1267);
            var_1352 = wp::where(var_1283, var_1348, var_1268);
            var_1353 = wp::where(var_1283, var_1349, var_1269);
            var_1354 = wp::where(var_1283, var_1350, var_1270);
        }
        var_1355 = wp::where(var_1102, var_1271, var_1085);
        var_1356 = wp::where(var_1102, var_1274, var_1086);
        var_1357 = wp::where(var_1102, var_1277, var_1087);
        var_1358 = wp::where(var_1102, var_1351, var_1088);
        var_1359 = wp::where(var_1102, var_1352, var_1089);
        var_1360 = wp::where(var_1102, var_1353, var_1090);
        var_1361 = wp::where(var_1102, var_1354, var_1091);
        // sy__voxels_around__1 = side_in_order(y__voxels_around__1, near[1])                 <L 14>
        var_1364 = wp::extract(var_5, var_1363);
        var_1365 = side_in_order_0(var_1362, var_1364);
        // gy__voxels_around__1 = gap_to__voxels_around(position[1], sy__voxels_around__1, edge__voxels_around__1)       <L 15>
        var_1367 = wp::extract(var_1, var_1366);
        var_1368 = gap_to_0(var_1367, var_1365, var_9);
        // if gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 16>
        var_1369 = wp::mul(var_1368, var_1368);
        var_1370 = wp::mul(var_819, var_819);
        var_1371 = wp::add(var_1369, var_1370);
        var_1372 = (var_1371 < var_6);
        if (var_1372) {
            // for x__voxels_around__1 in range(3):                                           <L 17>
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_1375 = wp::extract(var_5, var_1374);
            var_1376 = side_in_order_0(var_1373, var_1375);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_1378 = wp::extract(var_1, var_1377);
            var_1379 = gap_to_0(var_1378, var_1376, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_1380 = wp::mul(var_1379, var_1379);
            var_1381 = wp::mul(var_1368, var_1368);
            var_1382 = wp::add(var_1380, var_1381);
            var_1383 = wp::mul(var_819, var_819);
            var_1384 = wp::add(var_1382, var_1383);
            var_1385 = (var_1384 < var_6);
            if (var_1385) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_1387 = wp::extract(var_0, var_1386);
                var_1388 = wp::add(var_1387, var_1376);
                var_1390 = wp::extract(var_0, var_1389);
                var_1391 = wp::add(var_1390, var_1365);
                var_1393 = wp::extract(var_0, var_1392);
                var_1394 = wp::add(var_1393, var_816);
                var_1395 = block_key_0(var_1388, var_1391, var_1394);
                var_1396 = find_position_0(var_1395, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_1398 = (var_1396 >= var_1397);
                if (var_1398) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_1399 = wp::float(var_1376);
                    var_1400 = wp::mul(var_1399, var_9);
                    var_1401 = wp::float(var_1365);
                    var_1402 = wp::mul(var_1401, var_9);
                    var_1403 = wp::float(var_816);
                    var_1404 = wp::mul(var_1403, var_9);
                    var_1405 = wp::vec_t<3, wp::float32>(var_1400, var_1402, var_1404);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_1406 = wp::mul(var_1396, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_1407 = wp::address(var_voxel_map__counts, var_1396);
                    var_1409 = wp::load(var_1407);
                    var_1408 = wp::add(var_1406, var_1409);
                    var_1410 = wp::range(var_1406, var_1408);
                    start_for_30:;
                        if (iter_cmp(var_1410) == 0) goto end_for_30;
                        var_1411 = wp::iter_next(var_1410);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_1412 = wp::address(var_voxel_map__offsets, var_1411);
                        var_1414 = wp::load(var_1412);
                        var_1413 = wp::add(var_1414, var_1405);
                        var_1415 = wp::sub(var_1413, var_1);
                        var_1416 = widen_0(var_1415);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_1417 = wp::dot(var_1416, var_1416);
                        var_1418 = wp::float(var_1417);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_1420 = (var_1418 < var_6);
                        var_1419 = var_1420;
                        if (var_1419) {
                            var_1421 = wp::mul(var_78, var_6);
                            var_1422 = (var_1418 > var_1421);
                            var_1419 = var_1419 && var_1422;
                        }
                        if (var_1419) {
                            // a = dot(d, u)                                                  <L 29>
                            var_1423 = wp::dot(var_1416, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_1424 = wp::dot(var_1416, var_v);
                            // octant = int(0)                                                <L 31>
                            var_1426 = wp::int(var_1425);
                            // if a > float64(0.0):                                           <L 32>
                            var_1427 = 0.0;
                            var_1428 = (var_1423 > var_1427);
                            if (var_1428) {
                                // octant += 1                                                <L 33>
                                var_1430 = wp::add(var_1426, var_1429);
                            }
                            var_1431 = wp::where(var_1428, var_1430, var_1426);
                            // if b > float64(0.0):                                           <L 34>
                            var_1432 = 0.0;
                            var_1433 = (var_1424 > var_1432);
                            if (var_1433) {
                                // octant += 2                                                <L 35>
                                var_1435 = wp::add(var_1431, var_1434);
                            }
                            var_1436 = wp::where(var_1433, var_1435, var_1431);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_1437 = wp::abs(var_1423);
                            var_1438 = wp::abs(var_1424);
                            var_1439 = (var_1437 > var_1438);
                            if (var_1439) {
                                // octant += 4                                                <L 37>
                                var_1441 = wp::add(var_1436, var_1440);
                            }
                            var_1442 = wp::where(var_1439, var_1441, var_1436);
                            // octants = octants | 1 << octant                                <L 38>
                            var_1444 = wp::lshift(var_1443, var_1442);
                            var_1445 = wp::bit_or(var_8, var_1444);
                        }
                        var_1446 = wp::where(var_1419, var_1445, var_8);
                        var_1447 = wp::where(var_1419, var_1423, var_81);
                        var_1448 = wp::where(var_1419, var_1424, var_82);
                        var_1449 = wp::where(var_1419, var_1442, var_100);
                        wp::assign(var_8, var_1446);
                        wp::assign(var_73, var_1416);
                        wp::assign(var_75, var_1418);
                        wp::assign(var_81, var_1447);
                        wp::assign(var_82, var_1448);
                        wp::assign(var_100, var_1449);
                        goto start_for_30;
                    end_for_30:;
                }
                var_1450 = wp::where(var_1398, var_1405, var_1359);
                var_1451 = wp::where(var_1398, var_1406, var_1360);
                var_1452 = wp::where(var_1398, var_1411, var_1361);
            }
            var_1453 = wp::where(var_1385, var_1396, var_1358);
            var_1454 = wp::where(var_1385, var_1450, var_1359);
            var_1455 = wp::where(var_1385, var_1451, var_1360);
            var_1456 = wp::where(var_1385, var_1452, var_1361);
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_1459 = wp::extract(var_5, var_1458);
            var_1460 = side_in_order_0(var_1457, var_1459);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_1462 = wp::extract(var_1, var_1461);
            var_1463 = gap_to_0(var_1462, var_1460, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_1464 = wp::mul(var_1463, var_1463);
            var_1465 = wp::mul(var_1368, var_1368);
            var_1466 = wp::add(var_1464, var_1465);
            var_1467 = wp::mul(var_819, var_819);
            var_1468 = wp::add(var_1466, var_1467);
            var_1469 = (var_1468 < var_6);
            if (var_1469) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_1471 = wp::extract(var_0, var_1470);
                var_1472 = wp::add(var_1471, var_1460);
                var_1474 = wp::extract(var_0, var_1473);
                var_1475 = wp::add(var_1474, var_1365);
                var_1477 = wp::extract(var_0, var_1476);
                var_1478 = wp::add(var_1477, var_816);
                var_1479 = block_key_0(var_1472, var_1475, var_1478);
                var_1480 = find_position_0(var_1479, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_1482 = (var_1480 >= var_1481);
                if (var_1482) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_1483 = wp::float(var_1460);
                    var_1484 = wp::mul(var_1483, var_9);
                    var_1485 = wp::float(var_1365);
                    var_1486 = wp::mul(var_1485, var_9);
                    var_1487 = wp::float(var_816);
                    var_1488 = wp::mul(var_1487, var_9);
                    var_1489 = wp::vec_t<3, wp::float32>(var_1484, var_1486, var_1488);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_1490 = wp::mul(var_1480, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_1491 = wp::address(var_voxel_map__counts, var_1480);
                    var_1493 = wp::load(var_1491);
                    var_1492 = wp::add(var_1490, var_1493);
                    var_1494 = wp::range(var_1490, var_1492);
                    start_for_32:;
                        if (iter_cmp(var_1494) == 0) goto end_for_32;
                        var_1495 = wp::iter_next(var_1494);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_1496 = wp::address(var_voxel_map__offsets, var_1495);
                        var_1498 = wp::load(var_1496);
                        var_1497 = wp::add(var_1498, var_1489);
                        var_1499 = wp::sub(var_1497, var_1);
                        var_1500 = widen_0(var_1499);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_1501 = wp::dot(var_1500, var_1500);
                        var_1502 = wp::float(var_1501);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_1504 = (var_1502 < var_6);
                        var_1503 = var_1504;
                        if (var_1503) {
                            var_1505 = wp::mul(var_78, var_6);
                            var_1506 = (var_1502 > var_1505);
                            var_1503 = var_1503 && var_1506;
                        }
                        if (var_1503) {
                            // a = dot(d, u)                                                  <L 29>
                            var_1507 = wp::dot(var_1500, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_1508 = wp::dot(var_1500, var_v);
                            // octant = int(0)                                                <L 31>
                            var_1510 = wp::int(var_1509);
                            // if a > float64(0.0):                                           <L 32>
                            var_1511 = 0.0;
                            var_1512 = (var_1507 > var_1511);
                            if (var_1512) {
                                // octant += 1                                                <L 33>
                                var_1514 = wp::add(var_1510, var_1513);
                            }
                            var_1515 = wp::where(var_1512, var_1514, var_1510);
                            // if b > float64(0.0):                                           <L 34>
                            var_1516 = 0.0;
                            var_1517 = (var_1508 > var_1516);
                            if (var_1517) {
                                // octant += 2                                                <L 35>
                                var_1519 = wp::add(var_1515, var_1518);
                            }
                            var_1520 = wp::where(var_1517, var_1519, var_1515);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_1521 = wp::abs(var_1507);
                            var_1522 = wp::abs(var_1508);
                            var_1523 = (var_1521 > var_1522);
                            if (var_1523) {
                                // octant += 4                                                <L 37>
                                var_1525 = wp::add(var_1520, var_1524);
                            }
                            var_1526 = wp::where(var_1523, var_1525, var_1520);
                            // octants = octants | 1 << octant                                <L 38>
                            var_1528 = wp::lshift(var_1527, var_1526);
                            var_1529 = wp::bit_or(var_8, var_1528);
                        }
                        var_1530 = wp::where(var_1503, var_1529, var_8);
                        var_1531 = wp::where(var_1503, var_1507, var_81);
                        var_1532 = wp::where(var_1503, var_1508, var_82);
                        var_1533 = wp::where(var_1503, var_1526, var_100);
                        wp::assign(var_8, var_1530);
                        wp::assign(var_73, var_1500);
                        wp::assign(var_75, var_1502);
                        wp::assign(var_81, var_1531);
                        wp::assign(var_82, var_1532);
                        wp::assign(var_100, var_1533);
                        goto start_for_32;
                    end_for_32:;
                }
                var_1534 = wp::where(var_1482, var_1489, var_1454);
                var_1535 = wp::where(var_1482, var_1490, var_1455);
                var_1536 = wp::where(var_1482, var_1495, var_1456);
            }
            var_1537 = wp::where(var_1469, var_1480, var_1453);
            var_1538 = wp::where(var_1469, var_1534, var_1454);
            var_1539 = wp::where(var_1469, var_1535, var_1455);
            var_1540 = wp::where(var_1469, var_1536, var_1456);
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_1543 = wp::extract(var_5, var_1542);
            var_1544 = side_in_order_0(var_1541, var_1543);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_1546 = wp::extract(var_1, var_1545);
            var_1547 = gap_to_0(var_1546, var_1544, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_1548 = wp::mul(var_1547, var_1547);
            var_1549 = wp::mul(var_1368, var_1368);
            var_1550 = wp::add(var_1548, var_1549);
            var_1551 = wp::mul(var_819, var_819);
            var_1552 = wp::add(var_1550, var_1551);
            var_1553 = (var_1552 < var_6);
            if (var_1553) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_1555 = wp::extract(var_0, var_1554);
                var_1556 = wp::add(var_1555, var_1544);
                var_1558 = wp::extract(var_0, var_1557);
                var_1559 = wp::add(var_1558, var_1365);
                var_1561 = wp::extract(var_0, var_1560);
                var_1562 = wp::add(var_1561, var_816);
                var_1563 = block_key_0(var_1556, var_1559, var_1562);
                var_1564 = find_position_0(var_1563, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_1566 = (var_1564 >= var_1565);
                if (var_1566) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_1567 = wp::float(var_1544);
                    var_1568 = wp::mul(var_1567, var_9);
                    var_1569 = wp::float(var_1365);
                    var_1570 = wp::mul(var_1569, var_9);
                    var_1571 = wp::float(var_816);
                    var_1572 = wp::mul(var_1571, var_9);
                    var_1573 = wp::vec_t<3, wp::float32>(var_1568, var_1570, var_1572);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_1574 = wp::mul(var_1564, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_1575 = wp::address(var_voxel_map__counts, var_1564);
                    var_1577 = wp::load(var_1575);
                    var_1576 = wp::add(var_1574, var_1577);
                    var_1578 = wp::range(var_1574, var_1576);
                    start_for_34:;
                        if (iter_cmp(var_1578) == 0) goto end_for_34;
                        var_1579 = wp::iter_next(var_1578);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_1580 = wp::address(var_voxel_map__offsets, var_1579);
                        var_1582 = wp::load(var_1580);
                        var_1581 = wp::add(var_1582, var_1573);
                        var_1583 = wp::sub(var_1581, var_1);
                        var_1584 = widen_0(var_1583);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_1585 = wp::dot(var_1584, var_1584);
                        var_1586 = wp::float(var_1585);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_1588 = (var_1586 < var_6);
                        var_1587 = var_1588;
                        if (var_1587) {
                            var_1589 = wp::mul(var_78, var_6);
                            var_1590 = (var_1586 > var_1589);
                            var_1587 = var_1587 && var_1590;
                        }
                        if (var_1587) {
                            // a = dot(d, u)                                                  <L 29>
                            var_1591 = wp::dot(var_1584, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_1592 = wp::dot(var_1584, var_v);
                            // octant = int(0)                                                <L 31>
                            var_1594 = wp::int(var_1593);
                            // if a > float64(0.0):                                           <L 32>
                            var_1595 = 0.0;
                            var_1596 = (var_1591 > var_1595);
                            if (var_1596) {
                                // octant += 1                                                <L 33>
                                var_1598 = wp::add(var_1594, var_1597);
                            }
                            var_1599 = wp::where(var_1596, var_1598, var_1594);
                            // if b > float64(0.0):                                           <L 34>
                            var_1600 = 0.0;
                            var_1601 = (var_1592 > var_1600);
                            if (var_1601) {
                                // octant += 2                                                <L 35>
                                var_1603 = wp::add(var_1599, var_1602);
                            }
                            var_1604 = wp::where(var_1601, var_1603, var_1599);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_1605 = wp::abs(var_1591);
                            var_1606 = wp::abs(var_1592);
                            var_1607 = (var_1605 > var_1606);
                            if (var_1607) {
                                // octant += 4                                                <L 37>
                                var_1609 = wp::add(var_1604, var_1608);
                            }
                            var_1610 = wp::where(var_1607, var_1609, var_1604);
                            // octants = octants | 1 << octant                                <L 38>
                            var_1612 = wp::lshift(var_1611, var_1610);
                            var_1613 = wp::bit_or(var_8, var_1612);
                        }
                        var_1614 = wp::where(var_1587, var_1613, var_8);
                        var_1615 = wp::where(var_1587, var_1591, var_81);
                        var_1616 = wp::where(var_1587, var_1592, var_82);
                        var_1617 = wp::where(var_1587, var_1610, var_100);
                        wp::assign(var_8, var_1614);
                        wp::assign(var_73, var_1584);
                        wp::assign(var_75, var_1586);
                        wp::assign(var_81, var_1615);
                        wp::assign(var_82, var_1616);
                        wp::assign(var_100, var_1617);
                        goto start_for_34;
                    end_for_34:;
                }
                var_1618 = wp::where(var_1566, var_1573, var_1538);
                var_1619 = wp::where(var_1566, var_1574, var_1539);
                var_1620 = wp::where(var_1566, var_1579, var_1540);
            }
            var_1621 = wp::where(var_1553, var_1564, var_1537);
            var_1622 = wp::where(var_1553, var_1618, var_1538);
            var_1623 = wp::where(var_1553, var_1619, var_1539);
            var_1624 = wp::where(var_1553, var_1620, var_1540);
        }
        var_1625 = wp::where(var_1372, var_1541, var_1355);
        var_1626 = wp::where(var_1372, var_1544, var_1356);
        var_1627 = wp::where(var_1372, var_1547, var_1357);
        var_1628 = wp::where(var_1372, var_1621, var_1358);
        var_1629 = wp::where(var_1372, var_1622, var_1359);
        var_1630 = wp::where(var_1372, var_1623, var_1360);
        var_1631 = wp::where(var_1372, var_1624, var_1361);
    }
    var_1632 = wp::where(var_821, var_1362, var_543);
    var_1633 = wp::where(var_821, var_1365, var_546);
    var_1634 = wp::where(var_821, var_1368, var_549);
    var_1635 = wp::where(var_821, var_1625, var_806);
    var_1636 = wp::where(var_821, var_1626, var_807);
    var_1637 = wp::where(var_821, var_1627, var_808);
    var_1638 = wp::where(var_821, var_1628, var_809);
    var_1639 = wp::where(var_821, var_1629, var_810);
    var_1640 = wp::where(var_821, var_1630, var_811);
    var_1641 = wp::where(var_821, var_1631, var_812);
    // sz__voxels_around__1 = side_in_order(z__voxels_around__1, near[2])                     <L 10>
    var_1644 = wp::extract(var_5, var_1643);
    var_1645 = side_in_order_0(var_1642, var_1644);
    // gz__voxels_around__1 = gap_to__voxels_around(position[2], sz__voxels_around__1, edge__voxels_around__1)       <L 11>
    var_1647 = wp::extract(var_1, var_1646);
    var_1648 = gap_to_0(var_1647, var_1645, var_9);
    // if gz__voxels_around__1 * gz__voxels_around__1 < sqradius:                             <L 12>
    var_1649 = wp::mul(var_1648, var_1648);
    var_1650 = (var_1649 < var_6);
    if (var_1650) {
        // for y__voxels_around__1 in range(3):                                               <L 13>
        // sy__voxels_around__1 = side_in_order(y__voxels_around__1, near[1])                 <L 14>
        var_1653 = wp::extract(var_5, var_1652);
        var_1654 = side_in_order_0(var_1651, var_1653);
        // gy__voxels_around__1 = gap_to__voxels_around(position[1], sy__voxels_around__1, edge__voxels_around__1)       <L 15>
        var_1656 = wp::extract(var_1, var_1655);
        var_1657 = gap_to_0(var_1656, var_1654, var_9);
        // if gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 16>
        var_1658 = wp::mul(var_1657, var_1657);
        var_1659 = wp::mul(var_1648, var_1648);
        var_1660 = wp::add(var_1658, var_1659);
        var_1661 = (var_1660 < var_6);
        if (var_1661) {
            // for x__voxels_around__1 in range(3):                                           <L 17>
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_1664 = wp::extract(var_5, var_1663);
            var_1665 = side_in_order_0(var_1662, var_1664);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_1667 = wp::extract(var_1, var_1666);
            var_1668 = gap_to_0(var_1667, var_1665, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_1669 = wp::mul(var_1668, var_1668);
            var_1670 = wp::mul(var_1657, var_1657);
            var_1671 = wp::add(var_1669, var_1670);
            var_1672 = wp::mul(var_1648, var_1648);
            var_1673 = wp::add(var_1671, var_1672);
            var_1674 = (var_1673 < var_6);
            if (var_1674) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_1676 = wp::extract(var_0, var_1675);
                var_1677 = wp::add(var_1676, var_1665);
                var_1679 = wp::extract(var_0, var_1678);
                var_1680 = wp::add(var_1679, var_1654);
                var_1682 = wp::extract(var_0, var_1681);
                var_1683 = wp::add(var_1682, var_1645);
                var_1684 = block_key_0(var_1677, var_1680, var_1683);
                var_1685 = find_position_0(var_1684, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_1687 = (var_1685 >= var_1686);
                if (var_1687) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_1688 = wp::float(var_1665);
                    var_1689 = wp::mul(var_1688, var_9);
                    var_1690 = wp::float(var_1654);
                    var_1691 = wp::mul(var_1690, var_9);
                    var_1692 = wp::float(var_1645);
                    var_1693 = wp::mul(var_1692, var_9);
                    var_1694 = wp::vec_t<3, wp::float32>(var_1689, var_1691, var_1693);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_1695 = wp::mul(var_1685, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_1696 = wp::address(var_voxel_map__counts, var_1685);
                    var_1698 = wp::load(var_1696);
                    var_1697 = wp::add(var_1695, var_1698);
                    var_1699 = wp::range(var_1695, var_1697);
                    start_for_36:;
                        if (iter_cmp(var_1699) == 0) goto end_for_36;
                        var_1700 = wp::iter_next(var_1699);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_1701 = wp::address(var_voxel_map__offsets, var_1700);
                        var_1703 = wp::load(var_1701);
                        var_1702 = wp::add(var_1703, var_1694);
                        var_1704 = wp::sub(var_1702, var_1);
                        var_1705 = widen_0(var_1704);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_1706 = wp::dot(var_1705, var_1705);
                        var_1707 = wp::float(var_1706);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_1709 = (var_1707 < var_6);
                        var_1708 = var_1709;
                        if (var_1708) {
                            var_1710 = wp::mul(var_78, var_6);
                            var_1711 = (var_1707 > var_1710);
                            var_1708 = var_1708 && var_1711;
                        }
                        if (var_1708) {
                            // a = dot(d, u)                                                  <L 29>
                            var_1712 = wp::dot(var_1705, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_1713 = wp::dot(var_1705, var_v);
                            // octant = int(0)                                                <L 31>
                            var_1715 = wp::int(var_1714);
                            // if a > float64(0.0):                                           <L 32>
                            var_1716 = 0.0;
                            var_1717 = (var_1712 > var_1716);
                            if (var_1717) {
                                // octant += 1                                                <L 33>
                                var_1719 = wp::add(var_1715, var_1718);
                            }
                            var_1720 = wp::where(var_1717, var_1719, var_1715);
                            // if b > float64(0.0):                                           <L 34>
                            var_1721 = 0.0;
                            var_1722 = (var_1713 > var_1721);
                            if (var_1722) {
                                // octant += 2                                                <L 35>
                                var_1724 = wp::add(var_1720, var_1723);
                            }
                            var_1725 = wp::where(var_1722, var_1724, var_1720);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_1726 = wp::abs(var_1712);
                            var_1727 = wp::abs(var_1713);
                            var_1728 = (var_1726 > var_1727);
                            if (var_1728) {
                                // octant += 4                                                <L 37>
                                var_1730 = wp::add(var_1725, var_1729);
                            }
                            var_1731 = wp::where(var_1728, var_1730, var_1725);
                            // octants = octants | 1 << octant                                <L 38>
                            var_1733 = wp::lshift(var_1732, var_1731);
                            var_1734 = wp::bit_or(var_8, var_1733);
                        }
                        var_1735 = wp::where(var_1708, var_1734, var_8);
                        var_1736 = wp::where(var_1708, var_1712, var_81);
                        var_1737 = wp::where(var_1708, var_1713, var_82);
                        var_1738 = wp::where(var_1708, var_1731, var_100);
                        wp::assign(var_8, var_1735);
                        wp::assign(var_73, var_1705);
                        wp::assign(var_75, var_1707);
                        wp::assign(var_81, var_1736);
                        wp::assign(var_82, var_1737);
                        wp::assign(var_100, var_1738);
                        goto start_for_36;
                    end_for_36:;
                }
                var_1739 = wp::where(var_1687, var_1694, var_1639);
                var_1740 = wp::where(var_1687, var_1695, var_1640);
                var_1741 = wp::where(var_1687, var_1700, var_1641);
            }
            var_1742 = wp::where(var_1674, var_1685, var_1638);
            var_1743 = wp::where(var_1674, var_1739, var_1639);
            var_1744 = wp::where(var_1674, var_1740, var_1640);
            var_1745 = wp::where(var_1674, var_1741, var_1641);
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_1748 = wp::extract(var_5, var_1747);
            var_1749 = side_in_order_0(var_1746, var_1748);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_1751 = wp::extract(var_1, var_1750);
            var_1752 = gap_to_0(var_1751, var_1749, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_1753 = wp::mul(var_1752, var_1752);
            var_1754 = wp::mul(var_1657, var_1657);
            var_1755 = wp::add(var_1753, var_1754);
            var_1756 = wp::mul(var_1648, var_1648);
            var_1757 = wp::add(var_1755, var_1756);
            var_1758 = (var_1757 < var_6);
            if (var_1758) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_1760 = wp::extract(var_0, var_1759);
                var_1761 = wp::add(var_1760, var_1749);
                var_1763 = wp::extract(var_0, var_1762);
                var_1764 = wp::add(var_1763, var_1654);
                var_1766 = wp::extract(var_0, var_1765);
                var_1767 = wp::add(var_1766, var_1645);
                var_1768 = block_key_0(var_1761, var_1764, var_1767);
                var_1769 = find_position_0(var_1768, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_1771 = (var_1769 >= var_1770);
                if (var_1771) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_1772 = wp::float(var_1749);
                    var_1773 = wp::mul(var_1772, var_9);
                    var_1774 = wp::float(var_1654);
                    var_1775 = wp::mul(var_1774, var_9);
                    var_1776 = wp::float(var_1645);
                    var_1777 = wp::mul(var_1776, var_9);
                    var_1778 = wp::vec_t<3, wp::float32>(var_1773, var_1775, var_1777);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_1779 = wp::mul(var_1769, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_1780 = wp::address(var_voxel_map__counts, var_1769);
                    var_1782 = wp::load(var_1780);
                    var_1781 = wp::add(var_1779, var_1782);
                    var_1783 = wp::range(var_1779, var_1781);
                    start_for_38:;
                        if (iter_cmp(var_1783) == 0) goto end_for_38;
                        var_1784 = wp::iter_next(var_1783);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_1785 = wp::address(var_voxel_map__offsets, var_1784);
                        var_1787 = wp::load(var_1785);
                        var_1786 = wp::add(var_1787, var_1778);
                        var_1788 = wp::sub(var_1786, var_1);
                        var_1789 = widen_0(var_1788);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_1790 = wp::dot(var_1789, var_1789);
                        var_1791 = wp::float(var_1790);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_1793 = (var_1791 < var_6);
                        var_1792 = var_1793;
                        if (var_1792) {
                            var_1794 = wp::mul(var_78, var_6);
                            var_1795 = (var_1791 > var_1794);
                            var_1792 = var_1792 && var_1795;
                        }
                        if (var_1792) {
                            // a = dot(d, u)                                                  <L 29>
                            var_1796 = wp::dot(var_1789, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_1797 = wp::dot(var_1789, var_v);
                            // octant = int(0)                                                <L 31>
                            var_1799 = wp::int(var_1798);
                            // if a > float64(0.0):                                           <L 32>
                            var_1800 = 0.0;
                            var_1801 = (var_1796 > var_1800);
                            if (var_1801) {
                                // octant += 1                                                <L 33>
                                var_1803 = wp::add(var_1799, var_1802);
                            }
                            var_1804 = wp::where(var_1801, var_1803, var_1799);
                            // if b > float64(0.0):                                           <L 34>
                            var_1805 = 0.0;
                            var_1806 = (var_1797 > var_1805);
                            if (var_1806) {
                                // octant += 2                                                <L 35>
                                var_1808 = wp::add(var_1804, var_1807);
                            }
                            var_1809 = wp::where(var_1806, var_1808, var_1804);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_1810 = wp::abs(var_1796);
                            var_1811 = wp::abs(var_1797);
                            var_1812 = (var_1810 > var_1811);
                            if (var_1812) {
                                // octant += 4                                                <L 37>
                                var_1814 = wp::add(var_1809, var_1813);
                            }
                            var_1815 = wp::where(var_1812, var_1814, var_1809);
                            // octants = octants | 1 << octant                                <L 38>
                            var_1817 = wp::lshift(var_1816, var_1815);
                            var_1818 = wp::bit_or(var_8, var_1817);
                        }
                        var_1819 = wp::where(var_1792, var_1818, var_8);
                        var_1820 = wp::where(var_1792, var_1796, var_81);
                        var_1821 = wp::where(var_1792, var_1797, var_82);
                        var_1822 = wp::where(var_1792, var_1815, var_100);
                        wp::assign(var_8, var_1819);
                        wp::assign(var_73, var_1789);
                        wp::assign(var_75, var_1791);
                        wp::assign(var_81, var_1820);
                        wp::assign(var_82, var_1821);
                        wp::assign(var_100, var_1822);
                        goto start_for_38;
                    end_for_38:;
                }
                var_1823 = wp::where(var_1771, var_1778, var_1743);
                var_1824 = wp::where(var_1771, var_1779, var_1744);
                var_1825 = wp::where(var_1771, var_1784, var_1745);
            }
            var_1826 = wp::where(var_1758, var_1769, var_1742);
            var_1827 = wp::where(var_1758, var_1823, var_1743);
            var_1828 = wp::where(var_1758, var_1824, var_1744);
            var_1829 = wp::where(var_1758, var_1825, var_1745);
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_1832 = wp::extract(var_5, var_1831);
            var_1833 = side_in_order_0(var_1830, var_1832);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_1835 = wp::extract(var_1, var_1834);
            var_1836 = gap_to_0(var_1835, var_1833, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_1837 = wp::mul(var_1836, var_1836);
            var_1838 = wp::mul(var_1657, var_1657);
            var_1839 = wp::add(var_1837, var_1838);
            var_1840 = wp::mul(var_1648, var_1648);
            var_1841 = wp::add(var_1839, var_1840);
            var_1842 = (var_1841 < var_6);
            if (var_1842) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_1844 = wp::extract(var_0, var_1843);
                var_1845 = wp::add(var_1844, var_1833);
                var_1847 = wp::extract(var_0, var_1846);
                var_1848 = wp::add(var_1847, var_1654);
                var_1850 = wp::extract(var_0, var_1849);
                var_1851 = wp::add(var_1850, var_1645);
                var_1852 = block_key_0(var_1845, var_1848, var_1851);
                var_1853 = find_position_0(var_1852, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_1855 = (var_1853 >= var_1854);
                if (var_1855) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_1856 = wp::float(var_1833);
                    var_1857 = wp::mul(var_1856, var_9);
                    var_1858 = wp::float(var_1654);
                    var_1859 = wp::mul(var_1858, var_9);
                    var_1860 = wp::float(var_1645);
                    var_1861 = wp::mul(var_1860, var_9);
                    var_1862 = wp::vec_t<3, wp::float32>(var_1857, var_1859, var_1861);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_1863 = wp::mul(var_1853, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_1864 = wp::address(var_voxel_map__counts, var_1853);
                    var_1866 = wp::load(var_1864);
                    var_1865 = wp::add(var_1863, var_1866);
                    var_1867 = wp::range(var_1863, var_1865);
                    start_for_40:;
                        if (iter_cmp(var_1867) == 0) goto end_for_40;
                        var_1868 = wp::iter_next(var_1867);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_1869 = wp::address(var_voxel_map__offsets, var_1868);
                        var_1871 = wp::load(var_1869);
                        var_1870 = wp::add(var_1871, var_1862);
                        var_1872 = wp::sub(var_1870, var_1);
                        var_1873 = widen_0(var_1872);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_1874 = wp::dot(var_1873, var_1873);
                        var_1875 = wp::float(var_1874);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_1877 = (var_1875 < var_6);
                        var_1876 = var_1877;
                        if (var_1876) {
                            var_1878 = wp::mul(var_78, var_6);
                            var_1879 = (var_1875 > var_1878);
                            var_1876 = var_1876 && var_1879;
                        }
                        if (var_1876) {
                            // a = dot(d, u)                                                  <L 29>
                            var_1880 = wp::dot(var_1873, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_1881 = wp::dot(var_1873, var_v);
                            // octant = int(0)                                                <L 31>
                            var_1883 = wp::int(var_1882);
                            // if a > float64(0.0):                                           <L 32>
                            var_1884 = 0.0;
                            var_1885 = (var_1880 > var_1884);
                            if (var_1885) {
                                // octant += 1                                                <L 33>
                                var_1887 = wp::add(var_1883, var_1886);
                            }
                            var_1888 = wp::where(var_1885, var_1887, var_1883);
                            // if b > float64(0.0):                                           <L 34>
                            var_1889 = 0.0;
                            var_1890 = (var_1881 > var_1889);
                            if (var_1890) {
                                // octant += 2                                                <L 35>
                                var_1892 = wp::add(var_1888, var_1891);
                            }
                            var_1893 = wp::where(var_1890, var_1892, var_1888);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_1894 = wp::abs(var_1880);
                            var_1895 = wp::abs(var_1881);
                            var_1896 = (var_1894 > var_1895);
                            if (var_1896) {
                                // octant += 4                                                <L 37>
                                var_1898 = wp::add(var_1893, var_1897);
                            }
                            var_1899 = wp::where(var_1896, var_1898, var_1893);
                            // octants = octants | 1 << octant                                <L 38>
                            var_1901 = wp::lshift(var_1900, var_1899);
                            var_1902 = wp::bit_or(var_8, var_1901);
                        }
                        var_1903 = wp::where(var_1876, var_1902, var_8);
                        var_1904 = wp::where(var_1876, var_1880, var_81);
                        var_1905 = wp::where(var_1876, var_1881, var_82);
                        var_1906 = wp::where(var_1876, var_1899, var_100);
                        wp::assign(var_8, var_1903);
                        wp::assign(var_73, var_1873);
                        wp::assign(var_75, var_1875);
                        wp::assign(var_81, var_1904);
                        wp::assign(var_82, var_1905);
                        wp::assign(var_100, var_1906);
                        goto start_for_40;
                    end_for_40:;
                }
                var_1907 = wp::where(var_1855, var_1862, var_1827);
                var_1908 = wp::where(var_1855, var_1863, var_1828);
                var_1909 = wp::where(var_1855, var_1868, var_1829);
            }
            var_1910 = wp::where(var_1842, var_1853, var_1826);
            var_1911 = wp::where(var_1842, var_1907, var_1827);
            var_1912 = wp::where(var_1842, var_1908, var_1828);
            var_1913 = wp::where(var_1842, var_1909, var_1829);
        }
        var_1914 = wp::where(var_1661, var_1830, var_1635);
        var_1915 = wp::where(var_1661, var_1833, var_1636);
        var_1916 = wp::where(var_1661, var_1836, var_1637);
        var_1917 = wp::where(var_1661, var_1910, var_1638);
        var_1918 = wp::where(var_1661, var_1911, var_1639);
        var_1919 = wp::where(var_1661, var_1912, var_1640);
        var_1920 = wp::where(var_1661, var_1913, var_1641);
        // sy__voxels_around__1 = side_in_order(y__voxels_around__1, near[1])                 <L 14>
        var_1923 = wp::extract(var_5, var_1922);
        var_1924 = side_in_order_0(var_1921, var_1923);
        // gy__voxels_around__1 = gap_to__voxels_around(position[1], sy__voxels_around__1, edge__voxels_around__1)       <L 15>
        var_1926 = wp::extract(var_1, var_1925);
        var_1927 = gap_to_0(var_1926, var_1924, var_9);
        // if gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 16>
        var_1928 = wp::mul(var_1927, var_1927);
        var_1929 = wp::mul(var_1648, var_1648);
        var_1930 = wp::add(var_1928, var_1929);
        var_1931 = (var_1930 < var_6);
        if (var_1931) {
            // for x__voxels_around__1 in range(3):                                           <L 17>
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_1934 = wp::extract(var_5, var_1933);
            var_1935 = side_in_order_0(var_1932, var_1934);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_1937 = wp::extract(var_1, var_1936);
            var_1938 = gap_to_0(var_1937, var_1935, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_1939 = wp::mul(var_1938, var_1938);
            var_1940 = wp::mul(var_1927, var_1927);
            var_1941 = wp::add(var_1939, var_1940);
            var_1942 = wp::mul(var_1648, var_1648);
            var_1943 = wp::add(var_1941, var_1942);
            var_1944 = (var_1943 < var_6);
            if (var_1944) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_1946 = wp::extract(var_0, var_1945);
                var_1947 = wp::add(var_1946, var_1935);
                var_1949 = wp::extract(var_0, var_1948);
                var_1950 = wp::add(var_1949, var_1924);
                var_1952 = wp::extract(var_0, var_1951);
                var_1953 = wp::add(var_1952, var_1645);
                var_1954 = block_key_0(var_1947, var_1950, var_1953);
                var_1955 = find_position_0(var_1954, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_1957 = (var_1955 >= var_1956);
                if (var_1957) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_1958 = wp::float(var_1935);
                    var_1959 = wp::mul(var_1958, var_9);
                    var_1960 = wp::float(var_1924);
                    var_1961 = wp::mul(var_1960, var_9);
                    var_1962 = wp::float(var_1645);
                    var_1963 = wp::mul(var_1962, var_9);
                    var_1964 = wp::vec_t<3, wp::float32>(var_1959, var_1961, var_1963);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_1965 = wp::mul(var_1955, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_1966 = wp::address(var_voxel_map__counts, var_1955);
                    var_1968 = wp::load(var_1966);
                    var_1967 = wp::add(var_1965, var_1968);
                    var_1969 = wp::range(var_1965, var_1967);
                    start_for_42:;
                        if (iter_cmp(var_1969) == 0) goto end_for_42;
                        var_1970 = wp::iter_next(var_1969);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_1971 = wp::address(var_voxel_map__offsets, var_1970);
                        var_1973 = wp::load(var_1971);
                        var_1972 = wp::add(var_1973, var_1964);
                        var_1974 = wp::sub(var_1972, var_1);
                        var_1975 = widen_0(var_1974);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_1976 = wp::dot(var_1975, var_1975);
                        var_1977 = wp::float(var_1976);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_1979 = (var_1977 < var_6);
                        var_1978 = var_1979;
                        if (var_1978) {
                            var_1980 = wp::mul(var_78, var_6);
                            var_1981 = (var_1977 > var_1980);
                            var_1978 = var_1978 && var_1981;
                        }
                        if (var_1978) {
                            // a = dot(d, u)                                                  <L 29>
                            var_1982 = wp::dot(var_1975, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_1983 = wp::dot(var_1975, var_v);
                            // octant = int(0)                                                <L 31>
                            var_1985 = wp::int(var_1984);
                            // if a > float64(0.0):                                           <L 32>
                            var_1986 = 0.0;
                            var_1987 = (var_1982 > var_1986);
                            if (var_1987) {
                                // octant += 1                                                <L 33>
                                var_1989 = wp::add(var_1985, var_1988);
                            }
                            var_1990 = wp::where(var_1987, var_1989, var_1985);
                            // if b > float64(0.0):                                           <L 34>
                            var_1991 = 0.0;
                            var_1992 = (var_1983 > var_1991);
                            if (var_1992) {
                                // octant += 2                                                <L 35>
                                var_1994 = wp::add(var_1990, var_1993);
                            }
                            var_1995 = wp::where(var_1992, var_1994, var_1990);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_1996 = wp::abs(var_1982);
                            var_1997 = wp::abs(var_1983);
                            var_1998 = (var_1996 > var_1997);
                            if (var_1998) {
                                // octant += 4                                                <L 37>
                                var_2000 = wp::add(var_1995, var_1999);
                            }
                            var_2001 = wp::where(var_1998, var_2000, var_1995);
                            // octants = octants | 1 << octant                                <L 38>
                            var_2003 = wp::lshift(var_2002, var_2001);
                            var_2004 = wp::bit_or(var_8, var_2003);
                        }
                        var_2005 = wp::where(var_1978, var_2004, var_8);
                        var_2006 = wp::where(var_1978, var_1982, var_81);
                        var_2007 = wp::where(var_1978, var_1983, var_82);
                        var_2008 = wp::where(var_1978, var_2001, var_100);
                        wp::assign(var_8, var_2005);
                        wp::assign(var_73, var_1975);
                        wp::assign(var_75, var_1977);
                        wp::assign(var_81, var_2006);
                        wp::assign(var_82, var_2007);
                        wp::assign(var_100, var_2008);
                        goto start_for_42;
                    end_for_42:;
                }
                var_2009 = wp::where(var_1957, var_1964, var_1918);
                var_2010 = wp::where(var_1957, var_1965, var_1919);
                var_2011 = wp::where(var_1957, var_1970, var_1920);
            }
            var_2012 = wp::where(var_1944, var_1955, var_1917);
            var_2013 = wp::where(var_1944, var_2009, var_1918);
            var_2014 = wp::where(var_1944, var_2010, var_1919);
            var_2015 = wp::where(var_1944, var_2011, var_1920);
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_2018 = wp::extract(var_5, var_2017);
            var_2019 = side_in_order_0(var_2016, var_2018);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_2021 = wp::extract(var_1, var_2020);
            var_2022 = gap_to_0(var_2021, var_2019, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_2023 = wp::mul(var_2022, var_2022);
            var_2024 = wp::mul(var_1927, var_1927);
            var_2025 = wp::add(var_2023, var_2024);
            var_2026 = wp::mul(var_1648, var_1648);
            var_2027 = wp::add(var_2025, var_2026);
            var_2028 = (var_2027 < var_6);
            if (var_2028) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_2030 = wp::extract(var_0, var_2029);
                var_2031 = wp::add(var_2030, var_2019);
                var_2033 = wp::extract(var_0, var_2032);
                var_2034 = wp::add(var_2033, var_1924);
                var_2036 = wp::extract(var_0, var_2035);
                var_2037 = wp::add(var_2036, var_1645);
                var_2038 = block_key_0(var_2031, var_2034, var_2037);
                var_2039 = find_position_0(var_2038, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_2041 = (var_2039 >= var_2040);
                if (var_2041) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_2042 = wp::float(var_2019);
                    var_2043 = wp::mul(var_2042, var_9);
                    var_2044 = wp::float(var_1924);
                    var_2045 = wp::mul(var_2044, var_9);
                    var_2046 = wp::float(var_1645);
                    var_2047 = wp::mul(var_2046, var_9);
                    var_2048 = wp::vec_t<3, wp::float32>(var_2043, var_2045, var_2047);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_2049 = wp::mul(var_2039, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_2050 = wp::address(var_voxel_map__counts, var_2039);
                    var_2052 = wp::load(var_2050);
                    var_2051 = wp::add(var_2049, var_2052);
                    var_2053 = wp::range(var_2049, var_2051);
                    start_for_44:;
                        if (iter_cmp(var_2053) == 0) goto end_for_44;
                        var_2054 = wp::iter_next(var_2053);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_2055 = wp::address(var_voxel_map__offsets, var_2054);
                        var_2057 = wp::load(var_2055);
                        var_2056 = wp::add(var_2057, var_2048);
                        var_2058 = wp::sub(var_2056, var_1);
                        var_2059 = widen_0(var_2058);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_2060 = wp::dot(var_2059, var_2059);
                        var_2061 = wp::float(var_2060);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_2063 = (var_2061 < var_6);
                        var_2062 = var_2063;
                        if (var_2062) {
                            var_2064 = wp::mul(var_78, var_6);
                            var_2065 = (var_2061 > var_2064);
                            var_2062 = var_2062 && var_2065;
                        }
                        if (var_2062) {
                            // a = dot(d, u)                                                  <L 29>
                            var_2066 = wp::dot(var_2059, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_2067 = wp::dot(var_2059, var_v);
                            // octant = int(0)                                                <L 31>
                            var_2069 = wp::int(var_2068);
                            // if a > float64(0.0):                                           <L 32>
                            var_2070 = 0.0;
                            var_2071 = (var_2066 > var_2070);
                            if (var_2071) {
                                // octant += 1                                                <L 33>
                                var_2073 = wp::add(var_2069, var_2072);
                            }
                            var_2074 = wp::where(var_2071, var_2073, var_2069);
                            // if b > float64(0.0):                                           <L 34>
                            var_2075 = 0.0;
                            var_2076 = (var_2067 > var_2075);
                            if (var_2076) {
                                // octant += 2                                                <L 35>
                                var_2078 = wp::add(var_2074, var_2077);
                            }
                            var_2079 = wp::where(var_2076, var_2078, var_2074);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_2080 = wp::abs(var_2066);
                            var_2081 = wp::abs(var_2067);
                            var_2082 = (var_2080 > var_2081);
                            if (var_2082) {
                                // octant += 4                                                <L 37>
                                var_2084 = wp::add(var_2079, var_2083);
                            }
                            var_2085 = wp::where(var_2082, var_2084, var_2079);
                            // octants = octants | 1 << octant                                <L 38>
                            var_2087 = wp::lshift(var_2086, var_2085);
                            var_2088 = wp::bit_or(var_8, var_2087);
                        }
                        var_2089 = wp::where(var_2062, var_2088, var_8);
                        var_2090 = wp::where(var_2062, var_2066, var_81);
                        var_2091 = wp::where(var_2062, var_2067, var_82);
                        var_2092 = wp::where(var_2062, var_2085, var_100);
                        wp::assign(var_8, var_2089);
                        wp::assign(var_73, var_2059);
                        wp::assign(var_75, var_2061);
                        wp::assign(var_81, var_2090);
                        wp::assign(var_82, var_2091);
                        wp::assign(var_100, var_2092);
                        goto start_for_44;
                    end_for_44:;
                }
                var_2093 = wp::where(var_2041, var_2048, var_2013);
                var_2094 = wp::where(var_2041, var_2049, var_2014);
                var_2095 = wp::where(var_2041, var_2054, var_2015);
            }
            var_2096 = wp::where(var_2028, var_2039, var_2012);
            var_2097 = wp::where(var_2028, var_2093, var_2013);
            var_2098 = wp::where(var_2028, var_2094, var_2014);
            var_2099 = wp::where(var_2028, var_2095, var_2015);
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_2102 = wp::extract(var_5, var_2101);
            var_2103 = side_in_order_0(var_2100, var_2102);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_2105 = wp::extract(var_1, var_2104);
            var_2106 = gap_to_0(var_2105, var_2103, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_2107 = wp::mul(var_2106, var_2106);
            var_2108 = wp::mul(var_1927, var_1927);
            var_2109 = wp::add(var_2107, var_2108);
            var_2110 = wp::mul(var_1648, var_1648);
            var_2111 = wp::add(var_2109, var_2110);
            var_2112 = (var_2111 < var_6);
            if (var_2112) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_2114 = wp::extract(var_0, var_2113);
                var_2115 = wp::add(var_2114, var_2103);
                var_2117 = wp::extract(var_0, var_2116);
                var_2118 = wp::add(var_2117, var_1924);
                var_2120 = wp::extract(var_0, var_2119);
                var_2121 = wp::add(var_2120, var_1645);
                var_2122 = block_key_0(var_2115, var_2118, var_2121);
                var_2123 = find_position_0(var_2122, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_2125 = (var_2123 >= var_2124);
                if (var_2125) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_2126 = wp::float(var_2103);
                    var_2127 = wp::mul(var_2126, var_9);
                    var_2128 = wp::float(var_1924);
                    var_2129 = wp::mul(var_2128, var_9);
                    var_2130 = wp::float(var_1645);
                    var_2131 = wp::mul(var_2130, var_9);
                    var_2132 = wp::vec_t<3, wp::float32>(var_2127, var_2129, var_2131);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_2133 = wp::mul(var_2123, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_2134 = wp::address(var_voxel_map__counts, var_2123);
                    var_2136 = wp::load(var_2134);
                    var_2135 = wp::add(var_2133, var_2136);
                    var_2137 = wp::range(var_2133, var_2135);
                    start_for_46:;
                        if (iter_cmp(var_2137) == 0) goto end_for_46;
                        var_2138 = wp::iter_next(var_2137);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_2139 = wp::address(var_voxel_map__offsets, var_2138);
                        var_2141 = wp::load(var_2139);
                        var_2140 = wp::add(var_2141, var_2132);
                        var_2142 = wp::sub(var_2140, var_1);
                        var_2143 = widen_0(var_2142);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_2144 = wp::dot(var_2143, var_2143);
                        var_2145 = wp::float(var_2144);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_2147 = (var_2145 < var_6);
                        var_2146 = var_2147;
                        if (var_2146) {
                            var_2148 = wp::mul(var_78, var_6);
                            var_2149 = (var_2145 > var_2148);
                            var_2146 = var_2146 && var_2149;
                        }
                        if (var_2146) {
                            // a = dot(d, u)                                                  <L 29>
                            var_2150 = wp::dot(var_2143, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_2151 = wp::dot(var_2143, var_v);
                            // octant = int(0)                                                <L 31>
                            var_2153 = wp::int(var_2152);
                            // if a > float64(0.0):                                           <L 32>
                            var_2154 = 0.0;
                            var_2155 = (var_2150 > var_2154);
                            if (var_2155) {
                                // octant += 1                                                <L 33>
                                var_2157 = wp::add(var_2153, var_2156);
                            }
                            var_2158 = wp::where(var_2155, var_2157, var_2153);
                            // if b > float64(0.0):                                           <L 34>
                            var_2159 = 0.0;
                            var_2160 = (var_2151 > var_2159);
                            if (var_2160) {
                                // octant += 2                                                <L 35>
                                var_2162 = wp::add(var_2158, var_2161);
                            }
                            var_2163 = wp::where(var_2160, var_2162, var_2158);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_2164 = wp::abs(var_2150);
                            var_2165 = wp::abs(var_2151);
                            var_2166 = (var_2164 > var_2165);
                            if (var_2166) {
                                // octant += 4                                                <L 37>
                                var_2168 = wp::add(var_2163, var_2167);
                            }
                            var_2169 = wp::where(var_2166, var_2168, var_2163);
                            // octants = octants | 1 << octant                                <L 38>
                            var_2171 = wp::lshift(var_2170, var_2169);
                            var_2172 = wp::bit_or(var_8, var_2171);
                        }
                        var_2173 = wp::where(var_2146, var_2172, var_8);
                        var_2174 = wp::where(var_2146, var_2150, var_81);
                        var_2175 = wp::where(var_2146, var_2151, var_82);
                        var_2176 = wp::where(var_2146, var_2169, var_100);
                        wp::assign(var_8, var_2173);
                        wp::assign(var_73, var_2143);
                        wp::assign(var_75, var_2145);
                        wp::assign(var_81, var_2174);
                        wp::assign(var_82, var_2175);
                        wp::assign(var_100, var_2176);
                        goto start_for_46;
                    end_for_46:;
                }
                var_2177 = wp::where(var_2125, var_2132, var_2097);
                var_2178 = wp::where(var_2125, var_2133, var_2098);
                var_2179 = wp::where(var_2125, var_2138, var_2099);
            }
            var_2180 = wp::where(var_2112, var_2123, var_2096);
            var_2181 = wp::where(var_2112, var_2177, var_2097);
            var_2182 = wp::where(var_2112, var_2178, var_2098);
            var_2183 = wp::where(var_2112, var_2179, var_2099);
        }
        var_2184 = wp::where(var_1931, var_2100, var_1914);
        var_2185 = wp::where(var_1931, var_2103, var_1915);
        var_2186 = wp::where(var_1931, var_2106, var_1916);
        var_2187 = wp::where(var_1931, var_2180, var_1917);
        var_2188 = wp::where(var_1931, var_2181, var_1918);
        var_2189 = wp::where(var_1931, var_2182, var_1919);
        var_2190 = wp::where(var_1931, var_2183, var_1920);
        // sy__voxels_around__1 = side_in_order(y__voxels_around__1, near[1])                 <L 14>
        var_2193 = wp::extract(var_5, var_2192);
        var_2194 = side_in_order_0(var_2191, var_2193);
        // gy__voxels_around__1 = gap_to__voxels_around(position[1], sy__voxels_around__1, edge__voxels_around__1)       <L 15>
        var_2196 = wp::extract(var_1, var_2195);
        var_2197 = gap_to_0(var_2196, var_2194, var_9);
        // if gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 16>
        var_2198 = wp::mul(var_2197, var_2197);
        var_2199 = wp::mul(var_1648, var_1648);
        var_2200 = wp::add(var_2198, var_2199);
        var_2201 = (var_2200 < var_6);
        if (var_2201) {
            // for x__voxels_around__1 in range(3):                                           <L 17>
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_2204 = wp::extract(var_5, var_2203);
            var_2205 = side_in_order_0(var_2202, var_2204);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_2207 = wp::extract(var_1, var_2206);
            var_2208 = gap_to_0(var_2207, var_2205, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_2209 = wp::mul(var_2208, var_2208);
            var_2210 = wp::mul(var_2197, var_2197);
            var_2211 = wp::add(var_2209, var_2210);
            var_2212 = wp::mul(var_1648, var_1648);
            var_2213 = wp::add(var_2211, var_2212);
            var_2214 = (var_2213 < var_6);
            if (var_2214) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_2216 = wp::extract(var_0, var_2215);
                var_2217 = wp::add(var_2216, var_2205);
                var_2219 = wp::extract(var_0, var_2218);
                var_2220 = wp::add(var_2219, var_2194);
                var_2222 = wp::extract(var_0, var_2221);
                var_2223 = wp::add(var_2222, var_1645);
                var_2224 = block_key_0(var_2217, var_2220, var_2223);
                var_2225 = find_position_0(var_2224, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_2227 = (var_2225 >= var_2226);
                if (var_2227) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_2228 = wp::float(var_2205);
                    var_2229 = wp::mul(var_2228, var_9);
                    var_2230 = wp::float(var_2194);
                    var_2231 = wp::mul(var_2230, var_9);
                    var_2232 = wp::float(var_1645);
                    var_2233 = wp::mul(var_2232, var_9);
                    var_2234 = wp::vec_t<3, wp::float32>(var_2229, var_2231, var_2233);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_2235 = wp::mul(var_2225, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_2236 = wp::address(var_voxel_map__counts, var_2225);
                    var_2238 = wp::load(var_2236);
                    var_2237 = wp::add(var_2235, var_2238);
                    var_2239 = wp::range(var_2235, var_2237);
                    start_for_48:;
                        if (iter_cmp(var_2239) == 0) goto end_for_48;
                        var_2240 = wp::iter_next(var_2239);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_2241 = wp::address(var_voxel_map__offsets, var_2240);
                        var_2243 = wp::load(var_2241);
                        var_2242 = wp::add(var_2243, var_2234);
                        var_2244 = wp::sub(var_2242, var_1);
                        var_2245 = widen_0(var_2244);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_2246 = wp::dot(var_2245, var_2245);
                        var_2247 = wp::float(var_2246);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_2249 = (var_2247 < var_6);
                        var_2248 = var_2249;
                        if (var_2248) {
                            var_2250 = wp::mul(var_78, var_6);
                            var_2251 = (var_2247 > var_2250);
                            var_2248 = var_2248 && var_2251;
                        }
                        if (var_2248) {
                            // a = dot(d, u)                                                  <L 29>
                            var_2252 = wp::dot(var_2245, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_2253 = wp::dot(var_2245, var_v);
                            // octant = int(0)                                                <L 31>
                            var_2255 = wp::int(var_2254);
                            // if a > float64(0.0):                                           <L 32>
                            var_2256 = 0.0;
                            var_2257 = (var_2252 > var_2256);
                            if (var_2257) {
                                // octant += 1                                                <L 33>
                                var_2259 = wp::add(var_2255, var_2258);
                            }
                            var_2260 = wp::where(var_2257, var_2259, var_2255);
                            // if b > float64(0.0):                                           <L 34>
                            var_2261 = 0.0;
                            var_2262 = (var_2253 > var_2261);
                            if (var_2262) {
                                // octant += 2                                                <L 35>
                                var_2264 = wp::add(var_2260, var_2263);
                            }
                            var_2265 = wp::where(var_2262, var_2264, var_2260);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_2266 = wp::abs(var_2252);
                            var_2267 = wp::abs(var_2253);
                            var_2268 = (var_2266 > var_2267);
                            if (var_2268) {
                                // octant += 4                                                <L 37>
                                var_2270 = wp::add(var_2265, var_2269);
                            }
                            var_2271 = wp::where(var_2268, var_2270, var_2265);
                            // octants = octants | 1 << octant                                <L 38>
                            var_2273 = wp::lshift(var_2272, var_2271);
                            var_2274 = wp::bit_or(var_8, var_2273);
                        }
                        var_2275 = wp::where(var_2248, var_2274, var_8);
                        var_2276 = wp::where(var_2248, var_2252, var_81);
                        var_2277 = wp::where(var_2248, var_2253, var_82);
                        var_2278 = wp::where(var_2248, var_2271, var_100);
                        wp::assign(var_8, var_2275);
                        wp::assign(var_73, var_2245);
                        wp::assign(var_75, var_2247);
                        wp::assign(var_81, var_2276);
                        wp::assign(var_82, var_2277);
                        wp::assign(var_100, var_2278);
                        goto start_for_48;
                    end_for_48:;
                }
                var_2279 = wp::where(var_2227, var_2234, var_2188);
                var_2280 = wp::where(var_2227, var_2235, var_2189);
                var_2281 = wp::where(var_2227, var_2240, var_2190);
            }
            var_2282 = wp::where(var_2214, var_2225, var_2187);
            var_2283 = wp::where(var_2214, var_2279, var_2188);
            var_2284 = wp::where(var_2214, var_2280, var_2189);
            var_2285 = wp::where(var_2214, var_2281, var_2190);
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_2288 = wp::extract(var_5, var_2287);
            var_2289 = side_in_order_0(var_2286, var_2288);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_2291 = wp::extract(var_1, var_2290);
            var_2292 = gap_to_0(var_2291, var_2289, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_2293 = wp::mul(var_2292, var_2292);
            var_2294 = wp::mul(var_2197, var_2197);
            var_2295 = wp::add(var_2293, var_2294);
            var_2296 = wp::mul(var_1648, var_1648);
            var_2297 = wp::add(var_2295, var_2296);
            var_2298 = (var_2297 < var_6);
            if (var_2298) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_2300 = wp::extract(var_0, var_2299);
                var_2301 = wp::add(var_2300, var_2289);
                var_2303 = wp::extract(var_0, var_2302);
                var_2304 = wp::add(var_2303, var_2194);
                var_2306 = wp::extract(var_0, var_2305);
                var_2307 = wp::add(var_2306, var_1645);
                var_2308 = block_key_0(var_2301, var_2304, var_2307);
                var_2309 = find_position_0(var_2308, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_2311 = (var_2309 >= var_2310);
                if (var_2311) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_2312 = wp::float(var_2289);
                    var_2313 = wp::mul(var_2312, var_9);
                    var_2314 = wp::float(var_2194);
                    var_2315 = wp::mul(var_2314, var_9);
                    var_2316 = wp::float(var_1645);
                    var_2317 = wp::mul(var_2316, var_9);
                    var_2318 = wp::vec_t<3, wp::float32>(var_2313, var_2315, var_2317);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_2319 = wp::mul(var_2309, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_2320 = wp::address(var_voxel_map__counts, var_2309);
                    var_2322 = wp::load(var_2320);
                    var_2321 = wp::add(var_2319, var_2322);
                    var_2323 = wp::range(var_2319, var_2321);
                    start_for_50:;
                        if (iter_cmp(var_2323) == 0) goto end_for_50;
                        var_2324 = wp::iter_next(var_2323);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_2325 = wp::address(var_voxel_map__offsets, var_2324);
                        var_2327 = wp::load(var_2325);
                        var_2326 = wp::add(var_2327, var_2318);
                        var_2328 = wp::sub(var_2326, var_1);
                        var_2329 = widen_0(var_2328);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_2330 = wp::dot(var_2329, var_2329);
                        var_2331 = wp::float(var_2330);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_2333 = (var_2331 < var_6);
                        var_2332 = var_2333;
                        if (var_2332) {
                            var_2334 = wp::mul(var_78, var_6);
                            var_2335 = (var_2331 > var_2334);
                            var_2332 = var_2332 && var_2335;
                        }
                        if (var_2332) {
                            // a = dot(d, u)                                                  <L 29>
                            var_2336 = wp::dot(var_2329, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_2337 = wp::dot(var_2329, var_v);
                            // octant = int(0)                                                <L 31>
                            var_2339 = wp::int(var_2338);
                            // if a > float64(0.0):                                           <L 32>
                            var_2340 = 0.0;
                            var_2341 = (var_2336 > var_2340);
                            if (var_2341) {
                                // octant += 1                                                <L 33>
                                var_2343 = wp::add(var_2339, var_2342);
                            }
                            var_2344 = wp::where(var_2341, var_2343, var_2339);
                            // if b > float64(0.0):                                           <L 34>
                            var_2345 = 0.0;
                            var_2346 = (var_2337 > var_2345);
                            if (var_2346) {
                                // octant += 2                                                <L 35>
                                var_2348 = wp::add(var_2344, var_2347);
                            }
                            var_2349 = wp::where(var_2346, var_2348, var_2344);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_2350 = wp::abs(var_2336);
                            var_2351 = wp::abs(var_2337);
                            var_2352 = (var_2350 > var_2351);
                            if (var_2352) {
                                // octant += 4                                                <L 37>
                                var_2354 = wp::add(var_2349, var_2353);
                            }
                            var_2355 = wp::where(var_2352, var_2354, var_2349);
                            // octants = octants | 1 << octant                                <L 38>
                            var_2357 = wp::lshift(var_2356, var_2355);
                            var_2358 = wp::bit_or(var_8, var_2357);
                        }
                        var_2359 = wp::where(var_2332, var_2358, var_8);
                        var_2360 = wp::where(var_2332, var_2336, var_81);
                        var_2361 = wp::where(var_2332, var_2337, var_82);
                        var_2362 = wp::where(var_2332, var_2355, var_100);
                        wp::assign(var_8, var_2359);
                        wp::assign(var_73, var_2329);
                        wp::assign(var_75, var_2331);
                        wp::assign(var_81, var_2360);
                        wp::assign(var_82, var_2361);
                        wp::assign(var_100, var_2362);
                        goto start_for_50;
                    end_for_50:;
                }
                var_2363 = wp::where(var_2311, var_2318, var_2283);
                var_2364 = wp::where(var_2311, var_2319, var_2284);
                var_2365 = wp::where(var_2311, var_2324, var_2285);
            }
            var_2366 = wp::where(var_2298, var_2309, var_2282);
            var_2367 = wp::where(var_2298, var_2363, var_2283);
            var_2368 = wp::where(var_2298, var_2364, var_2284);
            var_2369 = wp::where(var_2298, var_2365, var_2285);
            // sx__voxels_around__1 = side_in_order(x__voxels_around__1, near[0])             <L 18>
            var_2372 = wp::extract(var_5, var_2371);
            var_2373 = side_in_order_0(var_2370, var_2372);
            // gx__voxels_around__1 = gap_to__voxels_around(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 19>
            var_2375 = wp::extract(var_1, var_2374);
            var_2376 = gap_to_0(var_2375, var_2373, var_9);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 20>
            var_2377 = wp::mul(var_2376, var_2376);
            var_2378 = wp::mul(var_2197, var_2197);
            var_2379 = wp::add(var_2377, var_2378);
            var_2380 = wp::mul(var_1648, var_1648);
            var_2381 = wp::add(var_2379, var_2380);
            var_2382 = (var_2381 < var_6);
            if (var_2382) {
                // voxel = find_position__voxels_around(block_key__voxels_around(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 21>
                var_2384 = wp::extract(var_0, var_2383);
                var_2385 = wp::add(var_2384, var_2373);
                var_2387 = wp::extract(var_0, var_2386);
                var_2388 = wp::add(var_2387, var_2194);
                var_2390 = wp::extract(var_0, var_2389);
                var_2391 = wp::add(var_2390, var_1645);
                var_2392 = block_key_0(var_2385, var_2388, var_2391);
                var_2393 = find_position_0(var_2392, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 22>
                var_2395 = (var_2393 >= var_2394);
                if (var_2395) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 23>
                    var_2396 = wp::float(var_2373);
                    var_2397 = wp::mul(var_2396, var_9);
                    var_2398 = wp::float(var_2194);
                    var_2399 = wp::mul(var_2398, var_9);
                    var_2400 = wp::float(var_1645);
                    var_2401 = wp::mul(var_2400, var_9);
                    var_2402 = wp::vec_t<3, wp::float32>(var_2397, var_2399, var_2401);
                    // first = voxel * voxel_map__room                                        <L 24>
                    var_2403 = wp::mul(var_2393, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 25>
                    var_2404 = wp::address(var_voxel_map__counts, var_2393);
                    var_2406 = wp::load(var_2404);
                    var_2405 = wp::add(var_2403, var_2406);
                    var_2407 = wp::range(var_2403, var_2405);
                    start_for_52:;
                        if (iter_cmp(var_2407) == 0) goto end_for_52;
                        var_2408 = wp::iter_next(var_2407);
                        // d = widen(voxel_map__offsets[slot] + shift - position)             <L 26>
                        var_2409 = wp::address(var_voxel_map__offsets, var_2408);
                        var_2411 = wp::load(var_2409);
                        var_2410 = wp::add(var_2411, var_2402);
                        var_2412 = wp::sub(var_2410, var_1);
                        var_2413 = widen_0(var_2412);
                        // sqdist = float(dot(d, d))                                          <L 27>
                        var_2414 = wp::dot(var_2413, var_2413);
                        var_2415 = wp::float(var_2414);
                        // if sqdist < sqradius and sqdist > INNER * sqradius:                <L 28>
                        var_2417 = (var_2415 < var_6);
                        var_2416 = var_2417;
                        if (var_2416) {
                            var_2418 = wp::mul(var_78, var_6);
                            var_2419 = (var_2415 > var_2418);
                            var_2416 = var_2416 && var_2419;
                        }
                        if (var_2416) {
                            // a = dot(d, u)                                                  <L 29>
                            var_2420 = wp::dot(var_2413, var_u);
                            // b = dot(d, v)                                                  <L 30>
                            var_2421 = wp::dot(var_2413, var_v);
                            // octant = int(0)                                                <L 31>
                            var_2423 = wp::int(var_2422);
                            // if a > float64(0.0):                                           <L 32>
                            var_2424 = 0.0;
                            var_2425 = (var_2420 > var_2424);
                            if (var_2425) {
                                // octant += 1                                                <L 33>
                                var_2427 = wp::add(var_2423, var_2426);
                            }
                            var_2428 = wp::where(var_2425, var_2427, var_2423);
                            // if b > float64(0.0):                                           <L 34>
                            var_2429 = 0.0;
                            var_2430 = (var_2421 > var_2429);
                            if (var_2430) {
                                // octant += 2                                                <L 35>
                                var_2432 = wp::add(var_2428, var_2431);
                            }
                            var_2433 = wp::where(var_2430, var_2432, var_2428);
                            // if abs(a) > abs(b):                                            <L 36>
                            var_2434 = wp::abs(var_2420);
                            var_2435 = wp::abs(var_2421);
                            var_2436 = (var_2434 > var_2435);
                            if (var_2436) {
                                // octant += 4                                                <L 37>
                                var_2438 = wp::add(var_2433, var_2437);
                            }
                            var_2439 = wp::where(var_2436, var_2438, var_2433);
                            // octants = octants | 1 << octant                                <L 38>
                            var_2441 = wp::lshift(var_2440, var_2439);
                            var_2442 = wp::bit_or(var_8, var_2441);
                        }
                        var_2443 = wp::where(var_2416, var_2442, var_8);
                        var_2444 = wp::where(var_2416, var_2420, var_81);
                        var_2445 = wp::where(var_2416, var_2421, var_82);
                        var_2446 = wp::where(var_2416, var_2439, var_100);
                        wp::assign(var_8, var_2443);
                        wp::assign(var_73, var_2413);
                        wp::assign(var_75, var_2415);
                        wp::assign(var_81, var_2444);
                        wp::assign(var_82, var_2445);
                        wp::assign(var_100, var_2446);
                        goto start_for_52;
                    end_for_52:;
                }
                var_2447 = wp::where(var_2395, var_2402, var_2367);
                var_2448 = wp::where(var_2395, var_2403, var_2368);
                var_2449 = wp::where(var_2395, var_2408, var_2369);
            }
            var_2450 = wp::where(var_2382, var_2393, var_2366);
            var_2451 = wp::where(var_2382, var_2447, var_2367);
            var_2452 = wp::where(var_2382, var_2448, var_2368);
            var_2453 = wp::where(var_2382, var_2449, var_2369);
        }
        var_2454 = wp::where(var_2201, var_2370, var_2184);
        var_2455 = wp::where(var_2201, var_2373, var_2185);
        var_2456 = wp::where(var_2201, var_2376, var_2186);
        var_2457 = wp::where(var_2201, var_2450, var_2187);
        var_2458 = wp::where(var_2201, var_2451, var_2188);
        var_2459 = wp::where(var_2201, var_2452, var_2189);
        var_2460 = wp::where(var_2201, var_2453, var_2190);
    }
    var_2461 = wp::where(var_1650, var_2191, var_1632);
    var_2462 = wp::where(var_1650, var_2194, var_1633);
    var_2463 = wp::where(var_1650, var_2197, var_1634);
    var_2464 = wp::where(var_1650, var_2454, var_1635);
    var_2465 = wp::where(var_1650, var_2455, var_1636);
    var_2466 = wp::where(var_1650, var_2456, var_1637);
    var_2467 = wp::where(var_1650, var_2457, var_1638);
    var_2468 = wp::where(var_1650, var_2458, var_1639);
    var_2469 = wp::where(var_1650, var_2459, var_1640);
    var_2470 = wp::where(var_1650, var_2460, var_1641);
    // count = int(0)                                                                         <L 39>
    var_2472 = wp::int(var_2471);
    // for k in range(8):                                                                     <L 40>
    // count += octants >> k & 1                                                              <L 41>
    var_2474 = wp::rshift(var_8, var_2473);
    var_2476 = wp::bit_and(var_2474, var_2475);
    var_2477 = wp::add(var_2472, var_2476);
    var_2479 = wp::rshift(var_8, var_2478);
    var_2481 = wp::bit_and(var_2479, var_2480);
    var_2482 = wp::add(var_2477, var_2481);
    var_2484 = wp::rshift(var_8, var_2483);
    var_2486 = wp::bit_and(var_2484, var_2485);
    var_2487 = wp::add(var_2482, var_2486);
    var_2489 = wp::rshift(var_8, var_2488);
    var_2491 = wp::bit_and(var_2489, var_2490);
    var_2492 = wp::add(var_2487, var_2491);
    var_2494 = wp::rshift(var_8, var_2493);
    var_2496 = wp::bit_and(var_2494, var_2495);
    var_2497 = wp::add(var_2492, var_2496);
    var_2499 = wp::rshift(var_8, var_2498);
    var_2501 = wp::bit_and(var_2499, var_2500);
    var_2502 = wp::add(var_2497, var_2501);
    var_2504 = wp::rshift(var_8, var_2503);
    var_2506 = wp::bit_and(var_2504, var_2505);
    var_2507 = wp::add(var_2502, var_2506);
    var_2509 = wp::rshift(var_8, var_2508);
    var_2511 = wp::bit_and(var_2509, var_2510);
    var_2512 = wp::add(var_2507, var_2511);
    // return count                                                                           <L 42>
    return var_2512;
}


// <pointloom.kernels.odometry.surface_patches.patch_at>:1
static CUDA_CALLABLE wp::vec_t<8, wp::float64> patch_at_0(
    wp::vec_t<3, wp::float64> var_center,
    wp::vec_t<3, wp::float64> var_ray,
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
    wp::float64 var_0;
    wp::vec_t<8, wp::float64> var_1;
    const wp::int32 var_2 = 1;
    wp::vec_t<10, wp::float32> var_3;
    const wp::int32 var_4 = 0;
    wp::float32 var_5;
    const wp::float32 var_6 = 6.0;
    bool var_7;
    const wp::int32 var_8 = 0;
    wp::float32 var_9;
    wp::float64 var_10;
    wp::vec_t<3, wp::float64> var_11;
    wp::mat_t<3, 3, wp::float64> var_12;
    wp::vec_t<3, wp::float64> var_13;
    bool var_14;
    const wp::int32 var_15 = 1;
    wp::float64 var_16;
    wp::float64 var_17;
    const wp::int32 var_18 = 2;
    wp::float64 var_19;
    wp::float64 var_20;
    bool var_21;
    const wp::int32 var_22 = 0;
    wp::float64 var_23;
    wp::float64 var_24;
    const wp::int32 var_25 = 1;
    wp::float64 var_26;
    wp::float64 var_27;
    bool var_28;
    bool var_29;
    const wp::int32 var_30 = 0;
    wp::float64 var_31;
    wp::float64 var_32;
    wp::float64 var_33;
    const wp::int32 var_34 = 1;
    wp::float64 var_35;
    wp::float64 var_36;
    bool var_37;
    wp::vec_t<3, wp::float64> var_38;
    wp::float64 var_39;
    wp::float64 var_40;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    bool var_44;
    wp::vec_t<3, wp::float64> var_45;
    wp::vec_t<3, wp::float64> var_46;
    wp::int32 var_47;
    const wp::int32 var_48 = 5;
    bool var_49;
    const wp::int32 var_50 = 0;
    wp::float64 var_51;
    const wp::int32 var_52 = 1;
    wp::float64 var_53;
    const wp::int32 var_54 = 2;
    wp::float64 var_55;
    const wp::int32 var_56 = 0;
    wp::float64 var_57;
    const wp::int32 var_58 = 1;
    wp::float64 var_59;
    const wp::int32 var_60 = 2;
    wp::float64 var_61;
    const wp::int32 var_62 = 1;
    wp::float64 var_63;
    wp::vec_t<8, wp::float64> var_64;
    wp::vec_t<8, wp::float64> var_65;
    wp::vec_t<8, wp::float64> var_66;
    wp::vec_t<8, wp::float64> var_67;
    wp::vec_t<8, wp::float64> var_68;
    //---------
    // forward
    // def patch_at(center, ray, radius, voxel_map__voxel_size, voxel_map__room, voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask, voxel_map__counts, voxel_map__offsets):       <L 1>
    // result = patch(float64(0.0))                                                           <L 3>
    var_0 = 0.0;
    var_1 = wp::vec_t<8, wp::float64>(var_0);
    // m = moments_in_map(center, radius, 1, voxel_map__voxel_size, voxel_map__room, voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask, voxel_map__counts, voxel_map__offsets)       <L 4>
    var_3 = moments_in_map_0(var_center, var_radius, var_2, var_voxel_map__voxel_size, var_voxel_map__room, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask, var_voxel_map__counts, var_voxel_map__offsets);
    // if m[0] >= MIN_POINTS:                                                                 <L 5>
    var_5 = wp::extract(var_3, var_4);
    var_7 = (var_5 >= var_6);
    if (var_7) {
        // n = float64(m[0])                                                                  <L 6>
        var_9 = wp::extract(var_3, var_8);
        var_10 = wp::float64(var_9);
        // mean = mean_of(m)                                                                  <L 7>
        var_11 = mean_of_0(var_3);
        // C = covariance_of(m, mean)                                                         <L 8>
        var_12 = covariance_of_1(var_3, var_11);
        // spread = eigenvalues(C)                                                            <L 9>
        var_13 = eigenvalues_0(var_12);
        // is_flat = spread[1] > float64(FLAT) * spread[2] and spread[0] < float64(FLAT) * spread[1]       <L 10>
        var_16 = wp::extract(var_13, var_15);
        var_17 = 0.1;
        var_19 = wp::extract(var_13, var_18);
        var_20 = wp::mul(var_17, var_19);
        var_21 = (var_16 > var_20);
        var_14 = var_21;
        if (var_14) {
            var_23 = wp::extract(var_13, var_22);
            var_24 = wp::float64(var_17);
            var_26 = wp::extract(var_13, var_25);
            var_27 = wp::mul(var_24, var_26);
            var_28 = (var_23 < var_27);
            var_14 = var_14 && var_28;
        }
        // if is_flat and spread[0] < float64(SURE) * n * spread[1]:                          <L 11>
        var_29 = var_14;
        if (var_29) {
            var_31 = wp::extract(var_13, var_30);
            var_32 = 0.005;
            var_33 = wp::mul(var_32, var_10);
            var_35 = wp::extract(var_13, var_34);
            var_36 = wp::mul(var_33, var_35);
            var_37 = (var_31 < var_36);
            var_29 = var_29 && var_37;
        }
        if (var_29) {
            // normal = smallest_eigenvector(C)                                               <L 12>
            var_38 = smallest_eigenvector_0(var_12);
            // incidence = dot(normal, ray)                                                   <L 13>
            var_39 = wp::dot(var_38, var_ray);
            // if incidence * incidence > float64(GRAZING) * dot(ray, ray):                   <L 14>
            var_40 = wp::mul(var_39, var_39);
            var_41 = 0.01;
            var_42 = wp::dot(var_ray, var_ray);
            var_43 = wp::mul(var_41, var_42);
            var_44 = (var_40 > var_43);
            if (var_44) {
                // u = orthogonal_direction(normal)                                           <L 15>
                var_45 = orthogonal_direction_0(var_38);
                // if sectors_in_map(center, radius, u, cross(normal, u), voxel_map__voxel_size, voxel_map__room, voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask, voxel_map__counts, voxel_map__offsets) >= MIN_SECTORS:       <L 16>
                var_46 = wp::cross(var_38, var_45);
                var_47 = sectors_in_map_0(var_center, var_radius, var_45, var_46, var_voxel_map__voxel_size, var_voxel_map__room, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask, var_voxel_map__counts, var_voxel_map__offsets);
                var_49 = (var_47 >= var_48);
                if (var_49) {
                    // result = patch(normal[0], normal[1], normal[2], mean[0], mean[1], mean[2], n, spread[1])       <L 17>
                    var_51 = wp::extract(var_38, var_50);
                    var_53 = wp::extract(var_38, var_52);
                    var_55 = wp::extract(var_38, var_54);
                    var_57 = wp::extract(var_11, var_56);
                    var_59 = wp::extract(var_11, var_58);
                    var_61 = wp::extract(var_11, var_60);
                    var_63 = wp::extract(var_13, var_62);
                    var_64 = wp::vec_t<8, wp::float64>({var_51, var_53, var_55, var_57, var_59, var_61, var_10, var_63});
                }
                var_65 = wp::where(var_49, var_64, var_1);
            }
            var_66 = wp::where(var_44, var_65, var_1);
        }
        var_67 = wp::where(var_29, var_66, var_1);
    }
    var_68 = wp::where(var_7, var_67, var_1);
    // return result                                                                          <L 18>
    return var_68;
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


// <pointloom.kernels.odometry.surface_patches.sectors_in_map>:1
static CUDA_CALLABLE void adj_sectors_in_map_0(
    wp::vec_t<3, wp::float64> var_center,
    wp::float32 var_radius,
    wp::vec_t<3, wp::float64> var_u,
    wp::vec_t<3, wp::float64> var_v,
    wp::float64 var_voxel_map__voxel_size,
    wp::int32 var_voxel_map__room,
    wp::array_t<wp::int64> var_voxel_map__table__keys,
    wp::array_t<wp::int32> var_voxel_map__table__positions,
    wp::int64 var_voxel_map__table__mask,
    wp::array_t<wp::int32> var_voxel_map__counts,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voxel_map__offsets,
    wp::vec_t<3, wp::float64> & adj_center,
    wp::float32 & adj_radius,
    wp::vec_t<3, wp::float64> & adj_u,
    wp::vec_t<3, wp::float64> & adj_v,
    wp::float64 & adj_voxel_map__voxel_size,
    wp::int32 & adj_voxel_map__room,
    wp::array_t<wp::int64> & adj_voxel_map__table__keys,
    wp::array_t<wp::int32> & adj_voxel_map__table__positions,
    wp::int64 & adj_voxel_map__table__mask,
    wp::array_t<wp::int32> & adj_voxel_map__counts,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_voxel_map__offsets,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.odometry.surface_patches.patch_at>:1
static CUDA_CALLABLE void adj_patch_at_0(
    wp::vec_t<3, wp::float64> var_center,
    wp::vec_t<3, wp::float64> var_ray,
    wp::float32 var_radius,
    wp::float64 var_voxel_map__voxel_size,
    wp::int32 var_voxel_map__room,
    wp::array_t<wp::int64> var_voxel_map__table__keys,
    wp::array_t<wp::int32> var_voxel_map__table__positions,
    wp::int64 var_voxel_map__table__mask,
    wp::array_t<wp::int32> var_voxel_map__counts,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voxel_map__offsets,
    wp::vec_t<3, wp::float64> & adj_center,
    wp::vec_t<3, wp::float64> & adj_ray,
    wp::float32 & adj_radius,
    wp::float64 & adj_voxel_map__voxel_size,
    wp::int32 & adj_voxel_map__room,
    wp::array_t<wp::int64> & adj_voxel_map__table__keys,
    wp::array_t<wp::int32> & adj_voxel_map__table__positions,
    wp::int64 & adj_voxel_map__table__mask,
    wp::array_t<wp::int32> & adj_voxel_map__counts,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_voxel_map__offsets,
    wp::vec_t<8, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void find_patches_kernel_c5104f44_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::int32 var_step,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_poses,
    wp::int32 var_run,
    wp::float32 var_limit,
    wp::float32 var_radius,
    wp::float64 var_voxel_map__voxel_size,
    wp::int32 var_voxel_map__room,
    wp::array_t<wp::int64> var_voxel_map__table__keys,
    wp::array_t<wp::int32> var_voxel_map__table__positions,
    wp::int64 var_voxel_map__table__mask,
    wp::array_t<wp::int32> var_voxel_map__counts,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voxel_map__offsets,
    wp::array_t<wp::float32> var_squares,
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
        wp::shape_t* var_1;
        const wp::int32 var_2 = 1;
        wp::int32 var_3;
        wp::shape_t var_4;
        wp::int32 var_5;
        const wp::int32 var_6 = 1;
        wp::int32 var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        wp::int32 var_10;
        wp::int32 var_11;
        wp::mat_t<4, 4, wp::float64>* var_12;
        wp::mat_t<4, 4, wp::float64> var_13;
        wp::mat_t<4, 4, wp::float64> var_14;
        const wp::int32 var_15 = 0;
        const wp::int32 var_16 = 3;
        wp::float64 var_17;
        const wp::int32 var_18 = 1;
        const wp::int32 var_19 = 3;
        wp::float64 var_20;
        const wp::int32 var_21 = 2;
        const wp::int32 var_22 = 3;
        wp::float64 var_23;
        wp::vec_t<3, wp::float64> var_24;
        wp::int32 var_25;
        wp::int32 var_26;
        wp::int32 var_27;
        wp::range_t var_28;
        wp::int32 var_29;
        wp::int32 var_30;
        wp::vec_t<3, wp::float32>* var_31;
        wp::vec_t<3, wp::float64> var_32;
        wp::vec_t<3, wp::float32> var_33;
        wp::vec_t<3, wp::float64> var_34;
        wp::vec_t<3, wp::float64> var_35;
        wp::vec_t<5, wp::float64> var_36;
        const wp::float32 var_37 = -1.0;
        wp::float32 var_38;
        wp::float64 var_39;
        wp::float64 var_40;
        wp::float64 var_41;
        wp::float64 var_42;
        wp::vec_t<3, wp::float64> var_43;
        const wp::int32 var_44 = 4;
        wp::float64 var_45;
        wp::float64 var_46;
        bool var_47;
        const wp::int32 var_48 = 0;
        wp::float64 var_49;
        const wp::int32 var_50 = 1;
        wp::float64 var_51;
        const wp::int32 var_52 = 2;
        wp::float64 var_53;
        wp::vec_t<3, wp::float64> var_54;
        wp::vec_t<3, wp::float64> var_55;
        wp::vec_t<8, wp::float64> var_56;
        const wp::int32 var_57 = 6;
        wp::float64 var_58;
        wp::float64 var_59;
        bool var_60;
        const wp::int32 var_61 = 0;
        wp::float64 var_62;
        const wp::int32 var_63 = 1;
        wp::float64 var_64;
        const wp::int32 var_65 = 2;
        wp::float64 var_66;
        wp::vec_t<3, wp::float64> var_67;
        const wp::int32 var_68 = 3;
        wp::float64 var_69;
        const wp::int32 var_70 = 4;
        wp::float64 var_71;
        const wp::int32 var_72 = 5;
        wp::float64 var_73;
        wp::vec_t<3, wp::float64> var_74;
        wp::vec_t<3, wp::float64> var_75;
        wp::float64 var_76;
        wp::float64 var_77;
        wp::float64 var_78;
        wp::float64 var_79;
        wp::float64 var_80;
        wp::float64 var_81;
        wp::float64 var_82;
        const wp::int32 var_83 = 7;
        wp::float64 var_84;
        wp::float64 var_85;
        wp::float64 var_86;
        const wp::int32 var_87 = 6;
        wp::float64 var_88;
        wp::float64 var_89;
        wp::float64 var_90;
        wp::float64 var_91;
        wp::float32 var_92;
        wp::float64 var_93;
        wp::float32 var_94;
        wp::float64 var_95;
        wp::vec_t<3, wp::float64> var_96;
        wp::float32 var_97;
        wp::float64 var_98;
        wp::vec_t<3, wp::float64> var_99;
        const wp::int32 var_100 = 0;
        bool var_101;
        wp::vec_t<3, wp::float64> var_102;
        const wp::int32 var_103 = 0;
        wp::float64 var_104;
        wp::float64 var_105;
        const wp::int32 var_106 = 3;
        wp::int32 var_107;
        const wp::int32 var_108 = 1;
        wp::float64 var_109;
        wp::float64 var_110;
        const wp::int32 var_111 = 3;
        wp::int32 var_112;
        const wp::int32 var_113 = 2;
        wp::float64 var_114;
        wp::float64 var_115;
        const wp::int32 var_116 = 3;
        wp::int32 var_117;
        const wp::int32 var_118 = 7;
        const wp::int32 var_119 = 1;
        wp::int32 var_120;
        //---------
        // forward
        // def find_patches_kernel(points, step, poses, run, limit, radius, voxel_map__voxel_size, voxel_map__room, voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask, voxel_map__counts, voxel_map__offsets, squares, rows):       <L 1>
        // i = tid()                                                                              <L 5>
        var_0 = builtin_tid1d();
        // count = squares.shape[1]                                                               <L 6>
        var_1 = &(var_squares.shape);
        var_4 = wp::load(var_1);
        var_3 = wp::extract(var_4, var_2);
        // runs = (count + run - 1) // run                                                        <L 7>
        var_5 = wp::add(var_3, var_run);
        var_7 = wp::sub(var_5, var_6);
        var_8 = wp::floordiv(var_7, var_run);
        // k = i // runs                                                                          <L 8>
        var_9 = wp::floordiv(var_0, var_8);
        // first = i % runs * run                                                                 <L 9>
        var_10 = wp::mod(var_0, var_8);
        var_11 = wp::mul(var_10, var_run);
        // pose = poses[k]                                                                        <L 10>
        var_12 = wp::address(var_poses, var_9);
        var_14 = wp::load(var_12);
        var_13 = wp::copy(var_14);
        // t = vec3d(pose[0, 3], pose[1, 3], pose[2, 3])                                          <L 11>
        var_17 = wp::extract(var_13, var_15, var_16);
        var_20 = wp::extract(var_13, var_18, var_19);
        var_23 = wp::extract(var_13, var_21, var_22);
        var_24 = wp::vec_t<3, wp::float64>(var_17, var_20, var_23);
        // for j in range(first, first + min(run, count - first)):                                <L 12>
        var_25 = wp::sub(var_3, var_11);
        var_26 = wp::min(var_run, var_25);
        var_27 = wp::add(var_11, var_26);
        var_28 = wp::range(var_11, var_27);
        start_for_0:;
            if (iter_cmp(var_28) == 0) goto end_for_0;
            var_29 = wp::iter_next(var_28);
            // y = rotate(pose, widen(points[j * step]))                                          <L 13>
            var_30 = wp::mul(var_29, var_step);
            var_31 = wp::address(var_points, var_30);
            var_33 = wp::load(var_31);
            var_32 = widen_0(var_33);
            var_34 = rotate_1(var_13, var_32);
            // x = y + t                                                                          <L 14>
            var_35 = wp::add(var_34, var_24);
            // nearest_point = find_nearest_in_map(x, limit, voxel_map__voxel_size, voxel_map__room, voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask, voxel_map__counts, voxel_map__offsets)       <L 15>
            var_36 = find_nearest_in_map_0(var_35, var_limit, var_voxel_map__voxel_size, var_voxel_map__room, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask, var_voxel_map__counts, var_voxel_map__offsets);
            // square = float(-1.0)                                                               <L 16>
            var_38 = wp::float(var_37);
            // residual = float64(0.0)                                                            <L 17>
            var_39 = 0.0;
            // normal = vec3d(float64(0.0), float64(0.0), float64(0.0))                           <L 18>
            var_40 = 0.0;
            var_41 = 0.0;
            var_42 = 0.0;
            var_43 = wp::vec_t<3, wp::float64>(var_40, var_41, var_42);
            // if nearest_point[4] >= float64(0.0):                                               <L 19>
            var_45 = wp::extract(var_36, var_44);
            var_46 = 0.0;
            var_47 = (var_45 >= var_46);
            if (var_47) {
                // r = vec3d(nearest_point[0], nearest_point[1], nearest_point[2])                <L 20>
                var_49 = wp::extract(var_36, var_48);
                var_51 = wp::extract(var_36, var_50);
                var_53 = wp::extract(var_36, var_52);
                var_54 = wp::vec_t<3, wp::float64>(var_49, var_51, var_53);
                // at = patch_at(x - r, y, radius, voxel_map__voxel_size, voxel_map__room, voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask, voxel_map__counts, voxel_map__offsets)       <L 21>
                var_55 = wp::sub(var_35, var_54);
                var_56 = patch_at_0(var_55, var_34, var_radius, var_voxel_map__voxel_size, var_voxel_map__room, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask, var_voxel_map__counts, var_voxel_map__offsets);
                // if at[6] > float64(0.0):                                                       <L 22>
                var_58 = wp::extract(var_56, var_57);
                var_59 = 0.0;
                var_60 = (var_58 > var_59);
                if (var_60) {
                    // normal = vec3d(at[0], at[1], at[2])                                        <L 23>
                    var_62 = wp::extract(var_56, var_61);
                    var_64 = wp::extract(var_56, var_63);
                    var_66 = wp::extract(var_56, var_65);
                    var_67 = wp::vec_t<3, wp::float64>(var_62, var_64, var_66);
                    // d = r - vec3d(at[3], at[4], at[5])                                         <L 24>
                    var_69 = wp::extract(var_56, var_68);
                    var_71 = wp::extract(var_56, var_70);
                    var_73 = wp::extract(var_56, var_72);
                    var_74 = wp::vec_t<3, wp::float64>(var_69, var_71, var_73);
                    var_75 = wp::sub(var_54, var_74);
                    // along = dot(d, normal)                                                     <L 25>
                    var_76 = wp::dot(var_75, var_67);
                    // beside = dot(d, d) - along * along                                         <L 26>
                    var_77 = wp::dot(var_75, var_75);
                    var_78 = wp::mul(var_76, var_76);
                    var_79 = wp::sub(var_77, var_78);
                    // square = float(along * along / (float64(1.0) + (float64(1.0) + beside / at[7]) / at[6]))       <L 27>
                    var_80 = wp::mul(var_76, var_76);
                    var_81 = 1.0;
                    var_82 = 1.0;
                    var_84 = wp::extract(var_56, var_83);
                    var_85 = wp::div(var_79, var_84);
                    var_86 = wp::add(var_82, var_85);
                    var_88 = wp::extract(var_56, var_87);
                    var_89 = wp::div(var_86, var_88);
                    var_90 = wp::add(var_81, var_89);
                    var_91 = wp::div(var_80, var_90);
                    var_92 = wp::float(var_91);
                    // residual = along                                                           <L 28>
                    var_93 = wp::copy(var_76);
                }
                var_94 = wp::where(var_60, var_92, var_38);
                var_95 = wp::where(var_60, var_93, var_39);
                var_96 = wp::where(var_60, var_67, var_43);
            }
            var_97 = wp::where(var_47, var_94, var_38);
            var_98 = wp::where(var_47, var_95, var_39);
            var_99 = wp::where(var_47, var_96, var_43);
            // squares[k, j] = square                                                             <L 29>
            wp::array_store(var_squares, var_9, var_29, var_97);
            // if k == 0:                                                                         <L 30>
            var_101 = (var_9 == var_100);
            if (var_101) {
                // turning = cross(y, normal)                                                     <L 31>
                var_102 = wp::cross(var_34, var_99);
                // for axis in range(3):                                                          <L 32>
                // rows[j, axis] = turning[axis]                                                  <L 33>
                var_104 = wp::extract(var_102, var_103);
                wp::array_store(var_rows, var_29, var_103, var_104);
                // rows[j, 3 + axis] = normal[axis]                                               <L 34>
                var_105 = wp::extract(var_99, var_103);
                var_107 = wp::add(var_106, var_103);
                wp::array_store(var_rows, var_29, var_107, var_105);
                // rows[j, axis] = turning[axis]                                                  <L 33>
                var_109 = wp::extract(var_102, var_108);
                wp::array_store(var_rows, var_29, var_108, var_109);
                // rows[j, 3 + axis] = normal[axis]                                               <L 34>
                var_110 = wp::extract(var_99, var_108);
                var_112 = wp::add(var_111, var_108);
                wp::array_store(var_rows, var_29, var_112, var_110);
                // rows[j, axis] = turning[axis]                                                  <L 33>
                var_114 = wp::extract(var_102, var_113);
                wp::array_store(var_rows, var_29, var_113, var_114);
                // rows[j, 3 + axis] = normal[axis]                                               <L 34>
                var_115 = wp::extract(var_99, var_113);
                var_117 = wp::add(var_116, var_113);
                wp::array_store(var_rows, var_29, var_117, var_115);
                // rows[j, ROW - 1] = residual                                                    <L 35>
                var_120 = wp::sub(var_118, var_119);
                wp::array_store(var_rows, var_29, var_120, var_98);
            }
            goto start_for_0;
        end_for_0:;
}


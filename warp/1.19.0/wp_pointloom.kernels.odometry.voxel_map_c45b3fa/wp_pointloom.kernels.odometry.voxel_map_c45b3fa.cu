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


// <pointloom.kernels.odometry.local_cells.key_cell>:1
static CUDA_CALLABLE wp::vec_t<3, wp::int32> key_cell_0(
    wp::int64 var_key,
    wp::vec_t<3, wp::int32> var_cells__first,
    wp::int32 var_cells__bits)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int64 var_2;
    wp::int64 var_3;
    wp::int64 var_4;
    const wp::int32 var_5 = 2;
    wp::int32 var_6;
    wp::int64 var_7;
    wp::int64 var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 0;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::int64 var_13;
    wp::int64 var_14;
    wp::int64 var_15;
    wp::int32 var_16;
    const wp::int32 var_17 = 1;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::int64 var_20;
    wp::int32 var_21;
    const wp::int32 var_22 = 2;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::vec_t<3, wp::int32> var_25;
    //---------
    // forward
    // def key_cell(key, cells__first, cells__bits):                                          <L 1>
    // low = (int64(1) << int64(cells__bits)) - int64(1)                                      <L 2>
    var_0 = 1ll;
    var_1 = wp::int64(var_cells__bits);
    var_2 = wp::lshift(var_0, var_1);
    var_3 = 1ll;
    var_4 = wp::sub(var_2, var_3);
    // x = int(key >> int64(2 * cells__bits)) + cells__first[0]                               <L 3>
    var_6 = wp::mul(var_5, var_cells__bits);
    var_7 = wp::int64(var_6);
    var_8 = wp::rshift(var_key, var_7);
    var_9 = wp::int(var_8);
    var_11 = wp::extract(var_cells__first, var_10);
    var_12 = wp::add(var_9, var_11);
    // y = int(key >> int64(cells__bits) & low) + cells__first[1]                             <L 4>
    var_13 = wp::int64(var_cells__bits);
    var_14 = wp::rshift(var_key, var_13);
    var_15 = wp::bit_and(var_14, var_4);
    var_16 = wp::int(var_15);
    var_18 = wp::extract(var_cells__first, var_17);
    var_19 = wp::add(var_16, var_18);
    // z = int(key & low) + cells__first[2]                                                   <L 5>
    var_20 = wp::bit_and(var_key, var_4);
    var_21 = wp::int(var_20);
    var_23 = wp::extract(var_cells__first, var_22);
    var_24 = wp::add(var_21, var_23);
    // return vec3i(x, y, z)                                                                  <L 6>
    var_25 = wp::vec_t<3, wp::int32>(var_12, var_19, var_24);
    return var_25;
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


// <pointloom.kernels.odometry.voxel_map.touched_key>:1
static CUDA_CALLABLE wp::int64 touched_key_0(
    wp::int32 var_i,
    wp::array_t<wp::int64> var_touched__keys,
    wp::array_t<wp::int32> var_touched__summary,
    wp::vec_t<3, wp::int32> var_cells__first,
    wp::int32 var_cells__bits,
    wp::int64 var_cells__skipped)
{
    //---------
    // primal vars
    wp::int64 var_0;
    const wp::int32 var_1 = 0;
    wp::int32* var_2;
    bool var_3;
    wp::int32 var_4;
    wp::int64* var_5;
    bool var_6;
    wp::int64 var_7;
    wp::int64* var_8;
    wp::vec_t<3, wp::int32> var_9;
    wp::int64 var_10;
    const wp::int32 var_11 = 0;
    wp::int32 var_12;
    const wp::int32 var_13 = 1;
    wp::int32 var_14;
    const wp::int32 var_15 = 2;
    wp::int32 var_16;
    wp::int64 var_17;
    wp::int64 var_18;
    wp::int64 var_19;
    //---------
    // forward
    // def touched_key(i, touched__keys, touched__summary, cells__first, cells__bits, cells__skipped):       <L 1>
    // key = int64(-1)                                                                        <L 3>
    var_0 = -1ll;
    // if i < touched__summary[0]:                                                            <L 4>
    var_2 = wp::address(var_touched__summary, var_1);
    var_4 = wp::load(var_2);
    var_3 = (var_i < var_4);
    if (var_3) {
        // if touched__keys[i] != cells__skipped:                                             <L 5>
        var_5 = wp::address(var_touched__keys, var_i);
        var_7 = wp::load(var_5);
        var_6 = (var_7 != var_cells__skipped);
        if (var_6) {
            // cell = key_cell(touched__keys[i], cells__first, cells__bits)                   <L 6>
            var_8 = wp::address(var_touched__keys, var_i);
            var_10 = wp::load(var_8);
            var_9 = key_cell_0(var_10, var_cells__first, var_cells__bits);
            // key = block_key(cell[0], cell[1], cell[2])                                     <L 7>
            var_12 = wp::extract(var_9, var_11);
            var_14 = wp::extract(var_9, var_13);
            var_16 = wp::extract(var_9, var_15);
            var_17 = block_key_0(var_12, var_14, var_16);
        }
        var_18 = wp::where(var_6, var_17, var_0);
    }
    var_19 = wp::where(var_3, var_18, var_0);
    // return key                                                                             <L 8>
    return var_19;
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


// <pointloom.kernels.odometry.local_cells.local_key>:1
static CUDA_CALLABLE wp::int64 local_key_0(
    wp::vec_t<3, wp::int32> var_cell,
    wp::vec_t<3, wp::int32> var_cells__first,
    wp::int32 var_cells__bits)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 0;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::int64 var_5;
    const wp::int32 var_6 = 1;
    wp::int32 var_7;
    const wp::int32 var_8 = 1;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::int64 var_11;
    const wp::int32 var_12 = 2;
    wp::int32 var_13;
    const wp::int32 var_14 = 2;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::int64 var_17;
    wp::int64 var_18;
    wp::int64 var_19;
    wp::int64 var_20;
    wp::int64 var_21;
    wp::int64 var_22;
    wp::int64 var_23;
    //---------
    // forward
    // def local_key(cell, cells__first, cells__bits):                                        <L 1>
    // x = int64(cell[0] - cells__first[0])                                                   <L 2>
    var_1 = wp::extract(var_cell, var_0);
    var_3 = wp::extract(var_cells__first, var_2);
    var_4 = wp::sub(var_1, var_3);
    var_5 = wp::int64(var_4);
    // y = int64(cell[1] - cells__first[1])                                                   <L 3>
    var_7 = wp::extract(var_cell, var_6);
    var_9 = wp::extract(var_cells__first, var_8);
    var_10 = wp::sub(var_7, var_9);
    var_11 = wp::int64(var_10);
    // z = int64(cell[2] - cells__first[2])                                                   <L 4>
    var_13 = wp::extract(var_cell, var_12);
    var_15 = wp::extract(var_cells__first, var_14);
    var_16 = wp::sub(var_13, var_15);
    var_17 = wp::int64(var_16);
    // return (x << int64(cells__bits) | y) << int64(cells__bits) | z                         <L 5>
    var_18 = wp::int64(var_cells__bits);
    var_19 = wp::lshift(var_5, var_18);
    var_20 = wp::bit_or(var_19, var_11);
    var_21 = wp::int64(var_cells__bits);
    var_22 = wp::lshift(var_20, var_21);
    var_23 = wp::bit_or(var_22, var_17);
    return var_23;
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


// <pointloom.kernels.arrays.atomic_changes.note_change>:1
static CUDA_CALLABLE void note_change_0(
    wp::int32 var_thread,
    wp::array_t<wp::int64> var_changes__latest,
    wp::int64 var_changes__number)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    bool var_1;
    const wp::int32 var_2 = 0;
    //---------
    // forward
    // def note_change(thread, changes__latest, changes__number):                             <L 1>
    // if thread == 0:                                                                        <L 3>
    var_1 = (var_thread == var_0);
    if (var_1) {
        // changes__latest[0] = changes__number                                               <L 4>
        wp::array_store(var_changes__latest, var_2, var_changes__number);
    }
}


// <pointloom.kernels.odometry.voxel_map.take_points>:1
static CUDA_CALLABLE void take_points_0(
    wp::int32 var_voxel,
    wp::int32 var_known,
    wp::int32 var_begin,
    wp::int32 var_end,
    wp::array_t<wp::int32> var_order,
    wp::array_t<wp::vec_t<3, wp::float32>> var_new_offsets,
    wp::int32 var_voxel_map__room,
    wp::float32 var_voxel_map__sqspacing,
    wp::array_t<wp::int32> var_voxel_map__counts,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voxel_map__offsets)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 0;
    wp::int32 var_2;
    bool var_3;
    wp::int32* var_4;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::int32 var_7;
    wp::range_t var_8;
    wp::int32 var_9;
    bool var_10;
    wp::int32* var_11;
    wp::int32 var_12;
    wp::vec_t<3, wp::float32>* var_13;
    wp::vec_t<3, wp::float32> var_14;
    wp::vec_t<3, wp::float32> var_15;
    const wp::int32 var_16 = 0;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::range_t var_19;
    wp::int32 var_20;
    wp::vec_t<3, wp::float32>* var_21;
    wp::vec_t<3, wp::float32> var_22;
    wp::vec_t<3, wp::float32> var_23;
    const wp::int32 var_24 = 0;
    wp::float32 var_25;
    const wp::int32 var_26 = 0;
    wp::float32 var_27;
    wp::float32 var_28;
    const wp::int32 var_29 = 1;
    wp::float32 var_30;
    const wp::int32 var_31 = 1;
    wp::float32 var_32;
    wp::float32 var_33;
    wp::float32 var_34;
    const wp::int32 var_35 = 2;
    wp::float32 var_36;
    const wp::int32 var_37 = 2;
    wp::float32 var_38;
    wp::float32 var_39;
    wp::float32 var_40;
    bool var_41;
    const wp::int32 var_42 = 1;
    wp::int32 var_43;
    const wp::int32 var_44 = 0;
    bool var_45;
    wp::int32 var_46;
    const wp::int32 var_47 = 1;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::int32 var_50;
    //---------
    // forward
    // def take_points(voxel, known, begin, end, order, new_offsets, voxel_map__room, voxel_map__sqspacing, voxel_map__counts, voxel_map__offsets):       <L 1>
    // first = voxel * voxel_map__room                                                        <L 3>
    var_0 = wp::mul(var_voxel, var_voxel_map__room);
    // count = int(0)                                                                         <L 4>
    var_2 = wp::int(var_1);
    // if voxel < known:                                                                      <L 5>
    var_3 = (var_voxel < var_known);
    if (var_3) {
        // count = voxel_map__counts[voxel]                                                   <L 6>
        var_4 = wp::address(var_voxel_map__counts, var_voxel);
        var_6 = wp::load(var_4);
        var_5 = wp::copy(var_6);
    }
    var_7 = wp::where(var_3, var_5, var_2);
    // for j in range(begin, end):                                                            <L 7>
    var_8 = wp::range(var_begin, var_end);
    start_for_0:;
        if (iter_cmp(var_8) == 0) goto end_for_0;
        var_9 = wp::iter_next(var_8);
        // if count < voxel_map__room:                                                        <L 8>
        var_10 = (var_7 < var_voxel_map__room);
        if (var_10) {
            // p = new_offsets[order[j]]                                                      <L 9>
            var_11 = wp::address(var_order, var_9);
            var_12 = wp::load(var_11);
            var_13 = wp::address(var_new_offsets, var_12);
            var_15 = wp::load(var_13);
            var_14 = wp::copy(var_15);
            // near = int(0)                                                                  <L 10>
            var_17 = wp::int(var_16);
            // for slot in range(first, first + count):                                       <L 11>
            var_18 = wp::add(var_0, var_7);
            var_19 = wp::range(var_0, var_18);
            start_for_2:;
                if (iter_cmp(var_19) == 0) goto end_for_2;
                var_20 = wp::iter_next(var_19);
                // d = p - voxel_map__offsets[slot]                                           <L 12>
                var_21 = wp::address(var_voxel_map__offsets, var_20);
                var_23 = wp::load(var_21);
                var_22 = wp::sub(var_14, var_23);
                // if d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < voxel_map__sqspacing:         <L 13>
                var_25 = wp::extract(var_22, var_24);
                var_27 = wp::extract(var_22, var_26);
                var_28 = wp::mul(var_25, var_27);
                var_30 = wp::extract(var_22, var_29);
                var_32 = wp::extract(var_22, var_31);
                var_33 = wp::mul(var_30, var_32);
                var_34 = wp::add(var_28, var_33);
                var_36 = wp::extract(var_22, var_35);
                var_38 = wp::extract(var_22, var_37);
                var_39 = wp::mul(var_36, var_38);
                var_40 = wp::add(var_34, var_39);
                var_41 = (var_40 < var_voxel_map__sqspacing);
                if (var_41) {
                    // near = 1                                                               <L 14>
                }
                var_43 = wp::where(var_41, var_42, var_17);
                wp::assign(var_17, var_43);
                goto start_for_2;
            end_for_2:;
            // if near == 0:                                                                  <L 15>
            var_45 = (var_17 == var_44);
            if (var_45) {
                // voxel_map__offsets[first + count] = p                                      <L 16>
                var_46 = wp::add(var_0, var_7);
                wp::array_store(var_voxel_map__offsets, var_46, var_14);
                // count += 1                                                                 <L 17>
                var_48 = wp::add(var_7, var_47);
            }
            var_49 = wp::where(var_45, var_48, var_7);
        }
        var_50 = wp::where(var_10, var_49, var_7);
        wp::assign(var_7, var_50);
        goto start_for_0;
    end_for_0:;
    // voxel_map__counts[voxel] = count                                                       <L 18>
    wp::array_store(var_voxel_map__counts, var_voxel, var_7);
}


// <pointloom.kernels.arrays.hash_table.insert_entry>:1
static CUDA_CALLABLE void insert_entry_0(
    wp::int64 var_entry,
    wp::int32 var_low_bits,
    wp::array_t<wp::int64> var_entries,
    wp::int64 var_mask)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int64 var_2;
    wp::int64 var_3;
    wp::int64 var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    const wp::int32 var_7 = 1;
    bool var_8;
    wp::int32 var_9;
    wp::int64 var_10;
    bool var_11;
    wp::int64 var_12;
    bool var_13;
    wp::int64 var_14;
    wp::int64 var_15;
    wp::int64 var_16;
    wp::int64 var_17;
    bool var_18;
    const wp::int32 var_19 = 0;
    bool var_20;
    wp::int64 var_21;
    wp::int64 var_22;
    wp::int64 var_23;
    wp::int64 var_24;
    wp::int64 var_25;
    wp::int64 var_26;
    wp::int64 var_27;
    wp::int32 var_28;
    //---------
    // forward
    // def insert_entry(entry, low_bits, entries, mask):                                      <L 1>
    // carried = entry                                                                        <L 3>
    var_0 = wp::copy(var_entry);
    // slot = mix_bits(carried >> int64(low_bits)) & mask                                     <L 4>
    var_1 = wp::int64(var_low_bits);
    var_2 = wp::rshift(var_0, var_1);
    var_3 = mix_bits_0(var_2);
    var_4 = wp::bit_and(var_3, var_mask);
    // carrying = int(1)                                                                      <L 5>
    var_6 = wp::int(var_5);
    // while carrying == 1:                                                                   <L 6>
    start_while_0:;
    var_8 = (var_6 == var_7);
    if ((var_8) == false) goto end_while_0;
        // old = atomic_min(entries, int(slot), carried)                                      <L 7>
        var_9 = wp::int(var_4);
        var_10 = wp::atomic_min(var_entries, var_9, var_0);
        // if old == int64(EMPTY) or old >> int64(low_bits) == carried >> int64(low_bits):       <L 8>
        var_12 = 9223372036854775807ll;
        var_13 = (var_10 == var_12);
        var_11 = var_13;
        if (!var_11) {
            var_14 = wp::int64(var_low_bits);
            var_15 = wp::rshift(var_10, var_14);
            var_16 = wp::int64(var_low_bits);
            var_17 = wp::rshift(var_0, var_16);
            var_18 = (var_15 == var_17);
            var_11 = var_11 || var_18;
        }
        if (var_11) {
            // carrying = 0                                                                   <L 9>
        }
        if (!var_11) {
            // if old > carried:                                                              <L 11>
            var_20 = (var_10 > var_0);
            if (var_20) {
                // carried = old                                                              <L 12>
                var_21 = wp::copy(var_10);
            }
            var_22 = wp::where(var_20, var_21, var_0);
            // slot = slot + int64(1) & mask                                                  <L 13>
            var_23 = 1ll;
            var_24 = wp::add(var_4, var_23);
            var_25 = wp::bit_and(var_24, var_mask);
        }
        var_26 = wp::where(var_11, var_0, var_22);
        var_27 = wp::where(var_11, var_4, var_25);
        var_28 = wp::where(var_11, var_19, var_6);
        wp::assign(var_0, var_26);
        wp::assign(var_4, var_27);
        wp::assign(var_6, var_28);
    goto start_while_0;
    end_while_0:;
}


// <pointloom.kernels.arrays.hash_table.insert_key>:1
static CUDA_CALLABLE void insert_key_0(
    wp::int64 var_key,
    wp::array_t<wp::int64> var_table__keys,
    wp::int64 var_table__mask)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    //---------
    // forward
    // def insert_key(key, table__keys, table__mask):                                         <L 1>
    // insert_entry(key, 0, table__keys, table__mask)                                         <L 2>
    insert_entry_0(var_key, var_0, var_table__keys, var_table__mask);
}


// <pointloom.kernels.odometry.local_cells.key_cell>:1
static CUDA_CALLABLE void adj_key_cell_0(
    wp::int64 var_key,
    wp::vec_t<3, wp::int32> var_cells__first,
    wp::int32 var_cells__bits,
    wp::int64 & adj_key,
    wp::vec_t<3, wp::int32> & adj_cells__first,
    wp::int32 & adj_cells__bits,
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


// <pointloom.kernels.odometry.voxel_map.touched_key>:1
static CUDA_CALLABLE void adj_touched_key_0(
    wp::int32 var_i,
    wp::array_t<wp::int64> var_touched__keys,
    wp::array_t<wp::int32> var_touched__summary,
    wp::vec_t<3, wp::int32> var_cells__first,
    wp::int32 var_cells__bits,
    wp::int64 var_cells__skipped,
    wp::int32 & adj_i,
    wp::array_t<wp::int64> & adj_touched__keys,
    wp::array_t<wp::int32> & adj_touched__summary,
    wp::vec_t<3, wp::int32> & adj_cells__first,
    wp::int32 & adj_cells__bits,
    wp::int64 & adj_cells__skipped,
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


// <pointloom.kernels.odometry.local_cells.local_key>:1
static CUDA_CALLABLE void adj_local_key_0(
    wp::vec_t<3, wp::int32> var_cell,
    wp::vec_t<3, wp::int32> var_cells__first,
    wp::int32 var_cells__bits,
    wp::vec_t<3, wp::int32> & adj_cell,
    wp::vec_t<3, wp::int32> & adj_cells__first,
    wp::int32 & adj_cells__bits,
    wp::int64 & adj_ret)
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


// /work/main/src/pointloom/kernels/arrays/block_keys.py:16
static CUDA_CALLABLE void adj_key_block_0(
    wp::int64 var_key,
    wp::int64 & adj_key,
    wp::vec_t<3, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.atomic_changes.note_change>:1
static CUDA_CALLABLE void adj_note_change_0(
    wp::int32 var_thread,
    wp::array_t<wp::int64> var_changes__latest,
    wp::int64 var_changes__number,
    wp::int32 & adj_thread,
    wp::array_t<wp::int64> & adj_changes__latest,
    wp::int64 & adj_changes__number)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.odometry.voxel_map.take_points>:1
static CUDA_CALLABLE void adj_take_points_0(
    wp::int32 var_voxel,
    wp::int32 var_known,
    wp::int32 var_begin,
    wp::int32 var_end,
    wp::array_t<wp::int32> var_order,
    wp::array_t<wp::vec_t<3, wp::float32>> var_new_offsets,
    wp::int32 var_voxel_map__room,
    wp::float32 var_voxel_map__sqspacing,
    wp::array_t<wp::int32> var_voxel_map__counts,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voxel_map__offsets,
    wp::int32 & adj_voxel,
    wp::int32 & adj_known,
    wp::int32 & adj_begin,
    wp::int32 & adj_end,
    wp::array_t<wp::int32> & adj_order,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_new_offsets,
    wp::int32 & adj_voxel_map__room,
    wp::float32 & adj_voxel_map__sqspacing,
    wp::array_t<wp::int32> & adj_voxel_map__counts,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_voxel_map__offsets)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.hash_table.insert_entry>:1
static CUDA_CALLABLE void adj_insert_entry_0(
    wp::int64 var_entry,
    wp::int32 var_low_bits,
    wp::array_t<wp::int64> var_entries,
    wp::int64 var_mask,
    wp::int64 & adj_entry,
    wp::int32 & adj_low_bits,
    wp::array_t<wp::int64> & adj_entries,
    wp::int64 & adj_mask)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.hash_table.insert_key>:1
static CUDA_CALLABLE void adj_insert_key_0(
    wp::int64 var_key,
    wp::array_t<wp::int64> var_table__keys,
    wp::int64 var_table__mask,
    wp::int64 & adj_key,
    wp::array_t<wp::int64> & adj_table__keys,
    wp::int64 & adj_table__mask)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void gather_voxels_kernel_5102193b_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_rows,
    wp::array_t<wp::int32> var_counts,
    wp::array_t<wp::vec_t<3, wp::float32>> var_offsets,
    wp::int32 var_voxel_map__room,
    wp::array_t<wp::int32> var_voxel_map__counts,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voxel_map__offsets)
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
        wp::int32 var_5;
        wp::int32 var_6;
        wp::range_t var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        wp::int32 var_10;
        wp::vec_t<3, wp::float32>* var_11;
        wp::vec_t<3, wp::float32> var_12;
        wp::vec_t<3, wp::float32> var_13;
        wp::int32 var_14;
        wp::int32 var_15;
        //---------
        // forward
        // def gather_voxels_kernel(rows, counts, offsets, voxel_map__room, voxel_map__counts, voxel_map__offsets):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // voxel = rows[i]                                                                        <L 3>
        var_1 = wp::address(var_rows, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // count = counts[voxel]                                                                  <L 4>
        var_4 = wp::address(var_counts, var_2);
        var_6 = wp::load(var_4);
        var_5 = wp::copy(var_6);
        // voxel_map__counts[i] = count                                                           <L 5>
        wp::array_store(var_voxel_map__counts, var_0, var_5);
        // for slot in range(count):                                                              <L 6>
        var_7 = wp::range(var_5);
        start_for_0:;
            if (iter_cmp(var_7) == 0) goto end_for_0;
            var_8 = wp::iter_next(var_7);
            // voxel_map__offsets[i * voxel_map__room + slot] = offsets[voxel * voxel_map__room + slot]       <L 7>
            var_9 = wp::mul(var_2, var_voxel_map__room);
            var_10 = wp::add(var_9, var_8);
            var_11 = wp::address(var_offsets, var_10);
            var_13 = wp::load(var_11);
            var_12 = wp::copy(var_13);
            var_14 = wp::mul(var_0, var_voxel_map__room);
            var_15 = wp::add(var_14, var_8);
            wp::array_store(var_voxel_map__offsets, var_15, var_12);
            goto start_for_0;
        end_for_0:;
}



extern "C" __global__ void find_voxels_kernel_67343d00_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int64> var_touched__keys,
    wp::array_t<wp::int32> var_touched__summary,
    wp::array_t<wp::int32> var_touched__voxels,
    wp::array_t<wp::int32> var_touched__fresh,
    wp::vec_t<3, wp::int32> var_cells__first,
    wp::int32 var_cells__bits,
    wp::int64 var_cells__skipped,
    wp::array_t<wp::int64> var_table__keys,
    wp::array_t<wp::int32> var_table__positions,
    wp::int64 var_table__mask)
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
        const wp::int32 var_2 = -2;
        wp::int32 var_3;
        const wp::int32 var_4 = 0;
        wp::int32 var_5;
        wp::int64 var_6;
        bool var_7;
        wp::int32 var_8;
        const wp::int32 var_9 = 0;
        bool var_10;
        const wp::int32 var_11 = 1;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int32 var_14;
        //---------
        // forward
        // def find_voxels_kernel(touched__keys, touched__summary, touched__voxels, touched__fresh, cells__first, cells__bits, cells__skipped, table__keys, table__positions, table__mask):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // key = touched_key(i, touched__keys, touched__summary, cells__first, cells__bits, cells__skipped)       <L 4>
        var_1 = touched_key_0(var_0, var_touched__keys, var_touched__summary, var_cells__first, var_cells__bits, var_cells__skipped);
        // voxel = int(-2)                                                                        <L 5>
        var_3 = wp::int(var_2);
        // is_new = int(0)                                                                        <L 6>
        var_5 = wp::int(var_4);
        // if key >= int64(0):                                                                    <L 7>
        var_6 = 0ll;
        var_7 = (var_1 >= var_6);
        if (var_7) {
            // voxel = find_position(key, table__keys, table__positions, table__mask)             <L 8>
            var_8 = find_position_0(var_1, var_table__keys, var_table__positions, var_table__mask);
            // if voxel < 0:                                                                      <L 9>
            var_10 = (var_8 < var_9);
            if (var_10) {
                // is_new = 1                                                                     <L 10>
            }
            var_12 = wp::where(var_10, var_11, var_5);
        }
        var_13 = wp::where(var_7, var_8, var_3);
        var_14 = wp::where(var_7, var_12, var_5);
        // touched__voxels[i] = voxel                                                             <L 11>
        wp::array_store(var_touched__voxels, var_0, var_13);
        // touched__fresh[i] = is_new                                                             <L 12>
        wp::array_store(var_touched__fresh, var_0, var_14);
}



extern "C" __global__ void encode_points_kernel_79b79e27_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::float64 var_cells__size,
    wp::vec_t<3, wp::int32> var_cells__first,
    wp::int32 var_cells__bits,
    wp::int64 var_cells__skipped,
    wp::array_t<wp::int64> var_keys,
    wp::array_t<wp::vec_t<3, wp::float32>> var_offsets)
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
        wp::vec_t<3, wp::float32> var_2;
        wp::vec_t<3, wp::float32> var_3;
        wp::int64 var_4;
        const wp::float32 var_5 = 0.0;
        const wp::float32 var_6 = 0.0;
        const wp::float32 var_7 = 0.0;
        wp::vec_t<3, wp::float32> var_8;
        bool var_9;
        wp::vec_t<3, wp::float64> var_10;
        wp::vec_t<3, wp::float64> var_11;
        wp::vec_t<3, wp::int32> var_12;
        wp::int64 var_13;
        wp::vec_t<3, wp::float32> var_14;
        wp::int64 var_15;
        wp::vec_t<3, wp::float32> var_16;
        //---------
        // forward
        // def encode_points_kernel(points, pose, cells__size, cells__first, cells__bits, cells__skipped, keys, offsets):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // p = points[i]                                                                          <L 3>
        var_1 = wp::address(var_points, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // key = cells__skipped                                                                   <L 4>
        var_4 = wp::copy(var_cells__skipped);
        // offset = vec3(0.0, 0.0, 0.0)                                                           <L 5>
        var_8 = wp::vec_t<3, wp::float32>(var_5, var_6, var_7);
        // if isfinite(p):                                                                        <L 6>
        var_9 = wp::isfinite(var_2);
        if (var_9) {
            // x = move(pose, widen(p))                                                           <L 7>
            var_10 = widen_0(var_2);
            var_11 = move_0(var_pose, var_10);
            // cell = cell_holding(x, cells__size)                                                <L 8>
            var_12 = cell_holding_0(var_11, var_cells__size);
            // key = local_key(cell, cells__first, cells__bits)                                   <L 9>
            var_13 = local_key_0(var_12, var_cells__first, var_cells__bits);
            // offset = offset_in_cell(x, cell, cells__size)                                      <L 10>
            var_14 = offset_in_cell_0(var_11, var_12, var_cells__size);
        }
        var_15 = wp::where(var_9, var_13, var_4);
        var_16 = wp::where(var_9, var_14, var_8);
        // keys[i] = key                                                                          <L 11>
        wp::array_store(var_keys, var_0, var_15);
        // offsets[i] = offset                                                                    <L 12>
        wp::array_store(var_offsets, var_0, var_16);
}



extern "C" __global__ void gather_map_kernel_90a6908b_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::float64 var_voxel_map__voxel_size,
    wp::int32 var_voxel_map__room,
    wp::array_t<wp::int64> var_voxel_map__keys,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voxel_map__offsets,
    wp::array_t<wp::int32> var_offsets,
    wp::vec_t<3, wp::int32> var_first,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points)
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
        wp::vec_t<3, wp::int32> var_2;
        wp::int64 var_3;
        wp::vec_t<3, wp::int32> var_4;
        const wp::int32 var_5 = 0;
        wp::int32 var_6;
        wp::float64 var_7;
        const wp::int32 var_8 = 1;
        wp::int32 var_9;
        wp::float64 var_10;
        const wp::int32 var_11 = 2;
        wp::int32 var_12;
        wp::float64 var_13;
        wp::vec_t<3, wp::float64> var_14;
        wp::vec_t<3, wp::float64> var_15;
        wp::int32* var_16;
        const wp::int32 var_17 = 1;
        wp::int32 var_18;
        wp::int32* var_19;
        wp::range_t var_20;
        wp::int32 var_21;
        wp::int32 var_22;
        wp::int32 var_23;
        wp::int32 var_24;
        wp::int32 var_25;
        wp::int32* var_26;
        wp::int32 var_27;
        wp::int32 var_28;
        wp::vec_t<3, wp::float32>* var_29;
        wp::vec_t<3, wp::float64> var_30;
        wp::vec_t<3, wp::float32> var_31;
        wp::vec_t<3, wp::float64> var_32;
        wp::vec_t<3, wp::float32> var_33;
        //---------
        // forward
        // def gather_map_kernel(voxel_map__voxel_size, voxel_map__room, voxel_map__keys, voxel_map__offsets, offsets, first, points):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // cell = key_block(voxel_map__keys[i]) - first                                           <L 4>
        var_1 = wp::address(var_voxel_map__keys, var_0);
        var_3 = wp::load(var_1);
        var_2 = key_block_0(var_3);
        var_4 = wp::sub(var_2, var_first);
        // corner = vec3d(float64(cell[0]), float64(cell[1]), float64(cell[2])) * voxel_map__voxel_size       <L 5>
        var_6 = wp::extract(var_4, var_5);
        var_7 = wp::float64(var_6);
        var_9 = wp::extract(var_4, var_8);
        var_10 = wp::float64(var_9);
        var_12 = wp::extract(var_4, var_11);
        var_13 = wp::float64(var_12);
        var_14 = wp::vec_t<3, wp::float64>(var_7, var_10, var_13);
        var_15 = wp::mul(var_14, var_voxel_map__voxel_size);
        // for j in range(offsets[i], offsets[i + 1]):                                            <L 6>
        var_16 = wp::address(var_offsets, var_0);
        var_18 = wp::add(var_0, var_17);
        var_19 = wp::address(var_offsets, var_18);
        var_21 = wp::load(var_16);
        var_22 = wp::load(var_19);
        var_20 = wp::range(var_21, var_22);
        start_for_0:;
            if (iter_cmp(var_20) == 0) goto end_for_0;
            var_23 = wp::iter_next(var_20);
            // points[j] = narrow(corner + widen(voxel_map__offsets[i * voxel_map__room + j - offsets[i]]))       <L 7>
            var_24 = wp::mul(var_0, var_voxel_map__room);
            var_25 = wp::add(var_24, var_23);
            var_26 = wp::address(var_offsets, var_0);
            var_28 = wp::load(var_26);
            var_27 = wp::sub(var_25, var_28);
            var_29 = wp::address(var_voxel_map__offsets, var_27);
            var_31 = wp::load(var_29);
            var_30 = widen_0(var_31);
            var_32 = wp::add(var_15, var_30);
            var_33 = narrow_0(var_32);
            wp::array_store(var_points, var_23, var_33);
            goto start_for_0;
        end_for_0:;
}



extern "C" __global__ void insert_touched_kernel_924569b6_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_touched__order,
    wp::array_t<wp::int32> var_touched__starts,
    wp::array_t<wp::int32> var_touched__voxels,
    wp::array_t<wp::vec_t<3, wp::float32>> var_new_offsets,
    wp::int32 var_voxel_map__room,
    wp::float32 var_voxel_map__sqspacing,
    wp::array_t<wp::int32> var_voxel_map__counts,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voxel_map__offsets,
    wp::array_t<wp::int32> var_voxel_map__totals,
    wp::array_t<wp::int64> var_voxel_map__changes__latest,
    wp::int64 var_voxel_map__changes__number)
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
        wp::int64 var_2;
        wp::int64 var_3;
        wp::int32 var_4;
        wp::int32 var_5;
        wp::int32* var_6;
        wp::int32 var_7;
        wp::int32 var_8;
        wp::int32* var_9;
        wp::int32 var_10;
        wp::int32 var_11;
        const wp::int32 var_12 = 0;
        bool var_13;
        wp::int32* var_14;
        const wp::int32 var_15 = 1;
        wp::int32 var_16;
        wp::int32* var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        //---------
        // forward
        // def insert_touched_kernel(touched__order, touched__starts, touched__voxels, new_offsets, voxel_map__room, voxel_map__sqspacing, voxel_map__counts, voxel_map__offsets, voxel_map__totals, voxel_map__changes__latest, voxel_map__changes__number):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // note_change(i, voxel_map__changes__latest, voxel_map__changes__number)                 <L 3>
        note_change_0(var_0, var_voxel_map__changes__latest, var_voxel_map__changes__number);
        // known = voxel_map__totals[1 - int(voxel_map__changes__number & int64(1))]              <L 4>
        var_2 = 1ll;
        var_3 = wp::bit_and(var_voxel_map__changes__number, var_2);
        var_4 = wp::int(var_3);
        var_5 = wp::sub(var_1, var_4);
        var_6 = wp::address(var_voxel_map__totals, var_5);
        var_8 = wp::load(var_6);
        var_7 = wp::copy(var_8);
        // voxel = touched__voxels[i]                                                             <L 5>
        var_9 = wp::address(var_touched__voxels, var_0);
        var_11 = wp::load(var_9);
        var_10 = wp::copy(var_11);
        // if voxel >= 0:                                                                         <L 6>
        var_13 = (var_10 >= var_12);
        if (var_13) {
            // take_points(voxel, known, touched__starts[i], touched__starts[i + 1], touched__order, new_offsets, voxel_map__room, voxel_map__sqspacing, voxel_map__counts, voxel_map__offsets)       <L 7>
            var_14 = wp::address(var_touched__starts, var_0);
            var_16 = wp::add(var_0, var_15);
            var_17 = wp::address(var_touched__starts, var_16);
            var_18 = wp::load(var_14);
            var_19 = wp::load(var_17);
            take_points_0(var_10, var_7, var_18, var_19, var_touched__order, var_new_offsets, var_voxel_map__room, var_voxel_map__sqspacing, var_voxel_map__counts, var_voxel_map__offsets);
        }
}



extern "C" __global__ void mark_near_voxels_kernel_9460f872_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::float64 var_voxel_map__voxel_size,
    wp::array_t<wp::int64> var_voxel_map__keys,
    wp::vec_t<3, wp::float64> var_center,
    wp::float64 var_limit,
    wp::array_t<wp::uint8> var_marks)
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
        wp::vec_t<3, wp::int32> var_2;
        wp::int64 var_3;
        const wp::int32 var_4 = 0;
        wp::int32 var_5;
        wp::float64 var_6;
        wp::float64 var_7;
        wp::float64 var_8;
        wp::float64 var_9;
        const wp::int32 var_10 = 0;
        wp::float64 var_11;
        wp::float64 var_12;
        const wp::int32 var_13 = 1;
        wp::int32 var_14;
        wp::float64 var_15;
        wp::float64 var_16;
        wp::float64 var_17;
        wp::float64 var_18;
        const wp::int32 var_19 = 1;
        wp::float64 var_20;
        wp::float64 var_21;
        const wp::int32 var_22 = 2;
        wp::int32 var_23;
        wp::float64 var_24;
        wp::float64 var_25;
        wp::float64 var_26;
        wp::float64 var_27;
        const wp::int32 var_28 = 2;
        wp::float64 var_29;
        wp::float64 var_30;
        const wp::int32 var_31 = 0;
        wp::int32 var_32;
        wp::float64 var_33;
        wp::float64 var_34;
        wp::float64 var_35;
        wp::float64 var_36;
        wp::float64 var_37;
        wp::float64 var_38;
        bool var_39;
        const wp::int32 var_40 = 1;
        wp::int32 var_41;
        wp::uint8 var_42;
        //---------
        // forward
        // def mark_near_voxels_kernel(voxel_map__voxel_size, voxel_map__keys, center, limit, marks):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // cell = key_block(voxel_map__keys[i])                                                   <L 4>
        var_1 = wp::address(var_voxel_map__keys, var_0);
        var_3 = wp::load(var_1);
        var_2 = key_block_0(var_3);
        // x = (float64(cell[0]) + float64(0.5)) * voxel_map__voxel_size - center[0]              <L 5>
        var_5 = wp::extract(var_2, var_4);
        var_6 = wp::float64(var_5);
        var_7 = 0.5;
        var_8 = wp::add(var_6, var_7);
        var_9 = wp::mul(var_8, var_voxel_map__voxel_size);
        var_11 = wp::extract(var_center, var_10);
        var_12 = wp::sub(var_9, var_11);
        // y = (float64(cell[1]) + float64(0.5)) * voxel_map__voxel_size - center[1]              <L 6>
        var_14 = wp::extract(var_2, var_13);
        var_15 = wp::float64(var_14);
        var_16 = 0.5;
        var_17 = wp::add(var_15, var_16);
        var_18 = wp::mul(var_17, var_voxel_map__voxel_size);
        var_20 = wp::extract(var_center, var_19);
        var_21 = wp::sub(var_18, var_20);
        // z = (float64(cell[2]) + float64(0.5)) * voxel_map__voxel_size - center[2]              <L 7>
        var_23 = wp::extract(var_2, var_22);
        var_24 = wp::float64(var_23);
        var_25 = 0.5;
        var_26 = wp::add(var_24, var_25);
        var_27 = wp::mul(var_26, var_voxel_map__voxel_size);
        var_29 = wp::extract(var_center, var_28);
        var_30 = wp::sub(var_27, var_29);
        // is_near = int(0)                                                                       <L 8>
        var_32 = wp::int(var_31);
        // if x * x + y * y + z * z <= limit * limit:                                             <L 9>
        var_33 = wp::mul(var_12, var_12);
        var_34 = wp::mul(var_21, var_21);
        var_35 = wp::add(var_33, var_34);
        var_36 = wp::mul(var_30, var_30);
        var_37 = wp::add(var_35, var_36);
        var_38 = wp::mul(var_limit, var_limit);
        var_39 = (var_37 <= var_38);
        if (var_39) {
            // is_near = 1                                                                        <L 10>
        }
        var_41 = wp::where(var_39, var_40, var_32);
        // marks[i] = uint8(is_near)                                                              <L 11>
        var_42 = wp::uint8(var_41);
        wp::array_store(var_marks, var_0, var_42);
}



extern "C" __global__ void store_voxels_kernel_b2e40300_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int64> var_keys,
    wp::int32 var_after,
    wp::array_t<wp::int32> var_totals,
    wp::array_t<wp::int64> var_table__keys,
    wp::array_t<wp::int32> var_table__positions,
    wp::int64 var_table__mask)
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
        bool var_2;
        wp::int32 var_3;
        wp::int64* var_4;
        wp::int32 var_5;
        wp::int64 var_6;
        //---------
        // forward
        // def store_voxels_kernel(keys, after, totals, table__keys, table__positions, table__mask):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // if i < totals[after]:                                                                  <L 4>
        var_1 = wp::address(var_totals, var_after);
        var_3 = wp::load(var_1);
        var_2 = (var_0 < var_3);
        if (var_2) {
            // table__positions[find_slot(keys[i], table__keys, table__mask)] = i                 <L 5>
            var_4 = wp::address(var_keys, var_0);
            var_6 = wp::load(var_4);
            var_5 = find_slot_0(var_6, var_table__keys, var_table__mask);
            wp::array_store(var_table__positions, var_5, var_0);
        }
}



extern "C" __global__ void gather_keys_kernel_c993f20f_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int64> var_keys,
    wp::array_t<wp::int32> var_rows,
    wp::int32 var_first,
    wp::array_t<wp::int64> var_out)
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
        wp::int64* var_3;
        wp::int64 var_4;
        wp::int64 var_5;
        wp::int32 var_6;
        //---------
        // forward
        // def gather_keys_kernel(keys: array(dtype=int64), rows: array(dtype=int32), first: int, out: array(dtype=int64)):       <L 318>
        // i = tid()                                                                              <L 319>
        var_0 = builtin_tid1d();
        // out[first + i] = keys[rows[i]]                                                         <L 320>
        var_1 = wp::address(var_rows, var_0);
        var_2 = wp::load(var_1);
        var_3 = wp::address(var_keys, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::copy(var_5);
        var_6 = wp::add(var_first, var_0);
        wp::array_store(var_out, var_6, var_4);
}



extern "C" __global__ void number_voxels_kernel_e0a1929a_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int64> var_touched__keys,
    wp::array_t<wp::int32> var_touched__summary,
    wp::array_t<wp::int32> var_touched__voxels,
    wp::array_t<wp::int32> var_touched__fresh,
    wp::vec_t<3, wp::int32> var_cells__first,
    wp::int32 var_cells__bits,
    wp::int64 var_cells__skipped,
    wp::int32 var_after,
    wp::array_t<wp::int32> var_totals,
    wp::array_t<wp::int64> var_keys,
    wp::array_t<wp::int64> var_table__keys,
    wp::int64 var_table__mask)
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
        wp::int32* var_3;
        wp::int32 var_4;
        wp::int32 var_5;
        wp::int32* var_6;
        const wp::int32 var_7 = -1;
        bool var_8;
        wp::int32 var_9;
        wp::int32* var_10;
        wp::int32 var_11;
        wp::int32 var_12;
        const wp::int32 var_13 = 1;
        wp::int32 var_14;
        wp::int64 var_15;
        const wp::int32 var_16 = 0;
        bool var_17;
        wp::shape_t* var_18;
        const wp::int32 var_19 = 0;
        wp::int32 var_20;
        wp::shape_t var_21;
        const wp::int32 var_22 = 1;
        wp::int32 var_23;
        wp::int32* var_24;
        wp::int32 var_25;
        wp::int32 var_26;
        //---------
        // forward
        // def number_voxels_kernel(touched__keys, touched__summary, touched__voxels, touched__fresh, cells__first, cells__bits, cells__skipped, after, totals, keys, table__keys, table__mask):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // known = totals[1 - after]                                                              <L 4>
        var_2 = wp::sub(var_1, var_after);
        var_3 = wp::address(var_totals, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::copy(var_5);
        // if touched__voxels[i] == -1:                                                           <L 5>
        var_6 = wp::address(var_touched__voxels, var_0);
        var_9 = wp::load(var_6);
        var_8 = (var_9 == var_7);
        if (var_8) {
            // voxel = known + touched__fresh[i] - 1                                              <L 6>
            var_10 = wp::address(var_touched__fresh, var_0);
            var_12 = wp::load(var_10);
            var_11 = wp::add(var_4, var_12);
            var_14 = wp::sub(var_11, var_13);
            // key = touched_key(i, touched__keys, touched__summary, cells__first, cells__bits, cells__skipped)       <L 7>
            var_15 = touched_key_0(var_0, var_touched__keys, var_touched__summary, var_cells__first, var_cells__bits, var_cells__skipped);
            // touched__voxels[i] = voxel                                                         <L 8>
            wp::array_store(var_touched__voxels, var_0, var_14);
            // keys[voxel] = key                                                                  <L 9>
            wp::array_store(var_keys, var_14, var_15);
            // insert_key(key, table__keys, table__mask)                                          <L 10>
            insert_key_0(var_15, var_table__keys, var_table__mask);
        }
        // if i == 0:                                                                             <L 11>
        var_17 = (var_0 == var_16);
        if (var_17) {
            // totals[after] = known + touched__fresh[touched__fresh.shape[0] - 1]                <L 12>
            var_18 = &(var_touched__fresh.shape);
            var_21 = wp::load(var_18);
            var_20 = wp::extract(var_21, var_19);
            var_23 = wp::sub(var_20, var_22);
            var_24 = wp::address(var_touched__fresh, var_23);
            var_26 = wp::load(var_24);
            var_25 = wp::add(var_4, var_26);
            wp::array_store(var_totals, var_after, var_25);
        }
}


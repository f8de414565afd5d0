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


// <pointloom.kernels.volumes.block_rows.word_near>:1
static CUDA_CALLABLE wp::int32 word_near_0(
    wp::array_t<wp::int32> var_words,
    wp::int32 var_block,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::int32 var_dz,
    wp::array_t<wp::int32> var_seen__neighbors)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 0;
    wp::int32 var_2;
    const wp::int32 var_3 = 0;
    bool var_4;
    wp::int32* var_5;
    wp::int32 var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    //---------
    // forward
    // def word_near(words, block, x, y, dz, seen__neighbors):                                <L 1>
    // row = row_near(block, x, y, dz, seen__neighbors)                                       <L 3>
    var_0 = row_near_0(var_block, var_x, var_y, var_dz, var_seen__neighbors);
    // word = int(0)                                                                          <L 4>
    var_2 = wp::int(var_1);
    // if row >= 0:                                                                           <L 5>
    var_4 = (var_0 >= var_3);
    if (var_4) {
        // word = words[row]                                                                  <L 6>
        var_5 = wp::address(var_words, var_0);
        var_7 = wp::load(var_5);
        var_6 = wp::copy(var_7);
    }
    var_8 = wp::where(var_4, var_6, var_2);
    // return word                                                                            <L 7>
    return var_8;
}


// /work/main/src/pointloom/kernels/volumes/block_surface.py:24
static CUDA_CALLABLE wp::int32 case_of_0(
    wp::int32 var_s00,
    wp::int32 var_s10,
    wp::int32 var_s01,
    wp::int32 var_s11,
    wp::int32 var_z)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 1;
    wp::int32 var_2;
    wp::int32 var_3;
    const wp::int32 var_4 = 1;
    wp::int32 var_5;
    const wp::int32 var_6 = 1;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 1;
    wp::int32 var_11;
    const wp::int32 var_12 = 2;
    wp::int32 var_13;
    wp::int32 var_14;
    wp::int32 var_15;
    const wp::int32 var_16 = 1;
    wp::int32 var_17;
    const wp::int32 var_18 = 3;
    wp::int32 var_19;
    wp::int32 var_20;
    const wp::int32 var_21 = 1;
    wp::int32 var_22;
    wp::int32 var_23;
    const wp::int32 var_24 = 1;
    wp::int32 var_25;
    wp::int32 var_26;
    const wp::int32 var_27 = 1;
    wp::int32 var_28;
    const wp::int32 var_29 = 1;
    wp::int32 var_30;
    wp::int32 var_31;
    wp::int32 var_32;
    const wp::int32 var_33 = 1;
    wp::int32 var_34;
    const wp::int32 var_35 = 2;
    wp::int32 var_36;
    wp::int32 var_37;
    wp::int32 var_38;
    const wp::int32 var_39 = 1;
    wp::int32 var_40;
    const wp::int32 var_41 = 3;
    wp::int32 var_42;
    wp::int32 var_43;
    const wp::int32 var_44 = 4;
    wp::int32 var_45;
    wp::int32 var_46;
    //---------
    // forward
    // def case_of(s00: int, s10: int, s01: int, s11: int, z: int) -> int:                    <L 25>
    // low = ((s00 >> z) & 1) | (((s10 >> z) & 1) << 1) | (((s01 >> z) & 1) << 2) | (((s11 >> z) & 1) << 3)       <L 27>
    var_0 = wp::rshift(var_s00, var_z);
    var_2 = wp::bit_and(var_0, var_1);
    var_3 = wp::rshift(var_s10, var_z);
    var_5 = wp::bit_and(var_3, var_4);
    var_7 = wp::lshift(var_5, var_6);
    var_8 = wp::bit_or(var_2, var_7);
    var_9 = wp::rshift(var_s01, var_z);
    var_11 = wp::bit_and(var_9, var_10);
    var_13 = wp::lshift(var_11, var_12);
    var_14 = wp::bit_or(var_8, var_13);
    var_15 = wp::rshift(var_s11, var_z);
    var_17 = wp::bit_and(var_15, var_16);
    var_19 = wp::lshift(var_17, var_18);
    var_20 = wp::bit_or(var_14, var_19);
    // up = z + 1                                                                             <L 28>
    var_22 = wp::add(var_z, var_21);
    // high = ((s00 >> up) & 1) | (((s10 >> up) & 1) << 1) | (((s01 >> up) & 1) << 2) | (((s11 >> up) & 1) << 3)       <L 29>
    var_23 = wp::rshift(var_s00, var_22);
    var_25 = wp::bit_and(var_23, var_24);
    var_26 = wp::rshift(var_s10, var_22);
    var_28 = wp::bit_and(var_26, var_27);
    var_30 = wp::lshift(var_28, var_29);
    var_31 = wp::bit_or(var_25, var_30);
    var_32 = wp::rshift(var_s01, var_22);
    var_34 = wp::bit_and(var_32, var_33);
    var_36 = wp::lshift(var_34, var_35);
    var_37 = wp::bit_or(var_31, var_36);
    var_38 = wp::rshift(var_s11, var_22);
    var_40 = wp::bit_and(var_38, var_39);
    var_42 = wp::lshift(var_40, var_41);
    var_43 = wp::bit_or(var_37, var_42);
    // return low | (high << 4)                                                               <L 30>
    var_45 = wp::lshift(var_43, var_44);
    var_46 = wp::bit_or(var_20, var_45);
    return var_46;
}


// <pointloom.kernels.volumes.block_surface.vertex_of>:1
static CUDA_CALLABLE wp::int32 vertex_of_0(
    wp::int32 var_row,
    wp::int32 var_axis,
    wp::int32 var_z,
    wp::array_t<wp::int32> var_surface__edges,
    wp::array_t<wp::int32> var_surface__offsets)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 8;
    wp::int32 var_1;
    wp::int32 var_2;
    wp::int32* var_3;
    wp::int32* var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    //---------
    // forward
    // def vertex_of(row, axis, z, surface__edges, surface__offsets):                         <L 1>
    // bit = axis * SIDE + z                                                                  <L 2>
    var_1 = wp::mul(var_axis, var_0);
    var_2 = wp::add(var_1, var_z);
    // return surface__offsets[row] + bit_count(surface__edges[row] & (1 << bit) - 1)         <L 3>
    var_3 = wp::address(var_surface__offsets, var_row);
    var_4 = wp::address(var_surface__edges, var_row);
    var_6 = wp::lshift(var_5, var_2);
    var_8 = wp::sub(var_6, var_7);
    var_10 = wp::load(var_4);
    var_9 = wp::bit_and(var_10, var_8);
    var_11 = wp::bit_count(var_9);
    var_13 = wp::load(var_3);
    var_12 = wp::add(var_13, var_11);
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


// <pointloom.kernels.volumes.block_surface.cells_near>:1
static CUDA_CALLABLE wp::int32 cells_near_0(
    wp::int32 var_block,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::array_t<wp::int32> var_surface__seen__neighbors,
    wp::array_t<wp::int32> var_surface__cells)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    //---------
    // forward
    // def cells_near(block, x, y, surface__seen__neighbors, surface__cells):                 <L 1>
    // return word_near(surface__cells, block, x, y, 0, surface__seen__neighbors)             <L 2>
    var_1 = word_near_0(var_surface__cells, var_block, var_x, var_y, var_0, var_surface__seen__neighbors);
    return var_1;
}


// <pointloom.kernels.volumes.block_surface.cells_beside>:1
static CUDA_CALLABLE wp::int32 cells_beside_0(
    wp::int32 var_block,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::array_t<wp::int32> var_surface__seen__neighbors,
    wp::array_t<wp::int32> var_surface__cells)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = -1;
    wp::int32 var_2;
    const wp::int32 var_3 = 1;
    wp::int32 var_4;
    wp::int32 var_5;
    const wp::int32 var_6 = 8;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::int32 var_10;
    const wp::int32 var_11 = 255;
    wp::int32 var_12;
    //---------
    // forward
    // def cells_beside(block, x, y, surface__seen__neighbors, surface__cells):               <L 1>
    // here = cells_near(block, x, y, surface__seen__neighbors, surface__cells)               <L 3>
    var_0 = cells_near_0(var_block, var_x, var_y, var_surface__seen__neighbors, var_surface__cells);
    // below = word_near(surface__cells, block, x, y, -1, surface__seen__neighbors)           <L 4>
    var_2 = word_near_0(var_surface__cells, var_block, var_x, var_y, var_1, var_surface__seen__neighbors);
    // return (here | here << 1 | below >> SIDE - 1) & EIGHT                                  <L 5>
    var_4 = wp::lshift(var_0, var_3);
    var_5 = wp::bit_or(var_0, var_4);
    var_8 = wp::sub(var_6, var_7);
    var_9 = wp::rshift(var_2, var_8);
    var_10 = wp::bit_or(var_5, var_9);
    var_12 = wp::bit_and(var_10, var_11);
    return var_12;
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


// <pointloom.kernels.volumes.block_surface.gradient_along>:1
static CUDA_CALLABLE wp::float32 gradient_along_0(
    wp::int32 var_low,
    wp::float32 var_here,
    wp::int32 var_high,
    wp::array_t<wp::float32> var_blocks__distances,
    wp::array_t<wp::uint16> var_blocks__weights)
{
    //---------
    // primal vars
    wp::float32 var_0;
    wp::float32 var_1;
    const wp::float32 var_2 = 0.0;
    wp::float32 var_3;
    const wp::int32 var_4 = 0;
    bool var_5;
    wp::uint16* var_6;
    const wp::int32 var_7 = 0;
    wp::uint16 var_8;
    bool var_9;
    wp::uint16 var_10;
    wp::float32* var_11;
    wp::float32 var_12;
    wp::float32 var_13;
    const wp::float32 var_14 = 1.0;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    const wp::int32 var_20 = 0;
    bool var_21;
    wp::uint16* var_22;
    const wp::int32 var_23 = 0;
    wp::uint16 var_24;
    bool var_25;
    wp::uint16 var_26;
    wp::float32* var_27;
    wp::float32 var_28;
    wp::float32 var_29;
    const wp::float32 var_30 = 1.0;
    wp::float32 var_31;
    wp::float32 var_32;
    wp::float32 var_33;
    wp::float32 var_34;
    wp::float32 var_35;
    const wp::float32 var_36 = 0.0;
    wp::float32 var_37;
    const wp::float32 var_38 = 0.0;
    bool var_39;
    wp::float32 var_40;
    wp::float32 var_41;
    wp::float32 var_42;
    //---------
    // forward
    // def gradient_along(low, here, high, blocks__distances, blocks__weights):               <L 1>
    // a = here                                                                               <L 3>
    var_0 = wp::copy(var_here);
    // b = here                                                                               <L 4>
    var_1 = wp::copy(var_here);
    // span = float(0.0)                                                                      <L 5>
    var_3 = wp::float(var_2);
    // if low >= 0:                                                                           <L 6>
    var_5 = (var_low >= var_4);
    if (var_5) {
        // if blocks__weights[low] > uint16(0):                                               <L 7>
        var_6 = wp::address(var_blocks__weights, var_low);
        var_8 = wp::uint16(var_7);
        var_10 = wp::load(var_6);
        var_9 = (var_10 > var_8);
        if (var_9) {
            // a = blocks__distances[low]                                                     <L 8>
            var_11 = wp::address(var_blocks__distances, var_low);
            var_13 = wp::load(var_11);
            var_12 = wp::copy(var_13);
            // span += 1.0                                                                    <L 9>
            var_15 = wp::add(var_3, var_14);
        }
        var_16 = wp::where(var_9, var_12, var_0);
        var_17 = wp::where(var_9, var_15, var_3);
    }
    var_18 = wp::where(var_5, var_16, var_0);
    var_19 = wp::where(var_5, var_17, var_3);
    // if high >= 0:                                                                          <L 10>
    var_21 = (var_high >= var_20);
    if (var_21) {
        // if blocks__weights[high] > uint16(0):                                              <L 11>
        var_22 = wp::address(var_blocks__weights, var_high);
        var_24 = wp::uint16(var_23);
        var_26 = wp::load(var_22);
        var_25 = (var_26 > var_24);
        if (var_25) {
            // b = blocks__distances[high]                                                    <L 12>
            var_27 = wp::address(var_blocks__distances, var_high);
            var_29 = wp::load(var_27);
            var_28 = wp::copy(var_29);
            // span += 1.0                                                                    <L 13>
            var_31 = wp::add(var_19, var_30);
        }
        var_32 = wp::where(var_25, var_28, var_1);
        var_33 = wp::where(var_25, var_31, var_19);
    }
    var_34 = wp::where(var_21, var_32, var_1);
    var_35 = wp::where(var_21, var_33, var_19);
    // slope = float(0.0)                                                                     <L 14>
    var_37 = wp::float(var_36);
    // if span > 0.0:                                                                         <L 15>
    var_39 = (var_35 > var_38);
    if (var_39) {
        // slope = (b - a) / span                                                             <L 16>
        var_40 = wp::sub(var_34, var_18);
        var_41 = wp::div(var_40, var_35);
    }
    var_42 = wp::where(var_39, var_41, var_37);
    // return slope                                                                           <L 17>
    return var_42;
}


// <pointloom.kernels.volumes.block_surface.gradient_at>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float32> gradient_at_0(
    wp::int32 var_block,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::int32 var_z,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::array_t<wp::int32> var_seen__neighbors)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::float32* var_1;
    wp::float32 var_2;
    wp::float32 var_3;
    const wp::int32 var_4 = 1;
    wp::int32 var_5;
    wp::int32 var_6;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 1;
    wp::int32 var_12;
    wp::int32 var_13;
    const wp::int32 var_14 = 1;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::float32 var_17;
    const wp::int32 var_18 = 1;
    wp::int32 var_19;
    wp::int32 var_20;
    const wp::int32 var_21 = 1;
    wp::int32 var_22;
    wp::int32 var_23;
    wp::float32 var_24;
    wp::vec_t<3, wp::float32> var_25;
    //---------
    // forward
    // def gradient_at(block, x, y, z, seen__blocks__distances, seen__blocks__weights, seen__neighbors):       <L 1>
    // here = seen__blocks__distances[voxel_near(block, x, y, z, seen__neighbors)]            <L 2>
    var_0 = voxel_near_0(var_block, var_x, var_y, var_z, var_seen__neighbors);
    var_1 = wp::address(var_seen__blocks__distances, var_0);
    var_3 = wp::load(var_1);
    var_2 = wp::copy(var_3);
    // low = voxel_near(block, x - 1, y, z, seen__neighbors)                                  <L 3>
    var_5 = wp::sub(var_x, var_4);
    var_6 = voxel_near_0(var_block, var_5, var_y, var_z, var_seen__neighbors);
    // gx = gradient_along(low, here, voxel_near(block, x + 1, y, z, seen__neighbors), seen__blocks__distances, seen__blocks__weights)       <L 4>
    var_8 = wp::add(var_x, var_7);
    var_9 = voxel_near_0(var_block, var_8, var_y, var_z, var_seen__neighbors);
    var_10 = gradient_along_0(var_6, var_2, var_9, var_seen__blocks__distances, var_seen__blocks__weights);
    // low = voxel_near(block, x, y - 1, z, seen__neighbors)                                  <L 5>
    var_12 = wp::sub(var_y, var_11);
    var_13 = voxel_near_0(var_block, var_x, var_12, var_z, var_seen__neighbors);
    // gy = gradient_along(low, here, voxel_near(block, x, y + 1, z, seen__neighbors), seen__blocks__distances, seen__blocks__weights)       <L 6>
    var_15 = wp::add(var_y, var_14);
    var_16 = voxel_near_0(var_block, var_x, var_15, var_z, var_seen__neighbors);
    var_17 = gradient_along_0(var_13, var_2, var_16, var_seen__blocks__distances, var_seen__blocks__weights);
    // low = voxel_near(block, x, y, z - 1, seen__neighbors)                                  <L 7>
    var_19 = wp::sub(var_z, var_18);
    var_20 = voxel_near_0(var_block, var_x, var_y, var_19, var_seen__neighbors);
    // gz = gradient_along(low, here, voxel_near(block, x, y, z + 1, seen__neighbors), seen__blocks__distances, seen__blocks__weights)       <L 8>
    var_22 = wp::add(var_z, var_21);
    var_23 = voxel_near_0(var_block, var_x, var_y, var_22, var_seen__neighbors);
    var_24 = gradient_along_0(var_20, var_2, var_23, var_seen__blocks__distances, var_seen__blocks__weights);
    // return vec3(gx, gy, gz)                                                                <L 9>
    var_25 = wp::vec_t<3, wp::float32>(var_10, var_17, var_24);
    return var_25;
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


// <pointloom.kernels.volumes.block_rows.word_near>:1
static CUDA_CALLABLE void adj_word_near_0(
    wp::array_t<wp::int32> var_words,
    wp::int32 var_block,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::int32 var_dz,
    wp::array_t<wp::int32> var_seen__neighbors,
    wp::array_t<wp::int32> & adj_words,
    wp::int32 & adj_block,
    wp::int32 & adj_x,
    wp::int32 & adj_y,
    wp::int32 & adj_dz,
    wp::array_t<wp::int32> & adj_seen__neighbors,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/volumes/block_surface.py:24
static CUDA_CALLABLE void adj_case_of_0(
    wp::int32 var_s00,
    wp::int32 var_s10,
    wp::int32 var_s01,
    wp::int32 var_s11,
    wp::int32 var_z,
    wp::int32 & adj_s00,
    wp::int32 & adj_s10,
    wp::int32 & adj_s01,
    wp::int32 & adj_s11,
    wp::int32 & adj_z,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.block_surface.vertex_of>:1
static CUDA_CALLABLE void adj_vertex_of_0(
    wp::int32 var_row,
    wp::int32 var_axis,
    wp::int32 var_z,
    wp::array_t<wp::int32> var_surface__edges,
    wp::array_t<wp::int32> var_surface__offsets,
    wp::int32 & adj_row,
    wp::int32 & adj_axis,
    wp::int32 & adj_z,
    wp::array_t<wp::int32> & adj_surface__edges,
    wp::array_t<wp::int32> & adj_surface__offsets,
    wp::int32 & adj_ret)
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


// <pointloom.kernels.volumes.block_surface.cells_near>:1
static CUDA_CALLABLE void adj_cells_near_0(
    wp::int32 var_block,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::array_t<wp::int32> var_surface__seen__neighbors,
    wp::array_t<wp::int32> var_surface__cells,
    wp::int32 & adj_block,
    wp::int32 & adj_x,
    wp::int32 & adj_y,
    wp::array_t<wp::int32> & adj_surface__seen__neighbors,
    wp::array_t<wp::int32> & adj_surface__cells,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.block_surface.cells_beside>:1
static CUDA_CALLABLE void adj_cells_beside_0(
    wp::int32 var_block,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::array_t<wp::int32> var_surface__seen__neighbors,
    wp::array_t<wp::int32> var_surface__cells,
    wp::int32 & adj_block,
    wp::int32 & adj_x,
    wp::int32 & adj_y,
    wp::array_t<wp::int32> & adj_surface__seen__neighbors,
    wp::array_t<wp::int32> & adj_surface__cells,
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


// <pointloom.kernels.volumes.block_surface.gradient_along>:1
static CUDA_CALLABLE void adj_gradient_along_0(
    wp::int32 var_low,
    wp::float32 var_here,
    wp::int32 var_high,
    wp::array_t<wp::float32> var_blocks__distances,
    wp::array_t<wp::uint16> var_blocks__weights,
    wp::int32 & adj_low,
    wp::float32 & adj_here,
    wp::int32 & adj_high,
    wp::array_t<wp::float32> & adj_blocks__distances,
    wp::array_t<wp::uint16> & adj_blocks__weights,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.block_surface.gradient_at>:1
static CUDA_CALLABLE void adj_gradient_at_0(
    wp::int32 var_block,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::int32 var_z,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::array_t<wp::int32> var_seen__neighbors,
    wp::int32 & adj_block,
    wp::int32 & adj_x,
    wp::int32 & adj_y,
    wp::int32 & adj_z,
    wp::array_t<wp::float32> & adj_seen__blocks__distances,
    wp::array_t<wp::uint16> & adj_seen__blocks__weights,
    wp::array_t<wp::int32> & adj_seen__neighbors,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void emit_triangles_kernel_31657cba_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_surface__seen__neighbors,
    wp::array_t<wp::int32> var_surface__words,
    wp::array_t<wp::int32> var_surface__cells,
    wp::array_t<wp::int32> var_surface__edges,
    wp::int32 var_surface__rows,
    wp::array_t<wp::int32> var_surface__offsets,
    wp::array_t<wp::int32> var_surface__tables__triangle_count,
    wp::array_t<wp::int32> var_surface__tables__triangle_edges,
    wp::array_t<wp::int32> var_surface__tables__edge_corner,
    wp::array_t<wp::int32> var_surface__tables__edge_axis,
    wp::array_t<wp::vec_t<3, wp::int32>> var_triangles)
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
        const wp::int32 var_4 = 0;
        bool var_5;
        const wp::int32 var_6 = 64;
        wp::int32 var_7;
        const wp::int32 var_8 = 8;
        wp::int32 var_9;
        wp::int32 var_10;
        wp::int32 var_11;
        const wp::int32 var_12 = 1;
        wp::int32 var_13;
        const wp::int32 var_14 = 0;
        wp::int32 var_15;
        const wp::int32 var_16 = 1;
        wp::int32 var_17;
        const wp::int32 var_18 = 0;
        wp::int32 var_19;
        const wp::int32 var_20 = 1;
        wp::int32 var_21;
        const wp::int32 var_22 = 1;
        wp::int32 var_23;
        const wp::int32 var_24 = 0;
        wp::int32 var_25;
        wp::int32 var_26;
        wp::int32* var_27;
        wp::int32* var_28;
        wp::int32 var_29;
        wp::int32 var_30;
        wp::int32 var_31;
        const wp::int32 var_32 = 0;
        wp::int32 var_33;
        const wp::int32 var_34 = 1;
        wp::int32 var_35;
        const wp::int32 var_36 = 1;
        bool var_37;
        wp::int32* var_38;
        wp::int32 var_39;
        wp::int32 var_40;
        wp::int32* var_41;
        wp::range_t var_42;
        wp::int32 var_43;
        wp::int32 var_44;
        const wp::int32 var_45 = 0;
        const wp::int32 var_46 = 0;
        const wp::int32 var_47 = 0;
        wp::vec_t<3, wp::int32> var_48;
        const wp::int32 var_49 = 0;
        const wp::int32 var_50 = 15;
        wp::int32 var_51;
        const wp::int32 var_52 = 3;
        wp::int32 var_53;
        wp::int32 var_54;
        wp::int32 var_55;
        wp::int32* var_56;
        wp::int32 var_57;
        wp::int32 var_58;
        wp::int32* var_59;
        wp::int32 var_60;
        wp::int32 var_61;
        const wp::int32 var_62 = 2;
        wp::int32 var_63;
        const wp::int32 var_64 = 1;
        wp::int32 var_65;
        wp::int32 var_66;
        wp::int32 var_67;
        const wp::int32 var_68 = 1;
        wp::int32 var_69;
        wp::int32 var_70;
        const wp::int32 var_71 = 1;
        wp::int32 var_72;
        const wp::int32 var_73 = 1;
        wp::int32 var_74;
        wp::int32 var_75;
        wp::int32 var_76;
        wp::int32* var_77;
        wp::int32 var_78;
        wp::int32 var_79;
        wp::int32 var_80;
        wp::int32 var_81;
        const wp::int32 var_82 = 1;
        wp::int32 var_83;
        const wp::int32 var_84 = 3;
        wp::int32 var_85;
        wp::int32 var_86;
        wp::int32 var_87;
        wp::int32* var_88;
        wp::int32 var_89;
        wp::int32 var_90;
        wp::int32* var_91;
        wp::int32 var_92;
        wp::int32 var_93;
        const wp::int32 var_94 = 2;
        wp::int32 var_95;
        const wp::int32 var_96 = 1;
        wp::int32 var_97;
        wp::int32 var_98;
        wp::int32 var_99;
        const wp::int32 var_100 = 1;
        wp::int32 var_101;
        wp::int32 var_102;
        const wp::int32 var_103 = 1;
        wp::int32 var_104;
        const wp::int32 var_105 = 1;
        wp::int32 var_106;
        wp::int32 var_107;
        wp::int32 var_108;
        wp::int32* var_109;
        wp::int32 var_110;
        wp::int32 var_111;
        wp::int32 var_112;
        wp::int32 var_113;
        const wp::int32 var_114 = 2;
        wp::int32 var_115;
        const wp::int32 var_116 = 3;
        wp::int32 var_117;
        wp::int32 var_118;
        wp::int32 var_119;
        wp::int32* var_120;
        wp::int32 var_121;
        wp::int32 var_122;
        wp::int32* var_123;
        wp::int32 var_124;
        wp::int32 var_125;
        const wp::int32 var_126 = 2;
        wp::int32 var_127;
        const wp::int32 var_128 = 1;
        wp::int32 var_129;
        wp::int32 var_130;
        wp::int32 var_131;
        const wp::int32 var_132 = 1;
        wp::int32 var_133;
        wp::int32 var_134;
        const wp::int32 var_135 = 1;
        wp::int32 var_136;
        const wp::int32 var_137 = 1;
        wp::int32 var_138;
        wp::int32 var_139;
        wp::int32 var_140;
        wp::int32* var_141;
        wp::int32 var_142;
        wp::int32 var_143;
        wp::int32 var_144;
        wp::int32 var_145;
        const wp::int32 var_146 = 1;
        wp::int32 var_147;
        const wp::int32 var_148 = 1;
        wp::int32 var_149;
        const wp::int32 var_150 = 1;
        wp::int32 var_151;
        const wp::int32 var_152 = 1;
        bool var_153;
        wp::int32* var_154;
        wp::int32 var_155;
        wp::int32 var_156;
        wp::int32* var_157;
        wp::range_t var_158;
        wp::int32 var_159;
        wp::int32 var_160;
        wp::int32 var_161;
        const wp::int32 var_162 = 0;
        const wp::int32 var_163 = 0;
        const wp::int32 var_164 = 0;
        wp::vec_t<3, wp::int32> var_165;
        const wp::int32 var_166 = 0;
        wp::int32 var_167;
        const wp::int32 var_168 = 3;
        wp::int32 var_169;
        wp::int32 var_170;
        wp::int32 var_171;
        wp::int32* var_172;
        wp::int32 var_173;
        wp::int32 var_174;
        wp::int32* var_175;
        wp::int32 var_176;
        wp::int32 var_177;
        const wp::int32 var_178 = 2;
        wp::int32 var_179;
        const wp::int32 var_180 = 1;
        wp::int32 var_181;
        wp::int32 var_182;
        wp::int32 var_183;
        const wp::int32 var_184 = 1;
        wp::int32 var_185;
        wp::int32 var_186;
        const wp::int32 var_187 = 1;
        wp::int32 var_188;
        const wp::int32 var_189 = 1;
        wp::int32 var_190;
        wp::int32 var_191;
        wp::int32 var_192;
        wp::int32* var_193;
        wp::int32 var_194;
        wp::int32 var_195;
        wp::int32 var_196;
        wp::int32 var_197;
        const wp::int32 var_198 = 1;
        wp::int32 var_199;
        const wp::int32 var_200 = 3;
        wp::int32 var_201;
        wp::int32 var_202;
        wp::int32 var_203;
        wp::int32* var_204;
        wp::int32 var_205;
        wp::int32 var_206;
        wp::int32* var_207;
        wp::int32 var_208;
        wp::int32 var_209;
        const wp::int32 var_210 = 2;
        wp::int32 var_211;
        const wp::int32 var_212 = 1;
        wp::int32 var_213;
        wp::int32 var_214;
        wp::int32 var_215;
        const wp::int32 var_216 = 1;
        wp::int32 var_217;
        wp::int32 var_218;
        const wp::int32 var_219 = 1;
        wp::int32 var_220;
        const wp::int32 var_221 = 1;
        wp::int32 var_222;
        wp::int32 var_223;
        wp::int32 var_224;
        wp::int32* var_225;
        wp::int32 var_226;
        wp::int32 var_227;
        wp::int32 var_228;
        wp::int32 var_229;
        const wp::int32 var_230 = 2;
        wp::int32 var_231;
        const wp::int32 var_232 = 3;
        wp::int32 var_233;
        wp::int32 var_234;
        wp::int32 var_235;
        wp::int32* var_236;
        wp::int32 var_237;
        wp::int32 var_238;
        wp::int32* var_239;
        wp::int32 var_240;
        wp::int32 var_241;
        const wp::int32 var_242 = 2;
        wp::int32 var_243;
        const wp::int32 var_244 = 1;
        wp::int32 var_245;
        wp::int32 var_246;
        wp::int32 var_247;
        const wp::int32 var_248 = 1;
        wp::int32 var_249;
        wp::int32 var_250;
        const wp::int32 var_251 = 1;
        wp::int32 var_252;
        const wp::int32 var_253 = 1;
        wp::int32 var_254;
        wp::int32 var_255;
        wp::int32 var_256;
        wp::int32* var_257;
        wp::int32 var_258;
        wp::int32 var_259;
        wp::int32 var_260;
        wp::int32 var_261;
        const wp::int32 var_262 = 1;
        wp::int32 var_263;
        wp::int32 var_264;
        wp::int32 var_265;
        wp::int32 var_266;
        const wp::int32 var_267 = 2;
        wp::int32 var_268;
        const wp::int32 var_269 = 1;
        wp::int32 var_270;
        const wp::int32 var_271 = 1;
        bool var_272;
        wp::int32* var_273;
        wp::int32 var_274;
        wp::int32 var_275;
        wp::int32* var_276;
        wp::range_t var_277;
        wp::int32 var_278;
        wp::int32 var_279;
        const wp::int32 var_280 = 0;
        const wp::int32 var_281 = 0;
        const wp::int32 var_282 = 0;
        wp::vec_t<3, wp::int32> var_283;
        const wp::int32 var_284 = 0;
        wp::int32 var_285;
        const wp::int32 var_286 = 3;
        wp::int32 var_287;
        wp::int32 var_288;
        wp::int32 var_289;
        wp::int32* var_290;
        wp::int32 var_291;
        wp::int32 var_292;
        wp::int32* var_293;
        wp::int32 var_294;
        wp::int32 var_295;
        const wp::int32 var_296 = 2;
        wp::int32 var_297;
        const wp::int32 var_298 = 1;
        wp::int32 var_299;
        wp::int32 var_300;
        wp::int32 var_301;
        const wp::int32 var_302 = 1;
        wp::int32 var_303;
        wp::int32 var_304;
        const wp::int32 var_305 = 1;
        wp::int32 var_306;
        const wp::int32 var_307 = 1;
        wp::int32 var_308;
        wp::int32 var_309;
        wp::int32 var_310;
        wp::int32* var_311;
        wp::int32 var_312;
        wp::int32 var_313;
        wp::int32 var_314;
        wp::int32 var_315;
        const wp::int32 var_316 = 1;
        wp::int32 var_317;
        const wp::int32 var_318 = 3;
        wp::int32 var_319;
        wp::int32 var_320;
        wp::int32 var_321;
        wp::int32* var_322;
        wp::int32 var_323;
        wp::int32 var_324;
        wp::int32* var_325;
        wp::int32 var_326;
        wp::int32 var_327;
        const wp::int32 var_328 = 2;
        wp::int32 var_329;
        const wp::int32 var_330 = 1;
        wp::int32 var_331;
        wp::int32 var_332;
        wp::int32 var_333;
        const wp::int32 var_334 = 1;
        wp::int32 var_335;
        wp::int32 var_336;
        const wp::int32 var_337 = 1;
        wp::int32 var_338;
        const wp::int32 var_339 = 1;
        wp::int32 var_340;
        wp::int32 var_341;
        wp::int32 var_342;
        wp::int32* var_343;
        wp::int32 var_344;
        wp::int32 var_345;
        wp::int32 var_346;
        wp::int32 var_347;
        const wp::int32 var_348 = 2;
        wp::int32 var_349;
        const wp::int32 var_350 = 3;
        wp::int32 var_351;
        wp::int32 var_352;
        wp::int32 var_353;
        wp::int32* var_354;
        wp::int32 var_355;
        wp::int32 var_356;
        wp::int32* var_357;
        wp::int32 var_358;
        wp::int32 var_359;
        const wp::int32 var_360 = 2;
        wp::int32 var_361;
        const wp::int32 var_362 = 1;
        wp::int32 var_363;
        wp::int32 var_364;
        wp::int32 var_365;
        const wp::int32 var_366 = 1;
        wp::int32 var_367;
        wp::int32 var_368;
        const wp::int32 var_369 = 1;
        wp::int32 var_370;
        const wp::int32 var_371 = 1;
        wp::int32 var_372;
        wp::int32 var_373;
        wp::int32 var_374;
        wp::int32* var_375;
        wp::int32 var_376;
        wp::int32 var_377;
        wp::int32 var_378;
        wp::int32 var_379;
        const wp::int32 var_380 = 1;
        wp::int32 var_381;
        wp::int32 var_382;
        wp::int32 var_383;
        const wp::int32 var_384 = 3;
        wp::int32 var_385;
        const wp::int32 var_386 = 1;
        wp::int32 var_387;
        const wp::int32 var_388 = 1;
        bool var_389;
        wp::int32* var_390;
        wp::int32 var_391;
        wp::int32 var_392;
        wp::int32* var_393;
        wp::range_t var_394;
        wp::int32 var_395;
        wp::int32 var_396;
        const wp::int32 var_397 = 0;
        const wp::int32 var_398 = 0;
        const wp::int32 var_399 = 0;
        wp::vec_t<3, wp::int32> var_400;
        const wp::int32 var_401 = 0;
        wp::int32 var_402;
        const wp::int32 var_403 = 3;
        wp::int32 var_404;
        wp::int32 var_405;
        wp::int32 var_406;
        wp::int32* var_407;
        wp::int32 var_408;
        wp::int32 var_409;
        wp::int32* var_410;
        wp::int32 var_411;
        wp::int32 var_412;
        const wp::int32 var_413 = 2;
        wp::int32 var_414;
        const wp::int32 var_415 = 1;
        wp::int32 var_416;
        wp::int32 var_417;
        wp::int32 var_418;
        const wp::int32 var_419 = 1;
        wp::int32 var_420;
        wp::int32 var_421;
        const wp::int32 var_422 = 1;
        wp::int32 var_423;
        const wp::int32 var_424 = 1;
        wp::int32 var_425;
        wp::int32 var_426;
        wp::int32 var_427;
        wp::int32* var_428;
        wp::int32 var_429;
        wp::int32 var_430;
        wp::int32 var_431;
        wp::int32 var_432;
        const wp::int32 var_433 = 1;
        wp::int32 var_434;
        const wp::int32 var_435 = 3;
        wp::int32 var_436;
        wp::int32 var_437;
        wp::int32 var_438;
        wp::int32* var_439;
        wp::int32 var_440;
        wp::int32 var_441;
        wp::int32* var_442;
        wp::int32 var_443;
        wp::int32 var_444;
        const wp::int32 var_445 = 2;
        wp::int32 var_446;
        const wp::int32 var_447 = 1;
        wp::int32 var_448;
        wp::int32 var_449;
        wp::int32 var_450;
        const wp::int32 var_451 = 1;
        wp::int32 var_452;
        wp::int32 var_453;
        const wp::int32 var_454 = 1;
        wp::int32 var_455;
        const wp::int32 var_456 = 1;
        wp::int32 var_457;
        wp::int32 var_458;
        wp::int32 var_459;
        wp::int32* var_460;
        wp::int32 var_461;
        wp::int32 var_462;
        wp::int32 var_463;
        wp::int32 var_464;
        const wp::int32 var_465 = 2;
        wp::int32 var_466;
        const wp::int32 var_467 = 3;
        wp::int32 var_468;
        wp::int32 var_469;
        wp::int32 var_470;
        wp::int32* var_471;
        wp::int32 var_472;
        wp::int32 var_473;
        wp::int32* var_474;
        wp::int32 var_475;
        wp::int32 var_476;
        const wp::int32 var_477 = 2;
        wp::int32 var_478;
        const wp::int32 var_479 = 1;
        wp::int32 var_480;
        wp::int32 var_481;
        wp::int32 var_482;
        const wp::int32 var_483 = 1;
        wp::int32 var_484;
        wp::int32 var_485;
        const wp::int32 var_486 = 1;
        wp::int32 var_487;
        const wp::int32 var_488 = 1;
        wp::int32 var_489;
        wp::int32 var_490;
        wp::int32 var_491;
        wp::int32* var_492;
        wp::int32 var_493;
        wp::int32 var_494;
        wp::int32 var_495;
        wp::int32 var_496;
        const wp::int32 var_497 = 1;
        wp::int32 var_498;
        wp::int32 var_499;
        wp::int32 var_500;
        const wp::int32 var_501 = 4;
        wp::int32 var_502;
        const wp::int32 var_503 = 1;
        wp::int32 var_504;
        const wp::int32 var_505 = 1;
        bool var_506;
        wp::int32* var_507;
        wp::int32 var_508;
        wp::int32 var_509;
        wp::int32* var_510;
        wp::range_t var_511;
        wp::int32 var_512;
        wp::int32 var_513;
        const wp::int32 var_514 = 0;
        const wp::int32 var_515 = 0;
        const wp::int32 var_516 = 0;
        wp::vec_t<3, wp::int32> var_517;
        const wp::int32 var_518 = 0;
        wp::int32 var_519;
        const wp::int32 var_520 = 3;
        wp::int32 var_521;
        wp::int32 var_522;
        wp::int32 var_523;
        wp::int32* var_524;
        wp::int32 var_525;
        wp::int32 var_526;
        wp::int32* var_527;
        wp::int32 var_528;
        wp::int32 var_529;
        const wp::int32 var_530 = 2;
        wp::int32 var_531;
        const wp::int32 var_532 = 1;
        wp::int32 var_533;
        wp::int32 var_534;
        wp::int32 var_535;
        const wp::int32 var_536 = 1;
        wp::int32 var_537;
        wp::int32 var_538;
        const wp::int32 var_539 = 1;
        wp::int32 var_540;
        const wp::int32 var_541 = 1;
        wp::int32 var_542;
        wp::int32 var_543;
        wp::int32 var_544;
        wp::int32* var_545;
        wp::int32 var_546;
        wp::int32 var_547;
        wp::int32 var_548;
        wp::int32 var_549;
        const wp::int32 var_550 = 1;
        wp::int32 var_551;
        const wp::int32 var_552 = 3;
        wp::int32 var_553;
        wp::int32 var_554;
        wp::int32 var_555;
        wp::int32* var_556;
        wp::int32 var_557;
        wp::int32 var_558;
        wp::int32* var_559;
        wp::int32 var_560;
        wp::int32 var_561;
        const wp::int32 var_562 = 2;
        wp::int32 var_563;
        const wp::int32 var_564 = 1;
        wp::int32 var_565;
        wp::int32 var_566;
        wp::int32 var_567;
        const wp::int32 var_568 = 1;
        wp::int32 var_569;
        wp::int32 var_570;
        const wp::int32 var_571 = 1;
        wp::int32 var_572;
        const wp::int32 var_573 = 1;
        wp::int32 var_574;
        wp::int32 var_575;
        wp::int32 var_576;
        wp::int32* var_577;
        wp::int32 var_578;
        wp::int32 var_579;
        wp::int32 var_580;
        wp::int32 var_581;
        const wp::int32 var_582 = 2;
        wp::int32 var_583;
        const wp::int32 var_584 = 3;
        wp::int32 var_585;
        wp::int32 var_586;
        wp::int32 var_587;
        wp::int32* var_588;
        wp::int32 var_589;
        wp::int32 var_590;
        wp::int32* var_591;
        wp::int32 var_592;
        wp::int32 var_593;
        const wp::int32 var_594 = 2;
        wp::int32 var_595;
        const wp::int32 var_596 = 1;
        wp::int32 var_597;
        wp::int32 var_598;
        wp::int32 var_599;
        const wp::int32 var_600 = 1;
        wp::int32 var_601;
        wp::int32 var_602;
        const wp::int32 var_603 = 1;
        wp::int32 var_604;
        const wp::int32 var_605 = 1;
        wp::int32 var_606;
        wp::int32 var_607;
        wp::int32 var_608;
        wp::int32* var_609;
        wp::int32 var_610;
        wp::int32 var_611;
        wp::int32 var_612;
        wp::int32 var_613;
        const wp::int32 var_614 = 1;
        wp::int32 var_615;
        wp::int32 var_616;
        wp::int32 var_617;
        const wp::int32 var_618 = 5;
        wp::int32 var_619;
        const wp::int32 var_620 = 1;
        wp::int32 var_621;
        const wp::int32 var_622 = 1;
        bool var_623;
        wp::int32* var_624;
        wp::int32 var_625;
        wp::int32 var_626;
        wp::int32* var_627;
        wp::range_t var_628;
        wp::int32 var_629;
        wp::int32 var_630;
        const wp::int32 var_631 = 0;
        const wp::int32 var_632 = 0;
        const wp::int32 var_633 = 0;
        wp::vec_t<3, wp::int32> var_634;
        const wp::int32 var_635 = 0;
        wp::int32 var_636;
        const wp::int32 var_637 = 3;
        wp::int32 var_638;
        wp::int32 var_639;
        wp::int32 var_640;
        wp::int32* var_641;
        wp::int32 var_642;
        wp::int32 var_643;
        wp::int32* var_644;
        wp::int32 var_645;
        wp::int32 var_646;
        const wp::int32 var_647 = 2;
        wp::int32 var_648;
        const wp::int32 var_649 = 1;
        wp::int32 var_650;
        wp::int32 var_651;
        wp::int32 var_652;
        const wp::int32 var_653 = 1;
        wp::int32 var_654;
        wp::int32 var_655;
        const wp::int32 var_656 = 1;
        wp::int32 var_657;
        const wp::int32 var_658 = 1;
        wp::int32 var_659;
        wp::int32 var_660;
        wp::int32 var_661;
        wp::int32* var_662;
        wp::int32 var_663;
        wp::int32 var_664;
        wp::int32 var_665;
        wp::int32 var_666;
        const wp::int32 var_667 = 1;
        wp::int32 var_668;
        const wp::int32 var_669 = 3;
        wp::int32 var_670;
        wp::int32 var_671;
        wp::int32 var_672;
        wp::int32* var_673;
        wp::int32 var_674;
        wp::int32 var_675;
        wp::int32* var_676;
        wp::int32 var_677;
        wp::int32 var_678;
        const wp::int32 var_679 = 2;
        wp::int32 var_680;
        const wp::int32 var_681 = 1;
        wp::int32 var_682;
        wp::int32 var_683;
        wp::int32 var_684;
        const wp::int32 var_685 = 1;
        wp::int32 var_686;
        wp::int32 var_687;
        const wp::int32 var_688 = 1;
        wp::int32 var_689;
        const wp::int32 var_690 = 1;
        wp::int32 var_691;
        wp::int32 var_692;
        wp::int32 var_693;
        wp::int32* var_694;
        wp::int32 var_695;
        wp::int32 var_696;
        wp::int32 var_697;
        wp::int32 var_698;
        const wp::int32 var_699 = 2;
        wp::int32 var_700;
        const wp::int32 var_701 = 3;
        wp::int32 var_702;
        wp::int32 var_703;
        wp::int32 var_704;
        wp::int32* var_705;
        wp::int32 var_706;
        wp::int32 var_707;
        wp::int32* var_708;
        wp::int32 var_709;
        wp::int32 var_710;
        const wp::int32 var_711 = 2;
        wp::int32 var_712;
        const wp::int32 var_713 = 1;
        wp::int32 var_714;
        wp::int32 var_715;
        wp::int32 var_716;
        const wp::int32 var_717 = 1;
        wp::int32 var_718;
        wp::int32 var_719;
        const wp::int32 var_720 = 1;
        wp::int32 var_721;
        const wp::int32 var_722 = 1;
        wp::int32 var_723;
        wp::int32 var_724;
        wp::int32 var_725;
        wp::int32* var_726;
        wp::int32 var_727;
        wp::int32 var_728;
        wp::int32 var_729;
        wp::int32 var_730;
        const wp::int32 var_731 = 1;
        wp::int32 var_732;
        wp::int32 var_733;
        wp::int32 var_734;
        const wp::int32 var_735 = 6;
        wp::int32 var_736;
        const wp::int32 var_737 = 1;
        wp::int32 var_738;
        const wp::int32 var_739 = 1;
        bool var_740;
        wp::int32* var_741;
        wp::int32 var_742;
        wp::int32 var_743;
        wp::int32* var_744;
        wp::range_t var_745;
        wp::int32 var_746;
        wp::int32 var_747;
        const wp::int32 var_748 = 0;
        const wp::int32 var_749 = 0;
        const wp::int32 var_750 = 0;
        wp::vec_t<3, wp::int32> var_751;
        const wp::int32 var_752 = 0;
        wp::int32 var_753;
        const wp::int32 var_754 = 3;
        wp::int32 var_755;
        wp::int32 var_756;
        wp::int32 var_757;
        wp::int32* var_758;
        wp::int32 var_759;
        wp::int32 var_760;
        wp::int32* var_761;
        wp::int32 var_762;
        wp::int32 var_763;
        const wp::int32 var_764 = 2;
        wp::int32 var_765;
        const wp::int32 var_766 = 1;
        wp::int32 var_767;
        wp::int32 var_768;
        wp::int32 var_769;
        const wp::int32 var_770 = 1;
        wp::int32 var_771;
        wp::int32 var_772;
        const wp::int32 var_773 = 1;
        wp::int32 var_774;
        const wp::int32 var_775 = 1;
        wp::int32 var_776;
        wp::int32 var_777;
        wp::int32 var_778;
        wp::int32* var_779;
        wp::int32 var_780;
        wp::int32 var_781;
        wp::int32 var_782;
        wp::int32 var_783;
        const wp::int32 var_784 = 1;
        wp::int32 var_785;
        const wp::int32 var_786 = 3;
        wp::int32 var_787;
        wp::int32 var_788;
        wp::int32 var_789;
        wp::int32* var_790;
        wp::int32 var_791;
        wp::int32 var_792;
        wp::int32* var_793;
        wp::int32 var_794;
        wp::int32 var_795;
        const wp::int32 var_796 = 2;
        wp::int32 var_797;
        const wp::int32 var_798 = 1;
        wp::int32 var_799;
        wp::int32 var_800;
        wp::int32 var_801;
        const wp::int32 var_802 = 1;
        wp::int32 var_803;
        wp::int32 var_804;
        const wp::int32 var_805 = 1;
        wp::int32 var_806;
        const wp::int32 var_807 = 1;
        wp::int32 var_808;
        wp::int32 var_809;
        wp::int32 var_810;
        wp::int32* var_811;
        wp::int32 var_812;
        wp::int32 var_813;
        wp::int32 var_814;
        wp::int32 var_815;
        const wp::int32 var_816 = 2;
        wp::int32 var_817;
        const wp::int32 var_818 = 3;
        wp::int32 var_819;
        wp::int32 var_820;
        wp::int32 var_821;
        wp::int32* var_822;
        wp::int32 var_823;
        wp::int32 var_824;
        wp::int32* var_825;
        wp::int32 var_826;
        wp::int32 var_827;
        const wp::int32 var_828 = 2;
        wp::int32 var_829;
        const wp::int32 var_830 = 1;
        wp::int32 var_831;
        wp::int32 var_832;
        wp::int32 var_833;
        const wp::int32 var_834 = 1;
        wp::int32 var_835;
        wp::int32 var_836;
        const wp::int32 var_837 = 1;
        wp::int32 var_838;
        const wp::int32 var_839 = 1;
        wp::int32 var_840;
        wp::int32 var_841;
        wp::int32 var_842;
        wp::int32* var_843;
        wp::int32 var_844;
        wp::int32 var_845;
        wp::int32 var_846;
        wp::int32 var_847;
        const wp::int32 var_848 = 1;
        wp::int32 var_849;
        wp::int32 var_850;
        wp::int32 var_851;
        const wp::int32 var_852 = 7;
        wp::int32 var_853;
        const wp::int32 var_854 = 1;
        wp::int32 var_855;
        const wp::int32 var_856 = 1;
        bool var_857;
        wp::int32* var_858;
        wp::int32 var_859;
        wp::int32 var_860;
        wp::int32* var_861;
        wp::range_t var_862;
        wp::int32 var_863;
        wp::int32 var_864;
        const wp::int32 var_865 = 0;
        const wp::int32 var_866 = 0;
        const wp::int32 var_867 = 0;
        wp::vec_t<3, wp::int32> var_868;
        const wp::int32 var_869 = 0;
        wp::int32 var_870;
        const wp::int32 var_871 = 3;
        wp::int32 var_872;
        wp::int32 var_873;
        wp::int32 var_874;
        wp::int32* var_875;
        wp::int32 var_876;
        wp::int32 var_877;
        wp::int32* var_878;
        wp::int32 var_879;
        wp::int32 var_880;
        const wp::int32 var_881 = 2;
        wp::int32 var_882;
        const wp::int32 var_883 = 1;
        wp::int32 var_884;
        wp::int32 var_885;
        wp::int32 var_886;
        const wp::int32 var_887 = 1;
        wp::int32 var_888;
        wp::int32 var_889;
        const wp::int32 var_890 = 1;
        wp::int32 var_891;
        const wp::int32 var_892 = 1;
        wp::int32 var_893;
        wp::int32 var_894;
        wp::int32 var_895;
        wp::int32* var_896;
        wp::int32 var_897;
        wp::int32 var_898;
        wp::int32 var_899;
        wp::int32 var_900;
        const wp::int32 var_901 = 1;
        wp::int32 var_902;
        const wp::int32 var_903 = 3;
        wp::int32 var_904;
        wp::int32 var_905;
        wp::int32 var_906;
        wp::int32* var_907;
        wp::int32 var_908;
        wp::int32 var_909;
        wp::int32* var_910;
        wp::int32 var_911;
        wp::int32 var_912;
        const wp::int32 var_913 = 2;
        wp::int32 var_914;
        const wp::int32 var_915 = 1;
        wp::int32 var_916;
        wp::int32 var_917;
        wp::int32 var_918;
        const wp::int32 var_919 = 1;
        wp::int32 var_920;
        wp::int32 var_921;
        const wp::int32 var_922 = 1;
        wp::int32 var_923;
        const wp::int32 var_924 = 1;
        wp::int32 var_925;
        wp::int32 var_926;
        wp::int32 var_927;
        wp::int32* var_928;
        wp::int32 var_929;
        wp::int32 var_930;
        wp::int32 var_931;
        wp::int32 var_932;
        const wp::int32 var_933 = 2;
        wp::int32 var_934;
        const wp::int32 var_935 = 3;
        wp::int32 var_936;
        wp::int32 var_937;
        wp::int32 var_938;
        wp::int32* var_939;
        wp::int32 var_940;
        wp::int32 var_941;
        wp::int32* var_942;
        wp::int32 var_943;
        wp::int32 var_944;
        const wp::int32 var_945 = 2;
        wp::int32 var_946;
        const wp::int32 var_947 = 1;
        wp::int32 var_948;
        wp::int32 var_949;
        wp::int32 var_950;
        const wp::int32 var_951 = 1;
        wp::int32 var_952;
        wp::int32 var_953;
        const wp::int32 var_954 = 1;
        wp::int32 var_955;
        const wp::int32 var_956 = 1;
        wp::int32 var_957;
        wp::int32 var_958;
        wp::int32 var_959;
        wp::int32* var_960;
        wp::int32 var_961;
        wp::int32 var_962;
        wp::int32 var_963;
        wp::int32 var_964;
        const wp::int32 var_965 = 1;
        wp::int32 var_966;
        wp::int32 var_967;
        wp::int32 var_968;
        //---------
        // forward
        // def emit_triangles_kernel(surface__seen__neighbors, surface__words, surface__cells, surface__edges, surface__rows, surface__offsets, surface__tables__triangle_count, surface__tables__triangle_edges, surface__tables__edge_corner, surface__tables__edge_axis, triangles):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // cut = surface__cells[i]                                                                <L 3>
        var_1 = wp::address(var_surface__cells, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // if cut == 0:                                                                           <L 4>
        var_5 = (var_2 == var_4);
        if (var_5) {
            // return                                                                             <L 5>
            return;
        }
        // block = i // ROWS                                                                      <L 6>
        var_7 = wp::floordiv(var_0, var_6);
        // x = i // SIDE % SIDE                                                                   <L 7>
        var_9 = wp::floordiv(var_0, var_8);
        var_10 = wp::mod(var_9, var_8);
        // y = i % SIDE                                                                           <L 8>
        var_11 = wp::mod(var_0, var_8);
        // w10 = word_near(surface__words, block, x + 1, y, 0, surface__seen__neighbors)          <L 9>
        var_13 = wp::add(var_10, var_12);
        var_15 = word_near_0(var_surface__words, var_7, var_13, var_11, var_14, var_surface__seen__neighbors);
        // w01 = word_near(surface__words, block, x, y + 1, 0, surface__seen__neighbors)          <L 10>
        var_17 = wp::add(var_11, var_16);
        var_19 = word_near_0(var_surface__words, var_7, var_10, var_17, var_18, var_surface__seen__neighbors);
        // w11 = word_near(surface__words, block, x + 1, y + 1, 0, surface__seen__neighbors)       <L 11>
        var_21 = wp::add(var_10, var_20);
        var_23 = wp::add(var_11, var_22);
        var_25 = word_near_0(var_surface__words, var_7, var_21, var_23, var_24, var_surface__seen__neighbors);
        // at = surface__offsets[surface__rows + i] - surface__offsets[surface__rows]             <L 12>
        var_26 = wp::add(var_surface__rows, var_0);
        var_27 = wp::address(var_surface__offsets, var_26);
        var_28 = wp::address(var_surface__offsets, var_surface__rows);
        var_30 = wp::load(var_27);
        var_31 = wp::load(var_28);
        var_29 = wp::sub(var_30, var_31);
        // for z in range(SIDE):                                                                  <L 13>
        // if cut >> z & 1 == 1:                                                                  <L 14>
        var_33 = wp::rshift(var_2, var_32);
        var_35 = wp::bit_and(var_33, var_34);
        var_37 = (var_35 == var_36);
        if (var_37) {
            // case = case_of(surface__words[i], w10, w01, w11, z)                                <L 15>
            var_38 = wp::address(var_surface__words, var_0);
            var_40 = wp::load(var_38);
            var_39 = case_of_0(var_40, var_15, var_19, var_25, var_32);
            // for t in range(surface__tables__triangle_count[case]):                             <L 16>
            var_41 = wp::address(var_surface__tables__triangle_count, var_39);
            var_43 = wp::load(var_41);
            var_42 = wp::range(var_43);
            start_for_1:;
                if (iter_cmp(var_42) == 0) goto end_for_1;
                var_44 = wp::iter_next(var_42);
                // triangle = vec3i(0, 0, 0)                                                      <L 17>
                var_48 = wp::vec_t<3, wp::int32>(var_45, var_46, var_47);
                // for k in range(3):                                                             <L 18>
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_51 = wp::mul(var_39, var_50);
                var_53 = wp::mul(var_52, var_44);
                var_54 = wp::add(var_51, var_53);
                var_55 = wp::add(var_54, var_49);
                var_56 = wp::address(var_surface__tables__triangle_edges, var_55);
                var_58 = wp::load(var_56);
                var_57 = wp::copy(var_58);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_59 = wp::address(var_surface__tables__edge_corner, var_57);
                var_61 = wp::load(var_59);
                var_60 = wp::copy(var_61);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_63 = wp::rshift(var_60, var_62);
                var_65 = wp::bit_and(var_63, var_64);
                var_66 = wp::add(var_32, var_65);
                // dz = up // SIDE                                                                <L 22>
                var_67 = wp::floordiv(var_66, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_69 = wp::bit_and(var_60, var_68);
                var_70 = wp::add(var_10, var_69);
                var_72 = wp::rshift(var_60, var_71);
                var_74 = wp::bit_and(var_72, var_73);
                var_75 = wp::add(var_11, var_74);
                var_76 = row_near_0(var_7, var_70, var_75, var_67, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_77 = wp::address(var_surface__tables__edge_axis, var_57);
                var_78 = wp::mul(var_67, var_8);
                var_79 = wp::sub(var_66, var_78);
                var_81 = wp::load(var_77);
                var_80 = vertex_of_0(var_76, var_81, var_79, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_48, var_49, var_80);
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_83 = wp::mul(var_39, var_50);
                var_85 = wp::mul(var_84, var_44);
                var_86 = wp::add(var_83, var_85);
                var_87 = wp::add(var_86, var_82);
                var_88 = wp::address(var_surface__tables__triangle_edges, var_87);
                var_90 = wp::load(var_88);
                var_89 = wp::copy(var_90);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_91 = wp::address(var_surface__tables__edge_corner, var_89);
                var_93 = wp::load(var_91);
                var_92 = wp::copy(var_93);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_95 = wp::rshift(var_92, var_94);
                var_97 = wp::bit_and(var_95, var_96);
                var_98 = wp::add(var_32, var_97);
                // dz = up // SIDE                                                                <L 22>
                var_99 = wp::floordiv(var_98, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_101 = wp::bit_and(var_92, var_100);
                var_102 = wp::add(var_10, var_101);
                var_104 = wp::rshift(var_92, var_103);
                var_106 = wp::bit_and(var_104, var_105);
                var_107 = wp::add(var_11, var_106);
                var_108 = row_near_0(var_7, var_102, var_107, var_99, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_109 = wp::address(var_surface__tables__edge_axis, var_89);
                var_110 = wp::mul(var_99, var_8);
                var_111 = wp::sub(var_98, var_110);
                var_113 = wp::load(var_109);
                var_112 = vertex_of_0(var_108, var_113, var_111, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_48, var_82, var_112);
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_115 = wp::mul(var_39, var_50);
                var_117 = wp::mul(var_116, var_44);
                var_118 = wp::add(var_115, var_117);
                var_119 = wp::add(var_118, var_114);
                var_120 = wp::address(var_surface__tables__triangle_edges, var_119);
                var_122 = wp::load(var_120);
                var_121 = wp::copy(var_122);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_123 = wp::address(var_surface__tables__edge_corner, var_121);
                var_125 = wp::load(var_123);
                var_124 = wp::copy(var_125);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_127 = wp::rshift(var_124, var_126);
                var_129 = wp::bit_and(var_127, var_128);
                var_130 = wp::add(var_32, var_129);
                // dz = up // SIDE                                                                <L 22>
                var_131 = wp::floordiv(var_130, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_133 = wp::bit_and(var_124, var_132);
                var_134 = wp::add(var_10, var_133);
                var_136 = wp::rshift(var_124, var_135);
                var_138 = wp::bit_and(var_136, var_137);
                var_139 = wp::add(var_11, var_138);
                var_140 = row_near_0(var_7, var_134, var_139, var_131, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_141 = wp::address(var_surface__tables__edge_axis, var_121);
                var_142 = wp::mul(var_131, var_8);
                var_143 = wp::sub(var_130, var_142);
                var_145 = wp::load(var_141);
                var_144 = vertex_of_0(var_140, var_145, var_143, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_48, var_114, var_144);
                // triangles[at] = triangle                                                       <L 25>
                wp::array_store(var_triangles, var_29, var_48);
                // at += 1                                                                        <L 26>
                var_147 = wp::add(var_29, var_146);
                wp::assign(var_29, var_147);
                goto start_for_1;
            end_for_1:;
        }
        // if cut >> z & 1 == 1:                                                                  <L 14>
        var_149 = wp::rshift(var_2, var_148);
        var_151 = wp::bit_and(var_149, var_150);
        var_153 = (var_151 == var_152);
        if (var_153) {
            // case = case_of(surface__words[i], w10, w01, w11, z)                                <L 15>
            var_154 = wp::address(var_surface__words, var_0);
            var_156 = wp::load(var_154);
            var_155 = case_of_0(var_156, var_15, var_19, var_25, var_148);
            // for t in range(surface__tables__triangle_count[case]):                             <L 16>
            var_157 = wp::address(var_surface__tables__triangle_count, var_155);
            var_159 = wp::load(var_157);
            var_158 = wp::range(var_159);
            var_160 = wp::copy(var_114);
            start_for_3:;
                if (iter_cmp(var_158) == 0) goto end_for_3;
                var_161 = wp::iter_next(var_158);
                // triangle = vec3i(0, 0, 0)                                                      <L 17>
                var_165 = wp::vec_t<3, wp::int32>(var_162, var_163, var_164);
                // for k in range(3):                                                             <L 18>
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_167 = wp::mul(var_155, var_50);
                var_169 = wp::mul(var_168, var_161);
                var_170 = wp::add(var_167, var_169);
                var_171 = wp::add(var_170, var_166);
                var_172 = wp::address(var_surface__tables__triangle_edges, var_171);
                var_174 = wp::load(var_172);
                var_173 = wp::copy(var_174);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_175 = wp::address(var_surface__tables__edge_corner, var_173);
                var_177 = wp::load(var_175);
                var_176 = wp::copy(var_177);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_179 = wp::rshift(var_176, var_178);
                var_181 = wp::bit_and(var_179, var_180);
                var_182 = wp::add(var_148, var_181);
                // dz = up // SIDE                                                                <L 22>
                var_183 = wp::floordiv(var_182, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_185 = wp::bit_and(var_176, var_184);
                var_186 = wp::add(var_10, var_185);
                var_188 = wp::rshift(var_176, var_187);
                var_190 = wp::bit_and(var_188, var_189);
                var_191 = wp::add(var_11, var_190);
                var_192 = row_near_0(var_7, var_186, var_191, var_183, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_193 = wp::address(var_surface__tables__edge_axis, var_173);
                var_194 = wp::mul(var_183, var_8);
                var_195 = wp::sub(var_182, var_194);
                var_197 = wp::load(var_193);
                var_196 = vertex_of_0(var_192, var_197, var_195, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_165, var_166, var_196);
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_199 = wp::mul(var_155, var_50);
                var_201 = wp::mul(var_200, var_161);
                var_202 = wp::add(var_199, var_201);
                var_203 = wp::add(var_202, var_198);
                var_204 = wp::address(var_surface__tables__triangle_edges, var_203);
                var_206 = wp::load(var_204);
                var_205 = wp::copy(var_206);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_207 = wp::address(var_surface__tables__edge_corner, var_205);
                var_209 = wp::load(var_207);
                var_208 = wp::copy(var_209);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_211 = wp::rshift(var_208, var_210);
                var_213 = wp::bit_and(var_211, var_212);
                var_214 = wp::add(var_148, var_213);
                // dz = up // SIDE                                                                <L 22>
                var_215 = wp::floordiv(var_214, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_217 = wp::bit_and(var_208, var_216);
                var_218 = wp::add(var_10, var_217);
                var_220 = wp::rshift(var_208, var_219);
                var_222 = wp::bit_and(var_220, var_221);
                var_223 = wp::add(var_11, var_222);
                var_224 = row_near_0(var_7, var_218, var_223, var_215, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_225 = wp::address(var_surface__tables__edge_axis, var_205);
                var_226 = wp::mul(var_215, var_8);
                var_227 = wp::sub(var_214, var_226);
                var_229 = wp::load(var_225);
                var_228 = vertex_of_0(var_224, var_229, var_227, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_165, var_198, var_228);
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_231 = wp::mul(var_155, var_50);
                var_233 = wp::mul(var_232, var_161);
                var_234 = wp::add(var_231, var_233);
                var_235 = wp::add(var_234, var_230);
                var_236 = wp::address(var_surface__tables__triangle_edges, var_235);
                var_238 = wp::load(var_236);
                var_237 = wp::copy(var_238);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_239 = wp::address(var_surface__tables__edge_corner, var_237);
                var_241 = wp::load(var_239);
                var_240 = wp::copy(var_241);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_243 = wp::rshift(var_240, var_242);
                var_245 = wp::bit_and(var_243, var_244);
                var_246 = wp::add(var_148, var_245);
                // dz = up // SIDE                                                                <L 22>
                var_247 = wp::floordiv(var_246, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_249 = wp::bit_and(var_240, var_248);
                var_250 = wp::add(var_10, var_249);
                var_252 = wp::rshift(var_240, var_251);
                var_254 = wp::bit_and(var_252, var_253);
                var_255 = wp::add(var_11, var_254);
                var_256 = row_near_0(var_7, var_250, var_255, var_247, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_257 = wp::address(var_surface__tables__edge_axis, var_237);
                var_258 = wp::mul(var_247, var_8);
                var_259 = wp::sub(var_246, var_258);
                var_261 = wp::load(var_257);
                var_260 = vertex_of_0(var_256, var_261, var_259, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_165, var_230, var_260);
                // triangles[at] = triangle                                                       <L 25>
                wp::array_store(var_triangles, var_29, var_165);
                // at += 1                                                                        <L 26>
                var_263 = wp::add(var_29, var_262);
                wp::assign(var_29, var_263);
                wp::assign(var_48, var_165);
                wp::assign(var_160, var_230);
                wp::assign(var_121, var_237);
                wp::assign(var_124, var_240);
                wp::assign(var_130, var_246);
                wp::assign(var_131, var_247);
                wp::assign(var_140, var_256);
                goto start_for_3;
            end_for_3:;
        }
        var_264 = wp::where(var_153, var_155, var_39);
        var_265 = wp::where(var_153, var_161, var_44);
        var_266 = wp::where(var_153, var_160, var_114);
        // if cut >> z & 1 == 1:                                                                  <L 14>
        var_268 = wp::rshift(var_2, var_267);
        var_270 = wp::bit_and(var_268, var_269);
        var_272 = (var_270 == var_271);
        if (var_272) {
            // case = case_of(surface__words[i], w10, w01, w11, z)                                <L 15>
            var_273 = wp::address(var_surface__words, var_0);
            var_275 = wp::load(var_273);
            var_274 = case_of_0(var_275, var_15, var_19, var_25, var_267);
            // for t in range(surface__tables__triangle_count[case]):                             <L 16>
            var_276 = wp::address(var_surface__tables__triangle_count, var_274);
            var_278 = wp::load(var_276);
            var_277 = wp::range(var_278);
            start_for_5:;
                if (iter_cmp(var_277) == 0) goto end_for_5;
                var_279 = wp::iter_next(var_277);
                // triangle = vec3i(0, 0, 0)                                                      <L 17>
                var_283 = wp::vec_t<3, wp::int32>(var_280, var_281, var_282);
                // for k in range(3):                                                             <L 18>
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_285 = wp::mul(var_274, var_50);
                var_287 = wp::mul(var_286, var_279);
                var_288 = wp::add(var_285, var_287);
                var_289 = wp::add(var_288, var_284);
                var_290 = wp::address(var_surface__tables__triangle_edges, var_289);
                var_292 = wp::load(var_290);
                var_291 = wp::copy(var_292);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_293 = wp::address(var_surface__tables__edge_corner, var_291);
                var_295 = wp::load(var_293);
                var_294 = wp::copy(var_295);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_297 = wp::rshift(var_294, var_296);
                var_299 = wp::bit_and(var_297, var_298);
                var_300 = wp::add(var_267, var_299);
                // dz = up // SIDE                                                                <L 22>
                var_301 = wp::floordiv(var_300, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_303 = wp::bit_and(var_294, var_302);
                var_304 = wp::add(var_10, var_303);
                var_306 = wp::rshift(var_294, var_305);
                var_308 = wp::bit_and(var_306, var_307);
                var_309 = wp::add(var_11, var_308);
                var_310 = row_near_0(var_7, var_304, var_309, var_301, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_311 = wp::address(var_surface__tables__edge_axis, var_291);
                var_312 = wp::mul(var_301, var_8);
                var_313 = wp::sub(var_300, var_312);
                var_315 = wp::load(var_311);
                var_314 = vertex_of_0(var_310, var_315, var_313, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_283, var_284, var_314);
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_317 = wp::mul(var_274, var_50);
                var_319 = wp::mul(var_318, var_279);
                var_320 = wp::add(var_317, var_319);
                var_321 = wp::add(var_320, var_316);
                var_322 = wp::address(var_surface__tables__triangle_edges, var_321);
                var_324 = wp::load(var_322);
                var_323 = wp::copy(var_324);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_325 = wp::address(var_surface__tables__edge_corner, var_323);
                var_327 = wp::load(var_325);
                var_326 = wp::copy(var_327);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_329 = wp::rshift(var_326, var_328);
                var_331 = wp::bit_and(var_329, var_330);
                var_332 = wp::add(var_267, var_331);
                // dz = up // SIDE                                                                <L 22>
                var_333 = wp::floordiv(var_332, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_335 = wp::bit_and(var_326, var_334);
                var_336 = wp::add(var_10, var_335);
                var_338 = wp::rshift(var_326, var_337);
                var_340 = wp::bit_and(var_338, var_339);
                var_341 = wp::add(var_11, var_340);
                var_342 = row_near_0(var_7, var_336, var_341, var_333, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_343 = wp::address(var_surface__tables__edge_axis, var_323);
                var_344 = wp::mul(var_333, var_8);
                var_345 = wp::sub(var_332, var_344);
                var_347 = wp::load(var_343);
                var_346 = vertex_of_0(var_342, var_347, var_345, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_283, var_316, var_346);
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_349 = wp::mul(var_274, var_50);
                var_351 = wp::mul(var_350, var_279);
                var_352 = wp::add(var_349, var_351);
                var_353 = wp::add(var_352, var_348);
                var_354 = wp::address(var_surface__tables__triangle_edges, var_353);
                var_356 = wp::load(var_354);
                var_355 = wp::copy(var_356);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_357 = wp::address(var_surface__tables__edge_corner, var_355);
                var_359 = wp::load(var_357);
                var_358 = wp::copy(var_359);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_361 = wp::rshift(var_358, var_360);
                var_363 = wp::bit_and(var_361, var_362);
                var_364 = wp::add(var_267, var_363);
                // dz = up // SIDE                                                                <L 22>
                var_365 = wp::floordiv(var_364, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_367 = wp::bit_and(var_358, var_366);
                var_368 = wp::add(var_10, var_367);
                var_370 = wp::rshift(var_358, var_369);
                var_372 = wp::bit_and(var_370, var_371);
                var_373 = wp::add(var_11, var_372);
                var_374 = row_near_0(var_7, var_368, var_373, var_365, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_375 = wp::address(var_surface__tables__edge_axis, var_355);
                var_376 = wp::mul(var_365, var_8);
                var_377 = wp::sub(var_364, var_376);
                var_379 = wp::load(var_375);
                var_378 = vertex_of_0(var_374, var_379, var_377, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_283, var_348, var_378);
                // triangles[at] = triangle                                                       <L 25>
                wp::array_store(var_triangles, var_29, var_283);
                // at += 1                                                                        <L 26>
                var_381 = wp::add(var_29, var_380);
                wp::assign(var_29, var_381);
                wp::assign(var_48, var_283);
                wp::assign(var_266, var_348);
                wp::assign(var_121, var_355);
                wp::assign(var_124, var_358);
                wp::assign(var_130, var_364);
                wp::assign(var_131, var_365);
                wp::assign(var_140, var_374);
                goto start_for_5;
            end_for_5:;
        }
        var_382 = wp::where(var_272, var_274, var_264);
        var_383 = wp::where(var_272, var_279, var_265);
        // if cut >> z & 1 == 1:                                                                  <L 14>
        var_385 = wp::rshift(var_2, var_384);
        var_387 = wp::bit_and(var_385, var_386);
        var_389 = (var_387 == var_388);
        if (var_389) {
            // case = case_of(surface__words[i], w10, w01, w11, z)                                <L 15>
            var_390 = wp::address(var_surface__words, var_0);
            var_392 = wp::load(var_390);
            var_391 = case_of_0(var_392, var_15, var_19, var_25, var_384);
            // for t in range(surface__tables__triangle_count[case]):                             <L 16>
            var_393 = wp::address(var_surface__tables__triangle_count, var_391);
            var_395 = wp::load(var_393);
            var_394 = wp::range(var_395);
            start_for_7:;
                if (iter_cmp(var_394) == 0) goto end_for_7;
                var_396 = wp::iter_next(var_394);
                // triangle = vec3i(0, 0, 0)                                                      <L 17>
                var_400 = wp::vec_t<3, wp::int32>(var_397, var_398, var_399);
                // for k in range(3):                                                             <L 18>
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_402 = wp::mul(var_391, var_50);
                var_404 = wp::mul(var_403, var_396);
                var_405 = wp::add(var_402, var_404);
                var_406 = wp::add(var_405, var_401);
                var_407 = wp::address(var_surface__tables__triangle_edges, var_406);
                var_409 = wp::load(var_407);
                var_408 = wp::copy(var_409);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_410 = wp::address(var_surface__tables__edge_corner, var_408);
                var_412 = wp::load(var_410);
                var_411 = wp::copy(var_412);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_414 = wp::rshift(var_411, var_413);
                var_416 = wp::bit_and(var_414, var_415);
                var_417 = wp::add(var_384, var_416);
                // dz = up // SIDE                                                                <L 22>
                var_418 = wp::floordiv(var_417, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_420 = wp::bit_and(var_411, var_419);
                var_421 = wp::add(var_10, var_420);
                var_423 = wp::rshift(var_411, var_422);
                var_425 = wp::bit_and(var_423, var_424);
                var_426 = wp::add(var_11, var_425);
                var_427 = row_near_0(var_7, var_421, var_426, var_418, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_428 = wp::address(var_surface__tables__edge_axis, var_408);
                var_429 = wp::mul(var_418, var_8);
                var_430 = wp::sub(var_417, var_429);
                var_432 = wp::load(var_428);
                var_431 = vertex_of_0(var_427, var_432, var_430, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_400, var_401, var_431);
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_434 = wp::mul(var_391, var_50);
                var_436 = wp::mul(var_435, var_396);
                var_437 = wp::add(var_434, var_436);
                var_438 = wp::add(var_437, var_433);
                var_439 = wp::address(var_surface__tables__triangle_edges, var_438);
                var_441 = wp::load(var_439);
                var_440 = wp::copy(var_441);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_442 = wp::address(var_surface__tables__edge_corner, var_440);
                var_444 = wp::load(var_442);
                var_443 = wp::copy(var_444);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_446 = wp::rshift(var_443, var_445);
                var_448 = wp::bit_and(var_446, var_447);
                var_449 = wp::add(var_384, var_448);
                // dz = up // SIDE                                                                <L 22>
                var_450 = wp::floordiv(var_449, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_452 = wp::bit_and(var_443, var_451);
                var_453 = wp::add(var_10, var_452);
                var_455 = wp::rshift(var_443, var_454);
                var_457 = wp::bit_and(var_455, var_456);
                var_458 = wp::add(var_11, var_457);
                var_459 = row_near_0(var_7, var_453, var_458, var_450, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_460 = wp::address(var_surface__tables__edge_axis, var_440);
                var_461 = wp::mul(var_450, var_8);
                var_462 = wp::sub(var_449, var_461);
                var_464 = wp::load(var_460);
                var_463 = vertex_of_0(var_459, var_464, var_462, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_400, var_433, var_463);
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_466 = wp::mul(var_391, var_50);
                var_468 = wp::mul(var_467, var_396);
                var_469 = wp::add(var_466, var_468);
                var_470 = wp::add(var_469, var_465);
                var_471 = wp::address(var_surface__tables__triangle_edges, var_470);
                var_473 = wp::load(var_471);
                var_472 = wp::copy(var_473);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_474 = wp::address(var_surface__tables__edge_corner, var_472);
                var_476 = wp::load(var_474);
                var_475 = wp::copy(var_476);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_478 = wp::rshift(var_475, var_477);
                var_480 = wp::bit_and(var_478, var_479);
                var_481 = wp::add(var_384, var_480);
                // dz = up // SIDE                                                                <L 22>
                var_482 = wp::floordiv(var_481, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_484 = wp::bit_and(var_475, var_483);
                var_485 = wp::add(var_10, var_484);
                var_487 = wp::rshift(var_475, var_486);
                var_489 = wp::bit_and(var_487, var_488);
                var_490 = wp::add(var_11, var_489);
                var_491 = row_near_0(var_7, var_485, var_490, var_482, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_492 = wp::address(var_surface__tables__edge_axis, var_472);
                var_493 = wp::mul(var_482, var_8);
                var_494 = wp::sub(var_481, var_493);
                var_496 = wp::load(var_492);
                var_495 = vertex_of_0(var_491, var_496, var_494, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_400, var_465, var_495);
                // triangles[at] = triangle                                                       <L 25>
                wp::array_store(var_triangles, var_29, var_400);
                // at += 1                                                                        <L 26>
                var_498 = wp::add(var_29, var_497);
                wp::assign(var_29, var_498);
                wp::assign(var_48, var_400);
                wp::assign(var_266, var_465);
                wp::assign(var_121, var_472);
                wp::assign(var_124, var_475);
                wp::assign(var_130, var_481);
                wp::assign(var_131, var_482);
                wp::assign(var_140, var_491);
                goto start_for_7;
            end_for_7:;
        }
        var_499 = wp::where(var_389, var_391, var_382);
        var_500 = wp::where(var_389, var_396, var_383);
        // if cut >> z & 1 == 1:                                                                  <L 14>
        var_502 = wp::rshift(var_2, var_501);
        var_504 = wp::bit_and(var_502, var_503);
        var_506 = (var_504 == var_505);
        if (var_506) {
            // case = case_of(surface__words[i], w10, w01, w11, z)                                <L 15>
            var_507 = wp::address(var_surface__words, var_0);
            var_509 = wp::load(var_507);
            var_508 = case_of_0(var_509, var_15, var_19, var_25, var_501);
            // for t in range(surface__tables__triangle_count[case]):                             <L 16>
            var_510 = wp::address(var_surface__tables__triangle_count, var_508);
            var_512 = wp::load(var_510);
            var_511 = wp::range(var_512);
            start_for_9:;
                if (iter_cmp(var_511) == 0) goto end_for_9;
                var_513 = wp::iter_next(var_511);
                // triangle = vec3i(0, 0, 0)                                                      <L 17>
                var_517 = wp::vec_t<3, wp::int32>(var_514, var_515, var_516);
                // for k in range(3):                                                             <L 18>
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_519 = wp::mul(var_508, var_50);
                var_521 = wp::mul(var_520, var_513);
                var_522 = wp::add(var_519, var_521);
                var_523 = wp::add(var_522, var_518);
                var_524 = wp::address(var_surface__tables__triangle_edges, var_523);
                var_526 = wp::load(var_524);
                var_525 = wp::copy(var_526);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_527 = wp::address(var_surface__tables__edge_corner, var_525);
                var_529 = wp::load(var_527);
                var_528 = wp::copy(var_529);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_531 = wp::rshift(var_528, var_530);
                var_533 = wp::bit_and(var_531, var_532);
                var_534 = wp::add(var_501, var_533);
                // dz = up // SIDE                                                                <L 22>
                var_535 = wp::floordiv(var_534, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_537 = wp::bit_and(var_528, var_536);
                var_538 = wp::add(var_10, var_537);
                var_540 = wp::rshift(var_528, var_539);
                var_542 = wp::bit_and(var_540, var_541);
                var_543 = wp::add(var_11, var_542);
                var_544 = row_near_0(var_7, var_538, var_543, var_535, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_545 = wp::address(var_surface__tables__edge_axis, var_525);
                var_546 = wp::mul(var_535, var_8);
                var_547 = wp::sub(var_534, var_546);
                var_549 = wp::load(var_545);
                var_548 = vertex_of_0(var_544, var_549, var_547, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_517, var_518, var_548);
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_551 = wp::mul(var_508, var_50);
                var_553 = wp::mul(var_552, var_513);
                var_554 = wp::add(var_551, var_553);
                var_555 = wp::add(var_554, var_550);
                var_556 = wp::address(var_surface__tables__triangle_edges, var_555);
                var_558 = wp::load(var_556);
                var_557 = wp::copy(var_558);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_559 = wp::address(var_surface__tables__edge_corner, var_557);
                var_561 = wp::load(var_559);
                var_560 = wp::copy(var_561);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_563 = wp::rshift(var_560, var_562);
                var_565 = wp::bit_and(var_563, var_564);
                var_566 = wp::add(var_501, var_565);
                // dz = up // SIDE                                                                <L 22>
                var_567 = wp::floordiv(var_566, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_569 = wp::bit_and(var_560, var_568);
                var_570 = wp::add(var_10, var_569);
                var_572 = wp::rshift(var_560, var_571);
                var_574 = wp::bit_and(var_572, var_573);
                var_575 = wp::add(var_11, var_574);
                var_576 = row_near_0(var_7, var_570, var_575, var_567, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_577 = wp::address(var_surface__tables__edge_axis, var_557);
                var_578 = wp::mul(var_567, var_8);
                var_579 = wp::sub(var_566, var_578);
                var_581 = wp::load(var_577);
                var_580 = vertex_of_0(var_576, var_581, var_579, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_517, var_550, var_580);
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_583 = wp::mul(var_508, var_50);
                var_585 = wp::mul(var_584, var_513);
                var_586 = wp::add(var_583, var_585);
                var_587 = wp::add(var_586, var_582);
                var_588 = wp::address(var_surface__tables__triangle_edges, var_587);
                var_590 = wp::load(var_588);
                var_589 = wp::copy(var_590);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_591 = wp::address(var_surface__tables__edge_corner, var_589);
                var_593 = wp::load(var_591);
                var_592 = wp::copy(var_593);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_595 = wp::rshift(var_592, var_594);
                var_597 = wp::bit_and(var_595, var_596);
                var_598 = wp::add(var_501, var_597);
                // dz = up // SIDE                                                                <L 22>
                var_599 = wp::floordiv(var_598, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_601 = wp::bit_and(var_592, var_600);
                var_602 = wp::add(var_10, var_601);
                var_604 = wp::rshift(var_592, var_603);
                var_606 = wp::bit_and(var_604, var_605);
                var_607 = wp::add(var_11, var_606);
                var_608 = row_near_0(var_7, var_602, var_607, var_599, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_609 = wp::address(var_surface__tables__edge_axis, var_589);
                var_610 = wp::mul(var_599, var_8);
                var_611 = wp::sub(var_598, var_610);
                var_613 = wp::load(var_609);
                var_612 = vertex_of_0(var_608, var_613, var_611, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_517, var_582, var_612);
                // triangles[at] = triangle                                                       <L 25>
                wp::array_store(var_triangles, var_29, var_517);
                // at += 1                                                                        <L 26>
                var_615 = wp::add(var_29, var_614);
                wp::assign(var_29, var_615);
                wp::assign(var_48, var_517);
                wp::assign(var_266, var_582);
                wp::assign(var_121, var_589);
                wp::assign(var_124, var_592);
                wp::assign(var_130, var_598);
                wp::assign(var_131, var_599);
                wp::assign(var_140, var_608);
                goto start_for_9;
            end_for_9:;
        }
        var_616 = wp::where(var_506, var_508, var_499);
        var_617 = wp::where(var_506, var_513, var_500);
        // if cut >> z & 1 == 1:                                                                  <L 14>
        var_619 = wp::rshift(var_2, var_618);
        var_621 = wp::bit_and(var_619, var_620);
        var_623 = (var_621 == var_622);
        if (var_623) {
            // case = case_of(surface__words[i], w10, w01, w11, z)                                <L 15>
            var_624 = wp::address(var_surface__words, var_0);
            var_626 = wp::load(var_624);
            var_625 = case_of_0(var_626, var_15, var_19, var_25, var_618);
            // for t in range(surface__tables__triangle_count[case]):                             <L 16>
            var_627 = wp::address(var_surface__tables__triangle_count, var_625);
            var_629 = wp::load(var_627);
            var_628 = wp::range(var_629);
            start_for_11:;
                if (iter_cmp(var_628) == 0) goto end_for_11;
                var_630 = wp::iter_next(var_628);
                // triangle = vec3i(0, 0, 0)                                                      <L 17>
                var_634 = wp::vec_t<3, wp::int32>(var_631, var_632, var_633);
                // for k in range(3):                                                             <L 18>
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_636 = wp::mul(var_625, var_50);
                var_638 = wp::mul(var_637, var_630);
                var_639 = wp::add(var_636, var_638);
                var_640 = wp::add(var_639, var_635);
                var_641 = wp::address(var_surface__tables__triangle_edges, var_640);
                var_643 = wp::load(var_641);
                var_642 = wp::copy(var_643);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_644 = wp::address(var_surface__tables__edge_corner, var_642);
                var_646 = wp::load(var_644);
                var_645 = wp::copy(var_646);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_648 = wp::rshift(var_645, var_647);
                var_650 = wp::bit_and(var_648, var_649);
                var_651 = wp::add(var_618, var_650);
                // dz = up // SIDE                                                                <L 22>
                var_652 = wp::floordiv(var_651, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_654 = wp::bit_and(var_645, var_653);
                var_655 = wp::add(var_10, var_654);
                var_657 = wp::rshift(var_645, var_656);
                var_659 = wp::bit_and(var_657, var_658);
                var_660 = wp::add(var_11, var_659);
                var_661 = row_near_0(var_7, var_655, var_660, var_652, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_662 = wp::address(var_surface__tables__edge_axis, var_642);
                var_663 = wp::mul(var_652, var_8);
                var_664 = wp::sub(var_651, var_663);
                var_666 = wp::load(var_662);
                var_665 = vertex_of_0(var_661, var_666, var_664, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_634, var_635, var_665);
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_668 = wp::mul(var_625, var_50);
                var_670 = wp::mul(var_669, var_630);
                var_671 = wp::add(var_668, var_670);
                var_672 = wp::add(var_671, var_667);
                var_673 = wp::address(var_surface__tables__triangle_edges, var_672);
                var_675 = wp::load(var_673);
                var_674 = wp::copy(var_675);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_676 = wp::address(var_surface__tables__edge_corner, var_674);
                var_678 = wp::load(var_676);
                var_677 = wp::copy(var_678);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_680 = wp::rshift(var_677, var_679);
                var_682 = wp::bit_and(var_680, var_681);
                var_683 = wp::add(var_618, var_682);
                // dz = up // SIDE                                                                <L 22>
                var_684 = wp::floordiv(var_683, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_686 = wp::bit_and(var_677, var_685);
                var_687 = wp::add(var_10, var_686);
                var_689 = wp::rshift(var_677, var_688);
                var_691 = wp::bit_and(var_689, var_690);
                var_692 = wp::add(var_11, var_691);
                var_693 = row_near_0(var_7, var_687, var_692, var_684, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_694 = wp::address(var_surface__tables__edge_axis, var_674);
                var_695 = wp::mul(var_684, var_8);
                var_696 = wp::sub(var_683, var_695);
                var_698 = wp::load(var_694);
                var_697 = vertex_of_0(var_693, var_698, var_696, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_634, var_667, var_697);
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_700 = wp::mul(var_625, var_50);
                var_702 = wp::mul(var_701, var_630);
                var_703 = wp::add(var_700, var_702);
                var_704 = wp::add(var_703, var_699);
                var_705 = wp::address(var_surface__tables__triangle_edges, var_704);
                var_707 = wp::load(var_705);
                var_706 = wp::copy(var_707);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_708 = wp::address(var_surface__tables__edge_corner, var_706);
                var_710 = wp::load(var_708);
                var_709 = wp::copy(var_710);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_712 = wp::rshift(var_709, var_711);
                var_714 = wp::bit_and(var_712, var_713);
                var_715 = wp::add(var_618, var_714);
                // dz = up // SIDE                                                                <L 22>
                var_716 = wp::floordiv(var_715, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_718 = wp::bit_and(var_709, var_717);
                var_719 = wp::add(var_10, var_718);
                var_721 = wp::rshift(var_709, var_720);
                var_723 = wp::bit_and(var_721, var_722);
                var_724 = wp::add(var_11, var_723);
                var_725 = row_near_0(var_7, var_719, var_724, var_716, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_726 = wp::address(var_surface__tables__edge_axis, var_706);
                var_727 = wp::mul(var_716, var_8);
                var_728 = wp::sub(var_715, var_727);
                var_730 = wp::load(var_726);
                var_729 = vertex_of_0(var_725, var_730, var_728, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_634, var_699, var_729);
                // triangles[at] = triangle                                                       <L 25>
                wp::array_store(var_triangles, var_29, var_634);
                // at += 1                                                                        <L 26>
                var_732 = wp::add(var_29, var_731);
                wp::assign(var_29, var_732);
                wp::assign(var_48, var_634);
                wp::assign(var_266, var_699);
                wp::assign(var_121, var_706);
                wp::assign(var_124, var_709);
                wp::assign(var_130, var_715);
                wp::assign(var_131, var_716);
                wp::assign(var_140, var_725);
                goto start_for_11;
            end_for_11:;
        }
        var_733 = wp::where(var_623, var_625, var_616);
        var_734 = wp::where(var_623, var_630, var_617);
        // if cut >> z & 1 == 1:                                                                  <L 14>
        var_736 = wp::rshift(var_2, var_735);
        var_738 = wp::bit_and(var_736, var_737);
        var_740 = (var_738 == var_739);
        if (var_740) {
            // case = case_of(surface__words[i], w10, w01, w11, z)                                <L 15>
            var_741 = wp::address(var_surface__words, var_0);
            var_743 = wp::load(var_741);
            var_742 = case_of_0(var_743, var_15, var_19, var_25, var_735);
            // for t in range(surface__tables__triangle_count[case]):                             <L 16>
            var_744 = wp::address(var_surface__tables__triangle_count, var_742);
            var_746 = wp::load(var_744);
            var_745 = wp::range(var_746);
            start_for_13:;
                if (iter_cmp(var_745) == 0) goto end_for_13;
                var_747 = wp::iter_next(var_745);
                // triangle = vec3i(0, 0, 0)                                                      <L 17>
                var_751 = wp::vec_t<3, wp::int32>(var_748, var_749, var_750);
                // for k in range(3):                                                             <L 18>
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_753 = wp::mul(var_742, var_50);
                var_755 = wp::mul(var_754, var_747);
                var_756 = wp::add(var_753, var_755);
                var_757 = wp::add(var_756, var_752);
                var_758 = wp::address(var_surface__tables__triangle_edges, var_757);
                var_760 = wp::load(var_758);
                var_759 = wp::copy(var_760);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_761 = wp::address(var_surface__tables__edge_corner, var_759);
                var_763 = wp::load(var_761);
                var_762 = wp::copy(var_763);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_765 = wp::rshift(var_762, var_764);
                var_767 = wp::bit_and(var_765, var_766);
                var_768 = wp::add(var_735, var_767);
                // dz = up // SIDE                                                                <L 22>
                var_769 = wp::floordiv(var_768, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_771 = wp::bit_and(var_762, var_770);
                var_772 = wp::add(var_10, var_771);
                var_774 = wp::rshift(var_762, var_773);
                var_776 = wp::bit_and(var_774, var_775);
                var_777 = wp::add(var_11, var_776);
                var_778 = row_near_0(var_7, var_772, var_777, var_769, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_779 = wp::address(var_surface__tables__edge_axis, var_759);
                var_780 = wp::mul(var_769, var_8);
                var_781 = wp::sub(var_768, var_780);
                var_783 = wp::load(var_779);
                var_782 = vertex_of_0(var_778, var_783, var_781, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_751, var_752, var_782);
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_785 = wp::mul(var_742, var_50);
                var_787 = wp::mul(var_786, var_747);
                var_788 = wp::add(var_785, var_787);
                var_789 = wp::add(var_788, var_784);
                var_790 = wp::address(var_surface__tables__triangle_edges, var_789);
                var_792 = wp::load(var_790);
                var_791 = wp::copy(var_792);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_793 = wp::address(var_surface__tables__edge_corner, var_791);
                var_795 = wp::load(var_793);
                var_794 = wp::copy(var_795);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_797 = wp::rshift(var_794, var_796);
                var_799 = wp::bit_and(var_797, var_798);
                var_800 = wp::add(var_735, var_799);
                // dz = up // SIDE                                                                <L 22>
                var_801 = wp::floordiv(var_800, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_803 = wp::bit_and(var_794, var_802);
                var_804 = wp::add(var_10, var_803);
                var_806 = wp::rshift(var_794, var_805);
                var_808 = wp::bit_and(var_806, var_807);
                var_809 = wp::add(var_11, var_808);
                var_810 = row_near_0(var_7, var_804, var_809, var_801, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_811 = wp::address(var_surface__tables__edge_axis, var_791);
                var_812 = wp::mul(var_801, var_8);
                var_813 = wp::sub(var_800, var_812);
                var_815 = wp::load(var_811);
                var_814 = vertex_of_0(var_810, var_815, var_813, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_751, var_784, var_814);
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_817 = wp::mul(var_742, var_50);
                var_819 = wp::mul(var_818, var_747);
                var_820 = wp::add(var_817, var_819);
                var_821 = wp::add(var_820, var_816);
                var_822 = wp::address(var_surface__tables__triangle_edges, var_821);
                var_824 = wp::load(var_822);
                var_823 = wp::copy(var_824);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_825 = wp::address(var_surface__tables__edge_corner, var_823);
                var_827 = wp::load(var_825);
                var_826 = wp::copy(var_827);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_829 = wp::rshift(var_826, var_828);
                var_831 = wp::bit_and(var_829, var_830);
                var_832 = wp::add(var_735, var_831);
                // dz = up // SIDE                                                                <L 22>
                var_833 = wp::floordiv(var_832, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_835 = wp::bit_and(var_826, var_834);
                var_836 = wp::add(var_10, var_835);
                var_838 = wp::rshift(var_826, var_837);
                var_840 = wp::bit_and(var_838, var_839);
                var_841 = wp::add(var_11, var_840);
                var_842 = row_near_0(var_7, var_836, var_841, var_833, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_843 = wp::address(var_surface__tables__edge_axis, var_823);
                var_844 = wp::mul(var_833, var_8);
                var_845 = wp::sub(var_832, var_844);
                var_847 = wp::load(var_843);
                var_846 = vertex_of_0(var_842, var_847, var_845, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_751, var_816, var_846);
                // triangles[at] = triangle                                                       <L 25>
                wp::array_store(var_triangles, var_29, var_751);
                // at += 1                                                                        <L 26>
                var_849 = wp::add(var_29, var_848);
                wp::assign(var_29, var_849);
                wp::assign(var_48, var_751);
                wp::assign(var_266, var_816);
                wp::assign(var_121, var_823);
                wp::assign(var_124, var_826);
                wp::assign(var_130, var_832);
                wp::assign(var_131, var_833);
                wp::assign(var_140, var_842);
                goto start_for_13;
            end_for_13:;
        }
        var_850 = wp::where(var_740, var_742, var_733);
        var_851 = wp::where(var_740, var_747, var_734);
        // if cut >> z & 1 == 1:                                                                  <L 14>
        var_853 = wp::rshift(var_2, var_852);
        var_855 = wp::bit_and(var_853, var_854);
        var_857 = (var_855 == var_856);
        if (var_857) {
            // case = case_of(surface__words[i], w10, w01, w11, z)                                <L 15>
            var_858 = wp::address(var_surface__words, var_0);
            var_860 = wp::load(var_858);
            var_859 = case_of_0(var_860, var_15, var_19, var_25, var_852);
            // for t in range(surface__tables__triangle_count[case]):                             <L 16>
            var_861 = wp::address(var_surface__tables__triangle_count, var_859);
            var_863 = wp::load(var_861);
            var_862 = wp::range(var_863);
            start_for_15:;
                if (iter_cmp(var_862) == 0) goto end_for_15;
                var_864 = wp::iter_next(var_862);
                // triangle = vec3i(0, 0, 0)                                                      <L 17>
                var_868 = wp::vec_t<3, wp::int32>(var_865, var_866, var_867);
                // for k in range(3):                                                             <L 18>
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_870 = wp::mul(var_859, var_50);
                var_872 = wp::mul(var_871, var_864);
                var_873 = wp::add(var_870, var_872);
                var_874 = wp::add(var_873, var_869);
                var_875 = wp::address(var_surface__tables__triangle_edges, var_874);
                var_877 = wp::load(var_875);
                var_876 = wp::copy(var_877);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_878 = wp::address(var_surface__tables__edge_corner, var_876);
                var_880 = wp::load(var_878);
                var_879 = wp::copy(var_880);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_882 = wp::rshift(var_879, var_881);
                var_884 = wp::bit_and(var_882, var_883);
                var_885 = wp::add(var_852, var_884);
                // dz = up // SIDE                                                                <L 22>
                var_886 = wp::floordiv(var_885, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_888 = wp::bit_and(var_879, var_887);
                var_889 = wp::add(var_10, var_888);
                var_891 = wp::rshift(var_879, var_890);
                var_893 = wp::bit_and(var_891, var_892);
                var_894 = wp::add(var_11, var_893);
                var_895 = row_near_0(var_7, var_889, var_894, var_886, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_896 = wp::address(var_surface__tables__edge_axis, var_876);
                var_897 = wp::mul(var_886, var_8);
                var_898 = wp::sub(var_885, var_897);
                var_900 = wp::load(var_896);
                var_899 = vertex_of_0(var_895, var_900, var_898, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_868, var_869, var_899);
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_902 = wp::mul(var_859, var_50);
                var_904 = wp::mul(var_903, var_864);
                var_905 = wp::add(var_902, var_904);
                var_906 = wp::add(var_905, var_901);
                var_907 = wp::address(var_surface__tables__triangle_edges, var_906);
                var_909 = wp::load(var_907);
                var_908 = wp::copy(var_909);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_910 = wp::address(var_surface__tables__edge_corner, var_908);
                var_912 = wp::load(var_910);
                var_911 = wp::copy(var_912);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_914 = wp::rshift(var_911, var_913);
                var_916 = wp::bit_and(var_914, var_915);
                var_917 = wp::add(var_852, var_916);
                // dz = up // SIDE                                                                <L 22>
                var_918 = wp::floordiv(var_917, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_920 = wp::bit_and(var_911, var_919);
                var_921 = wp::add(var_10, var_920);
                var_923 = wp::rshift(var_911, var_922);
                var_925 = wp::bit_and(var_923, var_924);
                var_926 = wp::add(var_11, var_925);
                var_927 = row_near_0(var_7, var_921, var_926, var_918, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_928 = wp::address(var_surface__tables__edge_axis, var_908);
                var_929 = wp::mul(var_918, var_8);
                var_930 = wp::sub(var_917, var_929);
                var_932 = wp::load(var_928);
                var_931 = vertex_of_0(var_927, var_932, var_930, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_868, var_901, var_931);
                // e = surface__tables__triangle_edges[case * MAX_EDGES + 3 * t + k]              <L 19>
                var_934 = wp::mul(var_859, var_50);
                var_936 = wp::mul(var_935, var_864);
                var_937 = wp::add(var_934, var_936);
                var_938 = wp::add(var_937, var_933);
                var_939 = wp::address(var_surface__tables__triangle_edges, var_938);
                var_941 = wp::load(var_939);
                var_940 = wp::copy(var_941);
                // c = surface__tables__edge_corner[e]                                            <L 20>
                var_942 = wp::address(var_surface__tables__edge_corner, var_940);
                var_944 = wp::load(var_942);
                var_943 = wp::copy(var_944);
                // up = z + (c >> 2 & 1)                                                          <L 21>
                var_946 = wp::rshift(var_943, var_945);
                var_948 = wp::bit_and(var_946, var_947);
                var_949 = wp::add(var_852, var_948);
                // dz = up // SIDE                                                                <L 22>
                var_950 = wp::floordiv(var_949, var_8);
                // row = row_near(block, x + (c & 1), y + (c >> 1 & 1), dz, surface__seen__neighbors)       <L 23>
                var_952 = wp::bit_and(var_943, var_951);
                var_953 = wp::add(var_10, var_952);
                var_955 = wp::rshift(var_943, var_954);
                var_957 = wp::bit_and(var_955, var_956);
                var_958 = wp::add(var_11, var_957);
                var_959 = row_near_0(var_7, var_953, var_958, var_950, var_surface__seen__neighbors);
                // triangle[k] = vertex_of(row, surface__tables__edge_axis[e], up - dz * SIDE, surface__edges, surface__offsets)       <L 24>
                var_960 = wp::address(var_surface__tables__edge_axis, var_940);
                var_961 = wp::mul(var_950, var_8);
                var_962 = wp::sub(var_949, var_961);
                var_964 = wp::load(var_960);
                var_963 = vertex_of_0(var_959, var_964, var_962, var_surface__edges, var_surface__offsets);
                wp::assign_inplace(var_868, var_933, var_963);
                // triangles[at] = triangle                                                       <L 25>
                wp::array_store(var_triangles, var_29, var_868);
                // at += 1                                                                        <L 26>
                var_966 = wp::add(var_29, var_965);
                wp::assign(var_29, var_966);
                wp::assign(var_48, var_868);
                wp::assign(var_266, var_933);
                wp::assign(var_121, var_940);
                wp::assign(var_124, var_943);
                wp::assign(var_130, var_949);
                wp::assign(var_131, var_950);
                wp::assign(var_140, var_959);
                goto start_for_15;
            end_for_15:;
        }
        var_967 = wp::where(var_857, var_859, var_850);
        var_968 = wp::where(var_857, var_864, var_851);
}



extern "C" __global__ void drop_cells_kernel_5020cb36_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int64> var_surface__seen__blocks__keys,
    wp::array_t<wp::int32> var_surface__cells,
    wp::int32 var_surface__rows,
    wp::vec_t<3, wp::int32> var_low,
    wp::vec_t<3, wp::int32> var_high,
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
        const wp::int32 var_1 = 64;
        wp::int32 var_2;
        wp::int64* var_3;
        wp::vec_t<3, wp::int32> var_4;
        wp::int64 var_5;
        bool var_6;
        const wp::int32 var_7 = 0;
        wp::int32 var_8;
        const wp::int32 var_9 = 0;
        wp::int32 var_10;
        bool var_11;
        const wp::int32 var_12 = 1;
        wp::int32 var_13;
        const wp::int32 var_14 = 1;
        wp::int32 var_15;
        bool var_16;
        const wp::int32 var_17 = 2;
        wp::int32 var_18;
        const wp::int32 var_19 = 2;
        wp::int32 var_20;
        bool var_21;
        bool var_22;
        const wp::int32 var_23 = 0;
        wp::int32 var_24;
        const wp::int32 var_25 = 0;
        wp::int32 var_26;
        bool var_27;
        const wp::int32 var_28 = 1;
        wp::int32 var_29;
        const wp::int32 var_30 = 1;
        wp::int32 var_31;
        bool var_32;
        const wp::int32 var_33 = 2;
        wp::int32 var_34;
        const wp::int32 var_35 = 2;
        wp::int32 var_36;
        bool var_37;
        bool var_38;
        const wp::int32 var_39 = 0;
        const wp::int32 var_40 = 0;
        wp::int32 var_41;
        //---------
        // forward
        // def drop_cells_kernel(surface__seen__blocks__keys, surface__cells, surface__rows, low, high, counts):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // block = key_block(surface__seen__blocks__keys[i // ROWS])                              <L 3>
        var_2 = wp::floordiv(var_0, var_1);
        var_3 = wp::address(var_surface__seen__blocks__keys, var_2);
        var_5 = wp::load(var_3);
        var_4 = key_block_0(var_5);
        // inside = block[0] >= low[0] and block[1] >= low[1] and (block[2] >= low[2])            <L 4>
        var_8 = wp::extract(var_4, var_7);
        var_10 = wp::extract(var_low, var_9);
        var_11 = (var_8 >= var_10);
        var_6 = var_11;
        if (var_6) {
            var_13 = wp::extract(var_4, var_12);
            var_15 = wp::extract(var_low, var_14);
            var_16 = (var_13 >= var_15);
            var_6 = var_6 && var_16;
        }
        if (var_6) {
            var_18 = wp::extract(var_4, var_17);
            var_20 = wp::extract(var_low, var_19);
            var_21 = (var_18 >= var_20);
            var_6 = var_6 && var_21;
        }
        // if not (inside and block[0] < high[0] and (block[1] < high[1]) and (block[2] < high[2])):       <L 5>
        var_22 = var_6;
        if (var_22) {
            var_24 = wp::extract(var_4, var_23);
            var_26 = wp::extract(var_high, var_25);
            var_27 = (var_24 < var_26);
            var_22 = var_22 && var_27;
        }
        if (var_22) {
            var_29 = wp::extract(var_4, var_28);
            var_31 = wp::extract(var_high, var_30);
            var_32 = (var_29 < var_31);
            var_22 = var_22 && var_32;
        }
        if (var_22) {
            var_34 = wp::extract(var_4, var_33);
            var_36 = wp::extract(var_high, var_35);
            var_37 = (var_34 < var_36);
            var_22 = var_22 && var_37;
        }
        var_38 = wp::unot(var_22);
        if (var_38) {
            // surface__cells[i] = 0                                                              <L 6>
            wp::array_store(var_surface__cells, var_0, var_39);
            // counts[surface__rows + i] = 0                                                      <L 7>
            var_41 = wp::add(var_surface__rows, var_0);
            wp::array_store(var_counts, var_41, var_40);
        }
}



extern "C" __global__ void find_edges_kernel_757634b7_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_surface__seen__neighbors,
    wp::array_t<wp::int32> var_surface__words,
    wp::array_t<wp::int32> var_surface__cells,
    wp::array_t<wp::int32> var_surface__edges,
    wp::int32 var_need_cells,
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
        const wp::int32 var_1 = 64;
        wp::int32 var_2;
        const wp::int32 var_3 = 8;
        wp::int32 var_4;
        wp::int32 var_5;
        wp::int32 var_6;
        wp::int32* var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        const wp::int32 var_10 = 0;
        wp::int32 var_11;
        const wp::int32 var_12 = 16;
        wp::int32 var_13;
        const wp::int32 var_14 = 0;
        bool var_15;
        const wp::int32 var_16 = 1;
        wp::int32 var_17;
        const wp::int32 var_18 = 0;
        wp::int32 var_19;
        const wp::int32 var_20 = 1;
        wp::int32 var_21;
        const wp::int32 var_22 = 0;
        wp::int32 var_23;
        wp::int32 var_24;
        wp::int32 var_25;
        wp::int32 var_26;
        wp::int32 var_27;
        const wp::int32 var_28 = 255;
        wp::int32 var_29;
        wp::int32 var_30;
        wp::int32 var_31;
        wp::int32 var_32;
        wp::int32 var_33;
        wp::int32 var_34;
        wp::int32 var_35;
        const wp::int32 var_36 = 1;
        wp::int32 var_37;
        wp::int32 var_38;
        wp::int32 var_39;
        const wp::int32 var_40 = 1;
        wp::int32 var_41;
        wp::int32 var_42;
        wp::int32 var_43;
        bool var_44;
        const wp::int32 var_45 = 1;
        bool var_46;
        wp::int32 var_47;
        wp::int32 var_48;
        const wp::int32 var_49 = 0;
        bool var_50;
        wp::int32 var_51;
        const wp::int32 var_52 = 1;
        wp::int32 var_53;
        wp::int32 var_54;
        wp::int32 var_55;
        wp::int32 var_56;
        const wp::int32 var_57 = 1;
        wp::int32 var_58;
        wp::int32 var_59;
        wp::int32 var_60;
        wp::int32 var_61;
        wp::int32* var_62;
        const wp::int32 var_63 = 1;
        wp::int32 var_64;
        wp::int32 var_65;
        wp::int32 var_66;
        wp::int32 var_67;
        const wp::int32 var_68 = 1;
        wp::int32 var_69;
        wp::int32 var_70;
        wp::int32 var_71;
        const wp::int32 var_72 = 1;
        wp::int32 var_73;
        const wp::int32 var_74 = 1;
        wp::int32 var_75;
        wp::int32 var_76;
        wp::int32 var_77;
        wp::int32 var_78;
        wp::int32 var_79;
        wp::int32 var_80;
        wp::int32 var_81;
        wp::int32 var_82;
        wp::int32 var_83;
        const wp::int32 var_84 = 2;
        wp::int32 var_85;
        wp::int32 var_86;
        wp::int32 var_87;
        wp::int32 var_88;
        wp::int32 var_89;
        //---------
        // forward
        // def find_edges_kernel(surface__seen__neighbors, surface__words, surface__cells, surface__edges, need_cells, counts):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // block = i // ROWS                                                                      <L 4>
        var_2 = wp::floordiv(var_0, var_1);
        // x = i // SIDE % SIDE                                                                   <L 5>
        var_4 = wp::floordiv(var_0, var_3);
        var_5 = wp::mod(var_4, var_3);
        // y = i % SIDE                                                                           <L 6>
        var_6 = wp::mod(var_0, var_3);
        // word = surface__words[i]                                                               <L 7>
        var_7 = wp::address(var_surface__words, var_0);
        var_9 = wp::load(var_7);
        var_8 = wp::copy(var_9);
        // edges = int(0)                                                                         <L 8>
        var_11 = wp::int(var_10);
        // if word >> VALID != 0:                                                                 <L 9>
        var_13 = wp::rshift(var_8, var_12);
        var_15 = (var_13 != var_14);
        if (var_15) {
            // wx = word_near(surface__words, block, x + 1, y, 0, surface__seen__neighbors)       <L 10>
            var_17 = wp::add(var_5, var_16);
            var_19 = word_near_0(var_surface__words, var_2, var_17, var_6, var_18, var_surface__seen__neighbors);
            // wy = word_near(surface__words, block, x, y + 1, 0, surface__seen__neighbors)       <L 11>
            var_21 = wp::add(var_6, var_20);
            var_23 = word_near_0(var_surface__words, var_2, var_5, var_21, var_22, var_surface__seen__neighbors);
            // along_x = (word ^ wx) & (word & wx) >> VALID & EIGHT                               <L 12>
            var_24 = wp::bit_xor(var_8, var_19);
            var_25 = wp::bit_and(var_8, var_19);
            var_26 = wp::rshift(var_25, var_12);
            var_27 = wp::bit_and(var_24, var_26);
            var_29 = wp::bit_and(var_27, var_28);
            // along_y = (word ^ wy) & (word & wy) >> VALID & EIGHT                               <L 13>
            var_30 = wp::bit_xor(var_8, var_23);
            var_31 = wp::bit_and(var_8, var_23);
            var_32 = wp::rshift(var_31, var_12);
            var_33 = wp::bit_and(var_30, var_32);
            var_34 = wp::bit_and(var_33, var_28);
            // valid = word >> VALID                                                              <L 14>
            var_35 = wp::rshift(var_8, var_12);
            // along_z = (word ^ word >> 1) & valid & valid >> 1 & EIGHT                          <L 15>
            var_37 = wp::rshift(var_8, var_36);
            var_38 = wp::bit_xor(var_8, var_37);
            var_39 = wp::bit_and(var_38, var_35);
            var_41 = wp::rshift(var_35, var_40);
            var_42 = wp::bit_and(var_39, var_41);
            var_43 = wp::bit_and(var_42, var_28);
            // if need_cells == 1 and along_x | along_y | along_z != 0:                           <L 16>
            var_46 = (var_need_cells == var_45);
            var_44 = var_46;
            if (var_44) {
                var_47 = wp::bit_or(var_29, var_34);
                var_48 = wp::bit_or(var_47, var_43);
                var_50 = (var_48 != var_49);
                var_44 = var_44 && var_50;
            }
            if (var_44) {
                // here = cells_beside(block, x, y, surface__seen__neighbors, surface__cells)       <L 17>
                var_51 = cells_beside_0(var_2, var_5, var_6, var_surface__seen__neighbors, var_surface__cells);
                // along_x = along_x & (here | cells_beside(block, x, y - 1, surface__seen__neighbors, surface__cells))       <L 18>
                var_53 = wp::sub(var_6, var_52);
                var_54 = cells_beside_0(var_2, var_5, var_53, var_surface__seen__neighbors, var_surface__cells);
                var_55 = wp::bit_or(var_51, var_54);
                var_56 = wp::bit_and(var_29, var_55);
                // along_y = along_y & (here | cells_beside(block, x - 1, y, surface__seen__neighbors, surface__cells))       <L 19>
                var_58 = wp::sub(var_5, var_57);
                var_59 = cells_beside_0(var_2, var_58, var_6, var_surface__seen__neighbors, var_surface__cells);
                var_60 = wp::bit_or(var_51, var_59);
                var_61 = wp::bit_and(var_34, var_60);
                // around = surface__cells[i] | cells_near(block, x - 1, y, surface__seen__neighbors, surface__cells)       <L 20>
                var_62 = wp::address(var_surface__cells, var_0);
                var_64 = wp::sub(var_5, var_63);
                var_65 = cells_near_0(var_2, var_64, var_6, var_surface__seen__neighbors, var_surface__cells);
                var_67 = wp::load(var_62);
                var_66 = wp::bit_or(var_67, var_65);
                // around = around | cells_near(block, x, y - 1, surface__seen__neighbors, surface__cells)       <L 21>
                var_69 = wp::sub(var_6, var_68);
                var_70 = cells_near_0(var_2, var_5, var_69, var_surface__seen__neighbors, var_surface__cells);
                var_71 = wp::bit_or(var_66, var_70);
                // along_z = along_z & (around | cells_near(block, x - 1, y - 1, surface__seen__neighbors, surface__cells))       <L 22>
                var_73 = wp::sub(var_5, var_72);
                var_75 = wp::sub(var_6, var_74);
                var_76 = cells_near_0(var_2, var_73, var_75, var_surface__seen__neighbors, var_surface__cells);
                var_77 = wp::bit_or(var_71, var_76);
                var_78 = wp::bit_and(var_43, var_77);
            }
            var_79 = wp::where(var_44, var_56, var_29);
            var_80 = wp::where(var_44, var_61, var_34);
            var_81 = wp::where(var_44, var_78, var_43);
            // edges = along_x | along_y << SIDE | along_z << 2 * SIDE                            <L 23>
            var_82 = wp::lshift(var_80, var_3);
            var_83 = wp::bit_or(var_79, var_82);
            var_85 = wp::mul(var_84, var_3);
            var_86 = wp::lshift(var_81, var_85);
            var_87 = wp::bit_or(var_83, var_86);
        }
        var_88 = wp::where(var_15, var_87, var_11);
        // surface__edges[i] = edges                                                              <L 24>
        wp::array_store(var_surface__edges, var_0, var_88);
        // counts[i] = bit_count(edges)                                                           <L 25>
        var_89 = wp::bit_count(var_88);
        wp::array_store(var_counts, var_0, var_89);
}



extern "C" __global__ void emit_vertices_kernel_aab370e9_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::float64 var_surface__seen__blocks__voxel_size,
    wp::array_t<wp::int64> var_surface__seen__blocks__keys,
    wp::array_t<wp::float32> var_surface__seen__blocks__distances,
    wp::array_t<wp::uint16> var_surface__seen__blocks__weights,
    wp::array_t<wp::uint16> var_surface__seen__blocks__colors,
    wp::array_t<wp::int32> var_surface__seen__neighbors,
    wp::array_t<wp::int32> var_surface__edges,
    wp::array_t<wp::int32> var_surface__offsets,
    wp::int32 var_has_color,
    wp::int32 var_has_normals,
    wp::array_t<wp::vec_t<3, wp::float32>> var_vertices,
    wp::array_t<wp::vec_t<3, wp::float32>> var_colors,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals)
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
        const wp::int32 var_4 = 0;
        bool var_5;
        const wp::int32 var_6 = 64;
        wp::int32 var_7;
        const wp::int32 var_8 = 8;
        wp::int32 var_9;
        wp::int32 var_10;
        wp::int32 var_11;
        wp::int64* var_12;
        wp::vec_t<3, wp::int32> var_13;
        wp::int64 var_14;
        wp::int32* var_15;
        wp::int32 var_16;
        wp::int32 var_17;
        const wp::int32 var_18 = 3;
        wp::int32 var_19;
        wp::range_t var_20;
        wp::int32 var_21;
        wp::int32 var_22;
        const wp::int32 var_23 = 1;
        wp::int32 var_24;
        const wp::int32 var_25 = 1;
        bool var_26;
        wp::int32 var_27;
        wp::int32 var_28;
        const wp::int32 var_29 = 0;
        bool var_30;
        wp::int32 var_31;
        wp::int32 var_32;
        const wp::int32 var_33 = 1;
        bool var_34;
        wp::int32 var_35;
        wp::int32 var_36;
        const wp::int32 var_37 = 2;
        bool var_38;
        wp::int32 var_39;
        wp::int32 var_40;
        wp::int32 var_41;
        wp::int32 var_42;
        wp::int32 var_43;
        wp::float32* var_44;
        wp::float32 var_45;
        wp::float32 var_46;
        wp::float32* var_47;
        wp::float32 var_48;
        wp::float32 var_49;
        wp::float32 var_50;
        const wp::int32 var_51 = 0;
        wp::int32 var_52;
        wp::int32 var_53;
        wp::int32 var_54;
        wp::float32 var_55;
        const wp::int32 var_56 = 1;
        wp::int32 var_57;
        wp::int32 var_58;
        wp::int32 var_59;
        wp::float32 var_60;
        const wp::int32 var_61 = 2;
        wp::int32 var_62;
        wp::int32 var_63;
        wp::int32 var_64;
        wp::float32 var_65;
        wp::vec_t<3, wp::float32> var_66;
        const wp::int32 var_67 = 0;
        bool var_68;
        const wp::int32 var_69 = 0;
        wp::float32 var_70;
        wp::float32 var_71;
        const wp::int32 var_72 = 1;
        wp::float32 var_73;
        const wp::int32 var_74 = 2;
        wp::float32 var_75;
        wp::vec_t<3, wp::float32> var_76;
        wp::vec_t<3, wp::float32> var_77;
        const wp::int32 var_78 = 1;
        bool var_79;
        const wp::int32 var_80 = 0;
        wp::float32 var_81;
        const wp::int32 var_82 = 1;
        wp::float32 var_83;
        wp::float32 var_84;
        const wp::int32 var_85 = 2;
        wp::float32 var_86;
        wp::vec_t<3, wp::float32> var_87;
        wp::vec_t<3, wp::float32> var_88;
        const wp::int32 var_89 = 2;
        bool var_90;
        const wp::int32 var_91 = 0;
        wp::float32 var_92;
        const wp::int32 var_93 = 1;
        wp::float32 var_94;
        const wp::int32 var_95 = 2;
        wp::float32 var_96;
        wp::float32 var_97;
        wp::vec_t<3, wp::float32> var_98;
        wp::vec_t<3, wp::float32> var_99;
        wp::float32 var_100;
        wp::vec_t<3, wp::float32> var_101;
        const wp::int32 var_102 = 1;
        bool var_103;
        wp::vec_t<3, wp::float32> var_104;
        wp::vec_t<3, wp::float32> var_105;
        wp::vec_t<3, wp::float32> var_106;
        wp::vec_t<3, wp::float32> var_107;
        wp::vec_t<3, wp::float32> var_108;
        const wp::float32 var_109 = 255.0;
        const wp::float32 var_110 = 257.0;
        wp::float32 var_111;
        wp::vec_t<3, wp::float32> var_112;
        const wp::int32 var_113 = 1;
        bool var_114;
        wp::vec_t<3, wp::float32> var_115;
        wp::vec_t<3, wp::float32> var_116;
        wp::vec_t<3, wp::float32> var_117;
        wp::vec_t<3, wp::float32> var_118;
        wp::vec_t<3, wp::float32> var_119;
        const wp::int32 var_120 = 0;
        wp::float32 var_121;
        const wp::int32 var_122 = 0;
        wp::float32 var_123;
        wp::float32 var_124;
        const wp::int32 var_125 = 1;
        wp::float32 var_126;
        const wp::int32 var_127 = 1;
        wp::float32 var_128;
        wp::float32 var_129;
        wp::float32 var_130;
        const wp::int32 var_131 = 2;
        wp::float32 var_132;
        const wp::int32 var_133 = 2;
        wp::float32 var_134;
        wp::float32 var_135;
        wp::float32 var_136;
        wp::float32 var_137;
        const wp::float32 var_138 = 0.0;
        bool var_139;
        wp::vec_t<3, wp::float32> var_140;
        wp::vec_t<3, wp::float32> var_141;
        const wp::int32 var_142 = 1;
        wp::int32 var_143;
        wp::int32 var_144;
        //---------
        // forward
        // def emit_vertices_kernel(surface__seen__blocks__voxel_size, surface__seen__blocks__keys, surface__seen__blocks__distances, surface__seen__blocks__weights, surface__seen__blocks__colors, surface__seen__neighbors, surface__edges, surface__offsets, has_color, has_normals, vertices, colors, normals):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // marks = surface__edges[i]                                                              <L 3>
        var_1 = wp::address(var_surface__edges, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // if marks == 0:                                                                         <L 4>
        var_5 = (var_2 == var_4);
        if (var_5) {
            // return                                                                             <L 5>
            return;
        }
        // block = i // ROWS                                                                      <L 6>
        var_7 = wp::floordiv(var_0, var_6);
        // x = i // SIDE % SIDE                                                                   <L 7>
        var_9 = wp::floordiv(var_0, var_8);
        var_10 = wp::mod(var_9, var_8);
        // y = i % SIDE                                                                           <L 8>
        var_11 = wp::mod(var_0, var_8);
        // corner = key_block(surface__seen__blocks__keys[block])                                 <L 9>
        var_12 = wp::address(var_surface__seen__blocks__keys, var_7);
        var_14 = wp::load(var_12);
        var_13 = key_block_0(var_14);
        // at = surface__offsets[i]                                                               <L 10>
        var_15 = wp::address(var_surface__offsets, var_0);
        var_17 = wp::load(var_15);
        var_16 = wp::copy(var_17);
        // for e in range(3 * SIDE):                                                              <L 11>
        var_19 = wp::mul(var_18, var_8);
        var_20 = wp::range(var_19);
        start_for_1:;
            if (iter_cmp(var_20) == 0) goto end_for_1;
            var_21 = wp::iter_next(var_20);
            // if marks >> e & 1 == 1:                                                            <L 12>
            var_22 = wp::rshift(var_2, var_21);
            var_24 = wp::bit_and(var_22, var_23);
            var_26 = (var_24 == var_25);
            if (var_26) {
                // axis = e // SIDE                                                               <L 13>
                var_27 = wp::floordiv(var_21, var_8);
                // z = e % SIDE                                                                   <L 14>
                var_28 = wp::mod(var_21, var_8);
                // ox = x + int(axis == 0)                                                        <L 15>
                var_30 = (var_27 == var_29);
                var_31 = wp::int(var_30);
                var_32 = wp::add(var_10, var_31);
                // oy = y + int(axis == 1)                                                        <L 16>
                var_34 = (var_27 == var_33);
                var_35 = wp::int(var_34);
                var_36 = wp::add(var_11, var_35);
                // oz = z + int(axis == 2)                                                        <L 17>
                var_38 = (var_27 == var_37);
                var_39 = wp::int(var_38);
                var_40 = wp::add(var_28, var_39);
                // a = i * SIDE + z                                                               <L 18>
                var_41 = wp::mul(var_0, var_8);
                var_42 = wp::add(var_41, var_28);
                // b = voxel_near(block, ox, oy, oz, surface__seen__neighbors)                    <L 19>
                var_43 = voxel_near_0(var_7, var_32, var_36, var_40, var_surface__seen__neighbors);
                // before = surface__seen__blocks__distances[a]                                   <L 20>
                var_44 = wp::address(var_surface__seen__blocks__distances, var_42);
                var_46 = wp::load(var_44);
                var_45 = wp::copy(var_46);
                // share = before / (before - surface__seen__blocks__distances[b])                <L 21>
                var_47 = wp::address(var_surface__seen__blocks__distances, var_43);
                var_49 = wp::load(var_47);
                var_48 = wp::sub(var_45, var_49);
                var_50 = wp::div(var_45, var_48);
                // p = vec3(float(corner[0] * SIDE + x), float(corner[1] * SIDE + y), float(corner[2] * SIDE + z))       <L 22>
                var_52 = wp::extract(var_13, var_51);
                var_53 = wp::mul(var_52, var_8);
                var_54 = wp::add(var_53, var_10);
                var_55 = wp::float(var_54);
                var_57 = wp::extract(var_13, var_56);
                var_58 = wp::mul(var_57, var_8);
                var_59 = wp::add(var_58, var_11);
                var_60 = wp::float(var_59);
                var_62 = wp::extract(var_13, var_61);
                var_63 = wp::mul(var_62, var_8);
                var_64 = wp::add(var_63, var_28);
                var_65 = wp::float(var_64);
                var_66 = wp::vec_t<3, wp::float32>(var_55, var_60, var_65);
                // if axis == 0:                                                                  <L 23>
                var_68 = (var_27 == var_67);
                if (var_68) {
                    // p = vec3(p[0] + share, p[1], p[2])                                         <L 24>
                    var_70 = wp::extract(var_66, var_69);
                    var_71 = wp::add(var_70, var_50);
                    var_73 = wp::extract(var_66, var_72);
                    var_75 = wp::extract(var_66, var_74);
                    var_76 = wp::vec_t<3, wp::float32>(var_71, var_73, var_75);
                }
                var_77 = wp::where(var_68, var_76, var_66);
                // if axis == 1:                                                                  <L 25>
                var_79 = (var_27 == var_78);
                if (var_79) {
                    // p = vec3(p[0], p[1] + share, p[2])                                         <L 26>
                    var_81 = wp::extract(var_77, var_80);
                    var_83 = wp::extract(var_77, var_82);
                    var_84 = wp::add(var_83, var_50);
                    var_86 = wp::extract(var_77, var_85);
                    var_87 = wp::vec_t<3, wp::float32>(var_81, var_84, var_86);
                }
                var_88 = wp::where(var_79, var_87, var_77);
                // if axis == 2:                                                                  <L 27>
                var_90 = (var_27 == var_89);
                if (var_90) {
                    // p = vec3(p[0], p[1], p[2] + share)                                         <L 28>
                    var_92 = wp::extract(var_88, var_91);
                    var_94 = wp::extract(var_88, var_93);
                    var_96 = wp::extract(var_88, var_95);
                    var_97 = wp::add(var_96, var_50);
                    var_98 = wp::vec_t<3, wp::float32>(var_92, var_94, var_97);
                }
                var_99 = wp::where(var_90, var_98, var_88);
                // vertices[at] = p * float(surface__seen__blocks__voxel_size)                    <L 29>
                var_100 = wp::float(var_surface__seen__blocks__voxel_size);
                var_101 = wp::mul(var_99, var_100);
                wp::array_store(var_vertices, var_16, var_101);
                // if has_color == 1:                                                             <L 30>
                var_103 = (var_has_color == var_102);
                if (var_103) {
                    // c = voxel_color(a, surface__seen__blocks__colors)                          <L 31>
                    var_104 = voxel_color_0(var_42, var_surface__seen__blocks__colors);
                    // d = voxel_color(b, surface__seen__blocks__colors)                          <L 32>
                    var_105 = voxel_color_0(var_43, var_surface__seen__blocks__colors);
                    // colors[at] = (c + (d - c) * share) / (255.0 * COLOR_SCALE)                 <L 33>
                    var_106 = wp::sub(var_105, var_104);
                    var_107 = wp::mul(var_106, var_50);
                    var_108 = wp::add(var_104, var_107);
                    var_111 = wp::mul(var_109, var_110);
                    var_112 = wp::div(var_108, var_111);
                    wp::array_store(var_colors, var_16, var_112);
                }
                // if has_normals == 1:                                                           <L 34>
                var_114 = (var_has_normals == var_113);
                if (var_114) {
                    // g = gradient_at(block, x, y, z, surface__seen__blocks__distances, surface__seen__blocks__weights, surface__seen__neighbors)       <L 35>
                    var_115 = gradient_at_0(var_7, var_10, var_11, var_28, var_surface__seen__blocks__distances, var_surface__seen__blocks__weights, var_surface__seen__neighbors);
                    // h = gradient_at(block, ox, oy, oz, surface__seen__blocks__distances, surface__seen__blocks__weights, surface__seen__neighbors)       <L 36>
                    var_116 = gradient_at_0(var_7, var_32, var_36, var_40, var_surface__seen__blocks__distances, var_surface__seen__blocks__weights, var_surface__seen__neighbors);
                    // n = g + (h - g) * share                                                    <L 37>
                    var_117 = wp::sub(var_116, var_115);
                    var_118 = wp::mul(var_117, var_50);
                    var_119 = wp::add(var_115, var_118);
                    // size = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2])                       <L 38>
                    var_121 = wp::extract(var_119, var_120);
                    var_123 = wp::extract(var_119, var_122);
                    var_124 = wp::mul(var_121, var_123);
                    var_126 = wp::extract(var_119, var_125);
                    var_128 = wp::extract(var_119, var_127);
                    var_129 = wp::mul(var_126, var_128);
                    var_130 = wp::add(var_124, var_129);
                    var_132 = wp::extract(var_119, var_131);
                    var_134 = wp::extract(var_119, var_133);
                    var_135 = wp::mul(var_132, var_134);
                    var_136 = wp::add(var_130, var_135);
                    var_137 = wp::sqrt(var_136);
                    // if size > 0.0:                                                             <L 39>
                    var_139 = (var_137 > var_138);
                    if (var_139) {
                        // n = n / size                                                           <L 40>
                        var_140 = wp::div(var_119, var_137);
                    }
                    var_141 = wp::where(var_139, var_140, var_119);
                    // normals[at] = n                                                            <L 41>
                    wp::array_store(var_normals, var_16, var_141);
                }
                // at += 1                                                                        <L 42>
                var_143 = wp::add(var_16, var_142);
            }
            var_144 = wp::where(var_26, var_143, var_16);
            wp::assign(var_16, var_144);
            goto start_for_1;
        end_for_1:;
}



extern "C" __global__ void emit_edges_kernel_d206570c_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int64> var_surface__seen__blocks__keys,
    wp::array_t<wp::int32> var_surface__edges,
    wp::array_t<wp::int32> var_surface__offsets,
    wp::array_t<wp::int64> var_blocks,
    wp::array_t<wp::int32> var_edges)
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
        const wp::int32 var_7 = 3;
        const wp::int32 var_8 = 8;
        wp::int32 var_9;
        wp::range_t var_10;
        wp::int32 var_11;
        wp::int32 var_12;
        const wp::int32 var_13 = 1;
        wp::int32 var_14;
        const wp::int32 var_15 = 1;
        bool var_16;
        const wp::int32 var_17 = 64;
        wp::int32 var_18;
        wp::int64* var_19;
        wp::int64 var_20;
        wp::int64 var_21;
        wp::int32 var_22;
        const wp::int32 var_23 = 3;
        wp::int32 var_24;
        wp::int32 var_25;
        wp::int32 var_26;
        const wp::int32 var_27 = 1;
        wp::int32 var_28;
        wp::int32 var_29;
        //---------
        // forward
        // def emit_edges_kernel(surface__seen__blocks__keys, surface__edges, surface__offsets, blocks, edges):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // marks = surface__edges[i]                                                              <L 3>
        var_1 = wp::address(var_surface__edges, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // at = surface__offsets[i]                                                               <L 4>
        var_4 = wp::address(var_surface__offsets, var_0);
        var_6 = wp::load(var_4);
        var_5 = wp::copy(var_6);
        // for e in range(3 * SIDE):                                                              <L 5>
        var_9 = wp::mul(var_7, var_8);
        var_10 = wp::range(var_9);
        start_for_0:;
            if (iter_cmp(var_10) == 0) goto end_for_0;
            var_11 = wp::iter_next(var_10);
            // if marks >> e & 1 == 1:                                                            <L 6>
            var_12 = wp::rshift(var_2, var_11);
            var_14 = wp::bit_and(var_12, var_13);
            var_16 = (var_14 == var_15);
            if (var_16) {
                // blocks[at] = surface__seen__blocks__keys[i // ROWS]                            <L 7>
                var_18 = wp::floordiv(var_0, var_17);
                var_19 = wp::address(var_surface__seen__blocks__keys, var_18);
                var_21 = wp::load(var_19);
                var_20 = wp::copy(var_21);
                wp::array_store(var_blocks, var_5, var_20);
                // edges[at] = i % ROWS * (3 * SIDE) + e                                          <L 8>
                var_22 = wp::mod(var_0, var_17);
                var_24 = wp::mul(var_23, var_8);
                var_25 = wp::mul(var_22, var_24);
                var_26 = wp::add(var_25, var_11);
                wp::array_store(var_edges, var_5, var_26);
                // at += 1                                                                        <L 9>
                var_28 = wp::add(var_5, var_27);
            }
            var_29 = wp::where(var_16, var_28, var_5);
            wp::assign(var_5, var_29);
            goto start_for_0;
        end_for_0:;
}



extern "C" __global__ void find_cells_kernel_fa26f08d_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_surface__seen__neighbors,
    wp::array_t<wp::int32> var_surface__words,
    wp::array_t<wp::int32> var_surface__cells,
    wp::int32 var_surface__rows,
    wp::array_t<wp::int32> var_surface__tables__triangle_count,
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
        const wp::int32 var_1 = 64;
        wp::int32 var_2;
        const wp::int32 var_3 = 8;
        wp::int32 var_4;
        wp::int32 var_5;
        wp::int32 var_6;
        const wp::int32 var_7 = 0;
        wp::int32 var_8;
        const wp::int32 var_9 = 0;
        wp::int32 var_10;
        wp::int32* var_11;
        wp::int32 var_12;
        wp::int32 var_13;
        const wp::int32 var_14 = 16;
        wp::int32 var_15;
        const wp::int32 var_16 = 0;
        bool var_17;
        const wp::int32 var_18 = 1;
        wp::int32 var_19;
        const wp::int32 var_20 = 0;
        wp::int32 var_21;
        const wp::int32 var_22 = 1;
        wp::int32 var_23;
        const wp::int32 var_24 = 0;
        wp::int32 var_25;
        const wp::int32 var_26 = 1;
        wp::int32 var_27;
        const wp::int32 var_28 = 1;
        wp::int32 var_29;
        const wp::int32 var_30 = 0;
        wp::int32 var_31;
        wp::int32 var_32;
        wp::int32 var_33;
        wp::int32 var_34;
        wp::int32 var_35;
        wp::int32 var_36;
        wp::int32 var_37;
        wp::int32 var_38;
        const wp::int32 var_39 = 1;
        wp::int32 var_40;
        wp::int32 var_41;
        const wp::int32 var_42 = 255;
        wp::int32 var_43;
        const wp::int32 var_44 = 511;
        wp::int32 var_45;
        wp::int32 var_46;
        const wp::int32 var_47 = 1;
        wp::int32 var_48;
        wp::int32 var_49;
        wp::int32 var_50;
        const wp::int32 var_51 = 1;
        wp::int32 var_52;
        wp::int32 var_53;
        wp::int32 var_54;
        wp::int32 var_55;
        wp::int32 var_56;
        const wp::int32 var_57 = 0;
        bool var_58;
        const wp::int32 var_59 = 0;
        wp::int32 var_60;
        const wp::int32 var_61 = 1;
        wp::int32 var_62;
        const wp::int32 var_63 = 1;
        bool var_64;
        wp::int32 var_65;
        wp::int32* var_66;
        wp::int32 var_67;
        wp::int32 var_68;
        wp::int32 var_69;
        const wp::int32 var_70 = 1;
        wp::int32 var_71;
        const wp::int32 var_72 = 1;
        wp::int32 var_73;
        const wp::int32 var_74 = 1;
        bool var_75;
        wp::int32 var_76;
        wp::int32* var_77;
        wp::int32 var_78;
        wp::int32 var_79;
        wp::int32 var_80;
        const wp::int32 var_81 = 2;
        wp::int32 var_82;
        const wp::int32 var_83 = 1;
        wp::int32 var_84;
        const wp::int32 var_85 = 1;
        bool var_86;
        wp::int32 var_87;
        wp::int32* var_88;
        wp::int32 var_89;
        wp::int32 var_90;
        wp::int32 var_91;
        const wp::int32 var_92 = 3;
        wp::int32 var_93;
        const wp::int32 var_94 = 1;
        wp::int32 var_95;
        const wp::int32 var_96 = 1;
        bool var_97;
        wp::int32 var_98;
        wp::int32* var_99;
        wp::int32 var_100;
        wp::int32 var_101;
        wp::int32 var_102;
        const wp::int32 var_103 = 4;
        wp::int32 var_104;
        const wp::int32 var_105 = 1;
        wp::int32 var_106;
        const wp::int32 var_107 = 1;
        bool var_108;
        wp::int32 var_109;
        wp::int32* var_110;
        wp::int32 var_111;
        wp::int32 var_112;
        wp::int32 var_113;
        const wp::int32 var_114 = 5;
        wp::int32 var_115;
        const wp::int32 var_116 = 1;
        wp::int32 var_117;
        const wp::int32 var_118 = 1;
        bool var_119;
        wp::int32 var_120;
        wp::int32* var_121;
        wp::int32 var_122;
        wp::int32 var_123;
        wp::int32 var_124;
        const wp::int32 var_125 = 6;
        wp::int32 var_126;
        const wp::int32 var_127 = 1;
        wp::int32 var_128;
        const wp::int32 var_129 = 1;
        bool var_130;
        wp::int32 var_131;
        wp::int32* var_132;
        wp::int32 var_133;
        wp::int32 var_134;
        wp::int32 var_135;
        const wp::int32 var_136 = 7;
        wp::int32 var_137;
        const wp::int32 var_138 = 1;
        wp::int32 var_139;
        const wp::int32 var_140 = 1;
        bool var_141;
        wp::int32 var_142;
        wp::int32* var_143;
        wp::int32 var_144;
        wp::int32 var_145;
        wp::int32 var_146;
        wp::int32 var_147;
        wp::int32 var_148;
        wp::int32 var_149;
        wp::int32 var_150;
        //---------
        // forward
        // def find_cells_kernel(surface__seen__neighbors, surface__words, surface__cells, surface__rows, surface__tables__triangle_count, counts):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // block = i // ROWS                                                                      <L 4>
        var_2 = wp::floordiv(var_0, var_1);
        // x = i // SIDE % SIDE                                                                   <L 5>
        var_4 = wp::floordiv(var_0, var_3);
        var_5 = wp::mod(var_4, var_3);
        // y = i % SIDE                                                                           <L 6>
        var_6 = wp::mod(var_0, var_3);
        // cut = int(0)                                                                           <L 7>
        var_8 = wp::int(var_7);
        // triangles = int(0)                                                                     <L 8>
        var_10 = wp::int(var_9);
        // w00 = surface__words[i]                                                                <L 9>
        var_11 = wp::address(var_surface__words, var_0);
        var_13 = wp::load(var_11);
        var_12 = wp::copy(var_13);
        // if w00 >> VALID != 0:                                                                  <L 10>
        var_15 = wp::rshift(var_12, var_14);
        var_17 = (var_15 != var_16);
        if (var_17) {
            // w10 = word_near(surface__words, block, x + 1, y, 0, surface__seen__neighbors)       <L 11>
            var_19 = wp::add(var_5, var_18);
            var_21 = word_near_0(var_surface__words, var_2, var_19, var_6, var_20, var_surface__seen__neighbors);
            // w01 = word_near(surface__words, block, x, y + 1, 0, surface__seen__neighbors)       <L 12>
            var_23 = wp::add(var_6, var_22);
            var_25 = word_near_0(var_surface__words, var_2, var_5, var_23, var_24, var_surface__seen__neighbors);
            // w11 = word_near(surface__words, block, x + 1, y + 1, 0, surface__seen__neighbors)       <L 13>
            var_27 = wp::add(var_5, var_26);
            var_29 = wp::add(var_6, var_28);
            var_31 = word_near_0(var_surface__words, var_2, var_27, var_29, var_30, var_surface__seen__neighbors);
            // every = w00 & w10 & w01 & w11                                                      <L 14>
            var_32 = wp::bit_and(var_12, var_21);
            var_33 = wp::bit_and(var_32, var_25);
            var_34 = wp::bit_and(var_33, var_31);
            // some = w00 | w10 | w01 | w11                                                       <L 15>
            var_35 = wp::bit_or(var_12, var_21);
            var_36 = wp::bit_or(var_35, var_25);
            var_37 = wp::bit_or(var_36, var_31);
            // valid = every >> VALID                                                             <L 16>
            var_38 = wp::rshift(var_34, var_14);
            // complete = valid & valid >> 1 & EIGHT                                              <L 17>
            var_40 = wp::rshift(var_38, var_39);
            var_41 = wp::bit_and(var_38, var_40);
            var_43 = wp::bit_and(var_41, var_42);
            // negative = every & NINE                                                            <L 18>
            var_45 = wp::bit_and(var_34, var_44);
            // any_negative = some & NINE                                                         <L 19>
            var_46 = wp::bit_and(var_37, var_44);
            // cut = complete & (any_negative | any_negative >> 1) & ~(negative & negative >> 1) & EIGHT       <L 20>
            var_48 = wp::rshift(var_46, var_47);
            var_49 = wp::bit_or(var_46, var_48);
            var_50 = wp::bit_and(var_43, var_49);
            var_52 = wp::rshift(var_45, var_51);
            var_53 = wp::bit_and(var_45, var_52);
            var_54 = wp::invert(var_53);
            var_55 = wp::bit_and(var_50, var_54);
            var_56 = wp::bit_and(var_55, var_42);
            // if cut != 0:                                                                       <L 21>
            var_58 = (var_56 != var_57);
            if (var_58) {
                // for z in range(SIDE):                                                          <L 22>
                // if cut >> z & 1 == 1:                                                          <L 23>
                var_60 = wp::rshift(var_56, var_59);
                var_62 = wp::bit_and(var_60, var_61);
                var_64 = (var_62 == var_63);
                if (var_64) {
                    // triangles += surface__tables__triangle_count[case_of(w00, w10, w01, w11, z)]       <L 24>
                    var_65 = case_of_0(var_12, var_21, var_25, var_31, var_59);
                    var_66 = wp::address(var_surface__tables__triangle_count, var_65);
                    var_68 = wp::load(var_66);
                    var_67 = wp::add(var_10, var_68);
                }
                var_69 = wp::where(var_64, var_67, var_10);
                // if cut >> z & 1 == 1:                                                          <L 23>
                var_71 = wp::rshift(var_56, var_70);
                var_73 = wp::bit_and(var_71, var_72);
                var_75 = (var_73 == var_74);
                if (var_75) {
                    // triangles += surface__tables__triangle_count[case_of(w00, w10, w01, w11, z)]       <L 24>
                    var_76 = case_of_0(var_12, var_21, var_25, var_31, var_70);
                    var_77 = wp::address(var_surface__tables__triangle_count, var_76);
                    var_79 = wp::load(var_77);
                    var_78 = wp::add(var_69, var_79);
                }
                var_80 = wp::where(var_75, var_78, var_69);
                // if cut >> z & 1 == 1:                                                          <L 23>
                var_82 = wp::rshift(var_56, var_81);
                var_84 = wp::bit_and(var_82, var_83);
                var_86 = (var_84 == var_85);
                if (var_86) {
                    // triangles += surface__tables__triangle_count[case_of(w00, w10, w01, w11, z)]       <L 24>
                    var_87 = case_of_0(var_12, var_21, var_25, var_31, var_81);
                    var_88 = wp::address(var_surface__tables__triangle_count, var_87);
                    var_90 = wp::load(var_88);
                    var_89 = wp::add(var_80, var_90);
                }
                var_91 = wp::where(var_86, var_89, var_80);
                // if cut >> z & 1 == 1:                                                          <L 23>
                var_93 = wp::rshift(var_56, var_92);
                var_95 = wp::bit_and(var_93, var_94);
                var_97 = (var_95 == var_96);
                if (var_97) {
                    // triangles += surface__tables__triangle_count[case_of(w00, w10, w01, w11, z)]       <L 24>
                    var_98 = case_of_0(var_12, var_21, var_25, var_31, var_92);
                    var_99 = wp::address(var_surface__tables__triangle_count, var_98);
                    var_101 = wp::load(var_99);
                    var_100 = wp::add(var_91, var_101);
                }
                var_102 = wp::where(var_97, var_100, var_91);
                // if cut >> z & 1 == 1:                                                          <L 23>
                var_104 = wp::rshift(var_56, var_103);
                var_106 = wp::bit_and(var_104, var_105);
                var_108 = (var_106 == var_107);
                if (var_108) {
                    // triangles += surface__tables__triangle_count[case_of(w00, w10, w01, w11, z)]       <L 24>
                    var_109 = case_of_0(var_12, var_21, var_25, var_31, var_103);
                    var_110 = wp::address(var_surface__tables__triangle_count, var_109);
                    var_112 = wp::load(var_110);
                    var_111 = wp::add(var_102, var_112);
                }
                var_113 = wp::where(var_108, var_111, var_102);
                // if cut >> z & 1 == 1:                                                          <L 23>
                var_115 = wp::rshift(var_56, var_114);
                var_117 = wp::bit_and(var_115, var_116);
                var_119 = (var_117 == var_118);
                if (var_119) {
                    // triangles += surface__tables__triangle_count[case_of(w00, w10, w01, w11, z)]       <L 24>
                    var_120 = case_of_0(var_12, var_21, var_25, var_31, var_114);
                    var_121 = wp::address(var_surface__tables__triangle_count, var_120);
                    var_123 = wp::load(var_121);
                    var_122 = wp::add(var_113, var_123);
                }
                var_124 = wp::where(var_119, var_122, var_113);
                // if cut >> z & 1 == 1:                                                          <L 23>
                var_126 = wp::rshift(var_56, var_125);
                var_128 = wp::bit_and(var_126, var_127);
                var_130 = (var_128 == var_129);
                if (var_130) {
                    // triangles += surface__tables__triangle_count[case_of(w00, w10, w01, w11, z)]       <L 24>
                    var_131 = case_of_0(var_12, var_21, var_25, var_31, var_125);
                    var_132 = wp::address(var_surface__tables__triangle_count, var_131);
                    var_134 = wp::load(var_132);
                    var_133 = wp::add(var_124, var_134);
                }
                var_135 = wp::where(var_130, var_133, var_124);
                // if cut >> z & 1 == 1:                                                          <L 23>
                var_137 = wp::rshift(var_56, var_136);
                var_139 = wp::bit_and(var_137, var_138);
                var_141 = (var_139 == var_140);
                if (var_141) {
                    // triangles += surface__tables__triangle_count[case_of(w00, w10, w01, w11, z)]       <L 24>
                    var_142 = case_of_0(var_12, var_21, var_25, var_31, var_136);
                    var_143 = wp::address(var_surface__tables__triangle_count, var_142);
                    var_145 = wp::load(var_143);
                    var_144 = wp::add(var_135, var_145);
                }
                var_146 = wp::where(var_141, var_144, var_135);
            }
            var_147 = wp::where(var_58, var_146, var_10);
        }
        var_148 = wp::where(var_17, var_56, var_8);
        var_149 = wp::where(var_17, var_147, var_10);
        // surface__cells[i] = cut                                                                <L 25>
        wp::array_store(var_surface__cells, var_0, var_148);
        // counts[surface__rows + i] = triangles                                                  <L 26>
        var_150 = wp::add(var_surface__rows, var_0);
        wp::array_store(var_counts, var_150, var_149);
}


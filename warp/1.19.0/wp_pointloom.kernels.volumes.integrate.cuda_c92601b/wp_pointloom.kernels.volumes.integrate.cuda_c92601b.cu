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


// <pointloom.kernels.volumes.integrate.note_frame>:1
static CUDA_CALLABLE void note_frame_0(
    wp::int32 var_i,
    wp::array_t<wp::int32> var_counts,
    wp::array_t<wp::float64> var_record,
    wp::array_t<wp::int64> var_blocks__changes__latest)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    bool var_1;
    const wp::int32 var_2 = 0;
    wp::int32* var_3;
    const wp::int32 var_4 = 2;
    wp::int32* var_5;
    wp::int32 var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 30;
    wp::float64* var_10;
    wp::int64 var_11;
    wp::float64 var_12;
    const wp::int32 var_13 = 0;
    //---------
    // forward
    // def note_frame(i, counts, record, blocks__changes__latest):                            <L 1>
    // if i == 0:                                                                             <L 2>
    var_1 = (var_i == var_0);
    if (var_1) {
        // counts[COUNTED] = counts[COUNTED] + counts[MISSING]                                <L 3>
        var_3 = wp::address(var_counts, var_2);
        var_5 = wp::address(var_counts, var_4);
        var_7 = wp::load(var_3);
        var_8 = wp::load(var_5);
        var_6 = wp::add(var_7, var_8);
        wp::array_store(var_counts, var_2, var_6);
        // blocks__changes__latest[0] = int64(record[NUMBER])                                 <L 4>
        var_10 = wp::address(var_record, var_9);
        var_12 = wp::load(var_10);
        var_11 = wp::int64(var_12);
        wp::array_store(var_blocks__changes__latest, var_13, var_11);
    }
}


// /work/main/src/pointloom/kernels/volumes/frame_record.py:64
static CUDA_CALLABLE wp::mat_t<3, 3, wp::float64> recorded_rotation_0(
    wp::array_t<wp::float64> var_record,
    wp::int32 var_at)
{
    //---------
    // primal vars
    wp::float64* var_0;
    const wp::int32 var_1 = 1;
    wp::int32 var_2;
    wp::float64* var_3;
    const wp::int32 var_4 = 2;
    wp::int32 var_5;
    wp::float64* var_6;
    const wp::int32 var_7 = 3;
    wp::int32 var_8;
    wp::float64* var_9;
    const wp::int32 var_10 = 4;
    wp::int32 var_11;
    wp::float64* var_12;
    const wp::int32 var_13 = 5;
    wp::int32 var_14;
    wp::float64* var_15;
    const wp::int32 var_16 = 6;
    wp::int32 var_17;
    wp::float64* var_18;
    const wp::int32 var_19 = 7;
    wp::int32 var_20;
    wp::float64* var_21;
    const wp::int32 var_22 = 8;
    wp::int32 var_23;
    wp::float64* var_24;
    wp::mat_t<3, 3, wp::float64> var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    wp::float64 var_28;
    wp::float64 var_29;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    wp::float64 var_33;
    wp::float64 var_34;
    //---------
    // forward
    // def recorded_rotation(record: array(dtype=float64), at: int) -> mat33d:                <L 65>
    // return mat33d(                                                                         <L 66>
    // record[at],                                                                            <L 67>
    var_0 = wp::address(var_record, var_at);
    // record[at + 1],                                                                        <L 68>
    var_2 = wp::add(var_at, var_1);
    var_3 = wp::address(var_record, var_2);
    // record[at + 2],                                                                        <L 69>
    var_5 = wp::add(var_at, var_4);
    var_6 = wp::address(var_record, var_5);
    // record[at + 3],                                                                        <L 70>
    var_8 = wp::add(var_at, var_7);
    var_9 = wp::address(var_record, var_8);
    // record[at + 4],                                                                        <L 71>
    var_11 = wp::add(var_at, var_10);
    var_12 = wp::address(var_record, var_11);
    // record[at + 5],                                                                        <L 72>
    var_14 = wp::add(var_at, var_13);
    var_15 = wp::address(var_record, var_14);
    // record[at + 6],                                                                        <L 73>
    var_17 = wp::add(var_at, var_16);
    var_18 = wp::address(var_record, var_17);
    // record[at + 7],                                                                        <L 74>
    var_20 = wp::add(var_at, var_19);
    var_21 = wp::address(var_record, var_20);
    // record[at + 8],                                                                        <L 75>
    var_23 = wp::add(var_at, var_22);
    var_24 = wp::address(var_record, var_23);
    var_26 = wp::load(var_0);
    var_27 = wp::load(var_3);
    var_28 = wp::load(var_6);
    var_29 = wp::load(var_9);
    var_30 = wp::load(var_12);
    var_31 = wp::load(var_15);
    var_32 = wp::load(var_18);
    var_33 = wp::load(var_21);
    var_34 = wp::load(var_24);
    var_25 = wp::mat_t<3, 3, wp::float64>(var_26, var_27, var_28, var_29, var_30, var_31, var_32, var_33, var_34);
    return var_25;
}


// /work/main/src/pointloom/kernels/volumes/frame_record.py:79
static CUDA_CALLABLE wp::vec_t<3, wp::float64> recorded_translation_0(
    wp::array_t<wp::float64> var_record,
    wp::int32 var_at)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 9;
    wp::int32 var_1;
    wp::float64* var_2;
    const wp::int32 var_3 = 10;
    wp::int32 var_4;
    wp::float64* var_5;
    const wp::int32 var_6 = 11;
    wp::int32 var_7;
    wp::float64* var_8;
    wp::vec_t<3, wp::float64> var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    //---------
    // forward
    // def recorded_translation(record: array(dtype=float64), at: int) -> vec3d:              <L 80>
    // return vec3d(record[at + 9], record[at + 10], record[at + 11])                         <L 81>
    var_1 = wp::add(var_at, var_0);
    var_2 = wp::address(var_record, var_1);
    var_4 = wp::add(var_at, var_3);
    var_5 = wp::address(var_record, var_4);
    var_7 = wp::add(var_at, var_6);
    var_8 = wp::address(var_record, var_7);
    var_10 = wp::load(var_2);
    var_11 = wp::load(var_5);
    var_12 = wp::load(var_8);
    var_9 = wp::vec_t<3, wp::float64>(var_10, var_11, var_12);
    return var_9;
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


// <pointloom.kernels.volumes.integrate.project_voxel>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float32> project_voxel_0(
    wp::int32 var_i,
    wp::int32 var_block,
    wp::mat_t<3, 3, wp::float64> var_R,
    wp::vec_t<3, wp::float64> var_t,
    wp::float64 var_frame__camera__fx,
    wp::float64 var_frame__camera__fy,
    wp::float64 var_frame__camera__cx,
    wp::float64 var_frame__camera__cy,
    wp::float64 var_blocks__voxel_size,
    wp::array_t<wp::int64> var_blocks__keys)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 8;
    wp::int32 var_1;
    wp::int32 var_2;
    wp::float32 var_3;
    wp::int32 var_4;
    wp::float32 var_5;
    wp::float64 var_6;
    wp::int64* var_7;
    wp::vec_t<3, wp::int32> var_8;
    wp::int64 var_9;
    wp::vec_t<3, wp::int32> var_10;
    const wp::int32 var_11 = 0;
    wp::int32 var_12;
    const wp::int32 var_13 = 64;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::float64 var_17;
    const wp::int32 var_18 = 1;
    wp::int32 var_19;
    wp::float64 var_20;
    const wp::int32 var_21 = 2;
    wp::int32 var_22;
    wp::float64 var_23;
    wp::vec_t<3, wp::float64> var_24;
    wp::vec_t<3, wp::float64> var_25;
    wp::vec_t<3, wp::float64> var_26;
    wp::vec_t<3, wp::float64> var_27;
    wp::vec_t<3, wp::float32> var_28;
    const wp::int32 var_29 = 0;
    wp::float32 var_30;
    const wp::int32 var_31 = 0;
    const wp::int32 var_32 = 1;
    wp::float64 var_33;
    wp::float64 var_34;
    wp::float32 var_35;
    wp::float32 var_36;
    wp::float32 var_37;
    const wp::int32 var_38 = 1;
    wp::float32 var_39;
    const wp::int32 var_40 = 1;
    const wp::int32 var_41 = 1;
    wp::float64 var_42;
    wp::float64 var_43;
    wp::float32 var_44;
    wp::float32 var_45;
    wp::float32 var_46;
    const wp::int32 var_47 = 2;
    wp::float32 var_48;
    const wp::int32 var_49 = 2;
    const wp::int32 var_50 = 1;
    wp::float64 var_51;
    wp::float64 var_52;
    wp::float32 var_53;
    wp::float32 var_54;
    wp::float32 var_55;
    const wp::int32 var_56 = 2;
    const wp::int32 var_57 = 2;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float32 var_60;
    wp::float32 var_61;
    wp::float32 var_62;
    const wp::float32 var_63 = 1.0;
    const wp::float32 var_64 = 1e-06;
    wp::float32 var_65;
    wp::float32 var_66;
    const wp::int32 var_67 = 0;
    const wp::int32 var_68 = 2;
    wp::float64 var_69;
    wp::float64 var_70;
    wp::float32 var_71;
    wp::float32 var_72;
    wp::float32 var_73;
    wp::float32 var_74;
    wp::float32 var_75;
    wp::float32 var_76;
    wp::float32 var_77;
    const wp::float32 var_78 = 0.5;
    wp::float32 var_79;
    wp::float32 var_80;
    const wp::int32 var_81 = 1;
    const wp::int32 var_82 = 2;
    wp::float64 var_83;
    wp::float64 var_84;
    wp::float32 var_85;
    wp::float32 var_86;
    wp::float32 var_87;
    wp::float32 var_88;
    wp::float32 var_89;
    wp::float32 var_90;
    wp::float32 var_91;
    const wp::float32 var_92 = 0.5;
    wp::float32 var_93;
    wp::float32 var_94;
    wp::vec_t<3, wp::float32> var_95;
    //---------
    // forward
    // def project_voxel(i, block, R, t, frame__camera__fx, frame__camera__fy, frame__camera__cx, frame__camera__cy, blocks__voxel_size, blocks__keys):       <L 1>
    // row = float(i // SIDE % SIDE)                                                          <L 3>
    var_1 = wp::floordiv(var_i, var_0);
    var_2 = wp::mod(var_1, var_0);
    var_3 = wp::float(var_2);
    // j = float(i % SIDE)                                                                    <L 4>
    var_4 = wp::mod(var_i, var_0);
    var_5 = wp::float(var_4);
    // size = blocks__voxel_size                                                              <L 5>
    var_6 = wp::copy(var_blocks__voxel_size);
    // corner = key_block(blocks__keys[block]) * SIDE                                         <L 6>
    var_7 = wp::address(var_blocks__keys, var_block);
    var_9 = wp::load(var_7);
    var_8 = key_block_0(var_9);
    var_10 = wp::mul(var_8, var_0);
    // x = corner[0] + i // ROWS % SIDE                                                       <L 7>
    var_12 = wp::extract(var_10, var_11);
    var_14 = wp::floordiv(var_i, var_13);
    var_15 = wp::mod(var_14, var_0);
    var_16 = wp::add(var_12, var_15);
    // p = narrow(R @ (vec3d(float64(x), float64(corner[1]), float64(corner[2])) * size) + t)       <L 8>
    var_17 = wp::float64(var_16);
    var_19 = wp::extract(var_10, var_18);
    var_20 = wp::float64(var_19);
    var_22 = wp::extract(var_10, var_21);
    var_23 = wp::float64(var_22);
    var_24 = wp::vec_t<3, wp::float64>(var_17, var_20, var_23);
    var_25 = wp::mul(var_24, var_6);
    var_26 = wp::mul(var_R, var_25);
    var_27 = wp::add(var_26, var_t);
    var_28 = narrow_0(var_27);
    // p0 = p[0] + float(R[0, 1] * size) * row                                                <L 9>
    var_30 = wp::extract(var_28, var_29);
    var_33 = wp::extract(var_R, var_31, var_32);
    var_34 = wp::mul(var_33, var_6);
    var_35 = wp::float(var_34);
    var_36 = wp::mul(var_35, var_3);
    var_37 = wp::add(var_30, var_36);
    // p1 = p[1] + float(R[1, 1] * size) * row                                                <L 10>
    var_39 = wp::extract(var_28, var_38);
    var_42 = wp::extract(var_R, var_40, var_41);
    var_43 = wp::mul(var_42, var_6);
    var_44 = wp::float(var_43);
    var_45 = wp::mul(var_44, var_3);
    var_46 = wp::add(var_39, var_45);
    // p2 = p[2] + float(R[2, 1] * size) * row                                                <L 11>
    var_48 = wp::extract(var_28, var_47);
    var_51 = wp::extract(var_R, var_49, var_50);
    var_52 = wp::mul(var_51, var_6);
    var_53 = wp::float(var_52);
    var_54 = wp::mul(var_53, var_3);
    var_55 = wp::add(var_48, var_54);
    // depth_z = p2 + float(R[2, 2] * size) * j                                               <L 12>
    var_58 = wp::extract(var_R, var_56, var_57);
    var_59 = wp::mul(var_58, var_6);
    var_60 = wp::float(var_59);
    var_61 = wp::mul(var_60, var_5);
    var_62 = wp::add(var_55, var_61);
    // scale = 1.0 / larger(depth_z, NEAREST)                                                 <L 13>
    var_65 = larger_0(var_62, var_64);
    var_66 = wp::div(var_63, var_65);
    // u = (p0 + float(R[0, 2] * size) * j) * scale * float(frame__camera__fx) + (float(frame__camera__cx) + 0.5)       <L 14>
    var_69 = wp::extract(var_R, var_67, var_68);
    var_70 = wp::mul(var_69, var_6);
    var_71 = wp::float(var_70);
    var_72 = wp::mul(var_71, var_5);
    var_73 = wp::add(var_37, var_72);
    var_74 = wp::mul(var_73, var_66);
    var_75 = wp::float(var_frame__camera__fx);
    var_76 = wp::mul(var_74, var_75);
    var_77 = wp::float(var_frame__camera__cx);
    var_79 = wp::add(var_77, var_78);
    var_80 = wp::add(var_76, var_79);
    // v = (p1 + float(R[1, 2] * size) * j) * scale * float(frame__camera__fy) + (float(frame__camera__cy) + 0.5)       <L 15>
    var_83 = wp::extract(var_R, var_81, var_82);
    var_84 = wp::mul(var_83, var_6);
    var_85 = wp::float(var_84);
    var_86 = wp::mul(var_85, var_5);
    var_87 = wp::add(var_46, var_86);
    var_88 = wp::mul(var_87, var_66);
    var_89 = wp::float(var_frame__camera__fy);
    var_90 = wp::mul(var_88, var_89);
    var_91 = wp::float(var_frame__camera__cy);
    var_93 = wp::add(var_91, var_92);
    var_94 = wp::add(var_90, var_93);
    // return vec3(u, v, depth_z)                                                             <L 16>
    var_95 = wp::vec_t<3, wp::float32>(var_80, var_94, var_62);
    return var_95;
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


// /work/main/src/pointloom/kernels/volumes/integrate.py:81
static CUDA_CALLABLE wp::int32 pixel_of_0(
    wp::float32 var_u,
    wp::float32 var_v,
    wp::float32 var_right,
    wp::float32 var_bottom,
    wp::int32 var_width)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    wp::float32 var_1;
    const wp::float32 var_2 = 1.0;
    wp::float32 var_3;
    wp::float32 var_4;
    wp::int32 var_5;
    const wp::float32 var_6 = 0.0;
    wp::float32 var_7;
    const wp::float32 var_8 = 1.0;
    wp::float32 var_9;
    wp::float32 var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    //---------
    // forward
    // def pixel_of(u: float, v: float, right: float, bottom: float, width: int) -> int:       <L 82>
    // column = int(smaller(larger(u, 0.0), right - 1.0))                                     <L 83>
    var_1 = larger_0(var_u, var_0);
    var_3 = wp::sub(var_right, var_2);
    var_4 = smaller_0(var_1, var_3);
    var_5 = wp::int(var_4);
    // return int(smaller(larger(v, 0.0), bottom - 1.0)) * width + column                     <L 84>
    var_7 = larger_0(var_v, var_6);
    var_9 = wp::sub(var_bottom, var_8);
    var_10 = smaller_0(var_7, var_9);
    var_11 = wp::int(var_10);
    var_12 = wp::mul(var_11, var_width);
    var_13 = wp::add(var_12, var_5);
    return var_13;
}


// /work/main/src/pointloom/kernels/volumes/integrate.py:87
static CUDA_CALLABLE wp::float32 margin_of_1(
    wp::float32 var_u,
    wp::float32 var_v,
    wp::float32 var_right,
    wp::float32 var_bottom,
    wp::float32 var_z,
    wp::float32 var_d,
    wp::float32 var_truncation)
{
    //---------
    // primal vars
    wp::float32 var_0;
    wp::float32 var_1;
    wp::float32 var_2;
    wp::float32 var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    wp::float32 var_6;
    wp::float32 var_7;
    wp::float32 var_8;
    wp::float32 var_9;
    //---------
    // forward
    // def margin_of(u: float, v: float, right: float, bottom: float, z: float, d: float, truncation: float) -> float:       <L 88>
    // inside = smaller(smaller(u, right - u), smaller(v, bottom - v))                        <L 90>
    var_0 = wp::sub(var_right, var_u);
    var_1 = smaller_0(var_u, var_0);
    var_2 = wp::sub(var_bottom, var_v);
    var_3 = smaller_0(var_v, var_2);
    var_4 = smaller_0(var_1, var_3);
    // return smaller(inside, smaller(smaller(z, d), d - z + truncation))                     <L 91>
    var_5 = smaller_0(var_z, var_d);
    var_6 = wp::sub(var_d, var_z);
    var_7 = wp::add(var_6, var_truncation);
    var_8 = smaller_0(var_5, var_7);
    var_9 = smaller_0(var_4, var_8);
    return var_9;
}


// /work/main/src/pointloom/kernels/volumes/integrate.py:65
static CUDA_CALLABLE wp::float32 changed_mean_0(
    wp::float32 var_mean,
    wp::float32 var_w,
    wp::float32 var_value,
    wp::float32 var_change)
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
    // def changed_mean(mean: float, w: float, value: float, change: float) -> float:         <L 66>
    // return (mean * w + change * value) / (w + change)                                      <L 68>
    var_0 = wp::mul(var_mean, var_w);
    var_1 = wp::mul(var_change, var_value);
    var_2 = wp::add(var_0, var_1);
    var_3 = wp::add(var_w, var_change);
    var_4 = wp::div(var_2, var_3);
    return var_4;
}


// <pointloom.kernels.volumes.integrate.change_color>:1
static CUDA_CALLABLE void change_color_0(
    wp::int32 var_voxel,
    wp::int32 var_pixel,
    wp::float32 var_change,
    wp::array_t<wp::uint8> var_frame__pixels,
    wp::array_t<wp::uint16> var_blocks__weights,
    wp::array_t<wp::uint16> var_blocks__colors)
{
    //---------
    // primal vars
    wp::uint16* var_0;
    wp::float32 var_1;
    wp::uint16 var_2;
    const wp::int32 var_3 = 0;
    wp::uint8* var_4;
    wp::float32 var_5;
    wp::uint8 var_6;
    const wp::float32 var_7 = 257.0;
    wp::float32 var_8;
    wp::uint16* var_9;
    wp::float32 var_10;
    wp::uint16 var_11;
    wp::float32 var_12;
    const wp::float32 var_13 = 0.0;
    wp::float32 var_14;
    const wp::float32 var_15 = 65535.0;
    wp::float32 var_16;
    const wp::float32 var_17 = 0.5;
    wp::float32 var_18;
    wp::uint16 var_19;
    const wp::int32 var_20 = 1;
    wp::uint8* var_21;
    wp::float32 var_22;
    wp::uint8 var_23;
    wp::float32 var_24;
    wp::uint16* var_25;
    wp::float32 var_26;
    wp::uint16 var_27;
    wp::float32 var_28;
    const wp::float32 var_29 = 0.0;
    wp::float32 var_30;
    wp::float32 var_31;
    const wp::float32 var_32 = 0.5;
    wp::float32 var_33;
    wp::uint16 var_34;
    const wp::int32 var_35 = 2;
    wp::uint8* var_36;
    wp::float32 var_37;
    wp::uint8 var_38;
    wp::float32 var_39;
    wp::uint16* var_40;
    wp::float32 var_41;
    wp::uint16 var_42;
    wp::float32 var_43;
    const wp::float32 var_44 = 0.0;
    wp::float32 var_45;
    wp::float32 var_46;
    const wp::float32 var_47 = 0.5;
    wp::float32 var_48;
    wp::uint16 var_49;
    //---------
    // forward
    // def change_color(voxel, pixel, change, frame__pixels, blocks__weights, blocks__colors):       <L 1>
    // w = float(blocks__weights[voxel])                                                      <L 3>
    var_0 = wp::address(var_blocks__weights, var_voxel);
    var_2 = wp::load(var_0);
    var_1 = wp::float(var_2);
    // for c in range(3):                                                                     <L 4>
    // shade = float(frame__pixels[pixel, c]) * COLOR_SCALE                                   <L 5>
    var_4 = wp::address(var_frame__pixels, var_pixel, var_3);
    var_6 = wp::load(var_4);
    var_5 = wp::float(var_6);
    var_8 = wp::mul(var_5, var_7);
    // mean = changed_mean(float(blocks__colors[voxel, c]), w, shade, change)                 <L 6>
    var_9 = wp::address(var_blocks__colors, var_voxel, var_3);
    var_11 = wp::load(var_9);
    var_10 = wp::float(var_11);
    var_12 = changed_mean_0(var_10, var_1, var_8, var_change);
    // blocks__colors[voxel, c] = uint16(smaller(larger(mean, 0.0), COLOR_LIMIT) + 0.5)       <L 7>
    var_14 = larger_0(var_12, var_13);
    var_16 = smaller_0(var_14, var_15);
    var_18 = wp::add(var_16, var_17);
    var_19 = wp::uint16(var_18);
    wp::array_store(var_blocks__colors, var_voxel, var_3, var_19);
    // shade = float(frame__pixels[pixel, c]) * COLOR_SCALE                                   <L 5>
    var_21 = wp::address(var_frame__pixels, var_pixel, var_20);
    var_23 = wp::load(var_21);
    var_22 = wp::float(var_23);
    var_24 = wp::mul(var_22, var_7);
    // mean = changed_mean(float(blocks__colors[voxel, c]), w, shade, change)                 <L 6>
    var_25 = wp::address(var_blocks__colors, var_voxel, var_20);
    var_27 = wp::load(var_25);
    var_26 = wp::float(var_27);
    var_28 = changed_mean_0(var_26, var_1, var_24, var_change);
    // blocks__colors[voxel, c] = uint16(smaller(larger(mean, 0.0), COLOR_LIMIT) + 0.5)       <L 7>
    var_30 = larger_0(var_28, var_29);
    var_31 = smaller_0(var_30, var_15);
    var_33 = wp::add(var_31, var_32);
    var_34 = wp::uint16(var_33);
    wp::array_store(var_blocks__colors, var_voxel, var_20, var_34);
    // shade = float(frame__pixels[pixel, c]) * COLOR_SCALE                                   <L 5>
    var_36 = wp::address(var_frame__pixels, var_pixel, var_35);
    var_38 = wp::load(var_36);
    var_37 = wp::float(var_38);
    var_39 = wp::mul(var_37, var_7);
    // mean = changed_mean(float(blocks__colors[voxel, c]), w, shade, change)                 <L 6>
    var_40 = wp::address(var_blocks__colors, var_voxel, var_35);
    var_42 = wp::load(var_40);
    var_41 = wp::float(var_42);
    var_43 = changed_mean_0(var_41, var_1, var_39, var_change);
    // blocks__colors[voxel, c] = uint16(smaller(larger(mean, 0.0), COLOR_LIMIT) + 0.5)       <L 7>
    var_45 = larger_0(var_43, var_44);
    var_46 = smaller_0(var_45, var_15);
    var_48 = wp::add(var_46, var_47);
    var_49 = wp::uint16(var_48);
    wp::array_store(var_blocks__colors, var_voxel, var_35, var_49);
}


// <pointloom.kernels.volumes.integrate.note_frame>:1
static CUDA_CALLABLE void adj_note_frame_0(
    wp::int32 var_i,
    wp::array_t<wp::int32> var_counts,
    wp::array_t<wp::float64> var_record,
    wp::array_t<wp::int64> var_blocks__changes__latest,
    wp::int32 & adj_i,
    wp::array_t<wp::int32> & adj_counts,
    wp::array_t<wp::float64> & adj_record,
    wp::array_t<wp::int64> & adj_blocks__changes__latest)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/volumes/frame_record.py:64
static CUDA_CALLABLE void adj_recorded_rotation_0(
    wp::array_t<wp::float64> var_record,
    wp::int32 var_at,
    wp::array_t<wp::float64> & adj_record,
    wp::int32 & adj_at,
    wp::mat_t<3, 3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/volumes/frame_record.py:79
static CUDA_CALLABLE void adj_recorded_translation_0(
    wp::array_t<wp::float64> var_record,
    wp::int32 var_at,
    wp::array_t<wp::float64> & adj_record,
    wp::int32 & adj_at,
    wp::vec_t<3, wp::float64> & adj_ret)
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


// /work/main/src/pointloom/kernels/algebra/transform.py:32
static CUDA_CALLABLE void adj_narrow_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::vec_t<3, wp::float32> & adj_ret)
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


// <pointloom.kernels.volumes.integrate.project_voxel>:1
static CUDA_CALLABLE void adj_project_voxel_0(
    wp::int32 var_i,
    wp::int32 var_block,
    wp::mat_t<3, 3, wp::float64> var_R,
    wp::vec_t<3, wp::float64> var_t,
    wp::float64 var_frame__camera__fx,
    wp::float64 var_frame__camera__fy,
    wp::float64 var_frame__camera__cx,
    wp::float64 var_frame__camera__cy,
    wp::float64 var_blocks__voxel_size,
    wp::array_t<wp::int64> var_blocks__keys,
    wp::int32 & adj_i,
    wp::int32 & adj_block,
    wp::mat_t<3, 3, wp::float64> & adj_R,
    wp::vec_t<3, wp::float64> & adj_t,
    wp::float64 & adj_frame__camera__fx,
    wp::float64 & adj_frame__camera__fy,
    wp::float64 & adj_frame__camera__cx,
    wp::float64 & adj_frame__camera__cy,
    wp::float64 & adj_blocks__voxel_size,
    wp::array_t<wp::int64> & adj_blocks__keys,
    wp::vec_t<3, wp::float32> & adj_ret)
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


// /work/main/src/pointloom/kernels/volumes/integrate.py:81
static CUDA_CALLABLE void adj_pixel_of_0(
    wp::float32 var_u,
    wp::float32 var_v,
    wp::float32 var_right,
    wp::float32 var_bottom,
    wp::int32 var_width,
    wp::float32 & adj_u,
    wp::float32 & adj_v,
    wp::float32 & adj_right,
    wp::float32 & adj_bottom,
    wp::int32 & adj_width,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/volumes/integrate.py:87
static CUDA_CALLABLE void adj_margin_of_1(
    wp::float32 var_u,
    wp::float32 var_v,
    wp::float32 var_right,
    wp::float32 var_bottom,
    wp::float32 var_z,
    wp::float32 var_d,
    wp::float32 var_truncation,
    wp::float32 & adj_u,
    wp::float32 & adj_v,
    wp::float32 & adj_right,
    wp::float32 & adj_bottom,
    wp::float32 & adj_z,
    wp::float32 & adj_d,
    wp::float32 & adj_truncation,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/volumes/integrate.py:65
static CUDA_CALLABLE void adj_changed_mean_0(
    wp::float32 var_mean,
    wp::float32 var_w,
    wp::float32 var_value,
    wp::float32 var_change,
    wp::float32 & adj_mean,
    wp::float32 & adj_w,
    wp::float32 & adj_value,
    wp::float32 & adj_change,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.integrate.change_color>:1
static CUDA_CALLABLE void adj_change_color_0(
    wp::int32 var_voxel,
    wp::int32 var_pixel,
    wp::float32 var_change,
    wp::array_t<wp::uint8> var_frame__pixels,
    wp::array_t<wp::uint16> var_blocks__weights,
    wp::array_t<wp::uint16> var_blocks__colors,
    wp::int32 & adj_voxel,
    wp::int32 & adj_pixel,
    wp::float32 & adj_change,
    wp::array_t<wp::uint8> & adj_frame__pixels,
    wp::array_t<wp::uint16> & adj_blocks__weights,
    wp::array_t<wp::uint16> & adj_blocks__colors)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void WP_MAXNREG(64) integrate_voxels_kernel_572916b4_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_touched,
    wp::array_t<wp::int32> var_counts,
    wp::array_t<wp::float64> var_record,
    wp::int32 var_stride,
    wp::array_t<wp::float32> var_frame__depth,
    wp::array_t<wp::uint8> var_frame__pixels,
    wp::int32 var_frame__has_color,
    wp::int32 var_frame__camera__width,
    wp::int32 var_frame__camera__height,
    wp::float64 var_frame__camera__fx,
    wp::float64 var_frame__camera__fy,
    wp::float64 var_frame__camera__cx,
    wp::float64 var_frame__camera__cy,
    wp::float64 var_blocks__voxel_size,
    wp::float64 var_blocks__truncation,
    wp::array_t<wp::int64> var_blocks__keys,
    wp::array_t<wp::float32> var_blocks__distances,
    wp::array_t<wp::uint16> var_blocks__weights,
    wp::array_t<wp::uint16> var_blocks__colors,
    wp::array_t<wp::int64> var_blocks__changes__latest)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 12;
        wp::mat_t<3, 3, wp::float64> var_2;
        wp::vec_t<3, wp::float64> var_3;
        wp::int32 var_4;
        wp::float32 var_5;
        wp::float32 var_6;
        wp::float32 var_7;
        const wp::int32 var_8 = 512;
        wp::int32 var_9;
        const wp::int32 var_10 = 1;
        wp::int32* var_11;
        bool var_12;
        wp::int32 var_13;
        wp::int32* var_14;
        wp::int32 var_15;
        wp::int32 var_16;
        wp::int32 var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::int32 var_20;
        wp::vec_t<3, wp::float32> var_21;
        const wp::int32 var_22 = 0;
        wp::float32 var_23;
        const wp::int32 var_24 = 1;
        wp::float32 var_25;
        const wp::int32 var_26 = 2;
        wp::float32 var_27;
        wp::int32 var_28;
        wp::float32* var_29;
        wp::float32 var_30;
        wp::float32 var_31;
        wp::float32 var_32;
        const wp::float32 var_33 = 0.0;
        bool var_34;
        wp::float32 var_35;
        const wp::float32 var_36 = 1.0;
        wp::float32 var_37;
        wp::float32 var_38;
        const wp::float32 var_39 = 1.0;
        wp::float32 var_40;
        const wp::int32 var_41 = 1;
        bool var_42;
        const wp::float32 var_43 = 1.0;
        wp::uint16* var_44;
        wp::float32 var_45;
        wp::uint16 var_46;
        wp::float32* var_47;
        const wp::float32 var_48 = 1.0;
        wp::float32 var_49;
        wp::float32 var_50;
        const wp::float32 var_51 = 1.0;
        wp::float32 var_52;
        const wp::float32 var_53 = 65535.0;
        wp::float32 var_54;
        wp::uint16 var_55;
        //---------
        // forward
        // def integrate_voxels_kernel(touched, counts, record, stride, frame__depth, frame__pixels, frame__has_color, frame__camera__width, frame__camera__height, frame__camera__fx, frame__camera__fy, frame__camera__cx, frame__camera__cy, blocks__voxel_size, blocks__truncation, blocks__keys, blocks__distances, blocks__weights, blocks__colors, blocks__changes__latest):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // note_frame(i, counts, record, blocks__changes__latest)                                 <L 4>
        note_frame_0(var_0, var_counts, var_record, var_blocks__changes__latest);
        // R = recorded_rotation(record, INTO_CAMERA)                                             <L 5>
        var_2 = recorded_rotation_0(var_record, var_1);
        // t = recorded_translation(record, INTO_CAMERA)                                          <L 6>
        var_3 = recorded_translation_0(var_record, var_1);
        // width = frame__camera__width                                                           <L 7>
        var_4 = wp::copy(var_frame__camera__width);
        // truncation = float(blocks__truncation)                                                 <L 8>
        var_5 = wp::float(var_blocks__truncation);
        // right = float(width)                                                                   <L 9>
        var_6 = wp::float(var_4);
        // bottom = float(frame__camera__height)                                                  <L 10>
        var_7 = wp::float(var_frame__camera__height);
        // at = i // BLOCK_VOXELS                                                                 <L 11>
        var_9 = wp::floordiv(var_0, var_8);
        // while at < counts[TOUCHED]:                                                            <L 12>
        start_while_0:;
        var_11 = wp::address(var_counts, var_10);
        var_13 = wp::load(var_11);
        var_12 = (var_9 < var_13);
        if ((var_12) == false) goto end_while_0;
            // block = touched[at]                                                                <L 13>
            var_14 = wp::address(var_touched, var_9);
            var_16 = wp::load(var_14);
            var_15 = wp::copy(var_16);
            // at += stride                                                                       <L 14>
            var_17 = wp::add(var_9, var_stride);
            // voxel = block * BLOCK_VOXELS + i % BLOCK_VOXELS                                    <L 15>
            var_18 = wp::mul(var_15, var_8);
            var_19 = wp::mod(var_0, var_8);
            var_20 = wp::add(var_18, var_19);
            // at_pixel = project_voxel(i, block, R, t, frame__camera__fx, frame__camera__fy, frame__camera__cx, frame__camera__cy, blocks__voxel_size, blocks__keys)       <L 16>
            var_21 = project_voxel_0(var_0, var_15, var_2, var_3, var_frame__camera__fx, var_frame__camera__fy, var_frame__camera__cx, var_frame__camera__cy, var_blocks__voxel_size, var_blocks__keys);
            // u = at_pixel[0]                                                                    <L 17>
            var_23 = wp::extract(var_21, var_22);
            // v = at_pixel[1]                                                                    <L 18>
            var_25 = wp::extract(var_21, var_24);
            // depth_z = at_pixel[2]                                                              <L 19>
            var_27 = wp::extract(var_21, var_26);
            // pixel = pixel_of(u, v, right, bottom, width)                                       <L 20>
            var_28 = pixel_of_0(var_23, var_25, var_6, var_7, var_4);
            // d = frame__depth[pixel]                                                            <L 21>
            var_29 = wp::address(var_frame__depth, var_28);
            var_31 = wp::load(var_29);
            var_30 = wp::copy(var_31);
            // if margin_of(u, v, right, bottom, depth_z, d, truncation) > 0.0:                   <L 22>
            var_32 = margin_of_1(var_23, var_25, var_6, var_7, var_27, var_30, var_5);
            var_34 = (var_32 > var_33);
            if (var_34) {
                // value = smaller((d - depth_z) * (1.0 / truncation), 1.0)                       <L 23>
                var_35 = wp::sub(var_30, var_27);
                var_37 = wp::div(var_36, var_5);
                var_38 = wp::mul(var_35, var_37);
                var_40 = smaller_0(var_38, var_39);
                // if frame__has_color == 1:                                                      <L 24>
                var_42 = (var_frame__has_color == var_41);
                if (var_42) {
                    // change_color(voxel, pixel, 1.0, frame__pixels, blocks__weights, blocks__colors)       <L 25>
                    change_color_0(var_20, var_28, var_43, var_frame__pixels, var_blocks__weights, var_blocks__colors);
                }
                // w = float(blocks__weights[voxel])                                              <L 26>
                var_44 = wp::address(var_blocks__weights, var_20);
                var_46 = wp::load(var_44);
                var_45 = wp::float(var_46);
                // blocks__distances[voxel] = changed_mean(blocks__distances[voxel], w, value, 1.0)       <L 27>
                var_47 = wp::address(var_blocks__distances, var_20);
                var_50 = wp::load(var_47);
                var_49 = changed_mean_0(var_50, var_45, var_40, var_48);
                wp::array_store(var_blocks__distances, var_20, var_49);
                // blocks__weights[voxel] = uint16(min(w + 1.0, MAX_WEIGHT))                      <L 28>
                var_52 = wp::add(var_45, var_51);
                var_54 = wp::min(var_52, var_53);
                var_55 = wp::uint16(var_54);
                wp::array_store(var_blocks__weights, var_20, var_55);
            }
            wp::assign(var_9, var_17);
        goto start_while_0;
        end_while_0:;
}


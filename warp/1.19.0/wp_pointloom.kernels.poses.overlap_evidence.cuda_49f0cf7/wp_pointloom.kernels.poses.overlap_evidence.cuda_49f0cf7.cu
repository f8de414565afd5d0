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


// <pointloom.kernels.poses.overlap_evidence.sum_deviating_element>:1
static CUDA_CALLABLE wp::vec_t<2, wp::float64> sum_deviating_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved_normals,
    wp::array_t<wp::int64> var_overlap__nearest,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__normals,
    wp::float32 var_overlap__distance,
    wp::float32 var_overlap__cosine,
    wp::array_t<wp::float32> var_spreads,
    wp::array_t<wp::float32> var_other_spreads,
    wp::float32 var_sigmas,
    wp::float32 var_floor,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::vec_t<2, wp::float64> var_1;
    wp::int64* var_2;
    wp::int64 var_3;
    bool var_4;
    wp::int64 var_5;
    wp::int32 var_6;
    const wp::int32 var_7 = 1;
    bool var_8;
    wp::int64* var_9;
    wp::int32 var_10;
    wp::int64 var_11;
    wp::vec_t<3, wp::float32>* var_12;
    wp::vec_t<3, wp::float32>* var_13;
    wp::vec_t<3, wp::float32> var_14;
    wp::vec_t<3, wp::float32> var_15;
    wp::vec_t<3, wp::float32> var_16;
    wp::vec_t<3, wp::float32>* var_17;
    wp::float32 var_18;
    wp::vec_t<3, wp::float32> var_19;
    wp::float32* var_20;
    wp::float32* var_21;
    wp::float32 var_22;
    wp::float32 var_23;
    wp::float32 var_24;
    wp::float32* var_25;
    wp::float32* var_26;
    wp::float32 var_27;
    wp::float32 var_28;
    wp::float32 var_29;
    wp::float32 var_30;
    wp::float64 var_31;
    wp::float32 var_32;
    wp::float32 var_33;
    wp::float32 var_34;
    wp::float32 var_35;
    wp::float32 var_36;
    bool var_37;
    wp::float64 var_38;
    wp::float64 var_39;
    wp::float64 var_40;
    wp::vec_t<2, wp::float64> var_41;
    wp::vec_t<2, wp::float64> var_42;
    wp::vec_t<2, wp::float64> var_43;
    //---------
    // forward
    // def sum_deviating_element(overlap__moved, overlap__moved_normals, overlap__nearest, overlap__points, overlap__normals, overlap__distance, overlap__cosine, spreads, other_spreads, sigmas, floor, i):       <L 1>
    // out = deviation_sums(float64(0.0))                                                     <L 2>
    var_0 = 0.0;
    var_1 = wp::vec_t<2, wp::float64>(var_0);
    // if overlap__nearest[i] != int64(NO_POINT):                                             <L 3>
    var_2 = wp::address(var_overlap__nearest, var_i);
    var_3 = -1ll;
    var_5 = wp::load(var_2);
    var_4 = (var_5 != var_3);
    if (var_4) {
        // if agrees(overlap__moved_normals, overlap__nearest, overlap__normals, overlap__distance, overlap__cosine, i) == 1:       <L 4>
        var_6 = agrees_0(var_overlap__moved_normals, var_overlap__nearest, var_overlap__normals, var_overlap__distance, var_overlap__cosine, var_i);
        var_8 = (var_6 == var_7);
        if (var_8) {
            // row = key_index(overlap__nearest[i])                                           <L 5>
            var_9 = wp::address(var_overlap__nearest, var_i);
            var_11 = wp::load(var_9);
            var_10 = key_index_0(var_11);
            // height = dot(overlap__moved[i] - overlap__points[row], overlap__normals[row])       <L 6>
            var_12 = wp::address(var_overlap__moved, var_i);
            var_13 = wp::address(var_overlap__points, var_10);
            var_15 = wp::load(var_12);
            var_16 = wp::load(var_13);
            var_14 = wp::sub(var_15, var_16);
            var_17 = wp::address(var_overlap__normals, var_10);
            var_19 = wp::load(var_17);
            var_18 = wp::dot(var_14, var_19);
            // noise = spreads[i] * spreads[i] + other_spreads[row] * other_spreads[row]       <L 7>
            var_20 = wp::address(var_spreads, var_i);
            var_21 = wp::address(var_spreads, var_i);
            var_23 = wp::load(var_20);
            var_24 = wp::load(var_21);
            var_22 = wp::mul(var_23, var_24);
            var_25 = wp::address(var_other_spreads, var_10);
            var_26 = wp::address(var_other_spreads, var_10);
            var_28 = wp::load(var_25);
            var_29 = wp::load(var_26);
            var_27 = wp::mul(var_28, var_29);
            var_30 = wp::add(var_22, var_27);
            // deviating = float64(0.0)                                                       <L 8>
            var_31 = 0.0;
            // if height * height > sigmas * sigmas * max(noise, floor * floor):              <L 9>
            var_32 = wp::mul(var_18, var_18);
            var_33 = wp::mul(var_sigmas, var_sigmas);
            var_34 = wp::mul(var_floor, var_floor);
            var_35 = wp::max(var_30, var_34);
            var_36 = wp::mul(var_33, var_35);
            var_37 = (var_32 > var_36);
            if (var_37) {
                // deviating = float64(1.0)                                                   <L 10>
                var_38 = 1.0;
            }
            var_39 = wp::where(var_37, var_38, var_31);
            // out = deviation_sums(float64(1.0), deviating)                                  <L 11>
            var_40 = 1.0;
            var_41 = wp::vec_t<2, wp::float64>(var_40, var_39);
        }
        var_42 = wp::where(var_8, var_41, var_1);
    }
    var_43 = wp::where(var_4, var_42, var_1);
    // return out                                                                             <L 12>
    return var_43;
}


// <pointloom.kernels.poses.overlap_evidence.plane_of>:1
static CUDA_CALLABLE wp::int32 plane_of_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved_normals,
    wp::float32 var_overlap__cosine,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__middles,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__directions,
    wp::array_t<wp::int32> var_planes__count,
    wp::float32 var_slab,
    wp::float32 var_edge,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32>* var_0;
    wp::vec_t<3, wp::float32> var_1;
    wp::vec_t<3, wp::float32> var_2;
    const wp::int32 var_3 = -1;
    wp::int32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 0;
    wp::int32 var_7;
    const wp::int32 var_8 = 0;
    wp::int32* var_9;
    wp::range_t var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::vec_t<3, wp::float32>* var_13;
    wp::vec_t<3, wp::float32> var_14;
    wp::vec_t<3, wp::float32> var_15;
    wp::vec_t<3, wp::float32>* var_16;
    wp::vec_t<3, wp::float32> var_17;
    wp::vec_t<3, wp::float32> var_18;
    wp::float32 var_19;
    wp::float32 var_20;
    bool var_21;
    bool var_22;
    wp::vec_t<3, wp::float32>* var_23;
    wp::float32 var_24;
    wp::vec_t<3, wp::float32> var_25;
    wp::float32 var_26;
    bool var_27;
    wp::int32 var_28;
    wp::float32 var_29;
    wp::int32 var_30;
    wp::float32 var_31;
    bool var_32;
    wp::range_t var_33;
    wp::int32 var_34;
    wp::vec_t<3, wp::float32>* var_35;
    wp::vec_t<3, wp::float32> var_36;
    wp::vec_t<3, wp::float32> var_37;
    bool var_38;
    wp::float32 var_39;
    wp::float32 var_40;
    bool var_41;
    wp::vec_t<3, wp::float32>* var_42;
    wp::vec_t<3, wp::float32> var_43;
    wp::vec_t<3, wp::float32> var_44;
    wp::float32 var_45;
    wp::float32 var_46;
    bool var_47;
    const wp::int32 var_48 = 1;
    wp::int32 var_49;
    const wp::int32 var_50 = 1;
    bool var_51;
    const wp::int32 var_52 = -1;
    wp::int32 var_53;
    //---------
    // forward
    // def plane_of(overlap__moved, overlap__moved_normals, overlap__cosine, planes__middles, planes__directions, planes__count, slab, edge, i):       <L 1>
    // p = overlap__moved[i]                                                                  <L 3>
    var_0 = wp::address(var_overlap__moved, var_i);
    var_2 = wp::load(var_0);
    var_1 = wp::copy(var_2);
    // plane = int(-1)                                                                        <L 4>
    var_4 = wp::int(var_3);
    // lowest = float(slab)                                                                   <L 5>
    var_5 = wp::float(var_slab);
    // at_edge = int(0)                                                                       <L 6>
    var_7 = wp::int(var_6);
    // for k in range(planes__count[0]):                                                      <L 7>
    var_9 = wp::address(var_planes__count, var_8);
    var_11 = wp::load(var_9);
    var_10 = wp::range(var_11);
    start_for_0:;
        if (iter_cmp(var_10) == 0) goto end_for_0;
        var_12 = wp::iter_next(var_10);
        // n = planes__directions[k]                                                          <L 8>
        var_13 = wp::address(var_planes__directions, var_12);
        var_15 = wp::load(var_13);
        var_14 = wp::copy(var_15);
        // height = abs(dot(n, p - planes__middles[k]))                                       <L 9>
        var_16 = wp::address(var_planes__middles, var_12);
        var_18 = wp::load(var_16);
        var_17 = wp::sub(var_1, var_18);
        var_19 = wp::dot(var_14, var_17);
        var_20 = wp::abs(var_19);
        // if height < lowest and abs(dot(n, overlap__moved_normals[i])) > overlap__cosine:       <L 10>
        var_22 = (var_20 < var_5);
        var_21 = var_22;
        if (var_21) {
            var_23 = wp::address(var_overlap__moved_normals, var_i);
            var_25 = wp::load(var_23);
            var_24 = wp::dot(var_14, var_25);
            var_26 = wp::abs(var_24);
            var_27 = (var_26 > var_overlap__cosine);
            var_21 = var_21 && var_27;
        }
        if (var_21) {
            // plane = k                                                                      <L 11>
            var_28 = wp::copy(var_12);
            // lowest = height                                                                <L 12>
            var_29 = wp::copy(var_20);
        }
        var_30 = wp::where(var_21, var_28, var_4);
        var_31 = wp::where(var_21, var_29, var_5);
        // if height < edge:                                                                  <L 13>
        var_32 = (var_20 < var_edge);
        if (var_32) {
            // for j in range(k):                                                             <L 14>
            var_33 = wp::range(var_12);
            start_for_2:;
                if (iter_cmp(var_33) == 0) goto end_for_2;
                var_34 = wp::iter_next(var_33);
                // m = planes__directions[j]                                                  <L 15>
                var_35 = wp::address(var_planes__directions, var_34);
                var_37 = wp::load(var_35);
                var_36 = wp::copy(var_37);
                // if abs(dot(n, m)) < overlap__cosine and abs(dot(m, p - planes__middles[j])) < edge:       <L 16>
                var_39 = wp::dot(var_14, var_36);
                var_40 = wp::abs(var_39);
                var_41 = (var_40 < var_overlap__cosine);
                var_38 = var_41;
                if (var_38) {
                    var_42 = wp::address(var_planes__middles, var_34);
                    var_44 = wp::load(var_42);
                    var_43 = wp::sub(var_1, var_44);
                    var_45 = wp::dot(var_36, var_43);
                    var_46 = wp::abs(var_45);
                    var_47 = (var_46 < var_edge);
                    var_38 = var_38 && var_47;
                }
                if (var_38) {
                    // at_edge = 1                                                            <L 17>
                }
                var_49 = wp::where(var_38, var_48, var_7);
                wp::assign(var_7, var_49);
                goto start_for_2;
            end_for_2:;
        }
        wp::assign(var_4, var_30);
        wp::assign(var_5, var_31);
        goto start_for_0;
    end_for_0:;
    // if at_edge == 1:                                                                       <L 18>
    var_51 = (var_7 == var_50);
    if (var_51) {
        // plane = -1                                                                         <L 19>
    }
    var_53 = wp::where(var_51, var_52, var_4);
    // return plane                                                                           <L 20>
    return var_53;
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


// /work/main/src/pointloom/kernels/poses/overlap_evidence.py:296
static CUDA_CALLABLE wp::vec_t<3, wp::float32> slope_of_0(
    wp::vec_t<3, wp::float32> var_n,
    wp::vec_t<3, wp::float32> var_axis)
{
    //---------
    // primal vars
    wp::float32 var_0;
    wp::vec_t<3, wp::float32> var_1;
    wp::vec_t<3, wp::float32> var_2;
    const wp::float32 var_3 = 0.0;
    bool var_4;
    wp::vec_t<3, wp::float32> var_5;
    wp::vec_t<3, wp::float32> var_6;
    //---------
    // forward
    // def slope_of(n: vec3, axis: vec3) -> vec3:                                             <L 297>
    // along = dot(n, axis)                                                                   <L 299>
    var_0 = wp::dot(var_n, var_axis);
    // slope = n - along * axis                                                               <L 300>
    var_1 = wp::mul(var_0, var_axis);
    var_2 = wp::sub(var_n, var_1);
    // if along < 0.0:                                                                        <L 301>
    var_4 = (var_0 < var_3);
    if (var_4) {
        // slope = -slope                                                                     <L 302>
        var_5 = wp::neg(var_2);
    }
    var_6 = wp::where(var_4, var_5, var_2);
    // return slope                                                                           <L 303>
    return var_6;
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


// <pointloom.kernels.poses.overlap_evidence.sum_relief_element>:1
static CUDA_CALLABLE wp::vec_t<4, wp::float64> sum_relief_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved_normals,
    wp::array_t<wp::int64> var_overlap__nearest,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__normals,
    wp::float32 var_overlap__distance,
    wp::float32 var_overlap__cosine,
    wp::float32 var_overlap__tight,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__middles,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__directions,
    wp::array_t<wp::int32> var_planes__count,
    wp::float32 var_slab,
    wp::float32 var_edge,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::vec_t<4, wp::float64> var_1;
    wp::int64* var_2;
    wp::int64 var_3;
    bool var_4;
    wp::int64 var_5;
    wp::int32 var_6;
    const wp::int32 var_7 = 1;
    bool var_8;
    wp::int32 var_9;
    wp::float32 var_10;
    bool var_11;
    const wp::int32 var_12 = 0;
    bool var_13;
    const wp::float32 var_14 = 0.0;
    bool var_15;
    wp::vec_t<3, wp::float32>* var_16;
    wp::vec_t<3, wp::float32> var_17;
    wp::vec_t<3, wp::float32> var_18;
    wp::int64* var_19;
    wp::int32 var_20;
    wp::int64 var_21;
    wp::vec_t<3, wp::float32>* var_22;
    wp::vec_t<3, wp::float32> var_23;
    wp::vec_t<3, wp::float32> var_24;
    wp::float32 var_25;
    wp::float32 var_26;
    bool var_27;
    wp::vec_t<3, wp::float32>* var_28;
    wp::vec_t<3, wp::float32> var_29;
    wp::vec_t<3, wp::float32> var_30;
    wp::vec_t<3, wp::float64> var_31;
    wp::vec_t<3, wp::float32> var_32;
    wp::vec_t<3, wp::float64> var_33;
    wp::float64 var_34;
    wp::float64 var_35;
    wp::float64 var_36;
    wp::float64 var_37;
    wp::vec_t<4, wp::float64> var_38;
    wp::vec_t<4, wp::float64> var_39;
    wp::vec_t<4, wp::float64> var_40;
    wp::vec_t<4, wp::float64> var_41;
    wp::vec_t<4, wp::float64> var_42;
    //---------
    // forward
    // def sum_relief_element(overlap__moved, overlap__moved_normals, overlap__nearest, overlap__points, overlap__normals, overlap__distance, overlap__cosine, overlap__tight, planes__middles, planes__directions, planes__count, slab, edge, i):       <L 1>
    // out = relief_sums(float64(0.0))                                                        <L 2>
    var_0 = 0.0;
    var_1 = wp::vec_t<4, wp::float64>(var_0);
    // if overlap__nearest[i] != int64(NO_POINT):                                             <L 3>
    var_2 = wp::address(var_overlap__nearest, var_i);
    var_3 = -1ll;
    var_5 = wp::load(var_2);
    var_4 = (var_5 != var_3);
    if (var_4) {
        // if agrees(overlap__moved_normals, overlap__nearest, overlap__normals, overlap__distance, overlap__cosine, i) == 1:       <L 4>
        var_6 = agrees_0(var_overlap__moved_normals, var_overlap__nearest, var_overlap__normals, var_overlap__distance, var_overlap__cosine, var_i);
        var_8 = (var_6 == var_7);
        if (var_8) {
            // plane = plane_of(overlap__moved, overlap__moved_normals, overlap__cosine, planes__middles, planes__directions, planes__count, slab, edge, i)       <L 5>
            var_9 = plane_of_0(var_overlap__moved, var_overlap__moved_normals, var_overlap__cosine, var_planes__middles, var_planes__directions, var_planes__count, var_slab, var_edge, var_i);
            // weight = match_weight(overlap__moved, overlap__nearest, overlap__points, overlap__normals, overlap__tight, i)       <L 6>
            var_10 = match_weight_0(var_overlap__moved, var_overlap__nearest, var_overlap__points, var_overlap__normals, var_overlap__tight, var_i);
            // if plane >= 0 and weight > 0.0:                                                <L 7>
            var_13 = (var_9 >= var_12);
            var_11 = var_13;
            if (var_11) {
                var_15 = (var_10 > var_14);
                var_11 = var_11 && var_15;
            }
            if (var_11) {
                // axis = planes__directions[plane]                                           <L 8>
                var_16 = wp::address(var_planes__directions, var_9);
                var_18 = wp::load(var_16);
                var_17 = wp::copy(var_18);
                // other = overlap__normals[key_index(overlap__nearest[i])]                   <L 9>
                var_19 = wp::address(var_overlap__nearest, var_i);
                var_21 = wp::load(var_19);
                var_20 = key_index_0(var_21);
                var_22 = wp::address(var_overlap__normals, var_20);
                var_24 = wp::load(var_22);
                var_23 = wp::copy(var_24);
                // if abs(dot(other, axis)) > overlap__cosine:                                <L 10>
                var_25 = wp::dot(var_23, var_17);
                var_26 = wp::abs(var_25);
                var_27 = (var_26 > var_overlap__cosine);
                if (var_27) {
                    // a = widen(slope_of(overlap__moved_normals[i], axis))                   <L 11>
                    var_28 = wp::address(var_overlap__moved_normals, var_i);
                    var_30 = wp::load(var_28);
                    var_29 = slope_of_0(var_30, var_17);
                    var_31 = widen_0(var_29);
                    // b = widen(slope_of(other, axis))                                       <L 12>
                    var_32 = slope_of_0(var_23, var_17);
                    var_33 = widen_0(var_32);
                    // out = relief_sums(float64(1.0), dot(a, b), dot(a, a), dot(b, b))       <L 13>
                    var_34 = 1.0;
                    var_35 = wp::dot(var_31, var_33);
                    var_36 = wp::dot(var_31, var_31);
                    var_37 = wp::dot(var_33, var_33);
                    var_38 = wp::vec_t<4, wp::float64>(var_34, var_35, var_36, var_37);
                }
                var_39 = wp::where(var_27, var_38, var_1);
            }
            var_40 = wp::where(var_11, var_39, var_1);
        }
        var_41 = wp::where(var_8, var_40, var_1);
    }
    var_42 = wp::where(var_4, var_41, var_1);
    // return out                                                                             <L 14>
    return var_42;
}


// <pointloom.kernels.poses.overlap_evidence.is_aligned>:1
static CUDA_CALLABLE wp::int32 is_aligned_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved_normals,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__frame,
    wp::array_t<wp::int32> var_overlap__frame_size,
    wp::int32 var_i)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 0;
    wp::int32* var_3;
    wp::range_t var_4;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::vec_t<3, wp::float32>* var_7;
    wp::vec_t<3, wp::float32>* var_8;
    wp::float32 var_9;
    wp::vec_t<3, wp::float32> var_10;
    wp::vec_t<3, wp::float32> var_11;
    wp::float32 var_12;
    const wp::float32 var_13 = 0.95;
    bool var_14;
    const wp::int32 var_15 = 1;
    wp::int32 var_16;
    //---------
    // forward
    // def is_aligned(overlap__moved_normals, overlap__frame, overlap__frame_size, i):        <L 1>
    // aligned = int(0)                                                                       <L 3>
    var_1 = wp::int(var_0);
    // for k in range(overlap__frame_size[0]):                                                <L 4>
    var_3 = wp::address(var_overlap__frame_size, var_2);
    var_5 = wp::load(var_3);
    var_4 = wp::range(var_5);
    start_for_0:;
        if (iter_cmp(var_4) == 0) goto end_for_0;
        var_6 = wp::iter_next(var_4);
        // if abs(dot(overlap__frame[k], overlap__moved_normals[i])) > ALIGNED:               <L 5>
        var_7 = wp::address(var_overlap__frame, var_6);
        var_8 = wp::address(var_overlap__moved_normals, var_i);
        var_10 = wp::load(var_7);
        var_11 = wp::load(var_8);
        var_9 = wp::dot(var_10, var_11);
        var_12 = wp::abs(var_9);
        var_14 = (var_12 > var_13);
        if (var_14) {
            // aligned = 1                                                                    <L 6>
        }
        var_16 = wp::where(var_14, var_15, var_1);
        wp::assign(var_1, var_16);
        goto start_for_0;
    end_for_0:;
    // return aligned                                                                         <L 7>
    return var_1;
}


// <pointloom.kernels.poses.overlap_evidence.sum_evidence_element>:1
static CUDA_CALLABLE wp::vec_t<46, wp::float64> sum_evidence_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved_normals,
    wp::array_t<wp::int64> var_overlap__nearest,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__normals,
    wp::array_t<wp::vec_t<3, wp::float64>> var_overlap__middle,
    wp::array_t<wp::float64> var_overlap__scale,
    wp::float32 var_overlap__distance,
    wp::float32 var_overlap__cosine,
    wp::float32 var_overlap__tight,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__frame,
    wp::array_t<wp::int32> var_overlap__frame_size,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::vec_t<46, wp::float64> var_1;
    wp::int64* var_2;
    wp::int64 var_3;
    bool var_4;
    wp::int64 var_5;
    wp::vec_t<3, wp::float32>* var_6;
    wp::vec_t<3, wp::float64> var_7;
    wp::vec_t<3, wp::float32> var_8;
    wp::vec_t<3, wp::float32>* var_9;
    wp::vec_t<3, wp::float64> var_10;
    wp::vec_t<3, wp::float32> var_11;
    const wp::int32 var_12 = 0;
    wp::vec_t<3, wp::float64>* var_13;
    wp::vec_t<3, wp::float64> var_14;
    wp::vec_t<3, wp::float64> var_15;
    const wp::int32 var_16 = 0;
    wp::float64* var_17;
    wp::vec_t<3, wp::float64> var_18;
    wp::float64 var_19;
    wp::vec_t<3, wp::float64> var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    wp::int32 var_23;
    const wp::int32 var_24 = 1;
    bool var_25;
    wp::float64 var_26;
    wp::float32 var_27;
    wp::float64 var_28;
    wp::float64 var_29;
    wp::float64 var_30;
    const wp::int32 var_31 = 0;
    wp::float64 var_32;
    const wp::int32 var_33 = 1;
    wp::float64 var_34;
    const wp::int32 var_35 = 2;
    wp::float64 var_36;
    const wp::int32 var_37 = 0;
    wp::float64 var_38;
    const wp::int32 var_39 = 1;
    wp::float64 var_40;
    const wp::int32 var_41 = 2;
    wp::float64 var_42;
    wp::vec_t<6, wp::float64> var_43;
    const wp::int32 var_44 = 0;
    wp::int32 var_45;
    const wp::int32 var_46 = 0;
    const wp::int32 var_47 = 0;
    wp::float64 var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    wp::float64 var_51;
    const wp::int32 var_52 = 21;
    wp::int32 var_53;
    const wp::int32 var_54 = 1;
    wp::int32 var_55;
    const wp::int32 var_56 = 1;
    wp::float64 var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float64 var_60;
    const wp::int32 var_61 = 21;
    wp::int32 var_62;
    const wp::int32 var_63 = 1;
    wp::int32 var_64;
    const wp::int32 var_65 = 2;
    wp::float64 var_66;
    wp::float64 var_67;
    wp::float64 var_68;
    wp::float64 var_69;
    const wp::int32 var_70 = 21;
    wp::int32 var_71;
    const wp::int32 var_72 = 1;
    wp::int32 var_73;
    const wp::int32 var_74 = 3;
    wp::float64 var_75;
    wp::float64 var_76;
    wp::float64 var_77;
    wp::float64 var_78;
    const wp::int32 var_79 = 21;
    wp::int32 var_80;
    const wp::int32 var_81 = 1;
    wp::int32 var_82;
    const wp::int32 var_83 = 4;
    wp::float64 var_84;
    wp::float64 var_85;
    wp::float64 var_86;
    wp::float64 var_87;
    const wp::int32 var_88 = 21;
    wp::int32 var_89;
    const wp::int32 var_90 = 1;
    wp::int32 var_91;
    const wp::int32 var_92 = 5;
    wp::float64 var_93;
    wp::float64 var_94;
    wp::float64 var_95;
    wp::float64 var_96;
    const wp::int32 var_97 = 21;
    wp::int32 var_98;
    const wp::int32 var_99 = 1;
    wp::int32 var_100;
    const wp::int32 var_101 = 1;
    const wp::int32 var_102 = 1;
    wp::float64 var_103;
    wp::float64 var_104;
    wp::float64 var_105;
    wp::float64 var_106;
    const wp::int32 var_107 = 21;
    wp::int32 var_108;
    const wp::int32 var_109 = 1;
    wp::int32 var_110;
    const wp::int32 var_111 = 2;
    wp::float64 var_112;
    wp::float64 var_113;
    wp::float64 var_114;
    wp::float64 var_115;
    const wp::int32 var_116 = 21;
    wp::int32 var_117;
    const wp::int32 var_118 = 1;
    wp::int32 var_119;
    const wp::int32 var_120 = 3;
    wp::float64 var_121;
    wp::float64 var_122;
    wp::float64 var_123;
    wp::float64 var_124;
    const wp::int32 var_125 = 21;
    wp::int32 var_126;
    const wp::int32 var_127 = 1;
    wp::int32 var_128;
    const wp::int32 var_129 = 4;
    wp::float64 var_130;
    wp::float64 var_131;
    wp::float64 var_132;
    wp::float64 var_133;
    const wp::int32 var_134 = 21;
    wp::int32 var_135;
    const wp::int32 var_136 = 1;
    wp::int32 var_137;
    const wp::int32 var_138 = 5;
    wp::float64 var_139;
    wp::float64 var_140;
    wp::float64 var_141;
    wp::float64 var_142;
    const wp::int32 var_143 = 21;
    wp::int32 var_144;
    const wp::int32 var_145 = 1;
    wp::int32 var_146;
    const wp::int32 var_147 = 2;
    const wp::int32 var_148 = 2;
    wp::float64 var_149;
    wp::float64 var_150;
    wp::float64 var_151;
    wp::float64 var_152;
    const wp::int32 var_153 = 21;
    wp::int32 var_154;
    const wp::int32 var_155 = 1;
    wp::int32 var_156;
    const wp::int32 var_157 = 3;
    wp::float64 var_158;
    wp::float64 var_159;
    wp::float64 var_160;
    wp::float64 var_161;
    const wp::int32 var_162 = 21;
    wp::int32 var_163;
    const wp::int32 var_164 = 1;
    wp::int32 var_165;
    const wp::int32 var_166 = 4;
    wp::float64 var_167;
    wp::float64 var_168;
    wp::float64 var_169;
    wp::float64 var_170;
    const wp::int32 var_171 = 21;
    wp::int32 var_172;
    const wp::int32 var_173 = 1;
    wp::int32 var_174;
    const wp::int32 var_175 = 5;
    wp::float64 var_176;
    wp::float64 var_177;
    wp::float64 var_178;
    wp::float64 var_179;
    const wp::int32 var_180 = 21;
    wp::int32 var_181;
    const wp::int32 var_182 = 1;
    wp::int32 var_183;
    const wp::int32 var_184 = 3;
    const wp::int32 var_185 = 3;
    wp::float64 var_186;
    wp::float64 var_187;
    wp::float64 var_188;
    wp::float64 var_189;
    const wp::int32 var_190 = 21;
    wp::int32 var_191;
    const wp::int32 var_192 = 1;
    wp::int32 var_193;
    const wp::int32 var_194 = 4;
    wp::float64 var_195;
    wp::float64 var_196;
    wp::float64 var_197;
    wp::float64 var_198;
    const wp::int32 var_199 = 21;
    wp::int32 var_200;
    const wp::int32 var_201 = 1;
    wp::int32 var_202;
    const wp::int32 var_203 = 5;
    wp::float64 var_204;
    wp::float64 var_205;
    wp::float64 var_206;
    wp::float64 var_207;
    const wp::int32 var_208 = 21;
    wp::int32 var_209;
    const wp::int32 var_210 = 1;
    wp::int32 var_211;
    const wp::int32 var_212 = 4;
    const wp::int32 var_213 = 4;
    wp::float64 var_214;
    wp::float64 var_215;
    wp::float64 var_216;
    wp::float64 var_217;
    const wp::int32 var_218 = 21;
    wp::int32 var_219;
    const wp::int32 var_220 = 1;
    wp::int32 var_221;
    const wp::int32 var_222 = 5;
    wp::float64 var_223;
    wp::float64 var_224;
    wp::float64 var_225;
    wp::float64 var_226;
    const wp::int32 var_227 = 21;
    wp::int32 var_228;
    const wp::int32 var_229 = 1;
    wp::int32 var_230;
    const wp::int32 var_231 = 5;
    const wp::int32 var_232 = 5;
    wp::float64 var_233;
    wp::float64 var_234;
    wp::float64 var_235;
    wp::float64 var_236;
    const wp::int32 var_237 = 21;
    wp::int32 var_238;
    const wp::int32 var_239 = 1;
    wp::int32 var_240;
    wp::float64 var_241;
    const wp::int32 var_242 = 42;
    const wp::int32 var_243 = 43;
    const wp::int32 var_244 = 44;
    wp::int32 var_245;
    wp::float64 var_246;
    wp::float64 var_247;
    const wp::int32 var_248 = 45;
    //---------
    // forward
    // def sum_evidence_element(overlap__moved, overlap__moved_normals, overlap__nearest, overlap__points, overlap__normals, overlap__middle, overlap__scale, overlap__distance, overlap__cosine, overlap__tight, overlap__frame, overlap__frame_size, i):       <L 1>
    // out = evidence_sums(float64(0.0))                                                      <L 2>
    var_0 = 0.0;
    var_1 = wp::vec_t<46, wp::float64>(var_0);
    // if overlap__nearest[i] != int64(NO_POINT):                                             <L 3>
    var_2 = wp::address(var_overlap__nearest, var_i);
    var_3 = -1ll;
    var_5 = wp::load(var_2);
    var_4 = (var_5 != var_3);
    if (var_4) {
        // n = widen(overlap__moved_normals[i])                                               <L 4>
        var_6 = wp::address(var_overlap__moved_normals, var_i);
        var_8 = wp::load(var_6);
        var_7 = widen_0(var_8);
        // r = (widen(overlap__moved[i]) - overlap__middle[0]) * overlap__scale[0]            <L 5>
        var_9 = wp::address(var_overlap__moved, var_i);
        var_11 = wp::load(var_9);
        var_10 = widen_0(var_11);
        var_13 = wp::address(var_overlap__middle, var_12);
        var_15 = wp::load(var_13);
        var_14 = wp::sub(var_10, var_15);
        var_17 = wp::address(var_overlap__scale, var_16);
        var_19 = wp::load(var_17);
        var_18 = wp::mul(var_14, var_19);
        // c = cross(r, n)                                                                    <L 6>
        var_20 = wp::cross(var_18, var_7);
        // agreeing = float64(0.0)                                                            <L 7>
        var_21 = 0.0;
        // matched = float64(0.0)                                                             <L 8>
        var_22 = 0.0;
        // if agrees(overlap__moved_normals, overlap__nearest, overlap__normals, overlap__distance, overlap__cosine, i) == 1:       <L 9>
        var_23 = agrees_0(var_overlap__moved_normals, var_overlap__nearest, var_overlap__normals, var_overlap__distance, var_overlap__cosine, var_i);
        var_25 = (var_23 == var_24);
        if (var_25) {
            // agreeing = float64(1.0)                                                        <L 10>
            var_26 = 1.0;
            // matched = float64(match_weight(overlap__moved, overlap__nearest, overlap__points, overlap__normals, overlap__tight, i))       <L 11>
            var_27 = match_weight_0(var_overlap__moved, var_overlap__nearest, var_overlap__points, var_overlap__normals, var_overlap__tight, var_i);
            var_28 = wp::float64(var_27);
        }
        var_29 = wp::where(var_25, var_26, var_21);
        var_30 = wp::where(var_25, var_28, var_22);
        // a = motions(c[0], c[1], c[2], n[0], n[1], n[2])                                    <L 12>
        var_32 = wp::extract(var_20, var_31);
        var_34 = wp::extract(var_20, var_33);
        var_36 = wp::extract(var_20, var_35);
        var_38 = wp::extract(var_7, var_37);
        var_40 = wp::extract(var_7, var_39);
        var_42 = wp::extract(var_7, var_41);
        var_43 = wp::vec_t<6, wp::float64>({var_32, var_34, var_36, var_38, var_40, var_42});
        // at = int(0)                                                                        <L 13>
        var_45 = wp::int(var_44);
        // for j in range(6):                                                                 <L 14>
        // for k in range(j, 6):                                                              <L 15>
        // entry = a[j] * a[k]                                                                <L 16>
        var_48 = wp::extract(var_43, var_46);
        var_49 = wp::extract(var_43, var_47);
        var_50 = wp::mul(var_48, var_49);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_45, var_50);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_51 = wp::mul(var_30, var_50);
        var_53 = wp::add(var_45, var_52);
        wp::assign_inplace(var_1, var_53, var_51);
        // at += 1                                                                            <L 19>
        var_55 = wp::add(var_45, var_54);
        // entry = a[j] * a[k]                                                                <L 16>
        var_57 = wp::extract(var_43, var_46);
        var_58 = wp::extract(var_43, var_56);
        var_59 = wp::mul(var_57, var_58);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_55, var_59);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_60 = wp::mul(var_30, var_59);
        var_62 = wp::add(var_55, var_61);
        wp::assign_inplace(var_1, var_62, var_60);
        // at += 1                                                                            <L 19>
        var_64 = wp::add(var_55, var_63);
        // entry = a[j] * a[k]                                                                <L 16>
        var_66 = wp::extract(var_43, var_46);
        var_67 = wp::extract(var_43, var_65);
        var_68 = wp::mul(var_66, var_67);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_64, var_68);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_69 = wp::mul(var_30, var_68);
        var_71 = wp::add(var_64, var_70);
        wp::assign_inplace(var_1, var_71, var_69);
        // at += 1                                                                            <L 19>
        var_73 = wp::add(var_64, var_72);
        // entry = a[j] * a[k]                                                                <L 16>
        var_75 = wp::extract(var_43, var_46);
        var_76 = wp::extract(var_43, var_74);
        var_77 = wp::mul(var_75, var_76);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_73, var_77);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_78 = wp::mul(var_30, var_77);
        var_80 = wp::add(var_73, var_79);
        wp::assign_inplace(var_1, var_80, var_78);
        // at += 1                                                                            <L 19>
        var_82 = wp::add(var_73, var_81);
        // entry = a[j] * a[k]                                                                <L 16>
        var_84 = wp::extract(var_43, var_46);
        var_85 = wp::extract(var_43, var_83);
        var_86 = wp::mul(var_84, var_85);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_82, var_86);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_87 = wp::mul(var_30, var_86);
        var_89 = wp::add(var_82, var_88);
        wp::assign_inplace(var_1, var_89, var_87);
        // at += 1                                                                            <L 19>
        var_91 = wp::add(var_82, var_90);
        // entry = a[j] * a[k]                                                                <L 16>
        var_93 = wp::extract(var_43, var_46);
        var_94 = wp::extract(var_43, var_92);
        var_95 = wp::mul(var_93, var_94);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_91, var_95);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_96 = wp::mul(var_30, var_95);
        var_98 = wp::add(var_91, var_97);
        wp::assign_inplace(var_1, var_98, var_96);
        // at += 1                                                                            <L 19>
        var_100 = wp::add(var_91, var_99);
        // for k in range(j, 6):                                                              <L 15>
        // entry = a[j] * a[k]                                                                <L 16>
        var_103 = wp::extract(var_43, var_101);
        var_104 = wp::extract(var_43, var_102);
        var_105 = wp::mul(var_103, var_104);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_100, var_105);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_106 = wp::mul(var_30, var_105);
        var_108 = wp::add(var_100, var_107);
        wp::assign_inplace(var_1, var_108, var_106);
        // at += 1                                                                            <L 19>
        var_110 = wp::add(var_100, var_109);
        // entry = a[j] * a[k]                                                                <L 16>
        var_112 = wp::extract(var_43, var_101);
        var_113 = wp::extract(var_43, var_111);
        var_114 = wp::mul(var_112, var_113);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_110, var_114);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_115 = wp::mul(var_30, var_114);
        var_117 = wp::add(var_110, var_116);
        wp::assign_inplace(var_1, var_117, var_115);
        // at += 1                                                                            <L 19>
        var_119 = wp::add(var_110, var_118);
        // entry = a[j] * a[k]                                                                <L 16>
        var_121 = wp::extract(var_43, var_101);
        var_122 = wp::extract(var_43, var_120);
        var_123 = wp::mul(var_121, var_122);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_119, var_123);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_124 = wp::mul(var_30, var_123);
        var_126 = wp::add(var_119, var_125);
        wp::assign_inplace(var_1, var_126, var_124);
        // at += 1                                                                            <L 19>
        var_128 = wp::add(var_119, var_127);
        // entry = a[j] * a[k]                                                                <L 16>
        var_130 = wp::extract(var_43, var_101);
        var_131 = wp::extract(var_43, var_129);
        var_132 = wp::mul(var_130, var_131);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_128, var_132);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_133 = wp::mul(var_30, var_132);
        var_135 = wp::add(var_128, var_134);
        wp::assign_inplace(var_1, var_135, var_133);
        // at += 1                                                                            <L 19>
        var_137 = wp::add(var_128, var_136);
        // entry = a[j] * a[k]                                                                <L 16>
        var_139 = wp::extract(var_43, var_101);
        var_140 = wp::extract(var_43, var_138);
        var_141 = wp::mul(var_139, var_140);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_137, var_141);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_142 = wp::mul(var_30, var_141);
        var_144 = wp::add(var_137, var_143);
        wp::assign_inplace(var_1, var_144, var_142);
        // at += 1                                                                            <L 19>
        var_146 = wp::add(var_137, var_145);
        // for k in range(j, 6):                                                              <L 15>
        // entry = a[j] * a[k]                                                                <L 16>
        var_149 = wp::extract(var_43, var_147);
        var_150 = wp::extract(var_43, var_148);
        var_151 = wp::mul(var_149, var_150);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_146, var_151);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_152 = wp::mul(var_30, var_151);
        var_154 = wp::add(var_146, var_153);
        wp::assign_inplace(var_1, var_154, var_152);
        // at += 1                                                                            <L 19>
        var_156 = wp::add(var_146, var_155);
        // entry = a[j] * a[k]                                                                <L 16>
        var_158 = wp::extract(var_43, var_147);
        var_159 = wp::extract(var_43, var_157);
        var_160 = wp::mul(var_158, var_159);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_156, var_160);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_161 = wp::mul(var_30, var_160);
        var_163 = wp::add(var_156, var_162);
        wp::assign_inplace(var_1, var_163, var_161);
        // at += 1                                                                            <L 19>
        var_165 = wp::add(var_156, var_164);
        // entry = a[j] * a[k]                                                                <L 16>
        var_167 = wp::extract(var_43, var_147);
        var_168 = wp::extract(var_43, var_166);
        var_169 = wp::mul(var_167, var_168);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_165, var_169);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_170 = wp::mul(var_30, var_169);
        var_172 = wp::add(var_165, var_171);
        wp::assign_inplace(var_1, var_172, var_170);
        // at += 1                                                                            <L 19>
        var_174 = wp::add(var_165, var_173);
        // entry = a[j] * a[k]                                                                <L 16>
        var_176 = wp::extract(var_43, var_147);
        var_177 = wp::extract(var_43, var_175);
        var_178 = wp::mul(var_176, var_177);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_174, var_178);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_179 = wp::mul(var_30, var_178);
        var_181 = wp::add(var_174, var_180);
        wp::assign_inplace(var_1, var_181, var_179);
        // at += 1                                                                            <L 19>
        var_183 = wp::add(var_174, var_182);
        // for k in range(j, 6):                                                              <L 15>
        // entry = a[j] * a[k]                                                                <L 16>
        var_186 = wp::extract(var_43, var_184);
        var_187 = wp::extract(var_43, var_185);
        var_188 = wp::mul(var_186, var_187);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_183, var_188);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_189 = wp::mul(var_30, var_188);
        var_191 = wp::add(var_183, var_190);
        wp::assign_inplace(var_1, var_191, var_189);
        // at += 1                                                                            <L 19>
        var_193 = wp::add(var_183, var_192);
        // entry = a[j] * a[k]                                                                <L 16>
        var_195 = wp::extract(var_43, var_184);
        var_196 = wp::extract(var_43, var_194);
        var_197 = wp::mul(var_195, var_196);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_193, var_197);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_198 = wp::mul(var_30, var_197);
        var_200 = wp::add(var_193, var_199);
        wp::assign_inplace(var_1, var_200, var_198);
        // at += 1                                                                            <L 19>
        var_202 = wp::add(var_193, var_201);
        // entry = a[j] * a[k]                                                                <L 16>
        var_204 = wp::extract(var_43, var_184);
        var_205 = wp::extract(var_43, var_203);
        var_206 = wp::mul(var_204, var_205);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_202, var_206);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_207 = wp::mul(var_30, var_206);
        var_209 = wp::add(var_202, var_208);
        wp::assign_inplace(var_1, var_209, var_207);
        // at += 1                                                                            <L 19>
        var_211 = wp::add(var_202, var_210);
        // for k in range(j, 6):                                                              <L 15>
        // entry = a[j] * a[k]                                                                <L 16>
        var_214 = wp::extract(var_43, var_212);
        var_215 = wp::extract(var_43, var_213);
        var_216 = wp::mul(var_214, var_215);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_211, var_216);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_217 = wp::mul(var_30, var_216);
        var_219 = wp::add(var_211, var_218);
        wp::assign_inplace(var_1, var_219, var_217);
        // at += 1                                                                            <L 19>
        var_221 = wp::add(var_211, var_220);
        // entry = a[j] * a[k]                                                                <L 16>
        var_223 = wp::extract(var_43, var_212);
        var_224 = wp::extract(var_43, var_222);
        var_225 = wp::mul(var_223, var_224);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_221, var_225);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_226 = wp::mul(var_30, var_225);
        var_228 = wp::add(var_221, var_227);
        wp::assign_inplace(var_1, var_228, var_226);
        // at += 1                                                                            <L 19>
        var_230 = wp::add(var_221, var_229);
        // for k in range(j, 6):                                                              <L 15>
        // entry = a[j] * a[k]                                                                <L 16>
        var_233 = wp::extract(var_43, var_231);
        var_234 = wp::extract(var_43, var_232);
        var_235 = wp::mul(var_233, var_234);
        // out[at] = entry                                                                    <L 17>
        wp::assign_inplace(var_1, var_230, var_235);
        // out[at + 21] = matched * entry                                                     <L 18>
        var_236 = wp::mul(var_30, var_235);
        var_238 = wp::add(var_230, var_237);
        wp::assign_inplace(var_1, var_238, var_236);
        // at += 1                                                                            <L 19>
        var_240 = wp::add(var_230, var_239);
        // out[NEAR_AT] = float64(1.0)                                                        <L 20>
        var_241 = 1.0;
        wp::assign_inplace(var_1, var_242, var_241);
        // out[AGREEING_AT] = agreeing                                                        <L 21>
        wp::assign_inplace(var_1, var_243, var_29);
        // out[MATCHED_AT] = matched                                                          <L 22>
        wp::assign_inplace(var_1, var_244, var_30);
        // out[ALIGNED_AT] = matched * float64(is_aligned(overlap__moved_normals, overlap__frame, overlap__frame_size, i))       <L 23>
        var_245 = is_aligned_0(var_overlap__moved_normals, var_overlap__frame, var_overlap__frame_size, var_i);
        var_246 = wp::float64(var_245);
        var_247 = wp::mul(var_30, var_246);
        wp::assign_inplace(var_1, var_248, var_247);
    }
    // return out                                                                             <L 24>
    return var_1;
}


// <pointloom.kernels.poses.overlap_evidence.sum_near_element>:1
static CUDA_CALLABLE wp::vec_t<5, wp::float64> sum_near_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_moved,
    wp::array_t<wp::int64> var_nearest,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::vec_t<5, wp::float64> var_1;
    wp::int64* var_2;
    wp::int64 var_3;
    bool var_4;
    wp::int64 var_5;
    wp::vec_t<3, wp::float32>* var_6;
    wp::vec_t<3, wp::float64> var_7;
    wp::vec_t<3, wp::float32> var_8;
    wp::float64 var_9;
    const wp::int32 var_10 = 0;
    wp::float64 var_11;
    const wp::int32 var_12 = 1;
    wp::float64 var_13;
    const wp::int32 var_14 = 2;
    wp::float64 var_15;
    wp::float64 var_16;
    wp::vec_t<5, wp::float64> var_17;
    wp::vec_t<5, wp::float64> var_18;
    //---------
    // forward
    // def sum_near_element(moved, nearest, i):                                               <L 1>
    // out = middle_sums(float64(0.0))                                                        <L 2>
    var_0 = 0.0;
    var_1 = wp::vec_t<5, wp::float64>(var_0);
    // if nearest[i] != int64(NO_POINT):                                                      <L 3>
    var_2 = wp::address(var_nearest, var_i);
    var_3 = -1ll;
    var_5 = wp::load(var_2);
    var_4 = (var_5 != var_3);
    if (var_4) {
        // p = widen(moved[i])                                                                <L 4>
        var_6 = wp::address(var_moved, var_i);
        var_8 = wp::load(var_6);
        var_7 = widen_0(var_8);
        // out = middle_sums(float64(1.0), p[0], p[1], p[2], dot(p, p))                       <L 5>
        var_9 = 1.0;
        var_11 = wp::extract(var_7, var_10);
        var_13 = wp::extract(var_7, var_12);
        var_15 = wp::extract(var_7, var_14);
        var_16 = wp::dot(var_7, var_7);
        var_17 = wp::vec_t<5, wp::float64>({var_9, var_11, var_13, var_15, var_16});
    }
    var_18 = wp::where(var_4, var_17, var_1);
    // return out                                                                             <L 6>
    return var_18;
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


// <pointloom.kernels.poses.overlap_evidence.sum_deviating_element>:1
static CUDA_CALLABLE void adj_sum_deviating_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved_normals,
    wp::array_t<wp::int64> var_overlap__nearest,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__normals,
    wp::float32 var_overlap__distance,
    wp::float32 var_overlap__cosine,
    wp::array_t<wp::float32> var_spreads,
    wp::array_t<wp::float32> var_other_spreads,
    wp::float32 var_sigmas,
    wp::float32 var_floor,
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__moved,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__moved_normals,
    wp::array_t<wp::int64> & adj_overlap__nearest,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__points,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__normals,
    wp::float32 & adj_overlap__distance,
    wp::float32 & adj_overlap__cosine,
    wp::array_t<wp::float32> & adj_spreads,
    wp::array_t<wp::float32> & adj_other_spreads,
    wp::float32 & adj_sigmas,
    wp::float32 & adj_floor,
    wp::int32 & adj_i,
    wp::vec_t<2, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.poses.overlap_evidence.plane_of>:1
static CUDA_CALLABLE void adj_plane_of_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved_normals,
    wp::float32 var_overlap__cosine,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__middles,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__directions,
    wp::array_t<wp::int32> var_planes__count,
    wp::float32 var_slab,
    wp::float32 var_edge,
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__moved,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__moved_normals,
    wp::float32 & adj_overlap__cosine,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_planes__middles,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_planes__directions,
    wp::array_t<wp::int32> & adj_planes__count,
    wp::float32 & adj_slab,
    wp::float32 & adj_edge,
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


// /work/main/src/pointloom/kernels/poses/overlap_evidence.py:296
static CUDA_CALLABLE void adj_slope_of_0(
    wp::vec_t<3, wp::float32> var_n,
    wp::vec_t<3, wp::float32> var_axis,
    wp::vec_t<3, wp::float32> & adj_n,
    wp::vec_t<3, wp::float32> & adj_axis,
    wp::vec_t<3, wp::float32> & adj_ret)
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


// <pointloom.kernels.poses.overlap_evidence.sum_relief_element>:1
static CUDA_CALLABLE void adj_sum_relief_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved_normals,
    wp::array_t<wp::int64> var_overlap__nearest,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__normals,
    wp::float32 var_overlap__distance,
    wp::float32 var_overlap__cosine,
    wp::float32 var_overlap__tight,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__middles,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__directions,
    wp::array_t<wp::int32> var_planes__count,
    wp::float32 var_slab,
    wp::float32 var_edge,
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__moved,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__moved_normals,
    wp::array_t<wp::int64> & adj_overlap__nearest,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__points,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__normals,
    wp::float32 & adj_overlap__distance,
    wp::float32 & adj_overlap__cosine,
    wp::float32 & adj_overlap__tight,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_planes__middles,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_planes__directions,
    wp::array_t<wp::int32> & adj_planes__count,
    wp::float32 & adj_slab,
    wp::float32 & adj_edge,
    wp::int32 & adj_i,
    wp::vec_t<4, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.poses.overlap_evidence.is_aligned>:1
static CUDA_CALLABLE void adj_is_aligned_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved_normals,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__frame,
    wp::array_t<wp::int32> var_overlap__frame_size,
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__moved_normals,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__frame,
    wp::array_t<wp::int32> & adj_overlap__frame_size,
    wp::int32 & adj_i,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.poses.overlap_evidence.sum_evidence_element>:1
static CUDA_CALLABLE void adj_sum_evidence_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved_normals,
    wp::array_t<wp::int64> var_overlap__nearest,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__normals,
    wp::array_t<wp::vec_t<3, wp::float64>> var_overlap__middle,
    wp::array_t<wp::float64> var_overlap__scale,
    wp::float32 var_overlap__distance,
    wp::float32 var_overlap__cosine,
    wp::float32 var_overlap__tight,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__frame,
    wp::array_t<wp::int32> var_overlap__frame_size,
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__moved,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__moved_normals,
    wp::array_t<wp::int64> & adj_overlap__nearest,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__points,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__normals,
    wp::array_t<wp::vec_t<3, wp::float64>> & adj_overlap__middle,
    wp::array_t<wp::float64> & adj_overlap__scale,
    wp::float32 & adj_overlap__distance,
    wp::float32 & adj_overlap__cosine,
    wp::float32 & adj_overlap__tight,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__frame,
    wp::array_t<wp::int32> & adj_overlap__frame_size,
    wp::int32 & adj_i,
    wp::vec_t<46, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.poses.overlap_evidence.sum_near_element>:1
static CUDA_CALLABLE void adj_sum_near_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_moved,
    wp::array_t<wp::int64> var_nearest,
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_moved,
    wp::array_t<wp::int64> & adj_nearest,
    wp::int32 & adj_i,
    wp::vec_t<5, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void sum_deviating_tiles_11dc021d_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved_normals,
    wp::array_t<wp::int64> var_overlap__nearest,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__normals,
    wp::float32 var_overlap__distance,
    wp::float32 var_overlap__cosine,
    wp::array_t<wp::float32> var_spreads,
    wp::array_t<wp::float32> var_other_spreads,
    wp::float32 var_sigmas,
    wp::float32 var_floor,
    wp::int32 var_count_,
    wp::array_t<wp::vec_t<2, wp::float64>> var_partials_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<2, wp::float64> var_1;
        bool var_2;
        wp::vec_t<2, wp::float64> var_3;
        wp::vec_t<2, wp::float64> var_4;
        const wp::int32 var_5 = 0;
        wp::float64 var_6;
        const wp::int32 var_7 = 1;
        wp::float64 var_8;
        wp::vec_t<2, wp::float64> var_9;
        const bool var_10 = true;
        wp::tile_register_t<wp::vec_t<2, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_11 = wp::tile_register_t<wp::vec_t<2, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<2, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_12 = wp::tile_alloc_empty<wp::vec_t<2, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_13 = 0;
        wp::vec_t<2, wp::float64> var_14;
        const wp::int32 var_15 = 0;
        wp::float64 var_16;
        const wp::int32 var_17 = 0;
        const wp::int32 var_18 = 1;
        wp::float64 var_19;
        const wp::int32 var_20 = 1;
        const wp::int32 var_21 = 256;
        wp::int32 var_22;
        const wp::int32 var_23 = 0;
        bool var_24;
        const wp::int32 var_25 = 256;
        wp::int32 var_26;
        //---------
        // forward
        // def sum_deviating_tiles(overlap__moved, overlap__moved_normals, overlap__nearest, overlap__points, overlap__normals, overlap__distance, overlap__cosine, spreads, other_spreads, sigmas, floor, count_, partials_):       <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // value_ = vector_()                                                                     <L 3>
        var_1 = wp::vec_t<2, wp::float64>();
        // if i_ < count_:                                                                        <L 4>
        var_2 = (var_0 < var_count_);
        if (var_2) {
            // value_ = element_(overlap__moved, overlap__moved_normals, overlap__nearest, overlap__points, overlap__normals, overlap__distance, overlap__cosine, spreads, other_spreads, sigmas, floor, i_)       <L 5>
            var_3 = sum_deviating_element_0(var_overlap__moved, var_overlap__moved_normals, var_overlap__nearest, var_overlap__points, var_overlap__normals, var_overlap__distance, var_overlap__cosine, var_spreads, var_other_spreads, var_sigmas, var_floor, var_0);
        }
        var_4 = wp::where(var_2, var_3, var_1);
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1]), preserve_type=True)), 0)       <L 6>
        var_6 = wp::extract(var_4, var_5);
        var_8 = wp::extract(var_4, var_7);
        var_9 = wp::vec_t<2, wp::float64>(var_6, var_8);
        var_11 = wp::tile<wp::vec_t<2, wp::float64>>(var_9);
        var_12 = wp::tile_sum(var_11);
        var_14 = wp::tile_extract(var_12, var_13);
        // value_[0] = part_0[0]                                                                  <L 7>
        var_16 = wp::extract(var_14, var_15);
        wp::assign_inplace(var_4, var_17, var_16);
        // value_[1] = part_0[1]                                                                  <L 8>
        var_19 = wp::extract(var_14, var_18);
        wp::assign_inplace(var_4, var_20, var_19);
        // if i_ % 256 == 0:                                                                      <L 9>
        var_22 = wp::mod(var_0, var_21);
        var_24 = (var_22 == var_23);
        if (var_24) {
            // partials_[i_ // 256] = value_                                                      <L 10>
            var_26 = wp::floordiv(var_0, var_25);
            wp::array_store(var_partials_, var_26, var_4);
        }
}



extern "C" __global__ void sum_near_fold_tiles_2f7dc2a4_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_count_,
    wp::array_t<wp::vec_t<5, wp::float64>> var_partials_,
    wp::array_t<wp::vec_t<5, wp::float64>> var_out_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<5, wp::float64> var_1;
        const wp::int32 var_2 = 256;
        wp::range_t var_3;
        wp::int32 var_4;
        wp::vec_t<5, wp::float64>* var_5;
        wp::vec_t<5, wp::float64> var_6;
        wp::vec_t<5, wp::float64> var_7;
        const wp::int32 var_8 = 0;
        wp::float64 var_9;
        const wp::int32 var_10 = 1;
        wp::float64 var_11;
        const wp::int32 var_12 = 2;
        wp::float64 var_13;
        const wp::int32 var_14 = 3;
        wp::float64 var_15;
        wp::vec_t<4, wp::float64> var_16;
        const bool var_17 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_18 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_19 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_20 = 0;
        wp::vec_t<4, wp::float64> var_21;
        const wp::int32 var_22 = 0;
        wp::float64 var_23;
        const wp::int32 var_24 = 0;
        const wp::int32 var_25 = 1;
        wp::float64 var_26;
        const wp::int32 var_27 = 1;
        const wp::int32 var_28 = 2;
        wp::float64 var_29;
        const wp::int32 var_30 = 2;
        const wp::int32 var_31 = 3;
        wp::float64 var_32;
        const wp::int32 var_33 = 3;
        const wp::int32 var_34 = 4;
        wp::float64 var_35;
        wp::tile_register_t<wp::float64,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_36 = wp::tile_register_t<wp::float64,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::float64,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_37 = wp::tile_alloc_empty<wp::float64,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_38 = 0;
        wp::float64 var_39;
        const wp::int32 var_40 = 4;
        const wp::int32 var_41 = 0;
        bool var_42;
        const wp::int32 var_43 = 0;
        //---------
        // forward
        // def sum_near_fold_tiles(count_, partials_, out_):                                      <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // value_ = vector_()                                                                     <L 3>
        var_1 = wp::vec_t<5, wp::float64>();
        // for j_ in range(i_, count_, 256):                                                      <L 4>
        var_3 = wp::range(var_0, var_count_, var_2);
        start_for_0:;
            if (iter_cmp(var_3) == 0) goto end_for_0;
            var_4 = wp::iter_next(var_3);
            // value_ += partials_[j_]                                                            <L 5>
            var_5 = wp::address(var_partials_, var_4);
            var_7 = wp::load(var_5);
            var_6 = wp::add(var_1, var_7);
            wp::assign(var_1, var_6);
            goto start_for_0;
        end_for_0:;
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 6>
        var_9 = wp::extract(var_1, var_8);
        var_11 = wp::extract(var_1, var_10);
        var_13 = wp::extract(var_1, var_12);
        var_15 = wp::extract(var_1, var_14);
        var_16 = wp::vec_t<4, wp::float64>(var_9, var_11, var_13, var_15);
        var_18 = wp::tile<wp::vec_t<4, wp::float64>>(var_16);
        var_19 = wp::tile_sum(var_18);
        var_21 = wp::tile_extract(var_19, var_20);
        // value_[0] = part_0[0]                                                                  <L 7>
        var_23 = wp::extract(var_21, var_22);
        wp::assign_inplace(var_1, var_24, var_23);
        // value_[1] = part_0[1]                                                                  <L 8>
        var_26 = wp::extract(var_21, var_25);
        wp::assign_inplace(var_1, var_27, var_26);
        // value_[2] = part_0[2]                                                                  <L 9>
        var_29 = wp::extract(var_21, var_28);
        wp::assign_inplace(var_1, var_30, var_29);
        // value_[3] = part_0[3]                                                                  <L 10>
        var_32 = wp::extract(var_21, var_31);
        wp::assign_inplace(var_1, var_33, var_32);
        // value_[4] = wp.tile_extract(wp.tile_sum(wp.tile(value_[4])), 0)                        <L 11>
        var_35 = wp::extract(var_1, var_34);
        var_36 = wp::tile<wp::float64>(var_35);
        var_37 = wp::tile_sum(var_36);
        var_39 = wp::tile_extract(var_37, var_38);
        wp::assign_inplace(var_1, var_40, var_39);
        // if i_ == 0:                                                                            <L 12>
        var_42 = (var_0 == var_41);
        if (var_42) {
            // out_[0] = value_                                                                   <L 13>
            wp::array_store(var_out_, var_43, var_1);
        }
}



extern "C" __global__ void sum_evidence_fold_tiles_60855a66_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_count_,
    wp::array_t<wp::vec_t<46, wp::float64>> var_partials_,
    wp::array_t<wp::vec_t<46, wp::float64>> var_out_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<46, wp::float64> var_1;
        const wp::int32 var_2 = 256;
        wp::range_t var_3;
        wp::int32 var_4;
        wp::vec_t<46, wp::float64>* var_5;
        wp::vec_t<46, wp::float64> var_6;
        wp::vec_t<46, wp::float64> var_7;
        const wp::int32 var_8 = 0;
        wp::float64 var_9;
        const wp::int32 var_10 = 1;
        wp::float64 var_11;
        const wp::int32 var_12 = 2;
        wp::float64 var_13;
        const wp::int32 var_14 = 3;
        wp::float64 var_15;
        wp::vec_t<4, wp::float64> var_16;
        const bool var_17 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_18 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_19 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_20 = 0;
        wp::vec_t<4, wp::float64> var_21;
        const wp::int32 var_22 = 0;
        wp::float64 var_23;
        const wp::int32 var_24 = 0;
        const wp::int32 var_25 = 1;
        wp::float64 var_26;
        const wp::int32 var_27 = 1;
        const wp::int32 var_28 = 2;
        wp::float64 var_29;
        const wp::int32 var_30 = 2;
        const wp::int32 var_31 = 3;
        wp::float64 var_32;
        const wp::int32 var_33 = 3;
        const wp::int32 var_34 = 4;
        wp::float64 var_35;
        const wp::int32 var_36 = 5;
        wp::float64 var_37;
        const wp::int32 var_38 = 6;
        wp::float64 var_39;
        const wp::int32 var_40 = 7;
        wp::float64 var_41;
        wp::vec_t<4, wp::float64> var_42;
        const bool var_43 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_44 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_45 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_46 = 0;
        wp::vec_t<4, wp::float64> var_47;
        const wp::int32 var_48 = 0;
        wp::float64 var_49;
        const wp::int32 var_50 = 4;
        const wp::int32 var_51 = 1;
        wp::float64 var_52;
        const wp::int32 var_53 = 5;
        const wp::int32 var_54 = 2;
        wp::float64 var_55;
        const wp::int32 var_56 = 6;
        const wp::int32 var_57 = 3;
        wp::float64 var_58;
        const wp::int32 var_59 = 7;
        const wp::int32 var_60 = 8;
        wp::float64 var_61;
        const wp::int32 var_62 = 9;
        wp::float64 var_63;
        const wp::int32 var_64 = 10;
        wp::float64 var_65;
        const wp::int32 var_66 = 11;
        wp::float64 var_67;
        wp::vec_t<4, wp::float64> var_68;
        const bool var_69 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_70 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_71 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_72 = 0;
        wp::vec_t<4, wp::float64> var_73;
        const wp::int32 var_74 = 0;
        wp::float64 var_75;
        const wp::int32 var_76 = 8;
        const wp::int32 var_77 = 1;
        wp::float64 var_78;
        const wp::int32 var_79 = 9;
        const wp::int32 var_80 = 2;
        wp::float64 var_81;
        const wp::int32 var_82 = 10;
        const wp::int32 var_83 = 3;
        wp::float64 var_84;
        const wp::int32 var_85 = 11;
        const wp::int32 var_86 = 12;
        wp::float64 var_87;
        const wp::int32 var_88 = 13;
        wp::float64 var_89;
        const wp::int32 var_90 = 14;
        wp::float64 var_91;
        const wp::int32 var_92 = 15;
        wp::float64 var_93;
        wp::vec_t<4, wp::float64> var_94;
        const bool var_95 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_96 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_97 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_98 = 0;
        wp::vec_t<4, wp::float64> var_99;
        const wp::int32 var_100 = 0;
        wp::float64 var_101;
        const wp::int32 var_102 = 12;
        const wp::int32 var_103 = 1;
        wp::float64 var_104;
        const wp::int32 var_105 = 13;
        const wp::int32 var_106 = 2;
        wp::float64 var_107;
        const wp::int32 var_108 = 14;
        const wp::int32 var_109 = 3;
        wp::float64 var_110;
        const wp::int32 var_111 = 15;
        const wp::int32 var_112 = 16;
        wp::float64 var_113;
        const wp::int32 var_114 = 17;
        wp::float64 var_115;
        const wp::int32 var_116 = 18;
        wp::float64 var_117;
        const wp::int32 var_118 = 19;
        wp::float64 var_119;
        wp::vec_t<4, wp::float64> var_120;
        const bool var_121 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_122 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_123 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_124 = 0;
        wp::vec_t<4, wp::float64> var_125;
        const wp::int32 var_126 = 0;
        wp::float64 var_127;
        const wp::int32 var_128 = 16;
        const wp::int32 var_129 = 1;
        wp::float64 var_130;
        const wp::int32 var_131 = 17;
        const wp::int32 var_132 = 2;
        wp::float64 var_133;
        const wp::int32 var_134 = 18;
        const wp::int32 var_135 = 3;
        wp::float64 var_136;
        const wp::int32 var_137 = 19;
        const wp::int32 var_138 = 20;
        wp::float64 var_139;
        const wp::int32 var_140 = 21;
        wp::float64 var_141;
        const wp::int32 var_142 = 22;
        wp::float64 var_143;
        const wp::int32 var_144 = 23;
        wp::float64 var_145;
        wp::vec_t<4, wp::float64> var_146;
        const bool var_147 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_148 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_149 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_150 = 0;
        wp::vec_t<4, wp::float64> var_151;
        const wp::int32 var_152 = 0;
        wp::float64 var_153;
        const wp::int32 var_154 = 20;
        const wp::int32 var_155 = 1;
        wp::float64 var_156;
        const wp::int32 var_157 = 21;
        const wp::int32 var_158 = 2;
        wp::float64 var_159;
        const wp::int32 var_160 = 22;
        const wp::int32 var_161 = 3;
        wp::float64 var_162;
        const wp::int32 var_163 = 23;
        const wp::int32 var_164 = 24;
        wp::float64 var_165;
        const wp::int32 var_166 = 25;
        wp::float64 var_167;
        const wp::int32 var_168 = 26;
        wp::float64 var_169;
        const wp::int32 var_170 = 27;
        wp::float64 var_171;
        wp::vec_t<4, wp::float64> var_172;
        const bool var_173 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_174 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_175 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_176 = 0;
        wp::vec_t<4, wp::float64> var_177;
        const wp::int32 var_178 = 0;
        wp::float64 var_179;
        const wp::int32 var_180 = 24;
        const wp::int32 var_181 = 1;
        wp::float64 var_182;
        const wp::int32 var_183 = 25;
        const wp::int32 var_184 = 2;
        wp::float64 var_185;
        const wp::int32 var_186 = 26;
        const wp::int32 var_187 = 3;
        wp::float64 var_188;
        const wp::int32 var_189 = 27;
        const wp::int32 var_190 = 28;
        wp::float64 var_191;
        const wp::int32 var_192 = 29;
        wp::float64 var_193;
        const wp::int32 var_194 = 30;
        wp::float64 var_195;
        const wp::int32 var_196 = 31;
        wp::float64 var_197;
        wp::vec_t<4, wp::float64> var_198;
        const bool var_199 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_200 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_201 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_202 = 0;
        wp::vec_t<4, wp::float64> var_203;
        const wp::int32 var_204 = 0;
        wp::float64 var_205;
        const wp::int32 var_206 = 28;
        const wp::int32 var_207 = 1;
        wp::float64 var_208;
        const wp::int32 var_209 = 29;
        const wp::int32 var_210 = 2;
        wp::float64 var_211;
        const wp::int32 var_212 = 30;
        const wp::int32 var_213 = 3;
        wp::float64 var_214;
        const wp::int32 var_215 = 31;
        const wp::int32 var_216 = 32;
        wp::float64 var_217;
        const wp::int32 var_218 = 33;
        wp::float64 var_219;
        const wp::int32 var_220 = 34;
        wp::float64 var_221;
        const wp::int32 var_222 = 35;
        wp::float64 var_223;
        wp::vec_t<4, wp::float64> var_224;
        const bool var_225 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_226 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_227 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_228 = 0;
        wp::vec_t<4, wp::float64> var_229;
        const wp::int32 var_230 = 0;
        wp::float64 var_231;
        const wp::int32 var_232 = 32;
        const wp::int32 var_233 = 1;
        wp::float64 var_234;
        const wp::int32 var_235 = 33;
        const wp::int32 var_236 = 2;
        wp::float64 var_237;
        const wp::int32 var_238 = 34;
        const wp::int32 var_239 = 3;
        wp::float64 var_240;
        const wp::int32 var_241 = 35;
        const wp::int32 var_242 = 36;
        wp::float64 var_243;
        const wp::int32 var_244 = 37;
        wp::float64 var_245;
        const wp::int32 var_246 = 38;
        wp::float64 var_247;
        const wp::int32 var_248 = 39;
        wp::float64 var_249;
        wp::vec_t<4, wp::float64> var_250;
        const bool var_251 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_252 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_253 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_254 = 0;
        wp::vec_t<4, wp::float64> var_255;
        const wp::int32 var_256 = 0;
        wp::float64 var_257;
        const wp::int32 var_258 = 36;
        const wp::int32 var_259 = 1;
        wp::float64 var_260;
        const wp::int32 var_261 = 37;
        const wp::int32 var_262 = 2;
        wp::float64 var_263;
        const wp::int32 var_264 = 38;
        const wp::int32 var_265 = 3;
        wp::float64 var_266;
        const wp::int32 var_267 = 39;
        const wp::int32 var_268 = 40;
        wp::float64 var_269;
        const wp::int32 var_270 = 41;
        wp::float64 var_271;
        const wp::int32 var_272 = 42;
        wp::float64 var_273;
        const wp::int32 var_274 = 43;
        wp::float64 var_275;
        wp::vec_t<4, wp::float64> var_276;
        const bool var_277 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_278 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_279 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_280 = 0;
        wp::vec_t<4, wp::float64> var_281;
        const wp::int32 var_282 = 0;
        wp::float64 var_283;
        const wp::int32 var_284 = 40;
        const wp::int32 var_285 = 1;
        wp::float64 var_286;
        const wp::int32 var_287 = 41;
        const wp::int32 var_288 = 2;
        wp::float64 var_289;
        const wp::int32 var_290 = 42;
        const wp::int32 var_291 = 3;
        wp::float64 var_292;
        const wp::int32 var_293 = 43;
        const wp::int32 var_294 = 44;
        wp::float64 var_295;
        const wp::int32 var_296 = 45;
        wp::float64 var_297;
        wp::vec_t<2, wp::float64> var_298;
        const bool var_299 = true;
        wp::tile_register_t<wp::vec_t<2, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_300 = wp::tile_register_t<wp::vec_t<2, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<2, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_301 = wp::tile_alloc_empty<wp::vec_t<2, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_302 = 0;
        wp::vec_t<2, wp::float64> var_303;
        const wp::int32 var_304 = 0;
        wp::float64 var_305;
        const wp::int32 var_306 = 44;
        const wp::int32 var_307 = 1;
        wp::float64 var_308;
        const wp::int32 var_309 = 45;
        const wp::int32 var_310 = 0;
        bool var_311;
        const wp::int32 var_312 = 0;
        //---------
        // forward
        // def sum_evidence_fold_tiles(count_, partials_, out_):                                  <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // value_ = vector_()                                                                     <L 3>
        var_1 = wp::vec_t<46, wp::float64>();
        // for j_ in range(i_, count_, 256):                                                      <L 4>
        var_3 = wp::range(var_0, var_count_, var_2);
        start_for_0:;
            if (iter_cmp(var_3) == 0) goto end_for_0;
            var_4 = wp::iter_next(var_3);
            // value_ += partials_[j_]                                                            <L 5>
            var_5 = wp::address(var_partials_, var_4);
            var_7 = wp::load(var_5);
            var_6 = wp::add(var_1, var_7);
            wp::assign(var_1, var_6);
            goto start_for_0;
        end_for_0:;
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 6>
        var_9 = wp::extract(var_1, var_8);
        var_11 = wp::extract(var_1, var_10);
        var_13 = wp::extract(var_1, var_12);
        var_15 = wp::extract(var_1, var_14);
        var_16 = wp::vec_t<4, wp::float64>(var_9, var_11, var_13, var_15);
        var_18 = wp::tile<wp::vec_t<4, wp::float64>>(var_16);
        var_19 = wp::tile_sum(var_18);
        var_21 = wp::tile_extract(var_19, var_20);
        // value_[0] = part_0[0]                                                                  <L 7>
        var_23 = wp::extract(var_21, var_22);
        wp::assign_inplace(var_1, var_24, var_23);
        // value_[1] = part_0[1]                                                                  <L 8>
        var_26 = wp::extract(var_21, var_25);
        wp::assign_inplace(var_1, var_27, var_26);
        // value_[2] = part_0[2]                                                                  <L 9>
        var_29 = wp::extract(var_21, var_28);
        wp::assign_inplace(var_1, var_30, var_29);
        // value_[3] = part_0[3]                                                                  <L 10>
        var_32 = wp::extract(var_21, var_31);
        wp::assign_inplace(var_1, var_33, var_32);
        // part_4 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[4], value_[5], value_[6], value_[7]), preserve_type=True)), 0)       <L 11>
        var_35 = wp::extract(var_1, var_34);
        var_37 = wp::extract(var_1, var_36);
        var_39 = wp::extract(var_1, var_38);
        var_41 = wp::extract(var_1, var_40);
        var_42 = wp::vec_t<4, wp::float64>(var_35, var_37, var_39, var_41);
        var_44 = wp::tile<wp::vec_t<4, wp::float64>>(var_42);
        var_45 = wp::tile_sum(var_44);
        var_47 = wp::tile_extract(var_45, var_46);
        // value_[4] = part_4[0]                                                                  <L 12>
        var_49 = wp::extract(var_47, var_48);
        wp::assign_inplace(var_1, var_50, var_49);
        // value_[5] = part_4[1]                                                                  <L 13>
        var_52 = wp::extract(var_47, var_51);
        wp::assign_inplace(var_1, var_53, var_52);
        // value_[6] = part_4[2]                                                                  <L 14>
        var_55 = wp::extract(var_47, var_54);
        wp::assign_inplace(var_1, var_56, var_55);
        // value_[7] = part_4[3]                                                                  <L 15>
        var_58 = wp::extract(var_47, var_57);
        wp::assign_inplace(var_1, var_59, var_58);
        // part_8 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[8], value_[9], value_[10], value_[11]), preserve_type=True)), 0)       <L 16>
        var_61 = wp::extract(var_1, var_60);
        var_63 = wp::extract(var_1, var_62);
        var_65 = wp::extract(var_1, var_64);
        var_67 = wp::extract(var_1, var_66);
        var_68 = wp::vec_t<4, wp::float64>(var_61, var_63, var_65, var_67);
        var_70 = wp::tile<wp::vec_t<4, wp::float64>>(var_68);
        var_71 = wp::tile_sum(var_70);
        var_73 = wp::tile_extract(var_71, var_72);
        // value_[8] = part_8[0]                                                                  <L 17>
        var_75 = wp::extract(var_73, var_74);
        wp::assign_inplace(var_1, var_76, var_75);
        // value_[9] = part_8[1]                                                                  <L 18>
        var_78 = wp::extract(var_73, var_77);
        wp::assign_inplace(var_1, var_79, var_78);
        // value_[10] = part_8[2]                                                                 <L 19>
        var_81 = wp::extract(var_73, var_80);
        wp::assign_inplace(var_1, var_82, var_81);
        // value_[11] = part_8[3]                                                                 <L 20>
        var_84 = wp::extract(var_73, var_83);
        wp::assign_inplace(var_1, var_85, var_84);
        // part_12 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[12], value_[13], value_[14], value_[15]), preserve_type=True)), 0)       <L 21>
        var_87 = wp::extract(var_1, var_86);
        var_89 = wp::extract(var_1, var_88);
        var_91 = wp::extract(var_1, var_90);
        var_93 = wp::extract(var_1, var_92);
        var_94 = wp::vec_t<4, wp::float64>(var_87, var_89, var_91, var_93);
        var_96 = wp::tile<wp::vec_t<4, wp::float64>>(var_94);
        var_97 = wp::tile_sum(var_96);
        var_99 = wp::tile_extract(var_97, var_98);
        // value_[12] = part_12[0]                                                                <L 22>
        var_101 = wp::extract(var_99, var_100);
        wp::assign_inplace(var_1, var_102, var_101);
        // value_[13] = part_12[1]                                                                <L 23>
        var_104 = wp::extract(var_99, var_103);
        wp::assign_inplace(var_1, var_105, var_104);
        // value_[14] = part_12[2]                                                                <L 24>
        var_107 = wp::extract(var_99, var_106);
        wp::assign_inplace(var_1, var_108, var_107);
        // value_[15] = part_12[3]                                                                <L 25>
        var_110 = wp::extract(var_99, var_109);
        wp::assign_inplace(var_1, var_111, var_110);
        // part_16 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[16], value_[17], value_[18], value_[19]), preserve_type=True)), 0)       <L 26>
        var_113 = wp::extract(var_1, var_112);
        var_115 = wp::extract(var_1, var_114);
        var_117 = wp::extract(var_1, var_116);
        var_119 = wp::extract(var_1, var_118);
        var_120 = wp::vec_t<4, wp::float64>(var_113, var_115, var_117, var_119);
        var_122 = wp::tile<wp::vec_t<4, wp::float64>>(var_120);
        var_123 = wp::tile_sum(var_122);
        var_125 = wp::tile_extract(var_123, var_124);
        // value_[16] = part_16[0]                                                                <L 27>
        var_127 = wp::extract(var_125, var_126);
        wp::assign_inplace(var_1, var_128, var_127);
        // value_[17] = part_16[1]                                                                <L 28>
        var_130 = wp::extract(var_125, var_129);
        wp::assign_inplace(var_1, var_131, var_130);
        // value_[18] = part_16[2]                                                                <L 29>
        var_133 = wp::extract(var_125, var_132);
        wp::assign_inplace(var_1, var_134, var_133);
        // value_[19] = part_16[3]                                                                <L 30>
        var_136 = wp::extract(var_125, var_135);
        wp::assign_inplace(var_1, var_137, var_136);
        // part_20 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[20], value_[21], value_[22], value_[23]), preserve_type=True)), 0)       <L 31>
        var_139 = wp::extract(var_1, var_138);
        var_141 = wp::extract(var_1, var_140);
        var_143 = wp::extract(var_1, var_142);
        var_145 = wp::extract(var_1, var_144);
        var_146 = wp::vec_t<4, wp::float64>(var_139, var_141, var_143, var_145);
        var_148 = wp::tile<wp::vec_t<4, wp::float64>>(var_146);
        var_149 = wp::tile_sum(var_148);
        var_151 = wp::tile_extract(var_149, var_150);
        // value_[20] = part_20[0]                                                                <L 32>
        var_153 = wp::extract(var_151, var_152);
        wp::assign_inplace(var_1, var_154, var_153);
        // value_[21] = part_20[1]                                                                <L 33>
        var_156 = wp::extract(var_151, var_155);
        wp::assign_inplace(var_1, var_157, var_156);
        // value_[22] = part_20[2]                                                                <L 34>
        var_159 = wp::extract(var_151, var_158);
        wp::assign_inplace(var_1, var_160, var_159);
        // value_[23] = part_20[3]                                                                <L 35>
        var_162 = wp::extract(var_151, var_161);
        wp::assign_inplace(var_1, var_163, var_162);
        // part_24 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[24], value_[25], value_[26], value_[27]), preserve_type=True)), 0)       <L 36>
        var_165 = wp::extract(var_1, var_164);
        var_167 = wp::extract(var_1, var_166);
        var_169 = wp::extract(var_1, var_168);
        var_171 = wp::extract(var_1, var_170);
        var_172 = wp::vec_t<4, wp::float64>(var_165, var_167, var_169, var_171);
        var_174 = wp::tile<wp::vec_t<4, wp::float64>>(var_172);
        var_175 = wp::tile_sum(var_174);
        var_177 = wp::tile_extract(var_175, var_176);
        // value_[24] = part_24[0]                                                                <L 37>
        var_179 = wp::extract(var_177, var_178);
        wp::assign_inplace(var_1, var_180, var_179);
        // value_[25] = part_24[1]                                                                <L 38>
        var_182 = wp::extract(var_177, var_181);
        wp::assign_inplace(var_1, var_183, var_182);
        // value_[26] = part_24[2]                                                                <L 39>
        var_185 = wp::extract(var_177, var_184);
        wp::assign_inplace(var_1, var_186, var_185);
        // value_[27] = part_24[3]                                                                <L 40>
        var_188 = wp::extract(var_177, var_187);
        wp::assign_inplace(var_1, var_189, var_188);
        // part_28 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[28], value_[29], value_[30], value_[31]), preserve_type=True)), 0)       <L 41>
        var_191 = wp::extract(var_1, var_190);
        var_193 = wp::extract(var_1, var_192);
        var_195 = wp::extract(var_1, var_194);
        var_197 = wp::extract(var_1, var_196);
        var_198 = wp::vec_t<4, wp::float64>(var_191, var_193, var_195, var_197);
        var_200 = wp::tile<wp::vec_t<4, wp::float64>>(var_198);
        var_201 = wp::tile_sum(var_200);
        var_203 = wp::tile_extract(var_201, var_202);
        // value_[28] = part_28[0]                                                                <L 42>
        var_205 = wp::extract(var_203, var_204);
        wp::assign_inplace(var_1, var_206, var_205);
        // value_[29] = part_28[1]                                                                <L 43>
        var_208 = wp::extract(var_203, var_207);
        wp::assign_inplace(var_1, var_209, var_208);
        // value_[30] = part_28[2]                                                                <L 44>
        var_211 = wp::extract(var_203, var_210);
        wp::assign_inplace(var_1, var_212, var_211);
        // value_[31] = part_28[3]                                                                <L 45>
        var_214 = wp::extract(var_203, var_213);
        wp::assign_inplace(var_1, var_215, var_214);
        // part_32 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[32], value_[33], value_[34], value_[35]), preserve_type=True)), 0)       <L 46>
        var_217 = wp::extract(var_1, var_216);
        var_219 = wp::extract(var_1, var_218);
        var_221 = wp::extract(var_1, var_220);
        var_223 = wp::extract(var_1, var_222);
        var_224 = wp::vec_t<4, wp::float64>(var_217, var_219, var_221, var_223);
        var_226 = wp::tile<wp::vec_t<4, wp::float64>>(var_224);
        var_227 = wp::tile_sum(var_226);
        var_229 = wp::tile_extract(var_227, var_228);
        // value_[32] = part_32[0]                                                                <L 47>
        var_231 = wp::extract(var_229, var_230);
        wp::assign_inplace(var_1, var_232, var_231);
        // value_[33] = part_32[1]                                                                <L 48>
        var_234 = wp::extract(var_229, var_233);
        wp::assign_inplace(var_1, var_235, var_234);
        // value_[34] = part_32[2]                                                                <L 49>
        var_237 = wp::extract(var_229, var_236);
        wp::assign_inplace(var_1, var_238, var_237);
        // value_[35] = part_32[3]                                                                <L 50>
        var_240 = wp::extract(var_229, var_239);
        wp::assign_inplace(var_1, var_241, var_240);
        // part_36 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[36], value_[37], value_[38], value_[39]), preserve_type=True)), 0)       <L 51>
        var_243 = wp::extract(var_1, var_242);
        var_245 = wp::extract(var_1, var_244);
        var_247 = wp::extract(var_1, var_246);
        var_249 = wp::extract(var_1, var_248);
        var_250 = wp::vec_t<4, wp::float64>(var_243, var_245, var_247, var_249);
        var_252 = wp::tile<wp::vec_t<4, wp::float64>>(var_250);
        var_253 = wp::tile_sum(var_252);
        var_255 = wp::tile_extract(var_253, var_254);
        // value_[36] = part_36[0]                                                                <L 52>
        var_257 = wp::extract(var_255, var_256);
        wp::assign_inplace(var_1, var_258, var_257);
        // value_[37] = part_36[1]                                                                <L 53>
        var_260 = wp::extract(var_255, var_259);
        wp::assign_inplace(var_1, var_261, var_260);
        // value_[38] = part_36[2]                                                                <L 54>
        var_263 = wp::extract(var_255, var_262);
        wp::assign_inplace(var_1, var_264, var_263);
        // value_[39] = part_36[3]                                                                <L 55>
        var_266 = wp::extract(var_255, var_265);
        wp::assign_inplace(var_1, var_267, var_266);
        // part_40 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[40], value_[41], value_[42], value_[43]), preserve_type=True)), 0)       <L 56>
        var_269 = wp::extract(var_1, var_268);
        var_271 = wp::extract(var_1, var_270);
        var_273 = wp::extract(var_1, var_272);
        var_275 = wp::extract(var_1, var_274);
        var_276 = wp::vec_t<4, wp::float64>(var_269, var_271, var_273, var_275);
        var_278 = wp::tile<wp::vec_t<4, wp::float64>>(var_276);
        var_279 = wp::tile_sum(var_278);
        var_281 = wp::tile_extract(var_279, var_280);
        // value_[40] = part_40[0]                                                                <L 57>
        var_283 = wp::extract(var_281, var_282);
        wp::assign_inplace(var_1, var_284, var_283);
        // value_[41] = part_40[1]                                                                <L 58>
        var_286 = wp::extract(var_281, var_285);
        wp::assign_inplace(var_1, var_287, var_286);
        // value_[42] = part_40[2]                                                                <L 59>
        var_289 = wp::extract(var_281, var_288);
        wp::assign_inplace(var_1, var_290, var_289);
        // value_[43] = part_40[3]                                                                <L 60>
        var_292 = wp::extract(var_281, var_291);
        wp::assign_inplace(var_1, var_293, var_292);
        // part_44 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[44], value_[45]), preserve_type=True)), 0)       <L 61>
        var_295 = wp::extract(var_1, var_294);
        var_297 = wp::extract(var_1, var_296);
        var_298 = wp::vec_t<2, wp::float64>(var_295, var_297);
        var_300 = wp::tile<wp::vec_t<2, wp::float64>>(var_298);
        var_301 = wp::tile_sum(var_300);
        var_303 = wp::tile_extract(var_301, var_302);
        // value_[44] = part_44[0]                                                                <L 62>
        var_305 = wp::extract(var_303, var_304);
        wp::assign_inplace(var_1, var_306, var_305);
        // value_[45] = part_44[1]                                                                <L 63>
        var_308 = wp::extract(var_303, var_307);
        wp::assign_inplace(var_1, var_309, var_308);
        // if i_ == 0:                                                                            <L 64>
        var_311 = (var_0 == var_310);
        if (var_311) {
            // out_[0] = value_                                                                   <L 65>
            wp::array_store(var_out_, var_312, var_1);
        }
}



extern "C" __global__ void sum_relief_tiles_793d54ff_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved_normals,
    wp::array_t<wp::int64> var_overlap__nearest,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__normals,
    wp::float32 var_overlap__distance,
    wp::float32 var_overlap__cosine,
    wp::float32 var_overlap__tight,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__middles,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__directions,
    wp::array_t<wp::int32> var_planes__count,
    wp::float32 var_slab,
    wp::float32 var_edge,
    wp::int32 var_count_,
    wp::array_t<wp::vec_t<4, wp::float64>> var_partials_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<4, wp::float64> var_1;
        bool var_2;
        wp::vec_t<4, wp::float64> var_3;
        wp::vec_t<4, wp::float64> var_4;
        const wp::int32 var_5 = 0;
        wp::float64 var_6;
        const wp::int32 var_7 = 1;
        wp::float64 var_8;
        const wp::int32 var_9 = 2;
        wp::float64 var_10;
        const wp::int32 var_11 = 3;
        wp::float64 var_12;
        wp::vec_t<4, wp::float64> var_13;
        const bool var_14 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_15 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_16 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_17 = 0;
        wp::vec_t<4, wp::float64> var_18;
        const wp::int32 var_19 = 0;
        wp::float64 var_20;
        const wp::int32 var_21 = 0;
        const wp::int32 var_22 = 1;
        wp::float64 var_23;
        const wp::int32 var_24 = 1;
        const wp::int32 var_25 = 2;
        wp::float64 var_26;
        const wp::int32 var_27 = 2;
        const wp::int32 var_28 = 3;
        wp::float64 var_29;
        const wp::int32 var_30 = 3;
        const wp::int32 var_31 = 256;
        wp::int32 var_32;
        const wp::int32 var_33 = 0;
        bool var_34;
        const wp::int32 var_35 = 256;
        wp::int32 var_36;
        //---------
        // forward
        // def sum_relief_tiles(overlap__moved, overlap__moved_normals, overlap__nearest, overlap__points, overlap__normals, overlap__distance, overlap__cosine, overlap__tight, planes__middles, planes__directions, planes__count, slab, edge, count_, partials_):       <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // value_ = vector_()                                                                     <L 3>
        var_1 = wp::vec_t<4, wp::float64>();
        // if i_ < count_:                                                                        <L 4>
        var_2 = (var_0 < var_count_);
        if (var_2) {
            // value_ = element_(overlap__moved, overlap__moved_normals, overlap__nearest, overlap__points, overlap__normals, overlap__distance, overlap__cosine, overlap__tight, planes__middles, planes__directions, planes__count, slab, edge, i_)       <L 5>
            var_3 = sum_relief_element_0(var_overlap__moved, var_overlap__moved_normals, var_overlap__nearest, var_overlap__points, var_overlap__normals, var_overlap__distance, var_overlap__cosine, var_overlap__tight, var_planes__middles, var_planes__directions, var_planes__count, var_slab, var_edge, var_0);
        }
        var_4 = wp::where(var_2, var_3, var_1);
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 6>
        var_6 = wp::extract(var_4, var_5);
        var_8 = wp::extract(var_4, var_7);
        var_10 = wp::extract(var_4, var_9);
        var_12 = wp::extract(var_4, var_11);
        var_13 = wp::vec_t<4, wp::float64>(var_6, var_8, var_10, var_12);
        var_15 = wp::tile<wp::vec_t<4, wp::float64>>(var_13);
        var_16 = wp::tile_sum(var_15);
        var_18 = wp::tile_extract(var_16, var_17);
        // value_[0] = part_0[0]                                                                  <L 7>
        var_20 = wp::extract(var_18, var_19);
        wp::assign_inplace(var_4, var_21, var_20);
        // value_[1] = part_0[1]                                                                  <L 8>
        var_23 = wp::extract(var_18, var_22);
        wp::assign_inplace(var_4, var_24, var_23);
        // value_[2] = part_0[2]                                                                  <L 9>
        var_26 = wp::extract(var_18, var_25);
        wp::assign_inplace(var_4, var_27, var_26);
        // value_[3] = part_0[3]                                                                  <L 10>
        var_29 = wp::extract(var_18, var_28);
        wp::assign_inplace(var_4, var_30, var_29);
        // if i_ % 256 == 0:                                                                      <L 11>
        var_32 = wp::mod(var_0, var_31);
        var_34 = (var_32 == var_33);
        if (var_34) {
            // partials_[i_ // 256] = value_                                                      <L 12>
            var_36 = wp::floordiv(var_0, var_35);
            wp::array_store(var_partials_, var_36, var_4);
        }
}



extern "C" __global__ void sum_evidence_tiles_a6dcff3e_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved_normals,
    wp::array_t<wp::int64> var_overlap__nearest,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__normals,
    wp::array_t<wp::vec_t<3, wp::float64>> var_overlap__middle,
    wp::array_t<wp::float64> var_overlap__scale,
    wp::float32 var_overlap__distance,
    wp::float32 var_overlap__cosine,
    wp::float32 var_overlap__tight,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__frame,
    wp::array_t<wp::int32> var_overlap__frame_size,
    wp::int32 var_count_,
    wp::array_t<wp::vec_t<46, wp::float64>> var_partials_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<46, wp::float64> var_1;
        bool var_2;
        wp::vec_t<46, wp::float64> var_3;
        wp::vec_t<46, wp::float64> var_4;
        const wp::int32 var_5 = 0;
        wp::float64 var_6;
        const wp::int32 var_7 = 1;
        wp::float64 var_8;
        const wp::int32 var_9 = 2;
        wp::float64 var_10;
        const wp::int32 var_11 = 3;
        wp::float64 var_12;
        wp::vec_t<4, wp::float64> var_13;
        const bool var_14 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_15 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_16 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_17 = 0;
        wp::vec_t<4, wp::float64> var_18;
        const wp::int32 var_19 = 0;
        wp::float64 var_20;
        const wp::int32 var_21 = 0;
        const wp::int32 var_22 = 1;
        wp::float64 var_23;
        const wp::int32 var_24 = 1;
        const wp::int32 var_25 = 2;
        wp::float64 var_26;
        const wp::int32 var_27 = 2;
        const wp::int32 var_28 = 3;
        wp::float64 var_29;
        const wp::int32 var_30 = 3;
        const wp::int32 var_31 = 4;
        wp::float64 var_32;
        const wp::int32 var_33 = 5;
        wp::float64 var_34;
        const wp::int32 var_35 = 6;
        wp::float64 var_36;
        const wp::int32 var_37 = 7;
        wp::float64 var_38;
        wp::vec_t<4, wp::float64> var_39;
        const bool var_40 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_41 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_42 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_43 = 0;
        wp::vec_t<4, wp::float64> var_44;
        const wp::int32 var_45 = 0;
        wp::float64 var_46;
        const wp::int32 var_47 = 4;
        const wp::int32 var_48 = 1;
        wp::float64 var_49;
        const wp::int32 var_50 = 5;
        const wp::int32 var_51 = 2;
        wp::float64 var_52;
        const wp::int32 var_53 = 6;
        const wp::int32 var_54 = 3;
        wp::float64 var_55;
        const wp::int32 var_56 = 7;
        const wp::int32 var_57 = 8;
        wp::float64 var_58;
        const wp::int32 var_59 = 9;
        wp::float64 var_60;
        const wp::int32 var_61 = 10;
        wp::float64 var_62;
        const wp::int32 var_63 = 11;
        wp::float64 var_64;
        wp::vec_t<4, wp::float64> var_65;
        const bool var_66 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_67 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_68 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_69 = 0;
        wp::vec_t<4, wp::float64> var_70;
        const wp::int32 var_71 = 0;
        wp::float64 var_72;
        const wp::int32 var_73 = 8;
        const wp::int32 var_74 = 1;
        wp::float64 var_75;
        const wp::int32 var_76 = 9;
        const wp::int32 var_77 = 2;
        wp::float64 var_78;
        const wp::int32 var_79 = 10;
        const wp::int32 var_80 = 3;
        wp::float64 var_81;
        const wp::int32 var_82 = 11;
        const wp::int32 var_83 = 12;
        wp::float64 var_84;
        const wp::int32 var_85 = 13;
        wp::float64 var_86;
        const wp::int32 var_87 = 14;
        wp::float64 var_88;
        const wp::int32 var_89 = 15;
        wp::float64 var_90;
        wp::vec_t<4, wp::float64> var_91;
        const bool var_92 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_93 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_94 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_95 = 0;
        wp::vec_t<4, wp::float64> var_96;
        const wp::int32 var_97 = 0;
        wp::float64 var_98;
        const wp::int32 var_99 = 12;
        const wp::int32 var_100 = 1;
        wp::float64 var_101;
        const wp::int32 var_102 = 13;
        const wp::int32 var_103 = 2;
        wp::float64 var_104;
        const wp::int32 var_105 = 14;
        const wp::int32 var_106 = 3;
        wp::float64 var_107;
        const wp::int32 var_108 = 15;
        const wp::int32 var_109 = 16;
        wp::float64 var_110;
        const wp::int32 var_111 = 17;
        wp::float64 var_112;
        const wp::int32 var_113 = 18;
        wp::float64 var_114;
        const wp::int32 var_115 = 19;
        wp::float64 var_116;
        wp::vec_t<4, wp::float64> var_117;
        const bool var_118 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_119 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_120 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_121 = 0;
        wp::vec_t<4, wp::float64> var_122;
        const wp::int32 var_123 = 0;
        wp::float64 var_124;
        const wp::int32 var_125 = 16;
        const wp::int32 var_126 = 1;
        wp::float64 var_127;
        const wp::int32 var_128 = 17;
        const wp::int32 var_129 = 2;
        wp::float64 var_130;
        const wp::int32 var_131 = 18;
        const wp::int32 var_132 = 3;
        wp::float64 var_133;
        const wp::int32 var_134 = 19;
        const wp::int32 var_135 = 20;
        wp::float64 var_136;
        const wp::int32 var_137 = 21;
        wp::float64 var_138;
        const wp::int32 var_139 = 22;
        wp::float64 var_140;
        const wp::int32 var_141 = 23;
        wp::float64 var_142;
        wp::vec_t<4, wp::float64> var_143;
        const bool var_144 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_145 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_146 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_147 = 0;
        wp::vec_t<4, wp::float64> var_148;
        const wp::int32 var_149 = 0;
        wp::float64 var_150;
        const wp::int32 var_151 = 20;
        const wp::int32 var_152 = 1;
        wp::float64 var_153;
        const wp::int32 var_154 = 21;
        const wp::int32 var_155 = 2;
        wp::float64 var_156;
        const wp::int32 var_157 = 22;
        const wp::int32 var_158 = 3;
        wp::float64 var_159;
        const wp::int32 var_160 = 23;
        const wp::int32 var_161 = 24;
        wp::float64 var_162;
        const wp::int32 var_163 = 25;
        wp::float64 var_164;
        const wp::int32 var_165 = 26;
        wp::float64 var_166;
        const wp::int32 var_167 = 27;
        wp::float64 var_168;
        wp::vec_t<4, wp::float64> var_169;
        const bool var_170 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_171 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_172 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_173 = 0;
        wp::vec_t<4, wp::float64> var_174;
        const wp::int32 var_175 = 0;
        wp::float64 var_176;
        const wp::int32 var_177 = 24;
        const wp::int32 var_178 = 1;
        wp::float64 var_179;
        const wp::int32 var_180 = 25;
        const wp::int32 var_181 = 2;
        wp::float64 var_182;
        const wp::int32 var_183 = 26;
        const wp::int32 var_184 = 3;
        wp::float64 var_185;
        const wp::int32 var_186 = 27;
        const wp::int32 var_187 = 28;
        wp::float64 var_188;
        const wp::int32 var_189 = 29;
        wp::float64 var_190;
        const wp::int32 var_191 = 30;
        wp::float64 var_192;
        const wp::int32 var_193 = 31;
        wp::float64 var_194;
        wp::vec_t<4, wp::float64> var_195;
        const bool var_196 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_197 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_198 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_199 = 0;
        wp::vec_t<4, wp::float64> var_200;
        const wp::int32 var_201 = 0;
        wp::float64 var_202;
        const wp::int32 var_203 = 28;
        const wp::int32 var_204 = 1;
        wp::float64 var_205;
        const wp::int32 var_206 = 29;
        const wp::int32 var_207 = 2;
        wp::float64 var_208;
        const wp::int32 var_209 = 30;
        const wp::int32 var_210 = 3;
        wp::float64 var_211;
        const wp::int32 var_212 = 31;
        const wp::int32 var_213 = 32;
        wp::float64 var_214;
        const wp::int32 var_215 = 33;
        wp::float64 var_216;
        const wp::int32 var_217 = 34;
        wp::float64 var_218;
        const wp::int32 var_219 = 35;
        wp::float64 var_220;
        wp::vec_t<4, wp::float64> var_221;
        const bool var_222 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_223 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_224 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_225 = 0;
        wp::vec_t<4, wp::float64> var_226;
        const wp::int32 var_227 = 0;
        wp::float64 var_228;
        const wp::int32 var_229 = 32;
        const wp::int32 var_230 = 1;
        wp::float64 var_231;
        const wp::int32 var_232 = 33;
        const wp::int32 var_233 = 2;
        wp::float64 var_234;
        const wp::int32 var_235 = 34;
        const wp::int32 var_236 = 3;
        wp::float64 var_237;
        const wp::int32 var_238 = 35;
        const wp::int32 var_239 = 36;
        wp::float64 var_240;
        const wp::int32 var_241 = 37;
        wp::float64 var_242;
        const wp::int32 var_243 = 38;
        wp::float64 var_244;
        const wp::int32 var_245 = 39;
        wp::float64 var_246;
        wp::vec_t<4, wp::float64> var_247;
        const bool var_248 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_249 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_250 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_251 = 0;
        wp::vec_t<4, wp::float64> var_252;
        const wp::int32 var_253 = 0;
        wp::float64 var_254;
        const wp::int32 var_255 = 36;
        const wp::int32 var_256 = 1;
        wp::float64 var_257;
        const wp::int32 var_258 = 37;
        const wp::int32 var_259 = 2;
        wp::float64 var_260;
        const wp::int32 var_261 = 38;
        const wp::int32 var_262 = 3;
        wp::float64 var_263;
        const wp::int32 var_264 = 39;
        const wp::int32 var_265 = 40;
        wp::float64 var_266;
        const wp::int32 var_267 = 41;
        wp::float64 var_268;
        const wp::int32 var_269 = 42;
        wp::float64 var_270;
        const wp::int32 var_271 = 43;
        wp::float64 var_272;
        wp::vec_t<4, wp::float64> var_273;
        const bool var_274 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_275 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_276 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_277 = 0;
        wp::vec_t<4, wp::float64> var_278;
        const wp::int32 var_279 = 0;
        wp::float64 var_280;
        const wp::int32 var_281 = 40;
        const wp::int32 var_282 = 1;
        wp::float64 var_283;
        const wp::int32 var_284 = 41;
        const wp::int32 var_285 = 2;
        wp::float64 var_286;
        const wp::int32 var_287 = 42;
        const wp::int32 var_288 = 3;
        wp::float64 var_289;
        const wp::int32 var_290 = 43;
        const wp::int32 var_291 = 44;
        wp::float64 var_292;
        const wp::int32 var_293 = 45;
        wp::float64 var_294;
        wp::vec_t<2, wp::float64> var_295;
        const bool var_296 = true;
        wp::tile_register_t<wp::vec_t<2, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_297 = wp::tile_register_t<wp::vec_t<2, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<2, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_298 = wp::tile_alloc_empty<wp::vec_t<2, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_299 = 0;
        wp::vec_t<2, wp::float64> var_300;
        const wp::int32 var_301 = 0;
        wp::float64 var_302;
        const wp::int32 var_303 = 44;
        const wp::int32 var_304 = 1;
        wp::float64 var_305;
        const wp::int32 var_306 = 45;
        const wp::int32 var_307 = 256;
        wp::int32 var_308;
        const wp::int32 var_309 = 0;
        bool var_310;
        const wp::int32 var_311 = 256;
        wp::int32 var_312;
        //---------
        // forward
        // def sum_evidence_tiles(overlap__moved, overlap__moved_normals, overlap__nearest, overlap__points, overlap__normals, overlap__middle, overlap__scale, overlap__distance, overlap__cosine, overlap__tight, overlap__frame, overlap__frame_size, count_, partials_):       <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // value_ = vector_()                                                                     <L 3>
        var_1 = wp::vec_t<46, wp::float64>();
        // if i_ < count_:                                                                        <L 4>
        var_2 = (var_0 < var_count_);
        if (var_2) {
            // value_ = element_(overlap__moved, overlap__moved_normals, overlap__nearest, overlap__points, overlap__normals, overlap__middle, overlap__scale, overlap__distance, overlap__cosine, overlap__tight, overlap__frame, overlap__frame_size, i_)       <L 5>
            var_3 = sum_evidence_element_0(var_overlap__moved, var_overlap__moved_normals, var_overlap__nearest, var_overlap__points, var_overlap__normals, var_overlap__middle, var_overlap__scale, var_overlap__distance, var_overlap__cosine, var_overlap__tight, var_overlap__frame, var_overlap__frame_size, var_0);
        }
        var_4 = wp::where(var_2, var_3, var_1);
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 6>
        var_6 = wp::extract(var_4, var_5);
        var_8 = wp::extract(var_4, var_7);
        var_10 = wp::extract(var_4, var_9);
        var_12 = wp::extract(var_4, var_11);
        var_13 = wp::vec_t<4, wp::float64>(var_6, var_8, var_10, var_12);
        var_15 = wp::tile<wp::vec_t<4, wp::float64>>(var_13);
        var_16 = wp::tile_sum(var_15);
        var_18 = wp::tile_extract(var_16, var_17);
        // value_[0] = part_0[0]                                                                  <L 7>
        var_20 = wp::extract(var_18, var_19);
        wp::assign_inplace(var_4, var_21, var_20);
        // value_[1] = part_0[1]                                                                  <L 8>
        var_23 = wp::extract(var_18, var_22);
        wp::assign_inplace(var_4, var_24, var_23);
        // value_[2] = part_0[2]                                                                  <L 9>
        var_26 = wp::extract(var_18, var_25);
        wp::assign_inplace(var_4, var_27, var_26);
        // value_[3] = part_0[3]                                                                  <L 10>
        var_29 = wp::extract(var_18, var_28);
        wp::assign_inplace(var_4, var_30, var_29);
        // part_4 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[4], value_[5], value_[6], value_[7]), preserve_type=True)), 0)       <L 11>
        var_32 = wp::extract(var_4, var_31);
        var_34 = wp::extract(var_4, var_33);
        var_36 = wp::extract(var_4, var_35);
        var_38 = wp::extract(var_4, var_37);
        var_39 = wp::vec_t<4, wp::float64>(var_32, var_34, var_36, var_38);
        var_41 = wp::tile<wp::vec_t<4, wp::float64>>(var_39);
        var_42 = wp::tile_sum(var_41);
        var_44 = wp::tile_extract(var_42, var_43);
        // value_[4] = part_4[0]                                                                  <L 12>
        var_46 = wp::extract(var_44, var_45);
        wp::assign_inplace(var_4, var_47, var_46);
        // value_[5] = part_4[1]                                                                  <L 13>
        var_49 = wp::extract(var_44, var_48);
        wp::assign_inplace(var_4, var_50, var_49);
        // value_[6] = part_4[2]                                                                  <L 14>
        var_52 = wp::extract(var_44, var_51);
        wp::assign_inplace(var_4, var_53, var_52);
        // value_[7] = part_4[3]                                                                  <L 15>
        var_55 = wp::extract(var_44, var_54);
        wp::assign_inplace(var_4, var_56, var_55);
        // part_8 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[8], value_[9], value_[10], value_[11]), preserve_type=True)), 0)       <L 16>
        var_58 = wp::extract(var_4, var_57);
        var_60 = wp::extract(var_4, var_59);
        var_62 = wp::extract(var_4, var_61);
        var_64 = wp::extract(var_4, var_63);
        var_65 = wp::vec_t<4, wp::float64>(var_58, var_60, var_62, var_64);
        var_67 = wp::tile<wp::vec_t<4, wp::float64>>(var_65);
        var_68 = wp::tile_sum(var_67);
        var_70 = wp::tile_extract(var_68, var_69);
        // value_[8] = part_8[0]                                                                  <L 17>
        var_72 = wp::extract(var_70, var_71);
        wp::assign_inplace(var_4, var_73, var_72);
        // value_[9] = part_8[1]                                                                  <L 18>
        var_75 = wp::extract(var_70, var_74);
        wp::assign_inplace(var_4, var_76, var_75);
        // value_[10] = part_8[2]                                                                 <L 19>
        var_78 = wp::extract(var_70, var_77);
        wp::assign_inplace(var_4, var_79, var_78);
        // value_[11] = part_8[3]                                                                 <L 20>
        var_81 = wp::extract(var_70, var_80);
        wp::assign_inplace(var_4, var_82, var_81);
        // part_12 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[12], value_[13], value_[14], value_[15]), preserve_type=True)), 0)       <L 21>
        var_84 = wp::extract(var_4, var_83);
        var_86 = wp::extract(var_4, var_85);
        var_88 = wp::extract(var_4, var_87);
        var_90 = wp::extract(var_4, var_89);
        var_91 = wp::vec_t<4, wp::float64>(var_84, var_86, var_88, var_90);
        var_93 = wp::tile<wp::vec_t<4, wp::float64>>(var_91);
        var_94 = wp::tile_sum(var_93);
        var_96 = wp::tile_extract(var_94, var_95);
        // value_[12] = part_12[0]                                                                <L 22>
        var_98 = wp::extract(var_96, var_97);
        wp::assign_inplace(var_4, var_99, var_98);
        // value_[13] = part_12[1]                                                                <L 23>
        var_101 = wp::extract(var_96, var_100);
        wp::assign_inplace(var_4, var_102, var_101);
        // value_[14] = part_12[2]                                                                <L 24>
        var_104 = wp::extract(var_96, var_103);
        wp::assign_inplace(var_4, var_105, var_104);
        // value_[15] = part_12[3]                                                                <L 25>
        var_107 = wp::extract(var_96, var_106);
        wp::assign_inplace(var_4, var_108, var_107);
        // part_16 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[16], value_[17], value_[18], value_[19]), preserve_type=True)), 0)       <L 26>
        var_110 = wp::extract(var_4, var_109);
        var_112 = wp::extract(var_4, var_111);
        var_114 = wp::extract(var_4, var_113);
        var_116 = wp::extract(var_4, var_115);
        var_117 = wp::vec_t<4, wp::float64>(var_110, var_112, var_114, var_116);
        var_119 = wp::tile<wp::vec_t<4, wp::float64>>(var_117);
        var_120 = wp::tile_sum(var_119);
        var_122 = wp::tile_extract(var_120, var_121);
        // value_[16] = part_16[0]                                                                <L 27>
        var_124 = wp::extract(var_122, var_123);
        wp::assign_inplace(var_4, var_125, var_124);
        // value_[17] = part_16[1]                                                                <L 28>
        var_127 = wp::extract(var_122, var_126);
        wp::assign_inplace(var_4, var_128, var_127);
        // value_[18] = part_16[2]                                                                <L 29>
        var_130 = wp::extract(var_122, var_129);
        wp::assign_inplace(var_4, var_131, var_130);
        // value_[19] = part_16[3]                                                                <L 30>
        var_133 = wp::extract(var_122, var_132);
        wp::assign_inplace(var_4, var_134, var_133);
        // part_20 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[20], value_[21], value_[22], value_[23]), preserve_type=True)), 0)       <L 31>
        var_136 = wp::extract(var_4, var_135);
        var_138 = wp::extract(var_4, var_137);
        var_140 = wp::extract(var_4, var_139);
        var_142 = wp::extract(var_4, var_141);
        var_143 = wp::vec_t<4, wp::float64>(var_136, var_138, var_140, var_142);
        var_145 = wp::tile<wp::vec_t<4, wp::float64>>(var_143);
        var_146 = wp::tile_sum(var_145);
        var_148 = wp::tile_extract(var_146, var_147);
        // value_[20] = part_20[0]                                                                <L 32>
        var_150 = wp::extract(var_148, var_149);
        wp::assign_inplace(var_4, var_151, var_150);
        // value_[21] = part_20[1]                                                                <L 33>
        var_153 = wp::extract(var_148, var_152);
        wp::assign_inplace(var_4, var_154, var_153);
        // value_[22] = part_20[2]                                                                <L 34>
        var_156 = wp::extract(var_148, var_155);
        wp::assign_inplace(var_4, var_157, var_156);
        // value_[23] = part_20[3]                                                                <L 35>
        var_159 = wp::extract(var_148, var_158);
        wp::assign_inplace(var_4, var_160, var_159);
        // part_24 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[24], value_[25], value_[26], value_[27]), preserve_type=True)), 0)       <L 36>
        var_162 = wp::extract(var_4, var_161);
        var_164 = wp::extract(var_4, var_163);
        var_166 = wp::extract(var_4, var_165);
        var_168 = wp::extract(var_4, var_167);
        var_169 = wp::vec_t<4, wp::float64>(var_162, var_164, var_166, var_168);
        var_171 = wp::tile<wp::vec_t<4, wp::float64>>(var_169);
        var_172 = wp::tile_sum(var_171);
        var_174 = wp::tile_extract(var_172, var_173);
        // value_[24] = part_24[0]                                                                <L 37>
        var_176 = wp::extract(var_174, var_175);
        wp::assign_inplace(var_4, var_177, var_176);
        // value_[25] = part_24[1]                                                                <L 38>
        var_179 = wp::extract(var_174, var_178);
        wp::assign_inplace(var_4, var_180, var_179);
        // value_[26] = part_24[2]                                                                <L 39>
        var_182 = wp::extract(var_174, var_181);
        wp::assign_inplace(var_4, var_183, var_182);
        // value_[27] = part_24[3]                                                                <L 40>
        var_185 = wp::extract(var_174, var_184);
        wp::assign_inplace(var_4, var_186, var_185);
        // part_28 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[28], value_[29], value_[30], value_[31]), preserve_type=True)), 0)       <L 41>
        var_188 = wp::extract(var_4, var_187);
        var_190 = wp::extract(var_4, var_189);
        var_192 = wp::extract(var_4, var_191);
        var_194 = wp::extract(var_4, var_193);
        var_195 = wp::vec_t<4, wp::float64>(var_188, var_190, var_192, var_194);
        var_197 = wp::tile<wp::vec_t<4, wp::float64>>(var_195);
        var_198 = wp::tile_sum(var_197);
        var_200 = wp::tile_extract(var_198, var_199);
        // value_[28] = part_28[0]                                                                <L 42>
        var_202 = wp::extract(var_200, var_201);
        wp::assign_inplace(var_4, var_203, var_202);
        // value_[29] = part_28[1]                                                                <L 43>
        var_205 = wp::extract(var_200, var_204);
        wp::assign_inplace(var_4, var_206, var_205);
        // value_[30] = part_28[2]                                                                <L 44>
        var_208 = wp::extract(var_200, var_207);
        wp::assign_inplace(var_4, var_209, var_208);
        // value_[31] = part_28[3]                                                                <L 45>
        var_211 = wp::extract(var_200, var_210);
        wp::assign_inplace(var_4, var_212, var_211);
        // part_32 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[32], value_[33], value_[34], value_[35]), preserve_type=True)), 0)       <L 46>
        var_214 = wp::extract(var_4, var_213);
        var_216 = wp::extract(var_4, var_215);
        var_218 = wp::extract(var_4, var_217);
        var_220 = wp::extract(var_4, var_219);
        var_221 = wp::vec_t<4, wp::float64>(var_214, var_216, var_218, var_220);
        var_223 = wp::tile<wp::vec_t<4, wp::float64>>(var_221);
        var_224 = wp::tile_sum(var_223);
        var_226 = wp::tile_extract(var_224, var_225);
        // value_[32] = part_32[0]                                                                <L 47>
        var_228 = wp::extract(var_226, var_227);
        wp::assign_inplace(var_4, var_229, var_228);
        // value_[33] = part_32[1]                                                                <L 48>
        var_231 = wp::extract(var_226, var_230);
        wp::assign_inplace(var_4, var_232, var_231);
        // value_[34] = part_32[2]                                                                <L 49>
        var_234 = wp::extract(var_226, var_233);
        wp::assign_inplace(var_4, var_235, var_234);
        // value_[35] = part_32[3]                                                                <L 50>
        var_237 = wp::extract(var_226, var_236);
        wp::assign_inplace(var_4, var_238, var_237);
        // part_36 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[36], value_[37], value_[38], value_[39]), preserve_type=True)), 0)       <L 51>
        var_240 = wp::extract(var_4, var_239);
        var_242 = wp::extract(var_4, var_241);
        var_244 = wp::extract(var_4, var_243);
        var_246 = wp::extract(var_4, var_245);
        var_247 = wp::vec_t<4, wp::float64>(var_240, var_242, var_244, var_246);
        var_249 = wp::tile<wp::vec_t<4, wp::float64>>(var_247);
        var_250 = wp::tile_sum(var_249);
        var_252 = wp::tile_extract(var_250, var_251);
        // value_[36] = part_36[0]                                                                <L 52>
        var_254 = wp::extract(var_252, var_253);
        wp::assign_inplace(var_4, var_255, var_254);
        // value_[37] = part_36[1]                                                                <L 53>
        var_257 = wp::extract(var_252, var_256);
        wp::assign_inplace(var_4, var_258, var_257);
        // value_[38] = part_36[2]                                                                <L 54>
        var_260 = wp::extract(var_252, var_259);
        wp::assign_inplace(var_4, var_261, var_260);
        // value_[39] = part_36[3]                                                                <L 55>
        var_263 = wp::extract(var_252, var_262);
        wp::assign_inplace(var_4, var_264, var_263);
        // part_40 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[40], value_[41], value_[42], value_[43]), preserve_type=True)), 0)       <L 56>
        var_266 = wp::extract(var_4, var_265);
        var_268 = wp::extract(var_4, var_267);
        var_270 = wp::extract(var_4, var_269);
        var_272 = wp::extract(var_4, var_271);
        var_273 = wp::vec_t<4, wp::float64>(var_266, var_268, var_270, var_272);
        var_275 = wp::tile<wp::vec_t<4, wp::float64>>(var_273);
        var_276 = wp::tile_sum(var_275);
        var_278 = wp::tile_extract(var_276, var_277);
        // value_[40] = part_40[0]                                                                <L 57>
        var_280 = wp::extract(var_278, var_279);
        wp::assign_inplace(var_4, var_281, var_280);
        // value_[41] = part_40[1]                                                                <L 58>
        var_283 = wp::extract(var_278, var_282);
        wp::assign_inplace(var_4, var_284, var_283);
        // value_[42] = part_40[2]                                                                <L 59>
        var_286 = wp::extract(var_278, var_285);
        wp::assign_inplace(var_4, var_287, var_286);
        // value_[43] = part_40[3]                                                                <L 60>
        var_289 = wp::extract(var_278, var_288);
        wp::assign_inplace(var_4, var_290, var_289);
        // part_44 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[44], value_[45]), preserve_type=True)), 0)       <L 61>
        var_292 = wp::extract(var_4, var_291);
        var_294 = wp::extract(var_4, var_293);
        var_295 = wp::vec_t<2, wp::float64>(var_292, var_294);
        var_297 = wp::tile<wp::vec_t<2, wp::float64>>(var_295);
        var_298 = wp::tile_sum(var_297);
        var_300 = wp::tile_extract(var_298, var_299);
        // value_[44] = part_44[0]                                                                <L 62>
        var_302 = wp::extract(var_300, var_301);
        wp::assign_inplace(var_4, var_303, var_302);
        // value_[45] = part_44[1]                                                                <L 63>
        var_305 = wp::extract(var_300, var_304);
        wp::assign_inplace(var_4, var_306, var_305);
        // if i_ % 256 == 0:                                                                      <L 64>
        var_308 = wp::mod(var_0, var_307);
        var_310 = (var_308 == var_309);
        if (var_310) {
            // partials_[i_ // 256] = value_                                                      <L 65>
            var_312 = wp::floordiv(var_0, var_311);
            wp::array_store(var_partials_, var_312, var_4);
        }
}



extern "C" __global__ void sum_deviating_fold_tiles_cd84353c_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_count_,
    wp::array_t<wp::vec_t<2, wp::float64>> var_partials_,
    wp::array_t<wp::vec_t<2, wp::float64>> var_out_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<2, wp::float64> var_1;
        const wp::int32 var_2 = 256;
        wp::range_t var_3;
        wp::int32 var_4;
        wp::vec_t<2, wp::float64>* var_5;
        wp::vec_t<2, wp::float64> var_6;
        wp::vec_t<2, wp::float64> var_7;
        const wp::int32 var_8 = 0;
        wp::float64 var_9;
        const wp::int32 var_10 = 1;
        wp::float64 var_11;
        wp::vec_t<2, wp::float64> var_12;
        const bool var_13 = true;
        wp::tile_register_t<wp::vec_t<2, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_14 = wp::tile_register_t<wp::vec_t<2, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<2, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_15 = wp::tile_alloc_empty<wp::vec_t<2, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_16 = 0;
        wp::vec_t<2, wp::float64> var_17;
        const wp::int32 var_18 = 0;
        wp::float64 var_19;
        const wp::int32 var_20 = 0;
        const wp::int32 var_21 = 1;
        wp::float64 var_22;
        const wp::int32 var_23 = 1;
        const wp::int32 var_24 = 0;
        bool var_25;
        const wp::int32 var_26 = 0;
        //---------
        // forward
        // def sum_deviating_fold_tiles(count_, partials_, out_):                                 <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // value_ = vector_()                                                                     <L 3>
        var_1 = wp::vec_t<2, wp::float64>();
        // for j_ in range(i_, count_, 256):                                                      <L 4>
        var_3 = wp::range(var_0, var_count_, var_2);
        start_for_0:;
            if (iter_cmp(var_3) == 0) goto end_for_0;
            var_4 = wp::iter_next(var_3);
            // value_ += partials_[j_]                                                            <L 5>
            var_5 = wp::address(var_partials_, var_4);
            var_7 = wp::load(var_5);
            var_6 = wp::add(var_1, var_7);
            wp::assign(var_1, var_6);
            goto start_for_0;
        end_for_0:;
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1]), preserve_type=True)), 0)       <L 6>
        var_9 = wp::extract(var_1, var_8);
        var_11 = wp::extract(var_1, var_10);
        var_12 = wp::vec_t<2, wp::float64>(var_9, var_11);
        var_14 = wp::tile<wp::vec_t<2, wp::float64>>(var_12);
        var_15 = wp::tile_sum(var_14);
        var_17 = wp::tile_extract(var_15, var_16);
        // value_[0] = part_0[0]                                                                  <L 7>
        var_19 = wp::extract(var_17, var_18);
        wp::assign_inplace(var_1, var_20, var_19);
        // value_[1] = part_0[1]                                                                  <L 8>
        var_22 = wp::extract(var_17, var_21);
        wp::assign_inplace(var_1, var_23, var_22);
        // if i_ == 0:                                                                            <L 9>
        var_25 = (var_0 == var_24);
        if (var_25) {
            // out_[0] = value_                                                                   <L 10>
            wp::array_store(var_out_, var_26, var_1);
        }
}



extern "C" __global__ void sum_relief_fold_tiles_e4b8cf6d_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_count_,
    wp::array_t<wp::vec_t<4, wp::float64>> var_partials_,
    wp::array_t<wp::vec_t<4, wp::float64>> var_out_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<4, wp::float64> var_1;
        const wp::int32 var_2 = 256;
        wp::range_t var_3;
        wp::int32 var_4;
        wp::vec_t<4, wp::float64>* var_5;
        wp::vec_t<4, wp::float64> var_6;
        wp::vec_t<4, wp::float64> var_7;
        const wp::int32 var_8 = 0;
        wp::float64 var_9;
        const wp::int32 var_10 = 1;
        wp::float64 var_11;
        const wp::int32 var_12 = 2;
        wp::float64 var_13;
        const wp::int32 var_14 = 3;
        wp::float64 var_15;
        wp::vec_t<4, wp::float64> var_16;
        const bool var_17 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_18 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_19 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_20 = 0;
        wp::vec_t<4, wp::float64> var_21;
        const wp::int32 var_22 = 0;
        wp::float64 var_23;
        const wp::int32 var_24 = 0;
        const wp::int32 var_25 = 1;
        wp::float64 var_26;
        const wp::int32 var_27 = 1;
        const wp::int32 var_28 = 2;
        wp::float64 var_29;
        const wp::int32 var_30 = 2;
        const wp::int32 var_31 = 3;
        wp::float64 var_32;
        const wp::int32 var_33 = 3;
        const wp::int32 var_34 = 0;
        bool var_35;
        const wp::int32 var_36 = 0;
        //---------
        // forward
        // def sum_relief_fold_tiles(count_, partials_, out_):                                    <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // value_ = vector_()                                                                     <L 3>
        var_1 = wp::vec_t<4, wp::float64>();
        // for j_ in range(i_, count_, 256):                                                      <L 4>
        var_3 = wp::range(var_0, var_count_, var_2);
        start_for_0:;
            if (iter_cmp(var_3) == 0) goto end_for_0;
            var_4 = wp::iter_next(var_3);
            // value_ += partials_[j_]                                                            <L 5>
            var_5 = wp::address(var_partials_, var_4);
            var_7 = wp::load(var_5);
            var_6 = wp::add(var_1, var_7);
            wp::assign(var_1, var_6);
            goto start_for_0;
        end_for_0:;
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 6>
        var_9 = wp::extract(var_1, var_8);
        var_11 = wp::extract(var_1, var_10);
        var_13 = wp::extract(var_1, var_12);
        var_15 = wp::extract(var_1, var_14);
        var_16 = wp::vec_t<4, wp::float64>(var_9, var_11, var_13, var_15);
        var_18 = wp::tile<wp::vec_t<4, wp::float64>>(var_16);
        var_19 = wp::tile_sum(var_18);
        var_21 = wp::tile_extract(var_19, var_20);
        // value_[0] = part_0[0]                                                                  <L 7>
        var_23 = wp::extract(var_21, var_22);
        wp::assign_inplace(var_1, var_24, var_23);
        // value_[1] = part_0[1]                                                                  <L 8>
        var_26 = wp::extract(var_21, var_25);
        wp::assign_inplace(var_1, var_27, var_26);
        // value_[2] = part_0[2]                                                                  <L 9>
        var_29 = wp::extract(var_21, var_28);
        wp::assign_inplace(var_1, var_30, var_29);
        // value_[3] = part_0[3]                                                                  <L 10>
        var_32 = wp::extract(var_21, var_31);
        wp::assign_inplace(var_1, var_33, var_32);
        // if i_ == 0:                                                                            <L 11>
        var_35 = (var_0 == var_34);
        if (var_35) {
            // out_[0] = value_                                                                   <L 12>
            wp::array_store(var_out_, var_36, var_1);
        }
}



extern "C" __global__ void sum_near_tiles_e697f94b_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_moved,
    wp::array_t<wp::int64> var_nearest,
    wp::int32 var_count_,
    wp::array_t<wp::vec_t<5, wp::float64>> var_partials_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<5, wp::float64> var_1;
        bool var_2;
        wp::vec_t<5, wp::float64> var_3;
        wp::vec_t<5, wp::float64> var_4;
        const wp::int32 var_5 = 0;
        wp::float64 var_6;
        const wp::int32 var_7 = 1;
        wp::float64 var_8;
        const wp::int32 var_9 = 2;
        wp::float64 var_10;
        const wp::int32 var_11 = 3;
        wp::float64 var_12;
        wp::vec_t<4, wp::float64> var_13;
        const bool var_14 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_15 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_16 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_17 = 0;
        wp::vec_t<4, wp::float64> var_18;
        const wp::int32 var_19 = 0;
        wp::float64 var_20;
        const wp::int32 var_21 = 0;
        const wp::int32 var_22 = 1;
        wp::float64 var_23;
        const wp::int32 var_24 = 1;
        const wp::int32 var_25 = 2;
        wp::float64 var_26;
        const wp::int32 var_27 = 2;
        const wp::int32 var_28 = 3;
        wp::float64 var_29;
        const wp::int32 var_30 = 3;
        const wp::int32 var_31 = 4;
        wp::float64 var_32;
        wp::tile_register_t<wp::float64,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_33 = wp::tile_register_t<wp::float64,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::float64,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_34 = wp::tile_alloc_empty<wp::float64,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_35 = 0;
        wp::float64 var_36;
        const wp::int32 var_37 = 4;
        const wp::int32 var_38 = 256;
        wp::int32 var_39;
        const wp::int32 var_40 = 0;
        bool var_41;
        const wp::int32 var_42 = 256;
        wp::int32 var_43;
        //---------
        // forward
        // def sum_near_tiles(moved, nearest, count_, partials_):                                 <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // value_ = vector_()                                                                     <L 3>
        var_1 = wp::vec_t<5, wp::float64>();
        // if i_ < count_:                                                                        <L 4>
        var_2 = (var_0 < var_count_);
        if (var_2) {
            // value_ = element_(moved, nearest, i_)                                              <L 5>
            var_3 = sum_near_element_0(var_moved, var_nearest, var_0);
        }
        var_4 = wp::where(var_2, var_3, var_1);
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 6>
        var_6 = wp::extract(var_4, var_5);
        var_8 = wp::extract(var_4, var_7);
        var_10 = wp::extract(var_4, var_9);
        var_12 = wp::extract(var_4, var_11);
        var_13 = wp::vec_t<4, wp::float64>(var_6, var_8, var_10, var_12);
        var_15 = wp::tile<wp::vec_t<4, wp::float64>>(var_13);
        var_16 = wp::tile_sum(var_15);
        var_18 = wp::tile_extract(var_16, var_17);
        // value_[0] = part_0[0]                                                                  <L 7>
        var_20 = wp::extract(var_18, var_19);
        wp::assign_inplace(var_4, var_21, var_20);
        // value_[1] = part_0[1]                                                                  <L 8>
        var_23 = wp::extract(var_18, var_22);
        wp::assign_inplace(var_4, var_24, var_23);
        // value_[2] = part_0[2]                                                                  <L 9>
        var_26 = wp::extract(var_18, var_25);
        wp::assign_inplace(var_4, var_27, var_26);
        // value_[3] = part_0[3]                                                                  <L 10>
        var_29 = wp::extract(var_18, var_28);
        wp::assign_inplace(var_4, var_30, var_29);
        // value_[4] = wp.tile_extract(wp.tile_sum(wp.tile(value_[4])), 0)                        <L 11>
        var_32 = wp::extract(var_4, var_31);
        var_33 = wp::tile<wp::float64>(var_32);
        var_34 = wp::tile_sum(var_33);
        var_36 = wp::tile_extract(var_34, var_35);
        wp::assign_inplace(var_4, var_37, var_36);
        // if i_ % 256 == 0:                                                                      <L 12>
        var_39 = wp::mod(var_0, var_38);
        var_41 = (var_39 == var_40);
        if (var_41) {
            // partials_[i_ // 256] = value_                                                      <L 13>
            var_43 = wp::floordiv(var_0, var_42);
            wp::array_store(var_partials_, var_43, var_4);
        }
}


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


// /work/main/src/pointloom/kernels/language/warp_compiler.py:174
static CUDA_CALLABLE wp::int32 _shuffle_xor_0(
    wp::int32 x,
    wp::int32 mask)
{
return __shfl_xor_sync(0xffffffffu, x, mask);}


// <pointloom.kernels.volumes.device_frames.greatest_of_lanes>:1
static CUDA_CALLABLE wp::int32 greatest_of_lanes_on_cuda_0(
    wp::int32 var_i,
    wp::array_t<wp::int32> var_values)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 32;
    wp::int32 var_3;
    wp::shape_t* var_4;
    const wp::int32 var_5 = 0;
    wp::int32 var_6;
    wp::shape_t var_7;
    bool var_8;
    wp::int32* var_9;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    const wp::int32 var_13 = 0;
    const wp::int32 var_14 = 1;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::int32 var_17;
    const wp::int32 var_18 = 1;
    const wp::int32 var_19 = 1;
    wp::int32 var_20;
    wp::int32 var_21;
    wp::int32 var_22;
    const wp::int32 var_23 = 2;
    const wp::int32 var_24 = 1;
    wp::int32 var_25;
    wp::int32 var_26;
    wp::int32 var_27;
    const wp::int32 var_28 = 3;
    const wp::int32 var_29 = 1;
    wp::int32 var_30;
    wp::int32 var_31;
    wp::int32 var_32;
    const wp::int32 var_33 = 4;
    const wp::int32 var_34 = 1;
    wp::int32 var_35;
    wp::int32 var_36;
    wp::int32 var_37;
    //---------
    // forward
    // def greatest_of_lanes(i, values):                                                      <L 1>
    // maximum = int(0)                                                                       <L 3>
    var_1 = wp::int(var_0);
    // k = i % WARP                                                                           <L 4>
    var_3 = wp::mod(var_i, var_2);
    // while k < values.shape[0]:                                                             <L 5>
    start_while_0:;
    var_4 = &(var_values.shape);
    var_7 = wp::load(var_4);
    var_6 = wp::extract(var_7, var_5);
    var_8 = (var_3 < var_6);
    if ((var_8) == false) goto end_while_0;
        // maximum = max(maximum, values[k])                                                  <L 6>
        var_9 = wp::address(var_values, var_3);
        var_11 = wp::load(var_9);
        var_10 = wp::max(var_1, var_11);
        // k += WARP                                                                          <L 7>
        var_12 = wp::add(var_3, var_2);
        wp::assign(var_1, var_10);
        wp::assign(var_3, var_12);
    goto start_while_0;
    end_while_0:;
    // for bit in range(LANE_BITS):                                                           <L 8>
    // maximum = max(maximum, shuffle_xor(maximum, 1 << bit))                                 <L 9>
    var_15 = wp::lshift(var_14, var_13);
    var_16 = _shuffle_xor_0(var_1, var_15);
    var_17 = wp::max(var_1, var_16);
    var_20 = wp::lshift(var_19, var_18);
    var_21 = _shuffle_xor_0(var_17, var_20);
    var_22 = wp::max(var_17, var_21);
    var_25 = wp::lshift(var_24, var_23);
    var_26 = _shuffle_xor_0(var_22, var_25);
    var_27 = wp::max(var_22, var_26);
    var_30 = wp::lshift(var_29, var_28);
    var_31 = _shuffle_xor_0(var_27, var_30);
    var_32 = wp::max(var_27, var_31);
    var_35 = wp::lshift(var_34, var_33);
    var_36 = _shuffle_xor_0(var_32, var_35);
    var_37 = wp::max(var_32, var_36);
    // return maximum                                                                         <L 10>
    return var_37;
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


// <pointloom.kernels.volumes.device_frames.stride_of>:1
static CUDA_CALLABLE wp::int32 stride_of_0(
    wp::int32 var_largest,
    wp::float64 var_camera__fx,
    wp::float64 var_camera__fy,
    wp::float64 var_block_size)
{
    //---------
    // primal vars
    wp::float32 var_0;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    const wp::int32 var_4 = 4;
    wp::int32 var_5;
    wp::float64 var_6;
    bool var_7;
    wp::float64 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    //---------
    // forward
    // def stride_of(largest, camera__fx, camera__fy, block_size):                            <L 1>
    // spacing = float64(bits_float(largest)) / min(camera__fx, camera__fy)                   <L 2>
    var_0 = _bits_float_0(var_largest);
    var_1 = wp::float64(var_0);
    var_2 = wp::min(var_camera__fx, var_camera__fy);
    var_3 = wp::div(var_1, var_2);
    // stride = int(MAX_STRIDE)                                                               <L 3>
    var_5 = wp::int(var_4);
    // if spacing > float64(0.0):                                                             <L 4>
    var_6 = 0.0;
    var_7 = (var_3 > var_6);
    if (var_7) {
        // stride = int(min(max(block_size / float64(2.0) / spacing, float64(1.0)), float64(LONGEST_STRIDE)))       <L 5>
        var_8 = 2.0;
        var_9 = wp::div(var_block_size, var_8);
        var_10 = wp::div(var_9, var_3);
        var_11 = 1.0;
        var_12 = wp::max(var_10, var_11);
        var_13 = 4.0;
        var_14 = wp::min(var_12, var_13);
        var_15 = wp::int(var_14);
    }
    var_16 = wp::where(var_7, var_15, var_5);
    // return stride                                                                          <L 6>
    return var_16;
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


// <pointloom.kernels.algebra.camera.pixel_ray>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float64> pixel_ray_0(
    wp::float64 var_u,
    wp::float64 var_v,
    wp::float64 var_camera__fx,
    wp::float64 var_camera__fy,
    wp::float64 var_camera__cx,
    wp::float64 var_camera__cy)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    wp::float64 var_4;
    wp::vec_t<3, wp::float64> var_5;
    //---------
    // forward
    // def pixel_ray(u, v, camera__fx, camera__fy, camera__cx, camera__cy):                   <L 1>
    // return vec3d((u - camera__cx) / camera__fx, (v - camera__cy) / camera__fy, float64(1.0))       <L 3>
    var_0 = wp::sub(var_u, var_camera__cx);
    var_1 = wp::div(var_0, var_camera__fx);
    var_2 = wp::sub(var_v, var_camera__cy);
    var_3 = wp::div(var_2, var_camera__fy);
    var_4 = 1.0;
    var_5 = wp::vec_t<3, wp::float64>(var_1, var_3, var_4);
    return var_5;
}


// <pointloom.kernels.volumes.tsdf_blocks.step_along>:1
static CUDA_CALLABLE wp::int32 step_along_0(
    wp::float64 var_d)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    wp::float64 var_2;
    bool var_3;
    const wp::int32 var_4 = 1;
    wp::int32 var_5;
    wp::float64 var_6;
    bool var_7;
    const wp::int32 var_8 = -1;
    wp::int32 var_9;
    //---------
    // forward
    // def step_along(d):                                                                     <L 1>
    // s = int(0)                                                                             <L 2>
    var_1 = wp::int(var_0);
    // if d > float64(0.0):                                                                   <L 3>
    var_2 = 0.0;
    var_3 = (var_d > var_2);
    if (var_3) {
        // s = 1                                                                              <L 4>
    }
    var_5 = wp::where(var_3, var_4, var_1);
    // if d < float64(0.0):                                                                   <L 5>
    var_6 = 0.0;
    var_7 = (var_d < var_6);
    if (var_7) {
        // s = -1                                                                             <L 6>
    }
    var_9 = wp::where(var_7, var_8, var_5);
    // return s                                                                               <L 7>
    return var_9;
}


// <pointloom.kernels.volumes.tsdf_blocks.crossing_length>:1
static CUDA_CALLABLE wp::float64 crossing_length_0(
    wp::float64 var_d)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    bool var_2;
    wp::float64 var_3;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    //---------
    // forward
    // def crossing_length(d):                                                                <L 1>
    // t = float64(NO_CROSSING)                                                               <L 2>
    var_0 = 1e+30;
    // if d != float64(0.0):                                                                  <L 3>
    var_1 = 0.0;
    var_2 = (var_d != var_1);
    if (var_2) {
        // t = float64(1.0) / abs(d)                                                          <L 4>
        var_3 = 1.0;
        var_4 = wp::abs(var_d);
        var_5 = wp::div(var_3, var_4);
    }
    var_6 = wp::where(var_2, var_5, var_0);
    // return t                                                                               <L 5>
    return var_6;
}


// <pointloom.kernels.volumes.tsdf_blocks.first_crossing>:1
static CUDA_CALLABLE wp::float64 first_crossing_0(
    wp::float64 var_start,
    wp::int32 var_step,
    wp::float64 var_delta)
{
    //---------
    // primal vars
    wp::float64 var_0;
    const wp::int32 var_1 = 0;
    bool var_2;
    wp::float64 var_3;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    const wp::int32 var_9 = 0;
    bool var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    //---------
    // forward
    // def first_crossing(start, step, delta):                                                <L 1>
    // t = float64(NO_CROSSING)                                                               <L 2>
    var_0 = 1e+30;
    // if step > 0:                                                                           <L 3>
    var_2 = (var_step > var_1);
    if (var_2) {
        // t = (floor(start) + float64(1.0) - start) * delta                                  <L 4>
        var_3 = wp::floor(var_start);
        var_4 = 1.0;
        var_5 = wp::add(var_3, var_4);
        var_6 = wp::sub(var_5, var_start);
        var_7 = wp::mul(var_6, var_delta);
    }
    var_8 = wp::where(var_2, var_7, var_0);
    // if step < 0:                                                                           <L 5>
    var_10 = (var_step < var_9);
    if (var_10) {
        // t = (start - floor(start)) * delta                                                 <L 6>
        var_11 = wp::floor(var_start);
        var_12 = wp::sub(var_start, var_11);
        var_13 = wp::mul(var_12, var_delta);
    }
    var_14 = wp::where(var_10, var_13, var_8);
    // return t                                                                               <L 7>
    return var_14;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:174
static CUDA_CALLABLE void adj__shuffle_xor_0(
    wp::int32 x,
    wp::int32 mask,
    wp::int32 & adj_x,
    wp::int32 & adj_mask,
    wp::int32 & adj_ret)
{
}


// <pointloom.kernels.volumes.device_frames.greatest_of_lanes>:1
static CUDA_CALLABLE void adj_greatest_of_lanes_on_cuda_0(
    wp::int32 var_i,
    wp::array_t<wp::int32> var_values,
    wp::int32 & adj_i,
    wp::array_t<wp::int32> & adj_values,
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


// <pointloom.kernels.volumes.device_frames.stride_of>:1
static CUDA_CALLABLE void adj_stride_of_0(
    wp::int32 var_largest,
    wp::float64 var_camera__fx,
    wp::float64 var_camera__fy,
    wp::float64 var_block_size,
    wp::int32 & adj_largest,
    wp::float64 & adj_camera__fx,
    wp::float64 & adj_camera__fy,
    wp::float64 & adj_block_size,
    wp::int32 & adj_ret)
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


// <pointloom.kernels.algebra.camera.pixel_ray>:1
static CUDA_CALLABLE void adj_pixel_ray_0(
    wp::float64 var_u,
    wp::float64 var_v,
    wp::float64 var_camera__fx,
    wp::float64 var_camera__fy,
    wp::float64 var_camera__cx,
    wp::float64 var_camera__cy,
    wp::float64 & adj_u,
    wp::float64 & adj_v,
    wp::float64 & adj_camera__fx,
    wp::float64 & adj_camera__fy,
    wp::float64 & adj_camera__cx,
    wp::float64 & adj_camera__cy,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.tsdf_blocks.step_along>:1
static CUDA_CALLABLE void adj_step_along_0(
    wp::float64 var_d,
    wp::float64 & adj_d,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.tsdf_blocks.crossing_length>:1
static CUDA_CALLABLE void adj_crossing_length_0(
    wp::float64 var_d,
    wp::float64 & adj_d,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.tsdf_blocks.first_crossing>:1
static CUDA_CALLABLE void adj_first_crossing_0(
    wp::float64 var_start,
    wp::int32 var_step,
    wp::float64 var_delta,
    wp::float64 & adj_start,
    wp::int32 & adj_step,
    wp::float64 & adj_delta,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void mark_touched_kernel_8b47465e_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_depth,
    wp::array_t<wp::int32> var_largest,
    wp::array_t<wp::float64> var_record,
    wp::int32 var_camera__width,
    wp::int32 var_camera__height,
    wp::float64 var_camera__fx,
    wp::float64 var_camera__fy,
    wp::float64 var_camera__cx,
    wp::float64 var_camera__cy,
    wp::float64 var_truncation,
    wp::float64 var_block_size,
    wp::int32 var_slots,
    wp::array_t<wp::uint8> var_grid)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::int32 var_1;
        wp::int32 var_2;
        wp::int32 var_3;
        const wp::int32 var_4 = 2;
        wp::int32 var_5;
        wp::int32 var_6;
        const wp::int32 var_7 = 1;
        wp::int32 var_8;
        wp::int32 var_9;
        const wp::int32 var_10 = 2;
        wp::int32 var_11;
        wp::int32 var_12;
        const wp::int32 var_13 = 1;
        wp::int32 var_14;
        wp::int32 var_15;
        bool var_16;
        wp::int32 var_17;
        wp::int32 var_18;
        const wp::int32 var_19 = 1;
        wp::int32 var_20;
        wp::int32 var_21;
        wp::int32 var_22;
        wp::int32 var_23;
        const wp::int32 var_24 = 1;
        wp::int32 var_25;
        wp::int32 var_26;
        wp::int32 var_27;
        wp::int32 var_28;
        wp::float32* var_29;
        wp::float64 var_30;
        wp::float32 var_31;
        wp::float64 var_32;
        bool var_33;
        const wp::int32 var_34 = 0;
        wp::mat_t<3, 3, wp::float64> var_35;
        wp::vec_t<3, wp::float64> var_36;
        wp::float64 var_37;
        wp::float64 var_38;
        wp::vec_t<3, wp::float64> var_39;
        wp::float64 var_40;
        wp::float64 var_41;
        wp::float64 var_42;
        wp::vec_t<3, wp::float64> var_43;
        wp::vec_t<3, wp::float64> var_44;
        wp::vec_t<3, wp::float64> var_45;
        wp::vec_t<3, wp::float64> var_46;
        wp::float64 var_47;
        wp::vec_t<3, wp::float64> var_48;
        wp::vec_t<3, wp::float64> var_49;
        wp::vec_t<3, wp::float64> var_50;
        wp::vec_t<3, wp::float64> var_51;
        const wp::int32 var_52 = 27;
        wp::float64* var_53;
        wp::int32 var_54;
        wp::float64 var_55;
        const wp::int32 var_56 = 1;
        wp::int32 var_57;
        wp::float64* var_58;
        wp::int32 var_59;
        wp::float64 var_60;
        const wp::int32 var_61 = 2;
        wp::int32 var_62;
        wp::float64* var_63;
        wp::int32 var_64;
        wp::float64 var_65;
        wp::vec_t<3, wp::float64> var_66;
        const wp::int32 var_67 = 0;
        wp::float64 var_68;
        wp::float64 var_69;
        wp::int32 var_70;
        const wp::int32 var_71 = 1;
        wp::float64 var_72;
        wp::float64 var_73;
        wp::int32 var_74;
        const wp::int32 var_75 = 2;
        wp::float64 var_76;
        wp::float64 var_77;
        wp::int32 var_78;
        const wp::int32 var_79 = 0;
        wp::float64 var_80;
        wp::int32 var_81;
        const wp::int32 var_82 = 1;
        wp::float64 var_83;
        wp::int32 var_84;
        const wp::int32 var_85 = 2;
        wp::float64 var_86;
        wp::int32 var_87;
        const wp::int32 var_88 = 0;
        wp::float64 var_89;
        wp::float64 var_90;
        const wp::int32 var_91 = 1;
        wp::float64 var_92;
        wp::float64 var_93;
        const wp::int32 var_94 = 2;
        wp::float64 var_95;
        wp::float64 var_96;
        const wp::int32 var_97 = 0;
        wp::float64 var_98;
        wp::float64 var_99;
        const wp::int32 var_100 = 1;
        wp::float64 var_101;
        wp::float64 var_102;
        const wp::int32 var_103 = 2;
        wp::float64 var_104;
        wp::float64 var_105;
        wp::range_t var_106;
        wp::int32 var_107;
        wp::int32 var_108;
        wp::int32 var_109;
        wp::int32 var_110;
        const wp::int32 var_111 = 24;
        wp::float64* var_112;
        wp::int32 var_113;
        wp::float64 var_114;
        wp::int32 var_115;
        const wp::int32 var_116 = 1;
        wp::int32 var_117;
        wp::float64* var_118;
        wp::int32 var_119;
        wp::float64 var_120;
        wp::int32 var_121;
        const wp::int32 var_122 = 2;
        wp::int32 var_123;
        wp::float64* var_124;
        wp::int32 var_125;
        wp::float64 var_126;
        wp::int32 var_127;
        bool var_128;
        const wp::int32 var_129 = 0;
        bool var_130;
        const wp::int32 var_131 = 0;
        bool var_132;
        const wp::int32 var_133 = 0;
        bool var_134;
        bool var_135;
        bool var_136;
        bool var_137;
        const wp::int32 var_138 = 1;
        wp::uint8 var_139;
        wp::int32 var_140;
        wp::int32 var_141;
        wp::int32 var_142;
        wp::int32 var_143;
        wp::float64 var_144;
        wp::float64 var_145;
        wp::float64 var_146;
        bool var_147;
        bool var_148;
        bool var_149;
        bool var_150;
        wp::int32 var_151;
        wp::float64 var_152;
        bool var_153;
        wp::int32 var_154;
        wp::float64 var_155;
        wp::int32 var_156;
        wp::float64 var_157;
        wp::int32 var_158;
        wp::int32 var_159;
        wp::float64 var_160;
        wp::float64 var_161;
        wp::int32 var_162;
        wp::int32 var_163;
        wp::int32 var_164;
        wp::float64 var_165;
        wp::float64 var_166;
        wp::float64 var_167;
        //---------
        // forward
        // def mark_touched_kernel(depth, largest, record, camera__width, camera__height, camera__fx, camera__fy, camera__cx, camera__cy, truncation, block_size, slots, grid):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // stride = stride_of(greatest_of(i, largest), camera__fx, camera__fy, block_size)        <L 4>
        var_1 = greatest_of_lanes_on_cuda_0(var_0, var_largest);
        var_2 = stride_of_0(var_1, var_camera__fx, var_camera__fy, var_block_size);
        // columns = (camera__width + stride - 2) // stride + 1                                   <L 5>
        var_3 = wp::add(var_camera__width, var_2);
        var_5 = wp::sub(var_3, var_4);
        var_6 = wp::floordiv(var_5, var_2);
        var_8 = wp::add(var_6, var_7);
        // rows = (camera__height + stride - 2) // stride + 1                                     <L 6>
        var_9 = wp::add(var_camera__height, var_2);
        var_11 = wp::sub(var_9, var_10);
        var_12 = wp::floordiv(var_11, var_2);
        var_14 = wp::add(var_12, var_13);
        // if i < columns * rows:                                                                 <L 7>
        var_15 = wp::mul(var_8, var_14);
        var_16 = (var_0 < var_15);
        if (var_16) {
            // u = min(i % columns * stride, camera__width - 1)                                   <L 8>
            var_17 = wp::mod(var_0, var_8);
            var_18 = wp::mul(var_17, var_2);
            var_20 = wp::sub(var_camera__width, var_19);
            var_21 = wp::min(var_18, var_20);
            // v = min(i // columns * stride, camera__height - 1)                                 <L 9>
            var_22 = wp::floordiv(var_0, var_8);
            var_23 = wp::mul(var_22, var_2);
            var_25 = wp::sub(var_camera__height, var_24);
            var_26 = wp::min(var_23, var_25);
            // d = float64(depth[v * camera__width + u])                                          <L 10>
            var_27 = wp::mul(var_26, var_camera__width);
            var_28 = wp::add(var_27, var_21);
            var_29 = wp::address(var_depth, var_28);
            var_31 = wp::load(var_29);
            var_30 = wp::float64(var_31);
            // if d > float64(0.0):                                                               <L 11>
            var_32 = 0.0;
            var_33 = (var_30 > var_32);
            if (var_33) {
                // R = recorded_rotation(record, INTO_VOLUME)                                     <L 12>
                var_35 = recorded_rotation_0(var_record, var_34);
                // t = recorded_translation(record, INTO_VOLUME)                                  <L 13>
                var_36 = recorded_translation_0(var_record, var_34);
                // ray = pixel_ray(float64(u), float64(v), camera__fx, camera__fy, camera__cx, camera__cy)       <L 14>
                var_37 = wp::float64(var_21);
                var_38 = wp::float64(var_26);
                var_39 = pixel_ray_0(var_37, var_38, var_camera__fx, var_camera__fy, var_camera__cx, var_camera__cy);
                // a = (R @ (ray * max(d - truncation, float64(0.0))) + t) / block_size           <L 15>
                var_40 = wp::sub(var_30, var_truncation);
                var_41 = 0.0;
                var_42 = wp::max(var_40, var_41);
                var_43 = wp::mul(var_39, var_42);
                var_44 = wp::mul(var_35, var_43);
                var_45 = wp::add(var_44, var_36);
                var_46 = wp::div(var_45, var_block_size);
                // b = (R @ (ray * (d + truncation)) + t) / block_size                            <L 16>
                var_47 = wp::add(var_30, var_truncation);
                var_48 = wp::mul(var_39, var_47);
                var_49 = wp::mul(var_35, var_48);
                var_50 = wp::add(var_49, var_36);
                var_51 = wp::div(var_50, var_block_size);
                // nx = int(record[SIZE])                                                         <L 17>
                var_53 = wp::address(var_record, var_52);
                var_55 = wp::load(var_53);
                var_54 = wp::int(var_55);
                // ny = int(record[SIZE + 1])                                                     <L 18>
                var_57 = wp::add(var_52, var_56);
                var_58 = wp::address(var_record, var_57);
                var_60 = wp::load(var_58);
                var_59 = wp::int(var_60);
                // nz = int(record[SIZE + 2])                                                     <L 19>
                var_62 = wp::add(var_52, var_61);
                var_63 = wp::address(var_record, var_62);
                var_65 = wp::load(var_63);
                var_64 = wp::int(var_65);
                // along__blocks_on_segment__1 = b - a                                            <L 20>
                var_66 = wp::sub(var_51, var_46);
                // x__blocks_on_segment__1 = int(floor(a[0]))                                     <L 21>
                var_68 = wp::extract(var_46, var_67);
                var_69 = wp::floor(var_68);
                var_70 = wp::int(var_69);
                // y__blocks_on_segment__1 = int(floor(a[1]))                                     <L 22>
                var_72 = wp::extract(var_46, var_71);
                var_73 = wp::floor(var_72);
                var_74 = wp::int(var_73);
                // z__blocks_on_segment__1 = int(floor(a[2]))                                     <L 23>
                var_76 = wp::extract(var_46, var_75);
                var_77 = wp::floor(var_76);
                var_78 = wp::int(var_77);
                // sx__blocks_on_segment__1 = step_along__blocks_on_segment(along__blocks_on_segment__1[0])       <L 24>
                var_80 = wp::extract(var_66, var_79);
                var_81 = step_along_0(var_80);
                // sy__blocks_on_segment__1 = step_along__blocks_on_segment(along__blocks_on_segment__1[1])       <L 25>
                var_83 = wp::extract(var_66, var_82);
                var_84 = step_along_0(var_83);
                // sz__blocks_on_segment__1 = step_along__blocks_on_segment(along__blocks_on_segment__1[2])       <L 26>
                var_86 = wp::extract(var_66, var_85);
                var_87 = step_along_0(var_86);
                // dx__blocks_on_segment__1 = crossing_length__blocks_on_segment(along__blocks_on_segment__1[0])       <L 27>
                var_89 = wp::extract(var_66, var_88);
                var_90 = crossing_length_0(var_89);
                // dy__blocks_on_segment__1 = crossing_length__blocks_on_segment(along__blocks_on_segment__1[1])       <L 28>
                var_92 = wp::extract(var_66, var_91);
                var_93 = crossing_length_0(var_92);
                // dz__blocks_on_segment__1 = crossing_length__blocks_on_segment(along__blocks_on_segment__1[2])       <L 29>
                var_95 = wp::extract(var_66, var_94);
                var_96 = crossing_length_0(var_95);
                // tx__blocks_on_segment__1 = first_crossing__blocks_on_segment(a[0], sx__blocks_on_segment__1, dx__blocks_on_segment__1)       <L 30>
                var_98 = wp::extract(var_46, var_97);
                var_99 = first_crossing_0(var_98, var_81, var_90);
                // ty__blocks_on_segment__1 = first_crossing__blocks_on_segment(a[1], sy__blocks_on_segment__1, dy__blocks_on_segment__1)       <L 31>
                var_101 = wp::extract(var_46, var_100);
                var_102 = first_crossing_0(var_101, var_84, var_93);
                // tz__blocks_on_segment__1 = first_crossing__blocks_on_segment(a[2], sz__blocks_on_segment__1, dz__blocks_on_segment__1)       <L 32>
                var_104 = wp::extract(var_46, var_103);
                var_105 = first_crossing_0(var_104, var_87, var_96);
                // for _slot in range(slots):                                                     <L 33>
                var_106 = wp::range(var_slots);
                start_for_0:;
                    if (iter_cmp(var_106) == 0) goto end_for_0;
                    var_107 = wp::iter_next(var_106);
                    // x = x__blocks_on_segment__1                                                <L 34>
                    var_108 = wp::copy(var_70);
                    // y = y__blocks_on_segment__1                                                <L 35>
                    var_109 = wp::copy(var_74);
                    // z = z__blocks_on_segment__1                                                <L 36>
                    var_110 = wp::copy(var_78);
                    // cx = x - int(record[LOW])                                                  <L 37>
                    var_112 = wp::address(var_record, var_111);
                    var_114 = wp::load(var_112);
                    var_113 = wp::int(var_114);
                    var_115 = wp::sub(var_108, var_113);
                    // cy = y - int(record[LOW + 1])                                              <L 38>
                    var_117 = wp::add(var_111, var_116);
                    var_118 = wp::address(var_record, var_117);
                    var_120 = wp::load(var_118);
                    var_119 = wp::int(var_120);
                    var_121 = wp::sub(var_109, var_119);
                    // cz = z - int(record[LOW + 2])                                              <L 39>
                    var_123 = wp::add(var_111, var_122);
                    var_124 = wp::address(var_record, var_123);
                    var_126 = wp::load(var_124);
                    var_125 = wp::int(var_126);
                    var_127 = wp::sub(var_110, var_125);
                    // if cx >= 0 and cy >= 0 and (cz >= 0) and (cx < nx) and (cy < ny) and (cz < nz):       <L 40>
                    var_130 = (var_115 >= var_129);
                    var_128 = var_130;
                    if (var_128) {
                        var_132 = (var_121 >= var_131);
                        var_128 = var_128 && var_132;
                    }
                    if (var_128) {
                        var_134 = (var_127 >= var_133);
                        var_128 = var_128 && var_134;
                    }
                    if (var_128) {
                        var_135 = (var_115 < var_54);
                        var_128 = var_128 && var_135;
                    }
                    if (var_128) {
                        var_136 = (var_121 < var_59);
                        var_128 = var_128 && var_136;
                    }
                    if (var_128) {
                        var_137 = (var_127 < var_64);
                        var_128 = var_128 && var_137;
                    }
                    if (var_128) {
                        // grid[(cx * ny + cy) * nz + cz] = uint8(MARKED)                         <L 41>
                        var_139 = wp::uint8(var_138);
                        var_140 = wp::mul(var_115, var_59);
                        var_141 = wp::add(var_140, var_121);
                        var_142 = wp::mul(var_141, var_64);
                        var_143 = wp::add(var_142, var_127);
                        wp::array_store(var_grid, var_143, var_139);
                    }
                    // if min(tx__blocks_on_segment__1, min(ty__blocks_on_segment__1, tz__blocks_on_segment__1)) > float64(1.0):       <L 42>
                    var_144 = wp::min(var_102, var_105);
                    var_145 = wp::min(var_99, var_144);
                    var_146 = 1.0;
                    var_147 = (var_145 > var_146);
                    if (var_147) {
                        // break                                                                  <L 43>
                        goto end_for_0;
                    }
                    // if tx__blocks_on_segment__1 <= ty__blocks_on_segment__1 and tx__blocks_on_segment__1 <= tz__blocks_on_segment__1:       <L 44>
                    var_149 = (var_99 <= var_102);
                    var_148 = var_149;
                    if (var_148) {
                        var_150 = (var_99 <= var_105);
                        var_148 = var_148 && var_150;
                    }
                    if (var_148) {
                        // x__blocks_on_segment__1 += sx__blocks_on_segment__1                    <L 45>
                        var_151 = wp::add(var_70, var_81);
                        // tx__blocks_on_segment__1 += dx__blocks_on_segment__1                   <L 46>
                        var_152 = wp::add(var_99, var_90);
                    }
                    if (!var_148) {
                        // elif ty__blocks_on_segment__1 <= tz__blocks_on_segment__1:             <L 47>
                        var_153 = (var_102 <= var_105);
                        if (var_153) {
                            // y__blocks_on_segment__1 += sy__blocks_on_segment__1                <L 48>
                            var_154 = wp::add(var_74, var_84);
                            // ty__blocks_on_segment__1 += dy__blocks_on_segment__1               <L 49>
                            var_155 = wp::add(var_102, var_93);
                        }
                        if (!var_153) {
                            // z__blocks_on_segment__1 += sz__blocks_on_segment__1                <L 51>
                            var_156 = wp::add(var_78, var_87);
                            // tz__blocks_on_segment__1 += dz__blocks_on_segment__1               <L 52>
                            var_157 = wp::add(var_105, var_96);
                        }
                        var_158 = wp::where(var_153, var_154, var_74);
                        var_159 = wp::where(var_153, var_78, var_156);
                        var_160 = wp::where(var_153, var_155, var_102);
                        var_161 = wp::where(var_153, var_105, var_157);
                    }
                    var_162 = wp::where(var_148, var_151, var_70);
                    var_163 = wp::where(var_148, var_74, var_158);
                    var_164 = wp::where(var_148, var_78, var_159);
                    var_165 = wp::where(var_148, var_152, var_99);
                    var_166 = wp::where(var_148, var_102, var_160);
                    var_167 = wp::where(var_148, var_105, var_161);
                    wp::assign(var_70, var_162);
                    wp::assign(var_74, var_163);
                    wp::assign(var_78, var_164);
                    wp::assign(var_99, var_165);
                    wp::assign(var_102, var_166);
                    wp::assign(var_105, var_167);
                    goto start_for_0;
                end_for_0:;
            }
        }
}


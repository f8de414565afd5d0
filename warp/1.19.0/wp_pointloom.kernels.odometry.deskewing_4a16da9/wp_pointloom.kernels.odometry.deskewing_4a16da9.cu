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


// <pointloom.kernels.odometry.deskewing.move_along_screw>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float32> move_along_screw_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::float32 var_share,
    wp::vec_t<3, wp::float32> var_motion__axis,
    wp::float32 var_motion__angle,
    wp::vec_t<3, wp::float32> var_motion__velocity)
{
    //---------
    // primal vars
    wp::float32 var_0;
    wp::float32 var_1;
    const wp::float32 var_2 = 0.5;
    wp::float32 var_3;
    wp::float32 var_4;
    const wp::float32 var_5 = 2.0;
    wp::float32 var_6;
    wp::float32 var_7;
    const wp::float32 var_8 = 0.0;
    wp::float32 var_9;
    const wp::float32 var_10 = 0.0;
    wp::float32 var_11;
    wp::float32 var_12;
    const wp::float32 var_13 = 1e-12;
    bool var_14;
    wp::float32 var_15;
    const wp::float32 var_16 = 1.0;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    wp::float32 var_20;
    wp::vec_t<3, wp::float32> var_21;
    wp::vec_t<3, wp::float32> var_22;
    wp::vec_t<3, wp::float32> var_23;
    wp::vec_t<3, wp::float32> var_24;
    wp::vec_t<3, wp::float32> var_25;
    wp::vec_t<3, wp::float32> var_26;
    wp::vec_t<3, wp::float32> var_27;
    wp::vec_t<3, wp::float32> var_28;
    wp::vec_t<3, wp::float32> var_29;
    wp::vec_t<3, wp::float32> var_30;
    wp::vec_t<3, wp::float32> var_31;
    wp::vec_t<3, wp::float32> var_32;
    wp::vec_t<3, wp::float32> var_33;
    wp::vec_t<3, wp::float32> var_34;
    //---------
    // forward
    // def move_along_screw(p, share, motion__axis, motion__angle, motion__velocity):         <L 1>
    // a = share * motion__angle                                                              <L 3>
    var_0 = wp::mul(var_share, var_motion__angle);
    // sine = sin(a)                                                                          <L 4>
    var_1 = wp::sin(var_0);
    // half = sin(0.5 * a)                                                                    <L 5>
    var_3 = wp::mul(var_2, var_0);
    var_4 = wp::sin(var_3);
    // versine = 2.0 * half * half                                                            <L 6>
    var_6 = wp::mul(var_5, var_4);
    var_7 = wp::mul(var_6, var_4);
    // first = float(0.0)                                                                     <L 7>
    var_9 = wp::float(var_8);
    // second = float(0.0)                                                                    <L 8>
    var_11 = wp::float(var_10);
    // if abs(a) > TINY_ANGLE:                                                                <L 9>
    var_12 = wp::abs(var_0);
    var_14 = (var_12 > var_13);
    if (var_14) {
        // first = versine / a                                                                <L 10>
        var_15 = wp::div(var_7, var_0);
        // second = 1.0 - sine / a                                                            <L 11>
        var_17 = wp::div(var_1, var_0);
        var_18 = wp::sub(var_16, var_17);
    }
    var_19 = wp::where(var_14, var_15, var_9);
    var_20 = wp::where(var_14, var_18, var_11);
    // kp = cross(motion__axis, p)                                                            <L 12>
    var_21 = wp::cross(var_motion__axis, var_p);
    // kv = cross(motion__axis, motion__velocity)                                             <L 13>
    var_22 = wp::cross(var_motion__axis, var_motion__velocity);
    // rotated = p + kp * sine + cross(motion__axis, kp) * versine                            <L 14>
    var_23 = wp::mul(var_21, var_1);
    var_24 = wp::add(var_p, var_23);
    var_25 = wp::cross(var_motion__axis, var_21);
    var_26 = wp::mul(var_25, var_7);
    var_27 = wp::add(var_24, var_26);
    // moved = (motion__velocity + kv * first + cross(motion__axis, kv) * second) * share       <L 15>
    var_28 = wp::mul(var_22, var_19);
    var_29 = wp::add(var_motion__velocity, var_28);
    var_30 = wp::cross(var_motion__axis, var_22);
    var_31 = wp::mul(var_30, var_20);
    var_32 = wp::add(var_29, var_31);
    var_33 = wp::mul(var_32, var_share);
    // return rotated + moved                                                                 <L 16>
    var_34 = wp::add(var_27, var_33);
    return var_34;
}


// <pointloom.kernels.arrays.runs.row_of>:1
static CUDA_CALLABLE wp::int32 row_of_0(
    wp::int32 var_i,
    wp::int32 var_runs__rows)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 32;
    wp::int32 var_1;
    wp::int32 var_2;
    //---------
    // forward
    // def row_of(i, runs__rows):                                                             <L 1>
    // return i // WARP % runs__rows                                                          <L 3>
    var_1 = wp::floordiv(var_i, var_0);
    var_2 = wp::mod(var_1, var_runs__rows);
    return var_2;
}


// /work/main/src/pointloom/kernels/algebra/transform.py:27
static CUDA_CALLABLE void adj_widen_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float64> & adj_ret)
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


// <pointloom.kernels.odometry.deskewing.move_along_screw>:1
static CUDA_CALLABLE void adj_move_along_screw_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::float32 var_share,
    wp::vec_t<3, wp::float32> var_motion__axis,
    wp::float32 var_motion__angle,
    wp::vec_t<3, wp::float32> var_motion__velocity,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::float32 & adj_share,
    wp::vec_t<3, wp::float32> & adj_motion__axis,
    wp::float32 & adj_motion__angle,
    wp::vec_t<3, wp::float32> & adj_motion__velocity,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.runs.row_of>:1
static CUDA_CALLABLE void adj_row_of_0(
    wp::int32 var_i,
    wp::int32 var_runs__rows,
    wp::int32 & adj_i,
    wp::int32 & adj_runs__rows,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void deskew_points_kernel_60f06b26_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::float64> var_times,
    wp::vec_t<3, wp::float64> var_origin,
    wp::array_t<wp::float64> var_motion__span,
    wp::vec_t<3, wp::float32> var_motion__axis,
    wp::float32 var_motion__angle,
    wp::vec_t<3, wp::float32> var_motion__velocity,
    wp::array_t<wp::vec_t<3, wp::float32>> var_out)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 0;
        wp::float64* var_2;
        wp::float64 var_3;
        wp::float64 var_4;
        const wp::int32 var_5 = 1;
        wp::float64* var_6;
        wp::float64 var_7;
        wp::float64 var_8;
        const wp::float32 var_9 = 0.0;
        wp::float32 var_10;
        bool var_11;
        wp::float64* var_12;
        wp::float64 var_13;
        wp::float64 var_14;
        wp::float64 var_15;
        wp::float64 var_16;
        wp::float32 var_17;
        bool var_18;
        bool var_19;
        wp::float64* var_20;
        bool var_21;
        wp::float64 var_22;
        bool var_23;
        const wp::float32 var_24 = NAN;
        wp::float32 var_25;
        wp::float32 var_26;
        wp::float32 var_27;
        wp::vec_t<3, wp::float32>* var_28;
        wp::vec_t<3, wp::float64> var_29;
        wp::vec_t<3, wp::float32> var_30;
        wp::vec_t<3, wp::float64> var_31;
        wp::vec_t<3, wp::float32> var_32;
        wp::vec_t<3, wp::float32> var_33;
        //---------
        // forward
        // def deskew_points_kernel(points, times, origin, motion__span, motion__axis, motion__angle, motion__velocity, out):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // first = motion__span[0]                                                                <L 4>
        var_2 = wp::address(var_motion__span, var_1);
        var_4 = wp::load(var_2);
        var_3 = wp::copy(var_4);
        // last = motion__span[1]                                                                 <L 5>
        var_6 = wp::address(var_motion__span, var_5);
        var_8 = wp::load(var_6);
        var_7 = wp::copy(var_8);
        // share = float(0.0)                                                                     <L 6>
        var_10 = wp::float(var_9);
        // if last > first:                                                                       <L 7>
        var_11 = (var_7 > var_3);
        if (var_11) {
            // share = float((times[i] - last) / (last - first))                                  <L 8>
            var_12 = wp::address(var_times, var_0);
            var_14 = wp::load(var_12);
            var_13 = wp::sub(var_14, var_7);
            var_15 = wp::sub(var_7, var_3);
            var_16 = wp::div(var_13, var_15);
            var_17 = wp::float(var_16);
        }
        if (!var_11) {
            // elif last == first and (not isfinite(times[i])):                                   <L 9>
            var_19 = (var_7 == var_3);
            var_18 = var_19;
            if (var_18) {
                var_20 = wp::address(var_times, var_0);
                var_22 = wp::load(var_20);
                var_21 = wp::isfinite(var_22);
                var_23 = wp::unot(var_21);
                var_18 = var_18 && var_23;
            }
            if (var_18) {
                // share = float(NAN)                                                             <L 10>
                var_25 = wp::float(var_24);
            }
            var_26 = wp::where(var_18, var_25, var_10);
        }
        var_27 = wp::where(var_11, var_17, var_26);
        // p = narrow(widen(points[i]) + origin)                                                  <L 11>
        var_28 = wp::address(var_points, var_0);
        var_30 = wp::load(var_28);
        var_29 = widen_0(var_30);
        var_31 = wp::add(var_29, var_origin);
        var_32 = narrow_0(var_31);
        // out[i] = move_along_screw(p, share, motion__axis, motion__angle, motion__velocity)       <L 12>
        var_33 = move_along_screw_0(var_32, var_27, var_motion__axis, var_motion__angle, var_motion__velocity);
        wp::array_store(var_out, var_0, var_33);
}



extern "C" __global__ void bound_times_kernel_7a733a95_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::float64> var_times,
    wp::int32 var_runs__rows,
    wp::int32 var_runs__count,
    wp::int32 var_runs__length,
    wp::int32 var_runs__stride,
    wp::int32 var_runs__step,
    wp::array_t<wp::float64> var_ends)
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
        wp::float64 var_2;
        wp::float64 var_3;
        wp::float64 var_4;
        wp::float64 var_5;
        wp::int32 var_6;
        const wp::int32 var_7 = 1;
        wp::int32 var_8;
        wp::int32 var_9;
        wp::int32 var_10;
        const wp::int32 var_11 = 1;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::range_t var_14;
        wp::int32 var_15;
        wp::int32 var_16;
        wp::int32 var_17;
        wp::vec_t<3, wp::float32>* var_18;
        wp::vec_t<3, wp::float32> var_19;
        wp::vec_t<3, wp::float32> var_20;
        wp::float64* var_21;
        wp::float64 var_22;
        wp::float64 var_23;
        bool var_24;
        bool var_25;
        bool var_26;
        const wp::int32 var_27 = 0;
        wp::float32 var_28;
        wp::float32 var_29;
        const wp::int32 var_30 = 1;
        wp::float32 var_31;
        wp::float32 var_32;
        wp::float32 var_33;
        const wp::int32 var_34 = 2;
        wp::float32 var_35;
        wp::float32 var_36;
        wp::float32 var_37;
        const wp::float32 var_38 = 0.0;
        bool var_39;
        wp::float64 var_40;
        wp::float64 var_41;
        wp::float64 var_42;
        wp::float64 var_43;
        wp::float64 var_44;
        wp::float64 var_45;
        bool var_46;
        const wp::int32 var_47 = 2;
        wp::int32 var_48;
        wp::int32 var_49;
        wp::float64 var_50;
        wp::float64 var_51;
        const wp::int32 var_52 = 1;
        wp::int32 var_53;
        wp::float64 var_54;
        //---------
        // forward
        // def bound_times_kernel(points, times, runs__rows, runs__count, runs__length, runs__stride, runs__step, ends):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // low = float64(INFINITY) + float64(0.0)                                                 <L 4>
        var_1 = INFINITY;
        var_2 = 0.0;
        var_3 = wp::add(var_1, var_2);
        // high = -float64(INFINITY)                                                              <L 5>
        var_4 = wp::float64(var_1);
        var_5 = wp::neg(var_4);
        // first__elements_of__1 = i * runs__stride                                               <L 6>
        var_6 = wp::mul(var_0, var_runs__stride);
        // for k__elements_of__1 in range(min(runs__length, (runs__count - 1 - first__elements_of__1) // runs__step + 1)):       <L 7>
        var_8 = wp::sub(var_runs__count, var_7);
        var_9 = wp::sub(var_8, var_6);
        var_10 = wp::floordiv(var_9, var_runs__step);
        var_12 = wp::add(var_10, var_11);
        var_13 = wp::min(var_runs__length, var_12);
        var_14 = wp::range(var_13);
        start_for_0:;
            if (iter_cmp(var_14) == 0) goto end_for_0;
            var_15 = wp::iter_next(var_14);
            // j = first__elements_of__1 + k__elements_of__1 * runs__step                         <L 8>
            var_16 = wp::mul(var_15, var_runs__step);
            var_17 = wp::add(var_6, var_16);
            // p = points[j]                                                                      <L 9>
            var_18 = wp::address(var_points, var_17);
            var_20 = wp::load(var_18);
            var_19 = wp::copy(var_20);
            // t = times[j]                                                                       <L 10>
            var_21 = wp::address(var_times, var_17);
            var_23 = wp::load(var_21);
            var_22 = wp::copy(var_23);
            // if isfinite(p) and isfinite(t):                                                    <L 11>
            var_25 = wp::isfinite(var_19);
            var_24 = var_25;
            if (var_24) {
                var_26 = wp::isfinite(var_22);
                var_24 = var_24 && var_26;
            }
            if (var_24) {
                // if abs(p[0]) + abs(p[1]) + abs(p[2]) > 0.0:                                    <L 12>
                var_28 = wp::extract(var_19, var_27);
                var_29 = wp::abs(var_28);
                var_31 = wp::extract(var_19, var_30);
                var_32 = wp::abs(var_31);
                var_33 = wp::add(var_29, var_32);
                var_35 = wp::extract(var_19, var_34);
                var_36 = wp::abs(var_35);
                var_37 = wp::add(var_33, var_36);
                var_39 = (var_37 > var_38);
                if (var_39) {
                    // low = min(low, t)                                                          <L 13>
                    var_40 = wp::min(var_3, var_22);
                    // high = max(high, t)                                                        <L 14>
                    var_41 = wp::max(var_5, var_22);
                }
                var_42 = wp::where(var_39, var_40, var_3);
                var_43 = wp::where(var_39, var_41, var_5);
            }
            var_44 = wp::where(var_24, var_42, var_3);
            var_45 = wp::where(var_24, var_43, var_5);
            wp::assign(var_3, var_44);
            wp::assign(var_5, var_45);
            goto start_for_0;
        end_for_0:;
        // if low <= high:                                                                        <L 15>
        var_46 = (var_3 <= var_5);
        if (var_46) {
            // at = 2 * row_of(i, runs__rows)                                                     <L 16>
            var_48 = row_of_0(var_0, var_runs__rows);
            var_49 = wp::mul(var_47, var_48);
            // atomic_max(ends, at, -low)                                                         <L 17>
            var_50 = wp::neg(var_3);
            var_51 = wp::atomic_max(var_ends, var_49, var_50);
            // atomic_max(ends, at + 1, high)                                                     <L 18>
            var_53 = wp::add(var_49, var_52);
            var_54 = wp::atomic_max(var_ends, var_53, var_5);
        }
}



extern "C" __global__ void fold_times_kernel_e9f516e5_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float64> var_ends,
    wp::array_t<wp::float64> var_span)
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
        wp::float64 var_2;
        wp::float64 var_3;
        wp::float64 var_4;
        wp::float64 var_5;
        wp::shape_t* var_6;
        const wp::int32 var_7 = 0;
        wp::int32 var_8;
        wp::shape_t var_9;
        const wp::int32 var_10 = 2;
        wp::int32 var_11;
        wp::range_t var_12;
        wp::int32 var_13;
        const wp::int32 var_14 = 2;
        wp::int32 var_15;
        wp::float64* var_16;
        wp::float64 var_17;
        wp::float64 var_18;
        wp::float64 var_19;
        const wp::int32 var_20 = 2;
        wp::int32 var_21;
        const wp::int32 var_22 = 1;
        wp::int32 var_23;
        wp::float64* var_24;
        wp::float64 var_25;
        wp::float64 var_26;
        const wp::int32 var_27 = 1;
        wp::int32 var_28;
        //---------
        // forward
        // def fold_times_kernel(ends, span):                                                     <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // low = float64(INFINITY) + float64(0.0)                                                 <L 3>
        var_1 = INFINITY;
        var_2 = 0.0;
        var_3 = wp::add(var_1, var_2);
        // high = -float64(INFINITY)                                                              <L 4>
        var_4 = wp::float64(var_1);
        var_5 = wp::neg(var_4);
        // for k in range(ends.shape[0] // 2):                                                    <L 5>
        var_6 = &(var_ends.shape);
        var_9 = wp::load(var_6);
        var_8 = wp::extract(var_9, var_7);
        var_11 = wp::floordiv(var_8, var_10);
        var_12 = wp::range(var_11);
        start_for_0:;
            if (iter_cmp(var_12) == 0) goto end_for_0;
            var_13 = wp::iter_next(var_12);
            // low = min(low, -ends[2 * k])                                                       <L 6>
            var_15 = wp::mul(var_14, var_13);
            var_16 = wp::address(var_ends, var_15);
            var_18 = wp::load(var_16);
            var_17 = wp::neg(var_18);
            var_19 = wp::min(var_3, var_17);
            // high = max(high, ends[2 * k + 1])                                                  <L 7>
            var_21 = wp::mul(var_20, var_13);
            var_23 = wp::add(var_21, var_22);
            var_24 = wp::address(var_ends, var_23);
            var_26 = wp::load(var_24);
            var_25 = wp::max(var_5, var_26);
            wp::assign(var_3, var_19);
            wp::assign(var_5, var_25);
            goto start_for_0;
        end_for_0:;
        // span[i] = low                                                                          <L 8>
        wp::array_store(var_span, var_0, var_3);
        // span[i + 1] = high                                                                     <L 9>
        var_28 = wp::add(var_0, var_27);
        wp::array_store(var_span, var_28, var_5);
}


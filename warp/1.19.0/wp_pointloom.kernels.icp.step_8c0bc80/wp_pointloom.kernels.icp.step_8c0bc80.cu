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



extern "C" __global__ void measure_sources_kernel_82138369_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_jobs__job_sources,
    wp::array_t<wp::vec_t<4, wp::float64>> var_moments,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_poses,
    wp::array_t<wp::vec_t<3, wp::float64>> var_progress__pivots,
    wp::array_t<wp::float64> var_progress__sizes,
    wp::array_t<wp::float64> var_progress__source_counts)
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
        wp::vec_t<4, wp::float64>* var_3;
        wp::float64* var_4;
        wp::vec_t<4, wp::float64> var_5;
        wp::vec_t<4, wp::float64> var_6;
        wp::float64 var_7;
        const wp::int32 var_8 = 0;
        wp::float64 var_9;
        const wp::int32 var_10 = 1;
        wp::float64 var_11;
        const wp::int32 var_12 = 2;
        wp::float64 var_13;
        wp::vec_t<3, wp::float64> var_14;
        wp::float64 var_15;
        const wp::int32 var_16 = 3;
        wp::float64 var_17;
        wp::float64 var_18;
        wp::float64 var_19;
        wp::float64 var_20;
        wp::float64 var_21;
        wp::float64 var_22;
        wp::float64 var_23;
        wp::float64 var_24;
        wp::float64 var_25;
        wp::mat_t<4, 4, wp::float64>* var_26;
        wp::vec_t<3, wp::float64> var_27;
        wp::mat_t<4, 4, wp::float64> var_28;
        wp::float64 var_29;
        bool var_30;
        wp::float64 var_31;
        wp::float64 var_32;
        //---------
        // forward
        // def measure_sources_kernel(jobs__job_sources, moments, poses, progress__pivots, progress__sizes, progress__source_counts):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // sums = moments[jobs__job_sources[i]] / progress__source_counts[i]                      <L 4>
        var_1 = wp::address(var_jobs__job_sources, var_0);
        var_2 = wp::load(var_1);
        var_3 = wp::address(var_moments, var_2);
        var_4 = wp::address(var_progress__source_counts, var_0);
        var_6 = wp::load(var_3);
        var_7 = wp::load(var_4);
        var_5 = wp::div(var_6, var_7);
        // mean = vec3d(sums[0], sums[1], sums[2])                                                <L 5>
        var_9 = wp::extract(var_5, var_8);
        var_11 = wp::extract(var_5, var_10);
        var_13 = wp::extract(var_5, var_12);
        var_14 = wp::vec_t<3, wp::float64>(var_9, var_11, var_13);
        // square = dot(mean, mean)                                                               <L 6>
        var_15 = wp::dot(var_14, var_14);
        // size = max(sqrt(max(sums[3] - square, float64(0.0))), float64(SMALLEST_SIZE) * sqrt(square))       <L 7>
        var_17 = wp::extract(var_5, var_16);
        var_18 = wp::sub(var_17, var_15);
        var_19 = 0.0;
        var_20 = wp::max(var_18, var_19);
        var_21 = wp::sqrt(var_20);
        var_22 = 1e-12;
        var_23 = wp::sqrt(var_15);
        var_24 = wp::mul(var_22, var_23);
        var_25 = wp::max(var_21, var_24);
        // progress__pivots[i] = move(poses[i], mean)                                             <L 8>
        var_26 = wp::address(var_poses, var_0);
        var_28 = wp::load(var_26);
        var_27 = move_0(var_28, var_14);
        wp::array_store(var_progress__pivots, var_0, var_27);
        // progress__sizes[i] = size if size > float64(0.0) else float64(SMALLEST_SIZE)           <L 9>
        var_29 = 0.0;
        var_30 = (var_25 > var_29);
        if (var_30) {
        }
        if (!var_30) {
            var_31 = wp::float64(var_22);
        }
        var_32 = wp::where(var_30, var_25, var_31);
        wp::array_store(var_progress__sizes, var_0, var_32);
}



extern "C" __global__ void measure_velocities_kernel_b3d7d79b_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_poses,
    wp::float64 var_period,
    wp::array_t<wp::vec_t<6, wp::float64>> var_velocities)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::mat_t<4, 4, wp::float64>* var_1;
        wp::mat_t<4, 4, wp::float64> var_2;
        wp::mat_t<4, 4, wp::float64> var_3;
        const wp::int32 var_4 = 2;
        const wp::int32 var_5 = 1;
        wp::float64 var_6;
        const wp::int32 var_7 = 2;
        const wp::int32 var_8 = 2;
        wp::float64 var_9;
        wp::float64 var_10;
        const wp::int32 var_11 = 2;
        const wp::int32 var_12 = 0;
        wp::float64 var_13;
        wp::float64 var_14;
        const wp::int32 var_15 = 0;
        const wp::int32 var_16 = 0;
        wp::float64 var_17;
        const wp::int32 var_18 = 0;
        const wp::int32 var_19 = 0;
        wp::float64 var_20;
        wp::float64 var_21;
        const wp::int32 var_22 = 1;
        const wp::int32 var_23 = 0;
        wp::float64 var_24;
        const wp::int32 var_25 = 1;
        const wp::int32 var_26 = 0;
        wp::float64 var_27;
        wp::float64 var_28;
        wp::float64 var_29;
        wp::float64 var_30;
        wp::float64 var_31;
        const wp::int32 var_32 = 1;
        const wp::int32 var_33 = 0;
        wp::float64 var_34;
        const wp::int32 var_35 = 0;
        const wp::int32 var_36 = 0;
        wp::float64 var_37;
        wp::float64 var_38;
        wp::float64 var_39;
        wp::float64 var_40;
        wp::float64 var_41;
        const wp::int32 var_42 = 0;
        const wp::int32 var_43 = 3;
        wp::float64 var_44;
        wp::float64 var_45;
        const wp::int32 var_46 = 1;
        const wp::int32 var_47 = 3;
        wp::float64 var_48;
        wp::float64 var_49;
        const wp::int32 var_50 = 2;
        const wp::int32 var_51 = 3;
        wp::float64 var_52;
        wp::float64 var_53;
        wp::vec_t<6, wp::float64> var_54;
        wp::vec_t<6, wp::float64> var_55;
        //---------
        // forward
        // def measure_velocities_kernel(poses: array(dtype=mat44d), period: float64, velocities: array(dtype=vec6d)):       <L 226>
        // i = tid()                                                                              <L 228>
        var_0 = builtin_tid1d();
        // T = poses[i]                                                                           <L 229>
        var_1 = wp::address(var_poses, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // x = atan2(T[2, 1], T[2, 2])                                                            <L 230>
        var_6 = wp::extract(var_2, var_4, var_5);
        var_9 = wp::extract(var_2, var_7, var_8);
        var_10 = wp::atan2(var_6, var_9);
        // y = atan2(-T[2, 0], sqrt(T[0, 0] * T[0, 0] + T[1, 0] * T[1, 0]))                       <L 231>
        var_13 = wp::extract(var_2, var_11, var_12);
        var_14 = wp::neg(var_13);
        var_17 = wp::extract(var_2, var_15, var_16);
        var_20 = wp::extract(var_2, var_18, var_19);
        var_21 = wp::mul(var_17, var_20);
        var_24 = wp::extract(var_2, var_22, var_23);
        var_27 = wp::extract(var_2, var_25, var_26);
        var_28 = wp::mul(var_24, var_27);
        var_29 = wp::add(var_21, var_28);
        var_30 = wp::sqrt(var_29);
        var_31 = wp::atan2(var_14, var_30);
        // z = atan2(T[1, 0], T[0, 0])                                                            <L 232>
        var_34 = wp::extract(var_2, var_32, var_33);
        var_37 = wp::extract(var_2, var_35, var_36);
        var_38 = wp::atan2(var_34, var_37);
        // velocities[i] = vec6d(-x, -y, -z, -T[0, 3], -T[1, 3], -T[2, 3]) / period               <L 233>
        var_39 = wp::neg(var_10);
        var_40 = wp::neg(var_31);
        var_41 = wp::neg(var_38);
        var_44 = wp::extract(var_2, var_42, var_43);
        var_45 = wp::neg(var_44);
        var_48 = wp::extract(var_2, var_46, var_47);
        var_49 = wp::neg(var_48);
        var_52 = wp::extract(var_2, var_50, var_51);
        var_53 = wp::neg(var_52);
        var_54 = wp::vec_t<6, wp::float64>({var_39, var_40, var_41, var_45, var_49, var_53});
        var_55 = wp::div(var_54, var_period);
        wp::array_store(var_velocities, var_0, var_55);
}


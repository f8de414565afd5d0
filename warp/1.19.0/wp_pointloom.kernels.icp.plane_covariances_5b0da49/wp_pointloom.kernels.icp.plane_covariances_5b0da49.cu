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


// /work/main/src/pointloom/kernels/icp/plane_covariances.py:36
static CUDA_CALLABLE wp::mat_t<3, 3, wp::float64> identity_0(
    )
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    wp::mat_t<3, 3, wp::float64> var_2;
    //---------
    // forward
    // def identity() -> mat33d:                                                              <L 37>
    // one = float64(1.0)                                                                     <L 38>
    var_0 = 1.0;
    // zero = float64(0.0)                                                                    <L 39>
    var_1 = 0.0;
    // return mat33d(one, zero, zero, zero, one, zero, zero, zero, one)                       <L 40>
    var_2 = wp::mat_t<3, 3, wp::float64>(var_0, var_1, var_1, var_1, var_0, var_1, var_1, var_1, var_0);
    return var_2;
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


// <pointloom.kernels.icp.plane_covariances.plane_covariance>:1
static CUDA_CALLABLE wp::mat_t<3, 3, wp::float64> plane_covariance_0(
    wp::vec_t<3, wp::float64> var_n,
    wp::float64 var_epsilon)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::mat_t<3, 3, wp::float64> var_1;
    wp::float64 var_2;
    bool var_3;
    wp::mat_t<3, 3, wp::float64> var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    wp::float64 var_7;
    wp::mat_t<3, 3, wp::float64> var_8;
    wp::mat_t<3, 3, wp::float64> var_9;
    wp::mat_t<3, 3, wp::float64> var_10;
    //---------
    // forward
    // def plane_covariance(n, epsilon):                                                      <L 1>
    // sqlength = dot(n, n)                                                                   <L 3>
    var_0 = wp::dot(var_n, var_n);
    // C = identity()                                                                         <L 4>
    var_1 = identity_0();
    // if sqlength > float64(0.0):                                                            <L 5>
    var_2 = 0.0;
    var_3 = (var_0 > var_2);
    if (var_3) {
        // C = C + outer(n, n) * ((epsilon - float64(1.0)) / sqlength)                        <L 6>
        var_4 = wp::outer(var_n, var_n);
        var_5 = 1.0;
        var_6 = wp::sub(var_epsilon, var_5);
        var_7 = wp::div(var_6, var_0);
        var_8 = wp::mul(var_4, var_7);
        var_9 = wp::add(var_1, var_8);
    }
    var_10 = wp::where(var_3, var_9, var_1);
    // return C                                                                               <L 7>
    return var_10;
}


// /work/main/src/pointloom/kernels/icp/plane_covariances.py:36
static CUDA_CALLABLE void adj_identity_0(
    wp::mat_t<3, 3, wp::float64> & adj_ret)
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


// <pointloom.kernels.icp.plane_covariances.plane_covariance>:1
static CUDA_CALLABLE void adj_plane_covariance_0(
    wp::vec_t<3, wp::float64> var_n,
    wp::float64 var_epsilon,
    wp::vec_t<3, wp::float64> & adj_n,
    wp::float64 & adj_epsilon,
    wp::mat_t<3, 3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void cover_planes_kernel_6117b93b_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals,
    wp::int32 var_known,
    wp::float64 var_epsilon,
    wp::array_t<wp::float32> var_covariances)
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
        wp::mat_t<3, 3, wp::float64> var_4;
        const wp::int32 var_5 = 1;
        bool var_6;
        wp::vec_t<3, wp::float64> var_7;
        wp::mat_t<3, 3, wp::float64> var_8;
        wp::mat_t<3, 3, wp::float64> var_9;
        const wp::int32 var_10 = 0;
        const wp::int32 var_11 = 0;
        const wp::float32 var_12 = NAN;
        wp::float32 var_13;
        bool var_14;
        wp::float64 var_15;
        wp::float32 var_16;
        wp::float32 var_17;
        const wp::int32 var_18 = 3;
        wp::int32 var_19;
        wp::int32 var_20;
        const wp::int32 var_21 = 1;
        wp::float32 var_22;
        bool var_23;
        wp::float64 var_24;
        wp::float32 var_25;
        wp::float32 var_26;
        const wp::int32 var_27 = 3;
        wp::int32 var_28;
        wp::int32 var_29;
        const wp::int32 var_30 = 2;
        wp::float32 var_31;
        bool var_32;
        wp::float64 var_33;
        wp::float32 var_34;
        wp::float32 var_35;
        const wp::int32 var_36 = 3;
        wp::int32 var_37;
        wp::int32 var_38;
        const wp::int32 var_39 = 1;
        const wp::int32 var_40 = 0;
        wp::float32 var_41;
        bool var_42;
        wp::float64 var_43;
        wp::float32 var_44;
        wp::float32 var_45;
        const wp::int32 var_46 = 3;
        wp::int32 var_47;
        wp::int32 var_48;
        const wp::int32 var_49 = 1;
        wp::float32 var_50;
        bool var_51;
        wp::float64 var_52;
        wp::float32 var_53;
        wp::float32 var_54;
        const wp::int32 var_55 = 3;
        wp::int32 var_56;
        wp::int32 var_57;
        const wp::int32 var_58 = 2;
        wp::float32 var_59;
        bool var_60;
        wp::float64 var_61;
        wp::float32 var_62;
        wp::float32 var_63;
        const wp::int32 var_64 = 3;
        wp::int32 var_65;
        wp::int32 var_66;
        const wp::int32 var_67 = 2;
        const wp::int32 var_68 = 0;
        wp::float32 var_69;
        bool var_70;
        wp::float64 var_71;
        wp::float32 var_72;
        wp::float32 var_73;
        const wp::int32 var_74 = 3;
        wp::int32 var_75;
        wp::int32 var_76;
        const wp::int32 var_77 = 1;
        wp::float32 var_78;
        bool var_79;
        wp::float64 var_80;
        wp::float32 var_81;
        wp::float32 var_82;
        const wp::int32 var_83 = 3;
        wp::int32 var_84;
        wp::int32 var_85;
        const wp::int32 var_86 = 2;
        wp::float32 var_87;
        bool var_88;
        wp::float64 var_89;
        wp::float32 var_90;
        wp::float32 var_91;
        const wp::int32 var_92 = 3;
        wp::int32 var_93;
        wp::int32 var_94;
        //---------
        // forward
        // def cover_planes_kernel(                                                               <L 54>
        // i = tid()                                                                              <L 58>
        var_0 = builtin_tid1d();
        // n = normals[i]                                                                         <L 59>
        var_1 = wp::address(var_normals, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // C = identity()                                                                         <L 60>
        var_4 = identity_0();
        // if known == 1:                                                                         <L 61>
        var_6 = (var_known == var_5);
        if (var_6) {
            // C = plane_covariance(widen(n), epsilon)                                            <L 62>
            var_7 = widen_0(var_2);
            var_8 = plane_covariance_0(var_7, var_epsilon);
        }
        var_9 = wp::where(var_6, var_8, var_4);
        // for row in range(3):                                                                   <L 63>
        // for column in range(3):                                                                <L 64>
        // value = float(NAN)                                                                     <L 65>
        var_13 = wp::float(var_12);
        // if isfinite(n):                                                                        <L 66>
        var_14 = wp::isfinite(var_2);
        if (var_14) {
            // value = float(C[row, column])                                                      <L 67>
            var_15 = wp::extract(var_9, var_10, var_11);
            var_16 = wp::float(var_15);
        }
        var_17 = wp::where(var_14, var_16, var_13);
        // covariances[i, 3 * row + column] = value                                               <L 68>
        var_19 = wp::mul(var_18, var_10);
        var_20 = wp::add(var_19, var_11);
        wp::array_store(var_covariances, var_0, var_20, var_17);
        // value = float(NAN)                                                                     <L 65>
        var_22 = wp::float(var_12);
        // if isfinite(n):                                                                        <L 66>
        var_23 = wp::isfinite(var_2);
        if (var_23) {
            // value = float(C[row, column])                                                      <L 67>
            var_24 = wp::extract(var_9, var_10, var_21);
            var_25 = wp::float(var_24);
        }
        var_26 = wp::where(var_23, var_25, var_22);
        // covariances[i, 3 * row + column] = value                                               <L 68>
        var_28 = wp::mul(var_27, var_10);
        var_29 = wp::add(var_28, var_21);
        wp::array_store(var_covariances, var_0, var_29, var_26);
        // value = float(NAN)                                                                     <L 65>
        var_31 = wp::float(var_12);
        // if isfinite(n):                                                                        <L 66>
        var_32 = wp::isfinite(var_2);
        if (var_32) {
            // value = float(C[row, column])                                                      <L 67>
            var_33 = wp::extract(var_9, var_10, var_30);
            var_34 = wp::float(var_33);
        }
        var_35 = wp::where(var_32, var_34, var_31);
        // covariances[i, 3 * row + column] = value                                               <L 68>
        var_37 = wp::mul(var_36, var_10);
        var_38 = wp::add(var_37, var_30);
        wp::array_store(var_covariances, var_0, var_38, var_35);
        // for column in range(3):                                                                <L 64>
        // value = float(NAN)                                                                     <L 65>
        var_41 = wp::float(var_12);
        // if isfinite(n):                                                                        <L 66>
        var_42 = wp::isfinite(var_2);
        if (var_42) {
            // value = float(C[row, column])                                                      <L 67>
            var_43 = wp::extract(var_9, var_39, var_40);
            var_44 = wp::float(var_43);
        }
        var_45 = wp::where(var_42, var_44, var_41);
        // covariances[i, 3 * row + column] = value                                               <L 68>
        var_47 = wp::mul(var_46, var_39);
        var_48 = wp::add(var_47, var_40);
        wp::array_store(var_covariances, var_0, var_48, var_45);
        // value = float(NAN)                                                                     <L 65>
        var_50 = wp::float(var_12);
        // if isfinite(n):                                                                        <L 66>
        var_51 = wp::isfinite(var_2);
        if (var_51) {
            // value = float(C[row, column])                                                      <L 67>
            var_52 = wp::extract(var_9, var_39, var_49);
            var_53 = wp::float(var_52);
        }
        var_54 = wp::where(var_51, var_53, var_50);
        // covariances[i, 3 * row + column] = value                                               <L 68>
        var_56 = wp::mul(var_55, var_39);
        var_57 = wp::add(var_56, var_49);
        wp::array_store(var_covariances, var_0, var_57, var_54);
        // value = float(NAN)                                                                     <L 65>
        var_59 = wp::float(var_12);
        // if isfinite(n):                                                                        <L 66>
        var_60 = wp::isfinite(var_2);
        if (var_60) {
            // value = float(C[row, column])                                                      <L 67>
            var_61 = wp::extract(var_9, var_39, var_58);
            var_62 = wp::float(var_61);
        }
        var_63 = wp::where(var_60, var_62, var_59);
        // covariances[i, 3 * row + column] = value                                               <L 68>
        var_65 = wp::mul(var_64, var_39);
        var_66 = wp::add(var_65, var_58);
        wp::array_store(var_covariances, var_0, var_66, var_63);
        // for column in range(3):                                                                <L 64>
        // value = float(NAN)                                                                     <L 65>
        var_69 = wp::float(var_12);
        // if isfinite(n):                                                                        <L 66>
        var_70 = wp::isfinite(var_2);
        if (var_70) {
            // value = float(C[row, column])                                                      <L 67>
            var_71 = wp::extract(var_9, var_67, var_68);
            var_72 = wp::float(var_71);
        }
        var_73 = wp::where(var_70, var_72, var_69);
        // covariances[i, 3 * row + column] = value                                               <L 68>
        var_75 = wp::mul(var_74, var_67);
        var_76 = wp::add(var_75, var_68);
        wp::array_store(var_covariances, var_0, var_76, var_73);
        // value = float(NAN)                                                                     <L 65>
        var_78 = wp::float(var_12);
        // if isfinite(n):                                                                        <L 66>
        var_79 = wp::isfinite(var_2);
        if (var_79) {
            // value = float(C[row, column])                                                      <L 67>
            var_80 = wp::extract(var_9, var_67, var_77);
            var_81 = wp::float(var_80);
        }
        var_82 = wp::where(var_79, var_81, var_78);
        // covariances[i, 3 * row + column] = value                                               <L 68>
        var_84 = wp::mul(var_83, var_67);
        var_85 = wp::add(var_84, var_77);
        wp::array_store(var_covariances, var_0, var_85, var_82);
        // value = float(NAN)                                                                     <L 65>
        var_87 = wp::float(var_12);
        // if isfinite(n):                                                                        <L 66>
        var_88 = wp::isfinite(var_2);
        if (var_88) {
            // value = float(C[row, column])                                                      <L 67>
            var_89 = wp::extract(var_9, var_67, var_86);
            var_90 = wp::float(var_89);
        }
        var_91 = wp::where(var_88, var_90, var_87);
        // covariances[i, 3 * row + column] = value                                               <L 68>
        var_93 = wp::mul(var_92, var_67);
        var_94 = wp::add(var_93, var_86);
        wp::array_store(var_covariances, var_0, var_94, var_91);
}


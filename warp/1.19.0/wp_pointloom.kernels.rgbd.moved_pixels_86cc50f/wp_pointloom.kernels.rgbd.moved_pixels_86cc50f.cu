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


// /work/main/src/pointloom/kernels/rgbd/pyramid.py:79
static CUDA_CALLABLE wp::float32 nearest_depth_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 var_c,
    wp::float32 var_d)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 1e+30;
    wp::float32 var_1;
    const wp::float32 var_2 = 0.0;
    bool var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::float32 var_6 = 0.0;
    bool var_7;
    wp::float32 var_8;
    wp::float32 var_9;
    const wp::float32 var_10 = 0.0;
    bool var_11;
    wp::float32 var_12;
    wp::float32 var_13;
    const wp::float32 var_14 = 0.0;
    bool var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    //---------
    // forward
    // def nearest_depth(a: float, b: float, c: float, d: float) -> float:                    <L 80>
    // near = float(NO_DEPTH)                                                                 <L 82>
    var_1 = wp::float(var_0);
    // if a > 0.0:                                                                            <L 83>
    var_3 = (var_a > var_2);
    if (var_3) {
        // near = min(near, a)                                                                <L 84>
        var_4 = wp::min(var_1, var_a);
    }
    var_5 = wp::where(var_3, var_4, var_1);
    // if b > 0.0:                                                                            <L 85>
    var_7 = (var_b > var_6);
    if (var_7) {
        // near = min(near, b)                                                                <L 86>
        var_8 = wp::min(var_5, var_b);
    }
    var_9 = wp::where(var_7, var_8, var_5);
    // if c > 0.0:                                                                            <L 87>
    var_11 = (var_c > var_10);
    if (var_11) {
        // near = min(near, c)                                                                <L 88>
        var_12 = wp::min(var_9, var_c);
    }
    var_13 = wp::where(var_11, var_12, var_9);
    // if d > 0.0:                                                                            <L 89>
    var_15 = (var_d > var_14);
    if (var_15) {
        // near = min(near, d)                                                                <L 90>
        var_16 = wp::min(var_13, var_d);
    }
    var_17 = wp::where(var_15, var_16, var_13);
    // return near                                                                            <L 91>
    return var_17;
}


// <pointloom.kernels.rgbd.moved_pixels.was_free>:1
static CUDA_CALLABLE wp::int32 was_free_0(
    wp::float32 var_u,
    wp::float32 var_v,
    wp::float32 var_d,
    wp::array_t<wp::float32> var_earlier__min_depth,
    wp::vec_t<4, wp::int32> var_earlier__size,
    wp::vec_t<4, wp::float32> var_earlier__lens,
    wp::vec_t<3, wp::float32> var_earlier__along_u,
    wp::vec_t<3, wp::float32> var_earlier__along_v,
    wp::vec_t<3, wp::float32> var_earlier__ray,
    wp::vec_t<3, wp::float32> var_earlier__start)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32> var_0;
    wp::vec_t<3, wp::float32> var_1;
    wp::vec_t<3, wp::float32> var_2;
    wp::vec_t<3, wp::float32> var_3;
    wp::vec_t<3, wp::float32> var_4;
    wp::vec_t<3, wp::float32> var_5;
    const wp::int32 var_6 = 0;
    wp::int32 var_7;
    const wp::int32 var_8 = 2;
    wp::float32 var_9;
    const wp::float32 var_10 = 0.1;
    bool var_11;
    const wp::int32 var_12 = 0;
    wp::float32 var_13;
    const wp::int32 var_14 = 2;
    wp::float32 var_15;
    wp::float32 var_16;
    const wp::int32 var_17 = 0;
    wp::float32 var_18;
    wp::float32 var_19;
    const wp::int32 var_20 = 2;
    wp::float32 var_21;
    wp::float32 var_22;
    const wp::float32 var_23 = 0.5;
    wp::float32 var_24;
    wp::float32 var_25;
    wp::int32 var_26;
    const wp::int32 var_27 = 1;
    wp::float32 var_28;
    const wp::int32 var_29 = 2;
    wp::float32 var_30;
    wp::float32 var_31;
    const wp::int32 var_32 = 1;
    wp::float32 var_33;
    wp::float32 var_34;
    const wp::int32 var_35 = 3;
    wp::float32 var_36;
    wp::float32 var_37;
    const wp::float32 var_38 = 0.5;
    wp::float32 var_39;
    wp::float32 var_40;
    wp::int32 var_41;
    bool var_42;
    const wp::int32 var_43 = 0;
    bool var_44;
    const wp::int32 var_45 = 0;
    bool var_46;
    const wp::int32 var_47 = 0;
    wp::int32 var_48;
    bool var_49;
    const wp::int32 var_50 = 1;
    wp::int32 var_51;
    bool var_52;
    const wp::int32 var_53 = 0;
    wp::int32 var_54;
    wp::int32 var_55;
    wp::int32 var_56;
    wp::float32* var_57;
    const wp::int32 var_58 = 2;
    wp::float32 var_59;
    const wp::float32 var_60 = 0.05;
    wp::float32 var_61;
    const wp::float32 var_62 = 0.05;
    const wp::int32 var_63 = 2;
    wp::float32 var_64;
    wp::float32 var_65;
    wp::float32 var_66;
    bool var_67;
    wp::float32 var_68;
    const wp::int32 var_69 = 1;
    wp::int32 var_70;
    wp::int32 var_71;
    wp::int32 var_72;
    //---------
    // forward
    // def was_free(u, v, d, earlier__min_depth, earlier__size, earlier__lens, earlier__along_u, earlier__along_v, earlier__ray, earlier__start):       <L 1>
    // p = (earlier__along_u * u + earlier__along_v * v + earlier__ray) * d + earlier__start       <L 3>
    var_0 = wp::mul(var_earlier__along_u, var_u);
    var_1 = wp::mul(var_earlier__along_v, var_v);
    var_2 = wp::add(var_0, var_1);
    var_3 = wp::add(var_2, var_earlier__ray);
    var_4 = wp::mul(var_3, var_d);
    var_5 = wp::add(var_4, var_earlier__start);
    // free = int(0)                                                                          <L 4>
    var_7 = wp::int(var_6);
    // if p[2] > NEAREST:                                                                     <L 5>
    var_9 = wp::extract(var_5, var_8);
    var_11 = (var_9 > var_10);
    if (var_11) {
        // x = int(floor(p[0] / p[2] * earlier__lens[0] + earlier__lens[2] + 0.5))            <L 6>
        var_13 = wp::extract(var_5, var_12);
        var_15 = wp::extract(var_5, var_14);
        var_16 = wp::div(var_13, var_15);
        var_18 = wp::extract(var_earlier__lens, var_17);
        var_19 = wp::mul(var_16, var_18);
        var_21 = wp::extract(var_earlier__lens, var_20);
        var_22 = wp::add(var_19, var_21);
        var_24 = wp::add(var_22, var_23);
        var_25 = wp::floor(var_24);
        var_26 = wp::int(var_25);
        // y = int(floor(p[1] / p[2] * earlier__lens[1] + earlier__lens[3] + 0.5))            <L 7>
        var_28 = wp::extract(var_5, var_27);
        var_30 = wp::extract(var_5, var_29);
        var_31 = wp::div(var_28, var_30);
        var_33 = wp::extract(var_earlier__lens, var_32);
        var_34 = wp::mul(var_31, var_33);
        var_36 = wp::extract(var_earlier__lens, var_35);
        var_37 = wp::add(var_34, var_36);
        var_39 = wp::add(var_37, var_38);
        var_40 = wp::floor(var_39);
        var_41 = wp::int(var_40);
        // if x >= 0 and y >= 0 and (x < earlier__size[0]) and (y < earlier__size[1]):        <L 8>
        var_44 = (var_26 >= var_43);
        var_42 = var_44;
        if (var_42) {
            var_46 = (var_41 >= var_45);
            var_42 = var_42 && var_46;
        }
        if (var_42) {
            var_48 = wp::extract(var_earlier__size, var_47);
            var_49 = (var_26 < var_48);
            var_42 = var_42 && var_49;
        }
        if (var_42) {
            var_51 = wp::extract(var_earlier__size, var_50);
            var_52 = (var_41 < var_51);
            var_42 = var_42 && var_52;
        }
        if (var_42) {
            // if earlier__min_depth[y * earlier__size[0] + x] > p[2] + MARGIN + NEARER * p[2]:       <L 9>
            var_54 = wp::extract(var_earlier__size, var_53);
            var_55 = wp::mul(var_41, var_54);
            var_56 = wp::add(var_55, var_26);
            var_57 = wp::address(var_earlier__min_depth, var_56);
            var_59 = wp::extract(var_5, var_58);
            var_61 = wp::add(var_59, var_60);
            var_64 = wp::extract(var_5, var_63);
            var_65 = wp::mul(var_62, var_64);
            var_66 = wp::add(var_61, var_65);
            var_68 = wp::load(var_57);
            var_67 = (var_68 > var_66);
            if (var_67) {
                // free = 1                                                                   <L 10>
            }
            var_70 = wp::where(var_67, var_69, var_7);
        }
        var_71 = wp::where(var_42, var_70, var_7);
    }
    var_72 = wp::where(var_11, var_71, var_7);
    // return free                                                                            <L 11>
    return var_72;
}


// <pointloom.kernels.rgbd.moved_pixels.beyond>:1
static CUDA_CALLABLE wp::float32 beyond_0(
    wp::float32 var_d,
    wp::float32 var_limit)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    wp::float32 var_1;
    bool var_2;
    wp::float32 var_3;
    wp::float32 var_4;
    //---------
    // forward
    // def beyond(d, limit):                                                                  <L 1>
    // result = float(0.0)                                                                    <L 2>
    var_1 = wp::float(var_0);
    // if d > limit:                                                                          <L 3>
    var_2 = (var_d > var_limit);
    if (var_2) {
        // result = d                                                                         <L 4>
        var_3 = wp::copy(var_d);
    }
    var_4 = wp::where(var_2, var_3, var_1);
    // return result                                                                          <L 5>
    return var_4;
}


// /work/main/src/pointloom/kernels/rgbd/pyramid.py:79
static CUDA_CALLABLE void adj_nearest_depth_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 var_c,
    wp::float32 var_d,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_c,
    wp::float32 & adj_d,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rgbd.moved_pixels.was_free>:1
static CUDA_CALLABLE void adj_was_free_0(
    wp::float32 var_u,
    wp::float32 var_v,
    wp::float32 var_d,
    wp::array_t<wp::float32> var_earlier__min_depth,
    wp::vec_t<4, wp::int32> var_earlier__size,
    wp::vec_t<4, wp::float32> var_earlier__lens,
    wp::vec_t<3, wp::float32> var_earlier__along_u,
    wp::vec_t<3, wp::float32> var_earlier__along_v,
    wp::vec_t<3, wp::float32> var_earlier__ray,
    wp::vec_t<3, wp::float32> var_earlier__start,
    wp::float32 & adj_u,
    wp::float32 & adj_v,
    wp::float32 & adj_d,
    wp::array_t<wp::float32> & adj_earlier__min_depth,
    wp::vec_t<4, wp::int32> & adj_earlier__size,
    wp::vec_t<4, wp::float32> & adj_earlier__lens,
    wp::vec_t<3, wp::float32> & adj_earlier__along_u,
    wp::vec_t<3, wp::float32> & adj_earlier__along_v,
    wp::vec_t<3, wp::float32> & adj_earlier__ray,
    wp::vec_t<3, wp::float32> & adj_earlier__start,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rgbd.moved_pixels.beyond>:1
static CUDA_CALLABLE void adj_beyond_0(
    wp::float32 var_d,
    wp::float32 var_limit,
    wp::float32 & adj_d,
    wp::float32 & adj_limit,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void find_min_depth_kernel_113cd70d_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<4, wp::int32>> var_levels__layout,
    wp::array_t<wp::float32> var_levels__depth,
    wp::array_t<wp::float32> var_min_depth)
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
        wp::vec_t<4, wp::int32>* var_2;
        wp::vec_t<4, wp::int32> var_3;
        wp::vec_t<4, wp::int32> var_4;
        const wp::int32 var_5 = 0;
        wp::int32 var_6;
        wp::int32 var_7;
        const wp::int32 var_8 = 0;
        wp::int32 var_9;
        wp::int32 var_10;
        const wp::float32 var_11 = 0.0;
        wp::float32 var_12;
        bool var_13;
        const wp::int32 var_14 = 0;
        bool var_15;
        const wp::int32 var_16 = 0;
        bool var_17;
        const wp::int32 var_18 = 0;
        wp::int32 var_19;
        const wp::int32 var_20 = 1;
        wp::int32 var_21;
        bool var_22;
        const wp::int32 var_23 = 1;
        wp::int32 var_24;
        const wp::int32 var_25 = 1;
        wp::int32 var_26;
        bool var_27;
        const wp::float32 var_28 = 1e+30;
        wp::float32 var_29;
        const wp::int32 var_30 = 0;
        const wp::int32 var_31 = 3;
        wp::int32 var_32;
        const wp::int32 var_33 = 1;
        wp::int32 var_34;
        const wp::int32 var_35 = 0;
        wp::int32 var_36;
        wp::int32 var_37;
        wp::int32 var_38;
        const wp::int32 var_39 = 3;
        wp::int32 var_40;
        wp::int32 var_41;
        const wp::int32 var_42 = 1;
        wp::int32 var_43;
        wp::float32* var_44;
        wp::float32 var_45;
        wp::float32 var_46;
        const wp::int32 var_47 = 1;
        const wp::int32 var_48 = 3;
        wp::int32 var_49;
        const wp::int32 var_50 = 1;
        wp::int32 var_51;
        const wp::int32 var_52 = 0;
        wp::int32 var_53;
        wp::int32 var_54;
        wp::int32 var_55;
        const wp::int32 var_56 = 3;
        wp::int32 var_57;
        wp::int32 var_58;
        const wp::int32 var_59 = 1;
        wp::int32 var_60;
        wp::float32* var_61;
        wp::float32 var_62;
        wp::float32 var_63;
        const wp::int32 var_64 = 2;
        const wp::int32 var_65 = 3;
        wp::int32 var_66;
        const wp::int32 var_67 = 1;
        wp::int32 var_68;
        const wp::int32 var_69 = 0;
        wp::int32 var_70;
        wp::int32 var_71;
        wp::int32 var_72;
        const wp::int32 var_73 = 3;
        wp::int32 var_74;
        wp::int32 var_75;
        const wp::int32 var_76 = 1;
        wp::int32 var_77;
        wp::float32* var_78;
        wp::float32 var_79;
        wp::float32 var_80;
        const wp::int32 var_81 = 3;
        const wp::int32 var_82 = 3;
        wp::int32 var_83;
        const wp::int32 var_84 = 1;
        wp::int32 var_85;
        const wp::int32 var_86 = 0;
        wp::int32 var_87;
        wp::int32 var_88;
        wp::int32 var_89;
        const wp::int32 var_90 = 3;
        wp::int32 var_91;
        wp::int32 var_92;
        const wp::int32 var_93 = 1;
        wp::int32 var_94;
        wp::float32* var_95;
        wp::float32 var_96;
        wp::float32 var_97;
        const wp::int32 var_98 = 4;
        const wp::int32 var_99 = 3;
        wp::int32 var_100;
        const wp::int32 var_101 = 1;
        wp::int32 var_102;
        const wp::int32 var_103 = 0;
        wp::int32 var_104;
        wp::int32 var_105;
        wp::int32 var_106;
        const wp::int32 var_107 = 3;
        wp::int32 var_108;
        wp::int32 var_109;
        const wp::int32 var_110 = 1;
        wp::int32 var_111;
        wp::float32* var_112;
        wp::float32 var_113;
        wp::float32 var_114;
        const wp::int32 var_115 = 5;
        const wp::int32 var_116 = 3;
        wp::int32 var_117;
        const wp::int32 var_118 = 1;
        wp::int32 var_119;
        const wp::int32 var_120 = 0;
        wp::int32 var_121;
        wp::int32 var_122;
        wp::int32 var_123;
        const wp::int32 var_124 = 3;
        wp::int32 var_125;
        wp::int32 var_126;
        const wp::int32 var_127 = 1;
        wp::int32 var_128;
        wp::float32* var_129;
        wp::float32 var_130;
        wp::float32 var_131;
        const wp::int32 var_132 = 6;
        const wp::int32 var_133 = 3;
        wp::int32 var_134;
        const wp::int32 var_135 = 1;
        wp::int32 var_136;
        const wp::int32 var_137 = 0;
        wp::int32 var_138;
        wp::int32 var_139;
        wp::int32 var_140;
        const wp::int32 var_141 = 3;
        wp::int32 var_142;
        wp::int32 var_143;
        const wp::int32 var_144 = 1;
        wp::int32 var_145;
        wp::float32* var_146;
        wp::float32 var_147;
        wp::float32 var_148;
        const wp::int32 var_149 = 7;
        const wp::int32 var_150 = 3;
        wp::int32 var_151;
        const wp::int32 var_152 = 1;
        wp::int32 var_153;
        const wp::int32 var_154 = 0;
        wp::int32 var_155;
        wp::int32 var_156;
        wp::int32 var_157;
        const wp::int32 var_158 = 3;
        wp::int32 var_159;
        wp::int32 var_160;
        const wp::int32 var_161 = 1;
        wp::int32 var_162;
        wp::float32* var_163;
        wp::float32 var_164;
        wp::float32 var_165;
        const wp::int32 var_166 = 8;
        const wp::int32 var_167 = 3;
        wp::int32 var_168;
        const wp::int32 var_169 = 1;
        wp::int32 var_170;
        const wp::int32 var_171 = 0;
        wp::int32 var_172;
        wp::int32 var_173;
        wp::int32 var_174;
        const wp::int32 var_175 = 3;
        wp::int32 var_176;
        wp::int32 var_177;
        const wp::int32 var_178 = 1;
        wp::int32 var_179;
        wp::float32* var_180;
        wp::float32 var_181;
        wp::float32 var_182;
        wp::float32 var_183;
        //---------
        // forward
        // def find_min_depth_kernel(levels__layout, levels__depth, min_depth):                   <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // size = levels__layout[0]                                                               <L 4>
        var_2 = wp::address(var_levels__layout, var_1);
        var_4 = wp::load(var_2);
        var_3 = wp::copy(var_4);
        // u = i % size[0]                                                                        <L 5>
        var_6 = wp::extract(var_3, var_5);
        var_7 = wp::mod(var_0, var_6);
        // v = i // size[0]                                                                       <L 6>
        var_9 = wp::extract(var_3, var_8);
        var_10 = wp::floordiv(var_0, var_9);
        // minimum = float(0.0)                                                                   <L 7>
        var_12 = wp::float(var_11);
        // if u > 0 and v > 0 and (u < size[0] - 1) and (v < size[1] - 1):                        <L 8>
        var_15 = (var_7 > var_14);
        var_13 = var_15;
        if (var_13) {
            var_17 = (var_10 > var_16);
            var_13 = var_13 && var_17;
        }
        if (var_13) {
            var_19 = wp::extract(var_3, var_18);
            var_21 = wp::sub(var_19, var_20);
            var_22 = (var_7 < var_21);
            var_13 = var_13 && var_22;
        }
        if (var_13) {
            var_24 = wp::extract(var_3, var_23);
            var_26 = wp::sub(var_24, var_25);
            var_27 = (var_10 < var_26);
            var_13 = var_13 && var_27;
        }
        if (var_13) {
            // minimum = float(1e+30)                                                             <L 9>
            var_29 = wp::float(var_28);
            // for k in range(9):                                                                 <L 10>
            // minimum = min(minimum, levels__depth[i + (k // 3 - 1) * size[0] + k % 3 - 1])       <L 11>
            var_32 = wp::floordiv(var_30, var_31);
            var_34 = wp::sub(var_32, var_33);
            var_36 = wp::extract(var_3, var_35);
            var_37 = wp::mul(var_34, var_36);
            var_38 = wp::add(var_0, var_37);
            var_40 = wp::mod(var_30, var_39);
            var_41 = wp::add(var_38, var_40);
            var_43 = wp::sub(var_41, var_42);
            var_44 = wp::address(var_levels__depth, var_43);
            var_46 = wp::load(var_44);
            var_45 = wp::min(var_29, var_46);
            var_49 = wp::floordiv(var_47, var_48);
            var_51 = wp::sub(var_49, var_50);
            var_53 = wp::extract(var_3, var_52);
            var_54 = wp::mul(var_51, var_53);
            var_55 = wp::add(var_0, var_54);
            var_57 = wp::mod(var_47, var_56);
            var_58 = wp::add(var_55, var_57);
            var_60 = wp::sub(var_58, var_59);
            var_61 = wp::address(var_levels__depth, var_60);
            var_63 = wp::load(var_61);
            var_62 = wp::min(var_45, var_63);
            var_66 = wp::floordiv(var_64, var_65);
            var_68 = wp::sub(var_66, var_67);
            var_70 = wp::extract(var_3, var_69);
            var_71 = wp::mul(var_68, var_70);
            var_72 = wp::add(var_0, var_71);
            var_74 = wp::mod(var_64, var_73);
            var_75 = wp::add(var_72, var_74);
            var_77 = wp::sub(var_75, var_76);
            var_78 = wp::address(var_levels__depth, var_77);
            var_80 = wp::load(var_78);
            var_79 = wp::min(var_62, var_80);
            var_83 = wp::floordiv(var_81, var_82);
            var_85 = wp::sub(var_83, var_84);
            var_87 = wp::extract(var_3, var_86);
            var_88 = wp::mul(var_85, var_87);
            var_89 = wp::add(var_0, var_88);
            var_91 = wp::mod(var_81, var_90);
            var_92 = wp::add(var_89, var_91);
            var_94 = wp::sub(var_92, var_93);
            var_95 = wp::address(var_levels__depth, var_94);
            var_97 = wp::load(var_95);
            var_96 = wp::min(var_79, var_97);
            var_100 = wp::floordiv(var_98, var_99);
            var_102 = wp::sub(var_100, var_101);
            var_104 = wp::extract(var_3, var_103);
            var_105 = wp::mul(var_102, var_104);
            var_106 = wp::add(var_0, var_105);
            var_108 = wp::mod(var_98, var_107);
            var_109 = wp::add(var_106, var_108);
            var_111 = wp::sub(var_109, var_110);
            var_112 = wp::address(var_levels__depth, var_111);
            var_114 = wp::load(var_112);
            var_113 = wp::min(var_96, var_114);
            var_117 = wp::floordiv(var_115, var_116);
            var_119 = wp::sub(var_117, var_118);
            var_121 = wp::extract(var_3, var_120);
            var_122 = wp::mul(var_119, var_121);
            var_123 = wp::add(var_0, var_122);
            var_125 = wp::mod(var_115, var_124);
            var_126 = wp::add(var_123, var_125);
            var_128 = wp::sub(var_126, var_127);
            var_129 = wp::address(var_levels__depth, var_128);
            var_131 = wp::load(var_129);
            var_130 = wp::min(var_113, var_131);
            var_134 = wp::floordiv(var_132, var_133);
            var_136 = wp::sub(var_134, var_135);
            var_138 = wp::extract(var_3, var_137);
            var_139 = wp::mul(var_136, var_138);
            var_140 = wp::add(var_0, var_139);
            var_142 = wp::mod(var_132, var_141);
            var_143 = wp::add(var_140, var_142);
            var_145 = wp::sub(var_143, var_144);
            var_146 = wp::address(var_levels__depth, var_145);
            var_148 = wp::load(var_146);
            var_147 = wp::min(var_130, var_148);
            var_151 = wp::floordiv(var_149, var_150);
            var_153 = wp::sub(var_151, var_152);
            var_155 = wp::extract(var_3, var_154);
            var_156 = wp::mul(var_153, var_155);
            var_157 = wp::add(var_0, var_156);
            var_159 = wp::mod(var_149, var_158);
            var_160 = wp::add(var_157, var_159);
            var_162 = wp::sub(var_160, var_161);
            var_163 = wp::address(var_levels__depth, var_162);
            var_165 = wp::load(var_163);
            var_164 = wp::min(var_147, var_165);
            var_168 = wp::floordiv(var_166, var_167);
            var_170 = wp::sub(var_168, var_169);
            var_172 = wp::extract(var_3, var_171);
            var_173 = wp::mul(var_170, var_172);
            var_174 = wp::add(var_0, var_173);
            var_176 = wp::mod(var_166, var_175);
            var_177 = wp::add(var_174, var_176);
            var_179 = wp::sub(var_177, var_178);
            var_180 = wp::address(var_levels__depth, var_179);
            var_182 = wp::load(var_180);
            var_181 = wp::min(var_164, var_182);
        }
        var_183 = wp::where(var_13, var_181, var_12);
        // min_depth[i] = minimum                                                                 <L 12>
        wp::array_store(var_min_depth, var_0, var_183);
}



extern "C" __global__ void hide_moved_kernel_bca3c91a_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_depth,
    wp::int32 var_width,
    wp::int32 var_height,
    wp::int32 var_side,
    wp::array_t<wp::float32> var_first__min_depth,
    wp::vec_t<4, wp::int32> var_first__size,
    wp::vec_t<4, wp::float32> var_first__lens,
    wp::vec_t<3, wp::float32> var_first__along_u,
    wp::vec_t<3, wp::float32> var_first__along_v,
    wp::vec_t<3, wp::float32> var_first__ray,
    wp::vec_t<3, wp::float32> var_first__start,
    wp::array_t<wp::float32> var_second__min_depth,
    wp::vec_t<4, wp::int32> var_second__size,
    wp::vec_t<4, wp::float32> var_second__lens,
    wp::vec_t<3, wp::float32> var_second__along_u,
    wp::vec_t<3, wp::float32> var_second__along_v,
    wp::vec_t<3, wp::float32> var_second__ray,
    wp::vec_t<3, wp::float32> var_second__start,
    wp::array_t<wp::float32> var_remaining)
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
        const wp::int32 var_2 = 1;
        wp::int32 var_3;
        wp::int32 var_4;
        wp::int32 var_5;
        wp::int32 var_6;
        wp::int32 var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        wp::int32 var_10;
        const wp::int32 var_11 = 1;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int32 var_14;
        const wp::int32 var_15 = 1;
        wp::int32 var_16;
        wp::int32 var_17;
        wp::int32 var_18;
        wp::float32* var_19;
        wp::float32 var_20;
        wp::float32 var_21;
        wp::int32 var_22;
        wp::int32 var_23;
        wp::float32* var_24;
        wp::float32 var_25;
        wp::float32 var_26;
        wp::int32 var_27;
        wp::int32 var_28;
        wp::float32* var_29;
        wp::float32 var_30;
        wp::float32 var_31;
        wp::int32 var_32;
        wp::int32 var_33;
        wp::float32* var_34;
        wp::float32 var_35;
        wp::float32 var_36;
        wp::float32 var_37;
        const wp::float32 var_38 = 0.0;
        wp::float32 var_39;
        const wp::float32 var_40 = 1e+30;
        bool var_41;
        wp::float32 var_42;
        const wp::float32 var_43 = 0.5;
        const wp::int32 var_44 = 1;
        wp::int32 var_45;
        wp::float32 var_46;
        wp::float32 var_47;
        wp::float32 var_48;
        wp::float32 var_49;
        const wp::float32 var_50 = 0.5;
        const wp::int32 var_51 = 1;
        wp::int32 var_52;
        wp::float32 var_53;
        wp::float32 var_54;
        wp::float32 var_55;
        wp::int32 var_56;
        const wp::int32 var_57 = 0;
        bool var_58;
        wp::int32 var_59;
        wp::int32 var_60;
        const wp::int32 var_61 = 1;
        bool var_62;
        const wp::float32 var_63 = 1.0;
        const wp::float32 var_64 = 0.04;
        wp::float32 var_65;
        wp::float32 var_66;
        wp::float32 var_67;
        wp::float32 var_68;
        wp::float32 var_69;
        wp::int32 var_70;
        wp::int32 var_71;
        wp::float32 var_72;
        wp::int32 var_73;
        wp::int32 var_74;
        wp::float32 var_75;
        wp::int32 var_76;
        wp::int32 var_77;
        wp::float32 var_78;
        wp::int32 var_79;
        wp::int32 var_80;
        //---------
        // forward
        // def hide_moved_kernel(depth, width, height, side, first__min_depth, first__size, first__lens, first__along_u, first__along_v, first__ray, first__start, second__min_depth, second__size, second__lens, second__along_u, second__along_v, second__ray, second__start, remaining):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // columns = (width + side - 1) // side                                                   <L 4>
        var_1 = wp::add(var_width, var_side);
        var_3 = wp::sub(var_1, var_2);
        var_4 = wp::floordiv(var_3, var_side);
        // u = i % columns * side                                                                 <L 5>
        var_5 = wp::mod(var_0, var_4);
        var_6 = wp::mul(var_5, var_side);
        // v = i // columns * side                                                                <L 6>
        var_7 = wp::floordiv(var_0, var_4);
        var_8 = wp::mul(var_7, var_side);
        // right = min(u + side, width) - 1                                                       <L 7>
        var_9 = wp::add(var_6, var_side);
        var_10 = wp::min(var_9, var_width);
        var_12 = wp::sub(var_10, var_11);
        // below = min(v + side, height) - 1                                                      <L 8>
        var_13 = wp::add(var_8, var_side);
        var_14 = wp::min(var_13, var_height);
        var_16 = wp::sub(var_14, var_15);
        // a = depth[v * width + u]                                                               <L 9>
        var_17 = wp::mul(var_8, var_width);
        var_18 = wp::add(var_17, var_6);
        var_19 = wp::address(var_depth, var_18);
        var_21 = wp::load(var_19);
        var_20 = wp::copy(var_21);
        // b = depth[v * width + right]                                                           <L 10>
        var_22 = wp::mul(var_8, var_width);
        var_23 = wp::add(var_22, var_12);
        var_24 = wp::address(var_depth, var_23);
        var_26 = wp::load(var_24);
        var_25 = wp::copy(var_26);
        // c = depth[below * width + u]                                                           <L 11>
        var_27 = wp::mul(var_16, var_width);
        var_28 = wp::add(var_27, var_6);
        var_29 = wp::address(var_depth, var_28);
        var_31 = wp::load(var_29);
        var_30 = wp::copy(var_31);
        // d = depth[below * width + right]                                                       <L 12>
        var_32 = wp::mul(var_16, var_width);
        var_33 = wp::add(var_32, var_12);
        var_34 = wp::address(var_depth, var_33);
        var_36 = wp::load(var_34);
        var_35 = wp::copy(var_36);
        // near = nearest_depth(a, b, c, d)                                                       <L 13>
        var_37 = nearest_depth_0(var_20, var_25, var_30, var_35);
        // limit = float(0.0)                                                                     <L 14>
        var_39 = wp::float(var_38);
        // if near < NO_DEPTH:                                                                    <L 15>
        var_41 = (var_37 < var_40);
        if (var_41) {
            // x = float(u) + 0.5 * float(side - 1)                                               <L 16>
            var_42 = wp::float(var_6);
            var_45 = wp::sub(var_side, var_44);
            var_46 = wp::float(var_45);
            var_47 = wp::mul(var_43, var_46);
            var_48 = wp::add(var_42, var_47);
            // y = float(v) + 0.5 * float(side - 1)                                               <L 17>
            var_49 = wp::float(var_8);
            var_52 = wp::sub(var_side, var_51);
            var_53 = wp::float(var_52);
            var_54 = wp::mul(var_50, var_53);
            var_55 = wp::add(var_49, var_54);
            // moved = was_free(x, y, near, first__min_depth, first__size, first__lens, first__along_u, first__along_v, first__ray, first__start)       <L 18>
            var_56 = was_free_0(var_48, var_55, var_37, var_first__min_depth, var_first__size, var_first__lens, var_first__along_u, var_first__along_v, var_first__ray, var_first__start);
            // if moved == 0:                                                                     <L 19>
            var_58 = (var_56 == var_57);
            if (var_58) {
                // moved = was_free(x, y, near, second__min_depth, second__size, second__lens, second__along_u, second__along_v, second__ray, second__start)       <L 20>
                var_59 = was_free_0(var_48, var_55, var_37, var_second__min_depth, var_second__size, var_second__lens, var_second__along_u, var_second__along_v, var_second__ray, var_second__start);
            }
            var_60 = wp::where(var_58, var_59, var_56);
            // if moved == 1:                                                                     <L 21>
            var_62 = (var_60 == var_61);
            if (var_62) {
                // limit = near * (1.0 + SAME_SURFACE)                                            <L 22>
                var_65 = wp::add(var_63, var_64);
                var_66 = wp::mul(var_37, var_65);
            }
            var_67 = wp::where(var_62, var_66, var_39);
        }
        var_68 = wp::where(var_41, var_67, var_39);
        // remaining[v * width + u] = beyond(a, limit)                                            <L 23>
        var_69 = beyond_0(var_20, var_68);
        var_70 = wp::mul(var_8, var_width);
        var_71 = wp::add(var_70, var_6);
        wp::array_store(var_remaining, var_71, var_69);
        // remaining[v * width + right] = beyond(b, limit)                                        <L 24>
        var_72 = beyond_0(var_25, var_68);
        var_73 = wp::mul(var_8, var_width);
        var_74 = wp::add(var_73, var_12);
        wp::array_store(var_remaining, var_74, var_72);
        // remaining[below * width + u] = beyond(c, limit)                                        <L 25>
        var_75 = beyond_0(var_30, var_68);
        var_76 = wp::mul(var_16, var_width);
        var_77 = wp::add(var_76, var_6);
        wp::array_store(var_remaining, var_77, var_75);
        // remaining[below * width + right] = beyond(d, limit)                                    <L 26>
        var_78 = beyond_0(var_35, var_68);
        var_79 = wp::mul(var_16, var_width);
        var_80 = wp::add(var_79, var_12);
        wp::array_store(var_remaining, var_80, var_78);
}


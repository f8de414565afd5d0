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


// <pointloom.kernels.segmentation.patch_growth.fits_patch>:1
static CUDA_CALLABLE wp::int32 fits_patch_0(
    wp::int32 var_i,
    wp::int32 var_patch,
    wp::float32 var_similar,
    wp::float32 var_near,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cloud__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cloud__normals,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__centers,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__directions)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32>* var_0;
    wp::vec_t<3, wp::float32> var_1;
    wp::vec_t<3, wp::float32> var_2;
    wp::vec_t<3, wp::float32>* var_3;
    wp::vec_t<3, wp::float32>* var_4;
    wp::vec_t<3, wp::float32> var_5;
    wp::vec_t<3, wp::float32> var_6;
    wp::vec_t<3, wp::float32> var_7;
    wp::float32 var_8;
    wp::float32 var_9;
    wp::vec_t<3, wp::float32>* var_10;
    wp::float32 var_11;
    wp::vec_t<3, wp::float32> var_12;
    wp::float32 var_13;
    const wp::int32 var_14 = 0;
    wp::int32 var_15;
    bool var_16;
    bool var_17;
    bool var_18;
    bool var_19;
    const wp::int32 var_20 = 1;
    wp::int32 var_21;
    //---------
    // forward
    // def fits_patch(i, patch, similar, near, cloud__points, cloud__normals, planes__centers, planes__directions):       <L 1>
    // direction = planes__directions[patch]                                                  <L 3>
    var_0 = wp::address(var_planes__directions, var_patch);
    var_2 = wp::load(var_0);
    var_1 = wp::copy(var_2);
    // distance = abs(dot(direction, cloud__points[i] - planes__centers[patch]))              <L 4>
    var_3 = wp::address(var_cloud__points, var_i);
    var_4 = wp::address(var_planes__centers, var_patch);
    var_6 = wp::load(var_3);
    var_7 = wp::load(var_4);
    var_5 = wp::sub(var_6, var_7);
    var_8 = wp::dot(var_1, var_5);
    var_9 = wp::abs(var_8);
    // cosine = abs(dot(direction, cloud__normals[i]))                                        <L 5>
    var_10 = wp::address(var_cloud__normals, var_i);
    var_12 = wp::load(var_10);
    var_11 = wp::dot(var_1, var_12);
    var_13 = wp::abs(var_11);
    // inside = int(0)                                                                        <L 6>
    var_15 = wp::int(var_14);
    // if isfinite(cosine) and cosine > similar and (distance < near):                        <L 7>
    var_17 = wp::isfinite(var_13);
    var_16 = var_17;
    if (var_16) {
        var_18 = (var_13 > var_similar);
        var_16 = var_16 && var_18;
    }
    if (var_16) {
        var_19 = (var_9 < var_near);
        var_16 = var_16 && var_19;
    }
    if (var_16) {
        // inside = 1                                                                         <L 8>
    }
    var_21 = wp::where(var_16, var_20, var_15);
    // return inside                                                                          <L 9>
    return var_21;
}


// <pointloom.kernels.segmentation.patch_growth.fits_patch>:1
static CUDA_CALLABLE void adj_fits_patch_0(
    wp::int32 var_i,
    wp::int32 var_patch,
    wp::float32 var_similar,
    wp::float32 var_near,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cloud__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cloud__normals,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__centers,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__directions,
    wp::int32 & adj_i,
    wp::int32 & adj_patch,
    wp::float32 & adj_similar,
    wp::float32 & adj_near,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_cloud__points,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_cloud__normals,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_planes__centers,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_planes__directions,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void order_counts_kernel_0f327aee_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_counts,
    wp::array_t<wp::int64> var_keys)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 2147483647;
        wp::int32* var_2;
        wp::int32 var_3;
        wp::int32 var_4;
        wp::int64 var_5;
        //---------
        // forward
        // def order_counts_kernel(counts: array(dtype=int32), keys: array(dtype=int64)):         <L 279>
        // i = tid()                                                                              <L 280>
        var_0 = builtin_tid1d();
        // keys[i] = int64(NO_OFFER - counts[i])                                                  <L 281>
        var_2 = wp::address(var_counts, var_0);
        var_4 = wp::load(var_2);
        var_3 = wp::sub(var_1, var_4);
        var_5 = wp::int64(var_3);
        wp::array_store(var_keys, var_0, var_5);
}



extern "C" __global__ void measure_boxes_kernel_10f9ec1f_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::int32> var_rows,
    wp::array_t<wp::int32> var_starts,
    wp::array_t<wp::vec_t<3, wp::float32>> var_centers,
    wp::array_t<wp::vec_t<3, wp::float32>> var_axes,
    wp::int32 var_directions,
    wp::array_t<wp::float32> var_lows,
    wp::array_t<wp::float32> var_highs)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 32;
        wp::int32 var_2;
        wp::int32 var_3;
        wp::int32 var_4;
        wp::int32* var_5;
        wp::int32 var_6;
        wp::int32 var_7;
        const wp::int32 var_8 = 1;
        wp::int32 var_9;
        wp::int32* var_10;
        wp::int32 var_11;
        wp::int32 var_12;
        wp::int32 var_13;
        const wp::int32 var_14 = 1;
        wp::int32 var_15;
        wp::int32 var_16;
        const wp::int32 var_17 = 0;
        const wp::int32 var_18 = 3;
        wp::int32 var_19;
        wp::int32 var_20;
        wp::vec_t<3, wp::float32>* var_21;
        wp::vec_t<3, wp::float32> var_22;
        wp::vec_t<3, wp::float32> var_23;
        const wp::float32 var_24 = INFINITY;
        wp::float32 var_25;
        wp::float32 var_26;
        wp::float32 var_27;
        wp::int32 var_28;
        wp::int32 var_29;
        wp::int32 var_30;
        const wp::int32 var_31 = 1;
        wp::int32 var_32;
        wp::int32 var_33;
        wp::int32 var_34;
        wp::int32 var_35;
        wp::range_t var_36;
        wp::int32 var_37;
        wp::int32* var_38;
        wp::int32 var_39;
        wp::vec_t<3, wp::float32>* var_40;
        wp::vec_t<3, wp::float32>* var_41;
        wp::vec_t<3, wp::float32> var_42;
        wp::vec_t<3, wp::float32> var_43;
        wp::vec_t<3, wp::float32> var_44;
        wp::float32 var_45;
        wp::float32 var_46;
        wp::float32 var_47;
        const wp::int32 var_48 = 3;
        wp::int32 var_49;
        wp::int32 var_50;
        wp::float32 var_51;
        const wp::int32 var_52 = 3;
        wp::int32 var_53;
        wp::int32 var_54;
        wp::float32 var_55;
        const wp::int32 var_56 = 1;
        const wp::int32 var_57 = 3;
        wp::int32 var_58;
        wp::int32 var_59;
        wp::vec_t<3, wp::float32>* var_60;
        wp::vec_t<3, wp::float32> var_61;
        wp::vec_t<3, wp::float32> var_62;
        wp::float32 var_63;
        wp::float32 var_64;
        wp::float32 var_65;
        wp::int32 var_66;
        wp::int32 var_67;
        wp::int32 var_68;
        const wp::int32 var_69 = 1;
        wp::int32 var_70;
        wp::int32 var_71;
        wp::int32 var_72;
        wp::int32 var_73;
        wp::range_t var_74;
        wp::int32 var_75;
        wp::int32* var_76;
        wp::int32 var_77;
        wp::vec_t<3, wp::float32>* var_78;
        wp::vec_t<3, wp::float32>* var_79;
        wp::vec_t<3, wp::float32> var_80;
        wp::vec_t<3, wp::float32> var_81;
        wp::vec_t<3, wp::float32> var_82;
        wp::float32 var_83;
        wp::float32 var_84;
        wp::float32 var_85;
        const wp::int32 var_86 = 3;
        wp::int32 var_87;
        wp::int32 var_88;
        wp::float32 var_89;
        const wp::int32 var_90 = 3;
        wp::int32 var_91;
        wp::int32 var_92;
        wp::float32 var_93;
        const wp::int32 var_94 = 2;
        const wp::int32 var_95 = 3;
        wp::int32 var_96;
        wp::int32 var_97;
        wp::vec_t<3, wp::float32>* var_98;
        wp::vec_t<3, wp::float32> var_99;
        wp::vec_t<3, wp::float32> var_100;
        wp::float32 var_101;
        wp::float32 var_102;
        wp::float32 var_103;
        wp::int32 var_104;
        wp::int32 var_105;
        wp::int32 var_106;
        const wp::int32 var_107 = 1;
        wp::int32 var_108;
        wp::int32 var_109;
        wp::int32 var_110;
        wp::int32 var_111;
        wp::range_t var_112;
        wp::int32 var_113;
        wp::int32* var_114;
        wp::int32 var_115;
        wp::vec_t<3, wp::float32>* var_116;
        wp::vec_t<3, wp::float32>* var_117;
        wp::vec_t<3, wp::float32> var_118;
        wp::vec_t<3, wp::float32> var_119;
        wp::vec_t<3, wp::float32> var_120;
        wp::float32 var_121;
        wp::float32 var_122;
        wp::float32 var_123;
        const wp::int32 var_124 = 3;
        wp::int32 var_125;
        wp::int32 var_126;
        wp::float32 var_127;
        const wp::int32 var_128 = 3;
        wp::int32 var_129;
        wp::int32 var_130;
        wp::float32 var_131;
        //---------
        // forward
        // def measure_boxes_kernel(                                                              <L 51>
        // i = tid()                                                                              <L 62>
        var_0 = builtin_tid1d();
        // box = i // SLICES                                                                      <L 63>
        var_2 = wp::floordiv(var_0, var_1);
        // part = i % SLICES                                                                      <L 64>
        var_3 = wp::mod(var_0, var_1);
        // patch = box // directions                                                              <L 65>
        var_4 = wp::floordiv(var_2, var_directions);
        // first = starts[patch]                                                                  <L 66>
        var_5 = wp::address(var_starts, var_4);
        var_7 = wp::load(var_5);
        var_6 = wp::copy(var_7);
        // size = starts[patch + 1] - first                                                       <L 67>
        var_9 = wp::add(var_4, var_8);
        var_10 = wp::address(var_starts, var_9);
        var_12 = wp::load(var_10);
        var_11 = wp::sub(var_12, var_6);
        // per_slice = (size + SLICES - 1) // SLICES                                              <L 68>
        var_13 = wp::add(var_11, var_1);
        var_15 = wp::sub(var_13, var_14);
        var_16 = wp::floordiv(var_15, var_1);
        // for axis in range(3):                                                                  <L 69>
        // side = axes[3 * box + axis]                                                            <L 70>
        var_19 = wp::mul(var_18, var_2);
        var_20 = wp::add(var_19, var_17);
        var_21 = wp::address(var_axes, var_20);
        var_23 = wp::load(var_21);
        var_22 = wp::copy(var_23);
        // low = float(INFINITY)                                                                  <L 71>
        var_25 = wp::float(var_24);
        // high = -float(INFINITY)                                                                <L 72>
        var_26 = wp::float(var_24);
        var_27 = wp::neg(var_26);
        // for j in range(first + min(part * per_slice, size), first + min((part + 1) * per_slice, size)):       <L 73>
        var_28 = wp::mul(var_3, var_16);
        var_29 = wp::min(var_28, var_11);
        var_30 = wp::add(var_6, var_29);
        var_32 = wp::add(var_3, var_31);
        var_33 = wp::mul(var_32, var_16);
        var_34 = wp::min(var_33, var_11);
        var_35 = wp::add(var_6, var_34);
        var_36 = wp::range(var_30, var_35);
        start_for_0:;
            if (iter_cmp(var_36) == 0) goto end_for_0;
            var_37 = wp::iter_next(var_36);
            // along = dot(side, points[rows[j]] - centers[patch])                                <L 74>
            var_38 = wp::address(var_rows, var_37);
            var_39 = wp::load(var_38);
            var_40 = wp::address(var_points, var_39);
            var_41 = wp::address(var_centers, var_4);
            var_43 = wp::load(var_40);
            var_44 = wp::load(var_41);
            var_42 = wp::sub(var_43, var_44);
            var_45 = wp::dot(var_22, var_42);
            // low = min(low, along)                                                              <L 75>
            var_46 = wp::min(var_25, var_45);
            // high = max(high, along)                                                            <L 76>
            var_47 = wp::max(var_27, var_45);
            wp::assign(var_25, var_46);
            wp::assign(var_27, var_47);
            goto start_for_0;
        end_for_0:;
        // atomic_min(lows, 3 * box + axis, low)                                                  <L 77>
        var_49 = wp::mul(var_48, var_2);
        var_50 = wp::add(var_49, var_17);
        var_51 = wp::atomic_min(var_lows, var_50, var_25);
        // atomic_max(highs, 3 * box + axis, high)                                                <L 78>
        var_53 = wp::mul(var_52, var_2);
        var_54 = wp::add(var_53, var_17);
        var_55 = wp::atomic_max(var_highs, var_54, var_27);
        // side = axes[3 * box + axis]                                                            <L 70>
        var_58 = wp::mul(var_57, var_2);
        var_59 = wp::add(var_58, var_56);
        var_60 = wp::address(var_axes, var_59);
        var_62 = wp::load(var_60);
        var_61 = wp::copy(var_62);
        // low = float(INFINITY)                                                                  <L 71>
        var_63 = wp::float(var_24);
        // high = -float(INFINITY)                                                                <L 72>
        var_64 = wp::float(var_24);
        var_65 = wp::neg(var_64);
        // for j in range(first + min(part * per_slice, size), first + min((part + 1) * per_slice, size)):       <L 73>
        var_66 = wp::mul(var_3, var_16);
        var_67 = wp::min(var_66, var_11);
        var_68 = wp::add(var_6, var_67);
        var_70 = wp::add(var_3, var_69);
        var_71 = wp::mul(var_70, var_16);
        var_72 = wp::min(var_71, var_11);
        var_73 = wp::add(var_6, var_72);
        var_74 = wp::range(var_68, var_73);
        start_for_2:;
            if (iter_cmp(var_74) == 0) goto end_for_2;
            var_75 = wp::iter_next(var_74);
            // along = dot(side, points[rows[j]] - centers[patch])                                <L 74>
            var_76 = wp::address(var_rows, var_75);
            var_77 = wp::load(var_76);
            var_78 = wp::address(var_points, var_77);
            var_79 = wp::address(var_centers, var_4);
            var_81 = wp::load(var_78);
            var_82 = wp::load(var_79);
            var_80 = wp::sub(var_81, var_82);
            var_83 = wp::dot(var_61, var_80);
            // low = min(low, along)                                                              <L 75>
            var_84 = wp::min(var_63, var_83);
            // high = max(high, along)                                                            <L 76>
            var_85 = wp::max(var_65, var_83);
            wp::assign(var_63, var_84);
            wp::assign(var_65, var_85);
            wp::assign(var_45, var_83);
            goto start_for_2;
        end_for_2:;
        // atomic_min(lows, 3 * box + axis, low)                                                  <L 77>
        var_87 = wp::mul(var_86, var_2);
        var_88 = wp::add(var_87, var_56);
        var_89 = wp::atomic_min(var_lows, var_88, var_63);
        // atomic_max(highs, 3 * box + axis, high)                                                <L 78>
        var_91 = wp::mul(var_90, var_2);
        var_92 = wp::add(var_91, var_56);
        var_93 = wp::atomic_max(var_highs, var_92, var_65);
        // side = axes[3 * box + axis]                                                            <L 70>
        var_96 = wp::mul(var_95, var_2);
        var_97 = wp::add(var_96, var_94);
        var_98 = wp::address(var_axes, var_97);
        var_100 = wp::load(var_98);
        var_99 = wp::copy(var_100);
        // low = float(INFINITY)                                                                  <L 71>
        var_101 = wp::float(var_24);
        // high = -float(INFINITY)                                                                <L 72>
        var_102 = wp::float(var_24);
        var_103 = wp::neg(var_102);
        // for j in range(first + min(part * per_slice, size), first + min((part + 1) * per_slice, size)):       <L 73>
        var_104 = wp::mul(var_3, var_16);
        var_105 = wp::min(var_104, var_11);
        var_106 = wp::add(var_6, var_105);
        var_108 = wp::add(var_3, var_107);
        var_109 = wp::mul(var_108, var_16);
        var_110 = wp::min(var_109, var_11);
        var_111 = wp::add(var_6, var_110);
        var_112 = wp::range(var_106, var_111);
        start_for_4:;
            if (iter_cmp(var_112) == 0) goto end_for_4;
            var_113 = wp::iter_next(var_112);
            // along = dot(side, points[rows[j]] - centers[patch])                                <L 74>
            var_114 = wp::address(var_rows, var_113);
            var_115 = wp::load(var_114);
            var_116 = wp::address(var_points, var_115);
            var_117 = wp::address(var_centers, var_4);
            var_119 = wp::load(var_116);
            var_120 = wp::load(var_117);
            var_118 = wp::sub(var_119, var_120);
            var_121 = wp::dot(var_99, var_118);
            // low = min(low, along)                                                              <L 75>
            var_122 = wp::min(var_101, var_121);
            // high = max(high, along)                                                            <L 76>
            var_123 = wp::max(var_103, var_121);
            wp::assign(var_101, var_122);
            wp::assign(var_103, var_123);
            wp::assign(var_45, var_121);
            goto start_for_4;
        end_for_4:;
        // atomic_min(lows, 3 * box + axis, low)                                                  <L 77>
        var_125 = wp::mul(var_124, var_2);
        var_126 = wp::add(var_125, var_94);
        var_127 = wp::atomic_min(var_lows, var_126, var_101);
        // atomic_max(highs, 3 * box + axis, high)                                                <L 78>
        var_129 = wp::mul(var_128, var_2);
        var_130 = wp::add(var_129, var_94);
        var_131 = wp::atomic_max(var_highs, var_130, var_103);
}



extern "C" __global__ void mask_growing_kernel_1885f215_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_labels,
    wp::array_t<wp::int32> var_growing,
    wp::array_t<wp::uint8> var_mask)
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
        wp::int32 var_2;
        wp::int32* var_3;
        const wp::int32 var_4 = 0;
        bool var_5;
        wp::int32 var_6;
        wp::int32* var_7;
        wp::int32 var_8;
        wp::int32* var_9;
        wp::int32 var_10;
        wp::int32 var_11;
        wp::int32 var_12;
        wp::uint8 var_13;
        //---------
        // forward
        // def mask_growing_kernel(labels, growing, mask):                                        <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // inside = int(0)                                                                        <L 3>
        var_2 = wp::int(var_1);
        // if labels[i] >= 0:                                                                     <L 4>
        var_3 = wp::address(var_labels, var_0);
        var_6 = wp::load(var_3);
        var_5 = (var_6 >= var_4);
        if (var_5) {
            // inside = growing[labels[i]]                                                        <L 5>
            var_7 = wp::address(var_labels, var_0);
            var_8 = wp::load(var_7);
            var_9 = wp::address(var_growing, var_8);
            var_11 = wp::load(var_9);
            var_10 = wp::copy(var_11);
        }
        var_12 = wp::where(var_5, var_10, var_2);
        // mask[i] = uint8(inside)                                                                <L 6>
        var_13 = wp::uint8(var_12);
        wp::array_store(var_mask, var_0, var_13);
}



extern "C" __global__ void offer_patches_kernel_190eede9_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_frontier,
    wp::array_t<wp::uint8> var_mask,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cloud__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cloud__normals,
    wp::array_t<wp::int32> var_cloud__neighbors,
    wp::array_t<wp::int32> var_cloud__labels,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__centers,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__directions,
    wp::array_t<wp::float32> var_planes__similar,
    wp::array_t<wp::float32> var_planes__near,
    wp::array_t<wp::int32> var_ranks,
    wp::array_t<wp::int32> var_offers,
    wp::array_t<wp::int32> var_going)
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
        bool var_2;
        const wp::int32 var_3 = 0;
        const wp::int32 var_4 = 0;
        wp::int32* var_5;
        wp::int32 var_6;
        wp::int32 var_7;
        wp::uint8* var_8;
        const wp::int32 var_9 = 0;
        wp::uint8 var_10;
        bool var_11;
        wp::uint8 var_12;
        wp::int32* var_13;
        wp::int32 var_14;
        wp::int32 var_15;
        wp::vec_t<3, wp::float32>* var_16;
        wp::vec_t<3, wp::float32> var_17;
        wp::vec_t<3, wp::float32> var_18;
        wp::shape_t* var_19;
        const wp::int32 var_20 = 1;
        wp::int32 var_21;
        wp::shape_t var_22;
        wp::range_t var_23;
        wp::int32 var_24;
        wp::int32* var_25;
        wp::int32 var_26;
        wp::int32 var_27;
        const wp::int32 var_28 = 0;
        bool var_29;
        wp::int32* var_30;
        const wp::int32 var_31 = 0;
        bool var_32;
        wp::int32 var_33;
        wp::vec_t<3, wp::float32>* var_34;
        wp::vec_t<3, wp::float32>* var_35;
        wp::vec_t<3, wp::float32> var_36;
        wp::vec_t<3, wp::float32> var_37;
        wp::vec_t<3, wp::float32> var_38;
        wp::float32 var_39;
        wp::float32 var_40;
        wp::vec_t<3, wp::float32>* var_41;
        wp::float32 var_42;
        wp::vec_t<3, wp::float32> var_43;
        wp::float32 var_44;
        bool var_45;
        bool var_46;
        wp::float32* var_47;
        bool var_48;
        wp::float32 var_49;
        wp::float32* var_50;
        bool var_51;
        wp::float32 var_52;
        wp::int32* var_53;
        wp::int32 var_54;
        wp::int32 var_55;
        //---------
        // forward
        // def offer_patches_kernel(frontier, mask, cloud__points, cloud__normals, cloud__neighbors, cloud__labels, planes__centers, planes__directions, planes__similar, planes__near, ranks, offers, going):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // if i == 0:                                                                             <L 4>
        var_2 = (var_0 == var_1);
        if (var_2) {
            // going[0] = 0                                                                       <L 5>
            wp::array_store(var_going, var_4, var_3);
        }
        // row = frontier[i]                                                                      <L 6>
        var_5 = wp::address(var_frontier, var_0);
        var_7 = wp::load(var_5);
        var_6 = wp::copy(var_7);
        // if mask[row] == uint8(0):                                                              <L 7>
        var_8 = wp::address(var_mask, var_6);
        var_10 = wp::uint8(var_9);
        var_12 = wp::load(var_8);
        var_11 = (var_12 == var_10);
        if (var_11) {
            // return                                                                             <L 8>
            return;
        }
        // patch = cloud__labels[row]                                                             <L 9>
        var_13 = wp::address(var_cloud__labels, var_6);
        var_15 = wp::load(var_13);
        var_14 = wp::copy(var_15);
        // direction = planes__directions[patch]                                                  <L 10>
        var_16 = wp::address(var_planes__directions, var_14);
        var_18 = wp::load(var_16);
        var_17 = wp::copy(var_18);
        // for k in range(cloud__neighbors.shape[1]):                                             <L 11>
        var_19 = &(var_cloud__neighbors.shape);
        var_22 = wp::load(var_19);
        var_21 = wp::extract(var_22, var_20);
        var_23 = wp::range(var_21);
        start_for_1:;
            if (iter_cmp(var_23) == 0) goto end_for_1;
            var_24 = wp::iter_next(var_23);
            // other = cloud__neighbors[row, k]                                                   <L 12>
            var_25 = wp::address(var_cloud__neighbors, var_6, var_24);
            var_27 = wp::load(var_25);
            var_26 = wp::copy(var_27);
            // if other >= 0:                                                                     <L 13>
            var_29 = (var_26 >= var_28);
            if (var_29) {
                // if cloud__labels[other] < 0:                                                   <L 14>
                var_30 = wp::address(var_cloud__labels, var_26);
                var_33 = wp::load(var_30);
                var_32 = (var_33 < var_31);
                if (var_32) {
                    // distance = abs(dot(direction, cloud__points[other] - planes__centers[patch]))       <L 15>
                    var_34 = wp::address(var_cloud__points, var_26);
                    var_35 = wp::address(var_planes__centers, var_14);
                    var_37 = wp::load(var_34);
                    var_38 = wp::load(var_35);
                    var_36 = wp::sub(var_37, var_38);
                    var_39 = wp::dot(var_17, var_36);
                    var_40 = wp::abs(var_39);
                    // cosine = abs(dot(direction, cloud__normals[other]))                        <L 16>
                    var_41 = wp::address(var_cloud__normals, var_26);
                    var_43 = wp::load(var_41);
                    var_42 = wp::dot(var_17, var_43);
                    var_44 = wp::abs(var_42);
                    // if isfinite(cosine) and cosine > planes__similar[patch] and (distance < planes__near[patch]):       <L 17>
                    var_46 = wp::isfinite(var_44);
                    var_45 = var_46;
                    if (var_45) {
                        var_47 = wp::address(var_planes__similar, var_14);
                        var_49 = wp::load(var_47);
                        var_48 = (var_44 > var_49);
                        var_45 = var_45 && var_48;
                    }
                    if (var_45) {
                        var_50 = wp::address(var_planes__near, var_14);
                        var_52 = wp::load(var_50);
                        var_51 = (var_40 < var_52);
                        var_45 = var_45 && var_51;
                    }
                    if (var_45) {
                        // atomic_min(offers, other, ranks[patch])                                <L 18>
                        var_53 = wp::address(var_ranks, var_14);
                        var_55 = wp::load(var_53);
                        var_54 = wp::atomic_min(var_offers, var_26, var_55);
                    }
                }
            }
            goto start_for_1;
        end_for_1:;
}



extern "C" __global__ void choose_partners_kernel_2c4541dd_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cloud__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cloud__normals,
    wp::array_t<wp::int32> var_cloud__neighbors,
    wp::array_t<wp::int32> var_cloud__labels,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__centers,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__directions,
    wp::array_t<wp::float32> var_planes__similar,
    wp::array_t<wp::float32> var_planes__near,
    wp::array_t<wp::int32> var_ranks,
    wp::array_t<wp::int32> var_partners)
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
        wp::shape_t* var_6;
        const wp::int32 var_7 = 1;
        wp::int32 var_8;
        wp::shape_t var_9;
        wp::range_t var_10;
        wp::int32 var_11;
        wp::int32* var_12;
        wp::int32 var_13;
        wp::int32 var_14;
        const wp::int32 var_15 = -1;
        wp::int32 var_16;
        const wp::int32 var_17 = 0;
        bool var_18;
        wp::int32* var_19;
        wp::int32 var_20;
        wp::int32 var_21;
        wp::int32 var_22;
        bool var_23;
        const wp::int32 var_24 = 0;
        bool var_25;
        bool var_26;
        wp::float32* var_27;
        wp::float32* var_28;
        wp::float32 var_29;
        wp::float32 var_30;
        wp::float32 var_31;
        wp::float32* var_32;
        wp::float32* var_33;
        wp::float32 var_34;
        wp::float32 var_35;
        wp::float32 var_36;
        wp::vec_t<3, wp::float32>* var_37;
        wp::vec_t<3, wp::float32>* var_38;
        wp::float32 var_39;
        wp::vec_t<3, wp::float32> var_40;
        wp::vec_t<3, wp::float32> var_41;
        wp::float32 var_42;
        bool var_43;
        wp::int32 var_44;
        wp::int32 var_45;
        bool var_46;
        const wp::int32 var_47 = 1;
        bool var_48;
        const wp::int32 var_49 = 1;
        bool var_50;
        wp::int32* var_51;
        wp::int32* var_52;
        bool var_53;
        wp::int32 var_54;
        wp::int32 var_55;
        wp::int32* var_56;
        wp::int32 var_57;
        wp::int32 var_58;
        wp::int32* var_59;
        wp::int32 var_60;
        wp::int32 var_61;
        //---------
        // forward
        // def choose_partners_kernel(cloud__points, cloud__normals, cloud__neighbors, cloud__labels, planes__centers, planes__directions, planes__similar, planes__near, ranks, partners):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // a = cloud__labels[i]                                                                   <L 4>
        var_1 = wp::address(var_cloud__labels, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // if a >= 0:                                                                             <L 5>
        var_5 = (var_2 >= var_4);
        if (var_5) {
            // for k in range(cloud__neighbors.shape[1]):                                         <L 6>
            var_6 = &(var_cloud__neighbors.shape);
            var_9 = wp::load(var_6);
            var_8 = wp::extract(var_9, var_7);
            var_10 = wp::range(var_8);
            start_for_0:;
                if (iter_cmp(var_10) == 0) goto end_for_0;
                var_11 = wp::iter_next(var_10);
                // j = cloud__neighbors[i, k]                                                     <L 7>
                var_12 = wp::address(var_cloud__neighbors, var_0, var_11);
                var_14 = wp::load(var_12);
                var_13 = wp::copy(var_14);
                // b = int(-1)                                                                    <L 8>
                var_16 = wp::int(var_15);
                // if j >= 0:                                                                     <L 9>
                var_18 = (var_13 >= var_17);
                if (var_18) {
                    // b = cloud__labels[j]                                                       <L 10>
                    var_19 = wp::address(var_cloud__labels, var_13);
                    var_21 = wp::load(var_19);
                    var_20 = wp::copy(var_21);
                }
                var_22 = wp::where(var_18, var_20, var_16);
                // if b >= 0 and b != a:                                                          <L 11>
                var_25 = (var_22 >= var_24);
                var_23 = var_25;
                if (var_23) {
                    var_26 = (var_22 != var_2);
                    var_23 = var_23 && var_26;
                }
                if (var_23) {
                    // like = min(planes__similar[a], planes__similar[b])                         <L 12>
                    var_27 = wp::address(var_planes__similar, var_2);
                    var_28 = wp::address(var_planes__similar, var_22);
                    var_30 = wp::load(var_27);
                    var_31 = wp::load(var_28);
                    var_29 = wp::min(var_30, var_31);
                    // max_distance = max(planes__near[a], planes__near[b])                       <L 13>
                    var_32 = wp::address(var_planes__near, var_2);
                    var_33 = wp::address(var_planes__near, var_22);
                    var_35 = wp::load(var_32);
                    var_36 = wp::load(var_33);
                    var_34 = wp::max(var_35, var_36);
                    // if abs(dot(planes__directions[a], planes__directions[b])) >= like:         <L 14>
                    var_37 = wp::address(var_planes__directions, var_2);
                    var_38 = wp::address(var_planes__directions, var_22);
                    var_40 = wp::load(var_37);
                    var_41 = wp::load(var_38);
                    var_39 = wp::dot(var_40, var_41);
                    var_42 = wp::abs(var_39);
                    var_43 = (var_42 >= var_29);
                    if (var_43) {
                        // there = fits_patch(j, a, like, max_distance, cloud__points, cloud__normals, planes__centers, planes__directions)       <L 15>
                        var_44 = fits_patch_0(var_13, var_2, var_29, var_34, var_cloud__points, var_cloud__normals, var_planes__centers, var_planes__directions);
                        // here = fits_patch(i, b, like, max_distance, cloud__points, cloud__normals, planes__centers, planes__directions)       <L 16>
                        var_45 = fits_patch_0(var_0, var_22, var_29, var_34, var_cloud__points, var_cloud__normals, var_planes__centers, var_planes__directions);
                        // if there == 1 and here == 1:                                           <L 17>
                        var_48 = (var_44 == var_47);
                        var_46 = var_48;
                        if (var_46) {
                            var_50 = (var_45 == var_49);
                            var_46 = var_46 && var_50;
                        }
                        if (var_46) {
                            // if ranks[a] < ranks[b]:                                            <L 18>
                            var_51 = wp::address(var_ranks, var_2);
                            var_52 = wp::address(var_ranks, var_22);
                            var_54 = wp::load(var_51);
                            var_55 = wp::load(var_52);
                            var_53 = (var_54 < var_55);
                            if (var_53) {
                                // atomic_min(partners, b, ranks[a])                              <L 19>
                                var_56 = wp::address(var_ranks, var_2);
                                var_58 = wp::load(var_56);
                                var_57 = wp::atomic_min(var_partners, var_22, var_58);
                            }
                            if (!var_53) {
                                // atomic_min(partners, a, ranks[b])                              <L 21>
                                var_59 = wp::address(var_ranks, var_22);
                                var_61 = wp::load(var_59);
                                var_60 = wp::atomic_min(var_partners, var_2, var_61);
                            }
                        }
                    }
                }
                goto start_for_0;
            end_for_0:;
        }
}



extern "C" __global__ void count_labels_kernel_303afcab_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_labels,
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
        wp::int32* var_1;
        const wp::int32 var_2 = 0;
        bool var_3;
        wp::int32 var_4;
        wp::int32* var_5;
        const wp::int32 var_6 = 1;
        wp::int32 var_7;
        wp::int32 var_8;
        //---------
        // forward
        // def count_labels_kernel(labels: array(dtype=int32), counts: array(dtype=int32)):       <L 272>
        // i = tid()                                                                              <L 273>
        var_0 = builtin_tid1d();
        // if labels[i] >= 0:                                                                     <L 274>
        var_1 = wp::address(var_labels, var_0);
        var_4 = wp::load(var_1);
        var_3 = (var_4 >= var_2);
        if (var_3) {
            // atomic_add(counts, labels[i], 1)                                                   <L 275>
            var_5 = wp::address(var_labels, var_0);
            var_8 = wp::load(var_5);
            var_7 = wp::atomic_add(var_counts, var_8, var_6);
        }
}



extern "C" __global__ void widen_labels_kernel_5ae8e8de_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_rows,
    wp::array_t<wp::int32> var_labels,
    wp::array_t<wp::int64> var_keys)
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
        wp::int32* var_3;
        wp::int64 var_4;
        wp::int32 var_5;
        //---------
        // forward
        // def widen_labels_kernel(rows: array(dtype=int32), labels: array(dtype=int32), keys: array(dtype=int64)):       <L 298>
        // i = tid()                                                                              <L 299>
        var_0 = builtin_tid1d();
        // keys[i] = int64(labels[rows[i]])                                                       <L 300>
        var_1 = wp::address(var_rows, var_0);
        var_2 = wp::load(var_1);
        var_3 = wp::address(var_labels, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::int64(var_5);
        wp::array_store(var_keys, var_0, var_4);
}



extern "C" __global__ void hand_over_kernel_939d3a33_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cloud__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cloud__normals,
    wp::array_t<wp::int32> var_cloud__labels,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__centers,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__directions,
    wp::array_t<wp::float32> var_planes__similar,
    wp::array_t<wp::float32> var_planes__near,
    wp::array_t<wp::int32> var_targets,
    wp::array_t<wp::int32> var_names)
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
        wp::int32* var_6;
        wp::int32 var_7;
        wp::int32 var_8;
        wp::int32* var_9;
        wp::int32 var_10;
        wp::int32 var_11;
        bool var_12;
        wp::float32* var_13;
        wp::float32* var_14;
        wp::int32 var_15;
        wp::float32 var_16;
        wp::float32 var_17;
        const wp::int32 var_18 = 0;
        bool var_19;
        const wp::int32 var_20 = -1;
        wp::int32 var_21;
        wp::int32 var_22;
        //---------
        // forward
        // def hand_over_kernel(cloud__points, cloud__normals, cloud__labels, planes__centers, planes__directions, planes__similar, planes__near, targets, names):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // patch = cloud__labels[i]                                                               <L 3>
        var_1 = wp::address(var_cloud__labels, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // if patch >= 0:                                                                         <L 4>
        var_5 = (var_2 >= var_4);
        if (var_5) {
            // target = targets[patch]                                                            <L 5>
            var_6 = wp::address(var_targets, var_2);
            var_8 = wp::load(var_6);
            var_7 = wp::copy(var_8);
            // name = names[target]                                                               <L 6>
            var_9 = wp::address(var_names, var_7);
            var_11 = wp::load(var_9);
            var_10 = wp::copy(var_11);
            // if target != patch:                                                                <L 7>
            var_12 = (var_7 != var_2);
            if (var_12) {
                // if fits_patch(i, target, planes__similar[target], planes__near[target], cloud__points, cloud__normals, planes__centers, planes__directions) == 0:       <L 8>
                var_13 = wp::address(var_planes__similar, var_7);
                var_14 = wp::address(var_planes__near, var_7);
                var_16 = wp::load(var_13);
                var_17 = wp::load(var_14);
                var_15 = fits_patch_0(var_0, var_7, var_16, var_17, var_cloud__points, var_cloud__normals, var_planes__centers, var_planes__directions);
                var_19 = (var_15 == var_18);
                if (var_19) {
                    // name = -1                                                                  <L 9>
                }
                var_21 = wp::where(var_19, var_20, var_10);
            }
            var_22 = wp::where(var_12, var_21, var_10);
            // cloud__labels[i] = name                                                            <L 10>
            wp::array_store(var_cloud__labels, var_0, var_22);
        }
}



extern "C" __global__ void write_planes_kernel_d61b1976_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_patches,
    wp::array_t<wp::vec_t<3, wp::float32>> var_new_centers,
    wp::array_t<wp::vec_t<3, wp::float32>> var_new_directions,
    wp::array_t<wp::vec_t<3, wp::float32>> var_centers,
    wp::array_t<wp::vec_t<3, wp::float32>> var_directions)
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
        wp::int32* var_4;
        wp::int32 var_5;
        wp::vec_t<3, wp::float32>* var_6;
        wp::vec_t<3, wp::float32> var_7;
        wp::vec_t<3, wp::float32> var_8;
        wp::int32* var_9;
        wp::int32 var_10;
        //---------
        // forward
        // def write_planes_kernel(                                                               <L 285>
        // i = tid()                                                                              <L 292>
        var_0 = builtin_tid1d();
        // centers[patches[i]] = new_centers[i]                                                   <L 293>
        var_1 = wp::address(var_new_centers, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        var_4 = wp::address(var_patches, var_0);
        var_5 = wp::load(var_4);
        wp::array_store(var_centers, var_5, var_2);
        // directions[patches[i]] = new_directions[i]                                             <L 294>
        var_6 = wp::address(var_new_directions, var_0);
        var_8 = wp::load(var_6);
        var_7 = wp::copy(var_8);
        var_9 = wp::address(var_patches, var_0);
        var_10 = wp::load(var_9);
        wp::array_store(var_directions, var_10, var_7);
}



extern "C" __global__ void take_offers_kernel_f3908488_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_by_rank,
    wp::array_t<wp::int32> var_offers,
    wp::array_t<wp::int32> var_labels,
    wp::array_t<wp::uint8> var_mask,
    wp::array_t<wp::int32> var_going)
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
        wp::int32 var_2;
        wp::int32* var_3;
        const wp::int32 var_4 = 2147483647;
        bool var_5;
        wp::int32 var_6;
        wp::int32* var_7;
        wp::int32 var_8;
        wp::int32* var_9;
        wp::int32 var_10;
        wp::int32 var_11;
        const wp::int32 var_12 = 1;
        const wp::int32 var_13 = 1;
        const wp::int32 var_14 = 0;
        wp::int32 var_15;
        wp::uint8 var_16;
        //---------
        // forward
        // def take_offers_kernel(by_rank, offers, labels, mask, going):                          <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // taken = int(0)                                                                         <L 4>
        var_2 = wp::int(var_1);
        // if offers[i] < NO_OFFER:                                                               <L 5>
        var_3 = wp::address(var_offers, var_0);
        var_6 = wp::load(var_3);
        var_5 = (var_6 < var_4);
        if (var_5) {
            // labels[i] = by_rank[offers[i]]                                                     <L 6>
            var_7 = wp::address(var_offers, var_0);
            var_8 = wp::load(var_7);
            var_9 = wp::address(var_by_rank, var_8);
            var_11 = wp::load(var_9);
            var_10 = wp::copy(var_11);
            wp::array_store(var_labels, var_0, var_10);
            // offers[i] = NO_OFFER                                                               <L 7>
            wp::array_store(var_offers, var_0, var_4);
            // taken = 1                                                                          <L 8>
            // going[0] = 1                                                                       <L 9>
            wp::array_store(var_going, var_14, var_13);
        }
        var_15 = wp::where(var_5, var_12, var_2);
        // mask[i] = uint8(taken)                                                                 <L 10>
        var_16 = wp::uint8(var_15);
        wp::array_store(var_mask, var_0, var_16);
}


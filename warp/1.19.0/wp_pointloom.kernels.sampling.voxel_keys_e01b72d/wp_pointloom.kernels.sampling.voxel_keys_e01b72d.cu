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


// /work/main/src/pointloom/kernels/sampling/voxel_keys.py:16
static CUDA_CALLABLE wp::int64 cell_of_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float64> var_corner,
    wp::float64 var_size,
    wp::int32 var_axis)
{
    //---------
    // primal vars
    wp::float32 var_0;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::int64 var_6;
    //---------
    // forward
    // def cell_of(p: vec3, corner: vec3d, size: float64, axis: int) -> int64:                <L 17>
    // return int64(floor((float64(p[axis]) - corner[axis]) / size))                          <L 18>
    var_0 = wp::extract(var_p, var_axis);
    var_1 = wp::float64(var_0);
    var_2 = wp::extract(var_corner, var_axis);
    var_3 = wp::sub(var_1, var_2);
    var_4 = wp::div(var_3, var_size);
    var_5 = wp::floor(var_4);
    var_6 = wp::int64(var_5);
    return var_6;
}


// /work/main/src/pointloom/kernels/sampling/voxel_keys.py:21
static CUDA_CALLABLE wp::int64 voxel_key_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float64> var_corner,
    wp::float64 var_size,
    wp::vec_t<3, wp::int64> var_first,
    wp::vec_t<3, wp::int32> var_bits,
    wp::int64 var_skipped)
{
    //---------
    // primal vars
    wp::int64 var_0;
    bool var_1;
    const wp::int32 var_2 = 0;
    wp::int64 var_3;
    const wp::int32 var_4 = 0;
    wp::int64 var_5;
    wp::int64 var_6;
    const wp::int32 var_7 = 1;
    wp::int64 var_8;
    const wp::int32 var_9 = 1;
    wp::int64 var_10;
    wp::int64 var_11;
    const wp::int32 var_12 = 2;
    wp::int64 var_13;
    const wp::int32 var_14 = 2;
    wp::int64 var_15;
    wp::int64 var_16;
    const wp::int32 var_17 = 1;
    wp::int32 var_18;
    wp::int64 var_19;
    wp::int64 var_20;
    wp::int64 var_21;
    const wp::int32 var_22 = 2;
    wp::int32 var_23;
    wp::int64 var_24;
    wp::int64 var_25;
    wp::int64 var_26;
    wp::int64 var_27;
    //---------
    // forward
    // def voxel_key(p: vec3, corner: vec3d, size: float64, first: cell, bits: vec3i, skipped: int64) -> int64:       <L 22>
    // key = skipped                                                                          <L 23>
    var_0 = wp::copy(var_skipped);
    // if isfinite(p):                                                                        <L 24>
    var_1 = wp::isfinite(var_p);
    if (var_1) {
        // x = cell_of(p, corner, size, 0) - first[0]                                         <L 25>
        var_3 = cell_of_0(var_p, var_corner, var_size, var_2);
        var_5 = wp::extract(var_first, var_4);
        var_6 = wp::sub(var_3, var_5);
        // y = cell_of(p, corner, size, 1) - first[1]                                         <L 26>
        var_8 = cell_of_0(var_p, var_corner, var_size, var_7);
        var_10 = wp::extract(var_first, var_9);
        var_11 = wp::sub(var_8, var_10);
        // z = cell_of(p, corner, size, 2) - first[2]                                         <L 27>
        var_13 = cell_of_0(var_p, var_corner, var_size, var_12);
        var_15 = wp::extract(var_first, var_14);
        var_16 = wp::sub(var_13, var_15);
        // key = (((x << int64(bits[1])) | y) << int64(bits[2])) | z                          <L 28>
        var_18 = wp::extract(var_bits, var_17);
        var_19 = wp::int64(var_18);
        var_20 = wp::lshift(var_6, var_19);
        var_21 = wp::bit_or(var_20, var_11);
        var_23 = wp::extract(var_bits, var_22);
        var_24 = wp::int64(var_23);
        var_25 = wp::lshift(var_21, var_24);
        var_26 = wp::bit_or(var_25, var_16);
    }
    var_27 = wp::where(var_1, var_26, var_0);
    // return key                                                                             <L 29>
    return var_27;
}


// <pointloom.kernels.arrays.sort.put_key>:1
static CUDA_CALLABLE void put_key_0(
    wp::int32 var_i,
    wp::int64 var_key,
    wp::array_t<wp::int64> var_into__keys,
    wp::array_t<wp::int32> var_into__positions)
{
    //---------
    // primal vars
    wp::shape_t* var_0;
    const wp::int32 var_1 = 0;
    wp::int32 var_2;
    wp::shape_t var_3;
    bool var_4;
    //---------
    // forward
    // def put_key(i, key, into__keys, into__positions):                                      <L 1>
    // into__keys[i] = key                                                                    <L 2>
    wp::array_store(var_into__keys, var_i, var_key);
    // if i < into__positions.shape[0]:                                                       <L 3>
    var_0 = &(var_into__positions.shape);
    var_3 = wp::load(var_0);
    var_2 = wp::extract(var_3, var_1);
    var_4 = (var_i < var_2);
    if (var_4) {
        // into__positions[i] = i                                                             <L 4>
        wp::array_store(var_into__positions, var_i, var_i);
    }
}


// /work/main/src/pointloom/kernels/sampling/voxel_keys.py:16
static CUDA_CALLABLE void adj_cell_of_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float64> var_corner,
    wp::float64 var_size,
    wp::int32 var_axis,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float64> & adj_corner,
    wp::float64 & adj_size,
    wp::int32 & adj_axis,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/sampling/voxel_keys.py:21
static CUDA_CALLABLE void adj_voxel_key_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float64> var_corner,
    wp::float64 var_size,
    wp::vec_t<3, wp::int64> var_first,
    wp::vec_t<3, wp::int32> var_bits,
    wp::int64 var_skipped,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float64> & adj_corner,
    wp::float64 & adj_size,
    wp::vec_t<3, wp::int64> & adj_first,
    wp::vec_t<3, wp::int32> & adj_bits,
    wp::int64 & adj_skipped,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.sort.put_key>:1
static CUDA_CALLABLE void adj_put_key_0(
    wp::int32 var_i,
    wp::int64 var_key,
    wp::array_t<wp::int64> var_into__keys,
    wp::array_t<wp::int32> var_into__positions,
    wp::int32 & adj_i,
    wp::int64 & adj_key,
    wp::array_t<wp::int64> & adj_into__keys,
    wp::array_t<wp::int32> & adj_into__positions)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void encode_voxels_kernel_da586630_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::vec_t<3, wp::float64> var_corner,
    wp::float64 var_size,
    wp::vec_t<3, wp::int64> var_first,
    wp::vec_t<3, wp::int32> var_bits,
    wp::int64 var_skipped,
    wp::array_t<wp::int64> var_keys__keys,
    wp::array_t<wp::int32> var_keys__positions)
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
        wp::int64 var_2;
        wp::vec_t<3, wp::float32> var_3;
        //---------
        // forward
        // def encode_voxels_kernel(points, corner, size, first, bits, skipped, keys__keys, keys__positions):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // put_key(i, voxel_key(points[i], corner, size, first, bits, skipped), keys__keys, keys__positions)       <L 4>
        var_1 = wp::address(var_points, var_0);
        var_3 = wp::load(var_1);
        var_2 = voxel_key_0(var_3, var_corner, var_size, var_first, var_bits, var_skipped);
        put_key_0(var_0, var_2, var_keys__keys, var_keys__positions);
}


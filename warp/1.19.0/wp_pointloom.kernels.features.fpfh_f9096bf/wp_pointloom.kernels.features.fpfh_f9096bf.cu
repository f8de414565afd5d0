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



extern "C" __global__ void fill_missing_features_kernel_09439722_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_order,
    wp::int32 var_count,
    wp::array_t<wp::float32> var_features)
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
        wp::int32* var_2;
        wp::int32 var_3;
        wp::int32 var_4;
        wp::int32 var_5;
        wp::int32 var_6;
        const wp::float32 var_7 = NAN;
        //---------
        // forward
        // def fill_missing_features_kernel(order: array(dtype=int32), count: int, features: array(dtype=float32, ndim=2)):       <L 201>
        // i = tid()                                                                              <L 202>
        var_0 = builtin_tid1d();
        // row = order[count + i]                                                                 <L 203>
        var_1 = wp::add(var_count, var_0);
        var_2 = wp::address(var_order, var_1);
        var_4 = wp::load(var_2);
        var_3 = wp::copy(var_4);
        // for c in range(COLUMNS):                                                               <L 204>
        var_5 = 0;
        start_for_0:;
            if (var_5 >= 33) goto end_for_0;
            var_6 = var_5;
            var_5 += 1;
            // features[row, c] = NAN                                                             <L 205>
            wp::array_store(var_features, var_3, var_6, var_7);
            goto start_for_0;
        end_for_0:;
}



extern "C" __global__ void mask_points_kernel_64ff3f90_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals,
    wp::array_t<wp::vec_t<3, wp::float32>> var_usable,
    wp::array_t<wp::int32> var_masked)
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
        wp::vec_t<3, wp::float32>* var_4;
        bool var_5;
        wp::vec_t<3, wp::float32> var_6;
        bool var_7;
        bool var_8;
        const wp::int32 var_9 = 0;
        const wp::int32 var_10 = 1;
        wp::int32 var_11;
        const wp::float32 var_12 = NAN;
        wp::vec_t<3, wp::float32> var_13;
        wp::vec_t<3, wp::float32> var_14;
        //---------
        // forward
        // def mask_points_kernel(                                                                <L 159>
        // i = tid()                                                                              <L 163>
        var_0 = builtin_tid1d();
        // p = points[i]                                                                          <L 164>
        var_1 = wp::address(var_points, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // if not isfinite(normals[i]):                                                           <L 165>
        var_4 = wp::address(var_normals, var_0);
        var_6 = wp::load(var_4);
        var_5 = wp::isfinite(var_6);
        var_7 = wp::unot(var_5);
        if (var_7) {
            // if isfinite(p):                                                                    <L 166>
            var_8 = wp::isfinite(var_2);
            if (var_8) {
                // atomic_max(masked, 0, 1)  # resolves the race: all writers set 1               <L 167>
                var_11 = wp::atomic_max(var_masked, var_9, var_10);
            }
            // p = vec3(NAN, NAN, NAN)                                                            <L 168>
            var_13 = wp::vec_t<3, wp::float32>(var_12, var_12, var_12);
        }
        var_14 = wp::where(var_7, var_13, var_2);
        // usable[i] = p                                                                          <L 169>
        wp::array_store(var_usable, var_0, var_14);
}



extern "C" __global__ void mark_chosen_kernel_6dacbe1b_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_rows,
    wp::array_t<wp::int32> var_positions,
    wp::int32 var_count,
    wp::array_t<wp::int32> var_marks)
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
        wp::int32 var_4;
        wp::int32 var_5;
        bool var_6;
        const wp::int32 var_7 = 1;
        wp::int32 var_8;
        //---------
        // forward
        // def mark_chosen_kernel(rows: array(dtype=int32), positions: array(dtype=int32), count: int, marks: array(dtype=int32)):       <L 173>
        // i = tid()                                                                              <L 175>
        var_0 = builtin_tid1d();
        // position = positions[rows[i]]                                                          <L 176>
        var_1 = wp::address(var_rows, var_0);
        var_2 = wp::load(var_1);
        var_3 = wp::address(var_positions, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::copy(var_5);
        // if position < count:                                                                   <L 177>
        var_6 = (var_4 < var_count);
        if (var_6) {
            // atomic_max(marks, position, 1)                                                     <L 178>
            var_8 = wp::atomic_max(var_marks, var_4, var_7);
        }
}



extern "C" __global__ void copy_features_kernel_d6696f6c_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_rows,
    wp::array_t<wp::int32> var_positions,
    wp::int32 var_count,
    wp::array_t<wp::int32> var_slots,
    wp::array_t<wp::float32> var_compact,
    wp::array_t<wp::float32> var_features)
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
        wp::int32 var_4;
        wp::int32 var_5;
        wp::int32 var_6;
        wp::int32 var_7;
        const wp::float32 var_8 = NAN;
        wp::float32 var_9;
        bool var_10;
        wp::int32* var_11;
        wp::int32 var_12;
        wp::float32* var_13;
        wp::float32 var_14;
        wp::float32 var_15;
        wp::float32 var_16;
        //---------
        // forward
        // def copy_features_kernel(                                                              <L 182>
        // i = tid()                                                                              <L 191>
        var_0 = builtin_tid1d();
        // position = positions[rows[i]]                                                          <L 192>
        var_1 = wp::address(var_rows, var_0);
        var_2 = wp::load(var_1);
        var_3 = wp::address(var_positions, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::copy(var_5);
        // for c in range(COLUMNS):                                                               <L 193>
        var_6 = 0;
        start_for_0:;
            if (var_6 >= 33) goto end_for_0;
            var_7 = var_6;
            var_6 += 1;
            // value = float(NAN)                                                                 <L 194>
            var_9 = wp::float(var_8);
            // if position < count:                                                               <L 195>
            var_10 = (var_4 < var_count);
            if (var_10) {
                // value = compact[slots[position], c]                                            <L 196>
                var_11 = wp::address(var_slots, var_4);
                var_12 = wp::load(var_11);
                var_13 = wp::address(var_compact, var_12, var_7);
                var_15 = wp::load(var_13);
                var_14 = wp::copy(var_15);
            }
            var_16 = wp::where(var_10, var_14, var_9);
            // features[i, c] = value                                                             <L 197>
            wp::array_store(var_features, var_0, var_7, var_16);
            goto start_for_0;
        end_for_0:;
}


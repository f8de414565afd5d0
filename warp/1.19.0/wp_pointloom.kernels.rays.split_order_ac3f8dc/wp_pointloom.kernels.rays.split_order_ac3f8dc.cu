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


// <pointloom.kernels.rays.split_order.longest_side>:1
static CUDA_CALLABLE wp::int32 longest_side_0(
    wp::array_t<wp::float32> var_low,
    wp::array_t<wp::float32> var_high,
    wp::int32 var_run)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    const wp::int32 var_3 = 3;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::float32* var_6;
    const wp::int32 var_7 = 3;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::float32* var_10;
    wp::float32 var_11;
    wp::float32 var_12;
    wp::float32 var_13;
    const wp::int32 var_14 = 3;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::float32* var_17;
    const wp::int32 var_18 = 3;
    wp::int32 var_19;
    wp::int32 var_20;
    wp::float32* var_21;
    wp::float32 var_22;
    wp::float32 var_23;
    wp::float32 var_24;
    bool var_25;
    wp::int32 var_26;
    wp::int32 var_27;
    const wp::int32 var_28 = 2;
    const wp::int32 var_29 = 3;
    wp::int32 var_30;
    wp::int32 var_31;
    wp::float32* var_32;
    const wp::int32 var_33 = 3;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::float32* var_36;
    wp::float32 var_37;
    wp::float32 var_38;
    wp::float32 var_39;
    const wp::int32 var_40 = 3;
    wp::int32 var_41;
    wp::int32 var_42;
    wp::float32* var_43;
    const wp::int32 var_44 = 3;
    wp::int32 var_45;
    wp::int32 var_46;
    wp::float32* var_47;
    wp::float32 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    bool var_51;
    wp::int32 var_52;
    wp::int32 var_53;
    //---------
    // forward
    // def longest_side(low, high, run):                                                      <L 1>
    // axis = int(0)                                                                          <L 2>
    var_1 = wp::int(var_0);
    // for k in range(1, 3):                                                                  <L 3>
    // if high[3 * run + k] - low[3 * run + k] > high[3 * run + axis] - low[3 * run + axis]:       <L 4>
    var_4 = wp::mul(var_3, var_run);
    var_5 = wp::add(var_4, var_2);
    var_6 = wp::address(var_high, var_5);
    var_8 = wp::mul(var_7, var_run);
    var_9 = wp::add(var_8, var_2);
    var_10 = wp::address(var_low, var_9);
    var_12 = wp::load(var_6);
    var_13 = wp::load(var_10);
    var_11 = wp::sub(var_12, var_13);
    var_15 = wp::mul(var_14, var_run);
    var_16 = wp::add(var_15, var_1);
    var_17 = wp::address(var_high, var_16);
    var_19 = wp::mul(var_18, var_run);
    var_20 = wp::add(var_19, var_1);
    var_21 = wp::address(var_low, var_20);
    var_23 = wp::load(var_17);
    var_24 = wp::load(var_21);
    var_22 = wp::sub(var_23, var_24);
    var_25 = (var_11 > var_22);
    if (var_25) {
        // axis = k                                                                           <L 5>
        var_26 = wp::copy(var_2);
    }
    var_27 = wp::where(var_25, var_26, var_1);
    // if high[3 * run + k] - low[3 * run + k] > high[3 * run + axis] - low[3 * run + axis]:       <L 4>
    var_30 = wp::mul(var_29, var_run);
    var_31 = wp::add(var_30, var_28);
    var_32 = wp::address(var_high, var_31);
    var_34 = wp::mul(var_33, var_run);
    var_35 = wp::add(var_34, var_28);
    var_36 = wp::address(var_low, var_35);
    var_38 = wp::load(var_32);
    var_39 = wp::load(var_36);
    var_37 = wp::sub(var_38, var_39);
    var_41 = wp::mul(var_40, var_run);
    var_42 = wp::add(var_41, var_27);
    var_43 = wp::address(var_high, var_42);
    var_45 = wp::mul(var_44, var_run);
    var_46 = wp::add(var_45, var_27);
    var_47 = wp::address(var_low, var_46);
    var_49 = wp::load(var_43);
    var_50 = wp::load(var_47);
    var_48 = wp::sub(var_49, var_50);
    var_51 = (var_37 > var_48);
    if (var_51) {
        // axis = k                                                                           <L 5>
        var_52 = wp::copy(var_28);
    }
    var_53 = wp::where(var_51, var_52, var_27);
    // return axis                                                                            <L 6>
    return var_53;
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


// <pointloom.kernels.rays.split_order.longest_side>:1
static CUDA_CALLABLE void adj_longest_side_0(
    wp::array_t<wp::float32> var_low,
    wp::array_t<wp::float32> var_high,
    wp::int32 var_run,
    wp::array_t<wp::float32> & adj_low,
    wp::array_t<wp::float32> & adj_high,
    wp::int32 & adj_run,
    wp::int32 & adj_ret)
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



extern "C" __global__ void key_positions_kernel_5eab15e8_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::int32> var_order,
    wp::int32 var_size,
    wp::array_t<wp::float32> var_low,
    wp::array_t<wp::float32> var_high,
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
        wp::int32 var_1;
        wp::int32 var_2;
        const wp::int32 var_3 = 3;
        wp::int32 var_4;
        wp::int32 var_5;
        wp::float32* var_6;
        wp::float32 var_7;
        wp::float32 var_8;
        const wp::int32 var_9 = 3;
        wp::int32 var_10;
        wp::int32 var_11;
        wp::float32* var_12;
        wp::float32 var_13;
        wp::float32 var_14;
        wp::int32* var_15;
        wp::int32 var_16;
        wp::vec_t<3, wp::float32>* var_17;
        wp::vec_t<3, wp::float32> var_18;
        wp::vec_t<3, wp::float32> var_19;
        const wp::int32 var_20 = 0;
        wp::int32 var_21;
        bool var_22;
        const wp::float32 var_23 = 0.0;
        bool var_24;
        bool var_25;
        wp::float32 var_26;
        wp::float32 var_27;
        wp::float32 var_28;
        const wp::float32 var_29 = 65535.0;
        wp::float32 var_30;
        wp::int32 var_31;
        wp::int32 var_32;
        wp::int64 var_33;
        wp::int64 var_34;
        wp::int64 var_35;
        wp::int64 var_36;
        wp::int64 var_37;
        //---------
        // forward
        // def key_positions_kernel(points, order, size, low, high, keys__keys, keys__positions):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // run = i // size                                                                        <L 4>
        var_1 = wp::floordiv(var_0, var_size);
        // axis = longest_side(low, high, run)                                                    <L 5>
        var_2 = longest_side_0(var_low, var_high, var_1);
        // lowest = low[3 * run + axis]                                                           <L 6>
        var_4 = wp::mul(var_3, var_1);
        var_5 = wp::add(var_4, var_2);
        var_6 = wp::address(var_low, var_5);
        var_8 = wp::load(var_6);
        var_7 = wp::copy(var_8);
        // extent = high[3 * run + axis] - lowest                                                 <L 7>
        var_10 = wp::mul(var_9, var_1);
        var_11 = wp::add(var_10, var_2);
        var_12 = wp::address(var_high, var_11);
        var_14 = wp::load(var_12);
        var_13 = wp::sub(var_14, var_7);
        // p = points[order[i]]                                                                   <L 8>
        var_15 = wp::address(var_order, var_0);
        var_16 = wp::load(var_15);
        var_17 = wp::address(var_points, var_16);
        var_19 = wp::load(var_17);
        var_18 = wp::copy(var_19);
        // step = int(0)                                                                          <L 9>
        var_21 = wp::int(var_20);
        // if extent > 0.0 and isfinite(extent):                                                  <L 10>
        var_24 = (var_13 > var_23);
        var_22 = var_24;
        if (var_22) {
            var_25 = wp::isfinite(var_13);
            var_22 = var_22 && var_25;
        }
        if (var_22) {
            // step = int((p[axis] - lowest) / extent * STEPS)                                    <L 11>
            var_26 = wp::extract(var_18, var_2);
            var_27 = wp::sub(var_26, var_7);
            var_28 = wp::div(var_27, var_13);
            var_30 = wp::mul(var_28, var_29);
            var_31 = wp::int(var_30);
        }
        var_32 = wp::where(var_22, var_31, var_21);
        // put_key(i, int64(run) << int64(STEP_BITS) | int64(step), keys__keys, keys__positions)       <L 12>
        var_33 = wp::int64(var_1);
        var_34 = 16ll;
        var_35 = wp::lshift(var_33, var_34);
        var_36 = wp::int64(var_32);
        var_37 = wp::bit_or(var_35, var_36);
        put_key_0(var_0, var_37, var_keys__keys, var_keys__positions);
}


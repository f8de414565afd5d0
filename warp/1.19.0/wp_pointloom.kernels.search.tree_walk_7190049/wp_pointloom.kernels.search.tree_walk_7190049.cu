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



extern "C" __global__ void lower_numbers_kernel_02a6cc24_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_below,
    wp::int32 var_first,
    wp::array_t<wp::int32> var_lowest)
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
        wp::int32 var_2;
        const wp::int32 var_3 = 0;
        wp::int32 var_4;
        const wp::int32 var_5 = 8;
        wp::int32 var_6;
        wp::int32 var_7;
        wp::int32* var_8;
        wp::int32 var_9;
        wp::int32 var_10;
        const wp::int32 var_11 = 1;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int32 var_14;
        wp::int32* var_15;
        wp::int32 var_16;
        wp::int32 var_17;
        const wp::int32 var_18 = 2;
        wp::int32 var_19;
        wp::int32 var_20;
        wp::int32 var_21;
        wp::int32* var_22;
        wp::int32 var_23;
        wp::int32 var_24;
        const wp::int32 var_25 = 3;
        wp::int32 var_26;
        wp::int32 var_27;
        wp::int32 var_28;
        wp::int32* var_29;
        wp::int32 var_30;
        wp::int32 var_31;
        const wp::int32 var_32 = 4;
        wp::int32 var_33;
        wp::int32 var_34;
        wp::int32 var_35;
        wp::int32* var_36;
        wp::int32 var_37;
        wp::int32 var_38;
        const wp::int32 var_39 = 5;
        wp::int32 var_40;
        wp::int32 var_41;
        wp::int32 var_42;
        wp::int32* var_43;
        wp::int32 var_44;
        wp::int32 var_45;
        const wp::int32 var_46 = 6;
        wp::int32 var_47;
        wp::int32 var_48;
        wp::int32 var_49;
        wp::int32* var_50;
        wp::int32 var_51;
        wp::int32 var_52;
        const wp::int32 var_53 = 7;
        wp::int32 var_54;
        wp::int32 var_55;
        wp::int32 var_56;
        wp::int32* var_57;
        wp::int32 var_58;
        wp::int32 var_59;
        wp::int32 var_60;
        wp::int32 var_61;
        //---------
        // forward
        // def lower_numbers_kernel(below: int, first: int, lowest: array(dtype=int32)):          <L 192>
        // i = tid()                                                                              <L 194>
        var_0 = builtin_tid1d();
        // minimum = int(NO_NUMBER)                                                               <L 195>
        var_2 = wp::int(var_1);
        // for j in range(FAN):                                                                   <L 196>
        // minimum = min(minimum, lowest[(below + i) * FAN + j])                                  <L 197>
        var_4 = wp::add(var_below, var_0);
        var_6 = wp::mul(var_4, var_5);
        var_7 = wp::add(var_6, var_3);
        var_8 = wp::address(var_lowest, var_7);
        var_10 = wp::load(var_8);
        var_9 = wp::min(var_2, var_10);
        var_12 = wp::add(var_below, var_0);
        var_13 = wp::mul(var_12, var_5);
        var_14 = wp::add(var_13, var_11);
        var_15 = wp::address(var_lowest, var_14);
        var_17 = wp::load(var_15);
        var_16 = wp::min(var_9, var_17);
        var_19 = wp::add(var_below, var_0);
        var_20 = wp::mul(var_19, var_5);
        var_21 = wp::add(var_20, var_18);
        var_22 = wp::address(var_lowest, var_21);
        var_24 = wp::load(var_22);
        var_23 = wp::min(var_16, var_24);
        var_26 = wp::add(var_below, var_0);
        var_27 = wp::mul(var_26, var_5);
        var_28 = wp::add(var_27, var_25);
        var_29 = wp::address(var_lowest, var_28);
        var_31 = wp::load(var_29);
        var_30 = wp::min(var_23, var_31);
        var_33 = wp::add(var_below, var_0);
        var_34 = wp::mul(var_33, var_5);
        var_35 = wp::add(var_34, var_32);
        var_36 = wp::address(var_lowest, var_35);
        var_38 = wp::load(var_36);
        var_37 = wp::min(var_30, var_38);
        var_40 = wp::add(var_below, var_0);
        var_41 = wp::mul(var_40, var_5);
        var_42 = wp::add(var_41, var_39);
        var_43 = wp::address(var_lowest, var_42);
        var_45 = wp::load(var_43);
        var_44 = wp::min(var_37, var_45);
        var_47 = wp::add(var_below, var_0);
        var_48 = wp::mul(var_47, var_5);
        var_49 = wp::add(var_48, var_46);
        var_50 = wp::address(var_lowest, var_49);
        var_52 = wp::load(var_50);
        var_51 = wp::min(var_44, var_52);
        var_54 = wp::add(var_below, var_0);
        var_55 = wp::mul(var_54, var_5);
        var_56 = wp::add(var_55, var_53);
        var_57 = wp::address(var_lowest, var_56);
        var_59 = wp::load(var_57);
        var_58 = wp::min(var_51, var_59);
        // lowest[first * FAN + i] = minimum                                                      <L 198>
        var_60 = wp::mul(var_first, var_5);
        var_61 = wp::add(var_60, var_0);
        wp::array_store(var_lowest, var_61, var_58);
}


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


// /work/main/src/pointloom/kernels/arrays/run_medians.py:16
static CUDA_CALLABLE wp::int32 flip_bits_0(
    wp::int32 var_bits)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 0;
    bool var_2;
    const wp::int32 var_3 = 2147483647;
    wp::int32 var_4;
    wp::int32 var_5;
    //---------
    // forward
    // def flip_bits(bits: int) -> int:                                                       <L 17>
    // flipped = bits                                                                         <L 19>
    var_0 = wp::copy(var_bits);
    // if bits < 0:                                                                           <L 20>
    var_2 = (var_bits < var_1);
    if (var_2) {
        // flipped = bits ^ MAGNITUDE                                                         <L 21>
        var_4 = wp::bit_xor(var_bits, var_3);
    }
    var_5 = wp::where(var_2, var_4, var_0);
    // return flipped                                                                         <L 22>
    return var_5;
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


// /work/main/src/pointloom/kernels/arrays/run_medians.py:34
static CUDA_CALLABLE wp::float32 number_of_0(
    wp::int64 var_key)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int64 var_2;
    wp::int64 var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::float32 var_6;
    //---------
    // forward
    // def number_of(key: int64) -> float:                                                    <L 35>
    // return bits_float(flip_bits(int((key & int64(LOW_WORD)) - int64(LOWEST))))             <L 36>
    var_0 = 4294967295ll;
    var_1 = wp::bit_and(var_key, var_0);
    var_2 = 2147483648ll;
    var_3 = wp::sub(var_1, var_2);
    var_4 = wp::int(var_3);
    var_5 = flip_bits_0(var_4);
    var_6 = _bits_float_0(var_5);
    return var_6;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:143
static CUDA_CALLABLE wp::int32 _float_bits_0(
    wp::float32 var_x)
{
    //---------
    // primal vars
    wp::int32 var_0;
    //---------
    // forward
    // def _float_bits(x: wp.float32):                                                        <L 144>
    // return wp.cast(x, wp.int32)                                                            <L 145>
    var_0 = wp::cast<wp::int32>(var_x);
    return var_0;
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


// /work/main/src/pointloom/kernels/arrays/run_medians.py:16
static CUDA_CALLABLE void adj_flip_bits_0(
    wp::int32 var_bits,
    wp::int32 & adj_bits,
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


// /work/main/src/pointloom/kernels/arrays/run_medians.py:34
static CUDA_CALLABLE void adj_number_of_0(
    wp::int64 var_key,
    wp::int64 & adj_key,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:143
static CUDA_CALLABLE void adj__float_bits_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
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



extern "C" __global__ void pick_numbers_kernel_463ef13c_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int64> var_keys,
    wp::array_t<wp::int32> var_starts,
    wp::int32 var_size,
    wp::array_t<wp::float32> var_numbers)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::shape_t* var_1;
        const wp::int32 var_2 = 0;
        wp::int32 var_3;
        wp::shape_t var_4;
        const wp::int32 var_5 = 1;
        wp::int32 var_6;
        wp::int32 var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        wp::int32 var_10;
        wp::int32* var_11;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int32 var_14;
        const wp::int32 var_15 = 1;
        wp::int32 var_16;
        wp::int32* var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        const wp::int32 var_20 = 1;
        wp::int32 var_21;
        const wp::int32 var_22 = 1;
        wp::int32 var_23;
        wp::int32 var_24;
        const wp::int32 var_25 = 2;
        wp::int32 var_26;
        wp::int32 var_27;
        const wp::int32 var_28 = 3;
        wp::int32 var_29;
        wp::int32 var_30;
        wp::int32 var_31;
        wp::int64* var_32;
        wp::float32 var_33;
        wp::int64 var_34;
        wp::int64* var_35;
        wp::float32 var_36;
        wp::int64 var_37;
        wp::int32 var_38;
        wp::int64* var_39;
        wp::float32 var_40;
        wp::int64 var_41;
        const wp::int32 var_42 = 2;
        wp::int32 var_43;
        wp::int32 var_44;
        //---------
        // forward
        // def pick_numbers_kernel(keys: array(dtype=int64), starts: array(dtype=int32), size: int, numbers: array(dtype=float32)):       <L 40>
        // i = tid()                                                                              <L 42>
        var_0 = builtin_tid1d();
        // runs = starts.shape[0] - 1                                                             <L 43>
        var_1 = &(var_starts.shape);
        var_4 = wp::load(var_1);
        var_3 = wp::extract(var_4, var_2);
        var_6 = wp::sub(var_3, var_5);
        // quantity = i // runs                                                                   <L 44>
        var_7 = wp::floordiv(var_0, var_6);
        // run = i - quantity * runs                                                              <L 45>
        var_8 = wp::mul(var_7, var_6);
        var_9 = wp::sub(var_0, var_8);
        // first = quantity * size + starts[run]                                                  <L 46>
        var_10 = wp::mul(var_7, var_size);
        var_11 = wp::address(var_starts, var_9);
        var_13 = wp::load(var_11);
        var_12 = wp::add(var_10, var_13);
        // last = quantity * size + starts[run + 1] - 1                                           <L 47>
        var_14 = wp::mul(var_7, var_size);
        var_16 = wp::add(var_9, var_15);
        var_17 = wp::address(var_starts, var_16);
        var_19 = wp::load(var_17);
        var_18 = wp::add(var_14, var_19);
        var_21 = wp::sub(var_18, var_20);
        // middle = first + (last + 1 - first) // 2                                               <L 48>
        var_23 = wp::add(var_21, var_22);
        var_24 = wp::sub(var_23, var_12);
        var_26 = wp::floordiv(var_24, var_25);
        var_27 = wp::add(var_12, var_26);
        // at = 3 * quantity * runs + run                                                         <L 49>
        var_29 = wp::mul(var_28, var_7);
        var_30 = wp::mul(var_29, var_6);
        var_31 = wp::add(var_30, var_9);
        // numbers[at] = number_of(keys[first])                                                   <L 50>
        var_32 = wp::address(var_keys, var_12);
        var_34 = wp::load(var_32);
        var_33 = number_of_0(var_34);
        wp::array_store(var_numbers, var_31, var_33);
        // numbers[at + runs] = number_of(keys[middle])                                           <L 51>
        var_35 = wp::address(var_keys, var_27);
        var_37 = wp::load(var_35);
        var_36 = number_of_0(var_37);
        var_38 = wp::add(var_31, var_6);
        wp::array_store(var_numbers, var_38, var_36);
        // numbers[at + 2 * runs] = number_of(keys[last])                                         <L 52>
        var_39 = wp::address(var_keys, var_21);
        var_41 = wp::load(var_39);
        var_40 = number_of_0(var_41);
        var_43 = wp::mul(var_42, var_6);
        var_44 = wp::add(var_31, var_43);
        wp::array_store(var_numbers, var_44, var_40);
}



extern "C" __global__ void encode_numbers_kernel_e641e767_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_values,
    wp::array_t<wp::int32> var_runs,
    wp::int32 var_run_count,
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
        wp::shape_t* var_1;
        const wp::int32 var_2 = 0;
        wp::int32 var_3;
        wp::shape_t var_4;
        wp::int32 var_5;
        wp::int32 var_6;
        wp::shape_t* var_7;
        const wp::int32 var_8 = 0;
        wp::int32 var_9;
        wp::shape_t var_10;
        wp::int32 var_11;
        wp::int32 var_12;
        wp::int32* var_13;
        wp::int32 var_14;
        wp::int32 var_15;
        wp::float32* var_16;
        wp::int32 var_17;
        wp::float32 var_18;
        wp::int32 var_19;
        wp::int64 var_20;
        wp::int64 var_21;
        wp::int64 var_22;
        wp::int64 var_23;
        wp::int64 var_24;
        wp::int64 var_25;
        wp::int64 var_26;
        //---------
        // forward
        // def encode_numbers_kernel(values, runs, run_count, keys__keys, keys__positions):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // quantity = i // runs.shape[0]                                                          <L 3>
        var_1 = &(var_runs.shape);
        var_4 = wp::load(var_1);
        var_3 = wp::extract(var_4, var_2);
        var_5 = wp::floordiv(var_0, var_3);
        // run = quantity * run_count + runs[i - quantity * runs.shape[0]]                        <L 4>
        var_6 = wp::mul(var_5, var_run_count);
        var_7 = &(var_runs.shape);
        var_10 = wp::load(var_7);
        var_9 = wp::extract(var_10, var_8);
        var_11 = wp::mul(var_5, var_9);
        var_12 = wp::sub(var_0, var_11);
        var_13 = wp::address(var_runs, var_12);
        var_15 = wp::load(var_13);
        var_14 = wp::add(var_6, var_15);
        // number = int64(flip_bits(float_bits(values[i]))) + int64(LOWEST)                       <L 5>
        var_16 = wp::address(var_values, var_0);
        var_18 = wp::load(var_16);
        var_17 = _float_bits_0(var_18);
        var_19 = flip_bits_0(var_17);
        var_20 = wp::int64(var_19);
        var_21 = 2147483648ll;
        var_22 = wp::add(var_20, var_21);
        // put_key(i, int64(run) << int64(KEY_BITS) | number, keys__keys, keys__positions)        <L 6>
        var_23 = wp::int64(var_14);
        var_24 = 32ll;
        var_25 = wp::lshift(var_23, var_24);
        var_26 = wp::bit_or(var_25, var_22);
        put_key_0(var_0, var_26, var_keys__keys, var_keys__positions);
}


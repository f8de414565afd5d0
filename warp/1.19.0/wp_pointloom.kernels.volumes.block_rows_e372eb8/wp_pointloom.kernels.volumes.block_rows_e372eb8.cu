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


// <pointloom.kernels.volumes.block_rows.signs_of>:1
static CUDA_CALLABLE wp::int32 signs_of_0(
    wp::int32 var_voxel,
    wp::int32 var_index,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::float32 var_seen__threshold)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    wp::uint16* var_2;
    wp::float32 var_3;
    wp::uint16 var_4;
    bool var_5;
    const wp::int32 var_6 = 1;
    const wp::int32 var_7 = 16;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::float32* var_10;
    const wp::float32 var_11 = 0.0;
    bool var_12;
    wp::float32 var_13;
    const wp::int32 var_14 = 1;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    //---------
    // forward
    // def signs_of(voxel, index, seen__blocks__distances, seen__blocks__weights, seen__threshold):       <L 1>
    // word = int(0)                                                                          <L 3>
    var_1 = wp::int(var_0);
    // if float(seen__blocks__weights[voxel]) > seen__threshold:                              <L 4>
    var_2 = wp::address(var_seen__blocks__weights, var_voxel);
    var_4 = wp::load(var_2);
    var_3 = wp::float(var_4);
    var_5 = (var_3 > var_seen__threshold);
    if (var_5) {
        // word = 1 << index + VALID                                                          <L 5>
        var_8 = wp::add(var_index, var_7);
        var_9 = wp::lshift(var_6, var_8);
        // if seen__blocks__distances[voxel] < 0.0:                                           <L 6>
        var_10 = wp::address(var_seen__blocks__distances, var_voxel);
        var_13 = wp::load(var_10);
        var_12 = (var_13 < var_11);
        if (var_12) {
            // word = word | 1 << index                                                       <L 7>
            var_15 = wp::lshift(var_14, var_index);
            var_16 = wp::bit_or(var_9, var_15);
        }
        var_17 = wp::where(var_12, var_16, var_9);
    }
    var_18 = wp::where(var_5, var_17, var_1);
    // return word                                                                            <L 8>
    return var_18;
}


// /work/main/src/pointloom/kernels/arrays/block_keys.py:16
static CUDA_CALLABLE wp::vec_t<3, wp::int32> key_block_0(
    wp::int64 var_key)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    const wp::int32 var_1 = 21;
    wp::int32 var_2;
    const wp::int32 var_3 = 1;
    wp::int32 var_4;
    wp::int64 var_5;
    wp::int64 var_6;
    wp::int64 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 1048576;
    wp::int32 var_10;
    wp::int64 var_11;
    wp::int64 var_12;
    wp::int64 var_13;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::int64 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::vec_t<3, wp::int32> var_19;
    //---------
    // forward
    // def key_block(key: int64) -> vec3i:                                                    <L 17>
    // low = int64((1 << 21) - 1)                                                             <L 18>
    var_2 = wp::lshift(var_0, var_1);
    var_4 = wp::sub(var_2, var_3);
    var_5 = wp::int64(var_4);
    // x = int(key >> int64(TWO_AXES)) - BIAS                                                 <L 19>
    var_6 = 42ll;
    var_7 = wp::rshift(var_key, var_6);
    var_8 = wp::int(var_7);
    var_10 = wp::sub(var_8, var_9);
    // y = int((key >> int64(AXIS_BITS)) & low) - BIAS                                        <L 20>
    var_11 = 21ll;
    var_12 = wp::rshift(var_key, var_11);
    var_13 = wp::bit_and(var_12, var_5);
    var_14 = wp::int(var_13);
    var_15 = wp::sub(var_14, var_9);
    // z = int(key & low) - BIAS                                                              <L 21>
    var_16 = wp::bit_and(var_key, var_5);
    var_17 = wp::int(var_16);
    var_18 = wp::sub(var_17, var_9);
    // return vec3i(x, y, z)                                                                  <L 22>
    var_19 = wp::vec_t<3, wp::int32>(var_10, var_15, var_18);
    return var_19;
}


// /work/main/src/pointloom/kernels/arrays/block_keys.py:10
static CUDA_CALLABLE wp::int64 block_key_0(
    wp::int32 var_x,
    wp::int32 var_y,
    wp::int32 var_z)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1048576;
    wp::int32 var_1;
    wp::int64 var_2;
    wp::int64 var_3;
    wp::int64 var_4;
    wp::int32 var_5;
    wp::int64 var_6;
    wp::int64 var_7;
    wp::int64 var_8;
    wp::int64 var_9;
    wp::int32 var_10;
    wp::int64 var_11;
    wp::int64 var_12;
    //---------
    // forward
    // def block_key(x: int, y: int, z: int) -> int64:                                        <L 11>
    // high = (int64(x + BIAS) << int64(AXIS_BITS)) | int64(y + BIAS)                         <L 12>
    var_1 = wp::add(var_x, var_0);
    var_2 = wp::int64(var_1);
    var_3 = 21ll;
    var_4 = wp::lshift(var_2, var_3);
    var_5 = wp::add(var_y, var_0);
    var_6 = wp::int64(var_5);
    var_7 = wp::bit_or(var_4, var_6);
    // return (high << int64(AXIS_BITS)) | int64(z + BIAS)                                    <L 13>
    var_8 = wp::int64(var_3);
    var_9 = wp::lshift(var_7, var_8);
    var_10 = wp::add(var_z, var_0);
    var_11 = wp::int64(var_10);
    var_12 = wp::bit_or(var_9, var_11);
    return var_12;
}


// <pointloom.kernels.arrays.hash_table.mix_bits>:1
static CUDA_CALLABLE wp::int64 mix_bits_0(
    wp::int64 var_key)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int64 var_2;
    wp::int64 var_3;
    wp::int64 var_4;
    wp::int64 var_5;
    wp::int64 var_6;
    wp::int64 var_7;
    wp::int64 var_8;
    wp::int64 var_9;
    wp::int64 var_10;
    wp::int64 var_11;
    //---------
    // forward
    // def mix_bits(key):                                                                     <L 1>
    // h = key ^ key >> int64(33) & int64(2147483647)                                         <L 3>
    var_0 = 33ll;
    var_1 = wp::rshift(var_key, var_0);
    var_2 = 2147483647ll;
    var_3 = wp::bit_and(var_1, var_2);
    var_4 = wp::bit_xor(var_key, var_3);
    // h = h * int64(-49064778989728563)                                                      <L 4>
    var_5 = -49064778989728563ll;
    var_6 = wp::mul(var_4, var_5);
    // return h ^ h >> int64(29) & int64(34359738367)                                         <L 5>
    var_7 = 29ll;
    var_8 = wp::rshift(var_6, var_7);
    var_9 = 34359738367ll;
    var_10 = wp::bit_and(var_8, var_9);
    var_11 = wp::bit_xor(var_6, var_10);
    return var_11;
}


// <pointloom.kernels.arrays.hash_table.find_slot>:1
static CUDA_CALLABLE wp::int32 find_slot_0(
    wp::int64 var_key,
    wp::array_t<wp::int64> var_table__keys,
    wp::int64 var_table__mask)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int32 var_2;
    wp::int64* var_3;
    bool var_4;
    wp::int64 var_5;
    wp::int64 var_6;
    wp::int64 var_7;
    wp::int64 var_8;
    wp::int32 var_9;
    //---------
    // forward
    // def find_slot(key, table__keys, table__mask):                                          <L 1>
    // slot = mix_bits(key) & table__mask                                                     <L 3>
    var_0 = mix_bits_0(var_key);
    var_1 = wp::bit_and(var_0, var_table__mask);
    // while table__keys[int(slot)] < key:                                                    <L 4>
    start_while_0:;
    var_2 = wp::int(var_1);
    var_3 = wp::address(var_table__keys, var_2);
    var_5 = wp::load(var_3);
    var_4 = (var_5 < var_key);
    if ((var_4) == false) goto end_while_0;
        // slot = slot + int64(1) & table__mask                                               <L 5>
        var_6 = 1ll;
        var_7 = wp::add(var_1, var_6);
        var_8 = wp::bit_and(var_7, var_table__mask);
        wp::assign(var_1, var_8);
    goto start_while_0;
    end_while_0:;
    // return int(slot)                                                                       <L 6>
    var_9 = wp::int(var_1);
    return var_9;
}


// <pointloom.kernels.arrays.hash_table.find_position>:1
static CUDA_CALLABLE wp::int32 find_position_0(
    wp::int64 var_key,
    wp::array_t<wp::int64> var_table__keys,
    wp::array_t<wp::int32> var_table__positions,
    wp::int64 var_table__mask)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = -1;
    wp::int32 var_2;
    wp::int64* var_3;
    bool var_4;
    wp::int64 var_5;
    wp::int32* var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    //---------
    // forward
    // def find_position(key, table__keys, table__positions, table__mask):                    <L 1>
    // slot = find_slot(key, table__keys, table__mask)                                        <L 2>
    var_0 = find_slot_0(var_key, var_table__keys, var_table__mask);
    // position = int(-1)                                                                     <L 3>
    var_2 = wp::int(var_1);
    // if table__keys[slot] == key:                                                           <L 4>
    var_3 = wp::address(var_table__keys, var_0);
    var_5 = wp::load(var_3);
    var_4 = (var_5 == var_key);
    if (var_4) {
        // position = table__positions[slot]                                                  <L 5>
        var_6 = wp::address(var_table__positions, var_0);
        var_8 = wp::load(var_6);
        var_7 = wp::copy(var_8);
    }
    var_9 = wp::where(var_4, var_7, var_2);
    // return position                                                                        <L 6>
    return var_9;
}


// <pointloom.kernels.volumes.block_rows.signs_of>:1
static CUDA_CALLABLE void adj_signs_of_0(
    wp::int32 var_voxel,
    wp::int32 var_index,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::float32 var_seen__threshold,
    wp::int32 & adj_voxel,
    wp::int32 & adj_index,
    wp::array_t<wp::float32> & adj_seen__blocks__distances,
    wp::array_t<wp::uint16> & adj_seen__blocks__weights,
    wp::float32 & adj_seen__threshold,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/block_keys.py:16
static CUDA_CALLABLE void adj_key_block_0(
    wp::int64 var_key,
    wp::int64 & adj_key,
    wp::vec_t<3, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/block_keys.py:10
static CUDA_CALLABLE void adj_block_key_0(
    wp::int32 var_x,
    wp::int32 var_y,
    wp::int32 var_z,
    wp::int32 & adj_x,
    wp::int32 & adj_y,
    wp::int32 & adj_z,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.hash_table.mix_bits>:1
static CUDA_CALLABLE void adj_mix_bits_0(
    wp::int64 var_key,
    wp::int64 & adj_key,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.hash_table.find_slot>:1
static CUDA_CALLABLE void adj_find_slot_0(
    wp::int64 var_key,
    wp::array_t<wp::int64> var_table__keys,
    wp::int64 var_table__mask,
    wp::int64 & adj_key,
    wp::array_t<wp::int64> & adj_table__keys,
    wp::int64 & adj_table__mask,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.hash_table.find_position>:1
static CUDA_CALLABLE void adj_find_position_0(
    wp::int64 var_key,
    wp::array_t<wp::int64> var_table__keys,
    wp::array_t<wp::int32> var_table__positions,
    wp::int64 var_table__mask,
    wp::int64 & adj_key,
    wp::array_t<wp::int64> & adj_table__keys,
    wp::array_t<wp::int32> & adj_table__positions,
    wp::int64 & adj_table__mask,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void pack_rows_kernel_423c3e33_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::array_t<wp::int32> var_seen__neighbors,
    wp::float32 var_seen__threshold,
    wp::array_t<wp::int32> var_words)
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
        const wp::int32 var_3 = 0;
        const wp::int32 var_4 = 8;
        wp::int32 var_5;
        wp::int32 var_6;
        wp::int32 var_7;
        wp::int32 var_8;
        const wp::int32 var_9 = 1;
        wp::int32 var_10;
        wp::int32 var_11;
        wp::int32 var_12;
        wp::int32 var_13;
        const wp::int32 var_14 = 2;
        wp::int32 var_15;
        wp::int32 var_16;
        wp::int32 var_17;
        wp::int32 var_18;
        const wp::int32 var_19 = 3;
        wp::int32 var_20;
        wp::int32 var_21;
        wp::int32 var_22;
        wp::int32 var_23;
        const wp::int32 var_24 = 4;
        wp::int32 var_25;
        wp::int32 var_26;
        wp::int32 var_27;
        wp::int32 var_28;
        const wp::int32 var_29 = 5;
        wp::int32 var_30;
        wp::int32 var_31;
        wp::int32 var_32;
        wp::int32 var_33;
        const wp::int32 var_34 = 6;
        wp::int32 var_35;
        wp::int32 var_36;
        wp::int32 var_37;
        wp::int32 var_38;
        const wp::int32 var_39 = 7;
        wp::int32 var_40;
        wp::int32 var_41;
        wp::int32 var_42;
        wp::int32 var_43;
        const wp::int32 var_44 = 64;
        wp::int32 var_45;
        const wp::int32 var_46 = 27;
        wp::int32 var_47;
        const wp::int32 var_48 = 14;
        wp::int32 var_49;
        wp::int32* var_50;
        wp::int32 var_51;
        wp::int32 var_52;
        const wp::int32 var_53 = 0;
        bool var_54;
        wp::int32 var_55;
        wp::int32 var_56;
        wp::int32 var_57;
        wp::int32 var_58;
        wp::int32 var_59;
        wp::int32 var_60;
        wp::int32 var_61;
        //---------
        // forward
        // def pack_rows_kernel(seen__blocks__distances, seen__blocks__weights, seen__neighbors, seen__threshold, words):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // word = int(0)                                                                          <L 3>
        var_2 = wp::int(var_1);
        // for j in range(SIDE):                                                                  <L 4>
        // word = word | signs_of(i * SIDE + j, j, seen__blocks__distances, seen__blocks__weights, seen__threshold)       <L 5>
        var_5 = wp::mul(var_0, var_4);
        var_6 = wp::add(var_5, var_3);
        var_7 = signs_of_0(var_6, var_3, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
        var_8 = wp::bit_or(var_2, var_7);
        var_10 = wp::mul(var_0, var_4);
        var_11 = wp::add(var_10, var_9);
        var_12 = signs_of_0(var_11, var_9, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
        var_13 = wp::bit_or(var_8, var_12);
        var_15 = wp::mul(var_0, var_4);
        var_16 = wp::add(var_15, var_14);
        var_17 = signs_of_0(var_16, var_14, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
        var_18 = wp::bit_or(var_13, var_17);
        var_20 = wp::mul(var_0, var_4);
        var_21 = wp::add(var_20, var_19);
        var_22 = signs_of_0(var_21, var_19, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
        var_23 = wp::bit_or(var_18, var_22);
        var_25 = wp::mul(var_0, var_4);
        var_26 = wp::add(var_25, var_24);
        var_27 = signs_of_0(var_26, var_24, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
        var_28 = wp::bit_or(var_23, var_27);
        var_30 = wp::mul(var_0, var_4);
        var_31 = wp::add(var_30, var_29);
        var_32 = signs_of_0(var_31, var_29, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
        var_33 = wp::bit_or(var_28, var_32);
        var_35 = wp::mul(var_0, var_4);
        var_36 = wp::add(var_35, var_34);
        var_37 = signs_of_0(var_36, var_34, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
        var_38 = wp::bit_or(var_33, var_37);
        var_40 = wp::mul(var_0, var_4);
        var_41 = wp::add(var_40, var_39);
        var_42 = signs_of_0(var_41, var_39, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
        var_43 = wp::bit_or(var_38, var_42);
        // above = seen__neighbors[i // ROWS * AROUND + 14]                                       <L 6>
        var_45 = wp::floordiv(var_0, var_44);
        var_47 = wp::mul(var_45, var_46);
        var_49 = wp::add(var_47, var_48);
        var_50 = wp::address(var_seen__neighbors, var_49);
        var_52 = wp::load(var_50);
        var_51 = wp::copy(var_52);
        // if above >= 0:                                                                         <L 7>
        var_54 = (var_51 >= var_53);
        if (var_54) {
            // word = word | signs_of((above * ROWS + i % ROWS) * SIDE, SIDE, seen__blocks__distances, seen__blocks__weights, seen__threshold)       <L 8>
            var_55 = wp::mul(var_51, var_44);
            var_56 = wp::mod(var_0, var_44);
            var_57 = wp::add(var_55, var_56);
            var_58 = wp::mul(var_57, var_4);
            var_59 = signs_of_0(var_58, var_4, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
            var_60 = wp::bit_or(var_43, var_59);
        }
        var_61 = wp::where(var_54, var_60, var_43);
        // words[i] = word                                                                        <L 9>
        wp::array_store(var_words, var_0, var_61);
}



extern "C" __global__ void find_neighbors_kernel_d882895c_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int64> var_blocks__keys,
    wp::array_t<wp::int64> var_blocks__table__keys,
    wp::array_t<wp::int32> var_blocks__table__positions,
    wp::int64 var_blocks__table__mask,
    wp::int32 var_known,
    wp::array_t<wp::int32> var_neighbors)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 27;
        wp::int32 var_2;
        wp::int32 var_3;
        wp::int64* var_4;
        wp::vec_t<3, wp::int32> var_5;
        wp::int64 var_6;
        wp::int32 var_7;
        const wp::int32 var_8 = 0;
        wp::int32 var_9;
        const wp::int32 var_10 = 9;
        wp::int32 var_11;
        wp::int32 var_12;
        const wp::int32 var_13 = 1;
        wp::int32 var_14;
        const wp::int32 var_15 = 1;
        wp::int32 var_16;
        const wp::int32 var_17 = 3;
        wp::int32 var_18;
        const wp::int32 var_19 = 3;
        wp::int32 var_20;
        wp::int32 var_21;
        const wp::int32 var_22 = 1;
        wp::int32 var_23;
        const wp::int32 var_24 = 2;
        wp::int32 var_25;
        const wp::int32 var_26 = 3;
        wp::int32 var_27;
        wp::int32 var_28;
        const wp::int32 var_29 = 1;
        wp::int32 var_30;
        const wp::int32 var_31 = -1;
        wp::int32 var_32;
        wp::int32 var_33;
        wp::int32 var_34;
        wp::int32 var_35;
        wp::int32 var_36;
        wp::int32 var_37;
        const wp::int32 var_38 = 1048576;
        const wp::int32 var_39 = 1;
        wp::int32 var_40;
        bool var_41;
        wp::int64 var_42;
        wp::int32 var_43;
        wp::int32 var_44;
        wp::int32 var_45;
        wp::int32 var_46;
        bool var_47;
        const wp::int32 var_48 = 0;
        bool var_49;
        bool var_50;
        wp::int32 var_51;
        wp::int32 var_52;
        const wp::int32 var_53 = 1;
        wp::int32 var_54;
        wp::int32 var_55;
        //---------
        // forward
        // def find_neighbors_kernel(blocks__keys, blocks__table__keys, blocks__table__positions, blocks__table__mask, known, neighbors):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // position = known + i // AROUND                                                         <L 4>
        var_2 = wp::floordiv(var_0, var_1);
        var_3 = wp::add(var_known, var_2);
        // block = key_block(blocks__keys[position])                                              <L 5>
        var_4 = wp::address(var_blocks__keys, var_3);
        var_6 = wp::load(var_4);
        var_5 = key_block_0(var_6);
        // side = i % AROUND                                                                      <L 6>
        var_7 = wp::mod(var_0, var_1);
        // x = block[0] + side // 9 - 1                                                           <L 7>
        var_9 = wp::extract(var_5, var_8);
        var_11 = wp::floordiv(var_7, var_10);
        var_12 = wp::add(var_9, var_11);
        var_14 = wp::sub(var_12, var_13);
        // y = block[1] + side // 3 % 3 - 1                                                       <L 8>
        var_16 = wp::extract(var_5, var_15);
        var_18 = wp::floordiv(var_7, var_17);
        var_20 = wp::mod(var_18, var_19);
        var_21 = wp::add(var_16, var_20);
        var_23 = wp::sub(var_21, var_22);
        // z = block[2] + side % 3 - 1                                                            <L 9>
        var_25 = wp::extract(var_5, var_24);
        var_27 = wp::mod(var_7, var_26);
        var_28 = wp::add(var_25, var_27);
        var_30 = wp::sub(var_28, var_29);
        // neighbor = int(-1)                                                                     <L 10>
        var_32 = wp::int(var_31);
        // if max(max(abs(x), abs(y)), abs(z)) < BIAS - 1:                                        <L 11>
        var_33 = wp::abs(var_14);
        var_34 = wp::abs(var_23);
        var_35 = wp::max(var_33, var_34);
        var_36 = wp::abs(var_30);
        var_37 = wp::max(var_35, var_36);
        var_40 = wp::sub(var_38, var_39);
        var_41 = (var_37 < var_40);
        if (var_41) {
            // neighbor = find_position(block_key(x, y, z), blocks__table__keys, blocks__table__positions, blocks__table__mask)       <L 12>
            var_42 = block_key_0(var_14, var_23, var_30);
            var_43 = find_position_0(var_42, var_blocks__table__keys, var_blocks__table__positions, var_blocks__table__mask);
        }
        var_44 = wp::where(var_41, var_43, var_32);
        // neighbors[position * AROUND + side] = neighbor                                         <L 13>
        var_45 = wp::mul(var_3, var_1);
        var_46 = wp::add(var_45, var_7);
        wp::array_store(var_neighbors, var_46, var_44);
        // if neighbor >= 0 and neighbor < known:                                                 <L 14>
        var_49 = (var_44 >= var_48);
        var_47 = var_49;
        if (var_47) {
            var_50 = (var_44 < var_known);
            var_47 = var_47 && var_50;
        }
        if (var_47) {
            // neighbors[neighbor * AROUND + AROUND - 1 - side] = position                        <L 15>
            var_51 = wp::mul(var_44, var_1);
            var_52 = wp::add(var_51, var_1);
            var_54 = wp::sub(var_52, var_53);
            var_55 = wp::sub(var_54, var_7);
            wp::array_store(var_neighbors, var_55, var_3);
        }
}


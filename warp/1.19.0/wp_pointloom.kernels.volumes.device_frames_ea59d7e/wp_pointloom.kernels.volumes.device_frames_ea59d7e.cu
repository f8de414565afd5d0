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


// /work/main/src/pointloom/kernels/volumes/device_frames.py:142
static CUDA_CALLABLE wp::int64 cell_key_0(
    wp::int32 var_cell,
    wp::array_t<wp::float64> var_record)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 27;
    const wp::int32 var_1 = 1;
    wp::int32 var_2;
    wp::float64* var_3;
    wp::int32 var_4;
    wp::float64 var_5;
    const wp::int32 var_6 = 2;
    wp::int32 var_7;
    wp::float64* var_8;
    wp::int32 var_9;
    wp::float64 var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    const wp::int32 var_13 = 24;
    wp::float64* var_14;
    wp::int32 var_15;
    wp::float64 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::int32 var_19;
    const wp::int32 var_20 = 1;
    wp::int32 var_21;
    wp::float64* var_22;
    wp::int32 var_23;
    wp::float64 var_24;
    wp::int32 var_25;
    wp::int32 var_26;
    const wp::int32 var_27 = 2;
    wp::int32 var_28;
    wp::float64* var_29;
    wp::int32 var_30;
    wp::float64 var_31;
    wp::int32 var_32;
    wp::int64 var_33;
    //---------
    // forward
    // def cell_key(cell: int, record: array(dtype=float64)) -> int64:                        <L 143>
    // ny = int(record[SIZE + 1])                                                             <L 144>
    var_2 = wp::add(var_0, var_1);
    var_3 = wp::address(var_record, var_2);
    var_5 = wp::load(var_3);
    var_4 = wp::int(var_5);
    // nz = int(record[SIZE + 2])                                                             <L 145>
    var_7 = wp::add(var_0, var_6);
    var_8 = wp::address(var_record, var_7);
    var_10 = wp::load(var_8);
    var_9 = wp::int(var_10);
    // x = cell // (ny * nz) + int(record[LOW])                                               <L 146>
    var_11 = wp::mul(var_4, var_9);
    var_12 = wp::floordiv(var_cell, var_11);
    var_14 = wp::address(var_record, var_13);
    var_16 = wp::load(var_14);
    var_15 = wp::int(var_16);
    var_17 = wp::add(var_12, var_15);
    // y = (cell // nz) % ny + int(record[LOW + 1])                                           <L 147>
    var_18 = wp::floordiv(var_cell, var_9);
    var_19 = wp::mod(var_18, var_4);
    var_21 = wp::add(var_13, var_20);
    var_22 = wp::address(var_record, var_21);
    var_24 = wp::load(var_22);
    var_23 = wp::int(var_24);
    var_25 = wp::add(var_19, var_23);
    // return block_key(x, y, cell % nz + int(record[LOW + 2]))                               <L 148>
    var_26 = wp::mod(var_cell, var_9);
    var_28 = wp::add(var_13, var_27);
    var_29 = wp::address(var_record, var_28);
    var_31 = wp::load(var_29);
    var_30 = wp::int(var_31);
    var_32 = wp::add(var_26, var_30);
    var_33 = block_key_0(var_17, var_25, var_32);
    return var_33;
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


// <pointloom.kernels.arrays.hash_table.insert_entry>:1
static CUDA_CALLABLE void insert_entry_0(
    wp::int64 var_entry,
    wp::int32 var_low_bits,
    wp::array_t<wp::int64> var_entries,
    wp::int64 var_mask)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int64 var_2;
    wp::int64 var_3;
    wp::int64 var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    const wp::int32 var_7 = 1;
    bool var_8;
    wp::int32 var_9;
    wp::int64 var_10;
    bool var_11;
    wp::int64 var_12;
    bool var_13;
    wp::int64 var_14;
    wp::int64 var_15;
    wp::int64 var_16;
    wp::int64 var_17;
    bool var_18;
    const wp::int32 var_19 = 0;
    bool var_20;
    wp::int64 var_21;
    wp::int64 var_22;
    wp::int64 var_23;
    wp::int64 var_24;
    wp::int64 var_25;
    wp::int64 var_26;
    wp::int64 var_27;
    wp::int32 var_28;
    //---------
    // forward
    // def insert_entry(entry, low_bits, entries, mask):                                      <L 1>
    // carried = entry                                                                        <L 3>
    var_0 = wp::copy(var_entry);
    // slot = mix_bits(carried >> int64(low_bits)) & mask                                     <L 4>
    var_1 = wp::int64(var_low_bits);
    var_2 = wp::rshift(var_0, var_1);
    var_3 = mix_bits_0(var_2);
    var_4 = wp::bit_and(var_3, var_mask);
    // carrying = int(1)                                                                      <L 5>
    var_6 = wp::int(var_5);
    // while carrying == 1:                                                                   <L 6>
    start_while_0:;
    var_8 = (var_6 == var_7);
    if ((var_8) == false) goto end_while_0;
        // old = atomic_min(entries, int(slot), carried)                                      <L 7>
        var_9 = wp::int(var_4);
        var_10 = wp::atomic_min(var_entries, var_9, var_0);
        // if old == int64(EMPTY) or old >> int64(low_bits) == carried >> int64(low_bits):       <L 8>
        var_12 = 9223372036854775807ll;
        var_13 = (var_10 == var_12);
        var_11 = var_13;
        if (!var_11) {
            var_14 = wp::int64(var_low_bits);
            var_15 = wp::rshift(var_10, var_14);
            var_16 = wp::int64(var_low_bits);
            var_17 = wp::rshift(var_0, var_16);
            var_18 = (var_15 == var_17);
            var_11 = var_11 || var_18;
        }
        if (var_11) {
            // carrying = 0                                                                   <L 9>
        }
        if (!var_11) {
            // if old > carried:                                                              <L 11>
            var_20 = (var_10 > var_0);
            if (var_20) {
                // carried = old                                                              <L 12>
                var_21 = wp::copy(var_10);
            }
            var_22 = wp::where(var_20, var_21, var_0);
            // slot = slot + int64(1) & mask                                                  <L 13>
            var_23 = 1ll;
            var_24 = wp::add(var_4, var_23);
            var_25 = wp::bit_and(var_24, var_mask);
        }
        var_26 = wp::where(var_11, var_0, var_22);
        var_27 = wp::where(var_11, var_4, var_25);
        var_28 = wp::where(var_11, var_19, var_6);
        wp::assign(var_0, var_26);
        wp::assign(var_4, var_27);
        wp::assign(var_6, var_28);
    goto start_while_0;
    end_while_0:;
}


// <pointloom.kernels.arrays.hash_table.insert_key>:1
static CUDA_CALLABLE void insert_key_0(
    wp::int64 var_key,
    wp::array_t<wp::int64> var_table__keys,
    wp::int64 var_table__mask)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    //---------
    // forward
    // def insert_key(key, table__keys, table__mask):                                         <L 1>
    // insert_entry(key, 0, table__keys, table__mask)                                         <L 2>
    insert_entry_0(var_key, var_0, var_table__keys, var_table__mask);
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


// /work/main/src/pointloom/kernels/volumes/device_frames.py:142
static CUDA_CALLABLE void adj_cell_key_0(
    wp::int32 var_cell,
    wp::array_t<wp::float64> var_record,
    wp::int32 & adj_cell,
    wp::array_t<wp::float64> & adj_record,
    wp::int64 & adj_ret)
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


// <pointloom.kernels.arrays.hash_table.insert_entry>:1
static CUDA_CALLABLE void adj_insert_entry_0(
    wp::int64 var_entry,
    wp::int32 var_low_bits,
    wp::array_t<wp::int64> var_entries,
    wp::int64 var_mask,
    wp::int64 & adj_entry,
    wp::int32 & adj_low_bits,
    wp::array_t<wp::int64> & adj_entries,
    wp::int64 & adj_mask)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.hash_table.insert_key>:1
static CUDA_CALLABLE void adj_insert_key_0(
    wp::int64 var_key,
    wp::array_t<wp::int64> var_table__keys,
    wp::int64 var_table__mask,
    wp::int64 & adj_key,
    wp::array_t<wp::int64> & adj_table__keys,
    wp::int64 & adj_table__mask)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void store_all_positions_kernel_1b17b999_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_counts,
    wp::array_t<wp::int64> var_keys,
    wp::array_t<wp::int64> var_table__keys,
    wp::array_t<wp::int32> var_table__positions,
    wp::int64 var_table__mask)
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
        wp::int32* var_2;
        const wp::int32 var_3 = 2;
        wp::int32* var_4;
        wp::int32 var_5;
        wp::int32 var_6;
        wp::int32 var_7;
        bool var_8;
        wp::int64* var_9;
        wp::int32 var_10;
        wp::int64 var_11;
        //---------
        // forward
        // def store_all_positions_kernel(counts, keys, table__keys, table__positions, table__mask):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // if i < counts[COUNTED] + counts[MISSING]:                                              <L 4>
        var_2 = wp::address(var_counts, var_1);
        var_4 = wp::address(var_counts, var_3);
        var_6 = wp::load(var_2);
        var_7 = wp::load(var_4);
        var_5 = wp::add(var_6, var_7);
        var_8 = (var_0 < var_5);
        if (var_8) {
            // table__positions[find_slot(keys[i], table__keys, table__mask)] = i                 <L 5>
            var_9 = wp::address(var_keys, var_0);
            var_11 = wp::load(var_9);
            var_10 = find_slot_0(var_11, var_table__keys, var_table__mask);
            wp::array_store(var_table__positions, var_10, var_0);
        }
}



extern "C" __global__ void count_touched_kernel_45d5092d_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float64> var_record,
    wp::array_t<wp::int64> var_table__keys,
    wp::array_t<wp::int32> var_table__positions,
    wp::int64 var_table__mask,
    wp::int32 var_groups,
    wp::array_t<wp::uint8> var_grid,
    wp::array_t<wp::int32> var_sizes)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::uint8* var_1;
        const wp::int32 var_2 = 0;
        wp::uint8 var_3;
        bool var_4;
        wp::uint8 var_5;
        const wp::int32 var_6 = 32;
        wp::int32 var_7;
        const wp::int32 var_8 = 1;
        wp::int32 var_9;
        wp::int64 var_10;
        wp::int32 var_11;
        const wp::int32 var_12 = 0;
        bool var_13;
        const wp::int32 var_14 = 2;
        wp::uint8 var_15;
        wp::int32 var_16;
        wp::int32 var_17;
        const wp::int32 var_18 = 1;
        wp::int32 var_19;
        //---------
        // forward
        // def count_touched_kernel(record, table__keys, table__positions, table__mask, groups, grid, sizes):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // if grid[i] != uint8(0):                                                                <L 4>
        var_1 = wp::address(var_grid, var_0);
        var_3 = wp::uint8(var_2);
        var_5 = wp::load(var_1);
        var_4 = (var_5 != var_3);
        if (var_4) {
            // atomic_add(sizes, i // GROUP, 1)                                                   <L 5>
            var_7 = wp::floordiv(var_0, var_6);
            var_9 = wp::atomic_add(var_sizes, var_7, var_8);
            // if find_position(cell_key(i, record), table__keys, table__positions, table__mask) < 0:       <L 6>
            var_10 = cell_key_0(var_0, var_record);
            var_11 = find_position_0(var_10, var_table__keys, var_table__positions, var_table__mask);
            var_13 = (var_11 < var_12);
            if (var_13) {
                // grid[i] = uint8(LACKED)                                                        <L 7>
                var_15 = wp::uint8(var_14);
                wp::array_store(var_grid, var_0, var_15);
                // atomic_add(sizes, groups + i // GROUP, 1)                                      <L 8>
                var_16 = wp::floordiv(var_0, var_6);
                var_17 = wp::add(var_groups, var_16);
                var_19 = wp::atomic_add(var_sizes, var_17, var_18);
            }
        }
}



extern "C" __global__ void list_touched_kernel_7a5a0699_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float64> var_record,
    wp::array_t<wp::int64> var_table__keys,
    wp::array_t<wp::int32> var_table__positions,
    wp::int64 var_table__mask,
    wp::array_t<wp::uint8> var_grid,
    wp::array_t<wp::int32> var_offsets,
    wp::int32 var_groups,
    wp::array_t<wp::int32> var_counts,
    wp::array_t<wp::int64> var_keys,
    wp::array_t<wp::int32> var_touched)
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
        wp::int32* var_3;
        wp::int32 var_4;
        wp::int32 var_5;
        const wp::int32 var_6 = 1;
        const wp::int32 var_7 = 2;
        wp::int32 var_8;
        wp::int32* var_9;
        wp::int32* var_10;
        wp::int32 var_11;
        wp::int32 var_12;
        wp::int32 var_13;
        const wp::int32 var_14 = 2;
        wp::uint8* var_15;
        const wp::int32 var_16 = 0;
        wp::uint8 var_17;
        bool var_18;
        wp::uint8 var_19;
        const wp::int32 var_20 = 32;
        wp::int32 var_21;
        wp::int32* var_22;
        wp::int32 var_23;
        wp::int32 var_24;
        const wp::int32 var_25 = 0;
        wp::int32* var_26;
        wp::int32 var_27;
        wp::int32* var_28;
        wp::int32 var_29;
        wp::int32 var_30;
        wp::int32 var_31;
        wp::int32* var_32;
        wp::int32 var_33;
        wp::int32 var_34;
        wp::int32 var_35;
        wp::range_t var_36;
        wp::int32 var_37;
        wp::uint8* var_38;
        const wp::int32 var_39 = 0;
        wp::uint8 var_40;
        bool var_41;
        wp::uint8 var_42;
        const wp::int32 var_43 = 1;
        wp::int32 var_44;
        wp::int32 var_45;
        wp::uint8* var_46;
        const wp::int32 var_47 = 2;
        wp::uint8 var_48;
        bool var_49;
        wp::uint8 var_50;
        const wp::int32 var_51 = 1;
        wp::int32 var_52;
        wp::int32 var_53;
        wp::int64 var_54;
        wp::uint8* var_55;
        wp::uint8 var_56;
        bool var_57;
        wp::uint8 var_58;
        wp::int32 var_59;
        wp::int32 var_60;
        //---------
        // forward
        // def list_touched_kernel(record, table__keys, table__positions, table__mask, grid, offsets, groups, counts, keys, touched):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // if i == 0:                                                                             <L 3>
        var_2 = (var_0 == var_1);
        if (var_2) {
            // counts[TOUCHED] = offsets[groups]                                                  <L 4>
            var_3 = wp::address(var_offsets, var_groups);
            var_5 = wp::load(var_3);
            var_4 = wp::copy(var_5);
            wp::array_store(var_counts, var_6, var_4);
            // counts[MISSING] = offsets[2 * groups] - offsets[groups]                            <L 5>
            var_8 = wp::mul(var_7, var_groups);
            var_9 = wp::address(var_offsets, var_8);
            var_10 = wp::address(var_offsets, var_groups);
            var_12 = wp::load(var_9);
            var_13 = wp::load(var_10);
            var_11 = wp::sub(var_12, var_13);
            wp::array_store(var_counts, var_14, var_11);
        }
        // if grid[i] != uint8(0):                                                                <L 6>
        var_15 = wp::address(var_grid, var_0);
        var_17 = wp::uint8(var_16);
        var_19 = wp::load(var_15);
        var_18 = (var_19 != var_17);
        if (var_18) {
            // group = i // GROUP                                                                 <L 7>
            var_21 = wp::floordiv(var_0, var_20);
            // at = offsets[group]                                                                <L 8>
            var_22 = wp::address(var_offsets, var_21);
            var_24 = wp::load(var_22);
            var_23 = wp::copy(var_24);
            // position = counts[COUNTED] + offsets[groups + group] - offsets[groups]             <L 9>
            var_26 = wp::address(var_counts, var_25);
            var_27 = wp::add(var_groups, var_21);
            var_28 = wp::address(var_offsets, var_27);
            var_30 = wp::load(var_26);
            var_31 = wp::load(var_28);
            var_29 = wp::add(var_30, var_31);
            var_32 = wp::address(var_offsets, var_groups);
            var_34 = wp::load(var_32);
            var_33 = wp::sub(var_29, var_34);
            // for j in range(group * GROUP, i):                                                  <L 10>
            var_35 = wp::mul(var_21, var_20);
            var_36 = wp::range(var_35, var_0);
            start_for_0:;
                if (iter_cmp(var_36) == 0) goto end_for_0;
                var_37 = wp::iter_next(var_36);
                // if grid[j] != uint8(0):                                                        <L 11>
                var_38 = wp::address(var_grid, var_37);
                var_40 = wp::uint8(var_39);
                var_42 = wp::load(var_38);
                var_41 = (var_42 != var_40);
                if (var_41) {
                    // at += 1                                                                    <L 12>
                    var_44 = wp::add(var_23, var_43);
                }
                var_45 = wp::where(var_41, var_44, var_23);
                // if grid[j] == uint8(LACKED):                                                   <L 13>
                var_46 = wp::address(var_grid, var_37);
                var_48 = wp::uint8(var_47);
                var_50 = wp::load(var_46);
                var_49 = (var_50 == var_48);
                if (var_49) {
                    // position += 1                                                              <L 14>
                    var_52 = wp::add(var_33, var_51);
                }
                var_53 = wp::where(var_49, var_52, var_33);
                wp::assign(var_23, var_45);
                wp::assign(var_33, var_53);
                goto start_for_0;
            end_for_0:;
            // key = cell_key(i, record)                                                          <L 15>
            var_54 = cell_key_0(var_0, var_record);
            // if grid[i] == uint8(LACKED):                                                       <L 16>
            var_55 = wp::address(var_grid, var_0);
            var_56 = wp::uint8(var_47);
            var_58 = wp::load(var_55);
            var_57 = (var_58 == var_56);
            if (var_57) {
                // keys[position] = key                                                           <L 17>
                wp::array_store(var_keys, var_33, var_54);
            }
            if (!var_57) {
                // position = find_position(key, table__keys, table__positions, table__mask)       <L 19>
                var_59 = find_position_0(var_54, var_table__keys, var_table__positions, var_table__mask);
            }
            var_60 = wp::where(var_57, var_33, var_59);
            // touched[at] = position                                                             <L 20>
            wp::array_store(var_touched, var_23, var_60);
        }
}



extern "C" __global__ void insert_new_kernel_ae57320c_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_counts,
    wp::array_t<wp::int64> var_keys,
    wp::array_t<wp::int64> var_table__keys,
    wp::int64 var_table__mask)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 2;
        wp::int32* var_2;
        bool var_3;
        wp::int32 var_4;
        const wp::int32 var_5 = 0;
        wp::int32* var_6;
        wp::int32 var_7;
        wp::int32 var_8;
        wp::int64* var_9;
        wp::int64 var_10;
        //---------
        // forward
        // def insert_new_kernel(counts, keys, table__keys, table__mask):                         <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // if i < counts[MISSING]:                                                                <L 4>
        var_2 = wp::address(var_counts, var_1);
        var_4 = wp::load(var_2);
        var_3 = (var_0 < var_4);
        if (var_3) {
            // insert_key(keys[counts[COUNTED] + i], table__keys, table__mask)                    <L 5>
            var_6 = wp::address(var_counts, var_5);
            var_8 = wp::load(var_6);
            var_7 = wp::add(var_8, var_0);
            var_9 = wp::address(var_keys, var_7);
            var_10 = wp::load(var_9);
            insert_key_0(var_10, var_table__keys, var_table__mask);
        }
}


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



extern "C" __global__ void average_vec3_kernel_2edc7208_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_values,
    wp::array_t<wp::int32> var_order,
    wp::array_t<wp::int32> var_starts,
    wp::array_t<wp::vec_t<3, wp::float32>> var_means)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::float64 var_1;
        wp::float64 var_2;
        wp::float64 var_3;
        wp::vec_t<3, wp::float64> var_4;
        wp::float64 var_5;
        wp::int32* var_6;
        const wp::int32 var_7 = 1;
        wp::int32 var_8;
        wp::int32* var_9;
        wp::range_t var_10;
        wp::int32 var_11;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int32* var_14;
        wp::int32 var_15;
        wp::vec_t<3, wp::float32>* var_16;
        wp::vec_t<3, wp::float32> var_17;
        wp::vec_t<3, wp::float32> var_18;
        bool var_19;
        const wp::int32 var_20 = 0;
        wp::float32 var_21;
        wp::float64 var_22;
        const wp::int32 var_23 = 1;
        wp::float32 var_24;
        wp::float64 var_25;
        const wp::int32 var_26 = 2;
        wp::float32 var_27;
        wp::float64 var_28;
        wp::vec_t<3, wp::float64> var_29;
        wp::vec_t<3, wp::float64> var_30;
        wp::float64 var_31;
        wp::float64 var_32;
        wp::vec_t<3, wp::float64> var_33;
        wp::float64 var_34;
        const wp::int32 var_35 = 0;
        wp::float64 var_36;
        wp::float64 var_37;
        wp::float32 var_38;
        const wp::int32 var_39 = 1;
        wp::float64 var_40;
        wp::float64 var_41;
        wp::float32 var_42;
        const wp::int32 var_43 = 2;
        wp::float64 var_44;
        wp::float64 var_45;
        wp::float32 var_46;
        wp::vec_t<3, wp::float32> var_47;
        //---------
        // forward
        // def average_vec3_kernel(values, order, starts, means):                                 <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // total = vec3d(float64(0.0), float64(0.0), float64(0.0))                                <L 4>
        var_1 = 0.0;
        var_2 = 0.0;
        var_3 = 0.0;
        var_4 = wp::vec_t<3, wp::float64>(var_1, var_2, var_3);
        // count = float64(0.0)                                                                   <L 5>
        var_5 = 0.0;
        // for j in range(starts[i], starts[i + 1]):                                              <L 6>
        var_6 = wp::address(var_starts, var_0);
        var_8 = wp::add(var_0, var_7);
        var_9 = wp::address(var_starts, var_8);
        var_11 = wp::load(var_6);
        var_12 = wp::load(var_9);
        var_10 = wp::range(var_11, var_12);
        start_for_0:;
            if (iter_cmp(var_10) == 0) goto end_for_0;
            var_13 = wp::iter_next(var_10);
            // v = values[order[j]]                                                               <L 7>
            var_14 = wp::address(var_order, var_13);
            var_15 = wp::load(var_14);
            var_16 = wp::address(var_values, var_15);
            var_18 = wp::load(var_16);
            var_17 = wp::copy(var_18);
            // if isfinite(v):                                                                    <L 8>
            var_19 = wp::isfinite(var_17);
            if (var_19) {
                // total += vec3d(float64(v[0]), float64(v[1]), float64(v[2]))                    <L 9>
                var_21 = wp::extract(var_17, var_20);
                var_22 = wp::float64(var_21);
                var_24 = wp::extract(var_17, var_23);
                var_25 = wp::float64(var_24);
                var_27 = wp::extract(var_17, var_26);
                var_28 = wp::float64(var_27);
                var_29 = wp::vec_t<3, wp::float64>(var_22, var_25, var_28);
                var_30 = wp::add(var_4, var_29);
                // count += float64(1.0)                                                          <L 10>
                var_31 = 1.0;
                var_32 = wp::add(var_5, var_31);
            }
            var_33 = wp::where(var_19, var_30, var_4);
            var_34 = wp::where(var_19, var_32, var_5);
            wp::assign(var_4, var_33);
            wp::assign(var_5, var_34);
            goto start_for_0;
        end_for_0:;
        // means[i] = vec3(float(total[0] / count), float(total[1] / count), float(total[2] / count))       <L 11>
        var_36 = wp::extract(var_4, var_35);
        var_37 = wp::div(var_36, var_5);
        var_38 = wp::float(var_37);
        var_40 = wp::extract(var_4, var_39);
        var_41 = wp::div(var_40, var_5);
        var_42 = wp::float(var_41);
        var_44 = wp::extract(var_4, var_43);
        var_45 = wp::div(var_44, var_5);
        var_46 = wp::float(var_45);
        var_47 = wp::vec_t<3, wp::float32>(var_38, var_42, var_46);
        wp::array_store(var_means, var_0, var_47);
}



extern "C" __global__ void sum_columns_kernel_7632a71b_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float64> var_values,
    wp::array_t<wp::int32> var_order,
    wp::array_t<wp::int32> var_starts,
    wp::int32 var_columns,
    wp::int32 var_mean,
    wp::array_t<wp::float64> var_totals)
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
        wp::float64 var_3;
        wp::float64 var_4;
        wp::float64 var_5;
        wp::int32* var_6;
        const wp::int32 var_7 = 1;
        wp::int32 var_8;
        wp::int32* var_9;
        wp::range_t var_10;
        wp::int32 var_11;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int32* var_14;
        wp::int32 var_15;
        wp::int32 var_16;
        const wp::int32 var_17 = 1;
        wp::int32 var_18;
        const wp::int32 var_19 = 1;
        bool var_20;
        wp::range_t var_21;
        wp::int32 var_22;
        wp::float64* var_23;
        bool var_24;
        wp::float64 var_25;
        bool var_26;
        const wp::int32 var_27 = 0;
        wp::int32 var_28;
        const wp::int32 var_29 = 1;
        bool var_30;
        wp::float64* var_31;
        wp::float64 var_32;
        wp::float64 var_33;
        wp::float64 var_34;
        const wp::int32 var_35 = 1;
        bool var_36;
        wp::float64 var_37;
        wp::float64 var_38;
        bool var_39;
        wp::float64 var_40;
        wp::float64 var_41;
        wp::float64 var_42;
        wp::float64 var_43;
        wp::float64 var_44;
        wp::float64 var_45;
        wp::float64 var_46;
        wp::float64 var_47;
        wp::float64 var_48;
        wp::float64 var_49;
        wp::float64 var_50;
        wp::float64 var_51;
        wp::float64 var_52;
        wp::float64 var_53;
        const wp::int32 var_54 = 1;
        bool var_55;
        bool var_56;
        wp::float64 var_57;
        wp::float64 var_58;
        wp::float64 var_59;
        wp::float64 var_60;
        //---------
        // forward
        // def sum_columns_kernel(values, order, starts, columns, mean, totals):                  <L 1>
        // i = tid()                                                                              <L 4>
        var_0 = builtin_tid1d();
        // run = i // columns                                                                     <L 5>
        var_1 = wp::floordiv(var_0, var_columns);
        // column = i % columns                                                                   <L 6>
        var_2 = wp::mod(var_0, var_columns);
        // total = float64(0.0)                                                                   <L 7>
        var_3 = 0.0;
        // lost = float64(0.0)                                                                    <L 8>
        var_4 = 0.0;
        // count = float64(0.0)                                                                   <L 9>
        var_5 = 0.0;
        // for j in range(starts[run], starts[run + 1]):                                          <L 10>
        var_6 = wp::address(var_starts, var_1);
        var_8 = wp::add(var_1, var_7);
        var_9 = wp::address(var_starts, var_8);
        var_11 = wp::load(var_6);
        var_12 = wp::load(var_9);
        var_10 = wp::range(var_11, var_12);
        start_for_0:;
            if (iter_cmp(var_10) == 0) goto end_for_0;
            var_13 = wp::iter_next(var_10);
            // row = order[j]                                                                     <L 11>
            var_14 = wp::address(var_order, var_13);
            var_16 = wp::load(var_14);
            var_15 = wp::copy(var_16);
            // is_counted = int(1)                                                                <L 12>
            var_18 = wp::int(var_17);
            // if mean == 1:                                                                      <L 13>
            var_20 = (var_mean == var_19);
            if (var_20) {
                // for k in range(columns):                                                       <L 14>
                var_21 = wp::range(var_columns);
                start_for_2:;
                    if (iter_cmp(var_21) == 0) goto end_for_2;
                    var_22 = wp::iter_next(var_21);
                    // if not isfinite(values[row, k]):                                           <L 15>
                    var_23 = wp::address(var_values, var_15, var_22);
                    var_25 = wp::load(var_23);
                    var_24 = wp::isfinite(var_25);
                    var_26 = wp::unot(var_24);
                    if (var_26) {
                        // is_counted = 0                                                         <L 16>
                    }
                    var_28 = wp::where(var_26, var_27, var_18);
                    wp::assign(var_18, var_28);
                    goto start_for_2;
                end_for_2:;
            }
            // if is_counted == 1:                                                                <L 17>
            var_30 = (var_18 == var_29);
            if (var_30) {
                // value = values[row, column]                                                    <L 18>
                var_31 = wp::address(var_values, var_15, var_2);
                var_33 = wp::load(var_31);
                var_32 = wp::copy(var_33);
                // new_total = total + value                                                      <L 19>
                var_34 = wp::add(var_3, var_32);
                // if mean == 1:                                                                  <L 20>
                var_36 = (var_mean == var_35);
                if (var_36) {
                    // if abs(total) >= abs(value):                                               <L 21>
                    var_37 = wp::abs(var_3);
                    var_38 = wp::abs(var_32);
                    var_39 = (var_37 >= var_38);
                    if (var_39) {
                        // lost += total - new_total + value                                      <L 22>
                        var_40 = wp::sub(var_3, var_34);
                        var_41 = wp::add(var_40, var_32);
                        var_42 = wp::add(var_4, var_41);
                    }
                    if (!var_39) {
                        // lost += value - new_total + total                                      <L 24>
                        var_43 = wp::sub(var_32, var_34);
                        var_44 = wp::add(var_43, var_3);
                        var_45 = wp::add(var_4, var_44);
                    }
                    var_46 = wp::where(var_39, var_42, var_45);
                }
                var_47 = wp::where(var_36, var_46, var_4);
                // total = new_total                                                              <L 25>
                var_48 = wp::copy(var_34);
                // count += float64(1.0)                                                          <L 26>
                var_49 = 1.0;
                var_50 = wp::add(var_5, var_49);
            }
            var_51 = wp::where(var_30, var_48, var_3);
            var_52 = wp::where(var_30, var_47, var_4);
            var_53 = wp::where(var_30, var_50, var_5);
            wp::assign(var_3, var_51);
            wp::assign(var_4, var_52);
            wp::assign(var_5, var_53);
            goto start_for_0;
        end_for_0:;
        // if mean == 1:                                                                          <L 27>
        var_55 = (var_mean == var_54);
        if (var_55) {
            // if isfinite(lost):                                                                 <L 28>
            var_56 = wp::isfinite(var_4);
            if (var_56) {
                // total += lost                                                                  <L 29>
                var_57 = wp::add(var_3, var_4);
            }
            var_58 = wp::where(var_56, var_57, var_3);
            // total = total / count                                                              <L 30>
            var_59 = wp::div(var_58, var_5);
        }
        var_60 = wp::where(var_55, var_59, var_3);
        // totals[run, column] = total                                                            <L 31>
        wp::array_store(var_totals, var_1, var_2, var_60);
}



extern "C" __global__ void first_rows_kernel_c16f5e0a_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_order,
    wp::array_t<wp::int32> var_starts,
    wp::array_t<wp::int32> var_rows)
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
        //---------
        // forward
        // def first_rows_kernel(order: array(dtype=int32), starts: array(dtype=int32), rows: array(dtype=int32)):       <L 66>
        // i = tid()                                                                              <L 67>
        var_0 = builtin_tid1d();
        // rows[i] = order[starts[i]]                                                             <L 68>
        var_1 = wp::address(var_starts, var_0);
        var_2 = wp::load(var_1);
        var_3 = wp::address(var_order, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::copy(var_5);
        wp::array_store(var_rows, var_0, var_4);
}


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


// <pointloom.kernels.rgbd.stream_views.sum_motion_element>:1
static CUDA_CALLABLE wp::vec_t<8, wp::float64> sum_motion_element_0(
    wp::array_t<wp::float32> var_now__brightness,
    wp::array_t<wp::float32> var_now__nearness,
    wp::array_t<wp::float32> var_before__brightness,
    wp::array_t<wp::float32> var_before__nearness,
    wp::int32 var_columns,
    wp::int32 var_rows,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    wp::float64 var_2;
    wp::vec_t<8, wp::float64> var_3;
    wp::float32* var_4;
    wp::float32 var_5;
    wp::float32 var_6;
    wp::float32* var_7;
    wp::float32 var_8;
    wp::float32 var_9;
    bool var_10;
    wp::float64 var_11;
    const wp::int32 var_12 = 5;
    const wp::float32 var_13 = 0.0;
    bool var_14;
    wp::float64 var_15;
    const wp::int32 var_16 = 6;
    bool var_17;
    wp::float32* var_18;
    const wp::float32 var_19 = 0.0;
    bool var_20;
    wp::float32 var_21;
    wp::float32* var_22;
    const wp::float32 var_23 = 0.0;
    bool var_24;
    wp::float32 var_25;
    wp::float32* var_26;
    wp::float32* var_27;
    wp::float32 var_28;
    wp::float32 var_29;
    wp::float32 var_30;
    wp::float32 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 7;
    bool var_34;
    const wp::int32 var_35 = 0;
    bool var_36;
    const wp::int32 var_37 = 0;
    bool var_38;
    const wp::int32 var_39 = 1;
    wp::int32 var_40;
    bool var_41;
    const wp::int32 var_42 = 1;
    wp::int32 var_43;
    bool var_44;
    const wp::int32 var_45 = 1;
    wp::int32 var_46;
    wp::float32* var_47;
    const wp::int32 var_48 = 1;
    wp::int32 var_49;
    wp::float32* var_50;
    wp::float32 var_51;
    wp::float32 var_52;
    wp::float32 var_53;
    const wp::int32 var_54 = 1;
    wp::int32 var_55;
    wp::float32* var_56;
    wp::float32 var_57;
    wp::float32 var_58;
    const wp::int32 var_59 = 1;
    wp::int32 var_60;
    wp::float32* var_61;
    wp::float32 var_62;
    wp::float32 var_63;
    wp::int32 var_64;
    wp::float32* var_65;
    wp::int32 var_66;
    wp::float32* var_67;
    wp::float32 var_68;
    wp::float32 var_69;
    wp::float32 var_70;
    wp::int32 var_71;
    wp::float32* var_72;
    wp::int32 var_73;
    wp::float32* var_74;
    wp::float32 var_75;
    wp::float32 var_76;
    wp::float32 var_77;
    wp::float32 var_78;
    const wp::float32 var_79 = 0.25;
    wp::float32 var_80;
    const wp::float32 var_81 = 0.25;
    wp::float32 var_82;
    wp::float32 var_83;
    wp::float64 var_84;
    const wp::int32 var_85 = 0;
    wp::float32 var_86;
    wp::float64 var_87;
    const wp::int32 var_88 = 1;
    wp::int32 var_89;
    wp::float32 var_90;
    wp::float64 var_91;
    const wp::int32 var_92 = 2;
    wp::int32 var_93;
    wp::float32 var_94;
    wp::float64 var_95;
    const wp::int32 var_96 = 3;
    wp::int32 var_97;
    wp::float32 var_98;
    wp::float64 var_99;
    const wp::int32 var_100 = 4;
    wp::int32 var_101;
    //---------
    // forward
    // def sum_motion_element(now__brightness, now__nearness, before__brightness, before__nearness, columns, rows, i):       <L 1>
    // u = i % columns                                                                        <L 2>
    var_0 = wp::mod(var_i, var_columns);
    // v = i // columns                                                                       <L 3>
    var_1 = wp::floordiv(var_i, var_columns);
    // out = stream_sums(float64(0.0))                                                        <L 4>
    var_2 = 0.0;
    var_3 = wp::vec_t<8, wp::float64>(var_2);
    // a = now__nearness[i]                                                                   <L 5>
    var_4 = wp::address(var_now__nearness, var_i);
    var_6 = wp::load(var_4);
    var_5 = wp::copy(var_6);
    // b = before__nearness[i]                                                                <L 6>
    var_7 = wp::address(var_before__nearness, var_i);
    var_9 = wp::load(var_7);
    var_8 = wp::copy(var_9);
    // if a != b:                                                                             <L 7>
    var_10 = (var_5 != var_8);
    if (var_10) {
        // out[OTHER] = float64(1.0)                                                          <L 8>
        var_11 = 1.0;
        wp::assign_inplace(var_3, var_12, var_11);
    }
    // if a > 0.0:                                                                            <L 9>
    var_14 = (var_5 > var_13);
    if (var_14) {
        // out[MEASURED] = float64(1.0)                                                       <L 10>
        var_15 = 1.0;
        wp::assign_inplace(var_3, var_16, var_15);
    }
    // if now__brightness[i] >= 0.0 and before__brightness[i] >= 0.0:                         <L 11>
    var_18 = wp::address(var_now__brightness, var_i);
    var_21 = wp::load(var_18);
    var_20 = (var_21 >= var_19);
    var_17 = var_20;
    if (var_17) {
        var_22 = wp::address(var_before__brightness, var_i);
        var_25 = wp::load(var_22);
        var_24 = (var_25 >= var_23);
        var_17 = var_17 && var_24;
    }
    if (var_17) {
        // d = now__brightness[i] - before__brightness[i]                                     <L 12>
        var_26 = wp::address(var_now__brightness, var_i);
        var_27 = wp::address(var_before__brightness, var_i);
        var_29 = wp::load(var_26);
        var_30 = wp::load(var_27);
        var_28 = wp::sub(var_29, var_30);
        // out[SHADES] = float64(d * d)                                                       <L 13>
        var_31 = wp::mul(var_28, var_28);
        var_32 = wp::float64(var_31);
        wp::assign_inplace(var_3, var_33, var_32);
        // if u > 0 and v > 0 and (u < columns - 1) and (v < rows - 1):                       <L 14>
        var_36 = (var_0 > var_35);
        var_34 = var_36;
        if (var_34) {
            var_38 = (var_1 > var_37);
            var_34 = var_34 && var_38;
        }
        if (var_34) {
            var_40 = wp::sub(var_columns, var_39);
            var_41 = (var_0 < var_40);
            var_34 = var_34 && var_41;
        }
        if (var_34) {
            var_43 = wp::sub(var_rows, var_42);
            var_44 = (var_1 < var_43);
            var_34 = var_34 && var_44;
        }
        if (var_34) {
            // x = now__brightness[i + 1] - now__brightness[i - 1] + before__brightness[i + 1] - before__brightness[i - 1]       <L 15>
            var_46 = wp::add(var_i, var_45);
            var_47 = wp::address(var_now__brightness, var_46);
            var_49 = wp::sub(var_i, var_48);
            var_50 = wp::address(var_now__brightness, var_49);
            var_52 = wp::load(var_47);
            var_53 = wp::load(var_50);
            var_51 = wp::sub(var_52, var_53);
            var_55 = wp::add(var_i, var_54);
            var_56 = wp::address(var_before__brightness, var_55);
            var_58 = wp::load(var_56);
            var_57 = wp::add(var_51, var_58);
            var_60 = wp::sub(var_i, var_59);
            var_61 = wp::address(var_before__brightness, var_60);
            var_63 = wp::load(var_61);
            var_62 = wp::sub(var_57, var_63);
            // y = now__brightness[i + columns] - now__brightness[i - columns]                <L 16>
            var_64 = wp::add(var_i, var_columns);
            var_65 = wp::address(var_now__brightness, var_64);
            var_66 = wp::sub(var_i, var_columns);
            var_67 = wp::address(var_now__brightness, var_66);
            var_69 = wp::load(var_65);
            var_70 = wp::load(var_67);
            var_68 = wp::sub(var_69, var_70);
            // y += before__brightness[i + columns] - before__brightness[i - columns]         <L 17>
            var_71 = wp::add(var_i, var_columns);
            var_72 = wp::address(var_before__brightness, var_71);
            var_73 = wp::sub(var_i, var_columns);
            var_74 = wp::address(var_before__brightness, var_73);
            var_76 = wp::load(var_72);
            var_77 = wp::load(var_74);
            var_75 = wp::sub(var_76, var_77);
            var_78 = wp::add(var_68, var_75);
            // x = 0.25 * x                                                                   <L 18>
            var_80 = wp::mul(var_79, var_62);
            // y = 0.25 * y                                                                   <L 19>
            var_82 = wp::mul(var_81, var_78);
            // out[BRIGHT] = float64(x * x)                                                   <L 20>
            var_83 = wp::mul(var_80, var_80);
            var_84 = wp::float64(var_83);
            wp::assign_inplace(var_3, var_85, var_84);
            // out[BRIGHT + 1] = float64(x * y)                                               <L 21>
            var_86 = wp::mul(var_80, var_82);
            var_87 = wp::float64(var_86);
            var_89 = wp::add(var_85, var_88);
            wp::assign_inplace(var_3, var_89, var_87);
            // out[BRIGHT + 2] = float64(y * y)                                               <L 22>
            var_90 = wp::mul(var_82, var_82);
            var_91 = wp::float64(var_90);
            var_93 = wp::add(var_85, var_92);
            wp::assign_inplace(var_3, var_93, var_91);
            // out[BRIGHT + 3] = float64(x * d)                                               <L 23>
            var_94 = wp::mul(var_80, var_28);
            var_95 = wp::float64(var_94);
            var_97 = wp::add(var_85, var_96);
            wp::assign_inplace(var_3, var_97, var_95);
            // out[BRIGHT + 4] = float64(y * d)                                               <L 24>
            var_98 = wp::mul(var_82, var_28);
            var_99 = wp::float64(var_98);
            var_101 = wp::add(var_85, var_100);
            wp::assign_inplace(var_3, var_101, var_99);
        }
    }
    // return out                                                                             <L 25>
    return var_3;
}


// <pointloom.kernels.rgbd.stream_views.sum_motion_element>:1
static CUDA_CALLABLE void adj_sum_motion_element_0(
    wp::array_t<wp::float32> var_now__brightness,
    wp::array_t<wp::float32> var_now__nearness,
    wp::array_t<wp::float32> var_before__brightness,
    wp::array_t<wp::float32> var_before__nearness,
    wp::int32 var_columns,
    wp::int32 var_rows,
    wp::int32 var_i,
    wp::array_t<wp::float32> & adj_now__brightness,
    wp::array_t<wp::float32> & adj_now__nearness,
    wp::array_t<wp::float32> & adj_before__brightness,
    wp::array_t<wp::float32> & adj_before__nearness,
    wp::int32 & adj_columns,
    wp::int32 & adj_rows,
    wp::int32 & adj_i,
    wp::vec_t<8, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void sum_motion_tiles_d8d7bd96_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_now__brightness,
    wp::array_t<wp::float32> var_now__nearness,
    wp::array_t<wp::float32> var_before__brightness,
    wp::array_t<wp::float32> var_before__nearness,
    wp::int32 var_columns,
    wp::int32 var_rows,
    wp::int32 var_count_,
    wp::array_t<wp::vec_t<8, wp::float64>> var_partials_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<8, wp::float64> var_1;
        bool var_2;
        wp::vec_t<8, wp::float64> var_3;
        wp::vec_t<8, wp::float64> var_4;
        const wp::int32 var_5 = 0;
        wp::float64 var_6;
        const wp::int32 var_7 = 1;
        wp::float64 var_8;
        const wp::int32 var_9 = 2;
        wp::float64 var_10;
        const wp::int32 var_11 = 3;
        wp::float64 var_12;
        wp::vec_t<4, wp::float64> var_13;
        const bool var_14 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_15 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_16 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_17 = 0;
        wp::vec_t<4, wp::float64> var_18;
        const wp::int32 var_19 = 0;
        wp::float64 var_20;
        const wp::int32 var_21 = 0;
        const wp::int32 var_22 = 1;
        wp::float64 var_23;
        const wp::int32 var_24 = 1;
        const wp::int32 var_25 = 2;
        wp::float64 var_26;
        const wp::int32 var_27 = 2;
        const wp::int32 var_28 = 3;
        wp::float64 var_29;
        const wp::int32 var_30 = 3;
        const wp::int32 var_31 = 4;
        wp::float64 var_32;
        const wp::int32 var_33 = 5;
        wp::float64 var_34;
        const wp::int32 var_35 = 6;
        wp::float64 var_36;
        const wp::int32 var_37 = 7;
        wp::float64 var_38;
        wp::vec_t<4, wp::float64> var_39;
        const bool var_40 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_41 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_42 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_43 = 0;
        wp::vec_t<4, wp::float64> var_44;
        const wp::int32 var_45 = 0;
        wp::float64 var_46;
        const wp::int32 var_47 = 4;
        const wp::int32 var_48 = 1;
        wp::float64 var_49;
        const wp::int32 var_50 = 5;
        const wp::int32 var_51 = 2;
        wp::float64 var_52;
        const wp::int32 var_53 = 6;
        const wp::int32 var_54 = 3;
        wp::float64 var_55;
        const wp::int32 var_56 = 7;
        const wp::int32 var_57 = 256;
        wp::int32 var_58;
        const wp::int32 var_59 = 0;
        bool var_60;
        const wp::int32 var_61 = 256;
        wp::int32 var_62;
        //---------
        // forward
        // def sum_motion_tiles(now__brightness, now__nearness, before__brightness, before__nearness, columns, rows, count_, partials_):       <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // value_ = vector_()                                                                     <L 3>
        var_1 = wp::vec_t<8, wp::float64>();
        // if i_ < count_:                                                                        <L 4>
        var_2 = (var_0 < var_count_);
        if (var_2) {
            // value_ = element_(now__brightness, now__nearness, before__brightness, before__nearness, columns, rows, i_)       <L 5>
            var_3 = sum_motion_element_0(var_now__brightness, var_now__nearness, var_before__brightness, var_before__nearness, var_columns, var_rows, var_0);
        }
        var_4 = wp::where(var_2, var_3, var_1);
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 6>
        var_6 = wp::extract(var_4, var_5);
        var_8 = wp::extract(var_4, var_7);
        var_10 = wp::extract(var_4, var_9);
        var_12 = wp::extract(var_4, var_11);
        var_13 = wp::vec_t<4, wp::float64>(var_6, var_8, var_10, var_12);
        var_15 = wp::tile<wp::vec_t<4, wp::float64>>(var_13);
        var_16 = wp::tile_sum(var_15);
        var_18 = wp::tile_extract(var_16, var_17);
        // value_[0] = part_0[0]                                                                  <L 7>
        var_20 = wp::extract(var_18, var_19);
        wp::assign_inplace(var_4, var_21, var_20);
        // value_[1] = part_0[1]                                                                  <L 8>
        var_23 = wp::extract(var_18, var_22);
        wp::assign_inplace(var_4, var_24, var_23);
        // value_[2] = part_0[2]                                                                  <L 9>
        var_26 = wp::extract(var_18, var_25);
        wp::assign_inplace(var_4, var_27, var_26);
        // value_[3] = part_0[3]                                                                  <L 10>
        var_29 = wp::extract(var_18, var_28);
        wp::assign_inplace(var_4, var_30, var_29);
        // part_4 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[4], value_[5], value_[6], value_[7]), preserve_type=True)), 0)       <L 11>
        var_32 = wp::extract(var_4, var_31);
        var_34 = wp::extract(var_4, var_33);
        var_36 = wp::extract(var_4, var_35);
        var_38 = wp::extract(var_4, var_37);
        var_39 = wp::vec_t<4, wp::float64>(var_32, var_34, var_36, var_38);
        var_41 = wp::tile<wp::vec_t<4, wp::float64>>(var_39);
        var_42 = wp::tile_sum(var_41);
        var_44 = wp::tile_extract(var_42, var_43);
        // value_[4] = part_4[0]                                                                  <L 12>
        var_46 = wp::extract(var_44, var_45);
        wp::assign_inplace(var_4, var_47, var_46);
        // value_[5] = part_4[1]                                                                  <L 13>
        var_49 = wp::extract(var_44, var_48);
        wp::assign_inplace(var_4, var_50, var_49);
        // value_[6] = part_4[2]                                                                  <L 14>
        var_52 = wp::extract(var_44, var_51);
        wp::assign_inplace(var_4, var_53, var_52);
        // value_[7] = part_4[3]                                                                  <L 15>
        var_55 = wp::extract(var_44, var_54);
        wp::assign_inplace(var_4, var_56, var_55);
        // if i_ % 256 == 0:                                                                      <L 16>
        var_58 = wp::mod(var_0, var_57);
        var_60 = (var_58 == var_59);
        if (var_60) {
            // partials_[i_ // 256] = value_                                                      <L 17>
            var_62 = wp::floordiv(var_0, var_61);
            wp::array_store(var_partials_, var_62, var_4);
        }
}



extern "C" __global__ void sum_motion_fold_tiles_db3fc4e8_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_count_,
    wp::array_t<wp::vec_t<8, wp::float64>> var_partials_,
    wp::array_t<wp::vec_t<8, wp::float64>> var_out_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<8, wp::float64> var_1;
        const wp::int32 var_2 = 256;
        wp::range_t var_3;
        wp::int32 var_4;
        wp::vec_t<8, wp::float64>* var_5;
        wp::vec_t<8, wp::float64> var_6;
        wp::vec_t<8, wp::float64> var_7;
        const wp::int32 var_8 = 0;
        wp::float64 var_9;
        const wp::int32 var_10 = 1;
        wp::float64 var_11;
        const wp::int32 var_12 = 2;
        wp::float64 var_13;
        const wp::int32 var_14 = 3;
        wp::float64 var_15;
        wp::vec_t<4, wp::float64> var_16;
        const bool var_17 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_18 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_19 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_20 = 0;
        wp::vec_t<4, wp::float64> var_21;
        const wp::int32 var_22 = 0;
        wp::float64 var_23;
        const wp::int32 var_24 = 0;
        const wp::int32 var_25 = 1;
        wp::float64 var_26;
        const wp::int32 var_27 = 1;
        const wp::int32 var_28 = 2;
        wp::float64 var_29;
        const wp::int32 var_30 = 2;
        const wp::int32 var_31 = 3;
        wp::float64 var_32;
        const wp::int32 var_33 = 3;
        const wp::int32 var_34 = 4;
        wp::float64 var_35;
        const wp::int32 var_36 = 5;
        wp::float64 var_37;
        const wp::int32 var_38 = 6;
        wp::float64 var_39;
        const wp::int32 var_40 = 7;
        wp::float64 var_41;
        wp::vec_t<4, wp::float64> var_42;
        const bool var_43 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_44 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_45 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_46 = 0;
        wp::vec_t<4, wp::float64> var_47;
        const wp::int32 var_48 = 0;
        wp::float64 var_49;
        const wp::int32 var_50 = 4;
        const wp::int32 var_51 = 1;
        wp::float64 var_52;
        const wp::int32 var_53 = 5;
        const wp::int32 var_54 = 2;
        wp::float64 var_55;
        const wp::int32 var_56 = 6;
        const wp::int32 var_57 = 3;
        wp::float64 var_58;
        const wp::int32 var_59 = 7;
        const wp::int32 var_60 = 0;
        bool var_61;
        const wp::int32 var_62 = 0;
        //---------
        // forward
        // def sum_motion_fold_tiles(count_, partials_, out_):                                    <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // value_ = vector_()                                                                     <L 3>
        var_1 = wp::vec_t<8, wp::float64>();
        // for j_ in range(i_, count_, 256):                                                      <L 4>
        var_3 = wp::range(var_0, var_count_, var_2);
        start_for_0:;
            if (iter_cmp(var_3) == 0) goto end_for_0;
            var_4 = wp::iter_next(var_3);
            // value_ += partials_[j_]                                                            <L 5>
            var_5 = wp::address(var_partials_, var_4);
            var_7 = wp::load(var_5);
            var_6 = wp::add(var_1, var_7);
            wp::assign(var_1, var_6);
            goto start_for_0;
        end_for_0:;
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 6>
        var_9 = wp::extract(var_1, var_8);
        var_11 = wp::extract(var_1, var_10);
        var_13 = wp::extract(var_1, var_12);
        var_15 = wp::extract(var_1, var_14);
        var_16 = wp::vec_t<4, wp::float64>(var_9, var_11, var_13, var_15);
        var_18 = wp::tile<wp::vec_t<4, wp::float64>>(var_16);
        var_19 = wp::tile_sum(var_18);
        var_21 = wp::tile_extract(var_19, var_20);
        // value_[0] = part_0[0]                                                                  <L 7>
        var_23 = wp::extract(var_21, var_22);
        wp::assign_inplace(var_1, var_24, var_23);
        // value_[1] = part_0[1]                                                                  <L 8>
        var_26 = wp::extract(var_21, var_25);
        wp::assign_inplace(var_1, var_27, var_26);
        // value_[2] = part_0[2]                                                                  <L 9>
        var_29 = wp::extract(var_21, var_28);
        wp::assign_inplace(var_1, var_30, var_29);
        // value_[3] = part_0[3]                                                                  <L 10>
        var_32 = wp::extract(var_21, var_31);
        wp::assign_inplace(var_1, var_33, var_32);
        // part_4 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[4], value_[5], value_[6], value_[7]), preserve_type=True)), 0)       <L 11>
        var_35 = wp::extract(var_1, var_34);
        var_37 = wp::extract(var_1, var_36);
        var_39 = wp::extract(var_1, var_38);
        var_41 = wp::extract(var_1, var_40);
        var_42 = wp::vec_t<4, wp::float64>(var_35, var_37, var_39, var_41);
        var_44 = wp::tile<wp::vec_t<4, wp::float64>>(var_42);
        var_45 = wp::tile_sum(var_44);
        var_47 = wp::tile_extract(var_45, var_46);
        // value_[4] = part_4[0]                                                                  <L 12>
        var_49 = wp::extract(var_47, var_48);
        wp::assign_inplace(var_1, var_50, var_49);
        // value_[5] = part_4[1]                                                                  <L 13>
        var_52 = wp::extract(var_47, var_51);
        wp::assign_inplace(var_1, var_53, var_52);
        // value_[6] = part_4[2]                                                                  <L 14>
        var_55 = wp::extract(var_47, var_54);
        wp::assign_inplace(var_1, var_56, var_55);
        // value_[7] = part_4[3]                                                                  <L 15>
        var_58 = wp::extract(var_47, var_57);
        wp::assign_inplace(var_1, var_59, var_58);
        // if i_ == 0:                                                                            <L 16>
        var_61 = (var_0 == var_60);
        if (var_61) {
            // out_[0] = value_                                                                   <L 17>
            wp::array_store(var_out_, var_62, var_1);
        }
}


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


// /work/main/src/pointloom/kernels/poses/pose_hypotheses.py:203
static CUDA_CALLABLE wp::vec_t<12, wp::float32> narrow_pose_0(
    wp::mat_t<4, 4, wp::float64> var_pose)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    wp::vec_t<12, wp::float32> var_1;
    const wp::int32 var_2 = 0;
    const wp::int32 var_3 = 0;
    wp::float64 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 3;
    wp::int32 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 1;
    wp::float64 var_10;
    wp::float32 var_11;
    const wp::int32 var_12 = 3;
    wp::int32 var_13;
    wp::int32 var_14;
    const wp::int32 var_15 = 2;
    wp::float64 var_16;
    wp::float32 var_17;
    const wp::int32 var_18 = 3;
    wp::int32 var_19;
    wp::int32 var_20;
    const wp::int32 var_21 = 3;
    wp::float64 var_22;
    wp::float32 var_23;
    const wp::int32 var_24 = 9;
    wp::int32 var_25;
    const wp::int32 var_26 = 1;
    const wp::int32 var_27 = 0;
    wp::float64 var_28;
    wp::float32 var_29;
    const wp::int32 var_30 = 3;
    wp::int32 var_31;
    wp::int32 var_32;
    const wp::int32 var_33 = 1;
    wp::float64 var_34;
    wp::float32 var_35;
    const wp::int32 var_36 = 3;
    wp::int32 var_37;
    wp::int32 var_38;
    const wp::int32 var_39 = 2;
    wp::float64 var_40;
    wp::float32 var_41;
    const wp::int32 var_42 = 3;
    wp::int32 var_43;
    wp::int32 var_44;
    const wp::int32 var_45 = 3;
    wp::float64 var_46;
    wp::float32 var_47;
    const wp::int32 var_48 = 9;
    wp::int32 var_49;
    const wp::int32 var_50 = 2;
    const wp::int32 var_51 = 0;
    wp::float64 var_52;
    wp::float32 var_53;
    const wp::int32 var_54 = 3;
    wp::int32 var_55;
    wp::int32 var_56;
    const wp::int32 var_57 = 1;
    wp::float64 var_58;
    wp::float32 var_59;
    const wp::int32 var_60 = 3;
    wp::int32 var_61;
    wp::int32 var_62;
    const wp::int32 var_63 = 2;
    wp::float64 var_64;
    wp::float32 var_65;
    const wp::int32 var_66 = 3;
    wp::int32 var_67;
    wp::int32 var_68;
    const wp::int32 var_69 = 3;
    wp::float64 var_70;
    wp::float32 var_71;
    const wp::int32 var_72 = 9;
    wp::int32 var_73;
    //---------
    // forward
    // def narrow_pose(pose: mat44d) -> pose_numbers:                                         <L 204>
    // d = pose_numbers(0.0)                                                                  <L 205>
    var_1 = wp::vec_t<12, wp::float32>(var_0);
    // for row in range(3):                                                                   <L 206>
    // for column in range(3):                                                                <L 207>
    // d[3 * row + column] = float(pose[row, column])                                         <L 208>
    var_4 = wp::extract(var_pose, var_2, var_3);
    var_5 = wp::float(var_4);
    var_7 = wp::mul(var_6, var_2);
    var_8 = wp::add(var_7, var_3);
    wp::assign_inplace(var_1, var_8, var_5);
    var_10 = wp::extract(var_pose, var_2, var_9);
    var_11 = wp::float(var_10);
    var_13 = wp::mul(var_12, var_2);
    var_14 = wp::add(var_13, var_9);
    wp::assign_inplace(var_1, var_14, var_11);
    var_16 = wp::extract(var_pose, var_2, var_15);
    var_17 = wp::float(var_16);
    var_19 = wp::mul(var_18, var_2);
    var_20 = wp::add(var_19, var_15);
    wp::assign_inplace(var_1, var_20, var_17);
    // d[9 + row] = float(pose[row, 3])                                                       <L 209>
    var_22 = wp::extract(var_pose, var_2, var_21);
    var_23 = wp::float(var_22);
    var_25 = wp::add(var_24, var_2);
    wp::assign_inplace(var_1, var_25, var_23);
    // for column in range(3):                                                                <L 207>
    // d[3 * row + column] = float(pose[row, column])                                         <L 208>
    var_28 = wp::extract(var_pose, var_26, var_27);
    var_29 = wp::float(var_28);
    var_31 = wp::mul(var_30, var_26);
    var_32 = wp::add(var_31, var_27);
    wp::assign_inplace(var_1, var_32, var_29);
    var_34 = wp::extract(var_pose, var_26, var_33);
    var_35 = wp::float(var_34);
    var_37 = wp::mul(var_36, var_26);
    var_38 = wp::add(var_37, var_33);
    wp::assign_inplace(var_1, var_38, var_35);
    var_40 = wp::extract(var_pose, var_26, var_39);
    var_41 = wp::float(var_40);
    var_43 = wp::mul(var_42, var_26);
    var_44 = wp::add(var_43, var_39);
    wp::assign_inplace(var_1, var_44, var_41);
    // d[9 + row] = float(pose[row, 3])                                                       <L 209>
    var_46 = wp::extract(var_pose, var_26, var_45);
    var_47 = wp::float(var_46);
    var_49 = wp::add(var_48, var_26);
    wp::assign_inplace(var_1, var_49, var_47);
    // for column in range(3):                                                                <L 207>
    // d[3 * row + column] = float(pose[row, column])                                         <L 208>
    var_52 = wp::extract(var_pose, var_50, var_51);
    var_53 = wp::float(var_52);
    var_55 = wp::mul(var_54, var_50);
    var_56 = wp::add(var_55, var_51);
    wp::assign_inplace(var_1, var_56, var_53);
    var_58 = wp::extract(var_pose, var_50, var_57);
    var_59 = wp::float(var_58);
    var_61 = wp::mul(var_60, var_50);
    var_62 = wp::add(var_61, var_57);
    wp::assign_inplace(var_1, var_62, var_59);
    var_64 = wp::extract(var_pose, var_50, var_63);
    var_65 = wp::float(var_64);
    var_67 = wp::mul(var_66, var_50);
    var_68 = wp::add(var_67, var_63);
    wp::assign_inplace(var_1, var_68, var_65);
    // d[9 + row] = float(pose[row, 3])                                                       <L 209>
    var_70 = wp::extract(var_pose, var_50, var_69);
    var_71 = wp::float(var_70);
    var_73 = wp::add(var_72, var_50);
    wp::assign_inplace(var_1, var_73, var_71);
    // return d                                                                               <L 210>
    return var_1;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:154
static CUDA_CALLABLE wp::int32 _lane_0(
    )
{
return (int)(threadIdx.x & 31u);}


// <pointloom.kernels.poses.pose_hypotheses.paired_sqdist>:1
static CUDA_CALLABLE wp::float32 paired_sqdist_0(
    wp::int32 var_j,
    wp::vec_t<12, wp::float32> var_pose,
    wp::array_t<wp::float32> var_pairs__coordinates,
    wp::int32 var_pairs__count)
{
    //---------
    // primal vars
    wp::float32* var_0;
    wp::float32 var_1;
    wp::float32 var_2;
    wp::int32 var_3;
    wp::float32* var_4;
    wp::float32 var_5;
    wp::float32 var_6;
    const wp::int32 var_7 = 2;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::float32* var_10;
    wp::float32 var_11;
    wp::float32 var_12;
    const wp::int32 var_13 = 0;
    wp::float32 var_14;
    wp::float32 var_15;
    const wp::int32 var_16 = 1;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    const wp::int32 var_20 = 2;
    wp::float32 var_21;
    wp::float32 var_22;
    wp::float32 var_23;
    const wp::int32 var_24 = 9;
    wp::float32 var_25;
    wp::float32 var_26;
    const wp::int32 var_27 = 3;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::float32* var_30;
    wp::float32 var_31;
    wp::float32 var_32;
    const wp::int32 var_33 = 3;
    wp::float32 var_34;
    wp::float32 var_35;
    const wp::int32 var_36 = 4;
    wp::float32 var_37;
    wp::float32 var_38;
    wp::float32 var_39;
    const wp::int32 var_40 = 5;
    wp::float32 var_41;
    wp::float32 var_42;
    wp::float32 var_43;
    const wp::int32 var_44 = 10;
    wp::float32 var_45;
    wp::float32 var_46;
    const wp::int32 var_47 = 4;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::float32* var_50;
    wp::float32 var_51;
    wp::float32 var_52;
    const wp::int32 var_53 = 6;
    wp::float32 var_54;
    wp::float32 var_55;
    const wp::int32 var_56 = 7;
    wp::float32 var_57;
    wp::float32 var_58;
    wp::float32 var_59;
    const wp::int32 var_60 = 8;
    wp::float32 var_61;
    wp::float32 var_62;
    wp::float32 var_63;
    const wp::int32 var_64 = 11;
    wp::float32 var_65;
    wp::float32 var_66;
    const wp::int32 var_67 = 5;
    wp::int32 var_68;
    wp::int32 var_69;
    wp::float32* var_70;
    wp::float32 var_71;
    wp::float32 var_72;
    wp::float32 var_73;
    wp::float32 var_74;
    wp::float32 var_75;
    wp::float32 var_76;
    wp::float32 var_77;
    //---------
    // forward
    // def paired_sqdist(j, pose, pairs__coordinates, pairs__count):                          <L 1>
    // px = pairs__coordinates[j]                                                             <L 2>
    var_0 = wp::address(var_pairs__coordinates, var_j);
    var_2 = wp::load(var_0);
    var_1 = wp::copy(var_2);
    // py = pairs__coordinates[pairs__count + j]                                              <L 3>
    var_3 = wp::add(var_pairs__count, var_j);
    var_4 = wp::address(var_pairs__coordinates, var_3);
    var_6 = wp::load(var_4);
    var_5 = wp::copy(var_6);
    // pz = pairs__coordinates[2 * pairs__count + j]                                          <L 4>
    var_8 = wp::mul(var_7, var_pairs__count);
    var_9 = wp::add(var_8, var_j);
    var_10 = wp::address(var_pairs__coordinates, var_9);
    var_12 = wp::load(var_10);
    var_11 = wp::copy(var_12);
    // x = pose[0] * px + pose[1] * py + pose[2] * pz + pose[9] - pairs__coordinates[3 * pairs__count + j]       <L 5>
    var_14 = wp::extract(var_pose, var_13);
    var_15 = wp::mul(var_14, var_1);
    var_17 = wp::extract(var_pose, var_16);
    var_18 = wp::mul(var_17, var_5);
    var_19 = wp::add(var_15, var_18);
    var_21 = wp::extract(var_pose, var_20);
    var_22 = wp::mul(var_21, var_11);
    var_23 = wp::add(var_19, var_22);
    var_25 = wp::extract(var_pose, var_24);
    var_26 = wp::add(var_23, var_25);
    var_28 = wp::mul(var_27, var_pairs__count);
    var_29 = wp::add(var_28, var_j);
    var_30 = wp::address(var_pairs__coordinates, var_29);
    var_32 = wp::load(var_30);
    var_31 = wp::sub(var_26, var_32);
    // y = pose[3] * px + pose[4] * py + pose[5] * pz + pose[10] - pairs__coordinates[4 * pairs__count + j]       <L 6>
    var_34 = wp::extract(var_pose, var_33);
    var_35 = wp::mul(var_34, var_1);
    var_37 = wp::extract(var_pose, var_36);
    var_38 = wp::mul(var_37, var_5);
    var_39 = wp::add(var_35, var_38);
    var_41 = wp::extract(var_pose, var_40);
    var_42 = wp::mul(var_41, var_11);
    var_43 = wp::add(var_39, var_42);
    var_45 = wp::extract(var_pose, var_44);
    var_46 = wp::add(var_43, var_45);
    var_48 = wp::mul(var_47, var_pairs__count);
    var_49 = wp::add(var_48, var_j);
    var_50 = wp::address(var_pairs__coordinates, var_49);
    var_52 = wp::load(var_50);
    var_51 = wp::sub(var_46, var_52);
    // z = pose[6] * px + pose[7] * py + pose[8] * pz + pose[11] - pairs__coordinates[5 * pairs__count + j]       <L 7>
    var_54 = wp::extract(var_pose, var_53);
    var_55 = wp::mul(var_54, var_1);
    var_57 = wp::extract(var_pose, var_56);
    var_58 = wp::mul(var_57, var_5);
    var_59 = wp::add(var_55, var_58);
    var_61 = wp::extract(var_pose, var_60);
    var_62 = wp::mul(var_61, var_11);
    var_63 = wp::add(var_59, var_62);
    var_65 = wp::extract(var_pose, var_64);
    var_66 = wp::add(var_63, var_65);
    var_68 = wp::mul(var_67, var_pairs__count);
    var_69 = wp::add(var_68, var_j);
    var_70 = wp::address(var_pairs__coordinates, var_69);
    var_72 = wp::load(var_70);
    var_71 = wp::sub(var_66, var_72);
    // return x * x + y * y + z * z                                                           <L 8>
    var_73 = wp::mul(var_31, var_31);
    var_74 = wp::mul(var_51, var_51);
    var_75 = wp::add(var_73, var_74);
    var_76 = wp::mul(var_71, var_71);
    var_77 = wp::add(var_75, var_76);
    return var_77;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:158
static CUDA_CALLABLE wp::int32 _ballot_0(
    wp::int32 flag)
{
return (int)__ballot_sync(0xffffffffu, flag != 0);}


// /work/main/src/pointloom/kernels/poses/pose_hypotheses.py:203
static CUDA_CALLABLE void adj_narrow_pose_0(
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::mat_t<4, 4, wp::float64> & adj_pose,
    wp::vec_t<12, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:154
static CUDA_CALLABLE void adj__lane_0(
    wp::int32 & adj_ret)
{
}


// <pointloom.kernels.poses.pose_hypotheses.paired_sqdist>:1
static CUDA_CALLABLE void adj_paired_sqdist_0(
    wp::int32 var_j,
    wp::vec_t<12, wp::float32> var_pose,
    wp::array_t<wp::float32> var_pairs__coordinates,
    wp::int32 var_pairs__count,
    wp::int32 & adj_j,
    wp::vec_t<12, wp::float32> & adj_pose,
    wp::array_t<wp::float32> & adj_pairs__coordinates,
    wp::int32 & adj_pairs__count,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:158
static CUDA_CALLABLE void adj__ballot_0(
    wp::int32 flag,
    wp::int32 & adj_flag,
    wp::int32 & adj_ret)
{
}



extern "C" __global__ void score_in_lanes_kernel_7f75c078_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_pairs__coordinates,
    wp::int32 var_pairs__count,
    wp::int32 var_run,
    wp::int32 var_size_of_block,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_poses,
    wp::float32 var_limit,
    wp::array_t<wp::int32> var_scores)
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
        const wp::int32 var_5 = 8;
        wp::int32 var_6;
        const wp::int32 var_7 = 1;
        wp::int32 var_8;
        wp::int32 var_9;
        const wp::int32 var_10 = 32;
        wp::int32 var_11;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int32 var_14;
        wp::int32 var_15;
        wp::int32 var_16;
        wp::int32 var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::shape_t* var_20;
        const wp::int32 var_21 = 0;
        wp::int32 var_22;
        wp::shape_t var_23;
        wp::int32 var_24;
        wp::range_t var_25;
        wp::int32 var_26;
        wp::int32* var_27;
        const wp::int32 var_28 = -1;
        bool var_29;
        wp::int32 var_30;
        wp::mat_t<4, 4, wp::float64>* var_31;
        wp::vec_t<12, wp::float32> var_32;
        wp::mat_t<4, 4, wp::float64> var_33;
        const wp::int32 var_34 = 0;
        wp::int32 var_35;
        wp::int32 var_36;
        wp::int32 var_37;
        const wp::int32 var_38 = 1;
        wp::int32 var_39;
        wp::int32 var_40;
        wp::range_t var_41;
        wp::int32 var_42;
        wp::int32 var_43;
        wp::int32 var_44;
        wp::int32 var_45;
        wp::int32 var_46;
        const wp::int32 var_47 = 0;
        wp::int32 var_48;
        bool var_49;
        wp::float32 var_50;
        bool var_51;
        const wp::int32 var_52 = 1;
        wp::int32 var_53;
        wp::int32 var_54;
        wp::int32 var_55;
        wp::int32 var_56;
        wp::int32 var_57;
        bool var_58;
        wp::int32 var_59;
        const wp::int32 var_60 = 0;
        bool var_61;
        const wp::int32 var_62 = 0;
        bool var_63;
        wp::int32 var_64;
        //---------
        // forward
        // def score_in_lanes_kernel(pairs__coordinates, pairs__count, run, size_of_block, poses, limit, scores):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // groups = (poses.shape[0] + GROUP - 1) // GROUP                                         <L 4>
        var_1 = &(var_poses.shape);
        var_4 = wp::load(var_1);
        var_3 = wp::extract(var_4, var_2);
        var_6 = wp::add(var_3, var_5);
        var_8 = wp::sub(var_6, var_7);
        var_9 = wp::floordiv(var_8, var_5);
        // first = i // WARP // groups * size_of_block                                            <L 5>
        var_11 = wp::floordiv(var_0, var_10);
        var_12 = wp::floordiv(var_11, var_9);
        var_13 = wp::mul(var_12, var_size_of_block);
        // last = min(first + size_of_block, pairs__count)                                        <L 6>
        var_14 = wp::add(var_13, var_size_of_block);
        var_15 = wp::min(var_14, var_pairs__count);
        // start = i // WARP % groups * GROUP                                                     <L 7>
        var_16 = wp::floordiv(var_0, var_10);
        var_17 = wp::mod(var_16, var_9);
        var_18 = wp::mul(var_17, var_5);
        // for k in range(start, min(start + GROUP, poses.shape[0])):                             <L 8>
        var_19 = wp::add(var_18, var_5);
        var_20 = &(var_poses.shape);
        var_23 = wp::load(var_20);
        var_22 = wp::extract(var_23, var_21);
        var_24 = wp::min(var_19, var_22);
        var_25 = wp::range(var_18, var_24);
        start_for_0:;
            if (iter_cmp(var_25) == 0) goto end_for_0;
            var_26 = wp::iter_next(var_25);
            // if scores[k] != REFUSED:                                                           <L 9>
            var_27 = wp::address(var_scores, var_26);
            var_30 = wp::load(var_27);
            var_29 = (var_30 != var_28);
            if (var_29) {
                // pose = narrow_pose(poses[k])                                                   <L 10>
                var_31 = wp::address(var_poses, var_26);
                var_33 = wp::load(var_31);
                var_32 = narrow_pose_0(var_33);
                // count = int(0)                                                                 <L 11>
                var_35 = wp::int(var_34);
                // for step in range((last - first + WARP - 1) // WARP):                          <L 12>
                var_36 = wp::sub(var_15, var_13);
                var_37 = wp::add(var_36, var_10);
                var_39 = wp::sub(var_37, var_38);
                var_40 = wp::floordiv(var_39, var_10);
                var_41 = wp::range(var_40);
                start_for_2:;
                    if (iter_cmp(var_41) == 0) goto end_for_2;
                    var_42 = wp::iter_next(var_41);
                    // j = first + step * WARP + lane()                                           <L 13>
                    var_43 = wp::mul(var_42, var_10);
                    var_44 = wp::add(var_13, var_43);
                    var_45 = _lane_0();
                    var_46 = wp::add(var_44, var_45);
                    // is_near = int(0)                                                           <L 14>
                    var_48 = wp::int(var_47);
                    // if j < last:                                                               <L 15>
                    var_49 = (var_46 < var_15);
                    if (var_49) {
                        // if paired_sqdist(j, pose, pairs__coordinates, pairs__count) < limit:       <L 16>
                        var_50 = paired_sqdist_0(var_46, var_32, var_pairs__coordinates, var_pairs__count);
                        var_51 = (var_50 < var_limit);
                        if (var_51) {
                            // is_near = 1                                                        <L 17>
                        }
                        var_53 = wp::where(var_51, var_52, var_48);
                    }
                    var_54 = wp::where(var_49, var_53, var_48);
                    // count += bit_count(ballot(is_near))                                        <L 18>
                    var_55 = _ballot_0(var_54);
                    var_56 = wp::bit_count(var_55);
                    var_57 = wp::add(var_35, var_56);
                    wp::assign(var_35, var_57);
                    goto start_for_2;
                end_for_2:;
                // if lane() == 0 and count > 0:                                                  <L 19>
                var_59 = _lane_0();
                var_61 = (var_59 == var_60);
                var_58 = var_61;
                if (var_58) {
                    var_63 = (var_35 > var_62);
                    var_58 = var_58 && var_63;
                }
                if (var_58) {
                    // atomic_add(scores, k, count)                                               <L 20>
                    var_64 = wp::atomic_add(var_scores, var_26, var_35);
                }
            }
            goto start_for_0;
        end_for_0:;
}


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


// <pointloom.kernels.icp.jobs.source_position>:1
static CUDA_CALLABLE wp::int32 source_position_0(
    wp::int32 var_i,
    wp::array_t<wp::int32> var_jobs__sources__first_positions,
    wp::array_t<wp::int32> var_jobs__group_jobs,
    wp::array_t<wp::int32> var_jobs__job_groups,
    wp::array_t<wp::int32> var_jobs__job_sources)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 8;
    wp::int32 var_1;
    wp::int32* var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::int32* var_5;
    wp::int32 var_6;
    wp::int32* var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::int32* var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    //---------
    // forward
    // def source_position(i, jobs__sources__first_positions, jobs__group_jobs, jobs__job_groups, jobs__job_sources):       <L 1>
    // job = jobs__group_jobs[i // LEAF]                                                      <L 2>
    var_1 = wp::floordiv(var_i, var_0);
    var_2 = wp::address(var_jobs__group_jobs, var_1);
    var_4 = wp::load(var_2);
    var_3 = wp::copy(var_4);
    // return jobs__sources__first_positions[jobs__job_sources[job]] + i - jobs__job_groups[job] * LEAF       <L 3>
    var_5 = wp::address(var_jobs__job_sources, var_3);
    var_6 = wp::load(var_5);
    var_7 = wp::address(var_jobs__sources__first_positions, var_6);
    var_9 = wp::load(var_7);
    var_8 = wp::add(var_9, var_i);
    var_10 = wp::address(var_jobs__job_groups, var_3);
    var_12 = wp::load(var_10);
    var_11 = wp::mul(var_12, var_0);
    var_13 = wp::sub(var_8, var_11);
    return var_13;
}


// /work/main/src/pointloom/kernels/algebra/transform.py:27
static CUDA_CALLABLE wp::vec_t<3, wp::float64> widen_0(
    wp::vec_t<3, wp::float32> var_p)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::float64 var_2;
    const wp::int32 var_3 = 1;
    wp::float32 var_4;
    wp::float64 var_5;
    const wp::int32 var_6 = 2;
    wp::float32 var_7;
    wp::float64 var_8;
    wp::vec_t<3, wp::float64> var_9;
    //---------
    // forward
    // def widen(p: vec3) -> vec3d:                                                           <L 28>
    // return vec3d(float64(p[0]), float64(p[1]), float64(p[2]))                              <L 29>
    var_1 = wp::extract(var_p, var_0);
    var_2 = wp::float64(var_1);
    var_4 = wp::extract(var_p, var_3);
    var_5 = wp::float64(var_4);
    var_7 = wp::extract(var_p, var_6);
    var_8 = wp::float64(var_7);
    var_9 = wp::vec_t<3, wp::float64>(var_2, var_5, var_8);
    return var_9;
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:301
static CUDA_CALLABLE wp::vec_t<3, wp::float64> move_0(
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::vec_t<3, wp::float64> var_p)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 0;
    wp::float64 var_2;
    const wp::int32 var_3 = 0;
    wp::float64 var_4;
    wp::float64 var_5;
    const wp::int32 var_6 = 0;
    const wp::int32 var_7 = 1;
    wp::float64 var_8;
    const wp::int32 var_9 = 1;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    const wp::int32 var_13 = 0;
    const wp::int32 var_14 = 2;
    wp::float64 var_15;
    const wp::int32 var_16 = 2;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    const wp::int32 var_20 = 0;
    const wp::int32 var_21 = 3;
    wp::float64 var_22;
    wp::float64 var_23;
    const wp::int32 var_24 = 1;
    const wp::int32 var_25 = 0;
    wp::float64 var_26;
    const wp::int32 var_27 = 0;
    wp::float64 var_28;
    wp::float64 var_29;
    const wp::int32 var_30 = 1;
    const wp::int32 var_31 = 1;
    wp::float64 var_32;
    const wp::int32 var_33 = 1;
    wp::float64 var_34;
    wp::float64 var_35;
    wp::float64 var_36;
    const wp::int32 var_37 = 1;
    const wp::int32 var_38 = 2;
    wp::float64 var_39;
    const wp::int32 var_40 = 2;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    const wp::int32 var_44 = 1;
    const wp::int32 var_45 = 3;
    wp::float64 var_46;
    wp::float64 var_47;
    const wp::int32 var_48 = 2;
    const wp::int32 var_49 = 0;
    wp::float64 var_50;
    const wp::int32 var_51 = 0;
    wp::float64 var_52;
    wp::float64 var_53;
    const wp::int32 var_54 = 2;
    const wp::int32 var_55 = 1;
    wp::float64 var_56;
    const wp::int32 var_57 = 1;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float64 var_60;
    const wp::int32 var_61 = 2;
    const wp::int32 var_62 = 2;
    wp::float64 var_63;
    const wp::int32 var_64 = 2;
    wp::float64 var_65;
    wp::float64 var_66;
    wp::float64 var_67;
    const wp::int32 var_68 = 2;
    const wp::int32 var_69 = 3;
    wp::float64 var_70;
    wp::float64 var_71;
    wp::vec_t<3, wp::float64> var_72;
    //---------
    // forward
    // def move(pose: mat44d, p: vec3d) -> vec3d:                                             <L 302>
    // return vec3d(                                                                          <L 303>
    // pose[0, 0] * p[0] + pose[0, 1] * p[1] + pose[0, 2] * p[2] + pose[0, 3],                <L 304>
    var_2 = wp::extract(var_pose, var_0, var_1);
    var_4 = wp::extract(var_p, var_3);
    var_5 = wp::mul(var_2, var_4);
    var_8 = wp::extract(var_pose, var_6, var_7);
    var_10 = wp::extract(var_p, var_9);
    var_11 = wp::mul(var_8, var_10);
    var_12 = wp::add(var_5, var_11);
    var_15 = wp::extract(var_pose, var_13, var_14);
    var_17 = wp::extract(var_p, var_16);
    var_18 = wp::mul(var_15, var_17);
    var_19 = wp::add(var_12, var_18);
    var_22 = wp::extract(var_pose, var_20, var_21);
    var_23 = wp::add(var_19, var_22);
    // pose[1, 0] * p[0] + pose[1, 1] * p[1] + pose[1, 2] * p[2] + pose[1, 3],                <L 305>
    var_26 = wp::extract(var_pose, var_24, var_25);
    var_28 = wp::extract(var_p, var_27);
    var_29 = wp::mul(var_26, var_28);
    var_32 = wp::extract(var_pose, var_30, var_31);
    var_34 = wp::extract(var_p, var_33);
    var_35 = wp::mul(var_32, var_34);
    var_36 = wp::add(var_29, var_35);
    var_39 = wp::extract(var_pose, var_37, var_38);
    var_41 = wp::extract(var_p, var_40);
    var_42 = wp::mul(var_39, var_41);
    var_43 = wp::add(var_36, var_42);
    var_46 = wp::extract(var_pose, var_44, var_45);
    var_47 = wp::add(var_43, var_46);
    // pose[2, 0] * p[0] + pose[2, 1] * p[1] + pose[2, 2] * p[2] + pose[2, 3],                <L 306>
    var_50 = wp::extract(var_pose, var_48, var_49);
    var_52 = wp::extract(var_p, var_51);
    var_53 = wp::mul(var_50, var_52);
    var_56 = wp::extract(var_pose, var_54, var_55);
    var_58 = wp::extract(var_p, var_57);
    var_59 = wp::mul(var_56, var_58);
    var_60 = wp::add(var_53, var_59);
    var_63 = wp::extract(var_pose, var_61, var_62);
    var_65 = wp::extract(var_p, var_64);
    var_66 = wp::mul(var_63, var_65);
    var_67 = wp::add(var_60, var_66);
    var_70 = wp::extract(var_pose, var_68, var_69);
    var_71 = wp::add(var_67, var_70);
    var_72 = wp::vec_t<3, wp::float64>(var_23, var_47, var_71);
    return var_72;
}


// /work/main/src/pointloom/kernels/algebra/transform.py:32
static CUDA_CALLABLE wp::vec_t<3, wp::float32> narrow_0(
    wp::vec_t<3, wp::float64> var_p)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float64 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 1;
    wp::float64 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 2;
    wp::float64 var_7;
    wp::float32 var_8;
    wp::vec_t<3, wp::float32> var_9;
    //---------
    // forward
    // def narrow(p: vec3d) -> vec3:                                                          <L 33>
    // return vec3(float(p[0]), float(p[1]), float(p[2]))                                     <L 34>
    var_1 = wp::extract(var_p, var_0);
    var_2 = wp::float(var_1);
    var_4 = wp::extract(var_p, var_3);
    var_5 = wp::float(var_4);
    var_7 = wp::extract(var_p, var_6);
    var_8 = wp::float(var_7);
    var_9 = wp::vec_t<3, wp::float32>(var_2, var_5, var_8);
    return var_9;
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


// /work/main/src/pointloom/kernels/icp/correspondences.py:115
static CUDA_CALLABLE wp::vec_t<12, wp::float32> difference_of_0(
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::mat_t<4, 4, wp::float64> var_before)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    wp::vec_t<12, wp::float32> var_1;
    const wp::int32 var_2 = 0;
    const wp::int32 var_3 = 0;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    wp::float32 var_7;
    const wp::int32 var_8 = 3;
    wp::int32 var_9;
    wp::int32 var_10;
    const wp::int32 var_11 = 1;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    wp::float32 var_15;
    const wp::int32 var_16 = 3;
    wp::int32 var_17;
    wp::int32 var_18;
    const wp::int32 var_19 = 2;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    wp::float32 var_23;
    const wp::int32 var_24 = 3;
    wp::int32 var_25;
    wp::int32 var_26;
    const wp::int32 var_27 = 3;
    wp::float64 var_28;
    const wp::int32 var_29 = 3;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float32 var_32;
    const wp::int32 var_33 = 9;
    wp::int32 var_34;
    const wp::int32 var_35 = 1;
    const wp::int32 var_36 = 0;
    wp::float64 var_37;
    wp::float64 var_38;
    wp::float64 var_39;
    wp::float32 var_40;
    const wp::int32 var_41 = 3;
    wp::int32 var_42;
    wp::int32 var_43;
    const wp::int32 var_44 = 1;
    wp::float64 var_45;
    wp::float64 var_46;
    wp::float64 var_47;
    wp::float32 var_48;
    const wp::int32 var_49 = 3;
    wp::int32 var_50;
    wp::int32 var_51;
    const wp::int32 var_52 = 2;
    wp::float64 var_53;
    wp::float64 var_54;
    wp::float64 var_55;
    wp::float32 var_56;
    const wp::int32 var_57 = 3;
    wp::int32 var_58;
    wp::int32 var_59;
    const wp::int32 var_60 = 3;
    wp::float64 var_61;
    const wp::int32 var_62 = 3;
    wp::float64 var_63;
    wp::float64 var_64;
    wp::float32 var_65;
    const wp::int32 var_66 = 9;
    wp::int32 var_67;
    const wp::int32 var_68 = 2;
    const wp::int32 var_69 = 0;
    wp::float64 var_70;
    wp::float64 var_71;
    wp::float64 var_72;
    wp::float32 var_73;
    const wp::int32 var_74 = 3;
    wp::int32 var_75;
    wp::int32 var_76;
    const wp::int32 var_77 = 1;
    wp::float64 var_78;
    wp::float64 var_79;
    wp::float64 var_80;
    wp::float32 var_81;
    const wp::int32 var_82 = 3;
    wp::int32 var_83;
    wp::int32 var_84;
    const wp::int32 var_85 = 2;
    wp::float64 var_86;
    wp::float64 var_87;
    wp::float64 var_88;
    wp::float32 var_89;
    const wp::int32 var_90 = 3;
    wp::int32 var_91;
    wp::int32 var_92;
    const wp::int32 var_93 = 3;
    wp::float64 var_94;
    const wp::int32 var_95 = 3;
    wp::float64 var_96;
    wp::float64 var_97;
    wp::float32 var_98;
    const wp::int32 var_99 = 9;
    wp::int32 var_100;
    //---------
    // forward
    // def difference_of(pose: mat44d, before: mat44d) -> motion:                             <L 116>
    // d = motion(0.0)                                                                        <L 118>
    var_1 = wp::vec_t<12, wp::float32>(var_0);
    // for row in range(3):                                                                   <L 119>
    // for column in range(3):                                                                <L 120>
    // d[3 * row + column] = float(pose[row, column] - before[row, column])                   <L 121>
    var_4 = wp::extract(var_pose, var_2, var_3);
    var_5 = wp::extract(var_before, var_2, var_3);
    var_6 = wp::sub(var_4, var_5);
    var_7 = wp::float(var_6);
    var_9 = wp::mul(var_8, var_2);
    var_10 = wp::add(var_9, var_3);
    wp::assign_inplace(var_1, var_10, var_7);
    var_12 = wp::extract(var_pose, var_2, var_11);
    var_13 = wp::extract(var_before, var_2, var_11);
    var_14 = wp::sub(var_12, var_13);
    var_15 = wp::float(var_14);
    var_17 = wp::mul(var_16, var_2);
    var_18 = wp::add(var_17, var_11);
    wp::assign_inplace(var_1, var_18, var_15);
    var_20 = wp::extract(var_pose, var_2, var_19);
    var_21 = wp::extract(var_before, var_2, var_19);
    var_22 = wp::sub(var_20, var_21);
    var_23 = wp::float(var_22);
    var_25 = wp::mul(var_24, var_2);
    var_26 = wp::add(var_25, var_19);
    wp::assign_inplace(var_1, var_26, var_23);
    // d[9 + row] = float(pose[row, 3] - before[row, 3])                                      <L 122>
    var_28 = wp::extract(var_pose, var_2, var_27);
    var_30 = wp::extract(var_before, var_2, var_29);
    var_31 = wp::sub(var_28, var_30);
    var_32 = wp::float(var_31);
    var_34 = wp::add(var_33, var_2);
    wp::assign_inplace(var_1, var_34, var_32);
    // for column in range(3):                                                                <L 120>
    // d[3 * row + column] = float(pose[row, column] - before[row, column])                   <L 121>
    var_37 = wp::extract(var_pose, var_35, var_36);
    var_38 = wp::extract(var_before, var_35, var_36);
    var_39 = wp::sub(var_37, var_38);
    var_40 = wp::float(var_39);
    var_42 = wp::mul(var_41, var_35);
    var_43 = wp::add(var_42, var_36);
    wp::assign_inplace(var_1, var_43, var_40);
    var_45 = wp::extract(var_pose, var_35, var_44);
    var_46 = wp::extract(var_before, var_35, var_44);
    var_47 = wp::sub(var_45, var_46);
    var_48 = wp::float(var_47);
    var_50 = wp::mul(var_49, var_35);
    var_51 = wp::add(var_50, var_44);
    wp::assign_inplace(var_1, var_51, var_48);
    var_53 = wp::extract(var_pose, var_35, var_52);
    var_54 = wp::extract(var_before, var_35, var_52);
    var_55 = wp::sub(var_53, var_54);
    var_56 = wp::float(var_55);
    var_58 = wp::mul(var_57, var_35);
    var_59 = wp::add(var_58, var_52);
    wp::assign_inplace(var_1, var_59, var_56);
    // d[9 + row] = float(pose[row, 3] - before[row, 3])                                      <L 122>
    var_61 = wp::extract(var_pose, var_35, var_60);
    var_63 = wp::extract(var_before, var_35, var_62);
    var_64 = wp::sub(var_61, var_63);
    var_65 = wp::float(var_64);
    var_67 = wp::add(var_66, var_35);
    wp::assign_inplace(var_1, var_67, var_65);
    // for column in range(3):                                                                <L 120>
    // d[3 * row + column] = float(pose[row, column] - before[row, column])                   <L 121>
    var_70 = wp::extract(var_pose, var_68, var_69);
    var_71 = wp::extract(var_before, var_68, var_69);
    var_72 = wp::sub(var_70, var_71);
    var_73 = wp::float(var_72);
    var_75 = wp::mul(var_74, var_68);
    var_76 = wp::add(var_75, var_69);
    wp::assign_inplace(var_1, var_76, var_73);
    var_78 = wp::extract(var_pose, var_68, var_77);
    var_79 = wp::extract(var_before, var_68, var_77);
    var_80 = wp::sub(var_78, var_79);
    var_81 = wp::float(var_80);
    var_83 = wp::mul(var_82, var_68);
    var_84 = wp::add(var_83, var_77);
    wp::assign_inplace(var_1, var_84, var_81);
    var_86 = wp::extract(var_pose, var_68, var_85);
    var_87 = wp::extract(var_before, var_68, var_85);
    var_88 = wp::sub(var_86, var_87);
    var_89 = wp::float(var_88);
    var_91 = wp::mul(var_90, var_68);
    var_92 = wp::add(var_91, var_85);
    wp::assign_inplace(var_1, var_92, var_89);
    // d[9 + row] = float(pose[row, 3] - before[row, 3])                                      <L 122>
    var_94 = wp::extract(var_pose, var_68, var_93);
    var_96 = wp::extract(var_before, var_68, var_95);
    var_97 = wp::sub(var_94, var_96);
    var_98 = wp::float(var_97);
    var_100 = wp::add(var_99, var_68);
    wp::assign_inplace(var_1, var_100, var_98);
    // return d                                                                               <L 123>
    return var_1;
}


// /work/main/src/pointloom/kernels/algebra/plain_min_max.py:11
static CUDA_CALLABLE wp::float32 larger_0(
    wp::float32 var_a,
    wp::float32 var_b)
{
    //---------
    // primal vars
    bool var_0;
    wp::float32 var_1;
    //---------
    // forward
    // def larger(a: float, b: float) -> float:                                               <L 12>
    // return a if a > b else b                                                               <L 13>
    var_0 = (var_a > var_b);
    if (var_0) {
    }
    if (!var_0) {
    }
    var_1 = wp::where(var_0, var_a, var_b);
    return var_1;
}


// /work/main/src/pointloom/kernels/icp/correspondences.py:126
static CUDA_CALLABLE wp::float32 remaining_bound_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_q,
    wp::vec_t<12, wp::float32> var_d,
    wp::float32 var_lower)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    wp::float32 var_4;
    const wp::int32 var_5 = 1;
    wp::float32 var_6;
    const wp::int32 var_7 = 1;
    wp::float32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 2;
    wp::float32 var_12;
    const wp::int32 var_13 = 2;
    wp::float32 var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    const wp::int32 var_17 = 9;
    wp::float32 var_18;
    wp::float32 var_19;
    const wp::int32 var_20 = 3;
    wp::float32 var_21;
    const wp::int32 var_22 = 0;
    wp::float32 var_23;
    wp::float32 var_24;
    const wp::int32 var_25 = 4;
    wp::float32 var_26;
    const wp::int32 var_27 = 1;
    wp::float32 var_28;
    wp::float32 var_29;
    wp::float32 var_30;
    const wp::int32 var_31 = 5;
    wp::float32 var_32;
    const wp::int32 var_33 = 2;
    wp::float32 var_34;
    wp::float32 var_35;
    wp::float32 var_36;
    const wp::int32 var_37 = 10;
    wp::float32 var_38;
    wp::float32 var_39;
    const wp::int32 var_40 = 6;
    wp::float32 var_41;
    const wp::int32 var_42 = 0;
    wp::float32 var_43;
    wp::float32 var_44;
    const wp::int32 var_45 = 7;
    wp::float32 var_46;
    const wp::int32 var_47 = 1;
    wp::float32 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    const wp::int32 var_51 = 8;
    wp::float32 var_52;
    const wp::int32 var_53 = 2;
    wp::float32 var_54;
    wp::float32 var_55;
    wp::float32 var_56;
    const wp::int32 var_57 = 11;
    wp::float32 var_58;
    wp::float32 var_59;
    const wp::int32 var_60 = 0;
    wp::float32 var_61;
    wp::float32 var_62;
    const wp::int32 var_63 = 1;
    wp::float32 var_64;
    wp::float32 var_65;
    wp::float32 var_66;
    const wp::int32 var_67 = 2;
    wp::float32 var_68;
    wp::float32 var_69;
    wp::float32 var_70;
    const wp::int32 var_71 = 0;
    wp::float32 var_72;
    wp::float32 var_73;
    const wp::int32 var_74 = 1;
    wp::float32 var_75;
    wp::float32 var_76;
    wp::float32 var_77;
    const wp::int32 var_78 = 2;
    wp::float32 var_79;
    wp::float32 var_80;
    wp::float32 var_81;
    wp::float32 var_82;
    wp::float32 var_83;
    wp::float32 var_84;
    wp::float32 var_85;
    wp::float32 var_86;
    wp::float32 var_87;
    const wp::float32 var_88 = 1.0;
    const wp::float32 var_89 = 1e-06;
    wp::float32 var_90;
    wp::float32 var_91;
    wp::float32 var_92;
    wp::float32 var_93;
    wp::float32 var_94;
    wp::float32 var_95;
    //---------
    // forward
    // def remaining_bound(p: vec3, q: vec3, d: motion, lower: float) -> float:               <L 127>
    // x = d[0] * p[0] + d[1] * p[1] + d[2] * p[2] + d[9]                                     <L 129>
    var_1 = wp::extract(var_d, var_0);
    var_3 = wp::extract(var_p, var_2);
    var_4 = wp::mul(var_1, var_3);
    var_6 = wp::extract(var_d, var_5);
    var_8 = wp::extract(var_p, var_7);
    var_9 = wp::mul(var_6, var_8);
    var_10 = wp::add(var_4, var_9);
    var_12 = wp::extract(var_d, var_11);
    var_14 = wp::extract(var_p, var_13);
    var_15 = wp::mul(var_12, var_14);
    var_16 = wp::add(var_10, var_15);
    var_18 = wp::extract(var_d, var_17);
    var_19 = wp::add(var_16, var_18);
    // y = d[3] * p[0] + d[4] * p[1] + d[5] * p[2] + d[10]                                    <L 130>
    var_21 = wp::extract(var_d, var_20);
    var_23 = wp::extract(var_p, var_22);
    var_24 = wp::mul(var_21, var_23);
    var_26 = wp::extract(var_d, var_25);
    var_28 = wp::extract(var_p, var_27);
    var_29 = wp::mul(var_26, var_28);
    var_30 = wp::add(var_24, var_29);
    var_32 = wp::extract(var_d, var_31);
    var_34 = wp::extract(var_p, var_33);
    var_35 = wp::mul(var_32, var_34);
    var_36 = wp::add(var_30, var_35);
    var_38 = wp::extract(var_d, var_37);
    var_39 = wp::add(var_36, var_38);
    // z = d[6] * p[0] + d[7] * p[1] + d[8] * p[2] + d[11]                                    <L 131>
    var_41 = wp::extract(var_d, var_40);
    var_43 = wp::extract(var_p, var_42);
    var_44 = wp::mul(var_41, var_43);
    var_46 = wp::extract(var_d, var_45);
    var_48 = wp::extract(var_p, var_47);
    var_49 = wp::mul(var_46, var_48);
    var_50 = wp::add(var_44, var_49);
    var_52 = wp::extract(var_d, var_51);
    var_54 = wp::extract(var_p, var_53);
    var_55 = wp::mul(var_52, var_54);
    var_56 = wp::add(var_50, var_55);
    var_58 = wp::extract(var_d, var_57);
    var_59 = wp::add(var_56, var_58);
    // size = larger(larger(abs(q[0]), abs(q[1])), abs(q[2]))                                 <L 132>
    var_61 = wp::extract(var_q, var_60);
    var_62 = wp::abs(var_61);
    var_64 = wp::extract(var_q, var_63);
    var_65 = wp::abs(var_64);
    var_66 = larger_0(var_62, var_65);
    var_68 = wp::extract(var_q, var_67);
    var_69 = wp::abs(var_68);
    var_70 = larger_0(var_66, var_69);
    // extent = larger(larger(abs(p[0]), abs(p[1])), abs(p[2]))                               <L 133>
    var_72 = wp::extract(var_p, var_71);
    var_73 = wp::abs(var_72);
    var_75 = wp::extract(var_p, var_74);
    var_76 = wp::abs(var_75);
    var_77 = larger_0(var_73, var_76);
    var_79 = wp::extract(var_p, var_78);
    var_80 = wp::abs(var_79);
    var_81 = larger_0(var_77, var_80);
    // return lower - sqrt(x * x + y * y + z * z) * (1.0 + SLACK) - SLACK * (size + extent)       <L 134>
    var_82 = wp::mul(var_19, var_19);
    var_83 = wp::mul(var_39, var_39);
    var_84 = wp::add(var_82, var_83);
    var_85 = wp::mul(var_59, var_59);
    var_86 = wp::add(var_84, var_85);
    var_87 = wp::sqrt(var_86);
    var_90 = wp::add(var_88, var_89);
    var_91 = wp::mul(var_87, var_90);
    var_92 = wp::sub(var_lower, var_91);
    var_93 = wp::add(var_70, var_81);
    var_94 = wp::mul(var_89, var_93);
    var_95 = wp::sub(var_92, var_94);
    return var_95;
}


// /work/main/src/pointloom/kernels/search/point_tree.py:379
static CUDA_CALLABLE wp::float32 square_distance_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_q)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    wp::float32 var_4;
    const wp::int32 var_5 = 1;
    wp::float32 var_6;
    const wp::int32 var_7 = 1;
    wp::float32 var_8;
    wp::float32 var_9;
    const wp::int32 var_10 = 2;
    wp::float32 var_11;
    const wp::int32 var_12 = 2;
    wp::float32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    //---------
    // forward
    // def square_distance(p: vec3, q: vec3) -> float:                                        <L 380>
    // x = q[0] - p[0]                                                                        <L 382>
    var_1 = wp::extract(var_q, var_0);
    var_3 = wp::extract(var_p, var_2);
    var_4 = wp::sub(var_1, var_3);
    // y = q[1] - p[1]                                                                        <L 383>
    var_6 = wp::extract(var_q, var_5);
    var_8 = wp::extract(var_p, var_7);
    var_9 = wp::sub(var_6, var_8);
    // z = q[2] - p[2]                                                                        <L 384>
    var_11 = wp::extract(var_q, var_10);
    var_13 = wp::extract(var_p, var_12);
    var_14 = wp::sub(var_11, var_13);
    // return x * x + y * y + z * z                                                           <L 385>
    var_15 = wp::mul(var_4, var_4);
    var_16 = wp::mul(var_9, var_9);
    var_17 = wp::add(var_15, var_16);
    var_18 = wp::mul(var_14, var_14);
    var_19 = wp::add(var_17, var_18);
    return var_19;
}


// /work/main/src/pointloom/kernels/search/hilbert_order.py:102
static CUDA_CALLABLE wp::int32 cell_on_axis_0(
    wp::float32 var_coordinate,
    wp::float32 var_low,
    wp::float32 var_scale,
    wp::int32 var_levels)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    wp::float32 var_6;
    const wp::float32 var_7 = 0.0;
    wp::float32 var_8;
    wp::float32 var_9;
    wp::int32 var_10;
    //---------
    // forward
    // def cell_on_axis(coordinate: float, low: float, scale: float, levels: int) -> int:       <L 103>
    // top = float((1 << levels) - 1)                                                         <L 104>
    var_1 = wp::lshift(var_0, var_levels);
    var_3 = wp::sub(var_1, var_2);
    var_4 = wp::float(var_3);
    // return int(min(max((coordinate - low) * scale, 0.0), top))                             <L 105>
    var_5 = wp::sub(var_coordinate, var_low);
    var_6 = wp::mul(var_5, var_scale);
    var_8 = wp::max(var_6, var_7);
    var_9 = wp::min(var_8, var_4);
    var_10 = wp::int(var_9);
    return var_10;
}


// <pointloom.kernels.search.hilbert_order.spread_bits>:1
static CUDA_CALLABLE wp::int64 spread_bits_0(
    wp::int32 var_v)
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
    wp::int64 var_12;
    wp::int64 var_13;
    wp::int64 var_14;
    wp::int64 var_15;
    wp::int64 var_16;
    wp::int64 var_17;
    wp::int64 var_18;
    wp::int64 var_19;
    wp::int64 var_20;
    wp::int64 var_21;
    wp::int64 var_22;
    wp::int64 var_23;
    wp::int64 var_24;
    wp::int64 var_25;
    //---------
    // forward
    // def spread_bits(v):                                                                    <L 1>
    // x = int64(v)                                                                           <L 3>
    var_0 = wp::int64(var_v);
    // x = (x | x << int64(32)) & int64(8725724278095871)                                     <L 4>
    var_1 = 32ll;
    var_2 = wp::lshift(var_0, var_1);
    var_3 = wp::bit_or(var_0, var_2);
    var_4 = 8725724278095871ll;
    var_5 = wp::bit_and(var_3, var_4);
    // x = (x | x << int64(16)) & int64(8725728556220671)                                     <L 5>
    var_6 = 16ll;
    var_7 = wp::lshift(var_5, var_6);
    var_8 = wp::bit_or(var_5, var_7);
    var_9 = 8725728556220671ll;
    var_10 = wp::bit_and(var_8, var_9);
    // x = (x | x << int64(8)) & int64(1157144660301377551)                                   <L 6>
    var_11 = 8ll;
    var_12 = wp::lshift(var_10, var_11);
    var_13 = wp::bit_or(var_10, var_12);
    var_14 = 1157144660301377551ll;
    var_15 = wp::bit_and(var_13, var_14);
    // x = (x | x << int64(4)) & int64(1207822528635744451)                                   <L 7>
    var_16 = 4ll;
    var_17 = wp::lshift(var_15, var_16);
    var_18 = wp::bit_or(var_15, var_17);
    var_19 = 1207822528635744451ll;
    var_20 = wp::bit_and(var_18, var_19);
    // return (x | x << int64(2)) & int64(1317624576693539401)                                <L 8>
    var_21 = 2ll;
    var_22 = wp::lshift(var_20, var_21);
    var_23 = wp::bit_or(var_20, var_22);
    var_24 = 1317624576693539401ll;
    var_25 = wp::bit_and(var_23, var_24);
    return var_25;
}


// <pointloom.kernels.search.hilbert_order.hilbert_codes>:1
static CUDA_CALLABLE wp::vec_t<8, wp::int64> hilbert_codes_0(
    wp::vec_t<8, wp::int32> var_cx,
    wp::vec_t<8, wp::int32> var_cy,
    wp::vec_t<8, wp::int32> var_cz,
    wp::int32 var_levels)
{
    //---------
    // primal vars
    wp::vec_t<8, wp::int32> var_0;
    wp::vec_t<8, wp::int32> var_1;
    wp::vec_t<8, wp::int32> var_2;
    const wp::int32 var_3 = 1;
    wp::range_t var_4;
    wp::int32 var_5;
    wp::int32 var_6;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    const wp::int32 var_11 = 0;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::int32 var_14;
    const wp::int32 var_15 = 1;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::int32 var_20;
    wp::int32 var_21;
    const wp::int32 var_22 = 1;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::int32 var_26;
    wp::int32 var_27;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::int32 var_31;
    wp::int32 var_32;
    wp::int32 var_33;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::int32 var_36;
    wp::int32 var_37;
    wp::int32 var_38;
    const wp::int32 var_39 = 1;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::int32 var_42;
    wp::int32 var_43;
    wp::int32 var_44;
    wp::int32 var_45;
    wp::int32 var_46;
    wp::int32 var_47;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::int32 var_50;
    wp::int32 var_51;
    wp::int32 var_52;
    wp::int32 var_53;
    const wp::int32 var_54 = 1;
    wp::int32 var_55;
    wp::int32 var_56;
    wp::int32 var_57;
    const wp::int32 var_58 = 1;
    wp::int32 var_59;
    wp::int32 var_60;
    wp::int32 var_61;
    wp::int32 var_62;
    wp::int32 var_63;
    wp::int32 var_64;
    const wp::int32 var_65 = 1;
    wp::int32 var_66;
    wp::int32 var_67;
    wp::int32 var_68;
    wp::int32 var_69;
    wp::int32 var_70;
    wp::int32 var_71;
    wp::int32 var_72;
    wp::int32 var_73;
    wp::int32 var_74;
    wp::int32 var_75;
    wp::int32 var_76;
    wp::int32 var_77;
    wp::int32 var_78;
    wp::int32 var_79;
    wp::int32 var_80;
    wp::int32 var_81;
    const wp::int32 var_82 = 1;
    wp::int32 var_83;
    wp::int32 var_84;
    wp::int32 var_85;
    wp::int32 var_86;
    wp::int32 var_87;
    wp::int32 var_88;
    wp::int32 var_89;
    wp::int32 var_90;
    wp::int32 var_91;
    wp::int32 var_92;
    wp::int32 var_93;
    wp::int32 var_94;
    wp::int32 var_95;
    wp::int32 var_96;
    const wp::int32 var_97 = 2;
    wp::int32 var_98;
    wp::int32 var_99;
    wp::int32 var_100;
    const wp::int32 var_101 = 1;
    wp::int32 var_102;
    wp::int32 var_103;
    wp::int32 var_104;
    wp::int32 var_105;
    wp::int32 var_106;
    wp::int32 var_107;
    const wp::int32 var_108 = 1;
    wp::int32 var_109;
    wp::int32 var_110;
    wp::int32 var_111;
    wp::int32 var_112;
    wp::int32 var_113;
    wp::int32 var_114;
    wp::int32 var_115;
    wp::int32 var_116;
    wp::int32 var_117;
    wp::int32 var_118;
    wp::int32 var_119;
    wp::int32 var_120;
    wp::int32 var_121;
    wp::int32 var_122;
    wp::int32 var_123;
    wp::int32 var_124;
    const wp::int32 var_125 = 1;
    wp::int32 var_126;
    wp::int32 var_127;
    wp::int32 var_128;
    wp::int32 var_129;
    wp::int32 var_130;
    wp::int32 var_131;
    wp::int32 var_132;
    wp::int32 var_133;
    wp::int32 var_134;
    wp::int32 var_135;
    wp::int32 var_136;
    wp::int32 var_137;
    wp::int32 var_138;
    wp::int32 var_139;
    const wp::int32 var_140 = 3;
    wp::int32 var_141;
    wp::int32 var_142;
    wp::int32 var_143;
    const wp::int32 var_144 = 1;
    wp::int32 var_145;
    wp::int32 var_146;
    wp::int32 var_147;
    wp::int32 var_148;
    wp::int32 var_149;
    wp::int32 var_150;
    const wp::int32 var_151 = 1;
    wp::int32 var_152;
    wp::int32 var_153;
    wp::int32 var_154;
    wp::int32 var_155;
    wp::int32 var_156;
    wp::int32 var_157;
    wp::int32 var_158;
    wp::int32 var_159;
    wp::int32 var_160;
    wp::int32 var_161;
    wp::int32 var_162;
    wp::int32 var_163;
    wp::int32 var_164;
    wp::int32 var_165;
    wp::int32 var_166;
    wp::int32 var_167;
    const wp::int32 var_168 = 1;
    wp::int32 var_169;
    wp::int32 var_170;
    wp::int32 var_171;
    wp::int32 var_172;
    wp::int32 var_173;
    wp::int32 var_174;
    wp::int32 var_175;
    wp::int32 var_176;
    wp::int32 var_177;
    wp::int32 var_178;
    wp::int32 var_179;
    wp::int32 var_180;
    wp::int32 var_181;
    wp::int32 var_182;
    const wp::int32 var_183 = 4;
    wp::int32 var_184;
    wp::int32 var_185;
    wp::int32 var_186;
    const wp::int32 var_187 = 1;
    wp::int32 var_188;
    wp::int32 var_189;
    wp::int32 var_190;
    wp::int32 var_191;
    wp::int32 var_192;
    wp::int32 var_193;
    const wp::int32 var_194 = 1;
    wp::int32 var_195;
    wp::int32 var_196;
    wp::int32 var_197;
    wp::int32 var_198;
    wp::int32 var_199;
    wp::int32 var_200;
    wp::int32 var_201;
    wp::int32 var_202;
    wp::int32 var_203;
    wp::int32 var_204;
    wp::int32 var_205;
    wp::int32 var_206;
    wp::int32 var_207;
    wp::int32 var_208;
    wp::int32 var_209;
    wp::int32 var_210;
    const wp::int32 var_211 = 1;
    wp::int32 var_212;
    wp::int32 var_213;
    wp::int32 var_214;
    wp::int32 var_215;
    wp::int32 var_216;
    wp::int32 var_217;
    wp::int32 var_218;
    wp::int32 var_219;
    wp::int32 var_220;
    wp::int32 var_221;
    wp::int32 var_222;
    wp::int32 var_223;
    wp::int32 var_224;
    wp::int32 var_225;
    const wp::int32 var_226 = 5;
    wp::int32 var_227;
    wp::int32 var_228;
    wp::int32 var_229;
    const wp::int32 var_230 = 1;
    wp::int32 var_231;
    wp::int32 var_232;
    wp::int32 var_233;
    wp::int32 var_234;
    wp::int32 var_235;
    wp::int32 var_236;
    const wp::int32 var_237 = 1;
    wp::int32 var_238;
    wp::int32 var_239;
    wp::int32 var_240;
    wp::int32 var_241;
    wp::int32 var_242;
    wp::int32 var_243;
    wp::int32 var_244;
    wp::int32 var_245;
    wp::int32 var_246;
    wp::int32 var_247;
    wp::int32 var_248;
    wp::int32 var_249;
    wp::int32 var_250;
    wp::int32 var_251;
    wp::int32 var_252;
    wp::int32 var_253;
    const wp::int32 var_254 = 1;
    wp::int32 var_255;
    wp::int32 var_256;
    wp::int32 var_257;
    wp::int32 var_258;
    wp::int32 var_259;
    wp::int32 var_260;
    wp::int32 var_261;
    wp::int32 var_262;
    wp::int32 var_263;
    wp::int32 var_264;
    wp::int32 var_265;
    wp::int32 var_266;
    wp::int32 var_267;
    wp::int32 var_268;
    const wp::int32 var_269 = 6;
    wp::int32 var_270;
    wp::int32 var_271;
    wp::int32 var_272;
    const wp::int32 var_273 = 1;
    wp::int32 var_274;
    wp::int32 var_275;
    wp::int32 var_276;
    wp::int32 var_277;
    wp::int32 var_278;
    wp::int32 var_279;
    const wp::int32 var_280 = 1;
    wp::int32 var_281;
    wp::int32 var_282;
    wp::int32 var_283;
    wp::int32 var_284;
    wp::int32 var_285;
    wp::int32 var_286;
    wp::int32 var_287;
    wp::int32 var_288;
    wp::int32 var_289;
    wp::int32 var_290;
    wp::int32 var_291;
    wp::int32 var_292;
    wp::int32 var_293;
    wp::int32 var_294;
    wp::int32 var_295;
    wp::int32 var_296;
    const wp::int32 var_297 = 1;
    wp::int32 var_298;
    wp::int32 var_299;
    wp::int32 var_300;
    wp::int32 var_301;
    wp::int32 var_302;
    wp::int32 var_303;
    wp::int32 var_304;
    wp::int32 var_305;
    wp::int32 var_306;
    wp::int32 var_307;
    wp::int32 var_308;
    wp::int32 var_309;
    wp::int32 var_310;
    wp::int32 var_311;
    const wp::int32 var_312 = 7;
    wp::int32 var_313;
    wp::int32 var_314;
    wp::int32 var_315;
    const wp::int32 var_316 = 1;
    wp::int32 var_317;
    wp::int32 var_318;
    wp::int32 var_319;
    wp::int32 var_320;
    wp::int32 var_321;
    wp::int32 var_322;
    const wp::int32 var_323 = 1;
    wp::int32 var_324;
    wp::int32 var_325;
    wp::int32 var_326;
    wp::int32 var_327;
    wp::int32 var_328;
    wp::int32 var_329;
    wp::int32 var_330;
    wp::int32 var_331;
    wp::int32 var_332;
    wp::int32 var_333;
    wp::int32 var_334;
    wp::int32 var_335;
    wp::int32 var_336;
    wp::int32 var_337;
    wp::int32 var_338;
    wp::int32 var_339;
    const wp::int32 var_340 = 1;
    wp::int32 var_341;
    wp::int32 var_342;
    wp::int32 var_343;
    wp::int32 var_344;
    wp::int32 var_345;
    wp::int32 var_346;
    wp::int32 var_347;
    wp::int32 var_348;
    wp::int32 var_349;
    wp::int32 var_350;
    wp::int32 var_351;
    wp::int32 var_352;
    wp::int32 var_353;
    wp::int32 var_354;
    wp::int64 var_355;
    wp::vec_t<8, wp::int64> var_356;
    const wp::int32 var_357 = 0;
    wp::int32 var_358;
    wp::int32 var_359;
    wp::int32 var_360;
    wp::int32 var_361;
    wp::int32 var_362;
    wp::int32 var_363;
    wp::int32 var_364;
    wp::int32 var_365;
    const wp::int32 var_366 = 1;
    wp::int32 var_367;
    wp::int32 var_368;
    const wp::int32 var_369 = 2;
    wp::int32 var_370;
    wp::int32 var_371;
    const wp::int32 var_372 = 4;
    wp::int32 var_373;
    wp::int32 var_374;
    const wp::int32 var_375 = 8;
    wp::int32 var_376;
    wp::int32 var_377;
    const wp::int32 var_378 = 1;
    wp::int32 var_379;
    wp::int32 var_380;
    wp::int32 var_381;
    wp::int32 var_382;
    wp::int32 var_383;
    wp::int32 var_384;
    wp::int32 var_385;
    wp::int32 var_386;
    wp::int64 var_387;
    wp::int64 var_388;
    wp::int64 var_389;
    wp::int32 var_390;
    wp::int64 var_391;
    wp::int64 var_392;
    wp::int64 var_393;
    wp::int64 var_394;
    wp::int32 var_395;
    wp::int64 var_396;
    wp::int64 var_397;
    const wp::int32 var_398 = 1;
    wp::int32 var_399;
    wp::int32 var_400;
    wp::int32 var_401;
    wp::int32 var_402;
    wp::int32 var_403;
    wp::int32 var_404;
    wp::int32 var_405;
    wp::int32 var_406;
    const wp::int32 var_407 = 1;
    wp::int32 var_408;
    wp::int32 var_409;
    const wp::int32 var_410 = 2;
    wp::int32 var_411;
    wp::int32 var_412;
    const wp::int32 var_413 = 4;
    wp::int32 var_414;
    wp::int32 var_415;
    const wp::int32 var_416 = 8;
    wp::int32 var_417;
    wp::int32 var_418;
    const wp::int32 var_419 = 1;
    wp::int32 var_420;
    wp::int32 var_421;
    wp::int32 var_422;
    wp::int32 var_423;
    wp::int32 var_424;
    wp::int32 var_425;
    wp::int32 var_426;
    wp::int32 var_427;
    wp::int64 var_428;
    wp::int64 var_429;
    wp::int64 var_430;
    wp::int32 var_431;
    wp::int64 var_432;
    wp::int64 var_433;
    wp::int64 var_434;
    wp::int64 var_435;
    wp::int32 var_436;
    wp::int64 var_437;
    wp::int64 var_438;
    const wp::int32 var_439 = 2;
    wp::int32 var_440;
    wp::int32 var_441;
    wp::int32 var_442;
    wp::int32 var_443;
    wp::int32 var_444;
    wp::int32 var_445;
    wp::int32 var_446;
    wp::int32 var_447;
    const wp::int32 var_448 = 1;
    wp::int32 var_449;
    wp::int32 var_450;
    const wp::int32 var_451 = 2;
    wp::int32 var_452;
    wp::int32 var_453;
    const wp::int32 var_454 = 4;
    wp::int32 var_455;
    wp::int32 var_456;
    const wp::int32 var_457 = 8;
    wp::int32 var_458;
    wp::int32 var_459;
    const wp::int32 var_460 = 1;
    wp::int32 var_461;
    wp::int32 var_462;
    wp::int32 var_463;
    wp::int32 var_464;
    wp::int32 var_465;
    wp::int32 var_466;
    wp::int32 var_467;
    wp::int32 var_468;
    wp::int64 var_469;
    wp::int64 var_470;
    wp::int64 var_471;
    wp::int32 var_472;
    wp::int64 var_473;
    wp::int64 var_474;
    wp::int64 var_475;
    wp::int64 var_476;
    wp::int32 var_477;
    wp::int64 var_478;
    wp::int64 var_479;
    const wp::int32 var_480 = 3;
    wp::int32 var_481;
    wp::int32 var_482;
    wp::int32 var_483;
    wp::int32 var_484;
    wp::int32 var_485;
    wp::int32 var_486;
    wp::int32 var_487;
    wp::int32 var_488;
    const wp::int32 var_489 = 1;
    wp::int32 var_490;
    wp::int32 var_491;
    const wp::int32 var_492 = 2;
    wp::int32 var_493;
    wp::int32 var_494;
    const wp::int32 var_495 = 4;
    wp::int32 var_496;
    wp::int32 var_497;
    const wp::int32 var_498 = 8;
    wp::int32 var_499;
    wp::int32 var_500;
    const wp::int32 var_501 = 1;
    wp::int32 var_502;
    wp::int32 var_503;
    wp::int32 var_504;
    wp::int32 var_505;
    wp::int32 var_506;
    wp::int32 var_507;
    wp::int32 var_508;
    wp::int32 var_509;
    wp::int64 var_510;
    wp::int64 var_511;
    wp::int64 var_512;
    wp::int32 var_513;
    wp::int64 var_514;
    wp::int64 var_515;
    wp::int64 var_516;
    wp::int64 var_517;
    wp::int32 var_518;
    wp::int64 var_519;
    wp::int64 var_520;
    const wp::int32 var_521 = 4;
    wp::int32 var_522;
    wp::int32 var_523;
    wp::int32 var_524;
    wp::int32 var_525;
    wp::int32 var_526;
    wp::int32 var_527;
    wp::int32 var_528;
    wp::int32 var_529;
    const wp::int32 var_530 = 1;
    wp::int32 var_531;
    wp::int32 var_532;
    const wp::int32 var_533 = 2;
    wp::int32 var_534;
    wp::int32 var_535;
    const wp::int32 var_536 = 4;
    wp::int32 var_537;
    wp::int32 var_538;
    const wp::int32 var_539 = 8;
    wp::int32 var_540;
    wp::int32 var_541;
    const wp::int32 var_542 = 1;
    wp::int32 var_543;
    wp::int32 var_544;
    wp::int32 var_545;
    wp::int32 var_546;
    wp::int32 var_547;
    wp::int32 var_548;
    wp::int32 var_549;
    wp::int32 var_550;
    wp::int64 var_551;
    wp::int64 var_552;
    wp::int64 var_553;
    wp::int32 var_554;
    wp::int64 var_555;
    wp::int64 var_556;
    wp::int64 var_557;
    wp::int64 var_558;
    wp::int32 var_559;
    wp::int64 var_560;
    wp::int64 var_561;
    const wp::int32 var_562 = 5;
    wp::int32 var_563;
    wp::int32 var_564;
    wp::int32 var_565;
    wp::int32 var_566;
    wp::int32 var_567;
    wp::int32 var_568;
    wp::int32 var_569;
    wp::int32 var_570;
    const wp::int32 var_571 = 1;
    wp::int32 var_572;
    wp::int32 var_573;
    const wp::int32 var_574 = 2;
    wp::int32 var_575;
    wp::int32 var_576;
    const wp::int32 var_577 = 4;
    wp::int32 var_578;
    wp::int32 var_579;
    const wp::int32 var_580 = 8;
    wp::int32 var_581;
    wp::int32 var_582;
    const wp::int32 var_583 = 1;
    wp::int32 var_584;
    wp::int32 var_585;
    wp::int32 var_586;
    wp::int32 var_587;
    wp::int32 var_588;
    wp::int32 var_589;
    wp::int32 var_590;
    wp::int32 var_591;
    wp::int64 var_592;
    wp::int64 var_593;
    wp::int64 var_594;
    wp::int32 var_595;
    wp::int64 var_596;
    wp::int64 var_597;
    wp::int64 var_598;
    wp::int64 var_599;
    wp::int32 var_600;
    wp::int64 var_601;
    wp::int64 var_602;
    const wp::int32 var_603 = 6;
    wp::int32 var_604;
    wp::int32 var_605;
    wp::int32 var_606;
    wp::int32 var_607;
    wp::int32 var_608;
    wp::int32 var_609;
    wp::int32 var_610;
    wp::int32 var_611;
    const wp::int32 var_612 = 1;
    wp::int32 var_613;
    wp::int32 var_614;
    const wp::int32 var_615 = 2;
    wp::int32 var_616;
    wp::int32 var_617;
    const wp::int32 var_618 = 4;
    wp::int32 var_619;
    wp::int32 var_620;
    const wp::int32 var_621 = 8;
    wp::int32 var_622;
    wp::int32 var_623;
    const wp::int32 var_624 = 1;
    wp::int32 var_625;
    wp::int32 var_626;
    wp::int32 var_627;
    wp::int32 var_628;
    wp::int32 var_629;
    wp::int32 var_630;
    wp::int32 var_631;
    wp::int32 var_632;
    wp::int64 var_633;
    wp::int64 var_634;
    wp::int64 var_635;
    wp::int32 var_636;
    wp::int64 var_637;
    wp::int64 var_638;
    wp::int64 var_639;
    wp::int64 var_640;
    wp::int32 var_641;
    wp::int64 var_642;
    wp::int64 var_643;
    const wp::int32 var_644 = 7;
    wp::int32 var_645;
    wp::int32 var_646;
    wp::int32 var_647;
    wp::int32 var_648;
    wp::int32 var_649;
    wp::int32 var_650;
    wp::int32 var_651;
    wp::int32 var_652;
    const wp::int32 var_653 = 1;
    wp::int32 var_654;
    wp::int32 var_655;
    const wp::int32 var_656 = 2;
    wp::int32 var_657;
    wp::int32 var_658;
    const wp::int32 var_659 = 4;
    wp::int32 var_660;
    wp::int32 var_661;
    const wp::int32 var_662 = 8;
    wp::int32 var_663;
    wp::int32 var_664;
    const wp::int32 var_665 = 1;
    wp::int32 var_666;
    wp::int32 var_667;
    wp::int32 var_668;
    wp::int32 var_669;
    wp::int32 var_670;
    wp::int32 var_671;
    wp::int32 var_672;
    wp::int32 var_673;
    wp::int64 var_674;
    wp::int64 var_675;
    wp::int64 var_676;
    wp::int32 var_677;
    wp::int64 var_678;
    wp::int64 var_679;
    wp::int64 var_680;
    wp::int64 var_681;
    wp::int32 var_682;
    wp::int64 var_683;
    wp::int64 var_684;
    //---------
    // forward
    // def hilbert_codes(cx, cy, cz, levels):                                                 <L 1>
    // x = cx                                                                                 <L 3>
    var_0 = wp::copy(var_cx);
    // y = cy                                                                                 <L 4>
    var_1 = wp::copy(var_cy);
    // z = cz                                                                                 <L 5>
    var_2 = wp::copy(var_cz);
    // for level in range(1, levels):                                                         <L 6>
    var_4 = wp::range(var_3, var_levels);
    start_for_0:;
        if (iter_cmp(var_4) == 0) goto end_for_0;
        var_5 = wp::iter_next(var_4);
        // shift = levels - level                                                             <L 7>
        var_6 = wp::sub(var_levels, var_5);
        // low = (1 << shift) - 1                                                             <L 8>
        var_8 = wp::lshift(var_7, var_6);
        var_10 = wp::sub(var_8, var_9);
        // for j in range(LANES):                                                             <L 9>
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_12 = wp::extract(var_0, var_11);
        var_13 = wp::extract(var_0, var_11);
        var_14 = wp::rshift(var_13, var_6);
        var_16 = wp::bit_and(var_14, var_15);
        var_17 = wp::neg(var_16);
        var_18 = wp::bit_and(var_10, var_17);
        var_19 = wp::bit_xor(var_12, var_18);
        wp::assign_inplace(var_0, var_11, var_19);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_20 = wp::extract(var_1, var_11);
        var_21 = wp::rshift(var_20, var_6);
        var_23 = wp::bit_and(var_21, var_22);
        var_24 = wp::neg(var_23);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_25 = wp::extract(var_0, var_11);
        var_26 = wp::extract(var_1, var_11);
        var_27 = wp::bit_xor(var_25, var_26);
        var_28 = wp::bit_and(var_27, var_10);
        var_29 = wp::invert(var_24);
        var_30 = wp::bit_and(var_28, var_29);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_31 = wp::extract(var_0, var_11);
        var_32 = wp::bit_and(var_10, var_24);
        var_33 = wp::bit_or(var_32, var_30);
        var_34 = wp::bit_xor(var_31, var_33);
        wp::assign_inplace(var_0, var_11, var_34);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_35 = wp::extract(var_1, var_11);
        var_36 = wp::bit_xor(var_35, var_30);
        wp::assign_inplace(var_1, var_11, var_36);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_37 = wp::extract(var_2, var_11);
        var_38 = wp::rshift(var_37, var_6);
        var_40 = wp::bit_and(var_38, var_39);
        var_41 = wp::neg(var_40);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_42 = wp::extract(var_0, var_11);
        var_43 = wp::extract(var_2, var_11);
        var_44 = wp::bit_xor(var_42, var_43);
        var_45 = wp::bit_and(var_44, var_10);
        var_46 = wp::invert(var_41);
        var_47 = wp::bit_and(var_45, var_46);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_48 = wp::extract(var_0, var_11);
        var_49 = wp::bit_and(var_10, var_41);
        var_50 = wp::bit_or(var_49, var_47);
        var_51 = wp::bit_xor(var_48, var_50);
        wp::assign_inplace(var_0, var_11, var_51);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_52 = wp::extract(var_2, var_11);
        var_53 = wp::bit_xor(var_52, var_47);
        wp::assign_inplace(var_2, var_11, var_53);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_55 = wp::extract(var_0, var_54);
        var_56 = wp::extract(var_0, var_54);
        var_57 = wp::rshift(var_56, var_6);
        var_59 = wp::bit_and(var_57, var_58);
        var_60 = wp::neg(var_59);
        var_61 = wp::bit_and(var_10, var_60);
        var_62 = wp::bit_xor(var_55, var_61);
        wp::assign_inplace(var_0, var_54, var_62);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_63 = wp::extract(var_1, var_54);
        var_64 = wp::rshift(var_63, var_6);
        var_66 = wp::bit_and(var_64, var_65);
        var_67 = wp::neg(var_66);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_68 = wp::extract(var_0, var_54);
        var_69 = wp::extract(var_1, var_54);
        var_70 = wp::bit_xor(var_68, var_69);
        var_71 = wp::bit_and(var_70, var_10);
        var_72 = wp::invert(var_67);
        var_73 = wp::bit_and(var_71, var_72);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_74 = wp::extract(var_0, var_54);
        var_75 = wp::bit_and(var_10, var_67);
        var_76 = wp::bit_or(var_75, var_73);
        var_77 = wp::bit_xor(var_74, var_76);
        wp::assign_inplace(var_0, var_54, var_77);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_78 = wp::extract(var_1, var_54);
        var_79 = wp::bit_xor(var_78, var_73);
        wp::assign_inplace(var_1, var_54, var_79);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_80 = wp::extract(var_2, var_54);
        var_81 = wp::rshift(var_80, var_6);
        var_83 = wp::bit_and(var_81, var_82);
        var_84 = wp::neg(var_83);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_85 = wp::extract(var_0, var_54);
        var_86 = wp::extract(var_2, var_54);
        var_87 = wp::bit_xor(var_85, var_86);
        var_88 = wp::bit_and(var_87, var_10);
        var_89 = wp::invert(var_84);
        var_90 = wp::bit_and(var_88, var_89);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_91 = wp::extract(var_0, var_54);
        var_92 = wp::bit_and(var_10, var_84);
        var_93 = wp::bit_or(var_92, var_90);
        var_94 = wp::bit_xor(var_91, var_93);
        wp::assign_inplace(var_0, var_54, var_94);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_95 = wp::extract(var_2, var_54);
        var_96 = wp::bit_xor(var_95, var_90);
        wp::assign_inplace(var_2, var_54, var_96);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_98 = wp::extract(var_0, var_97);
        var_99 = wp::extract(var_0, var_97);
        var_100 = wp::rshift(var_99, var_6);
        var_102 = wp::bit_and(var_100, var_101);
        var_103 = wp::neg(var_102);
        var_104 = wp::bit_and(var_10, var_103);
        var_105 = wp::bit_xor(var_98, var_104);
        wp::assign_inplace(var_0, var_97, var_105);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_106 = wp::extract(var_1, var_97);
        var_107 = wp::rshift(var_106, var_6);
        var_109 = wp::bit_and(var_107, var_108);
        var_110 = wp::neg(var_109);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_111 = wp::extract(var_0, var_97);
        var_112 = wp::extract(var_1, var_97);
        var_113 = wp::bit_xor(var_111, var_112);
        var_114 = wp::bit_and(var_113, var_10);
        var_115 = wp::invert(var_110);
        var_116 = wp::bit_and(var_114, var_115);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_117 = wp::extract(var_0, var_97);
        var_118 = wp::bit_and(var_10, var_110);
        var_119 = wp::bit_or(var_118, var_116);
        var_120 = wp::bit_xor(var_117, var_119);
        wp::assign_inplace(var_0, var_97, var_120);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_121 = wp::extract(var_1, var_97);
        var_122 = wp::bit_xor(var_121, var_116);
        wp::assign_inplace(var_1, var_97, var_122);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_123 = wp::extract(var_2, var_97);
        var_124 = wp::rshift(var_123, var_6);
        var_126 = wp::bit_and(var_124, var_125);
        var_127 = wp::neg(var_126);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_128 = wp::extract(var_0, var_97);
        var_129 = wp::extract(var_2, var_97);
        var_130 = wp::bit_xor(var_128, var_129);
        var_131 = wp::bit_and(var_130, var_10);
        var_132 = wp::invert(var_127);
        var_133 = wp::bit_and(var_131, var_132);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_134 = wp::extract(var_0, var_97);
        var_135 = wp::bit_and(var_10, var_127);
        var_136 = wp::bit_or(var_135, var_133);
        var_137 = wp::bit_xor(var_134, var_136);
        wp::assign_inplace(var_0, var_97, var_137);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_138 = wp::extract(var_2, var_97);
        var_139 = wp::bit_xor(var_138, var_133);
        wp::assign_inplace(var_2, var_97, var_139);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_141 = wp::extract(var_0, var_140);
        var_142 = wp::extract(var_0, var_140);
        var_143 = wp::rshift(var_142, var_6);
        var_145 = wp::bit_and(var_143, var_144);
        var_146 = wp::neg(var_145);
        var_147 = wp::bit_and(var_10, var_146);
        var_148 = wp::bit_xor(var_141, var_147);
        wp::assign_inplace(var_0, var_140, var_148);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_149 = wp::extract(var_1, var_140);
        var_150 = wp::rshift(var_149, var_6);
        var_152 = wp::bit_and(var_150, var_151);
        var_153 = wp::neg(var_152);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_154 = wp::extract(var_0, var_140);
        var_155 = wp::extract(var_1, var_140);
        var_156 = wp::bit_xor(var_154, var_155);
        var_157 = wp::bit_and(var_156, var_10);
        var_158 = wp::invert(var_153);
        var_159 = wp::bit_and(var_157, var_158);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_160 = wp::extract(var_0, var_140);
        var_161 = wp::bit_and(var_10, var_153);
        var_162 = wp::bit_or(var_161, var_159);
        var_163 = wp::bit_xor(var_160, var_162);
        wp::assign_inplace(var_0, var_140, var_163);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_164 = wp::extract(var_1, var_140);
        var_165 = wp::bit_xor(var_164, var_159);
        wp::assign_inplace(var_1, var_140, var_165);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_166 = wp::extract(var_2, var_140);
        var_167 = wp::rshift(var_166, var_6);
        var_169 = wp::bit_and(var_167, var_168);
        var_170 = wp::neg(var_169);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_171 = wp::extract(var_0, var_140);
        var_172 = wp::extract(var_2, var_140);
        var_173 = wp::bit_xor(var_171, var_172);
        var_174 = wp::bit_and(var_173, var_10);
        var_175 = wp::invert(var_170);
        var_176 = wp::bit_and(var_174, var_175);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_177 = wp::extract(var_0, var_140);
        var_178 = wp::bit_and(var_10, var_170);
        var_179 = wp::bit_or(var_178, var_176);
        var_180 = wp::bit_xor(var_177, var_179);
        wp::assign_inplace(var_0, var_140, var_180);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_181 = wp::extract(var_2, var_140);
        var_182 = wp::bit_xor(var_181, var_176);
        wp::assign_inplace(var_2, var_140, var_182);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_184 = wp::extract(var_0, var_183);
        var_185 = wp::extract(var_0, var_183);
        var_186 = wp::rshift(var_185, var_6);
        var_188 = wp::bit_and(var_186, var_187);
        var_189 = wp::neg(var_188);
        var_190 = wp::bit_and(var_10, var_189);
        var_191 = wp::bit_xor(var_184, var_190);
        wp::assign_inplace(var_0, var_183, var_191);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_192 = wp::extract(var_1, var_183);
        var_193 = wp::rshift(var_192, var_6);
        var_195 = wp::bit_and(var_193, var_194);
        var_196 = wp::neg(var_195);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_197 = wp::extract(var_0, var_183);
        var_198 = wp::extract(var_1, var_183);
        var_199 = wp::bit_xor(var_197, var_198);
        var_200 = wp::bit_and(var_199, var_10);
        var_201 = wp::invert(var_196);
        var_202 = wp::bit_and(var_200, var_201);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_203 = wp::extract(var_0, var_183);
        var_204 = wp::bit_and(var_10, var_196);
        var_205 = wp::bit_or(var_204, var_202);
        var_206 = wp::bit_xor(var_203, var_205);
        wp::assign_inplace(var_0, var_183, var_206);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_207 = wp::extract(var_1, var_183);
        var_208 = wp::bit_xor(var_207, var_202);
        wp::assign_inplace(var_1, var_183, var_208);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_209 = wp::extract(var_2, var_183);
        var_210 = wp::rshift(var_209, var_6);
        var_212 = wp::bit_and(var_210, var_211);
        var_213 = wp::neg(var_212);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_214 = wp::extract(var_0, var_183);
        var_215 = wp::extract(var_2, var_183);
        var_216 = wp::bit_xor(var_214, var_215);
        var_217 = wp::bit_and(var_216, var_10);
        var_218 = wp::invert(var_213);
        var_219 = wp::bit_and(var_217, var_218);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_220 = wp::extract(var_0, var_183);
        var_221 = wp::bit_and(var_10, var_213);
        var_222 = wp::bit_or(var_221, var_219);
        var_223 = wp::bit_xor(var_220, var_222);
        wp::assign_inplace(var_0, var_183, var_223);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_224 = wp::extract(var_2, var_183);
        var_225 = wp::bit_xor(var_224, var_219);
        wp::assign_inplace(var_2, var_183, var_225);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_227 = wp::extract(var_0, var_226);
        var_228 = wp::extract(var_0, var_226);
        var_229 = wp::rshift(var_228, var_6);
        var_231 = wp::bit_and(var_229, var_230);
        var_232 = wp::neg(var_231);
        var_233 = wp::bit_and(var_10, var_232);
        var_234 = wp::bit_xor(var_227, var_233);
        wp::assign_inplace(var_0, var_226, var_234);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_235 = wp::extract(var_1, var_226);
        var_236 = wp::rshift(var_235, var_6);
        var_238 = wp::bit_and(var_236, var_237);
        var_239 = wp::neg(var_238);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_240 = wp::extract(var_0, var_226);
        var_241 = wp::extract(var_1, var_226);
        var_242 = wp::bit_xor(var_240, var_241);
        var_243 = wp::bit_and(var_242, var_10);
        var_244 = wp::invert(var_239);
        var_245 = wp::bit_and(var_243, var_244);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_246 = wp::extract(var_0, var_226);
        var_247 = wp::bit_and(var_10, var_239);
        var_248 = wp::bit_or(var_247, var_245);
        var_249 = wp::bit_xor(var_246, var_248);
        wp::assign_inplace(var_0, var_226, var_249);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_250 = wp::extract(var_1, var_226);
        var_251 = wp::bit_xor(var_250, var_245);
        wp::assign_inplace(var_1, var_226, var_251);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_252 = wp::extract(var_2, var_226);
        var_253 = wp::rshift(var_252, var_6);
        var_255 = wp::bit_and(var_253, var_254);
        var_256 = wp::neg(var_255);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_257 = wp::extract(var_0, var_226);
        var_258 = wp::extract(var_2, var_226);
        var_259 = wp::bit_xor(var_257, var_258);
        var_260 = wp::bit_and(var_259, var_10);
        var_261 = wp::invert(var_256);
        var_262 = wp::bit_and(var_260, var_261);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_263 = wp::extract(var_0, var_226);
        var_264 = wp::bit_and(var_10, var_256);
        var_265 = wp::bit_or(var_264, var_262);
        var_266 = wp::bit_xor(var_263, var_265);
        wp::assign_inplace(var_0, var_226, var_266);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_267 = wp::extract(var_2, var_226);
        var_268 = wp::bit_xor(var_267, var_262);
        wp::assign_inplace(var_2, var_226, var_268);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_270 = wp::extract(var_0, var_269);
        var_271 = wp::extract(var_0, var_269);
        var_272 = wp::rshift(var_271, var_6);
        var_274 = wp::bit_and(var_272, var_273);
        var_275 = wp::neg(var_274);
        var_276 = wp::bit_and(var_10, var_275);
        var_277 = wp::bit_xor(var_270, var_276);
        wp::assign_inplace(var_0, var_269, var_277);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_278 = wp::extract(var_1, var_269);
        var_279 = wp::rshift(var_278, var_6);
        var_281 = wp::bit_and(var_279, var_280);
        var_282 = wp::neg(var_281);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_283 = wp::extract(var_0, var_269);
        var_284 = wp::extract(var_1, var_269);
        var_285 = wp::bit_xor(var_283, var_284);
        var_286 = wp::bit_and(var_285, var_10);
        var_287 = wp::invert(var_282);
        var_288 = wp::bit_and(var_286, var_287);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_289 = wp::extract(var_0, var_269);
        var_290 = wp::bit_and(var_10, var_282);
        var_291 = wp::bit_or(var_290, var_288);
        var_292 = wp::bit_xor(var_289, var_291);
        wp::assign_inplace(var_0, var_269, var_292);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_293 = wp::extract(var_1, var_269);
        var_294 = wp::bit_xor(var_293, var_288);
        wp::assign_inplace(var_1, var_269, var_294);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_295 = wp::extract(var_2, var_269);
        var_296 = wp::rshift(var_295, var_6);
        var_298 = wp::bit_and(var_296, var_297);
        var_299 = wp::neg(var_298);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_300 = wp::extract(var_0, var_269);
        var_301 = wp::extract(var_2, var_269);
        var_302 = wp::bit_xor(var_300, var_301);
        var_303 = wp::bit_and(var_302, var_10);
        var_304 = wp::invert(var_299);
        var_305 = wp::bit_and(var_303, var_304);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_306 = wp::extract(var_0, var_269);
        var_307 = wp::bit_and(var_10, var_299);
        var_308 = wp::bit_or(var_307, var_305);
        var_309 = wp::bit_xor(var_306, var_308);
        wp::assign_inplace(var_0, var_269, var_309);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_310 = wp::extract(var_2, var_269);
        var_311 = wp::bit_xor(var_310, var_305);
        wp::assign_inplace(var_2, var_269, var_311);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_313 = wp::extract(var_0, var_312);
        var_314 = wp::extract(var_0, var_312);
        var_315 = wp::rshift(var_314, var_6);
        var_317 = wp::bit_and(var_315, var_316);
        var_318 = wp::neg(var_317);
        var_319 = wp::bit_and(var_10, var_318);
        var_320 = wp::bit_xor(var_313, var_319);
        wp::assign_inplace(var_0, var_312, var_320);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_321 = wp::extract(var_1, var_312);
        var_322 = wp::rshift(var_321, var_6);
        var_324 = wp::bit_and(var_322, var_323);
        var_325 = wp::neg(var_324);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_326 = wp::extract(var_0, var_312);
        var_327 = wp::extract(var_1, var_312);
        var_328 = wp::bit_xor(var_326, var_327);
        var_329 = wp::bit_and(var_328, var_10);
        var_330 = wp::invert(var_325);
        var_331 = wp::bit_and(var_329, var_330);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_332 = wp::extract(var_0, var_312);
        var_333 = wp::bit_and(var_10, var_325);
        var_334 = wp::bit_or(var_333, var_331);
        var_335 = wp::bit_xor(var_332, var_334);
        wp::assign_inplace(var_0, var_312, var_335);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_336 = wp::extract(var_1, var_312);
        var_337 = wp::bit_xor(var_336, var_331);
        wp::assign_inplace(var_1, var_312, var_337);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_338 = wp::extract(var_2, var_312);
        var_339 = wp::rshift(var_338, var_6);
        var_341 = wp::bit_and(var_339, var_340);
        var_342 = wp::neg(var_341);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_343 = wp::extract(var_0, var_312);
        var_344 = wp::extract(var_2, var_312);
        var_345 = wp::bit_xor(var_343, var_344);
        var_346 = wp::bit_and(var_345, var_10);
        var_347 = wp::invert(var_342);
        var_348 = wp::bit_and(var_346, var_347);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_349 = wp::extract(var_0, var_312);
        var_350 = wp::bit_and(var_10, var_342);
        var_351 = wp::bit_or(var_350, var_348);
        var_352 = wp::bit_xor(var_349, var_351);
        wp::assign_inplace(var_0, var_312, var_352);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_353 = wp::extract(var_2, var_312);
        var_354 = wp::bit_xor(var_353, var_348);
        wp::assign_inplace(var_2, var_312, var_354);
        goto start_for_0;
    end_for_0:;
    // codes = lane_codes(int64(0))                                                           <L 19>
    var_355 = 0ll;
    var_356 = wp::vec_t<8, wp::int64>(var_355);
    // for j in range(LANES):                                                                 <L 20>
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_358 = wp::extract(var_1, var_357);
    var_359 = wp::extract(var_0, var_357);
    var_360 = wp::bit_xor(var_358, var_359);
    wp::assign_inplace(var_1, var_357, var_360);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_361 = wp::extract(var_2, var_357);
    var_362 = wp::extract(var_1, var_357);
    var_363 = wp::bit_xor(var_361, var_362);
    wp::assign_inplace(var_2, var_357, var_363);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_364 = wp::extract(var_2, var_357);
    var_365 = wp::extract(var_2, var_357);
    var_367 = wp::rshift(var_365, var_366);
    var_368 = wp::bit_xor(var_364, var_367);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_370 = wp::rshift(var_368, var_369);
    var_371 = wp::bit_xor(var_368, var_370);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_373 = wp::rshift(var_371, var_372);
    var_374 = wp::bit_xor(var_371, var_373);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_376 = wp::rshift(var_374, var_375);
    var_377 = wp::bit_xor(var_374, var_376);
    var_379 = wp::rshift(var_377, var_378);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_380 = wp::extract(var_0, var_357);
    var_381 = wp::bit_xor(var_380, var_379);
    wp::assign_inplace(var_0, var_357, var_381);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_382 = wp::extract(var_1, var_357);
    var_383 = wp::bit_xor(var_382, var_379);
    wp::assign_inplace(var_1, var_357, var_383);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_384 = wp::extract(var_2, var_357);
    var_385 = wp::bit_xor(var_384, var_379);
    wp::assign_inplace(var_2, var_357, var_385);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_386 = wp::extract(var_0, var_357);
    var_387 = spread_bits_0(var_386);
    var_388 = 2ll;
    var_389 = wp::lshift(var_387, var_388);
    var_390 = wp::extract(var_1, var_357);
    var_391 = spread_bits_0(var_390);
    var_392 = 1ll;
    var_393 = wp::lshift(var_391, var_392);
    var_394 = wp::bit_or(var_389, var_393);
    var_395 = wp::extract(var_2, var_357);
    var_396 = spread_bits_0(var_395);
    var_397 = wp::bit_or(var_394, var_396);
    wp::assign_inplace(var_356, var_357, var_397);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_399 = wp::extract(var_1, var_398);
    var_400 = wp::extract(var_0, var_398);
    var_401 = wp::bit_xor(var_399, var_400);
    wp::assign_inplace(var_1, var_398, var_401);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_402 = wp::extract(var_2, var_398);
    var_403 = wp::extract(var_1, var_398);
    var_404 = wp::bit_xor(var_402, var_403);
    wp::assign_inplace(var_2, var_398, var_404);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_405 = wp::extract(var_2, var_398);
    var_406 = wp::extract(var_2, var_398);
    var_408 = wp::rshift(var_406, var_407);
    var_409 = wp::bit_xor(var_405, var_408);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_411 = wp::rshift(var_409, var_410);
    var_412 = wp::bit_xor(var_409, var_411);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_414 = wp::rshift(var_412, var_413);
    var_415 = wp::bit_xor(var_412, var_414);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_417 = wp::rshift(var_415, var_416);
    var_418 = wp::bit_xor(var_415, var_417);
    var_420 = wp::rshift(var_418, var_419);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_421 = wp::extract(var_0, var_398);
    var_422 = wp::bit_xor(var_421, var_420);
    wp::assign_inplace(var_0, var_398, var_422);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_423 = wp::extract(var_1, var_398);
    var_424 = wp::bit_xor(var_423, var_420);
    wp::assign_inplace(var_1, var_398, var_424);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_425 = wp::extract(var_2, var_398);
    var_426 = wp::bit_xor(var_425, var_420);
    wp::assign_inplace(var_2, var_398, var_426);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_427 = wp::extract(var_0, var_398);
    var_428 = spread_bits_0(var_427);
    var_429 = 2ll;
    var_430 = wp::lshift(var_428, var_429);
    var_431 = wp::extract(var_1, var_398);
    var_432 = spread_bits_0(var_431);
    var_433 = 1ll;
    var_434 = wp::lshift(var_432, var_433);
    var_435 = wp::bit_or(var_430, var_434);
    var_436 = wp::extract(var_2, var_398);
    var_437 = spread_bits_0(var_436);
    var_438 = wp::bit_or(var_435, var_437);
    wp::assign_inplace(var_356, var_398, var_438);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_440 = wp::extract(var_1, var_439);
    var_441 = wp::extract(var_0, var_439);
    var_442 = wp::bit_xor(var_440, var_441);
    wp::assign_inplace(var_1, var_439, var_442);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_443 = wp::extract(var_2, var_439);
    var_444 = wp::extract(var_1, var_439);
    var_445 = wp::bit_xor(var_443, var_444);
    wp::assign_inplace(var_2, var_439, var_445);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_446 = wp::extract(var_2, var_439);
    var_447 = wp::extract(var_2, var_439);
    var_449 = wp::rshift(var_447, var_448);
    var_450 = wp::bit_xor(var_446, var_449);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_452 = wp::rshift(var_450, var_451);
    var_453 = wp::bit_xor(var_450, var_452);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_455 = wp::rshift(var_453, var_454);
    var_456 = wp::bit_xor(var_453, var_455);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_458 = wp::rshift(var_456, var_457);
    var_459 = wp::bit_xor(var_456, var_458);
    var_461 = wp::rshift(var_459, var_460);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_462 = wp::extract(var_0, var_439);
    var_463 = wp::bit_xor(var_462, var_461);
    wp::assign_inplace(var_0, var_439, var_463);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_464 = wp::extract(var_1, var_439);
    var_465 = wp::bit_xor(var_464, var_461);
    wp::assign_inplace(var_1, var_439, var_465);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_466 = wp::extract(var_2, var_439);
    var_467 = wp::bit_xor(var_466, var_461);
    wp::assign_inplace(var_2, var_439, var_467);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_468 = wp::extract(var_0, var_439);
    var_469 = spread_bits_0(var_468);
    var_470 = 2ll;
    var_471 = wp::lshift(var_469, var_470);
    var_472 = wp::extract(var_1, var_439);
    var_473 = spread_bits_0(var_472);
    var_474 = 1ll;
    var_475 = wp::lshift(var_473, var_474);
    var_476 = wp::bit_or(var_471, var_475);
    var_477 = wp::extract(var_2, var_439);
    var_478 = spread_bits_0(var_477);
    var_479 = wp::bit_or(var_476, var_478);
    wp::assign_inplace(var_356, var_439, var_479);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_481 = wp::extract(var_1, var_480);
    var_482 = wp::extract(var_0, var_480);
    var_483 = wp::bit_xor(var_481, var_482);
    wp::assign_inplace(var_1, var_480, var_483);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_484 = wp::extract(var_2, var_480);
    var_485 = wp::extract(var_1, var_480);
    var_486 = wp::bit_xor(var_484, var_485);
    wp::assign_inplace(var_2, var_480, var_486);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_487 = wp::extract(var_2, var_480);
    var_488 = wp::extract(var_2, var_480);
    var_490 = wp::rshift(var_488, var_489);
    var_491 = wp::bit_xor(var_487, var_490);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_493 = wp::rshift(var_491, var_492);
    var_494 = wp::bit_xor(var_491, var_493);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_496 = wp::rshift(var_494, var_495);
    var_497 = wp::bit_xor(var_494, var_496);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_499 = wp::rshift(var_497, var_498);
    var_500 = wp::bit_xor(var_497, var_499);
    var_502 = wp::rshift(var_500, var_501);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_503 = wp::extract(var_0, var_480);
    var_504 = wp::bit_xor(var_503, var_502);
    wp::assign_inplace(var_0, var_480, var_504);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_505 = wp::extract(var_1, var_480);
    var_506 = wp::bit_xor(var_505, var_502);
    wp::assign_inplace(var_1, var_480, var_506);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_507 = wp::extract(var_2, var_480);
    var_508 = wp::bit_xor(var_507, var_502);
    wp::assign_inplace(var_2, var_480, var_508);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_509 = wp::extract(var_0, var_480);
    var_510 = spread_bits_0(var_509);
    var_511 = 2ll;
    var_512 = wp::lshift(var_510, var_511);
    var_513 = wp::extract(var_1, var_480);
    var_514 = spread_bits_0(var_513);
    var_515 = 1ll;
    var_516 = wp::lshift(var_514, var_515);
    var_517 = wp::bit_or(var_512, var_516);
    var_518 = wp::extract(var_2, var_480);
    var_519 = spread_bits_0(var_518);
    var_520 = wp::bit_or(var_517, var_519);
    wp::assign_inplace(var_356, var_480, var_520);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_522 = wp::extract(var_1, var_521);
    var_523 = wp::extract(var_0, var_521);
    var_524 = wp::bit_xor(var_522, var_523);
    wp::assign_inplace(var_1, var_521, var_524);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_525 = wp::extract(var_2, var_521);
    var_526 = wp::extract(var_1, var_521);
    var_527 = wp::bit_xor(var_525, var_526);
    wp::assign_inplace(var_2, var_521, var_527);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_528 = wp::extract(var_2, var_521);
    var_529 = wp::extract(var_2, var_521);
    var_531 = wp::rshift(var_529, var_530);
    var_532 = wp::bit_xor(var_528, var_531);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_534 = wp::rshift(var_532, var_533);
    var_535 = wp::bit_xor(var_532, var_534);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_537 = wp::rshift(var_535, var_536);
    var_538 = wp::bit_xor(var_535, var_537);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_540 = wp::rshift(var_538, var_539);
    var_541 = wp::bit_xor(var_538, var_540);
    var_543 = wp::rshift(var_541, var_542);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_544 = wp::extract(var_0, var_521);
    var_545 = wp::bit_xor(var_544, var_543);
    wp::assign_inplace(var_0, var_521, var_545);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_546 = wp::extract(var_1, var_521);
    var_547 = wp::bit_xor(var_546, var_543);
    wp::assign_inplace(var_1, var_521, var_547);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_548 = wp::extract(var_2, var_521);
    var_549 = wp::bit_xor(var_548, var_543);
    wp::assign_inplace(var_2, var_521, var_549);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_550 = wp::extract(var_0, var_521);
    var_551 = spread_bits_0(var_550);
    var_552 = 2ll;
    var_553 = wp::lshift(var_551, var_552);
    var_554 = wp::extract(var_1, var_521);
    var_555 = spread_bits_0(var_554);
    var_556 = 1ll;
    var_557 = wp::lshift(var_555, var_556);
    var_558 = wp::bit_or(var_553, var_557);
    var_559 = wp::extract(var_2, var_521);
    var_560 = spread_bits_0(var_559);
    var_561 = wp::bit_or(var_558, var_560);
    wp::assign_inplace(var_356, var_521, var_561);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_563 = wp::extract(var_1, var_562);
    var_564 = wp::extract(var_0, var_562);
    var_565 = wp::bit_xor(var_563, var_564);
    wp::assign_inplace(var_1, var_562, var_565);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_566 = wp::extract(var_2, var_562);
    var_567 = wp::extract(var_1, var_562);
    var_568 = wp::bit_xor(var_566, var_567);
    wp::assign_inplace(var_2, var_562, var_568);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_569 = wp::extract(var_2, var_562);
    var_570 = wp::extract(var_2, var_562);
    var_572 = wp::rshift(var_570, var_571);
    var_573 = wp::bit_xor(var_569, var_572);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_575 = wp::rshift(var_573, var_574);
    var_576 = wp::bit_xor(var_573, var_575);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_578 = wp::rshift(var_576, var_577);
    var_579 = wp::bit_xor(var_576, var_578);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_581 = wp::rshift(var_579, var_580);
    var_582 = wp::bit_xor(var_579, var_581);
    var_584 = wp::rshift(var_582, var_583);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_585 = wp::extract(var_0, var_562);
    var_586 = wp::bit_xor(var_585, var_584);
    wp::assign_inplace(var_0, var_562, var_586);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_587 = wp::extract(var_1, var_562);
    var_588 = wp::bit_xor(var_587, var_584);
    wp::assign_inplace(var_1, var_562, var_588);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_589 = wp::extract(var_2, var_562);
    var_590 = wp::bit_xor(var_589, var_584);
    wp::assign_inplace(var_2, var_562, var_590);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_591 = wp::extract(var_0, var_562);
    var_592 = spread_bits_0(var_591);
    var_593 = 2ll;
    var_594 = wp::lshift(var_592, var_593);
    var_595 = wp::extract(var_1, var_562);
    var_596 = spread_bits_0(var_595);
    var_597 = 1ll;
    var_598 = wp::lshift(var_596, var_597);
    var_599 = wp::bit_or(var_594, var_598);
    var_600 = wp::extract(var_2, var_562);
    var_601 = spread_bits_0(var_600);
    var_602 = wp::bit_or(var_599, var_601);
    wp::assign_inplace(var_356, var_562, var_602);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_604 = wp::extract(var_1, var_603);
    var_605 = wp::extract(var_0, var_603);
    var_606 = wp::bit_xor(var_604, var_605);
    wp::assign_inplace(var_1, var_603, var_606);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_607 = wp::extract(var_2, var_603);
    var_608 = wp::extract(var_1, var_603);
    var_609 = wp::bit_xor(var_607, var_608);
    wp::assign_inplace(var_2, var_603, var_609);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_610 = wp::extract(var_2, var_603);
    var_611 = wp::extract(var_2, var_603);
    var_613 = wp::rshift(var_611, var_612);
    var_614 = wp::bit_xor(var_610, var_613);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_616 = wp::rshift(var_614, var_615);
    var_617 = wp::bit_xor(var_614, var_616);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_619 = wp::rshift(var_617, var_618);
    var_620 = wp::bit_xor(var_617, var_619);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_622 = wp::rshift(var_620, var_621);
    var_623 = wp::bit_xor(var_620, var_622);
    var_625 = wp::rshift(var_623, var_624);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_626 = wp::extract(var_0, var_603);
    var_627 = wp::bit_xor(var_626, var_625);
    wp::assign_inplace(var_0, var_603, var_627);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_628 = wp::extract(var_1, var_603);
    var_629 = wp::bit_xor(var_628, var_625);
    wp::assign_inplace(var_1, var_603, var_629);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_630 = wp::extract(var_2, var_603);
    var_631 = wp::bit_xor(var_630, var_625);
    wp::assign_inplace(var_2, var_603, var_631);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_632 = wp::extract(var_0, var_603);
    var_633 = spread_bits_0(var_632);
    var_634 = 2ll;
    var_635 = wp::lshift(var_633, var_634);
    var_636 = wp::extract(var_1, var_603);
    var_637 = spread_bits_0(var_636);
    var_638 = 1ll;
    var_639 = wp::lshift(var_637, var_638);
    var_640 = wp::bit_or(var_635, var_639);
    var_641 = wp::extract(var_2, var_603);
    var_642 = spread_bits_0(var_641);
    var_643 = wp::bit_or(var_640, var_642);
    wp::assign_inplace(var_356, var_603, var_643);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_645 = wp::extract(var_1, var_644);
    var_646 = wp::extract(var_0, var_644);
    var_647 = wp::bit_xor(var_645, var_646);
    wp::assign_inplace(var_1, var_644, var_647);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_648 = wp::extract(var_2, var_644);
    var_649 = wp::extract(var_1, var_644);
    var_650 = wp::bit_xor(var_648, var_649);
    wp::assign_inplace(var_2, var_644, var_650);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_651 = wp::extract(var_2, var_644);
    var_652 = wp::extract(var_2, var_644);
    var_654 = wp::rshift(var_652, var_653);
    var_655 = wp::bit_xor(var_651, var_654);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_657 = wp::rshift(var_655, var_656);
    var_658 = wp::bit_xor(var_655, var_657);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_660 = wp::rshift(var_658, var_659);
    var_661 = wp::bit_xor(var_658, var_660);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_663 = wp::rshift(var_661, var_662);
    var_664 = wp::bit_xor(var_661, var_663);
    var_666 = wp::rshift(var_664, var_665);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_667 = wp::extract(var_0, var_644);
    var_668 = wp::bit_xor(var_667, var_666);
    wp::assign_inplace(var_0, var_644, var_668);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_669 = wp::extract(var_1, var_644);
    var_670 = wp::bit_xor(var_669, var_666);
    wp::assign_inplace(var_1, var_644, var_670);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_671 = wp::extract(var_2, var_644);
    var_672 = wp::bit_xor(var_671, var_666);
    wp::assign_inplace(var_2, var_644, var_672);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_673 = wp::extract(var_0, var_644);
    var_674 = spread_bits_0(var_673);
    var_675 = 2ll;
    var_676 = wp::lshift(var_674, var_675);
    var_677 = wp::extract(var_1, var_644);
    var_678 = spread_bits_0(var_677);
    var_679 = 1ll;
    var_680 = wp::lshift(var_678, var_679);
    var_681 = wp::bit_or(var_676, var_680);
    var_682 = wp::extract(var_2, var_644);
    var_683 = spread_bits_0(var_682);
    var_684 = wp::bit_or(var_681, var_683);
    wp::assign_inplace(var_356, var_644, var_684);
    // return codes                                                                           <L 31>
    return var_356;
}


// <pointloom.kernels.search.hilbert_order.locate_on_curve>:1
static CUDA_CALLABLE wp::int64 locate_on_curve_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_curve__low,
    wp::float32 var_curve__scale,
    wp::int32 var_curve__levels)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    wp::int32 var_4;
    wp::vec_t<8, wp::int32> var_5;
    const wp::int32 var_6 = 1;
    wp::float32 var_7;
    const wp::int32 var_8 = 1;
    wp::float32 var_9;
    wp::int32 var_10;
    wp::vec_t<8, wp::int32> var_11;
    const wp::int32 var_12 = 2;
    wp::float32 var_13;
    const wp::int32 var_14 = 2;
    wp::float32 var_15;
    wp::int32 var_16;
    wp::vec_t<8, wp::int32> var_17;
    wp::vec_t<8, wp::int64> var_18;
    const wp::int32 var_19 = 0;
    wp::int64 var_20;
    //---------
    // forward
    // def locate_on_curve(p, curve__low, curve__scale, curve__levels):                       <L 1>
    // x = lanes(cell_on_axis(p[0], curve__low[0], curve__scale, curve__levels))              <L 3>
    var_1 = wp::extract(var_p, var_0);
    var_3 = wp::extract(var_curve__low, var_2);
    var_4 = cell_on_axis_0(var_1, var_3, var_curve__scale, var_curve__levels);
    var_5 = wp::vec_t<8, wp::int32>(var_4);
    // y = lanes(cell_on_axis(p[1], curve__low[1], curve__scale, curve__levels))              <L 4>
    var_7 = wp::extract(var_p, var_6);
    var_9 = wp::extract(var_curve__low, var_8);
    var_10 = cell_on_axis_0(var_7, var_9, var_curve__scale, var_curve__levels);
    var_11 = wp::vec_t<8, wp::int32>(var_10);
    // z = lanes(cell_on_axis(p[2], curve__low[2], curve__scale, curve__levels))              <L 5>
    var_13 = wp::extract(var_p, var_12);
    var_15 = wp::extract(var_curve__low, var_14);
    var_16 = cell_on_axis_0(var_13, var_15, var_curve__scale, var_curve__levels);
    var_17 = wp::vec_t<8, wp::int32>(var_16);
    // codes = hilbert_codes(x, y, z, curve__levels)                                          <L 6>
    var_18 = hilbert_codes_0(var_5, var_11, var_17, var_curve__levels);
    // return codes[0]                                                                        <L 7>
    var_20 = wp::extract(var_18, var_19);
    return var_20;
}


// <pointloom.kernels.search.point_tree.find_run>:1
static CUDA_CALLABLE wp::int32 find_run_0(
    wp::array_t<wp::int64> var_codes,
    wp::int32 var_first,
    wp::int32 var_count,
    wp::int64 var_code)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    wp::int32 var_2;
    wp::int32 var_3;
    const wp::int32 var_4 = 1;
    bool var_5;
    wp::int32 var_6;
    const wp::int32 var_7 = 2;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::int64* var_10;
    bool var_11;
    wp::int64 var_12;
    wp::int32 var_13;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    //---------
    // forward
    // def find_run(codes, first, count, code):                                               <L 1>
    // a = int(0)                                                                             <L 3>
    var_1 = wp::int(var_0);
    // b = count                                                                              <L 4>
    var_2 = wp::copy(var_count);
    // while b - a > 1:                                                                       <L 5>
    start_while_0:;
    var_3 = wp::sub(var_2, var_1);
    var_5 = (var_3 > var_4);
    if ((var_5) == false) goto end_while_0;
        // middle = (a + b) // 2                                                              <L 6>
        var_6 = wp::add(var_1, var_2);
        var_8 = wp::floordiv(var_6, var_7);
        // if codes[first + middle] <= code:                                                  <L 7>
        var_9 = wp::add(var_first, var_8);
        var_10 = wp::address(var_codes, var_9);
        var_12 = wp::load(var_10);
        var_11 = (var_12 <= var_code);
        if (var_11) {
            // a = middle                                                                     <L 8>
            var_13 = wp::copy(var_8);
        }
        if (!var_11) {
            // b = middle                                                                     <L 10>
            var_14 = wp::copy(var_8);
        }
        var_15 = wp::where(var_11, var_13, var_1);
        var_16 = wp::where(var_11, var_2, var_14);
        wp::assign(var_1, var_15);
        wp::assign(var_2, var_16);
    goto start_while_0;
    end_while_0:;
    // return a                                                                               <L 11>
    return var_1;
}


// <pointloom.kernels.search.point_forest.find_bucket_of>:1
static CUDA_CALLABLE wp::int32 find_bucket_of_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_tree,
    wp::array_t<wp::int64> var_forest__clouds__codes,
    wp::vec_t<3, wp::float32> var_forest__clouds__curve__low,
    wp::float32 var_forest__clouds__curve__scale,
    wp::int32 var_forest__clouds__curve__levels,
    wp::array_t<wp::int32> var_forest__bucket_counts,
    wp::array_t<wp::int32> var_forest__levels)
{
    //---------
    // primal vars
    wp::int64 var_0;
    const wp::int32 var_1 = 12;
    wp::int32 var_2;
    wp::int32* var_3;
    wp::int32* var_4;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::int32 var_7;
    //---------
    // forward
    // def find_bucket_of(p, tree, forest__clouds__codes, forest__clouds__curve__low, forest__clouds__curve__scale, forest__clouds__curve__levels, forest__bucket_counts, forest__levels):       <L 1>
    // code = locate_on_curve(p, forest__clouds__curve__low, forest__clouds__curve__scale, forest__clouds__curve__levels)       <L 3>
    var_0 = locate_on_curve_0(var_p, var_forest__clouds__curve__low, var_forest__clouds__curve__scale, var_forest__clouds__curve__levels);
    // return find_run(forest__clouds__codes, forest__levels[tree * HEIGHTS], forest__bucket_counts[tree], code)       <L 4>
    var_2 = wp::mul(var_tree, var_1);
    var_3 = wp::address(var_forest__levels, var_2);
    var_4 = wp::address(var_forest__bucket_counts, var_tree);
    var_6 = wp::load(var_3);
    var_7 = wp::load(var_4);
    var_5 = find_run_0(var_forest__clouds__codes, var_6, var_7, var_0);
    return var_5;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:158
static CUDA_CALLABLE wp::int32 _ballot_0(
    wp::int32 flag)
{
return (int)__ballot_sync(0xffffffffu, flag != 0);}


// /work/main/src/pointloom/kernels/search/tree_walk.py:20
static CUDA_CALLABLE wp::int32 lowest_bit_0(
    wp::int32 var_bits)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::int32 var_4;
    //---------
    // forward
    // def lowest_bit(bits: int) -> int:                                                      <L 21>
    // return bit_count((bits & (-bits)) - 1)                                                 <L 22>
    var_0 = wp::neg(var_bits);
    var_1 = wp::bit_and(var_bits, var_0);
    var_3 = wp::sub(var_1, var_2);
    var_4 = wp::bit_count(var_3);
    return var_4;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:162
static CUDA_CALLABLE wp::int32 _shuffle_0(
    wp::int32 x,
    wp::int32 lane)
{
return __shfl_sync(0xffffffffu, x, lane);}


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


// /work/main/src/pointloom/kernels/algebra/plain_min_max.py:6
static CUDA_CALLABLE wp::float32 smaller_0(
    wp::float32 var_a,
    wp::float32 var_b)
{
    //---------
    // primal vars
    bool var_0;
    wp::float32 var_1;
    //---------
    // forward
    // def smaller(a: float, b: float) -> float:                                              <L 7>
    // return a if a < b else b                                                               <L 8>
    var_0 = (var_a < var_b);
    if (var_0) {
    }
    if (!var_0) {
    }
    var_1 = wp::where(var_0, var_a, var_b);
    return var_1;
}


// /work/main/src/pointloom/kernels/icp/correspondences.py:98
static CUDA_CALLABLE wp::float32 limit_beside_0(
    wp::int32 var_best,
    wp::int32 var_second,
    wp::float32 var_margin)
{
    //---------
    // primal vars
    wp::float32 var_0;
    wp::float32 var_1;
    wp::float32 var_2;
    wp::float32 var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    wp::float32 var_6;
    //---------
    // forward
    // def limit_beside(best: int, second: int, margin: float) -> float:                      <L 99>
    // nearest = bits_float(best)                                                             <L 100>
    var_0 = _bits_float_0(var_best);
    // look = sqrt(nearest) + margin                                                          <L 101>
    var_1 = wp::sqrt(var_0);
    var_2 = wp::add(var_1, var_margin);
    // return smaller(larger(look * look, nearest), bits_float(second))                       <L 102>
    var_3 = wp::mul(var_2, var_2);
    var_4 = larger_0(var_3, var_0);
    var_5 = _bits_float_0(var_second);
    var_6 = smaller_0(var_4, var_5);
    return var_6;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:154
static CUDA_CALLABLE wp::int32 _lane_0(
    )
{
return (int)(threadIdx.x & 31u);}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:166
static CUDA_CALLABLE wp::float32 _shuffle_1(
    wp::float32 x,
    wp::int32 lane)
{
return __shfl_sync(0xffffffffu, x, lane);}


// /work/main/src/pointloom/kernels/search/lane_search.py:50
static CUDA_CALLABLE wp::vec_t<3, wp::float32> point_of_lane_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_owner)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 1;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 2;
    wp::float32 var_7;
    wp::float32 var_8;
    wp::vec_t<3, wp::float32> var_9;
    //---------
    // forward
    // def point_of_lane(p: vec3, owner: int) -> vec3:                                        <L 51>
    // return vec3(shuffle(p[0], owner), shuffle(p[1], owner), shuffle(p[2], owner))          <L 52>
    var_1 = wp::extract(var_p, var_0);
    var_2 = _shuffle_1(var_1, var_owner);
    var_4 = wp::extract(var_p, var_3);
    var_5 = _shuffle_1(var_4, var_owner);
    var_7 = wp::extract(var_p, var_6);
    var_8 = _shuffle_1(var_7, var_owner);
    var_9 = wp::vec_t<3, wp::float32>(var_2, var_5, var_8);
    return var_9;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:178
static CUDA_CALLABLE wp::float32 _shuffle_xor_1(
    wp::float32 x,
    wp::int32 mask)
{
return __shfl_xor_sync(0xffffffffu, x, mask);}


// /work/main/src/pointloom/kernels/arrays/lanes.py:52
static CUDA_CALLABLE wp::float32 max_of_eight_on_cuda_0(
    wp::float32 var_x)
{
    //---------
    // primal vars
    wp::float32 var_0;
    const wp::int32 var_1 = 0;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 1;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 2;
    const wp::int32 var_12 = 1;
    wp::int32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    //---------
    // forward
    // def max_of_eight(x: float) -> float:                                                   <L 53>
    // highest = x                                                                            <L 54>
    var_0 = wp::copy(var_x);
    // for bit in range(EIGHT_BITS):                                                          <L 55>
    // highest = max(highest, shuffle_xor(highest, 1 << bit))                                 <L 56>
    var_3 = wp::lshift(var_2, var_1);
    var_4 = _shuffle_xor_1(var_0, var_3);
    var_5 = wp::max(var_0, var_4);
    var_8 = wp::lshift(var_7, var_6);
    var_9 = _shuffle_xor_1(var_5, var_8);
    var_10 = wp::max(var_5, var_9);
    var_13 = wp::lshift(var_12, var_11);
    var_14 = _shuffle_xor_1(var_10, var_13);
    var_15 = wp::max(var_10, var_14);
    // return highest                                                                         <L 57>
    return var_15;
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:44
static CUDA_CALLABLE wp::float32 min_of_eight_on_cuda_0(
    wp::float32 var_x)
{
    //---------
    // primal vars
    wp::float32 var_0;
    const wp::int32 var_1 = 0;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 1;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 2;
    const wp::int32 var_12 = 1;
    wp::int32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    //---------
    // forward
    // def min_of_eight(x: float) -> float:                                                   <L 45>
    // lowest = x                                                                             <L 46>
    var_0 = wp::copy(var_x);
    // for bit in range(EIGHT_BITS):                                                          <L 47>
    // lowest = min(lowest, shuffle_xor(lowest, 1 << bit))                                    <L 48>
    var_3 = wp::lshift(var_2, var_1);
    var_4 = _shuffle_xor_1(var_0, var_3);
    var_5 = wp::min(var_0, var_4);
    var_8 = wp::lshift(var_7, var_6);
    var_9 = _shuffle_xor_1(var_5, var_8);
    var_10 = wp::min(var_5, var_9);
    var_13 = wp::lshift(var_12, var_11);
    var_14 = _shuffle_xor_1(var_10, var_13);
    var_15 = wp::min(var_10, var_14);
    // return lowest                                                                          <L 49>
    return var_15;
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:60
static CUDA_CALLABLE wp::vec_t<3, wp::float32> low_of_eight_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 1;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 2;
    wp::float32 var_7;
    wp::float32 var_8;
    wp::vec_t<3, wp::float32> var_9;
    //---------
    // forward
    // def low_of_eight(p: vec3) -> vec3:                                                     <L 61>
    // return vec3(min_of_eight(p[0]), min_of_eight(p[1]), min_of_eight(p[2]))                <L 63>
    var_1 = wp::extract(var_p, var_0);
    var_2 = min_of_eight_on_cuda_0(var_1);
    var_4 = wp::extract(var_p, var_3);
    var_5 = min_of_eight_on_cuda_0(var_4);
    var_7 = wp::extract(var_p, var_6);
    var_8 = min_of_eight_on_cuda_0(var_7);
    var_9 = wp::vec_t<3, wp::float32>(var_2, var_5, var_8);
    return var_9;
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:66
static CUDA_CALLABLE wp::vec_t<3, wp::float32> high_of_eight_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 1;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 2;
    wp::float32 var_7;
    wp::float32 var_8;
    wp::vec_t<3, wp::float32> var_9;
    //---------
    // forward
    // def high_of_eight(p: vec3) -> vec3:                                                    <L 67>
    // return vec3(max_of_eight(p[0]), max_of_eight(p[1]), max_of_eight(p[2]))                <L 68>
    var_1 = wp::extract(var_p, var_0);
    var_2 = max_of_eight_on_cuda_0(var_1);
    var_4 = wp::extract(var_p, var_3);
    var_5 = max_of_eight_on_cuda_0(var_4);
    var_7 = wp::extract(var_p, var_6);
    var_8 = max_of_eight_on_cuda_0(var_7);
    var_9 = wp::vec_t<3, wp::float32>(var_2, var_5, var_8);
    return var_9;
}


// /work/main/src/pointloom/kernels/search/lane_search.py:55
static CUDA_CALLABLE wp::vec_t<12, wp::float32> boxes_of_eight_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_is_used)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 8;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    const wp::int32 var_6 = 1;
    wp::int32 var_7;
    const wp::int32 var_8 = 32;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::vec_t<3, wp::float32> var_12;
    const wp::int32 var_13 = 1;
    wp::int32 var_14;
    bool var_15;
    wp::float32 var_16;
    const wp::float32 var_17 = -1.0;
    wp::float32 var_18;
    wp::float32 var_19;
    bool var_20;
    const wp::int32 var_21 = 1;
    const wp::int32 var_22 = 0;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::int32 var_26;
    wp::int32 var_27;
    const wp::int32 var_28 = 255;
    wp::int32 var_29;
    wp::int32 var_30;
    bool var_31;
    const wp::int32 var_32 = 1;
    const wp::int32 var_33 = 0;
    wp::int32 var_34;
    const wp::float32 var_35 = INFINITY;
    wp::vec_t<3, wp::float32> var_36;
    wp::vec_t<3, wp::float32> var_37;
    wp::vec_t<3, wp::float32> var_38;
    wp::vec_t<3, wp::float32> var_39;
    wp::vec_t<3, wp::float32> var_40;
    const wp::int32 var_41 = 1;
    bool var_42;
    const wp::int32 var_43 = 1;
    bool var_44;
    wp::vec_t<3, wp::float32> var_45;
    wp::vec_t<3, wp::float32> var_46;
    wp::vec_t<3, wp::float32> var_47;
    wp::vec_t<3, wp::float32> var_48;
    wp::vec_t<3, wp::float32> var_49;
    wp::vec_t<3, wp::float32> var_50;
    wp::vec_t<3, wp::float32> var_51;
    wp::vec_t<3, wp::float32> var_52;
    wp::vec_t<3, wp::float32> var_53;
    wp::vec_t<3, wp::float32> var_54;
    wp::vec_t<3, wp::float32> var_55;
    wp::vec_t<3, wp::float32> var_56;
    wp::vec_t<3, wp::float32> var_57;
    wp::vec_t<3, wp::float32> var_58;
    wp::vec_t<3, wp::float32> var_59;
    wp::vec_t<3, wp::float32> var_60;
    const wp::int32 var_61 = 0;
    wp::float32 var_62;
    const wp::int32 var_63 = 1;
    wp::float32 var_64;
    const wp::int32 var_65 = 2;
    wp::float32 var_66;
    const wp::int32 var_67 = 0;
    wp::float32 var_68;
    const wp::int32 var_69 = 1;
    wp::float32 var_70;
    const wp::int32 var_71 = 2;
    wp::float32 var_72;
    const wp::int32 var_73 = 0;
    wp::float32 var_74;
    const wp::int32 var_75 = 1;
    wp::float32 var_76;
    const wp::int32 var_77 = 2;
    wp::float32 var_78;
    const wp::int32 var_79 = 0;
    wp::float32 var_80;
    const wp::int32 var_81 = 1;
    wp::float32 var_82;
    const wp::int32 var_83 = 2;
    wp::float32 var_84;
    wp::vec_t<12, wp::float32> var_85;
    //---------
    // forward
    // def boxes_of_eight(p: vec3, is_used: int) -> two_boxes:                                <L 56>
    // own = lane() & (FAN - 1)                                                               <L 59>
    var_0 = _lane_0();
    var_3 = wp::sub(var_1, var_2);
    var_4 = wp::bit_and(var_0, var_3);
    // after = point_of_lane(p, min(lane() + 1, WARP - 1))                                    <L 60>
    var_5 = _lane_0();
    var_7 = wp::add(var_5, var_6);
    var_10 = wp::sub(var_8, var_9);
    var_11 = wp::min(var_7, var_10);
    var_12 = point_of_lane_on_cuda_0(var_p, var_11);
    // gap = square_distance(p, after) if own < FAN - 1 else -1.0                             <L 61>
    var_14 = wp::sub(var_1, var_13);
    var_15 = (var_4 < var_14);
    if (var_15) {
        var_16 = square_distance_0(var_p, var_12);
    }
    if (!var_15) {
    }
    var_18 = wp::where(var_15, var_16, var_17);
    // largest = max_of_eight(gap)                                                            <L 62>
    var_19 = max_of_eight_on_cuda_0(var_18);
    // widest = ballot(1 if gap == largest else 0) >> (lane() - own)                          <L 63>
    var_20 = (var_18 == var_19);
    if (var_20) {
    }
    if (!var_20) {
    }
    var_23 = wp::where(var_20, var_21, var_22);
    var_24 = _ballot_0(var_23);
    var_25 = _lane_0();
    var_26 = wp::sub(var_25, var_4);
    var_27 = wp::rshift(var_24, var_26);
    // is_before = 1 if own <= lowest_bit(widest & BYTE) else 0                               <L 64>
    var_29 = wp::bit_and(var_27, var_28);
    var_30 = lowest_bit_0(var_29);
    var_31 = (var_4 <= var_30);
    if (var_31) {
    }
    if (!var_31) {
    }
    var_34 = wp::where(var_31, var_32, var_33);
    // nowhere = vec3(INFINITY, INFINITY, INFINITY)                                           <L 65>
    var_36 = wp::vec_t<3, wp::float32>(var_35, var_35, var_35);
    // low = nowhere                                                                          <L 66>
    var_37 = wp::copy(var_36);
    // high = -nowhere                                                                        <L 67>
    var_38 = wp::neg(var_36);
    // low_after = nowhere                                                                    <L 68>
    var_39 = wp::copy(var_36);
    // high_after = -nowhere                                                                  <L 69>
    var_40 = wp::neg(var_36);
    // if is_used == 1:                                                                       <L 70>
    var_42 = (var_is_used == var_41);
    if (var_42) {
        // if is_before == 1:                                                                 <L 71>
        var_44 = (var_34 == var_43);
        if (var_44) {
            // low = p                                                                        <L 72>
            var_45 = wp::copy(var_p);
            // high = p                                                                       <L 73>
            var_46 = wp::copy(var_p);
        }
        if (!var_44) {
            // low_after = p                                                                  <L 75>
            var_47 = wp::copy(var_p);
            // high_after = p                                                                 <L 76>
            var_48 = wp::copy(var_p);
        }
        var_49 = wp::where(var_44, var_45, var_37);
        var_50 = wp::where(var_44, var_46, var_38);
        var_51 = wp::where(var_44, var_39, var_47);
        var_52 = wp::where(var_44, var_40, var_48);
    }
    var_53 = wp::where(var_42, var_49, var_37);
    var_54 = wp::where(var_42, var_50, var_38);
    var_55 = wp::where(var_42, var_51, var_39);
    var_56 = wp::where(var_42, var_52, var_40);
    // a = low_of_eight(low)                                                                  <L 77>
    var_57 = low_of_eight_on_cuda_0(var_53);
    // b = high_of_eight(high)                                                                <L 78>
    var_58 = high_of_eight_on_cuda_0(var_54);
    // c = low_of_eight(low_after)                                                            <L 79>
    var_59 = low_of_eight_on_cuda_0(var_55);
    // d = high_of_eight(high_after)                                                          <L 80>
    var_60 = high_of_eight_on_cuda_0(var_56);
    // return two_boxes(a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2], d[0], d[1], d[2])       <L 81>
    var_62 = wp::extract(var_57, var_61);
    var_64 = wp::extract(var_57, var_63);
    var_66 = wp::extract(var_57, var_65);
    var_68 = wp::extract(var_58, var_67);
    var_70 = wp::extract(var_58, var_69);
    var_72 = wp::extract(var_58, var_71);
    var_74 = wp::extract(var_59, var_73);
    var_76 = wp::extract(var_59, var_75);
    var_78 = wp::extract(var_59, var_77);
    var_80 = wp::extract(var_60, var_79);
    var_82 = wp::extract(var_60, var_81);
    var_84 = wp::extract(var_60, var_83);
    var_85 = wp::vec_t<12, wp::float32>({var_62, var_64, var_66, var_68, var_70, var_72, var_74, var_76, var_78, var_80, var_82, var_84});
    return var_85;
}


// <pointloom.kernels.search.bucket_walk.start_traversal>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> start_traversal_0(
    wp::int32 var_bucket)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int64 var_2;
    wp::int64 var_3;
    wp::vec_t<4, wp::int64> var_4;
    //---------
    // forward
    // def start_traversal(bucket):                                                           <L 1>
    // return traversal(int64(0), int64(0), int64(bucket), int64(0))                          <L 2>
    var_0 = 0ll;
    var_1 = 0ll;
    var_2 = wp::int64(var_bucket);
    var_3 = 0ll;
    var_4 = wp::vec_t<4, wp::int64>(var_0, var_1, var_2, var_3);
    return var_4;
}


// /work/main/src/pointloom/kernels/search/point_tree.py:401
static CUDA_CALLABLE wp::float32 measure_box_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::int32 var_child,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 48;
    wp::int32 var_1;
    wp::int32 var_2;
    wp::float32* var_3;
    const wp::int32 var_4 = 0;
    wp::float32 var_5;
    wp::float32 var_6;
    wp::float32 var_7;
    const wp::int32 var_8 = 0;
    wp::float32 var_9;
    const wp::int32 var_10 = 3;
    const wp::int32 var_11 = 8;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::float32* var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    const wp::float32 var_18 = 0.0;
    wp::float32 var_19;
    wp::int32 var_20;
    wp::float32* var_21;
    const wp::int32 var_22 = 1;
    wp::float32 var_23;
    wp::float32 var_24;
    wp::float32 var_25;
    const wp::int32 var_26 = 1;
    wp::float32 var_27;
    const wp::int32 var_28 = 4;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::float32* var_31;
    wp::float32 var_32;
    wp::float32 var_33;
    wp::float32 var_34;
    const wp::float32 var_35 = 0.0;
    wp::float32 var_36;
    const wp::int32 var_37 = 2;
    wp::int32 var_38;
    wp::int32 var_39;
    wp::float32* var_40;
    const wp::int32 var_41 = 2;
    wp::float32 var_42;
    wp::float32 var_43;
    wp::float32 var_44;
    const wp::int32 var_45 = 2;
    wp::float32 var_46;
    const wp::int32 var_47 = 5;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::float32* var_50;
    wp::float32 var_51;
    wp::float32 var_52;
    wp::float32 var_53;
    const wp::float32 var_54 = 0.0;
    wp::float32 var_55;
    wp::float32 var_56;
    wp::float32 var_57;
    wp::float32 var_58;
    wp::float32 var_59;
    wp::float32 var_60;
    //---------
    // forward
    // def measure_box(boxes: array(dtype=float32), node: int, child: int, a: vec3, b: vec3) -> float:       <L 402>
    // at = node * SIDES + child                                                              <L 403>
    var_1 = wp::mul(var_node, var_0);
    var_2 = wp::add(var_1, var_child);
    // x = larger(larger(boxes[at] - b[0], a[0] - boxes[at + 3 * FAN]), 0.0)                  <L 404>
    var_3 = wp::address(var_boxes, var_2);
    var_5 = wp::extract(var_b, var_4);
    var_7 = wp::load(var_3);
    var_6 = wp::sub(var_7, var_5);
    var_9 = wp::extract(var_a, var_8);
    var_12 = wp::mul(var_10, var_11);
    var_13 = wp::add(var_2, var_12);
    var_14 = wp::address(var_boxes, var_13);
    var_16 = wp::load(var_14);
    var_15 = wp::sub(var_9, var_16);
    var_17 = larger_0(var_6, var_15);
    var_19 = larger_0(var_17, var_18);
    // y = larger(larger(boxes[at + FAN] - b[1], a[1] - boxes[at + 4 * FAN]), 0.0)            <L 405>
    var_20 = wp::add(var_2, var_11);
    var_21 = wp::address(var_boxes, var_20);
    var_23 = wp::extract(var_b, var_22);
    var_25 = wp::load(var_21);
    var_24 = wp::sub(var_25, var_23);
    var_27 = wp::extract(var_a, var_26);
    var_29 = wp::mul(var_28, var_11);
    var_30 = wp::add(var_2, var_29);
    var_31 = wp::address(var_boxes, var_30);
    var_33 = wp::load(var_31);
    var_32 = wp::sub(var_27, var_33);
    var_34 = larger_0(var_24, var_32);
    var_36 = larger_0(var_34, var_35);
    // z = larger(larger(boxes[at + 2 * FAN] - b[2], a[2] - boxes[at + 5 * FAN]), 0.0)        <L 406>
    var_38 = wp::mul(var_37, var_11);
    var_39 = wp::add(var_2, var_38);
    var_40 = wp::address(var_boxes, var_39);
    var_42 = wp::extract(var_b, var_41);
    var_44 = wp::load(var_40);
    var_43 = wp::sub(var_44, var_42);
    var_46 = wp::extract(var_a, var_45);
    var_48 = wp::mul(var_47, var_11);
    var_49 = wp::add(var_2, var_48);
    var_50 = wp::address(var_boxes, var_49);
    var_52 = wp::load(var_50);
    var_51 = wp::sub(var_46, var_52);
    var_53 = larger_0(var_43, var_51);
    var_55 = larger_0(var_53, var_54);
    // return x * x + y * y + z * z                                                           <L 407>
    var_56 = wp::mul(var_19, var_19);
    var_57 = wp::mul(var_36, var_36);
    var_58 = wp::add(var_56, var_57);
    var_59 = wp::mul(var_55, var_55);
    var_60 = wp::add(var_58, var_59);
    return var_60;
}


// /work/main/src/pointloom/kernels/search/lane_search.py:84
static CUDA_CALLABLE wp::int32 nearby_children_on_cuda_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::vec_t<12, wp::float32> var_around,
    wp::float32 var_bound)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 8;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 0;
    wp::float32 var_6;
    const wp::int32 var_7 = 1;
    wp::float32 var_8;
    const wp::int32 var_9 = 2;
    wp::float32 var_10;
    wp::vec_t<3, wp::float32> var_11;
    const wp::int32 var_12 = 3;
    wp::float32 var_13;
    const wp::int32 var_14 = 4;
    wp::float32 var_15;
    const wp::int32 var_16 = 5;
    wp::float32 var_17;
    wp::vec_t<3, wp::float32> var_18;
    wp::float32 var_19;
    const wp::int32 var_20 = 6;
    wp::float32 var_21;
    const wp::int32 var_22 = 7;
    wp::float32 var_23;
    const wp::int32 var_24 = 8;
    wp::float32 var_25;
    wp::vec_t<3, wp::float32> var_26;
    const wp::int32 var_27 = 9;
    wp::float32 var_28;
    const wp::int32 var_29 = 10;
    wp::float32 var_30;
    const wp::int32 var_31 = 11;
    wp::float32 var_32;
    wp::vec_t<3, wp::float32> var_33;
    wp::float32 var_34;
    wp::float32 var_35;
    bool var_36;
    const wp::int32 var_37 = 1;
    const wp::int32 var_38 = 0;
    wp::int32 var_39;
    wp::int32 var_40;
    const wp::int32 var_41 = 2;
    wp::int32 var_42;
    wp::int32 var_43;
    wp::int32 var_44;
    wp::int32 var_45;
    wp::int32 var_46;
    const wp::int32 var_47 = 255;
    wp::int32 var_48;
    //---------
    // forward
    // def nearby_children(boxes: array(dtype=float32), node: int, around: two_boxes, bound: float) -> int:       <L 85>
    // child = lane() & (FAN - 1)                                                             <L 87>
    var_0 = _lane_0();
    var_3 = wp::sub(var_1, var_2);
    var_4 = wp::bit_and(var_0, var_3);
    // a = measure_box(boxes, node, child, vec3(around[0], around[1], around[2]), vec3(around[3], around[4], around[5]))       <L 88>
    var_6 = wp::extract(var_around, var_5);
    var_8 = wp::extract(var_around, var_7);
    var_10 = wp::extract(var_around, var_9);
    var_11 = wp::vec_t<3, wp::float32>(var_6, var_8, var_10);
    var_13 = wp::extract(var_around, var_12);
    var_15 = wp::extract(var_around, var_14);
    var_17 = wp::extract(var_around, var_16);
    var_18 = wp::vec_t<3, wp::float32>(var_13, var_15, var_17);
    var_19 = measure_box_0(var_boxes, var_node, var_4, var_11, var_18);
    // b = measure_box(boxes, node, child, vec3(around[6], around[7], around[8]), vec3(around[9], around[10], around[11]))       <L 89>
    var_21 = wp::extract(var_around, var_20);
    var_23 = wp::extract(var_around, var_22);
    var_25 = wp::extract(var_around, var_24);
    var_26 = wp::vec_t<3, wp::float32>(var_21, var_23, var_25);
    var_28 = wp::extract(var_around, var_27);
    var_30 = wp::extract(var_around, var_29);
    var_32 = wp::extract(var_around, var_31);
    var_33 = wp::vec_t<3, wp::float32>(var_28, var_30, var_32);
    var_34 = measure_box_0(var_boxes, var_node, var_4, var_26, var_33);
    // near = ballot(1 if min(a, b) <= bound else 0)                                          <L 90>
    var_35 = wp::min(var_19, var_34);
    var_36 = (var_35 <= var_bound);
    if (var_36) {
    }
    if (!var_36) {
    }
    var_39 = wp::where(var_36, var_37, var_38);
    var_40 = _ballot_0(var_39);
    // near = near | (near >> (2 * FAN))                                                      <L 91>
    var_42 = wp::mul(var_41, var_1);
    var_43 = wp::rshift(var_40, var_42);
    var_44 = wp::bit_or(var_40, var_43);
    // return (near | (near >> FAN)) & BYTE                                                   <L 92>
    var_45 = wp::rshift(var_44, var_1);
    var_46 = wp::bit_or(var_44, var_45);
    var_48 = wp::bit_and(var_46, var_47);
    return var_48;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:193
static CUDA_CALLABLE wp::vec_t<24, wp::float32> _load_eight_0(
    wp::array_t<wp::vec_t<3, wp::float32>> points,
    wp::int32 first)
{

    const float4* quads = (const float4*)(points.data + first);
    wp::vec_t<24, float> result;
    for (int k = 0; k < 6; ++k) {
        float4 quad = quads[k];
        result[4 * k] = quad.x; result[4 * k + 1] = quad.y; result[4 * k + 2] = quad.z; result[4 * k + 3] = quad.w;
    }
    return result;
}


// /work/main/src/pointloom/kernels/search/lane_search.py:135
static CUDA_CALLABLE wp::float32 sqdist_of_on_cuda_0(
    wp::vec_t<24, wp::float32> var_leaf,
    wp::int32 var_j,
    wp::vec_t<3, wp::float32> var_p)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 3;
    wp::int32 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 3;
    wp::int32 var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    wp::float32 var_7;
    const wp::int32 var_8 = 3;
    wp::int32 var_9;
    const wp::int32 var_10 = 2;
    wp::int32 var_11;
    wp::float32 var_12;
    wp::vec_t<3, wp::float32> var_13;
    wp::float32 var_14;
    //---------
    // forward
    // def sqdist_of(leaf: eight_points, j: int, p: vec3) -> float:                           <L 136>
    // return square_distance(p, vec3(leaf[3 * j], leaf[3 * j + 1], leaf[3 * j + 2]))         <L 137>
    var_1 = wp::mul(var_0, var_j);
    var_2 = wp::extract(var_leaf, var_1);
    var_4 = wp::mul(var_3, var_j);
    var_6 = wp::add(var_4, var_5);
    var_7 = wp::extract(var_leaf, var_6);
    var_9 = wp::mul(var_8, var_j);
    var_11 = wp::add(var_9, var_10);
    var_12 = wp::extract(var_leaf, var_11);
    var_13 = wp::vec_t<3, wp::float32>(var_2, var_7, var_12);
    var_14 = square_distance_0(var_p, var_13);
    return var_14;
}


// /work/main/src/pointloom/kernels/search/bucket_walk.py:35
static CUDA_CALLABLE wp::int64 byte_shift_0(
    wp::int32 var_level)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 8;
    const wp::int32 var_1 = 1;
    wp::int32 var_2;
    const wp::int32 var_3 = 0;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::int64 var_6;
    //---------
    // forward
    // def byte_shift(level: int) -> int64:                                                   <L 36>
    // return int64(FAN * max(level - 1, 0))                                                  <L 38>
    var_2 = wp::sub(var_level, var_1);
    var_4 = wp::max(var_2, var_3);
    var_5 = wp::mul(var_0, var_4);
    var_6 = wp::int64(var_5);
    return var_6;
}


// /work/main/src/pointloom/kernels/search/lane_search.py:95
static CUDA_CALLABLE wp::int32 nearby_nodes_on_cuda_0(
    wp::array_t<wp::int32> var_levels,
    wp::int32 var_first,
    wp::array_t<wp::float32> var_boxes,
    wp::vec_t<12, wp::float32> var_around,
    wp::float32 var_bound,
    wp::int32 var_level,
    wp::int32 var_node)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32* var_1;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    //---------
    // forward
    // def nearby_nodes(                                                                      <L 96>
    // return nearby_children(boxes, levels[first + level] + node, around, bound)             <L 106>
    var_0 = wp::add(var_first, var_level);
    var_1 = wp::address(var_levels, var_0);
    var_3 = wp::load(var_1);
    var_2 = wp::add(var_3, var_node);
    var_4 = nearby_children_on_cuda_0(var_boxes, var_2, var_around, var_bound);
    return var_4;
}


// <pointloom.kernels.search.bucket_walk.next_step__nearby_nodes>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> next_step__nearby_nodes_on_cuda_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::int32 var_root,
    wp::array_t<wp::int32> var_children__levels,
    wp::int32 var_children__first,
    wp::array_t<wp::float32> var_children__boxes,
    wp::vec_t<12, wp::float32> var_children__around,
    wp::float32 var_children__bound)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int64 var_1;
    wp::int32 var_2;
    const wp::int32 var_3 = 1;
    wp::int64 var_4;
    wp::int32 var_5;
    const wp::int32 var_6 = 2;
    wp::int64 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 3;
    wp::int64 var_10;
    bool var_11;
    const wp::int32 var_12 = 0;
    bool var_13;
    const wp::int32 var_14 = 0;
    bool var_15;
    const wp::int32 var_16 = 1;
    const wp::int32 var_17 = 8;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::int32 var_20;
    const wp::int32 var_21 = 1;
    wp::int32 var_22;
    const wp::int32 var_23 = 1;
    bool var_24;
    wp::int64 var_25;
    wp::int64 var_26;
    wp::int32 var_27;
    const wp::int32 var_28 = 255;
    wp::int32 var_29;
    const wp::int32 var_30 = 0;
    bool var_31;
    wp::int32 var_32;
    wp::int32 var_33;
    wp::int64 var_34;
    wp::int64 var_35;
    wp::int64 var_36;
    wp::int64 var_37;
    wp::int32 var_38;
    const wp::int32 var_39 = 1;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::int32 var_42;
    const wp::int32 var_43 = 1;
    wp::int32 var_44;
    const wp::int32 var_45 = 0;
    bool var_46;
    const wp::int32 var_47 = 0;
    wp::int32 var_48;
    wp::int64 var_49;
    wp::int64 var_50;
    wp::int64 var_51;
    wp::int64 var_52;
    wp::int64 var_53;
    wp::int32 var_54;
    bool var_55;
    const wp::int32 var_56 = 1;
    wp::int32 var_57;
    bool var_58;
    const wp::int32 var_59 = 0;
    const wp::int32 var_60 = 1;
    wp::int32 var_61;
    wp::int32 var_62;
    wp::int32 var_63;
    const wp::int32 var_64 = 1;
    wp::int32 var_65;
    wp::int32 var_66;
    wp::int32 var_67;
    wp::int32 var_68;
    wp::int64 var_69;
    wp::int64 var_70;
    wp::int64 var_71;
    wp::int64 var_72;
    wp::int32 var_73;
    wp::int32 var_74;
    wp::int64 var_75;
    wp::int32 var_76;
    wp::int32 var_77;
    const wp::int32 var_78 = 1;
    wp::int32 var_79;
    wp::int32 var_80;
    wp::int32 var_81;
    wp::int32 var_82;
    wp::int64 var_83;
    wp::int32 var_84;
    wp::int32 var_85;
    wp::int32 var_86;
    wp::int32 var_87;
    wp::int64 var_88;
    wp::int32 var_89;
    wp::int64 var_90;
    wp::int64 var_91;
    wp::int64 var_92;
    wp::vec_t<4, wp::int64> var_93;
    //---------
    // forward
    // def next_step__nearby_nodes(step, root, children__levels, children__first, children__boxes, children__around, children__bound):       <L 1>
    // height = int(step[0])                                                                  <L 3>
    var_1 = wp::extract(var_step, var_0);
    var_2 = wp::int(var_1);
    // level = int(step[1])                                                                   <L 4>
    var_4 = wp::extract(var_step, var_3);
    var_5 = wp::int(var_4);
    // node = int(step[2])                                                                    <L 5>
    var_7 = wp::extract(var_step, var_6);
    var_8 = wp::int(var_7);
    // pending = step[3]                                                                      <L 6>
    var_10 = wp::extract(var_step, var_9);
    // if level == 0 and height > 0:                                                          <L 7>
    var_13 = (var_5 == var_12);
    var_11 = var_13;
    if (var_11) {
        var_15 = (var_2 > var_14);
        var_11 = var_11 && var_15;
    }
    if (var_11) {
        // level = 1                                                                          <L 8>
        // node = node // FAN                                                                 <L 9>
        var_18 = wp::floordiv(var_8, var_17);
    }
    var_19 = wp::where(var_11, var_16, var_5);
    var_20 = wp::where(var_11, var_18, var_8);
    // searching = int(1)                                                                     <L 10>
    var_22 = wp::int(var_21);
    // while searching == 1:                                                                  <L 11>
    start_while_0:;
    var_24 = (var_22 == var_23);
    if ((var_24) == false) goto end_while_0;
        // left = int(pending >> byte_shift(level)) & BYTE                                    <L 12>
        var_25 = byte_shift_0(var_19);
        var_26 = wp::rshift(var_10, var_25);
        var_27 = wp::int(var_26);
        var_29 = wp::bit_and(var_27, var_28);
        // if left != 0:                                                                      <L 13>
        var_31 = (var_29 != var_30);
        if (var_31) {
            // lowest = left & -left                                                          <L 14>
            var_32 = wp::neg(var_29);
            var_33 = wp::bit_and(var_29, var_32);
            // pending = pending ^ int64(lowest) << byte_shift(level)                         <L 15>
            var_34 = wp::int64(var_33);
            var_35 = byte_shift_0(var_19);
            var_36 = wp::lshift(var_34, var_35);
            var_37 = wp::bit_xor(var_10, var_36);
            // node = node * FAN + bit_count(lowest - 1)                                      <L 16>
            var_38 = wp::mul(var_20, var_17);
            var_40 = wp::sub(var_33, var_39);
            var_41 = wp::bit_count(var_40);
            var_42 = wp::add(var_38, var_41);
            // level = level - 1                                                              <L 17>
            var_44 = wp::sub(var_19, var_43);
            // if level == 0:                                                                 <L 18>
            var_46 = (var_44 == var_45);
            if (var_46) {
                // searching = 0                                                              <L 19>
            }
            if (!var_46) {
                // inside = children__call(children__levels, children__first, children__boxes, children__around, children__bound, level, node)       <L 21>
                var_48 = nearby_nodes_on_cuda_0(var_children__levels, var_children__first, var_children__boxes, var_children__around, var_children__bound, var_44, var_42);
                // pending = pending | int64(inside) << byte_shift(level)                     <L 22>
                var_49 = wp::int64(var_48);
                var_50 = byte_shift_0(var_44);
                var_51 = wp::lshift(var_49, var_50);
                var_52 = wp::bit_or(var_37, var_51);
            }
            var_53 = wp::where(var_46, var_37, var_52);
            var_54 = wp::where(var_46, var_47, var_22);
        }
        if (!var_31) {
            // elif level == height:                                                          <L 23>
            var_55 = (var_19 == var_2);
            if (var_55) {
                // height = height + 1                                                        <L 24>
                var_57 = wp::add(var_2, var_56);
                // if height > root:                                                          <L 25>
                var_58 = (var_57 > var_root);
                if (var_58) {
                    // searching = 0                                                          <L 26>
                }
                if (!var_58) {
                    // own = 1 << node % FAN                                                  <L 28>
                    var_61 = wp::mod(var_20, var_17);
                    var_62 = wp::lshift(var_60, var_61);
                    // node = node // FAN                                                     <L 29>
                    var_63 = wp::floordiv(var_20, var_17);
                    // level = level + 1                                                      <L 30>
                    var_65 = wp::add(var_19, var_64);
                    // others = children__call(children__levels, children__first, children__boxes, children__around, children__bound, level, node) & BYTE - own       <L 31>
                    var_66 = nearby_nodes_on_cuda_0(var_children__levels, var_children__first, var_children__boxes, var_children__around, var_children__bound, var_65, var_63);
                    var_67 = wp::sub(var_28, var_62);
                    var_68 = wp::bit_and(var_66, var_67);
                    // pending = pending | int64(others) << byte_shift(level)                 <L 32>
                    var_69 = wp::int64(var_68);
                    var_70 = byte_shift_0(var_65);
                    var_71 = wp::lshift(var_69, var_70);
                    var_72 = wp::bit_or(var_10, var_71);
                }
                var_73 = wp::where(var_58, var_19, var_65);
                var_74 = wp::where(var_58, var_20, var_63);
                var_75 = wp::where(var_58, var_10, var_72);
                var_76 = wp::where(var_58, var_59, var_22);
            }
            if (!var_55) {
                // node = node // FAN                                                         <L 34>
                var_77 = wp::floordiv(var_20, var_17);
                // level = level + 1                                                          <L 35>
                var_79 = wp::add(var_19, var_78);
            }
            var_80 = wp::where(var_55, var_57, var_2);
            var_81 = wp::where(var_55, var_73, var_79);
            var_82 = wp::where(var_55, var_74, var_77);
            var_83 = wp::where(var_55, var_75, var_10);
            var_84 = wp::where(var_55, var_76, var_22);
        }
        var_85 = wp::where(var_31, var_2, var_80);
        var_86 = wp::where(var_31, var_44, var_81);
        var_87 = wp::where(var_31, var_42, var_82);
        var_88 = wp::where(var_31, var_53, var_83);
        var_89 = wp::where(var_31, var_54, var_84);
        wp::assign(var_2, var_85);
        wp::assign(var_19, var_86);
        wp::assign(var_20, var_87);
        wp::assign(var_10, var_88);
        wp::assign(var_22, var_89);
    goto start_while_0;
    end_while_0:;
    // return traversal(int64(height), int64(level), int64(node), pending)                    <L 36>
    var_90 = wp::int64(var_2);
    var_91 = wp::int64(var_19);
    var_92 = wp::int64(var_20);
    var_93 = wp::vec_t<4, wp::int64>(var_90, var_91, var_92, var_10);
    return var_93;
}


// <pointloom.kernels.icp.correspondences.next_bucket_of_lanes>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> next_bucket_of_lanes_on_cuda_1(
    wp::vec_t<4, wp::int64> var_step,
    wp::vec_t<12, wp::float32> var_around,
    wp::float32 var_bound,
    wp::int32 var_target,
    wp::array_t<wp::int32> var_forest__levels,
    wp::array_t<wp::int32> var_forest__roots,
    wp::array_t<wp::float32> var_forest__boxes)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 12;
    wp::int32 var_1;
    wp::int32* var_2;
    wp::vec_t<4, wp::int64> var_3;
    wp::int32 var_4;
    //---------
    // forward
    // def next_bucket_of_lanes(step, around, bound, target, forest__levels, forest__roots, forest__boxes):       <L 1>
    // nodes = target * HEIGHTS                                                               <L 2>
    var_1 = wp::mul(var_target, var_0);
    // return next_step__nearby_nodes(step, forest__roots[target], forest__levels, nodes, forest__boxes, around, bound)       <L 3>
    var_2 = wp::address(var_forest__roots, var_target);
    var_4 = wp::load(var_2);
    var_3 = next_step__nearby_nodes_on_cuda_0(var_step, var_4, var_forest__levels, var_1, var_forest__boxes, var_around, var_bound);
    return var_3;
}


// <pointloom.kernels.icp.jobs.source_position>:1
static CUDA_CALLABLE void adj_source_position_0(
    wp::int32 var_i,
    wp::array_t<wp::int32> var_jobs__sources__first_positions,
    wp::array_t<wp::int32> var_jobs__group_jobs,
    wp::array_t<wp::int32> var_jobs__job_groups,
    wp::array_t<wp::int32> var_jobs__job_sources,
    wp::int32 & adj_i,
    wp::array_t<wp::int32> & adj_jobs__sources__first_positions,
    wp::array_t<wp::int32> & adj_jobs__group_jobs,
    wp::array_t<wp::int32> & adj_jobs__job_groups,
    wp::array_t<wp::int32> & adj_jobs__job_sources,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/transform.py:27
static CUDA_CALLABLE void adj_widen_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:301
static CUDA_CALLABLE void adj_move_0(
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::vec_t<3, wp::float64> var_p,
    wp::mat_t<4, 4, wp::float64> & adj_pose,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/transform.py:32
static CUDA_CALLABLE void adj_narrow_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::vec_t<3, wp::float32> & adj_ret)
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


// /work/main/src/pointloom/kernels/icp/correspondences.py:115
static CUDA_CALLABLE void adj_difference_of_0(
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::mat_t<4, 4, wp::float64> var_before,
    wp::mat_t<4, 4, wp::float64> & adj_pose,
    wp::mat_t<4, 4, wp::float64> & adj_before,
    wp::vec_t<12, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/plain_min_max.py:11
static CUDA_CALLABLE void adj_larger_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/icp/correspondences.py:126
static CUDA_CALLABLE void adj_remaining_bound_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_q,
    wp::vec_t<12, wp::float32> var_d,
    wp::float32 var_lower,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_q,
    wp::vec_t<12, wp::float32> & adj_d,
    wp::float32 & adj_lower,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/point_tree.py:379
static CUDA_CALLABLE void adj_square_distance_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_q,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_q,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/hilbert_order.py:102
static CUDA_CALLABLE void adj_cell_on_axis_0(
    wp::float32 var_coordinate,
    wp::float32 var_low,
    wp::float32 var_scale,
    wp::int32 var_levels,
    wp::float32 & adj_coordinate,
    wp::float32 & adj_low,
    wp::float32 & adj_scale,
    wp::int32 & adj_levels,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.hilbert_order.spread_bits>:1
static CUDA_CALLABLE void adj_spread_bits_0(
    wp::int32 var_v,
    wp::int32 & adj_v,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.hilbert_order.hilbert_codes>:1
static CUDA_CALLABLE void adj_hilbert_codes_0(
    wp::vec_t<8, wp::int32> var_cx,
    wp::vec_t<8, wp::int32> var_cy,
    wp::vec_t<8, wp::int32> var_cz,
    wp::int32 var_levels,
    wp::vec_t<8, wp::int32> & adj_cx,
    wp::vec_t<8, wp::int32> & adj_cy,
    wp::vec_t<8, wp::int32> & adj_cz,
    wp::int32 & adj_levels,
    wp::vec_t<8, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.hilbert_order.locate_on_curve>:1
static CUDA_CALLABLE void adj_locate_on_curve_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_curve__low,
    wp::float32 var_curve__scale,
    wp::int32 var_curve__levels,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_curve__low,
    wp::float32 & adj_curve__scale,
    wp::int32 & adj_curve__levels,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.point_tree.find_run>:1
static CUDA_CALLABLE void adj_find_run_0(
    wp::array_t<wp::int64> var_codes,
    wp::int32 var_first,
    wp::int32 var_count,
    wp::int64 var_code,
    wp::array_t<wp::int64> & adj_codes,
    wp::int32 & adj_first,
    wp::int32 & adj_count,
    wp::int64 & adj_code,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.point_forest.find_bucket_of>:1
static CUDA_CALLABLE void adj_find_bucket_of_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_tree,
    wp::array_t<wp::int64> var_forest__clouds__codes,
    wp::vec_t<3, wp::float32> var_forest__clouds__curve__low,
    wp::float32 var_forest__clouds__curve__scale,
    wp::int32 var_forest__clouds__curve__levels,
    wp::array_t<wp::int32> var_forest__bucket_counts,
    wp::array_t<wp::int32> var_forest__levels,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::int32 & adj_tree,
    wp::array_t<wp::int64> & adj_forest__clouds__codes,
    wp::vec_t<3, wp::float32> & adj_forest__clouds__curve__low,
    wp::float32 & adj_forest__clouds__curve__scale,
    wp::int32 & adj_forest__clouds__curve__levels,
    wp::array_t<wp::int32> & adj_forest__bucket_counts,
    wp::array_t<wp::int32> & adj_forest__levels,
    wp::int32 & adj_ret)
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


// /work/main/src/pointloom/kernels/search/tree_walk.py:20
static CUDA_CALLABLE void adj_lowest_bit_0(
    wp::int32 var_bits,
    wp::int32 & adj_bits,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:162
static CUDA_CALLABLE void adj__shuffle_0(
    wp::int32 x,
    wp::int32 lane,
    wp::int32 & adj_x,
    wp::int32 & adj_lane,
    wp::int32 & adj_ret)
{
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:148
static CUDA_CALLABLE void adj__bits_float_0(
    wp::int32 var_i,
    wp::int32 & adj_i,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/plain_min_max.py:6
static CUDA_CALLABLE void adj_smaller_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/icp/correspondences.py:98
static CUDA_CALLABLE void adj_limit_beside_0(
    wp::int32 var_best,
    wp::int32 var_second,
    wp::float32 var_margin,
    wp::int32 & adj_best,
    wp::int32 & adj_second,
    wp::float32 & adj_margin,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:154
static CUDA_CALLABLE void adj__lane_0(
    wp::int32 & adj_ret)
{
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:166
static CUDA_CALLABLE void adj__shuffle_1(
    wp::float32 x,
    wp::int32 lane,
    wp::float32 & adj_x,
    wp::int32 & adj_lane,
    wp::float32 & adj_ret)
{
}


// /work/main/src/pointloom/kernels/search/lane_search.py:50
static CUDA_CALLABLE void adj_point_of_lane_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_owner,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::int32 & adj_owner,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:178
static CUDA_CALLABLE void adj__shuffle_xor_1(
    wp::float32 x,
    wp::int32 mask,
    wp::float32 & adj_x,
    wp::int32 & adj_mask,
    wp::float32 & adj_ret)
{
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:52
static CUDA_CALLABLE void adj_max_of_eight_on_cuda_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:44
static CUDA_CALLABLE void adj_min_of_eight_on_cuda_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:60
static CUDA_CALLABLE void adj_low_of_eight_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:66
static CUDA_CALLABLE void adj_high_of_eight_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/lane_search.py:55
static CUDA_CALLABLE void adj_boxes_of_eight_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_is_used,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::int32 & adj_is_used,
    wp::vec_t<12, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.bucket_walk.start_traversal>:1
static CUDA_CALLABLE void adj_start_traversal_0(
    wp::int32 var_bucket,
    wp::int32 & adj_bucket,
    wp::vec_t<4, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/point_tree.py:401
static CUDA_CALLABLE void adj_measure_box_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::int32 var_child,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::array_t<wp::float32> & adj_boxes,
    wp::int32 & adj_node,
    wp::int32 & adj_child,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/lane_search.py:84
static CUDA_CALLABLE void adj_nearby_children_on_cuda_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::vec_t<12, wp::float32> var_around,
    wp::float32 var_bound,
    wp::array_t<wp::float32> & adj_boxes,
    wp::int32 & adj_node,
    wp::vec_t<12, wp::float32> & adj_around,
    wp::float32 & adj_bound,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:193
static CUDA_CALLABLE void adj__load_eight_0(
    wp::array_t<wp::vec_t<3, wp::float32>> points,
    wp::int32 first,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_points,
    wp::int32 & adj_first,
    wp::vec_t<24, wp::float32> & adj_ret)
{
}


// /work/main/src/pointloom/kernels/search/lane_search.py:135
static CUDA_CALLABLE void adj_sqdist_of_on_cuda_0(
    wp::vec_t<24, wp::float32> var_leaf,
    wp::int32 var_j,
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<24, wp::float32> & adj_leaf,
    wp::int32 & adj_j,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/bucket_walk.py:35
static CUDA_CALLABLE void adj_byte_shift_0(
    wp::int32 var_level,
    wp::int32 & adj_level,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/lane_search.py:95
static CUDA_CALLABLE void adj_nearby_nodes_on_cuda_0(
    wp::array_t<wp::int32> var_levels,
    wp::int32 var_first,
    wp::array_t<wp::float32> var_boxes,
    wp::vec_t<12, wp::float32> var_around,
    wp::float32 var_bound,
    wp::int32 var_level,
    wp::int32 var_node,
    wp::array_t<wp::int32> & adj_levels,
    wp::int32 & adj_first,
    wp::array_t<wp::float32> & adj_boxes,
    wp::vec_t<12, wp::float32> & adj_around,
    wp::float32 & adj_bound,
    wp::int32 & adj_level,
    wp::int32 & adj_node,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.bucket_walk.next_step__nearby_nodes>:1
static CUDA_CALLABLE void adj_next_step__nearby_nodes_on_cuda_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::int32 var_root,
    wp::array_t<wp::int32> var_children__levels,
    wp::int32 var_children__first,
    wp::array_t<wp::float32> var_children__boxes,
    wp::vec_t<12, wp::float32> var_children__around,
    wp::float32 var_children__bound,
    wp::vec_t<4, wp::int64> & adj_step,
    wp::int32 & adj_root,
    wp::array_t<wp::int32> & adj_children__levels,
    wp::int32 & adj_children__first,
    wp::array_t<wp::float32> & adj_children__boxes,
    wp::vec_t<12, wp::float32> & adj_children__around,
    wp::float32 & adj_children__bound,
    wp::vec_t<4, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.icp.correspondences.next_bucket_of_lanes>:1
static CUDA_CALLABLE void adj_next_bucket_of_lanes_on_cuda_1(
    wp::vec_t<4, wp::int64> var_step,
    wp::vec_t<12, wp::float32> var_around,
    wp::float32 var_bound,
    wp::int32 var_target,
    wp::array_t<wp::int32> var_forest__levels,
    wp::array_t<wp::int32> var_forest__roots,
    wp::array_t<wp::float32> var_forest__boxes,
    wp::vec_t<4, wp::int64> & adj_step,
    wp::vec_t<12, wp::float32> & adj_around,
    wp::float32 & adj_bound,
    wp::int32 & adj_target,
    wp::array_t<wp::int32> & adj_forest__levels,
    wp::array_t<wp::int32> & adj_forest__roots,
    wp::array_t<wp::float32> & adj_forest__boxes,
    wp::vec_t<4, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void WP_MAXNREG(128) match_lanes_kernel_6327e0ff_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::int32> var_matches__jobs__job_targets,
    wp::float32 var_matches__max_sqdist,
    wp::array_t<wp::int32> var_matches__live,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__earlier,
    wp::array_t<wp::float32> var_matches__margins,
    wp::array_t<wp::int32> var_matches__nearest,
    wp::array_t<wp::float32> var_matches__lowers,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::array_t<wp::vec_t<3, wp::float32>> var_forest__clouds__points,
    wp::array_t<wp::int64> var_forest__clouds__codes,
    wp::vec_t<3, wp::float32> var_forest__clouds__curve__low,
    wp::float32 var_forest__clouds__curve__scale,
    wp::int32 var_forest__clouds__curve__levels,
    wp::array_t<wp::int32> var_forest__bucket_counts,
    wp::array_t<wp::int32> var_forest__levels,
    wp::array_t<wp::int32> var_forest__roots,
    wp::array_t<wp::float32> var_forest__boxes)
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
        const wp::int32 var_8 = 8;
        wp::int32 var_9;
        wp::int32* var_10;
        wp::int32 var_11;
        wp::int32 var_12;
        bool var_13;
        bool var_14;
        wp::int32* var_15;
        const wp::int32 var_16 = 0;
        bool var_17;
        wp::int32 var_18;
        const wp::int32 var_19 = 1;
        const wp::int32 var_20 = 0;
        wp::int32 var_21;
        wp::int32* var_22;
        wp::int32 var_23;
        wp::int32 var_24;
        wp::float32* var_25;
        wp::float32 var_26;
        wp::float32 var_27;
        wp::int32 var_28;
        wp::vec_t<3, wp::float32>* var_29;
        wp::vec_t<3, wp::float32> var_30;
        wp::vec_t<3, wp::float32> var_31;
        wp::mat_t<4, 4, wp::float64>* var_32;
        wp::vec_t<3, wp::float64> var_33;
        wp::vec_t<3, wp::float64> var_34;
        wp::mat_t<4, 4, wp::float64> var_35;
        wp::vec_t<3, wp::float32> var_36;
        bool var_37;
        const wp::int32 var_38 = 1;
        bool var_39;
        bool var_40;
        bool var_41;
        const wp::int32 var_42 = 1;
        const wp::int32 var_43 = 0;
        wp::int32 var_44;
        const wp::float32 var_45 = 0.0;
        wp::float32 var_46;
        const wp::int32 var_47 = -1;
        wp::int32 var_48;
        const wp::int32 var_49 = -1;
        wp::int32 var_50;
        wp::int32 var_51;
        const wp::int32 var_52 = 1;
        wp::int32 var_53;
        const wp::int32 var_54 = 2139095039;
        wp::int32 var_55;
        const wp::int32 var_56 = 0;
        wp::int32 var_57;
        const wp::int32 var_58 = 0;
        wp::int32 var_59;
        const wp::int32 var_60 = 1;
        bool var_61;
        wp::int32* var_62;
        wp::int32 var_63;
        wp::int32 var_64;
        wp::mat_t<4, 4, wp::float64>* var_65;
        wp::mat_t<4, 4, wp::float64>* var_66;
        wp::vec_t<12, wp::float32> var_67;
        wp::mat_t<4, 4, wp::float64> var_68;
        wp::mat_t<4, 4, wp::float64> var_69;
        wp::float32* var_70;
        wp::float32 var_71;
        wp::float32 var_72;
        wp::float32 var_73;
        const wp::int32 var_74 = 0;
        bool var_75;
        wp::vec_t<3, wp::float32>* var_76;
        wp::float32 var_77;
        wp::vec_t<3, wp::float32> var_78;
        wp::float32 var_79;
        wp::int32 var_80;
        const wp::int32 var_81 = 1;
        wp::int32 var_82;
        wp::int32 var_83;
        bool var_84;
        wp::int32 var_85;
        wp::int32 var_86;
        wp::int32 var_87;
        wp::int32 var_88;
        wp::float32 var_89;
        const wp::float32 var_90 = 1.0;
        const wp::float32 var_91 = 1e-06;
        wp::float32 var_92;
        wp::float32 var_93;
        bool var_94;
        const wp::int32 var_95 = 1;
        const wp::int32 var_96 = -1;
        const wp::int32 var_97 = 64;
        wp::int32 var_98;
        const wp::int32 var_99 = 12;
        wp::int32 var_100;
        wp::int32* var_101;
        wp::int32 var_102;
        wp::int32 var_103;
        const wp::int32 var_104 = 0;
        bool var_105;
        wp::int32 var_106;
        wp::int32 var_107;
        wp::int32 var_108;
        wp::int32 var_109;
        wp::int32 var_110;
        wp::float32 var_111;
        wp::int32 var_112;
        wp::int32 var_113;
        wp::int32 var_114;
        wp::int32 var_115;
        wp::int32 var_116;
        wp::int32 var_117;
        const wp::int32 var_118 = 0;
        bool var_119;
        wp::int32 var_120;
        wp::int32 var_121;
        const wp::float32 var_122 = -1.0;
        wp::float32 var_123;
        bool var_124;
        const wp::int32 var_125 = 1;
        bool var_126;
        bool var_127;
        const wp::int32 var_128 = 1;
        const wp::int32 var_129 = 0;
        wp::int32 var_130;
        const wp::int32 var_131 = 1;
        bool var_132;
        wp::float32 var_133;
        wp::float32 var_134;
        wp::int32 var_135;
        wp::int32 var_136;
        wp::vec_t<12, wp::float32> var_137;
        wp::float32 var_138;
        wp::int32 var_139;
        wp::int32* var_140;
        wp::int32 var_141;
        wp::int32 var_142;
        wp::int32 var_143;
        wp::vec_t<4, wp::int64> var_144;
        const wp::int32 var_145 = 0;
        wp::int64 var_146;
        wp::int32 var_147;
        wp::int32* var_148;
        bool var_149;
        wp::int32 var_150;
        const wp::int32 var_151 = 2;
        wp::int64 var_152;
        wp::int32 var_153;
        wp::int32 var_154;
        wp::int32 var_155;
        wp::int32 var_156;
        const wp::int32 var_157 = 0;
        bool var_158;
        wp::int32 var_159;
        const wp::int32 var_160 = 1;
        wp::int32 var_161;
        wp::int32 var_162;
        wp::float32 var_163;
        bool var_164;
        const wp::int32 var_165 = 1;
        const wp::int32 var_166 = 0;
        wp::int32 var_167;
        wp::int32 var_168;
        const wp::int32 var_169 = 0;
        bool var_170;
        wp::int32 var_171;
        wp::int32 var_172;
        wp::int32 var_173;
        wp::vec_t<24, wp::float32> var_174;
        const wp::int32 var_175 = 1;
        bool var_176;
        const wp::int32 var_177 = 0;
        wp::float32 var_178;
        wp::int32 var_179;
        wp::int32 var_180;
        bool var_181;
        const wp::int32 var_182 = 0;
        bool var_183;
        wp::int32 var_184;
        wp::int32 var_185;
        wp::int32 var_186;
        wp::int32 var_187;
        wp::int32 var_188;
        wp::int32 var_189;
        wp::int32 var_190;
        wp::int32 var_191;
        const wp::int32 var_192 = 1;
        wp::float32 var_193;
        wp::int32 var_194;
        wp::int32 var_195;
        bool var_196;
        const wp::int32 var_197 = 0;
        bool var_198;
        wp::int32 var_199;
        wp::int32 var_200;
        wp::int32 var_201;
        wp::int32 var_202;
        wp::int32 var_203;
        wp::int32 var_204;
        wp::int32 var_205;
        wp::int32 var_206;
        const wp::int32 var_207 = 2;
        wp::float32 var_208;
        wp::int32 var_209;
        wp::int32 var_210;
        bool var_211;
        const wp::int32 var_212 = 0;
        bool var_213;
        wp::int32 var_214;
        wp::int32 var_215;
        wp::int32 var_216;
        wp::int32 var_217;
        wp::int32 var_218;
        wp::int32 var_219;
        wp::int32 var_220;
        wp::int32 var_221;
        const wp::int32 var_222 = 3;
        wp::float32 var_223;
        wp::int32 var_224;
        wp::int32 var_225;
        bool var_226;
        const wp::int32 var_227 = 0;
        bool var_228;
        wp::int32 var_229;
        wp::int32 var_230;
        wp::int32 var_231;
        wp::int32 var_232;
        wp::int32 var_233;
        wp::int32 var_234;
        wp::int32 var_235;
        wp::int32 var_236;
        const wp::int32 var_237 = 4;
        wp::float32 var_238;
        wp::int32 var_239;
        wp::int32 var_240;
        bool var_241;
        const wp::int32 var_242 = 0;
        bool var_243;
        wp::int32 var_244;
        wp::int32 var_245;
        wp::int32 var_246;
        wp::int32 var_247;
        wp::int32 var_248;
        wp::int32 var_249;
        wp::int32 var_250;
        wp::int32 var_251;
        const wp::int32 var_252 = 5;
        wp::float32 var_253;
        wp::int32 var_254;
        wp::int32 var_255;
        bool var_256;
        const wp::int32 var_257 = 0;
        bool var_258;
        wp::int32 var_259;
        wp::int32 var_260;
        wp::int32 var_261;
        wp::int32 var_262;
        wp::int32 var_263;
        wp::int32 var_264;
        wp::int32 var_265;
        wp::int32 var_266;
        const wp::int32 var_267 = 6;
        wp::float32 var_268;
        wp::int32 var_269;
        wp::int32 var_270;
        bool var_271;
        const wp::int32 var_272 = 0;
        bool var_273;
        wp::int32 var_274;
        wp::int32 var_275;
        wp::int32 var_276;
        wp::int32 var_277;
        wp::int32 var_278;
        wp::int32 var_279;
        wp::int32 var_280;
        wp::int32 var_281;
        const wp::int32 var_282 = 7;
        wp::float32 var_283;
        wp::int32 var_284;
        wp::int32 var_285;
        bool var_286;
        const wp::int32 var_287 = 0;
        bool var_288;
        wp::int32 var_289;
        wp::int32 var_290;
        wp::int32 var_291;
        wp::int32 var_292;
        wp::int32 var_293;
        wp::int32 var_294;
        wp::int32 var_295;
        wp::int32 var_296;
        wp::float32 var_297;
        wp::int32 var_298;
        wp::int32 var_299;
        wp::int32 var_300;
        wp::float32 var_301;
        wp::int32 var_302;
        wp::int32 var_303;
        wp::int32 var_304;
        wp::float32 var_305;
        wp::float32 var_306;
        wp::vec_t<4, wp::int64> var_307;
        const wp::int32 var_308 = 1;
        bool var_309;
        wp::float32 var_310;
        wp::float32 var_311;
        const wp::int32 var_312 = 1;
        bool var_313;
        const wp::int32 var_314 = 1;
        bool var_315;
        //---------
        // forward
        // def match_lanes_kernel(matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__jobs__job_targets, matches__max_sqdist, matches__live, matches__poses, matches__earlier, matches__margins, matches__nearest, matches__lowers, matches__pairs, forest__clouds__points, forest__clouds__codes, forest__clouds__curve__low, forest__clouds__curve__scale, forest__clouds__curve__levels, forest__bucket_counts, forest__levels, forest__roots, forest__boxes):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // row = min(i, matches__pairs.shape[0] - 1)                                              <L 4>
        var_1 = &(var_matches__pairs.shape);
        var_4 = wp::load(var_1);
        var_3 = wp::extract(var_4, var_2);
        var_6 = wp::sub(var_3, var_5);
        var_7 = wp::min(var_0, var_6);
        // job = matches__jobs__group_jobs[row // LEAF]                                           <L 5>
        var_9 = wp::floordiv(var_7, var_8);
        var_10 = wp::address(var_matches__jobs__group_jobs, var_9);
        var_12 = wp::load(var_10);
        var_11 = wp::copy(var_12);
        // is_live = 1 if i == row and matches__live[job] != 0 else 0                             <L 6>
        var_14 = (var_0 == var_7);
        var_13 = var_14;
        if (var_13) {
            var_15 = wp::address(var_matches__live, var_11);
            var_18 = wp::load(var_15);
            var_17 = (var_18 != var_16);
            var_13 = var_13 && var_17;
        }
        if (var_13) {
        }
        if (!var_13) {
        }
        var_21 = wp::where(var_13, var_19, var_20);
        // target = matches__jobs__job_targets[job]                                               <L 7>
        var_22 = wp::address(var_matches__jobs__job_targets, var_11);
        var_24 = wp::load(var_22);
        var_23 = wp::copy(var_24);
        // margin = matches__margins[job]                                                         <L 8>
        var_25 = wp::address(var_matches__margins, var_11);
        var_27 = wp::load(var_25);
        var_26 = wp::copy(var_27);
        // p = matches__jobs__sources__points[source_position(row, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources)]       <L 9>
        var_28 = source_position_0(var_7, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources);
        var_29 = wp::address(var_matches__jobs__sources__points, var_28);
        var_31 = wp::load(var_29);
        var_30 = wp::copy(var_31);
        // q = narrow(move(matches__poses[job], widen(p)))                                        <L 10>
        var_32 = wp::address(var_matches__poses, var_11);
        var_33 = widen_0(var_30);
        var_35 = wp::load(var_32);
        var_34 = move_0(var_35, var_33);
        var_36 = narrow_0(var_34);
        // is_point = 1 if is_live == 1 and isfinite(p) and isfinite(q) else 0                    <L 11>
        var_39 = (var_21 == var_38);
        var_37 = var_39;
        if (var_37) {
            var_40 = wp::isfinite(var_30);
            var_37 = var_37 && var_40;
        }
        if (var_37) {
            var_41 = wp::isfinite(var_36);
            var_37 = var_37 && var_41;
        }
        if (var_37) {
        }
        if (!var_37) {
        }
        var_44 = wp::where(var_37, var_42, var_43);
        // lower = float(0.0)                                                                     <L 12>
        var_46 = wp::float(var_45);
        // position = int(-1)                                                                     <L 13>
        var_48 = wp::int(var_47);
        // pair = int(-1)                                                                         <L 14>
        var_50 = wp::int(var_49);
        // best = float_bits(matches__max_sqdist) + 1                                             <L 15>
        var_51 = _float_bits_0(var_matches__max_sqdist);
        var_53 = wp::add(var_51, var_52);
        // second = int(LARGEST_BITS)                                                             <L 16>
        var_55 = wp::int(var_54);
        // is_searching = int(0)                                                                  <L 17>
        var_57 = wp::int(var_56);
        // bucket = int(0)                                                                        <L 18>
        var_59 = wp::int(var_58);
        // if is_point == 1:                                                                      <L 19>
        var_61 = (var_44 == var_60);
        if (var_61) {
            // position = matches__nearest[row]                                                   <L 20>
            var_62 = wp::address(var_matches__nearest, var_7);
            var_64 = wp::load(var_62);
            var_63 = wp::copy(var_64);
            // lower = remaining_bound(p, q, difference_of(matches__poses[job], matches__earlier[job]), matches__lowers[row])       <L 21>
            var_65 = wp::address(var_matches__poses, var_11);
            var_66 = wp::address(var_matches__earlier, var_11);
            var_68 = wp::load(var_65);
            var_69 = wp::load(var_66);
            var_67 = difference_of_0(var_68, var_69);
            var_70 = wp::address(var_matches__lowers, var_7);
            var_72 = wp::load(var_70);
            var_71 = remaining_bound_0(var_30, var_36, var_67, var_72);
            // distance = sqrt(matches__max_sqdist)                                               <L 22>
            var_73 = wp::sqrt(var_matches__max_sqdist);
            // if position >= 0:                                                                  <L 23>
            var_75 = (var_63 >= var_74);
            if (var_75) {
                // square = square_distance(q, forest__clouds__points[position])                  <L 24>
                var_76 = wp::address(var_forest__clouds__points, var_63);
                var_78 = wp::load(var_76);
                var_77 = square_distance_0(var_36, var_78);
                // distance = sqrt(square)                                                        <L 25>
                var_79 = wp::sqrt(var_77);
                // best = min(best, float_bits(square) + 1)                                       <L 26>
                var_80 = _float_bits_0(var_77);
                var_82 = wp::add(var_80, var_81);
                var_83 = wp::min(var_53, var_82);
                // if square <= matches__max_sqdist:                                              <L 27>
                var_84 = (var_77 <= var_matches__max_sqdist);
                if (var_84) {
                    // pair = position                                                            <L 28>
                    var_85 = wp::copy(var_63);
                }
                var_86 = wp::where(var_84, var_85, var_50);
            }
            var_87 = wp::where(var_75, var_86, var_50);
            var_88 = wp::where(var_75, var_83, var_53);
            var_89 = wp::where(var_75, var_79, var_73);
            // if distance * (1.0 + SLACK) >= lower:                                              <L 29>
            var_92 = wp::add(var_90, var_91);
            var_93 = wp::mul(var_89, var_92);
            var_94 = (var_93 >= var_71);
            if (var_94) {
                // is_searching = 1                                                               <L 30>
                // pair = -1                                                                      <L 31>
                // bucket = position // BUCKET - forest__levels[target * HEIGHTS]                 <L 32>
                var_98 = wp::floordiv(var_63, var_97);
                var_100 = wp::mul(var_23, var_99);
                var_101 = wp::address(var_forest__levels, var_100);
                var_103 = wp::load(var_101);
                var_102 = wp::sub(var_98, var_103);
                // if position < 0:                                                               <L 33>
                var_105 = (var_63 < var_104);
                if (var_105) {
                    // bucket = find_bucket_of(q, target, forest__clouds__codes, forest__clouds__curve__low, forest__clouds__curve__scale, forest__clouds__curve__levels, forest__bucket_counts, forest__levels)       <L 34>
                    var_106 = find_bucket_of_0(var_36, var_23, var_forest__clouds__codes, var_forest__clouds__curve__low, var_forest__clouds__curve__scale, var_forest__clouds__curve__levels, var_forest__bucket_counts, var_forest__levels);
                }
                var_107 = wp::where(var_105, var_106, var_102);
            }
            var_108 = wp::where(var_94, var_96, var_87);
            var_109 = wp::where(var_94, var_95, var_57);
            var_110 = wp::where(var_94, var_107, var_59);
        }
        var_111 = wp::where(var_61, var_71, var_46);
        var_112 = wp::where(var_61, var_63, var_48);
        var_113 = wp::where(var_61, var_108, var_50);
        var_114 = wp::where(var_61, var_88, var_53);
        var_115 = wp::where(var_61, var_109, var_57);
        var_116 = wp::where(var_61, var_110, var_59);
        // searching = ballot(is_searching)                                                       <L 35>
        var_117 = _ballot_0(var_115);
        // while searching != 0:                                                                  <L 36>
        start_while_0:;
        var_119 = (var_117 != var_118);
        if ((var_119) == false) goto end_while_0;
            // leader = lowest_bit(searching)                                                     <L 37>
            var_120 = lowest_bit_0(var_117);
            // shared = shuffle(target, leader)                                                   <L 38>
            var_121 = _shuffle_0(var_23, var_120);
            // limit = float(-1.0)                                                                <L 39>
            var_123 = wp::float(var_122);
            // is_shared = 1 if is_searching == 1 and target == shared else 0                     <L 40>
            var_126 = (var_115 == var_125);
            var_124 = var_126;
            if (var_124) {
                var_127 = (var_23 == var_121);
                var_124 = var_124 && var_127;
            }
            if (var_124) {
            }
            if (!var_124) {
            }
            var_130 = wp::where(var_124, var_128, var_129);
            // if is_shared == 1:                                                                 <L 41>
            var_132 = (var_130 == var_131);
            if (var_132) {
                // limit = limit_beside(best, second, margin)                                     <L 42>
                var_133 = limit_beside_0(var_114, var_55, var_26);
            }
            var_134 = wp::where(var_132, var_133, var_123);
            // searching = searching ^ ballot(is_shared)                                          <L 43>
            var_135 = _ballot_0(var_130);
            var_136 = wp::bit_xor(var_117, var_135);
            // around = boxes_of_eight(q, is_shared)                                              <L 44>
            var_137 = boxes_of_eight_on_cuda_0(var_36, var_130);
            // widest = max_of_eight(limit)                                                       <L 45>
            var_138 = max_of_eight_on_cuda_0(var_134);
            // first_bucket = forest__levels[shared * HEIGHTS]                                    <L 46>
            var_139 = wp::mul(var_121, var_99);
            var_140 = wp::address(var_forest__levels, var_139);
            var_142 = wp::load(var_140);
            var_141 = wp::copy(var_142);
            // step = start_traversal(shuffle(bucket, leader))                                    <L 47>
            var_143 = _shuffle_0(var_116, var_120);
            var_144 = start_traversal_0(var_143);
            // while int(step[0]) <= forest__roots[shared]:                                       <L 48>
        start_while_2:;
            var_146 = wp::extract(var_144, var_145);
            var_147 = wp::int(var_146);
            var_148 = wp::address(var_forest__roots, var_121);
            var_150 = wp::load(var_148);
            var_149 = (var_147 <= var_150);
        if ((var_149) == false) goto end_while_2;
                // record = first_bucket + int(step[2])                                           <L 49>
                var_152 = wp::extract(var_144, var_151);
                var_153 = wp::int(var_152);
                var_154 = wp::add(var_141, var_153);
                // near = nearby_children(forest__boxes, record, around, widest)                  <L 50>
                var_155 = nearby_children_on_cuda_0(var_forest__boxes, var_154, var_137, var_138);
                // left__bits_of__1 = near                                                        <L 51>
                var_156 = wp::copy(var_155);
                // while left__bits_of__1 != 0:                                                   <L 52>
        start_while_4:;
                var_158 = (var_156 != var_157);
        if ((var_158) == false) goto end_while_4;
                    // child = lowest_bit(left__bits_of__1)                                       <L 53>
                    var_159 = lowest_bit_0(var_156);
                    // left__bits_of__1 = left__bits_of__1 & left__bits_of__1 - 1                 <L 54>
                    var_161 = wp::sub(var_156, var_160);
                    var_162 = wp::bit_and(var_156, var_161);
                    // if ballot(1 if measure_box(forest__boxes, record, child, q, q) < limit else 0) != 0:       <L 55>
                    var_163 = measure_box_0(var_forest__boxes, var_154, var_159, var_36, var_36);
                    var_164 = (var_163 < var_134);
                    if (var_164) {
                    }
                    if (!var_164) {
                    }
                    var_167 = wp::where(var_164, var_165, var_166);
                    var_168 = _ballot_0(var_167);
                    var_170 = (var_168 != var_169);
                    if (var_170) {
                        // first = record * BUCKET + child * LEAF                                 <L 56>
                        var_171 = wp::mul(var_154, var_97);
                        var_172 = wp::mul(var_159, var_8);
                        var_173 = wp::add(var_171, var_172);
                        // leaf = load_eight(forest__clouds__points, first)                       <L 57>
                        var_174 = _load_eight_0(var_forest__clouds__points, var_173);
                        // if is_shared == 1:                                                     <L 58>
                        var_176 = (var_130 == var_175);
                        if (var_176) {
                            // for j in range(LEAF):                                              <L 59>
                            // bits = min(float_bits(sqdist_of(leaf, j, q)), LARGEST_BITS)        <L 60>
                            var_178 = sqdist_of_on_cuda_0(var_174, var_177, var_36);
                            var_179 = _float_bits_0(var_178);
                            var_180 = wp::min(var_179, var_54);
                            // if bits < best:                                                    <L 61>
                            var_181 = (var_180 < var_114);
                            if (var_181) {
                                // if pair >= 0:                                                  <L 62>
                                var_183 = (var_113 >= var_182);
                                if (var_183) {
                                    // second = min(second, best)                                 <L 63>
                                    var_184 = wp::min(var_55, var_114);
                                }
                                var_185 = wp::where(var_183, var_184, var_55);
                                // best = bits                                                    <L 64>
                                var_186 = wp::copy(var_180);
                                // pair = first + j                                               <L 65>
                                var_187 = wp::add(var_173, var_177);
                            }
                            if (!var_181) {
                                // second = min(second, bits)                                     <L 67>
                                var_188 = wp::min(var_55, var_180);
                            }
                            var_189 = wp::where(var_181, var_187, var_113);
                            var_190 = wp::where(var_181, var_186, var_114);
                            var_191 = wp::where(var_181, var_185, var_188);
                            // bits = min(float_bits(sqdist_of(leaf, j, q)), LARGEST_BITS)        <L 60>
                            var_193 = sqdist_of_on_cuda_0(var_174, var_192, var_36);
                            var_194 = _float_bits_0(var_193);
                            var_195 = wp::min(var_194, var_54);
                            // if bits < best:                                                    <L 61>
                            var_196 = (var_195 < var_190);
                            if (var_196) {
                                // if pair >= 0:                                                  <L 62>
                                var_198 = (var_189 >= var_197);
                                if (var_198) {
                                    // second = min(second, best)                                 <L 63>
                                    var_199 = wp::min(var_191, var_190);
                                }
                                var_200 = wp::where(var_198, var_199, var_191);
                                // best = bits                                                    <L 64>
                                var_201 = wp::copy(var_195);
                                // pair = first + j                                               <L 65>
                                var_202 = wp::add(var_173, var_192);
                            }
                            if (!var_196) {
                                // second = min(second, bits)                                     <L 67>
                                var_203 = wp::min(var_191, var_195);
                            }
                            var_204 = wp::where(var_196, var_202, var_189);
                            var_205 = wp::where(var_196, var_201, var_190);
                            var_206 = wp::where(var_196, var_200, var_203);
                            // bits = min(float_bits(sqdist_of(leaf, j, q)), LARGEST_BITS)        <L 60>
                            var_208 = sqdist_of_on_cuda_0(var_174, var_207, var_36);
                            var_209 = _float_bits_0(var_208);
                            var_210 = wp::min(var_209, var_54);
                            // if bits < best:                                                    <L 61>
                            var_211 = (var_210 < var_205);
                            if (var_211) {
                                // if pair >= 0:                                                  <L 62>
                                var_213 = (var_204 >= var_212);
                                if (var_213) {
                                    // second = min(second, best)                                 <L 63>
                                    var_214 = wp::min(var_206, var_205);
                                }
                                var_215 = wp::where(var_213, var_214, var_206);
                                // best = bits                                                    <L 64>
                                var_216 = wp::copy(var_210);
                                // pair = first + j                                               <L 65>
                                var_217 = wp::add(var_173, var_207);
                            }
                            if (!var_211) {
                                // second = min(second, bits)                                     <L 67>
                                var_218 = wp::min(var_206, var_210);
                            }
                            var_219 = wp::where(var_211, var_217, var_204);
                            var_220 = wp::where(var_211, var_216, var_205);
                            var_221 = wp::where(var_211, var_215, var_218);
                            // bits = min(float_bits(sqdist_of(leaf, j, q)), LARGEST_BITS)        <L 60>
                            var_223 = sqdist_of_on_cuda_0(var_174, var_222, var_36);
                            var_224 = _float_bits_0(var_223);
                            var_225 = wp::min(var_224, var_54);
                            // if bits < best:                                                    <L 61>
                            var_226 = (var_225 < var_220);
                            if (var_226) {
                                // if pair >= 0:                                                  <L 62>
                                var_228 = (var_219 >= var_227);
                                if (var_228) {
                                    // second = min(second, best)                                 <L 63>
                                    var_229 = wp::min(var_221, var_220);
                                }
                                var_230 = wp::where(var_228, var_229, var_221);
                                // best = bits                                                    <L 64>
                                var_231 = wp::copy(var_225);
                                // pair = first + j                                               <L 65>
                                var_232 = wp::add(var_173, var_222);
                            }
                            if (!var_226) {
                                // second = min(second, bits)                                     <L 67>
                                var_233 = wp::min(var_221, var_225);
                            }
                            var_234 = wp::where(var_226, var_232, var_219);
                            var_235 = wp::where(var_226, var_231, var_220);
                            var_236 = wp::where(var_226, var_230, var_233);
                            // bits = min(float_bits(sqdist_of(leaf, j, q)), LARGEST_BITS)        <L 60>
                            var_238 = sqdist_of_on_cuda_0(var_174, var_237, var_36);
                            var_239 = _float_bits_0(var_238);
                            var_240 = wp::min(var_239, var_54);
                            // if bits < best:                                                    <L 61>
                            var_241 = (var_240 < var_235);
                            if (var_241) {
                                // if pair >= 0:                                                  <L 62>
                                var_243 = (var_234 >= var_242);
                                if (var_243) {
                                    // second = min(second, best)                                 <L 63>
                                    var_244 = wp::min(var_236, var_235);
                                }
                                var_245 = wp::where(var_243, var_244, var_236);
                                // best = bits                                                    <L 64>
                                var_246 = wp::copy(var_240);
                                // pair = first + j                                               <L 65>
                                var_247 = wp::add(var_173, var_237);
                            }
                            if (!var_241) {
                                // second = min(second, bits)                                     <L 67>
                                var_248 = wp::min(var_236, var_240);
                            }
                            var_249 = wp::where(var_241, var_247, var_234);
                            var_250 = wp::where(var_241, var_246, var_235);
                            var_251 = wp::where(var_241, var_245, var_248);
                            // bits = min(float_bits(sqdist_of(leaf, j, q)), LARGEST_BITS)        <L 60>
                            var_253 = sqdist_of_on_cuda_0(var_174, var_252, var_36);
                            var_254 = _float_bits_0(var_253);
                            var_255 = wp::min(var_254, var_54);
                            // if bits < best:                                                    <L 61>
                            var_256 = (var_255 < var_250);
                            if (var_256) {
                                // if pair >= 0:                                                  <L 62>
                                var_258 = (var_249 >= var_257);
                                if (var_258) {
                                    // second = min(second, best)                                 <L 63>
                                    var_259 = wp::min(var_251, var_250);
                                }
                                var_260 = wp::where(var_258, var_259, var_251);
                                // best = bits                                                    <L 64>
                                var_261 = wp::copy(var_255);
                                // pair = first + j                                               <L 65>
                                var_262 = wp::add(var_173, var_252);
                            }
                            if (!var_256) {
                                // second = min(second, bits)                                     <L 67>
                                var_263 = wp::min(var_251, var_255);
                            }
                            var_264 = wp::where(var_256, var_262, var_249);
                            var_265 = wp::where(var_256, var_261, var_250);
                            var_266 = wp::where(var_256, var_260, var_263);
                            // bits = min(float_bits(sqdist_of(leaf, j, q)), LARGEST_BITS)        <L 60>
                            var_268 = sqdist_of_on_cuda_0(var_174, var_267, var_36);
                            var_269 = _float_bits_0(var_268);
                            var_270 = wp::min(var_269, var_54);
                            // if bits < best:                                                    <L 61>
                            var_271 = (var_270 < var_265);
                            if (var_271) {
                                // if pair >= 0:                                                  <L 62>
                                var_273 = (var_264 >= var_272);
                                if (var_273) {
                                    // second = min(second, best)                                 <L 63>
                                    var_274 = wp::min(var_266, var_265);
                                }
                                var_275 = wp::where(var_273, var_274, var_266);
                                // best = bits                                                    <L 64>
                                var_276 = wp::copy(var_270);
                                // pair = first + j                                               <L 65>
                                var_277 = wp::add(var_173, var_267);
                            }
                            if (!var_271) {
                                // second = min(second, bits)                                     <L 67>
                                var_278 = wp::min(var_266, var_270);
                            }
                            var_279 = wp::where(var_271, var_277, var_264);
                            var_280 = wp::where(var_271, var_276, var_265);
                            var_281 = wp::where(var_271, var_275, var_278);
                            // bits = min(float_bits(sqdist_of(leaf, j, q)), LARGEST_BITS)        <L 60>
                            var_283 = sqdist_of_on_cuda_0(var_174, var_282, var_36);
                            var_284 = _float_bits_0(var_283);
                            var_285 = wp::min(var_284, var_54);
                            // if bits < best:                                                    <L 61>
                            var_286 = (var_285 < var_280);
                            if (var_286) {
                                // if pair >= 0:                                                  <L 62>
                                var_288 = (var_279 >= var_287);
                                if (var_288) {
                                    // second = min(second, best)                                 <L 63>
                                    var_289 = wp::min(var_281, var_280);
                                }
                                var_290 = wp::where(var_288, var_289, var_281);
                                // best = bits                                                    <L 64>
                                var_291 = wp::copy(var_285);
                                // pair = first + j                                               <L 65>
                                var_292 = wp::add(var_173, var_282);
                            }
                            if (!var_286) {
                                // second = min(second, bits)                                     <L 67>
                                var_293 = wp::min(var_281, var_285);
                            }
                            var_294 = wp::where(var_286, var_292, var_279);
                            var_295 = wp::where(var_286, var_291, var_280);
                            var_296 = wp::where(var_286, var_290, var_293);
                            // limit = limit_beside(best, second, margin)                         <L 68>
                            var_297 = limit_beside_0(var_295, var_296, var_26);
                        }
                        var_298 = wp::where(var_176, var_294, var_113);
                        var_299 = wp::where(var_176, var_295, var_114);
                        var_300 = wp::where(var_176, var_296, var_55);
                        var_301 = wp::where(var_176, var_297, var_134);
                    }
                    var_302 = wp::where(var_170, var_298, var_113);
                    var_303 = wp::where(var_170, var_299, var_114);
                    var_304 = wp::where(var_170, var_300, var_55);
                    var_305 = wp::where(var_170, var_301, var_134);
                    wp::assign(var_113, var_302);
                    wp::assign(var_114, var_303);
                    wp::assign(var_55, var_304);
                    wp::assign(var_134, var_305);
                    wp::assign(var_156, var_162);
        goto start_while_4;
        end_while_4:;
                // widest = max_of_eight(limit)                                                   <L 69>
                var_306 = max_of_eight_on_cuda_0(var_134);
                // step = next_bucket_of_lanes(step, around, widest, shared, forest__levels, forest__roots, forest__boxes)       <L 70>
                var_307 = next_bucket_of_lanes_on_cuda_1(var_144, var_137, var_306, var_121, var_forest__levels, var_forest__roots, var_forest__boxes);
                wp::assign(var_138, var_306);
                wp::assign(var_144, var_307);
        goto start_while_2;
        end_while_2:;
            // if is_shared == 1:                                                                 <L 71>
            var_309 = (var_130 == var_308);
            if (var_309) {
                // matches__nearest[row] = pair                                                   <L 72>
                wp::array_store(var_matches__nearest, var_7, var_113);
                // lower = sqrt(limit)                                                            <L 73>
                var_310 = wp::sqrt(var_134);
            }
            var_311 = wp::where(var_309, var_310, var_111);
            wp::assign(var_111, var_311);
            wp::assign(var_117, var_136);
        goto start_while_0;
        end_while_0:;
        // if is_live == 1:                                                                       <L 74>
        var_313 = (var_21 == var_312);
        if (var_313) {
            // if is_point == 1:                                                                  <L 75>
            var_315 = (var_44 == var_314);
            if (var_315) {
                // matches__lowers[row] = lower                                                   <L 76>
                wp::array_store(var_matches__lowers, var_7, var_111);
            }
            // matches__pairs[row] = pair                                                         <L 77>
            wp::array_store(var_matches__pairs, var_7, var_113);
        }
}


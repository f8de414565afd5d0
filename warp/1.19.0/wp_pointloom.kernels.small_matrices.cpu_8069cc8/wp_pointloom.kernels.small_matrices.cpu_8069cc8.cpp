#define WP_NO_BFLOAT16

#define WP_TILE_BLOCK_DIM 1
#define WP_NO_CRT
#include "builtin.h"
#include "deterministic.h"

#define builtin_tid1d() wp::linear_tid<wp_linear_tid>(task_index, dim)
#define builtin_tid2d(x, y) wp::tid(x, y, task_index, dim)
#define builtin_tid3d(x, y, z) wp::tid(x, y, z, task_index, dim)
#define builtin_tid4d(x, y, z, w) wp::tid(x, y, z, w, task_index, dim)

#define builtin_block_dim() wp::block_dim()

// Overloads for the CPU code that Warp generates, included after Warp's headers: arrays are contiguous and indices are not
// negative, which saves a multiplication, a comparison and an addition per element. They are more specialized than Warp's.
// If Warp renames its own, they are unused or fail to compile: pool_code.py tests that.

namespace wp {

template <typename T> inline T* address(const array_t<T>& a, int i) { return a.data + i; }
template <typename T> inline T* address(const array_t<T>& a, int i, int j) { return a.data + ((long long)i * a.shape[1] + j); }
template <typename T> inline T* address(const array_t<T>& a, int i, int j, int k)
{
    return a.data + (((long long)i * a.shape[1] + j) * a.shape[2] + k);
}
template <typename T> inline void array_store(const array_t<T>& a, int i, T value) { a.data[i] = value; }
template <typename T> inline void array_store(const array_t<T>& a, int i, int j, T value) { *address(a, i, j) = value; }
template <typename T> inline void array_store(const array_t<T>& a, int i, int j, int k, T value)
{
    *address(a, i, j, k) = value;
}

// Warp's own atomics on the CPU are for one thread: a load, and a store.
template <typename T> inline T shared_add(T* place, T value)
{
    T old, wanted;
    __atomic_load(place, &old, __ATOMIC_RELAXED);
    do wanted = old + value; while (!__atomic_compare_exchange(place, &old, &wanted, true, __ATOMIC_SEQ_CST, __ATOMIC_RELAXED));
    return old;
}
inline int shared_add(int* place, int value) { return __atomic_fetch_add(place, value, __ATOMIC_SEQ_CST); }
inline int64 shared_add(int64* place, int64 value) { return __atomic_fetch_add(place, value, __ATOMIC_SEQ_CST); }
template <typename T> inline T shared_min(T* place, T value)
{
    T old;
    __atomic_load(place, &old, __ATOMIC_RELAXED);
    while (value < old && !__atomic_compare_exchange(place, &old, &value, true, __ATOMIC_SEQ_CST, __ATOMIC_RELAXED)) {}
    return old;
}
template <typename T> inline T shared_max(T* place, T value)
{
    T old;
    __atomic_load(place, &old, __ATOMIC_RELAXED);
    while (old < value && !__atomic_compare_exchange(place, &old, &value, true, __ATOMIC_SEQ_CST, __ATOMIC_RELAXED)) {}
    return old;
}
template <typename T> inline T atomic_add(const array_t<T>& a, int i, T value) { return shared_add(a.data + i, value); }
template <typename T> inline T atomic_min(const array_t<T>& a, int i, T value) { return shared_min(a.data + i, value); }
template <typename T> inline T atomic_max(const array_t<T>& a, int i, T value) { return shared_max(a.data + i, value); }
template <typename T> inline T atomic_add(const array_t<T>& a, int i, int j, T value) { return shared_add(address(a, i, j), value); }
template <typename T> inline T atomic_min(const array_t<T>& a, int i, int j, T value) { return shared_min(address(a, i, j), value); }
template <typename T> inline T atomic_max(const array_t<T>& a, int i, int j, T value) { return shared_max(address(a, i, j), value); }

template <unsigned N, typename T> inline T extract(vec_t<N, T>& v, int i) { return v.c[i]; }
template <unsigned R, unsigned C, typename T> inline T extract(mat_t<R, C, T>& m, int i, int j) { return m.data[i][j]; }

// Warp's version calls a library function for each number.
inline bool is_number(double x) { return x - x == 0.0; }
inline bool is_number(float x) { return x - x == 0.0f; }
template <typename T> inline bool is_number(const T& x) { return true; }
template <unsigned N, typename T> inline bool is_number(const vec_t<N, T>& v)
{
    bool all = true;
    for (unsigned i = 0; i < N; ++i) all = all & (v.c[i] - v.c[i] == T(0));
    return all;
}

// A range constructed in place: a function would return four numbers packed in two 64-bit registers.
struct made_range : range_t {
    inline made_range(int last) { start = 0, end = last, step = 1, i = 0; }
    inline made_range(int first, int last) { start = first, end = last, step = 1, i = first; }
    inline made_range(int first, int last, int by) { start = first, end = last, step = by, i = first; }
};

// A part of a launch: if the highest bit of the extent is set, the others are the part's first thread. Warp itself sets
// the extent, below 2^31, and begins at 0.
template <bool Linear> inline int linear_tid(size_t index, const launch_bounds_t<1>& bounds)
{
    const unsigned first = bounds.shape[0];
    return int(index) + int(first & 0x80000000u ? first & 0x7fffffffu : 0u);
}

}
#define range made_range
#define isfinite is_number
// Warp compiles each body for known and for other strides, and tests `dim->coord_mult == 1 && ...`. One is enough here.
#define coord_mult coord_mult * 0

// avoid namespacing of float type for casting to float type, this is to avoid wp::float(x), which is not valid in C++
#define float(x) cast_float(x)
#define adj_float(x, adj_x, adj_ret) adj_cast_float(x, adj_x, adj_ret)

#define int(x) cast_int(x)
#define adj_int(x, adj_x, adj_ret) adj_cast_int(x, adj_x, adj_ret)


// <pointloom.kernels.small_matrices.scale_down>:1
static wp::float64 scale_down_0(
    wp::int32 var_b,
    wp::int32 var_n,
    wp::array_t<wp::float64> var_p__matrices,
    wp::array_t<wp::float64> var_p__rows)
{
    //---------
    // primal vars
    wp::float64 var_0;
    const wp::int32 var_1 = 0;
    wp::int32 var_2;
    wp::range_t var_3;
    wp::int32 var_4;
    wp::range_t var_5;
    wp::int32 var_6;
    wp::float64* var_7;
    wp::float64 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::float64* var_11;
    bool var_12;
    wp::float64 var_13;
    bool var_14;
    const wp::int32 var_15 = 1;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::float64 var_18;
    bool var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::range_t var_22;
    wp::int32 var_23;
    wp::range_t var_24;
    wp::int32 var_25;
    wp::float64* var_26;
    wp::float64 var_27;
    wp::float64 var_28;
    bool var_29;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 0;
    bool var_34;
    wp::float64 var_35;
    wp::float64 var_36;
    //---------
    // forward
    // def scale_down(b, n, p__matrices, p__rows):                                            <L 1>
    // size = float64(0.0)                                                                    <L 3>
    var_0 = 0.0;
    // faults = int(0)                                                                        <L 4>
    var_2 = wp::int(var_1);
    // for i in range(n):                                                                     <L 5>
    var_3 = wp::range(var_n);
    start_for_0:;
        if (iter_cmp(var_3) == 0) goto end_for_0;
        var_4 = wp::iter_next(var_3);
        // for j in range(n):                                                                 <L 6>
        var_5 = wp::range(var_n);
        start_for_2:;
            if (iter_cmp(var_5) == 0) goto end_for_2;
            var_6 = wp::iter_next(var_5);
            // size = max(size, abs(p__matrices[b, i, j]))                                    <L 7>
            var_7 = wp::address(var_p__matrices, var_b, var_4, var_6);
            var_9 = wp::load(var_7);
            var_8 = wp::abs(var_9);
            var_10 = wp::max(var_0, var_8);
            // if not isfinite(p__matrices[b, i, j]):                                         <L 8>
            var_11 = wp::address(var_p__matrices, var_b, var_4, var_6);
            var_13 = wp::load(var_11);
            var_12 = wp::isfinite(var_13);
            var_14 = wp::unot(var_12);
            if (var_14) {
                // faults += 1                                                                <L 9>
                var_16 = wp::add(var_2, var_15);
            }
            var_17 = wp::where(var_14, var_16, var_2);
            wp::assign(var_0, var_10);
            wp::assign(var_2, var_17);
            goto start_for_2;
        end_for_2:;
        goto start_for_0;
    end_for_0:;
    // divisor = size if size > float64(0.0) else float64(1.0)                                <L 10>
    var_18 = 0.0;
    var_19 = (var_0 > var_18);
    if (var_19) {
    }
    if (!var_19) {
        var_20 = 1.0;
    }
    var_21 = wp::where(var_19, var_0, var_20);
    // for i in range(n):                                                                     <L 11>
    var_22 = wp::range(var_n);
    start_for_4:;
        if (iter_cmp(var_22) == 0) goto end_for_4;
        var_23 = wp::iter_next(var_22);
        // for j in range(n):                                                                 <L 12>
        var_24 = wp::range(var_n);
        start_for_6:;
            if (iter_cmp(var_24) == 0) goto end_for_6;
            var_25 = wp::iter_next(var_24);
            // p__matrices[b, i, j] = p__matrices[b, i, j] / divisor                          <L 13>
            var_26 = wp::address(var_p__matrices, var_b, var_23, var_25);
            var_28 = wp::load(var_26);
            var_27 = wp::div(var_28, var_21);
            wp::array_store(var_p__matrices, var_b, var_23, var_25, var_27);
            // p__rows[b, i, j] = float64(1.0) if i == j else float64(0.0)                    <L 14>
            var_29 = (var_23 == var_25);
            if (var_29) {
                var_30 = 1.0;
            }
            if (!var_29) {
                var_31 = 0.0;
            }
            var_32 = wp::where(var_29, var_30, var_31);
            wp::array_store(var_p__rows, var_b, var_23, var_25, var_32);
            goto start_for_6;
        end_for_6:;
        wp::assign(var_6, var_25);
        goto start_for_4;
    end_for_4:;
    // return size if faults == 0 else float64(-1.0)                                          <L 15>
    var_34 = (var_2 == var_33);
    if (var_34) {
    }
    if (!var_34) {
        var_35 = -1.0;
    }
    var_36 = wp::where(var_34, var_0, var_35);
    return var_36;
}


// <pointloom.kernels.small_matrices.copied_sign>:1
static wp::float64 copied_sign_0(
    wp::float64 var_size,
    wp::float64 var_sign)
{
    //---------
    // primal vars
    wp::float64 var_0;
    bool var_1;
    wp::float64 var_2;
    bool var_3;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    bool var_7;
    bool var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    //---------
    // forward
    // def copied_sign(size, sign):                                                           <L 1>
    // is_negative = sign < float64(0.0)                                                      <L 2>
    var_0 = 0.0;
    var_1 = (var_sign < var_0);
    // if sign == float64(0.0):                                                               <L 3>
    var_2 = 0.0;
    var_3 = (var_sign == var_2);
    if (var_3) {
        // is_negative = float64(1.0) / sign < float64(0.0)                                   <L 4>
        var_4 = 1.0;
        var_5 = wp::div(var_4, var_sign);
        var_6 = 0.0;
        var_7 = (var_5 < var_6);
    }
    var_8 = wp::where(var_3, var_7, var_1);
    // return -size if is_negative else size                                                  <L 5>
    if (var_8) {
        var_9 = wp::neg(var_size);
    }
    if (!var_8) {
    }
    var_10 = wp::where(var_8, var_9, var_size);
    return var_10;
}


// <pointloom.kernels.small_matrices.reflect>:1
static wp::int32 reflect_0(
    wp::int32 var_b,
    wp::int32 var_k,
    wp::int32 var_n,
    wp::array_t<wp::float64> var_p__matrices,
    wp::array_t<wp::float64> var_p__rows,
    wp::array_t<wp::float64> var_p__beside)
{
    //---------
    // primal vars
    wp::float64 var_0;
    const wp::int32 var_1 = 1;
    wp::int32 var_2;
    wp::range_t var_3;
    wp::int32 var_4;
    wp::float64* var_5;
    wp::float64* var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    const wp::int32 var_12 = 1;
    wp::int32 var_13;
    wp::float64* var_14;
    wp::float64 var_15;
    wp::float64 var_16;
    wp::float64 var_17;
    bool var_18;
    const wp::int32 var_19 = 1;
    wp::int32 var_20;
    wp::range_t var_21;
    wp::int32 var_22;
    wp::float64* var_23;
    wp::float64 var_24;
    wp::float64 var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    const wp::int32 var_28 = 1;
    wp::int32 var_29;
    wp::float64 var_30;
    const wp::int32 var_31 = 1;
    wp::int32 var_32;
    wp::range_t var_33;
    wp::int32 var_34;
    wp::float64* var_35;
    wp::float64* var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    wp::float64 var_39;
    wp::float64 var_40;
    wp::float64 var_41;
    const wp::int32 var_42 = 1;
    wp::int32 var_43;
    wp::range_t var_44;
    wp::int32 var_45;
    wp::float64* var_46;
    wp::float64 var_47;
    wp::float64 var_48;
    wp::range_t var_49;
    wp::int32 var_50;
    wp::float64 var_51;
    const wp::int32 var_52 = 1;
    wp::int32 var_53;
    wp::range_t var_54;
    wp::int32 var_55;
    wp::float64* var_56;
    wp::float64* var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float64 var_60;
    wp::float64 var_61;
    const wp::int32 var_62 = 1;
    wp::int32 var_63;
    wp::range_t var_64;
    wp::int32 var_65;
    wp::float64* var_66;
    wp::float64 var_67;
    wp::float64* var_68;
    wp::float64 var_69;
    wp::float64 var_70;
    wp::float64 var_71;
    wp::float64 var_72;
    wp::float64 var_73;
    wp::range_t var_74;
    wp::int32 var_75;
    wp::float64 var_76;
    const wp::int32 var_77 = 1;
    wp::int32 var_78;
    wp::range_t var_79;
    wp::int32 var_80;
    wp::float64* var_81;
    wp::float64* var_82;
    wp::float64 var_83;
    wp::float64 var_84;
    wp::float64 var_85;
    wp::float64 var_86;
    const wp::int32 var_87 = 1;
    wp::int32 var_88;
    wp::range_t var_89;
    wp::int32 var_90;
    wp::float64* var_91;
    wp::float64 var_92;
    wp::float64 var_93;
    wp::float64* var_94;
    wp::float64 var_95;
    wp::float64 var_96;
    wp::float64 var_97;
    wp::float64 var_98;
    wp::range_t var_99;
    wp::int32 var_100;
    wp::float64 var_101;
    const wp::int32 var_102 = 1;
    wp::int32 var_103;
    wp::range_t var_104;
    wp::int32 var_105;
    wp::float64* var_106;
    wp::float64* var_107;
    wp::float64 var_108;
    wp::float64 var_109;
    wp::float64 var_110;
    wp::float64 var_111;
    const wp::int32 var_112 = 1;
    wp::int32 var_113;
    wp::range_t var_114;
    wp::int32 var_115;
    wp::float64* var_116;
    wp::float64 var_117;
    wp::float64* var_118;
    wp::float64 var_119;
    wp::float64 var_120;
    wp::float64 var_121;
    wp::float64 var_122;
    wp::float64 var_123;
    wp::float64 var_124;
    wp::int32 var_125;
    wp::float64 var_126;
    //---------
    // forward
    // def reflect(b, k, n, p__matrices, p__rows, p__beside):                                 <L 1>
    // square = float64(0.0)                                                                  <L 3>
    var_0 = 0.0;
    // for i in range(k + 1, n):                                                              <L 4>
    var_2 = wp::add(var_k, var_1);
    var_3 = wp::range(var_2, var_n);
    start_for_0:;
        if (iter_cmp(var_3) == 0) goto end_for_0;
        var_4 = wp::iter_next(var_3);
        // square += p__matrices[b, i, k] * p__matrices[b, i, k]                              <L 5>
        var_5 = wp::address(var_p__matrices, var_b, var_4, var_k);
        var_6 = wp::address(var_p__matrices, var_b, var_4, var_k);
        var_8 = wp::load(var_5);
        var_9 = wp::load(var_6);
        var_7 = wp::mul(var_8, var_9);
        var_10 = wp::add(var_0, var_7);
        wp::assign(var_0, var_10);
        goto start_for_0;
    end_for_0:;
    // length = sqrt(square)                                                                  <L 6>
    var_11 = wp::sqrt(var_0);
    // first = p__matrices[b, k + 1, k]                                                       <L 7>
    var_13 = wp::add(var_k, var_12);
    var_14 = wp::address(var_p__matrices, var_b, var_13, var_k);
    var_16 = wp::load(var_14);
    var_15 = wp::copy(var_16);
    // if length > abs(first):                                                                <L 8>
    var_17 = wp::abs(var_15);
    var_18 = (var_11 > var_17);
    if (var_18) {
        // for i in range(k + 1, n):                                                          <L 9>
        var_20 = wp::add(var_k, var_19);
        var_21 = wp::range(var_20, var_n);
        start_for_2:;
            if (iter_cmp(var_21) == 0) goto end_for_2;
            var_22 = wp::iter_next(var_21);
            // p__beside[b, i] = p__matrices[b, i, k]                                         <L 10>
            var_23 = wp::address(var_p__matrices, var_b, var_22, var_k);
            var_25 = wp::load(var_23);
            var_24 = wp::copy(var_25);
            wp::array_store(var_p__beside, var_b, var_22, var_24);
            goto start_for_2;
        end_for_2:;
        // p__beside[b, k + 1] = first + copied_sign(length, first)                           <L 11>
        var_26 = copied_sign_0(var_11, var_15);
        var_27 = wp::add(var_15, var_26);
        var_29 = wp::add(var_k, var_28);
        wp::array_store(var_p__beside, var_b, var_29, var_27);
        // square = float64(0.0)                                                              <L 12>
        var_30 = 0.0;
        // for i in range(k + 1, n):                                                          <L 13>
        var_32 = wp::add(var_k, var_31);
        var_33 = wp::range(var_32, var_n);
        start_for_4:;
            if (iter_cmp(var_33) == 0) goto end_for_4;
            var_34 = wp::iter_next(var_33);
            // square += p__beside[b, i] * p__beside[b, i]                                    <L 14>
            var_35 = wp::address(var_p__beside, var_b, var_34);
            var_36 = wp::address(var_p__beside, var_b, var_34);
            var_38 = wp::load(var_35);
            var_39 = wp::load(var_36);
            var_37 = wp::mul(var_38, var_39);
            var_40 = wp::add(var_30, var_37);
            wp::assign(var_30, var_40);
            goto start_for_4;
        end_for_4:;
        // length = sqrt(square)                                                              <L 15>
        var_41 = wp::sqrt(var_30);
        // for i in range(k + 1, n):                                                          <L 16>
        var_43 = wp::add(var_k, var_42);
        var_44 = wp::range(var_43, var_n);
        start_for_6:;
            if (iter_cmp(var_44) == 0) goto end_for_6;
            var_45 = wp::iter_next(var_44);
            // p__beside[b, i] = p__beside[b, i] / length                                     <L 17>
            var_46 = wp::address(var_p__beside, var_b, var_45);
            var_48 = wp::load(var_46);
            var_47 = wp::div(var_48, var_41);
            wp::array_store(var_p__beside, var_b, var_45, var_47);
            goto start_for_6;
        end_for_6:;
        // for j in range(k, n):                                                              <L 18>
        var_49 = wp::range(var_k, var_n);
        start_for_8:;
            if (iter_cmp(var_49) == 0) goto end_for_8;
            var_50 = wp::iter_next(var_49);
            // total = float64(0.0)                                                           <L 19>
            var_51 = 0.0;
            // for i in range(k + 1, n):                                                      <L 20>
            var_53 = wp::add(var_k, var_52);
            var_54 = wp::range(var_53, var_n);
            start_for_10:;
                if (iter_cmp(var_54) == 0) goto end_for_10;
                var_55 = wp::iter_next(var_54);
                // total += p__beside[b, i] * p__matrices[b, i, j]                            <L 21>
                var_56 = wp::address(var_p__beside, var_b, var_55);
                var_57 = wp::address(var_p__matrices, var_b, var_55, var_50);
                var_59 = wp::load(var_56);
                var_60 = wp::load(var_57);
                var_58 = wp::mul(var_59, var_60);
                var_61 = wp::add(var_51, var_58);
                wp::assign(var_51, var_61);
                goto start_for_10;
            end_for_10:;
            // for i in range(k + 1, n):                                                      <L 22>
            var_63 = wp::add(var_k, var_62);
            var_64 = wp::range(var_63, var_n);
            start_for_12:;
                if (iter_cmp(var_64) == 0) goto end_for_12;
                var_65 = wp::iter_next(var_64);
                // p__matrices[b, i, j] = p__matrices[b, i, j] - float64(2.0) * p__beside[b, i] * total       <L 23>
                var_66 = wp::address(var_p__matrices, var_b, var_65, var_50);
                var_67 = 2.0;
                var_68 = wp::address(var_p__beside, var_b, var_65);
                var_70 = wp::load(var_68);
                var_69 = wp::mul(var_67, var_70);
                var_71 = wp::mul(var_69, var_51);
                var_73 = wp::load(var_66);
                var_72 = wp::sub(var_73, var_71);
                wp::array_store(var_p__matrices, var_b, var_65, var_50, var_72);
                goto start_for_12;
            end_for_12:;
            wp::assign(var_45, var_65);
            goto start_for_8;
        end_for_8:;
        // for i in range(k, n):                                                              <L 24>
        var_74 = wp::range(var_k, var_n);
        start_for_14:;
            if (iter_cmp(var_74) == 0) goto end_for_14;
            var_75 = wp::iter_next(var_74);
            // total = float64(0.0)                                                           <L 25>
            var_76 = 0.0;
            // for j in range(k + 1, n):                                                      <L 26>
            var_78 = wp::add(var_k, var_77);
            var_79 = wp::range(var_78, var_n);
            start_for_16:;
                if (iter_cmp(var_79) == 0) goto end_for_16;
                var_80 = wp::iter_next(var_79);
                // total += p__matrices[b, i, j] * p__beside[b, j]                            <L 27>
                var_81 = wp::address(var_p__matrices, var_b, var_75, var_80);
                var_82 = wp::address(var_p__beside, var_b, var_80);
                var_84 = wp::load(var_81);
                var_85 = wp::load(var_82);
                var_83 = wp::mul(var_84, var_85);
                var_86 = wp::add(var_76, var_83);
                wp::assign(var_76, var_86);
                goto start_for_16;
            end_for_16:;
            // for j in range(k + 1, n):                                                      <L 28>
            var_88 = wp::add(var_k, var_87);
            var_89 = wp::range(var_88, var_n);
            start_for_18:;
                if (iter_cmp(var_89) == 0) goto end_for_18;
                var_90 = wp::iter_next(var_89);
                // p__matrices[b, i, j] = p__matrices[b, i, j] - float64(2.0) * total * p__beside[b, j]       <L 29>
                var_91 = wp::address(var_p__matrices, var_b, var_75, var_90);
                var_92 = 2.0;
                var_93 = wp::mul(var_92, var_76);
                var_94 = wp::address(var_p__beside, var_b, var_90);
                var_96 = wp::load(var_94);
                var_95 = wp::mul(var_93, var_96);
                var_98 = wp::load(var_91);
                var_97 = wp::sub(var_98, var_95);
                wp::array_store(var_p__matrices, var_b, var_75, var_90, var_97);
                goto start_for_18;
            end_for_18:;
            wp::assign(var_50, var_90);
            wp::assign(var_51, var_76);
            goto start_for_14;
        end_for_14:;
        // for j in range(n):                                                                 <L 30>
        var_99 = wp::range(var_n);
        start_for_20:;
            if (iter_cmp(var_99) == 0) goto end_for_20;
            var_100 = wp::iter_next(var_99);
            // total = float64(0.0)                                                           <L 31>
            var_101 = 0.0;
            // for i in range(k + 1, n):                                                      <L 32>
            var_103 = wp::add(var_k, var_102);
            var_104 = wp::range(var_103, var_n);
            start_for_22:;
                if (iter_cmp(var_104) == 0) goto end_for_22;
                var_105 = wp::iter_next(var_104);
                // total += p__beside[b, i] * p__rows[b, i, j]                                <L 33>
                var_106 = wp::address(var_p__beside, var_b, var_105);
                var_107 = wp::address(var_p__rows, var_b, var_105, var_100);
                var_109 = wp::load(var_106);
                var_110 = wp::load(var_107);
                var_108 = wp::mul(var_109, var_110);
                var_111 = wp::add(var_101, var_108);
                wp::assign(var_101, var_111);
                goto start_for_22;
            end_for_22:;
            // for i in range(k + 1, n):                                                      <L 34>
            var_113 = wp::add(var_k, var_112);
            var_114 = wp::range(var_113, var_n);
            start_for_24:;
                if (iter_cmp(var_114) == 0) goto end_for_24;
                var_115 = wp::iter_next(var_114);
                // p__rows[b, i, j] = p__rows[b, i, j] - float64(2.0) * p__beside[b, i] * total       <L 35>
                var_116 = wp::address(var_p__rows, var_b, var_115, var_100);
                var_117 = 2.0;
                var_118 = wp::address(var_p__beside, var_b, var_115);
                var_120 = wp::load(var_118);
                var_119 = wp::mul(var_117, var_120);
                var_121 = wp::mul(var_119, var_101);
                var_123 = wp::load(var_116);
                var_122 = wp::sub(var_123, var_121);
                wp::array_store(var_p__rows, var_b, var_115, var_100, var_122);
                goto start_for_24;
            end_for_24:;
            wp::assign(var_75, var_115);
            wp::assign(var_51, var_101);
            goto start_for_20;
        end_for_20:;
    }
    var_124 = wp::where(var_18, var_30, var_0);
    var_125 = wp::where(var_18, var_75, var_4);
    var_126 = wp::where(var_18, var_41, var_11);
    // return k                                                                               <L 36>
    return var_k;
}


// <pointloom.kernels.small_matrices.is_divided>:1
static bool is_divided_0(
    wp::int32 var_b,
    wp::int32 var_i,
    wp::array_t<wp::float64> var_p__values,
    wp::array_t<wp::float64> var_p__beside)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64* var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    const wp::int32 var_4 = 1;
    wp::int32 var_5;
    wp::float64* var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    wp::float64* var_13;
    wp::float64 var_14;
    wp::float64 var_15;
    bool var_16;
    bool var_17;
    //---------
    // forward
    // def is_divided(b, i, p__values, p__beside):                                            <L 1>
    // limit = max(float64(EPSILON) * (abs(p__values[b, i]) + abs(p__values[b, i + 1])), float64(NEGLIGIBLE))       <L 3>
    var_0 = 2.220446049250313e-16;
    var_1 = wp::address(var_p__values, var_b, var_i);
    var_3 = wp::load(var_1);
    var_2 = wp::abs(var_3);
    var_5 = wp::add(var_i, var_4);
    var_6 = wp::address(var_p__values, var_b, var_5);
    var_8 = wp::load(var_6);
    var_7 = wp::abs(var_8);
    var_9 = wp::add(var_2, var_7);
    var_10 = wp::mul(var_0, var_9);
    var_11 = 1e-30;
    var_12 = wp::max(var_10, var_11);
    // return not abs(p__beside[b, i]) > limit                                                <L 4>
    var_13 = wp::address(var_p__beside, var_b, var_i);
    var_15 = wp::load(var_13);
    var_14 = wp::abs(var_15);
    var_16 = (var_14 > var_12);
    var_17 = wp::unot(var_16);
    return var_17;
}


// <pointloom.kernels.small_matrices.end_of_block>:1
static wp::int32 end_of_block_0(
    wp::int32 var_b,
    wp::int32 var_first,
    wp::int32 var_n,
    wp::array_t<wp::float64> var_p__values,
    wp::array_t<wp::float64> var_p__beside)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::range_t var_4;
    wp::int32 var_5;
    bool var_6;
    bool var_7;
    bool var_8;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    //---------
    // forward
    // def end_of_block(b, first, n, p__values, p__beside):                                   <L 1>
    // last = first + 0                                                                       <L 3>
    var_1 = wp::add(var_first, var_0);
    // for i in range(first, n - 1):                                                          <L 4>
    var_3 = wp::sub(var_n, var_2);
    var_4 = wp::range(var_first, var_3);
    start_for_0:;
        if (iter_cmp(var_4) == 0) goto end_for_0;
        var_5 = wp::iter_next(var_4);
        // if last == i:                                                                      <L 5>
        var_6 = (var_1 == var_5);
        if (var_6) {
            // if not is_divided(b, i, p__values, p__beside):                                 <L 6>
            var_7 = is_divided_0(var_b, var_5, var_p__values, var_p__beside);
            var_8 = wp::unot(var_7);
            if (var_8) {
                // last = i + 1                                                               <L 7>
                var_10 = wp::add(var_5, var_9);
            }
            var_11 = wp::where(var_8, var_10, var_1);
        }
        var_12 = wp::where(var_6, var_11, var_1);
        wp::assign(var_1, var_12);
        goto start_for_0;
    end_for_0:;
    // return last                                                                            <L 8>
    return var_1;
}


// <pointloom.kernels.small_matrices.rotate>:1
static wp::int32 rotate_0(
    wp::int32 var_b,
    wp::int32 var_first,
    wp::int32 var_last,
    wp::array_t<wp::float64> var_p__matrices,
    wp::array_t<wp::float64> var_p__rows,
    wp::array_t<wp::float64> var_p__values,
    wp::array_t<wp::float64> var_p__beside)
{
    //---------
    // primal vars
    wp::shape_t* var_0;
    const wp::int32 var_1 = 1;
    wp::int32 var_2;
    wp::shape_t var_3;
    const wp::int32 var_4 = 1;
    wp::int32 var_5;
    wp::float64* var_6;
    wp::float64* var_7;
    wp::float64 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float64* var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    wp::float64 var_15;
    wp::float64 var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::float64* var_21;
    wp::float64* var_22;
    wp::float64 var_23;
    wp::float64 var_24;
    wp::float64 var_25;
    wp::float64* var_26;
    wp::float64 var_27;
    wp::float64 var_28;
    wp::float64 var_29;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    wp::float64 var_33;
    const wp::int32 var_34 = 1;
    wp::int32 var_35;
    bool var_36;
    wp::float64* var_37;
    wp::float64 var_38;
    wp::float64 var_39;
    wp::float64* var_40;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    wp::float64 var_44;
    wp::float64 var_45;
    wp::float64 var_46;
    const wp::int32 var_47 = 1;
    wp::int32 var_48;
    wp::float64 var_49;
    bool var_50;
    const wp::int32 var_51 = 1;
    wp::int32 var_52;
    wp::float64* var_53;
    wp::float64 var_54;
    wp::float64 var_55;
    const wp::int32 var_56 = 1;
    wp::int32 var_57;
    wp::float64 var_58;
    const wp::int32 var_59 = -2;
    wp::float64 var_60;
    wp::float64 var_61;
    const wp::int32 var_62 = 1;
    wp::int32 var_63;
    wp::float64* var_64;
    wp::float64 var_65;
    wp::float64 var_66;
    wp::float64* var_67;
    wp::float64 var_68;
    wp::float64 var_69;
    wp::float64 var_70;
    wp::float64 var_71;
    wp::float64 var_72;
    wp::float64 var_73;
    wp::float64 var_74;
    wp::float64 var_75;
    wp::float64 var_76;
    const wp::int32 var_77 = 1;
    wp::int32 var_78;
    wp::float64 var_79;
    wp::float64 var_80;
    wp::range_t var_81;
    wp::int32 var_82;
    wp::float64* var_83;
    wp::float64 var_84;
    wp::float64 var_85;
    const wp::int32 var_86 = 1;
    wp::int32 var_87;
    wp::float64* var_88;
    wp::float64 var_89;
    wp::float64 var_90;
    wp::float64 var_91;
    wp::float64 var_92;
    wp::float64 var_93;
    const wp::int32 var_94 = 1;
    wp::int32 var_95;
    wp::float64 var_96;
    wp::float64 var_97;
    wp::float64 var_98;
    const wp::int32 var_99 = 1;
    wp::int32 var_100;
    wp::float64 var_101;
    wp::float64 var_102;
    wp::float64 var_103;
    wp::float64 var_104;
    wp::int32 var_105;
    wp::float64 var_106;
    const wp::int32 var_107 = 1;
    wp::int32 var_108;
    bool var_109;
    wp::float64* var_110;
    wp::float64 var_111;
    wp::float64 var_112;
    wp::float64 var_113;
    //---------
    // forward
    // def rotate(b, first, last, p__matrices, p__rows, p__values, p__beside):                <L 1>
    // n = p__matrices.shape[1]                                                               <L 3>
    var_0 = &(var_p__matrices.shape);
    var_3 = wp::load(var_0);
    var_2 = wp::extract(var_3, var_1);
    // g = (p__values[b, first + 1] - p__values[b, first]) / (float64(2.0) * p__beside[b, first])       <L 4>
    var_5 = wp::add(var_first, var_4);
    var_6 = wp::address(var_p__values, var_b, var_5);
    var_7 = wp::address(var_p__values, var_b, var_first);
    var_9 = wp::load(var_6);
    var_10 = wp::load(var_7);
    var_8 = wp::sub(var_9, var_10);
    var_11 = 2.0;
    var_12 = wp::address(var_p__beside, var_b, var_first);
    var_14 = wp::load(var_12);
    var_13 = wp::mul(var_11, var_14);
    var_15 = wp::div(var_8, var_13);
    // root = copied_sign(sqrt(g * g + float64(1.0)), g)                                      <L 5>
    var_16 = wp::mul(var_15, var_15);
    var_17 = 1.0;
    var_18 = wp::add(var_16, var_17);
    var_19 = wp::sqrt(var_18);
    var_20 = copied_sign_0(var_19, var_15);
    // g = p__values[b, last] - p__values[b, first] + p__beside[b, first] / (g + root)        <L 6>
    var_21 = wp::address(var_p__values, var_b, var_last);
    var_22 = wp::address(var_p__values, var_b, var_first);
    var_24 = wp::load(var_21);
    var_25 = wp::load(var_22);
    var_23 = wp::sub(var_24, var_25);
    var_26 = wp::address(var_p__beside, var_b, var_first);
    var_27 = wp::add(var_15, var_20);
    var_29 = wp::load(var_26);
    var_28 = wp::div(var_29, var_27);
    var_30 = wp::add(var_23, var_28);
    // sine = float64(1.0)                                                                    <L 7>
    var_31 = 1.0;
    // cosine = float64(1.0)                                                                  <L 8>
    var_32 = 1.0;
    // shift = float64(0.0)                                                                   <L 9>
    var_33 = 0.0;
    // i = last - 1                                                                           <L 10>
    var_35 = wp::sub(var_last, var_34);
    // while i >= first:                                                                      <L 11>
    start_while_0:;
    var_36 = (var_35 >= var_first);
    if ((var_36) == false) goto end_while_0;
        // f = sine * p__beside[b, i]                                                         <L 12>
        var_37 = wp::address(var_p__beside, var_b, var_35);
        var_39 = wp::load(var_37);
        var_38 = wp::mul(var_31, var_39);
        // h = cosine * p__beside[b, i]                                                       <L 13>
        var_40 = wp::address(var_p__beside, var_b, var_35);
        var_42 = wp::load(var_40);
        var_41 = wp::mul(var_32, var_42);
        // r = sqrt(f * f + g * g)                                                            <L 14>
        var_43 = wp::mul(var_38, var_38);
        var_44 = wp::mul(var_30, var_30);
        var_45 = wp::add(var_43, var_44);
        var_46 = wp::sqrt(var_45);
        // p__beside[b, i + 1] = r                                                            <L 15>
        var_48 = wp::add(var_35, var_47);
        wp::array_store(var_p__beside, var_b, var_48, var_46);
        // if r == float64(0.0):                                                              <L 16>
        var_49 = 0.0;
        var_50 = (var_46 == var_49);
        if (var_50) {
            // p__values[b, i + 1] = p__values[b, i + 1] - shift                              <L 17>
            var_52 = wp::add(var_35, var_51);
            var_53 = wp::address(var_p__values, var_b, var_52);
            var_55 = wp::load(var_53);
            var_54 = wp::sub(var_55, var_33);
            var_57 = wp::add(var_35, var_56);
            wp::array_store(var_p__values, var_b, var_57, var_54);
            // p__beside[b, last] = float64(0.0)                                              <L 18>
            var_58 = 0.0;
            wp::array_store(var_p__beside, var_b, var_last, var_58);
            // i = -2                                                                         <L 19>
        }
        if (!var_50) {
            // sine = f / r                                                                   <L 21>
            var_60 = wp::div(var_38, var_46);
            // cosine = g / r                                                                 <L 22>
            var_61 = wp::div(var_30, var_46);
            // g = p__values[b, i + 1] - shift                                                <L 23>
            var_63 = wp::add(var_35, var_62);
            var_64 = wp::address(var_p__values, var_b, var_63);
            var_66 = wp::load(var_64);
            var_65 = wp::sub(var_66, var_33);
            // r = (p__values[b, i] - g) * sine + float64(2.0) * cosine * h                   <L 24>
            var_67 = wp::address(var_p__values, var_b, var_35);
            var_69 = wp::load(var_67);
            var_68 = wp::sub(var_69, var_65);
            var_70 = wp::mul(var_68, var_60);
            var_71 = 2.0;
            var_72 = wp::mul(var_71, var_61);
            var_73 = wp::mul(var_72, var_41);
            var_74 = wp::add(var_70, var_73);
            // shift = sine * r                                                               <L 25>
            var_75 = wp::mul(var_60, var_74);
            // p__values[b, i + 1] = g + shift                                                <L 26>
            var_76 = wp::add(var_65, var_75);
            var_78 = wp::add(var_35, var_77);
            wp::array_store(var_p__values, var_b, var_78, var_76);
            // g = cosine * r - h                                                             <L 27>
            var_79 = wp::mul(var_61, var_74);
            var_80 = wp::sub(var_79, var_41);
            // for j in range(n):                                                             <L 28>
            var_81 = wp::range(var_2);
            start_for_2:;
                if (iter_cmp(var_81) == 0) goto end_for_2;
                var_82 = wp::iter_next(var_81);
                // above = p__rows[b, i, j]                                                   <L 29>
                var_83 = wp::address(var_p__rows, var_b, var_35, var_82);
                var_85 = wp::load(var_83);
                var_84 = wp::copy(var_85);
                // below = p__rows[b, i + 1, j]                                               <L 30>
                var_87 = wp::add(var_35, var_86);
                var_88 = wp::address(var_p__rows, var_b, var_87, var_82);
                var_90 = wp::load(var_88);
                var_89 = wp::copy(var_90);
                // p__rows[b, i + 1, j] = sine * above + cosine * below                       <L 31>
                var_91 = wp::mul(var_60, var_84);
                var_92 = wp::mul(var_61, var_89);
                var_93 = wp::add(var_91, var_92);
                var_95 = wp::add(var_35, var_94);
                wp::array_store(var_p__rows, var_b, var_95, var_82, var_93);
                // p__rows[b, i, j] = cosine * above - sine * below                           <L 32>
                var_96 = wp::mul(var_61, var_84);
                var_97 = wp::mul(var_60, var_89);
                var_98 = wp::sub(var_96, var_97);
                wp::array_store(var_p__rows, var_b, var_35, var_82, var_98);
                goto start_for_2;
            end_for_2:;
            // i -= 1                                                                         <L 33>
            var_100 = wp::sub(var_35, var_99);
        }
        var_101 = wp::where(var_50, var_30, var_80);
        var_102 = wp::where(var_50, var_31, var_60);
        var_103 = wp::where(var_50, var_32, var_61);
        var_104 = wp::where(var_50, var_33, var_75);
        var_105 = wp::where(var_50, var_59, var_100);
        var_106 = wp::where(var_50, var_46, var_74);
        wp::assign(var_30, var_101);
        wp::assign(var_31, var_102);
        wp::assign(var_32, var_103);
        wp::assign(var_33, var_104);
        wp::assign(var_35, var_105);
    goto start_while_0;
    end_while_0:;
    // if i == first - 1:                                                                     <L 34>
    var_108 = wp::sub(var_first, var_107);
    var_109 = (var_35 == var_108);
    if (var_109) {
        // p__values[b, first] = p__values[b, first] - shift                                  <L 35>
        var_110 = wp::address(var_p__values, var_b, var_first);
        var_112 = wp::load(var_110);
        var_111 = wp::sub(var_112, var_33);
        wp::array_store(var_p__values, var_b, var_first, var_111);
        // p__beside[b, first] = g                                                            <L 36>
        wp::array_store(var_p__beside, var_b, var_first, var_30);
        // p__beside[b, last] = float64(0.0)                                                  <L 37>
        var_113 = 0.0;
        wp::array_store(var_p__beside, var_b, var_last, var_113);
    }
    // return i                                                                               <L 38>
    return var_35;
}


// <pointloom.kernels.small_matrices.diagonalize>:1
static wp::int32 diagonalize_0(
    wp::int32 var_b,
    wp::int32 var_n,
    wp::array_t<wp::float64> var_p__matrices,
    wp::array_t<wp::float64> var_p__rows,
    wp::array_t<wp::float64> var_p__values,
    wp::array_t<wp::float64> var_p__beside)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    wp::range_t var_2;
    wp::int32 var_3;
    const wp::int32 var_4 = 0;
    wp::int32 var_5;
    wp::int32 var_6;
    bool var_7;
    bool var_8;
    const wp::int32 var_9 = 60;
    bool var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    const wp::int32 var_13 = 1;
    wp::int32 var_14;
    bool var_15;
    const wp::int32 var_16 = 1;
    wp::int32 var_17;
    wp::int32 var_18;
    //---------
    // forward
    // def diagonalize(b, n, p__matrices, p__rows, p__values, p__beside):                     <L 1>
    // failures = int(0)                                                                      <L 3>
    var_1 = wp::int(var_0);
    // for first in range(n):                                                                 <L 4>
    var_2 = wp::range(var_n);
    start_for_0:;
        if (iter_cmp(var_2) == 0) goto end_for_0;
        var_3 = wp::iter_next(var_2);
        // steps = int(0)                                                                     <L 5>
        var_5 = wp::int(var_4);
        // last = end_of_block(b, first, n, p__values, p__beside)                             <L 6>
        var_6 = end_of_block_0(var_b, var_3, var_n, var_p__values, var_p__beside);
        // while last != first and steps < MAX_STEPS:                                         <L 7>
    start_while_2:;
        var_8 = (var_6 != var_3);
        var_7 = var_8;
        if (var_7) {
            var_10 = (var_5 < var_9);
            var_7 = var_7 && var_10;
        }
    if ((var_7) == false) goto end_while_2;
            // _ = rotate(b, first, last, p__matrices, p__rows, p__values, p__beside)         <L 8>
            var_11 = rotate_0(var_b, var_3, var_6, var_p__matrices, var_p__rows, var_p__values, var_p__beside);
            // last = end_of_block(b, first, n, p__values, p__beside)                         <L 9>
            var_12 = end_of_block_0(var_b, var_3, var_n, var_p__values, var_p__beside);
            // steps += 1                                                                     <L 10>
            var_14 = wp::add(var_5, var_13);
            wp::assign(var_5, var_14);
            wp::assign(var_6, var_12);
    goto start_while_2;
    end_while_2:;
        // if last != first:                                                                  <L 11>
        var_15 = (var_6 != var_3);
        if (var_15) {
            // failures += 1                                                                  <L 12>
            var_17 = wp::add(var_1, var_16);
        }
        var_18 = wp::where(var_15, var_17, var_1);
        wp::assign(var_1, var_18);
        goto start_for_0;
    end_for_0:;
    // return failures                                                                        <L 13>
    return var_1;
}


// <pointloom.kernels.small_matrices.sort_pairs>:1
static wp::int32 sort_pairs_0(
    wp::int32 var_b,
    wp::int32 var_n,
    wp::array_t<wp::float64> var_p__rows,
    wp::array_t<wp::float64> var_p__values)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::range_t var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 0;
    wp::int32 var_6;
    bool var_7;
    const wp::int32 var_8 = 0;
    bool var_9;
    wp::float64* var_10;
    const wp::int32 var_11 = 1;
    wp::int32 var_12;
    wp::float64* var_13;
    bool var_14;
    wp::float64 var_15;
    wp::float64 var_16;
    wp::float64* var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    const wp::int32 var_20 = 1;
    wp::int32 var_21;
    wp::float64* var_22;
    wp::float64 var_23;
    wp::float64 var_24;
    const wp::int32 var_25 = 1;
    wp::int32 var_26;
    wp::range_t var_27;
    wp::int32 var_28;
    wp::float64* var_29;
    wp::float64 var_30;
    wp::float64 var_31;
    const wp::int32 var_32 = 1;
    wp::int32 var_33;
    wp::float64* var_34;
    wp::float64 var_35;
    wp::float64 var_36;
    const wp::int32 var_37 = 1;
    wp::int32 var_38;
    const wp::int32 var_39 = 1;
    wp::int32 var_40;
    const wp::int32 var_41 = 1;
    wp::int32 var_42;
    //---------
    // forward
    // def sort_pairs(b, n, p__rows, p__values):                                              <L 1>
    // moved = int(0)                                                                         <L 3>
    var_1 = wp::int(var_0);
    // for k in range(1, n):                                                                  <L 4>
    var_3 = wp::range(var_2, var_n);
    start_for_0:;
        if (iter_cmp(var_3) == 0) goto end_for_0;
        var_4 = wp::iter_next(var_3);
        // j = k + 0                                                                          <L 5>
        var_6 = wp::add(var_4, var_5);
        // while j > 0 and p__values[b, j] < p__values[b, j - 1]:                             <L 6>
    start_while_2:;
        var_9 = (var_6 > var_8);
        var_7 = var_9;
        if (var_7) {
            var_10 = wp::address(var_p__values, var_b, var_6);
            var_12 = wp::sub(var_6, var_11);
            var_13 = wp::address(var_p__values, var_b, var_12);
            var_15 = wp::load(var_10);
            var_16 = wp::load(var_13);
            var_14 = (var_15 < var_16);
            var_7 = var_7 && var_14;
        }
    if ((var_7) == false) goto end_while_2;
            // value = p__values[b, j]                                                        <L 7>
            var_17 = wp::address(var_p__values, var_b, var_6);
            var_19 = wp::load(var_17);
            var_18 = wp::copy(var_19);
            // p__values[b, j] = p__values[b, j - 1]                                          <L 8>
            var_21 = wp::sub(var_6, var_20);
            var_22 = wp::address(var_p__values, var_b, var_21);
            var_24 = wp::load(var_22);
            var_23 = wp::copy(var_24);
            wp::array_store(var_p__values, var_b, var_6, var_23);
            // p__values[b, j - 1] = value                                                    <L 9>
            var_26 = wp::sub(var_6, var_25);
            wp::array_store(var_p__values, var_b, var_26, var_18);
            // for c in range(n):                                                             <L 10>
            var_27 = wp::range(var_n);
            start_for_4:;
                if (iter_cmp(var_27) == 0) goto end_for_4;
                var_28 = wp::iter_next(var_27);
                // entry = p__rows[b, j, c]                                                   <L 11>
                var_29 = wp::address(var_p__rows, var_b, var_6, var_28);
                var_31 = wp::load(var_29);
                var_30 = wp::copy(var_31);
                // p__rows[b, j, c] = p__rows[b, j - 1, c]                                    <L 12>
                var_33 = wp::sub(var_6, var_32);
                var_34 = wp::address(var_p__rows, var_b, var_33, var_28);
                var_36 = wp::load(var_34);
                var_35 = wp::copy(var_36);
                wp::array_store(var_p__rows, var_b, var_6, var_28, var_35);
                // p__rows[b, j - 1, c] = entry                                               <L 13>
                var_38 = wp::sub(var_6, var_37);
                wp::array_store(var_p__rows, var_b, var_38, var_28, var_30);
                goto start_for_4;
            end_for_4:;
            // j -= 1                                                                         <L 14>
            var_40 = wp::sub(var_6, var_39);
            // moved += 1                                                                     <L 15>
            var_42 = wp::add(var_1, var_41);
            wp::assign(var_1, var_42);
            wp::assign(var_6, var_40);
    goto start_while_2;
    end_while_2:;
        goto start_for_0;
    end_for_0:;
    // return moved                                                                           <L 16>
    return var_1;
}


// <pointloom.kernels.small_matrices.sign_of_row>:1
static wp::float64 sign_of_row_0(
    wp::int32 var_b,
    wp::int32 var_j,
    wp::int32 var_n,
    wp::float64 var_largest,
    wp::array_t<wp::float64> var_p__lapack,
    wp::array_t<wp::float64> var_p__rows,
    wp::array_t<wp::float64> var_p__values)
{
    //---------
    // primal vars
    wp::float64* var_0;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    wp::float64 var_4;
    bool var_5;
    bool var_6;
    const wp::int32 var_7 = 0;
    bool var_8;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    const wp::int32 var_11 = 0;
    wp::int32 var_12;
    wp::float64* var_13;
    wp::float64 var_14;
    wp::float64 var_15;
    bool var_16;
    bool var_17;
    const wp::int32 var_18 = 1;
    wp::int32 var_19;
    bool var_20;
    const wp::int32 var_21 = 1;
    wp::int32 var_22;
    const wp::int32 var_23 = 1;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::float64* var_26;
    wp::float64 var_27;
    wp::float64 var_28;
    bool var_29;
    wp::float64 var_30;
    const wp::int32 var_31 = 0;
    wp::float64* var_32;
    wp::float64 var_33;
    wp::float64 var_34;
    wp::range_t var_35;
    wp::int32 var_36;
    wp::float64* var_37;
    wp::float64* var_38;
    wp::float64 var_39;
    wp::float64 var_40;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::float64* var_43;
    wp::float64 var_44;
    wp::float64 var_45;
    wp::float64 var_46;
    bool var_47;
    wp::float64* var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    wp::float64 var_51;
    wp::float64 var_52;
    wp::float64 var_53;
    bool var_54;
    wp::float64 var_55;
    wp::float64 var_56;
    wp::float64 var_57;
    //---------
    // forward
    // def sign_of_row(b, j, n, largest, p__lapack, p__rows, p__values):                      <L 1>
    // value = p__values[b, j]                                                                <L 3>
    var_0 = wp::address(var_p__values, var_b, var_j);
    var_2 = wp::load(var_0);
    var_1 = wp::copy(var_2);
    // limit = float64(SEPARATED) * largest                                                   <L 4>
    var_3 = 1e-06;
    var_4 = wp::mul(var_3, var_largest);
    // is_single = (j == 0 or value - p__values[b, max(j - 1, 0)] > limit) and (j == n - 1 or p__values[b, min(j + 1, n - 1)] - value > limit)       <L 5>
    var_8 = (var_j == var_7);
    var_6 = var_8;
    if (!var_6) {
        var_10 = wp::sub(var_j, var_9);
        var_12 = wp::max(var_10, var_11);
        var_13 = wp::address(var_p__values, var_b, var_12);
        var_15 = wp::load(var_13);
        var_14 = wp::sub(var_1, var_15);
        var_16 = (var_14 > var_4);
        var_6 = var_6 || var_16;
    }
    var_5 = var_6;
    if (var_5) {
        var_19 = wp::sub(var_n, var_18);
        var_20 = (var_j == var_19);
        var_17 = var_20;
        if (!var_17) {
            var_22 = wp::add(var_j, var_21);
            var_24 = wp::sub(var_n, var_23);
            var_25 = wp::min(var_22, var_24);
            var_26 = wp::address(var_p__values, var_b, var_25);
            var_28 = wp::load(var_26);
            var_27 = wp::sub(var_28, var_1);
            var_29 = (var_27 > var_4);
            var_17 = var_17 || var_29;
        }
        var_5 = var_5 && var_17;
    }
    // along = float64(0.0)                                                                   <L 6>
    var_30 = 0.0;
    // top = p__rows[b, j, 0]                                                                 <L 7>
    var_32 = wp::address(var_p__rows, var_b, var_j, var_31);
    var_34 = wp::load(var_32);
    var_33 = wp::copy(var_34);
    // for c in range(n):                                                                     <L 8>
    var_35 = wp::range(var_n);
    start_for_0:;
        if (iter_cmp(var_35) == 0) goto end_for_0;
        var_36 = wp::iter_next(var_35);
        // along += p__rows[b, j, c] * p__lapack[b, c, j]                                     <L 9>
        var_37 = wp::address(var_p__rows, var_b, var_j, var_36);
        var_38 = wp::address(var_p__lapack, var_b, var_36, var_j);
        var_40 = wp::load(var_37);
        var_41 = wp::load(var_38);
        var_39 = wp::mul(var_40, var_41);
        var_42 = wp::add(var_30, var_39);
        // if abs(p__rows[b, j, c]) > abs(top):                                               <L 10>
        var_43 = wp::address(var_p__rows, var_b, var_j, var_36);
        var_45 = wp::load(var_43);
        var_44 = wp::abs(var_45);
        var_46 = wp::abs(var_33);
        var_47 = (var_44 > var_46);
        if (var_47) {
            // top = p__rows[b, j, c]                                                         <L 11>
            var_48 = wp::address(var_p__rows, var_b, var_j, var_36);
            var_50 = wp::load(var_48);
            var_49 = wp::copy(var_50);
        }
        var_51 = wp::where(var_47, var_49, var_33);
        wp::assign(var_30, var_42);
        wp::assign(var_33, var_51);
        goto start_for_0;
    end_for_0:;
    // decisive = along if is_single else top                                                 <L 12>
    if (var_5) {
    }
    if (!var_5) {
    }
    var_52 = wp::where(var_5, var_30, var_33);
    // return float64(-1.0) if decisive < float64(0.0) else float64(1.0)                      <L 13>
    var_53 = 0.0;
    var_54 = (var_52 < var_53);
    if (var_54) {
        var_55 = -1.0;
    }
    if (!var_54) {
        var_56 = 1.0;
    }
    var_57 = wp::where(var_54, var_55, var_56);
    return var_57;
}


// <pointloom.kernels.small_matrices.scale_down>:1
static void adj_scale_down_0(
    wp::int32 var_b,
    wp::int32 var_n,
    wp::array_t<wp::float64> var_p__matrices,
    wp::array_t<wp::float64> var_p__rows,
    wp::int32 & adj_b,
    wp::int32 & adj_n,
    wp::array_t<wp::float64> & adj_p__matrices,
    wp::array_t<wp::float64> & adj_p__rows,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.small_matrices.copied_sign>:1
static void adj_copied_sign_0(
    wp::float64 var_size,
    wp::float64 var_sign,
    wp::float64 & adj_size,
    wp::float64 & adj_sign,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.small_matrices.reflect>:1
static void adj_reflect_0(
    wp::int32 var_b,
    wp::int32 var_k,
    wp::int32 var_n,
    wp::array_t<wp::float64> var_p__matrices,
    wp::array_t<wp::float64> var_p__rows,
    wp::array_t<wp::float64> var_p__beside,
    wp::int32 & adj_b,
    wp::int32 & adj_k,
    wp::int32 & adj_n,
    wp::array_t<wp::float64> & adj_p__matrices,
    wp::array_t<wp::float64> & adj_p__rows,
    wp::array_t<wp::float64> & adj_p__beside,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.small_matrices.is_divided>:1
static void adj_is_divided_0(
    wp::int32 var_b,
    wp::int32 var_i,
    wp::array_t<wp::float64> var_p__values,
    wp::array_t<wp::float64> var_p__beside,
    wp::int32 & adj_b,
    wp::int32 & adj_i,
    wp::array_t<wp::float64> & adj_p__values,
    wp::array_t<wp::float64> & adj_p__beside,
    bool & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.small_matrices.end_of_block>:1
static void adj_end_of_block_0(
    wp::int32 var_b,
    wp::int32 var_first,
    wp::int32 var_n,
    wp::array_t<wp::float64> var_p__values,
    wp::array_t<wp::float64> var_p__beside,
    wp::int32 & adj_b,
    wp::int32 & adj_first,
    wp::int32 & adj_n,
    wp::array_t<wp::float64> & adj_p__values,
    wp::array_t<wp::float64> & adj_p__beside,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.small_matrices.rotate>:1
static void adj_rotate_0(
    wp::int32 var_b,
    wp::int32 var_first,
    wp::int32 var_last,
    wp::array_t<wp::float64> var_p__matrices,
    wp::array_t<wp::float64> var_p__rows,
    wp::array_t<wp::float64> var_p__values,
    wp::array_t<wp::float64> var_p__beside,
    wp::int32 & adj_b,
    wp::int32 & adj_first,
    wp::int32 & adj_last,
    wp::array_t<wp::float64> & adj_p__matrices,
    wp::array_t<wp::float64> & adj_p__rows,
    wp::array_t<wp::float64> & adj_p__values,
    wp::array_t<wp::float64> & adj_p__beside,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.small_matrices.diagonalize>:1
static void adj_diagonalize_0(
    wp::int32 var_b,
    wp::int32 var_n,
    wp::array_t<wp::float64> var_p__matrices,
    wp::array_t<wp::float64> var_p__rows,
    wp::array_t<wp::float64> var_p__values,
    wp::array_t<wp::float64> var_p__beside,
    wp::int32 & adj_b,
    wp::int32 & adj_n,
    wp::array_t<wp::float64> & adj_p__matrices,
    wp::array_t<wp::float64> & adj_p__rows,
    wp::array_t<wp::float64> & adj_p__values,
    wp::array_t<wp::float64> & adj_p__beside,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.small_matrices.sort_pairs>:1
static void adj_sort_pairs_0(
    wp::int32 var_b,
    wp::int32 var_n,
    wp::array_t<wp::float64> var_p__rows,
    wp::array_t<wp::float64> var_p__values,
    wp::int32 & adj_b,
    wp::int32 & adj_n,
    wp::array_t<wp::float64> & adj_p__rows,
    wp::array_t<wp::float64> & adj_p__values,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.small_matrices.sign_of_row>:1
static void adj_sign_of_row_0(
    wp::int32 var_b,
    wp::int32 var_j,
    wp::int32 var_n,
    wp::float64 var_largest,
    wp::array_t<wp::float64> var_p__lapack,
    wp::array_t<wp::float64> var_p__rows,
    wp::array_t<wp::float64> var_p__values,
    wp::int32 & adj_b,
    wp::int32 & adj_j,
    wp::int32 & adj_n,
    wp::float64 & adj_largest,
    wp::array_t<wp::float64> & adj_p__lapack,
    wp::array_t<wp::float64> & adj_p__rows,
    wp::array_t<wp::float64> & adj_p__values,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}

struct wp_args_solve_systems_kernel_4f290fe2 {
    wp::array_t<wp::float64> p__systems;
    wp::array_t<wp::int32> p__failed;
};


template <bool wp_linear_contiguous>
static void solve_systems_kernel_4f290fe2_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args_solve_systems_kernel_4f290fe2 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;

    //---------
    // argument vars
    wp::array_t<wp::float64> var_p__systems = _wp_args->p__systems;
    wp::array_t<wp::int32> var_p__failed = _wp_args->p__failed;
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 0;
    const wp::int32 var_2 = 0;
    wp::shape_t* var_3;
    const wp::int32 var_4 = 1;
    wp::int32 var_5;
    wp::shape_t var_6;
    wp::shape_t* var_7;
    const wp::int32 var_8 = 2;
    wp::int32 var_9;
    wp::shape_t var_10;
    wp::shape_t* var_11;
    const wp::int32 var_12 = 0;
    wp::int32 var_13;
    wp::shape_t var_14;
    wp::range_t var_15;
    wp::int32 var_16;
    wp::range_t var_17;
    wp::int32 var_18;
    const wp::int32 var_19 = 0;
    wp::int32 var_20;
    wp::float64* var_21;
    wp::float64 var_22;
    wp::float64 var_23;
    const wp::int32 var_24 = 1;
    wp::int32 var_25;
    wp::range_t var_26;
    wp::int32 var_27;
    wp::float64* var_28;
    wp::float64 var_29;
    wp::float64 var_30;
    bool var_31;
    bool var_32;
    bool var_33;
    bool var_34;
    bool var_35;
    wp::int32 var_36;
    wp::float64 var_37;
    wp::int32 var_38;
    wp::float64 var_39;
    wp::float64 var_40;
    bool var_41;
    const wp::int32 var_42 = 1;
    const wp::int32 var_43 = 0;
    wp::range_t var_44;
    wp::int32 var_45;
    wp::float64* var_46;
    wp::float64 var_47;
    wp::float64 var_48;
    wp::float64* var_49;
    wp::float64 var_50;
    wp::float64 var_51;
    const wp::int32 var_52 = 1;
    wp::int32 var_53;
    wp::range_t var_54;
    wp::int32 var_55;
    wp::float64* var_56;
    wp::float64* var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float64 var_60;
    wp::range_t var_61;
    wp::int32 var_62;
    wp::float64* var_63;
    wp::float64* var_64;
    wp::float64 var_65;
    wp::float64 var_66;
    wp::float64 var_67;
    wp::float64 var_68;
    wp::range_t var_69;
    wp::int32 var_70;
    const wp::int32 var_71 = 1;
    wp::int32 var_72;
    wp::int32 var_73;
    wp::range_t var_74;
    wp::int32 var_75;
    wp::float64* var_76;
    wp::float64* var_77;
    wp::float64 var_78;
    wp::float64 var_79;
    wp::float64 var_80;
    wp::range_t var_81;
    wp::int32 var_82;
    wp::float64* var_83;
    wp::float64* var_84;
    wp::float64 var_85;
    wp::float64 var_86;
    wp::float64 var_87;
    wp::float64 var_88;
    //---------
    // forward
    // def solve_systems_kernel(p__systems, p__failed):                                       <L 1>
    // thread = tid()                                                                         <L 2>
    var_0 = builtin_tid1d();
    // p__failed[0] = 0                                                                       <L 3>
    wp::array_store(var_p__failed, var_2, var_1);
    // n = p__systems.shape[1]                                                                <L 4>
    var_3 = &(var_p__systems.shape);
    var_6 = wp::load(var_3);
    var_5 = wp::extract(var_6, var_4);
    // width = p__systems.shape[2]                                                            <L 5>
    var_7 = &(var_p__systems.shape);
    var_10 = wp::load(var_7);
    var_9 = wp::extract(var_10, var_8);
    // for b in range(thread, p__systems.shape[0]):                                           <L 6>
    var_11 = &(var_p__systems.shape);
    var_14 = wp::load(var_11);
    var_13 = wp::extract(var_14, var_12);
    var_15 = wp::range(var_0, var_13);
    start_for_0:;
        if (iter_cmp(var_15) == 0) goto end_for_0;
        var_16 = wp::iter_next(var_15);
        // for k in range(n):                                                                 <L 7>
        var_17 = wp::range(var_5);
        start_for_2:;
            if (iter_cmp(var_17) == 0) goto end_for_2;
            var_18 = wp::iter_next(var_17);
            // best = k + 0                                                                   <L 8>
            var_20 = wp::add(var_18, var_19);
            // largest = abs(p__systems[b, k, k])                                             <L 9>
            var_21 = wp::address(var_p__systems, var_16, var_18, var_18);
            var_23 = wp::load(var_21);
            var_22 = wp::abs(var_23);
            // for i in range(k + 1, n):                                                      <L 10>
            var_25 = wp::add(var_18, var_24);
            var_26 = wp::range(var_25, var_5);
            start_for_4:;
                if (iter_cmp(var_26) == 0) goto end_for_4;
                var_27 = wp::iter_next(var_26);
                // size = abs(p__systems[b, i, k])                                            <L 11>
                var_28 = wp::address(var_p__systems, var_16, var_27, var_18);
                var_30 = wp::load(var_28);
                var_29 = wp::abs(var_30);
                // if largest == largest and (size > largest or size != size):                <L 12>
                var_32 = (var_22 == var_22);
                var_31 = var_32;
                if (var_31) {
                    var_34 = (var_29 > var_22);
                    var_33 = var_34;
                    if (!var_33) {
                        var_35 = (var_29 != var_29);
                        var_33 = var_33 || var_35;
                    }
                    var_31 = var_31 && var_33;
                }
                if (var_31) {
                    // best = i                                                               <L 13>
                    var_36 = wp::copy(var_27);
                    // largest = size                                                         <L 14>
                    var_37 = wp::copy(var_29);
                }
                var_38 = wp::where(var_31, var_36, var_20);
                var_39 = wp::where(var_31, var_37, var_22);
                wp::assign(var_20, var_38);
                wp::assign(var_22, var_39);
                goto start_for_4;
            end_for_4:;
            // if largest == float64(0.0):                                                    <L 15>
            var_40 = 0.0;
            var_41 = (var_22 == var_40);
            if (var_41) {
                // p__failed[0] = 1                                                           <L 16>
                wp::array_store(var_p__failed, var_43, var_42);
            }
            // for c in range(width):                                                         <L 17>
            var_44 = wp::range(var_9);
            start_for_6:;
                if (iter_cmp(var_44) == 0) goto end_for_6;
                var_45 = wp::iter_next(var_44);
                // entry = p__systems[b, best, c]                                             <L 18>
                var_46 = wp::address(var_p__systems, var_16, var_20, var_45);
                var_48 = wp::load(var_46);
                var_47 = wp::copy(var_48);
                // p__systems[b, best, c] = p__systems[b, k, c]                               <L 19>
                var_49 = wp::address(var_p__systems, var_16, var_18, var_45);
                var_51 = wp::load(var_49);
                var_50 = wp::copy(var_51);
                wp::array_store(var_p__systems, var_16, var_20, var_45, var_50);
                // p__systems[b, k, c] = entry                                                <L 20>
                wp::array_store(var_p__systems, var_16, var_18, var_45, var_47);
                goto start_for_6;
            end_for_6:;
            // for i in range(k + 1, n):                                                      <L 21>
            var_53 = wp::add(var_18, var_52);
            var_54 = wp::range(var_53, var_5);
            start_for_8:;
                if (iter_cmp(var_54) == 0) goto end_for_8;
                var_55 = wp::iter_next(var_54);
                // factor = p__systems[b, i, k] / p__systems[b, k, k]                         <L 22>
                var_56 = wp::address(var_p__systems, var_16, var_55, var_18);
                var_57 = wp::address(var_p__systems, var_16, var_18, var_18);
                var_59 = wp::load(var_56);
                var_60 = wp::load(var_57);
                var_58 = wp::div(var_59, var_60);
                // for c in range(k, width):                                                  <L 23>
                var_61 = wp::range(var_18, var_9);
                start_for_10:;
                    if (iter_cmp(var_61) == 0) goto end_for_10;
                    var_62 = wp::iter_next(var_61);
                    // p__systems[b, i, c] = p__systems[b, i, c] - factor * p__systems[b, k, c]       <L 24>
                    var_63 = wp::address(var_p__systems, var_16, var_55, var_62);
                    var_64 = wp::address(var_p__systems, var_16, var_18, var_62);
                    var_66 = wp::load(var_64);
                    var_65 = wp::mul(var_58, var_66);
                    var_68 = wp::load(var_63);
                    var_67 = wp::sub(var_68, var_65);
                    wp::array_store(var_p__systems, var_16, var_55, var_62, var_67);
                    goto start_for_10;
                end_for_10:;
                wp::assign(var_45, var_62);
                goto start_for_8;
            end_for_8:;
            goto start_for_2;
        end_for_2:;
        // for step in range(n):                                                              <L 25>
        var_69 = wp::range(var_5);
        start_for_12:;
            if (iter_cmp(var_69) == 0) goto end_for_12;
            var_70 = wp::iter_next(var_69);
            // k = n - 1 - step                                                               <L 26>
            var_72 = wp::sub(var_5, var_71);
            var_73 = wp::sub(var_72, var_70);
            // for c in range(n, width):                                                      <L 27>
            var_74 = wp::range(var_5, var_9);
            start_for_14:;
                if (iter_cmp(var_74) == 0) goto end_for_14;
                var_75 = wp::iter_next(var_74);
                // solution = p__systems[b, k, c] / p__systems[b, k, k]                       <L 28>
                var_76 = wp::address(var_p__systems, var_16, var_73, var_75);
                var_77 = wp::address(var_p__systems, var_16, var_73, var_73);
                var_79 = wp::load(var_76);
                var_80 = wp::load(var_77);
                var_78 = wp::div(var_79, var_80);
                // p__systems[b, k, c] = solution                                             <L 29>
                wp::array_store(var_p__systems, var_16, var_73, var_75, var_78);
                // for i in range(k):                                                         <L 30>
                var_81 = wp::range(var_73);
                start_for_16:;
                    if (iter_cmp(var_81) == 0) goto end_for_16;
                    var_82 = wp::iter_next(var_81);
                    // p__systems[b, i, c] = p__systems[b, i, c] - p__systems[b, i, k] * solution       <L 31>
                    var_83 = wp::address(var_p__systems, var_16, var_82, var_75);
                    var_84 = wp::address(var_p__systems, var_16, var_82, var_73);
                    var_86 = wp::load(var_84);
                    var_85 = wp::mul(var_86, var_78);
                    var_88 = wp::load(var_83);
                    var_87 = wp::sub(var_88, var_85);
                    wp::array_store(var_p__systems, var_16, var_82, var_75, var_87);
                    goto start_for_16;
                end_for_16:;
                wp::assign(var_55, var_82);
                goto start_for_14;
            end_for_14:;
            wp::assign(var_18, var_73);
            wp::assign(var_45, var_75);
            goto start_for_12;
        end_for_12:;
        goto start_for_0;
    end_for_0:;
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void solve_systems_kernel_4f290fe2_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args_solve_systems_kernel_4f290fe2 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        solve_systems_kernel_4f290fe2_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void solve_systems_kernel_4f290fe2_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args_solve_systems_kernel_4f290fe2 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    solve_systems_kernel_4f290fe2_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void solve_systems_kernel_4f290fe2_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args_solve_systems_kernel_4f290fe2 *_wp_args)
{
    solve_systems_kernel_4f290fe2_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

struct wp_args_decompose_kernel_dcd2fc98 {
    wp::array_t<wp::float64> p__matrices;
    wp::array_t<wp::float64> p__lapack;
    wp::array_t<wp::float64> p__rows;
    wp::array_t<wp::float64> p__values;
    wp::array_t<wp::float64> p__beside;
    wp::array_t<wp::int32> p__failed;
};


template <bool wp_linear_contiguous>
static void decompose_kernel_dcd2fc98_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args_decompose_kernel_dcd2fc98 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;

    //---------
    // argument vars
    wp::array_t<wp::float64> var_p__matrices = _wp_args->p__matrices;
    wp::array_t<wp::float64> var_p__lapack = _wp_args->p__lapack;
    wp::array_t<wp::float64> var_p__rows = _wp_args->p__rows;
    wp::array_t<wp::float64> var_p__values = _wp_args->p__values;
    wp::array_t<wp::float64> var_p__beside = _wp_args->p__beside;
    wp::array_t<wp::int32> var_p__failed = _wp_args->p__failed;
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 0;
    const wp::int32 var_2 = 0;
    wp::shape_t* var_3;
    const wp::int32 var_4 = 1;
    wp::int32 var_5;
    wp::shape_t var_6;
    wp::shape_t* var_7;
    const wp::int32 var_8 = 0;
    wp::int32 var_9;
    wp::shape_t var_10;
    wp::range_t var_11;
    wp::int32 var_12;
    wp::float64 var_13;
    const wp::int32 var_14 = 2;
    wp::int32 var_15;
    wp::range_t var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::range_t var_19;
    wp::int32 var_20;
    wp::float64* var_21;
    wp::float64 var_22;
    wp::float64 var_23;
    const wp::int32 var_24 = 1;
    wp::int32 var_25;
    bool var_26;
    const wp::int32 var_27 = 1;
    wp::int32 var_28;
    const wp::int32 var_29 = 1;
    wp::int32 var_30;
    wp::int32 var_31;
    wp::float64* var_32;
    wp::float64 var_33;
    wp::float64 var_34;
    wp::float64 var_35;
    wp::float64 var_36;
    wp::int32 var_37;
    bool var_38;
    wp::float64 var_39;
    bool var_40;
    const wp::int32 var_41 = 0;
    wp::int32* var_42;
    const wp::int32 var_43 = 0;
    bool var_44;
    wp::int32 var_45;
    const wp::int32 var_46 = -1;
    const wp::int32 var_47 = 0;
    const wp::int32 var_48 = 0;
    wp::int32* var_49;
    wp::int32 var_50;
    wp::int32 var_51;
    const wp::int32 var_52 = 0;
    wp::int32 var_53;
    const wp::int32 var_54 = 0;
    wp::float64* var_55;
    wp::float64 var_56;
    wp::float64 var_57;
    const wp::int32 var_58 = 1;
    wp::int32 var_59;
    wp::float64* var_60;
    wp::float64 var_61;
    wp::float64 var_62;
    wp::float64 var_63;
    wp::range_t var_64;
    wp::int32 var_65;
    wp::float64 var_66;
    wp::range_t var_67;
    wp::int32 var_68;
    wp::float64* var_69;
    wp::float64 var_70;
    wp::float64 var_71;
    wp::range_t var_72;
    wp::int32 var_73;
    wp::float64* var_74;
    wp::float64 var_75;
    wp::float64 var_76;
    //---------
    // forward
    // def decompose_kernel(p__matrices, p__lapack, p__rows, p__values, p__beside, p__failed):       <L 1>
    // thread = tid()                                                                         <L 3>
    var_0 = builtin_tid1d();
    // p__failed[0] = 0                                                                       <L 4>
    wp::array_store(var_p__failed, var_2, var_1);
    // n = p__matrices.shape[1]                                                               <L 5>
    var_3 = &(var_p__matrices.shape);
    var_6 = wp::load(var_3);
    var_5 = wp::extract(var_6, var_4);
    // for b in range(thread, p__matrices.shape[0]):                                          <L 6>
    var_7 = &(var_p__matrices.shape);
    var_10 = wp::load(var_7);
    var_9 = wp::extract(var_10, var_8);
    var_11 = wp::range(var_0, var_9);
    start_for_0:;
        if (iter_cmp(var_11) == 0) goto end_for_0;
        var_12 = wp::iter_next(var_11);
        // size = scale_down(b, n, p__matrices, p__rows)                                      <L 7>
        var_13 = scale_down_0(var_12, var_5, var_p__matrices, var_p__rows);
        // for k in range(n - 2):                                                             <L 8>
        var_15 = wp::sub(var_5, var_14);
        var_16 = wp::range(var_15);
        start_for_2:;
            if (iter_cmp(var_16) == 0) goto end_for_2;
            var_17 = wp::iter_next(var_16);
            // _ = reflect(b, k, n, p__matrices, p__rows, p__beside)                          <L 9>
            var_18 = reflect_0(var_12, var_17, var_5, var_p__matrices, var_p__rows, var_p__beside);
            goto start_for_2;
        end_for_2:;
        // for i in range(n):                                                                 <L 10>
        var_19 = wp::range(var_5);
        start_for_4:;
            if (iter_cmp(var_19) == 0) goto end_for_4;
            var_20 = wp::iter_next(var_19);
            // p__values[b, i] = p__matrices[b, i, i]                                         <L 11>
            var_21 = wp::address(var_p__matrices, var_12, var_20, var_20);
            var_23 = wp::load(var_21);
            var_22 = wp::copy(var_23);
            wp::array_store(var_p__values, var_12, var_20, var_22);
            // p__beside[b, i] = p__matrices[b, min(i + 1, n - 1), i] if i < n - 1 else float64(0.0)       <L 12>
            var_25 = wp::sub(var_5, var_24);
            var_26 = (var_20 < var_25);
            if (var_26) {
                var_28 = wp::add(var_20, var_27);
                var_30 = wp::sub(var_5, var_29);
                var_31 = wp::min(var_28, var_30);
                var_32 = wp::address(var_p__matrices, var_12, var_31, var_20);
                var_34 = wp::load(var_32);
                var_33 = wp::copy(var_34);
            }
            if (!var_26) {
                var_35 = 0.0;
            }
            var_36 = wp::where(var_26, var_33, var_35);
            wp::array_store(var_p__beside, var_12, var_20, var_36);
            goto start_for_4;
        end_for_4:;
        // failures = diagonalize(b, n, p__matrices, p__rows, p__values, p__beside)           <L 13>
        var_37 = diagonalize_0(var_12, var_5, var_p__matrices, var_p__rows, var_p__values, var_p__beside);
        // if size < float64(0.0) or p__failed[0] < 0:                                        <L 14>
        var_39 = 0.0;
        var_40 = (var_13 < var_39);
        var_38 = var_40;
        if (!var_38) {
            var_42 = wp::address(var_p__failed, var_41);
            var_45 = wp::load(var_42);
            var_44 = (var_45 < var_43);
            var_38 = var_38 || var_44;
        }
        if (var_38) {
            // p__failed[0] = -1                                                              <L 15>
            wp::array_store(var_p__failed, var_47, var_46);
        }
        if (!var_38) {
            // p__failed[0] = p__failed[0] + failures                                         <L 17>
            var_49 = wp::address(var_p__failed, var_48);
            var_51 = wp::load(var_49);
            var_50 = wp::add(var_51, var_37);
            wp::array_store(var_p__failed, var_52, var_50);
        }
        // _ = sort_pairs(b, n, p__rows, p__values)                                           <L 18>
        var_53 = sort_pairs_0(var_12, var_5, var_p__rows, var_p__values);
        // largest = max(abs(p__values[b, 0]), abs(p__values[b, n - 1]))                      <L 19>
        var_55 = wp::address(var_p__values, var_12, var_54);
        var_57 = wp::load(var_55);
        var_56 = wp::abs(var_57);
        var_59 = wp::sub(var_5, var_58);
        var_60 = wp::address(var_p__values, var_12, var_59);
        var_62 = wp::load(var_60);
        var_61 = wp::abs(var_62);
        var_63 = wp::max(var_56, var_61);
        // for j in range(n):                                                                 <L 20>
        var_64 = wp::range(var_5);
        start_for_6:;
            if (iter_cmp(var_64) == 0) goto end_for_6;
            var_65 = wp::iter_next(var_64);
            // sign = sign_of_row(b, j, n, largest, p__lapack, p__rows, p__values)            <L 21>
            var_66 = sign_of_row_0(var_12, var_65, var_5, var_63, var_p__lapack, var_p__rows, var_p__values);
            // for c in range(n):                                                             <L 22>
            var_67 = wp::range(var_5);
            start_for_8:;
                if (iter_cmp(var_67) == 0) goto end_for_8;
                var_68 = wp::iter_next(var_67);
                // p__rows[b, j, c] = p__rows[b, j, c] * sign                                 <L 23>
                var_69 = wp::address(var_p__rows, var_12, var_65, var_68);
                var_71 = wp::load(var_69);
                var_70 = wp::mul(var_71, var_66);
                wp::array_store(var_p__rows, var_12, var_65, var_68, var_70);
                goto start_for_8;
            end_for_8:;
            goto start_for_6;
        end_for_6:;
        // for j in range(n):                                                                 <L 24>
        var_72 = wp::range(var_5);
        start_for_10:;
            if (iter_cmp(var_72) == 0) goto end_for_10;
            var_73 = wp::iter_next(var_72);
            // p__values[b, j] = p__values[b, j] * size                                       <L 25>
            var_74 = wp::address(var_p__values, var_12, var_73);
            var_76 = wp::load(var_74);
            var_75 = wp::mul(var_76, var_13);
            wp::array_store(var_p__values, var_12, var_73, var_75);
            goto start_for_10;
        end_for_10:;
        goto start_for_0;
    end_for_0:;
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void decompose_kernel_dcd2fc98_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args_decompose_kernel_dcd2fc98 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        decompose_kernel_dcd2fc98_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void decompose_kernel_dcd2fc98_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args_decompose_kernel_dcd2fc98 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    decompose_kernel_dcd2fc98_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void decompose_kernel_dcd2fc98_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args_decompose_kernel_dcd2fc98 *_wp_args)
{
    decompose_kernel_dcd2fc98_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C


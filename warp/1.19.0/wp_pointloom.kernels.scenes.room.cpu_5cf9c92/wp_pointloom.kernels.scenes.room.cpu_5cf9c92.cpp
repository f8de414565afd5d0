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


// <pointloom.kernels.scenes.room.node_index>:1
static wp::vec_t<3, wp::int32> node_index_0(
    wp::int32 var_i,
    wp::vec_t<3, wp::int32> var_light__size)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 2;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    const wp::int32 var_6 = 2;
    wp::int32 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    wp::int32 var_11;
    const wp::int32 var_12 = 2;
    wp::int32 var_13;
    wp::int32 var_14;
    wp::vec_t<3, wp::int32> var_15;
    //---------
    // forward
    // def node_index(i, light__size):                                                        <L 1>
    // return vec3i(i // (light__size[2] * light__size[1]), i // light__size[2] % light__size[1], i % light__size[2])       <L 2>
    var_1 = wp::extract(var_light__size, var_0);
    var_3 = wp::extract(var_light__size, var_2);
    var_4 = wp::mul(var_1, var_3);
    var_5 = wp::floordiv(var_i, var_4);
    var_7 = wp::extract(var_light__size, var_6);
    var_8 = wp::floordiv(var_i, var_7);
    var_10 = wp::extract(var_light__size, var_9);
    var_11 = wp::mod(var_8, var_10);
    var_13 = wp::extract(var_light__size, var_12);
    var_14 = wp::mod(var_i, var_13);
    var_15 = wp::vec_t<3, wp::int32>(var_5, var_11, var_14);
    return var_15;
}


// <pointloom.kernels.scenes.primitives.point_in_solid>:1
static wp::vec_t<3, wp::float64> point_in_solid_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::int32 var_solid,
    wp::array_t<wp::mat_t<3, 3, wp::float64>> var_solids__rotations,
    wp::array_t<wp::vec_t<3, wp::float64>> var_solids__centers)
{
    //---------
    // primal vars
    wp::mat_t<3, 3, wp::float64>* var_0;
    wp::vec_t<3, wp::float64>* var_1;
    wp::vec_t<3, wp::float64> var_2;
    wp::vec_t<3, wp::float64> var_3;
    wp::vec_t<3, wp::float64> var_4;
    wp::mat_t<3, 3, wp::float64> var_5;
    //---------
    // forward
    // def point_in_solid(p, solid, solids__rotations, solids__centers):                      <L 1>
    // return solids__rotations[solid] @ (p - solids__centers[solid])                         <L 2>
    var_0 = wp::address(var_solids__rotations, var_solid);
    var_1 = wp::address(var_solids__centers, var_solid);
    var_3 = wp::load(var_1);
    var_2 = wp::sub(var_p, var_3);
    var_5 = wp::load(var_0);
    var_4 = wp::mul(var_5, var_2);
    return var_4;
}


// /work/main/src/pointloom/kernels/scenes/primitives.py:41
static wp::vec_t<4, wp::float64> box_field_0(
    wp::vec_t<3, wp::float64> var_q,
    wp::vec_t<4, wp::float64> var_extent)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float64 var_1;
    wp::float64 var_2;
    const wp::int32 var_3 = 0;
    wp::float64 var_4;
    wp::float64 var_5;
    const wp::int32 var_6 = 1;
    wp::float64 var_7;
    wp::float64 var_8;
    const wp::int32 var_9 = 1;
    wp::float64 var_10;
    wp::float64 var_11;
    const wp::int32 var_12 = 2;
    wp::float64 var_13;
    wp::float64 var_14;
    const wp::int32 var_15 = 2;
    wp::float64 var_16;
    wp::float64 var_17;
    wp::vec_t<3, wp::float64> var_18;
    const wp::int32 var_19 = 0;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    const wp::int32 var_23 = 1;
    wp::float64 var_24;
    wp::float64 var_25;
    wp::float64 var_26;
    const wp::int32 var_27 = 2;
    wp::float64 var_28;
    wp::float64 var_29;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    wp::float64 var_33;
    wp::float64 var_34;
    wp::float64 var_35;
    wp::float64 var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    wp::float64 var_39;
    bool var_40;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    const wp::int32 var_44 = 0;
    wp::float64 var_45;
    const wp::int32 var_46 = 1;
    wp::float64 var_47;
    const wp::int32 var_48 = 2;
    wp::float64 var_49;
    wp::float64 var_50;
    wp::float64 var_51;
    const wp::int32 var_52 = 0;
    wp::float64 var_53;
    bool var_54;
    wp::float64 var_55;
    const wp::int32 var_56 = 1;
    wp::float64 var_57;
    bool var_58;
    wp::float64 var_59;
    wp::float64 var_60;
    wp::float64 var_61;
    wp::float64 var_62;
    wp::float64 var_63;
    wp::float64 var_64;
    wp::float64 var_65;
    wp::float64 var_66;
    wp::float64 var_67;
    wp::float64 var_68;
    wp::float64 var_69;
    wp::float64 var_70;
    wp::float64 var_71;
    const wp::int32 var_72 = 0;
    wp::float64 var_73;
    wp::float64 var_74;
    bool var_75;
    wp::float64 var_76;
    wp::float64 var_77;
    const wp::int32 var_78 = 1;
    wp::float64 var_79;
    wp::float64 var_80;
    bool var_81;
    wp::float64 var_82;
    wp::float64 var_83;
    const wp::int32 var_84 = 2;
    wp::float64 var_85;
    wp::float64 var_86;
    bool var_87;
    wp::float64 var_88;
    wp::float64 var_89;
    const wp::int32 var_90 = 3;
    wp::float64 var_91;
    wp::float64 var_92;
    wp::vec_t<4, wp::float64> var_93;
    //---------
    // forward
    // def box_field(q: vec3d, extent: vec4d) -> vec4d:                                       <L 42>
    // a = vec3d(abs(q[0]) - extent[0], abs(q[1]) - extent[1], abs(q[2]) - extent[2])         <L 44>
    var_1 = wp::extract(var_q, var_0);
    var_2 = wp::abs(var_1);
    var_4 = wp::extract(var_extent, var_3);
    var_5 = wp::sub(var_2, var_4);
    var_7 = wp::extract(var_q, var_6);
    var_8 = wp::abs(var_7);
    var_10 = wp::extract(var_extent, var_9);
    var_11 = wp::sub(var_8, var_10);
    var_13 = wp::extract(var_q, var_12);
    var_14 = wp::abs(var_13);
    var_16 = wp::extract(var_extent, var_15);
    var_17 = wp::sub(var_14, var_16);
    var_18 = wp::vec_t<3, wp::float64>(var_5, var_11, var_17);
    // x = max(a[0], float64(ZERO))                                                           <L 45>
    var_20 = wp::extract(var_18, var_19);
    var_21 = 0.0;
    var_22 = wp::max(var_20, var_21);
    // y = max(a[1], float64(ZERO))                                                           <L 46>
    var_24 = wp::extract(var_18, var_23);
    var_25 = wp::float64(var_21);
    var_26 = wp::max(var_24, var_25);
    // z = max(a[2], float64(ZERO))                                                           <L 47>
    var_28 = wp::extract(var_18, var_27);
    var_29 = wp::float64(var_21);
    var_30 = wp::max(var_28, var_29);
    // size = sqrt(x * x + y * y + z * z)                                                     <L 48>
    var_31 = wp::mul(var_22, var_22);
    var_32 = wp::mul(var_26, var_26);
    var_33 = wp::add(var_31, var_32);
    var_34 = wp::mul(var_30, var_30);
    var_35 = wp::add(var_33, var_34);
    var_36 = wp::sqrt(var_35);
    // distance = size + float64(ZERO)                                                        <L 49>
    var_37 = wp::float64(var_21);
    var_38 = wp::add(var_36, var_37);
    // if size > float64(ZERO):                                                               <L 50>
    var_39 = wp::float64(var_21);
    var_40 = (var_36 > var_39);
    if (var_40) {
        // x = x / size                                                                       <L 51>
        var_41 = wp::div(var_22, var_36);
        // y = y / size                                                                       <L 52>
        var_42 = wp::div(var_26, var_36);
        // z = z / size                                                                       <L 53>
        var_43 = wp::div(var_30, var_36);
    }
    if (!var_40) {
        // distance = max(a[0], max(a[1], a[2]))                                              <L 55>
        var_45 = wp::extract(var_18, var_44);
        var_47 = wp::extract(var_18, var_46);
        var_49 = wp::extract(var_18, var_48);
        var_50 = wp::max(var_47, var_49);
        var_51 = wp::max(var_45, var_50);
        // if a[0] == distance:                                                               <L 56>
        var_53 = wp::extract(var_18, var_52);
        var_54 = (var_53 == var_51);
        if (var_54) {
            // x = float64(ONE)                                                               <L 57>
            var_55 = 1.0;
        }
        if (!var_54) {
            // elif a[1] == distance:                                                         <L 58>
            var_57 = wp::extract(var_18, var_56);
            var_58 = (var_57 == var_51);
            if (var_58) {
                // y = float64(ONE)                                                           <L 59>
                var_59 = 1.0;
            }
            if (!var_58) {
                // z = float64(ONE)                                                           <L 61>
                var_60 = 1.0;
            }
            var_61 = wp::where(var_58, var_59, var_26);
            var_62 = wp::where(var_58, var_30, var_60);
            var_63 = wp::where(var_58, var_59, var_60);
        }
        var_64 = wp::where(var_54, var_55, var_22);
        var_65 = wp::where(var_54, var_26, var_61);
        var_66 = wp::where(var_54, var_30, var_62);
        var_67 = wp::where(var_54, var_55, var_63);
    }
    var_68 = wp::where(var_40, var_41, var_64);
    var_69 = wp::where(var_40, var_42, var_65);
    var_70 = wp::where(var_40, var_43, var_66);
    var_71 = wp::where(var_40, var_38, var_51);
    // if q[0] < float64(ZERO):                                                               <L 62>
    var_73 = wp::extract(var_q, var_72);
    var_74 = wp::float64(var_21);
    var_75 = (var_73 < var_74);
    if (var_75) {
        // x = -x                                                                             <L 63>
        var_76 = wp::neg(var_68);
    }
    var_77 = wp::where(var_75, var_76, var_68);
    // if q[1] < float64(ZERO):                                                               <L 64>
    var_79 = wp::extract(var_q, var_78);
    var_80 = wp::float64(var_21);
    var_81 = (var_79 < var_80);
    if (var_81) {
        // y = -y                                                                             <L 65>
        var_82 = wp::neg(var_69);
    }
    var_83 = wp::where(var_81, var_82, var_69);
    // if q[2] < float64(ZERO):                                                               <L 66>
    var_85 = wp::extract(var_q, var_84);
    var_86 = wp::float64(var_21);
    var_87 = (var_85 < var_86);
    if (var_87) {
        // z = -z                                                                             <L 67>
        var_88 = wp::neg(var_70);
    }
    var_89 = wp::where(var_87, var_88, var_70);
    // return vec4d(x, y, z, distance - extent[3])                                            <L 68>
    var_91 = wp::extract(var_extent, var_90);
    var_92 = wp::sub(var_71, var_91);
    var_93 = wp::vec_t<4, wp::float64>(var_77, var_83, var_89, var_92);
    return var_93;
}


// /work/main/src/pointloom/kernels/scenes/primitives.py:71
static wp::vec_t<4, wp::float64> cylinder_field_0(
    wp::vec_t<3, wp::float64> var_q,
    wp::vec_t<4, wp::float64> var_extent)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float64 var_1;
    const wp::int32 var_2 = 0;
    wp::float64 var_3;
    wp::float64 var_4;
    const wp::int32 var_5 = 1;
    wp::float64 var_6;
    const wp::int32 var_7 = 1;
    wp::float64 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    const wp::int32 var_13 = 2;
    wp::float64 var_14;
    wp::vec_t<3, wp::float64> var_15;
    const wp::int32 var_16 = 0;
    wp::float64 var_17;
    wp::float64 var_18;
    const wp::int32 var_19 = 2;
    wp::float64 var_20;
    const wp::int32 var_21 = 3;
    wp::float64 var_22;
    wp::vec_t<4, wp::float64> var_23;
    wp::vec_t<4, wp::float64> var_24;
    wp::float64 var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    bool var_28;
    const wp::int32 var_29 = 0;
    wp::float64 var_30;
    wp::float64 var_31;
    const wp::int32 var_32 = 1;
    wp::float64 var_33;
    wp::float64 var_34;
    wp::float64 var_35;
    wp::float64 var_36;
    const wp::int32 var_37 = 0;
    wp::float64 var_38;
    wp::float64 var_39;
    const wp::int32 var_40 = 0;
    wp::float64 var_41;
    wp::float64 var_42;
    const wp::int32 var_43 = 2;
    wp::float64 var_44;
    const wp::int32 var_45 = 3;
    wp::float64 var_46;
    wp::vec_t<4, wp::float64> var_47;
    //---------
    // forward
    // def cylinder_field(q: vec3d, extent: vec4d) -> vec4d:                                  <L 72>
    // radius = sqrt(q[0] * q[0] + q[1] * q[1])                                               <L 74>
    var_1 = wp::extract(var_q, var_0);
    var_3 = wp::extract(var_q, var_2);
    var_4 = wp::mul(var_1, var_3);
    var_6 = wp::extract(var_q, var_5);
    var_8 = wp::extract(var_q, var_7);
    var_9 = wp::mul(var_6, var_8);
    var_10 = wp::add(var_4, var_9);
    var_11 = wp::sqrt(var_10);
    // flat = box_field(vec3d(radius, float64(ZERO), q[2]), vec4d(extent[0], float64(INFINITY), extent[2], extent[3]))       <L 75>
    var_12 = 0.0;
    var_14 = wp::extract(var_q, var_13);
    var_15 = wp::vec_t<3, wp::float64>(var_11, var_12, var_14);
    var_17 = wp::extract(var_extent, var_16);
    var_18 = INFINITY;
    var_20 = wp::extract(var_extent, var_19);
    var_22 = wp::extract(var_extent, var_21);
    var_23 = wp::vec_t<4, wp::float64>(var_17, var_18, var_20, var_22);
    var_24 = box_field_0(var_15, var_23);
    // x = float64(ONE)                                                                       <L 76>
    var_25 = 1.0;
    // y = float64(ZERO)                                                                      <L 77>
    var_26 = wp::float64(var_12);
    // if radius > float64(ZERO):                                                             <L 78>
    var_27 = wp::float64(var_12);
    var_28 = (var_11 > var_27);
    if (var_28) {
        // x = q[0] / radius                                                                  <L 79>
        var_30 = wp::extract(var_q, var_29);
        var_31 = wp::div(var_30, var_11);
        // y = q[1] / radius                                                                  <L 80>
        var_33 = wp::extract(var_q, var_32);
        var_34 = wp::div(var_33, var_11);
    }
    var_35 = wp::where(var_28, var_31, var_25);
    var_36 = wp::where(var_28, var_34, var_26);
    // return vec4d(flat[0] * x, flat[0] * y, flat[2], flat[3])                               <L 81>
    var_38 = wp::extract(var_24, var_37);
    var_39 = wp::mul(var_38, var_35);
    var_41 = wp::extract(var_24, var_40);
    var_42 = wp::mul(var_41, var_36);
    var_44 = wp::extract(var_24, var_43);
    var_46 = wp::extract(var_24, var_45);
    var_47 = wp::vec_t<4, wp::float64>(var_39, var_42, var_44, var_46);
    return var_47;
}


// /work/main/src/pointloom/kernels/scenes/primitives.py:84
static wp::vec_t<4, wp::float64> solid_field_0(
    wp::vec_t<3, wp::float64> var_q,
    wp::vec_t<4, wp::float64> var_extent,
    wp::int32 var_kind)
{
    //---------
    // primal vars
    wp::vec_t<4, wp::float64> var_0;
    const wp::int32 var_1 = 1;
    bool var_2;
    wp::vec_t<4, wp::float64> var_3;
    wp::vec_t<4, wp::float64> var_4;
    //---------
    // forward
    // def solid_field(q: vec3d, extent: vec4d, kind: int) -> vec4d:                          <L 85>
    // field = box_field(q, extent)                                                           <L 87>
    var_0 = box_field_0(var_q, var_extent);
    // if kind == CYLINDER:                                                                   <L 88>
    var_2 = (var_kind == var_1);
    if (var_2) {
        // field = cylinder_field(q, extent)                                                  <L 89>
        var_3 = cylinder_field_0(var_q, var_extent);
    }
    var_4 = wp::where(var_2, var_3, var_0);
    // return field                                                                           <L 90>
    return var_4;
}


// <pointloom.kernels.scenes.primitives.scene_distance>:1
static wp::float64 scene_distance_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::array_t<wp::int32> var_solids__kinds,
    wp::array_t<wp::mat_t<3, 3, wp::float64>> var_solids__rotations,
    wp::array_t<wp::vec_t<3, wp::float64>> var_solids__centers,
    wp::array_t<wp::vec_t<4, wp::float64>> var_solids__extents)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::shape_t* var_3;
    const wp::int32 var_4 = 0;
    wp::int32 var_5;
    wp::shape_t var_6;
    wp::range_t var_7;
    wp::int32 var_8;
    wp::vec_t<3, wp::float64> var_9;
    wp::vec_t<4, wp::float64>* var_10;
    wp::int32* var_11;
    wp::vec_t<4, wp::float64> var_12;
    wp::vec_t<4, wp::float64> var_13;
    wp::int32 var_14;
    const wp::int32 var_15 = 3;
    wp::float64 var_16;
    wp::float64 var_17;
    //---------
    // forward
    // def scene_distance(p, solids__kinds, solids__rotations, solids__centers, solids__extents):       <L 1>
    // distance = float64(INFINITY) + float64(0.0)                                            <L 3>
    var_0 = INFINITY;
    var_1 = 0.0;
    var_2 = wp::add(var_0, var_1);
    // for s in range(solids__kinds.shape[0]):                                                <L 4>
    var_3 = &(var_solids__kinds.shape);
    var_6 = wp::load(var_3);
    var_5 = wp::extract(var_6, var_4);
    var_7 = wp::range(var_5);
    start_for_0:;
        if (iter_cmp(var_7) == 0) goto end_for_0;
        var_8 = wp::iter_next(var_7);
        // field = solid_field(point_in_solid(p, s, solids__rotations, solids__centers), solids__extents[s], solids__kinds[s])       <L 5>
        var_9 = point_in_solid_0(var_p, var_8, var_solids__rotations, var_solids__centers);
        var_10 = wp::address(var_solids__extents, var_8);
        var_11 = wp::address(var_solids__kinds, var_8);
        var_13 = wp::load(var_10);
        var_14 = wp::load(var_11);
        var_12 = solid_field_0(var_9, var_13, var_14);
        // distance = min(distance, field[3])                                                 <L 6>
        var_16 = wp::extract(var_12, var_15);
        var_17 = wp::min(var_2, var_16);
        wp::assign(var_2, var_17);
        goto start_for_0;
    end_for_0:;
    // return distance                                                                        <L 7>
    return var_2;
}


// <pointloom.kernels.algebra.camera.pixel_ray>:1
static wp::vec_t<3, wp::float64> pixel_ray_0(
    wp::float64 var_u,
    wp::float64 var_v,
    wp::float64 var_camera__fx,
    wp::float64 var_camera__fy,
    wp::float64 var_camera__cx,
    wp::float64 var_camera__cy)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    wp::float64 var_4;
    wp::vec_t<3, wp::float64> var_5;
    //---------
    // forward
    // def pixel_ray(u, v, camera__fx, camera__fy, camera__cx, camera__cy):                   <L 1>
    // return vec3d((u - camera__cx) / camera__fx, (v - camera__cy) / camera__fy, float64(1.0))       <L 3>
    var_0 = wp::sub(var_u, var_camera__cx);
    var_1 = wp::div(var_0, var_camera__fx);
    var_2 = wp::sub(var_v, var_camera__cy);
    var_3 = wp::div(var_2, var_camera__fy);
    var_4 = 1.0;
    var_5 = wp::vec_t<3, wp::float64>(var_1, var_3, var_4);
    return var_5;
}


// <pointloom.kernels.scenes.primitives.meet_solid>:1
static wp::float64 meet_solid_0(
    wp::vec_t<3, wp::float64> var_origin,
    wp::vec_t<3, wp::float64> var_direction,
    wp::vec_t<4, wp::float64> var_extent,
    wp::int32 var_kind,
    wp::float64 var_limit)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    wp::float64 var_4;
    const wp::int32 var_5 = 0;
    wp::float64 var_6;
    const wp::int32 var_7 = 3;
    wp::float64 var_8;
    wp::float64 var_9;
    bool var_10;
    const wp::int32 var_11 = 1;
    bool var_12;
    const wp::int32 var_13 = 1;
    bool var_14;
    const wp::int32 var_15 = 0;
    wp::float64 var_16;
    const wp::int32 var_17 = 3;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    wp::float64 var_23;
    bool var_24;
    wp::float64 var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    wp::float64 var_28;
    wp::float64 var_29;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    wp::float64 var_33;
    wp::float64 var_34;
    wp::float64 var_35;
    wp::float64 var_36;
    wp::float64 var_37;
    const wp::int32 var_38 = 1;
    wp::float64 var_39;
    const wp::int32 var_40 = 3;
    wp::float64 var_41;
    wp::float64 var_42;
    bool var_43;
    bool var_44;
    const wp::int32 var_45 = 1;
    bool var_46;
    const wp::int32 var_47 = 0;
    wp::float64 var_48;
    const wp::int32 var_49 = 3;
    wp::float64 var_50;
    wp::float64 var_51;
    wp::float64 var_52;
    wp::float64 var_53;
    wp::float64 var_54;
    wp::float64 var_55;
    bool var_56;
    wp::float64 var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float64 var_60;
    wp::float64 var_61;
    wp::float64 var_62;
    wp::float64 var_63;
    wp::float64 var_64;
    wp::float64 var_65;
    wp::float64 var_66;
    wp::float64 var_67;
    wp::float64 var_68;
    wp::float64 var_69;
    const wp::int32 var_70 = 2;
    wp::float64 var_71;
    const wp::int32 var_72 = 3;
    wp::float64 var_73;
    wp::float64 var_74;
    bool var_75;
    bool var_76;
    const wp::int32 var_77 = 1;
    bool var_78;
    const wp::int32 var_79 = 0;
    wp::float64 var_80;
    const wp::int32 var_81 = 3;
    wp::float64 var_82;
    wp::float64 var_83;
    wp::float64 var_84;
    wp::float64 var_85;
    wp::float64 var_86;
    wp::float64 var_87;
    bool var_88;
    wp::float64 var_89;
    wp::float64 var_90;
    wp::float64 var_91;
    wp::float64 var_92;
    wp::float64 var_93;
    wp::float64 var_94;
    wp::float64 var_95;
    wp::float64 var_96;
    wp::float64 var_97;
    wp::float64 var_98;
    wp::float64 var_99;
    wp::float64 var_100;
    wp::float64 var_101;
    wp::float64 var_102;
    wp::float64 var_103;
    wp::float64 var_104;
    bool var_105;
    wp::float64 var_106;
    wp::float64 var_107;
    const wp::int32 var_108 = 1;
    wp::int32 var_109;
    const wp::int32 var_110 = 0;
    wp::int32 var_111;
    const wp::int32 var_112 = 1;
    bool var_113;
    wp::vec_t<3, wp::float64> var_114;
    wp::vec_t<3, wp::float64> var_115;
    wp::vec_t<4, wp::float64> var_116;
    const wp::int32 var_117 = 0;
    wp::float64 var_118;
    const wp::int32 var_119 = 0;
    wp::float64 var_120;
    wp::float64 var_121;
    const wp::int32 var_122 = 1;
    wp::float64 var_123;
    const wp::int32 var_124 = 1;
    wp::float64 var_125;
    wp::float64 var_126;
    wp::float64 var_127;
    const wp::int32 var_128 = 2;
    wp::float64 var_129;
    const wp::int32 var_130 = 2;
    wp::float64 var_131;
    wp::float64 var_132;
    wp::float64 var_133;
    wp::float64 var_134;
    const wp::int32 var_135 = 1;
    wp::int32 var_136;
    bool var_137;
    const wp::int32 var_138 = 3;
    wp::float64 var_139;
    wp::float64 var_140;
    bool var_141;
    bool var_142;
    const wp::int32 var_143 = 40;
    bool var_144;
    const wp::int32 var_145 = 3;
    wp::float64 var_146;
    wp::float64 var_147;
    bool var_148;
    wp::float64 var_149;
    const wp::int32 var_150 = 0;
    bool var_151;
    wp::float64 var_152;
    bool var_153;
    bool var_154;
    const wp::int32 var_155 = 0;
    const wp::int32 var_156 = 3;
    wp::float64 var_157;
    wp::float64 var_158;
    wp::float64 var_159;
    bool var_160;
    const wp::int32 var_161 = 0;
    wp::int32 var_162;
    wp::float64 var_163;
    wp::int32 var_164;
    wp::float64 var_165;
    wp::float64 var_166;
    wp::int32 var_167;
    //---------
    // forward
    // def meet_solid(origin, direction, extent, kind, limit):                                <L 1>
    // near = float64(ZERO) + float64(0.0)                                                    <L 3>
    var_0 = 0.0;
    var_1 = 0.0;
    var_2 = wp::add(var_0, var_1);
    // far = limit + float64(ZERO)                                                            <L 4>
    var_3 = wp::float64(var_0);
    var_4 = wp::add(var_limit, var_3);
    // for axis in range(3):                                                                  <L 5>
    // half = extent[axis] + extent[3]                                                        <L 6>
    var_6 = wp::extract(var_extent, var_5);
    var_8 = wp::extract(var_extent, var_7);
    var_9 = wp::add(var_6, var_8);
    // if kind == CYLINDER and axis == 1:                                                     <L 7>
    var_12 = (var_kind == var_11);
    var_10 = var_12;
    if (var_10) {
        var_14 = (var_5 == var_13);
        var_10 = var_10 && var_14;
    }
    if (var_10) {
        // half = extent[0] + extent[3]                                                       <L 8>
        var_16 = wp::extract(var_extent, var_15);
        var_18 = wp::extract(var_extent, var_17);
        var_19 = wp::add(var_16, var_18);
    }
    var_20 = wp::where(var_10, var_19, var_9);
    // slope = direction[axis]                                                                <L 9>
    var_21 = wp::extract(var_direction, var_5);
    // if abs(slope) < float64(SMALLEST):                                                     <L 10>
    var_22 = wp::abs(var_21);
    var_23 = 1e-12;
    var_24 = (var_22 < var_23);
    if (var_24) {
        // slope = float64(SMALLEST)                                                          <L 11>
        var_25 = wp::float64(var_23);
    }
    var_26 = wp::where(var_24, var_25, var_21);
    // a = (-half - origin[axis]) / slope                                                     <L 12>
    var_27 = wp::neg(var_20);
    var_28 = wp::extract(var_origin, var_5);
    var_29 = wp::sub(var_27, var_28);
    var_30 = wp::div(var_29, var_26);
    // b = (half - origin[axis]) / slope                                                      <L 13>
    var_31 = wp::extract(var_origin, var_5);
    var_32 = wp::sub(var_20, var_31);
    var_33 = wp::div(var_32, var_26);
    // near = max(near, min(a, b))                                                            <L 14>
    var_34 = wp::min(var_30, var_33);
    var_35 = wp::max(var_2, var_34);
    // far = min(far, max(a, b))                                                              <L 15>
    var_36 = wp::max(var_30, var_33);
    var_37 = wp::min(var_4, var_36);
    // half = extent[axis] + extent[3]                                                        <L 6>
    var_39 = wp::extract(var_extent, var_38);
    var_41 = wp::extract(var_extent, var_40);
    var_42 = wp::add(var_39, var_41);
    // if kind == CYLINDER and axis == 1:                                                     <L 7>
    var_44 = (var_kind == var_11);
    var_43 = var_44;
    if (var_43) {
        var_46 = (var_38 == var_45);
        var_43 = var_43 && var_46;
    }
    if (var_43) {
        // half = extent[0] + extent[3]                                                       <L 8>
        var_48 = wp::extract(var_extent, var_47);
        var_50 = wp::extract(var_extent, var_49);
        var_51 = wp::add(var_48, var_50);
    }
    var_52 = wp::where(var_43, var_51, var_42);
    // slope = direction[axis]                                                                <L 9>
    var_53 = wp::extract(var_direction, var_38);
    // if abs(slope) < float64(SMALLEST):                                                     <L 10>
    var_54 = wp::abs(var_53);
    var_55 = wp::float64(var_23);
    var_56 = (var_54 < var_55);
    if (var_56) {
        // slope = float64(SMALLEST)                                                          <L 11>
        var_57 = wp::float64(var_23);
    }
    var_58 = wp::where(var_56, var_57, var_53);
    // a = (-half - origin[axis]) / slope                                                     <L 12>
    var_59 = wp::neg(var_52);
    var_60 = wp::extract(var_origin, var_38);
    var_61 = wp::sub(var_59, var_60);
    var_62 = wp::div(var_61, var_58);
    // b = (half - origin[axis]) / slope                                                      <L 13>
    var_63 = wp::extract(var_origin, var_38);
    var_64 = wp::sub(var_52, var_63);
    var_65 = wp::div(var_64, var_58);
    // near = max(near, min(a, b))                                                            <L 14>
    var_66 = wp::min(var_62, var_65);
    var_67 = wp::max(var_35, var_66);
    // far = min(far, max(a, b))                                                              <L 15>
    var_68 = wp::max(var_62, var_65);
    var_69 = wp::min(var_37, var_68);
    // half = extent[axis] + extent[3]                                                        <L 6>
    var_71 = wp::extract(var_extent, var_70);
    var_73 = wp::extract(var_extent, var_72);
    var_74 = wp::add(var_71, var_73);
    // if kind == CYLINDER and axis == 1:                                                     <L 7>
    var_76 = (var_kind == var_11);
    var_75 = var_76;
    if (var_75) {
        var_78 = (var_70 == var_77);
        var_75 = var_75 && var_78;
    }
    if (var_75) {
        // half = extent[0] + extent[3]                                                       <L 8>
        var_80 = wp::extract(var_extent, var_79);
        var_82 = wp::extract(var_extent, var_81);
        var_83 = wp::add(var_80, var_82);
    }
    var_84 = wp::where(var_75, var_83, var_74);
    // slope = direction[axis]                                                                <L 9>
    var_85 = wp::extract(var_direction, var_70);
    // if abs(slope) < float64(SMALLEST):                                                     <L 10>
    var_86 = wp::abs(var_85);
    var_87 = wp::float64(var_23);
    var_88 = (var_86 < var_87);
    if (var_88) {
        // slope = float64(SMALLEST)                                                          <L 11>
        var_89 = wp::float64(var_23);
    }
    var_90 = wp::where(var_88, var_89, var_85);
    // a = (-half - origin[axis]) / slope                                                     <L 12>
    var_91 = wp::neg(var_84);
    var_92 = wp::extract(var_origin, var_70);
    var_93 = wp::sub(var_91, var_92);
    var_94 = wp::div(var_93, var_90);
    // b = (half - origin[axis]) / slope                                                      <L 13>
    var_95 = wp::extract(var_origin, var_70);
    var_96 = wp::sub(var_84, var_95);
    var_97 = wp::div(var_96, var_90);
    // near = max(near, min(a, b))                                                            <L 14>
    var_98 = wp::min(var_94, var_97);
    var_99 = wp::max(var_67, var_98);
    // far = min(far, max(a, b))                                                              <L 15>
    var_100 = wp::max(var_94, var_97);
    var_101 = wp::min(var_69, var_100);
    // t = float64(INFINITY) + float64(0.0)                                                   <L 16>
    var_102 = INFINITY;
    var_103 = 0.0;
    var_104 = wp::add(var_102, var_103);
    // if near <= far:                                                                        <L 17>
    var_105 = (var_99 <= var_101);
    if (var_105) {
        // parameter = near + float64(ZERO)                                                   <L 18>
        var_106 = wp::float64(var_0);
        var_107 = wp::add(var_99, var_106);
        // searching = int(1)                                                                 <L 19>
        var_109 = wp::int(var_108);
        // step = int(0)                                                                      <L 20>
        var_111 = wp::int(var_110);
        // while searching == 1:                                                              <L 21>
    start_while_0:;
        var_113 = (var_109 == var_112);
    if ((var_113) == false) goto end_while_0;
            // field = solid_field(origin + direction * parameter, extent, kind)              <L 22>
            var_114 = wp::mul(var_direction, var_107);
            var_115 = wp::add(var_origin, var_114);
            var_116 = solid_field_0(var_115, var_extent, var_kind);
            // descent = -(field[0] * direction[0] + field[1] * direction[1] + field[2] * direction[2])       <L 23>
            var_118 = wp::extract(var_116, var_117);
            var_120 = wp::extract(var_direction, var_119);
            var_121 = wp::mul(var_118, var_120);
            var_123 = wp::extract(var_116, var_122);
            var_125 = wp::extract(var_direction, var_124);
            var_126 = wp::mul(var_123, var_125);
            var_127 = wp::add(var_121, var_126);
            var_129 = wp::extract(var_116, var_128);
            var_131 = wp::extract(var_direction, var_130);
            var_132 = wp::mul(var_129, var_131);
            var_133 = wp::add(var_127, var_132);
            var_134 = wp::neg(var_133);
            // step += 1                                                                      <L 24>
            var_136 = wp::add(var_111, var_135);
            // if field[3] <= float64(TOUCH) or (step > STEPS and field[3] <= float64(GRAZE)):       <L 25>
            var_139 = wp::extract(var_116, var_138);
            var_140 = 1e-09;
            var_141 = (var_139 <= var_140);
            var_137 = var_141;
            if (!var_137) {
                var_144 = (var_136 > var_143);
                var_142 = var_144;
                if (var_142) {
                    var_146 = wp::extract(var_116, var_145);
                    var_147 = 1e-06;
                    var_148 = (var_146 <= var_147);
                    var_142 = var_142 && var_148;
                }
                var_137 = var_137 || var_142;
            }
            if (var_137) {
                // t = parameter                                                              <L 26>
                var_149 = wp::copy(var_107);
                // searching = 0                                                              <L 27>
            }
            if (!var_137) {
                // elif descent <= float64(ZERO) or step > STEPS:                             <L 28>
                var_152 = wp::float64(var_0);
                var_153 = (var_134 <= var_152);
                var_151 = var_153;
                if (!var_151) {
                    var_154 = (var_136 > var_143);
                    var_151 = var_151 || var_154;
                }
                if (var_151) {
                    // searching = 0                                                          <L 29>
                }
                if (!var_151) {
                    // parameter = parameter + field[3] / descent                             <L 31>
                    var_157 = wp::extract(var_116, var_156);
                    var_158 = wp::div(var_157, var_134);
                    var_159 = wp::add(var_107, var_158);
                    // if parameter > far:                                                    <L 32>
                    var_160 = (var_159 > var_101);
                    if (var_160) {
                        // searching = 0                                                      <L 33>
                    }
                    var_162 = wp::where(var_160, var_161, var_109);
                }
                var_163 = wp::where(var_151, var_107, var_159);
                var_164 = wp::where(var_151, var_155, var_162);
            }
            var_165 = wp::where(var_137, var_149, var_104);
            var_166 = wp::where(var_137, var_107, var_163);
            var_167 = wp::where(var_137, var_150, var_164);
            wp::assign(var_104, var_165);
            wp::assign(var_107, var_166);
            wp::assign(var_109, var_167);
            wp::assign(var_111, var_136);
    goto start_while_0;
    end_while_0:;
    }
    // return t                                                                               <L 34>
    return var_104;
}


// <pointloom.kernels.scenes.primitives.scene_normal>:1
static wp::vec_t<3, wp::float64> scene_normal_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::int32 var_solid,
    wp::array_t<wp::int32> var_solids__kinds,
    wp::array_t<wp::mat_t<3, 3, wp::float64>> var_solids__rotations,
    wp::array_t<wp::vec_t<3, wp::float64>> var_solids__centers,
    wp::array_t<wp::vec_t<4, wp::float64>> var_solids__extents)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float64> var_0;
    wp::vec_t<4, wp::float64>* var_1;
    wp::int32* var_2;
    wp::vec_t<4, wp::float64> var_3;
    wp::vec_t<4, wp::float64> var_4;
    wp::int32 var_5;
    wp::mat_t<3, 3, wp::float64>* var_6;
    wp::mat_t<3, 3, wp::float64> var_7;
    wp::mat_t<3, 3, wp::float64> var_8;
    const wp::int32 var_9 = 0;
    wp::float64 var_10;
    const wp::int32 var_11 = 1;
    wp::float64 var_12;
    const wp::int32 var_13 = 2;
    wp::float64 var_14;
    wp::vec_t<3, wp::float64> var_15;
    wp::vec_t<3, wp::float64> var_16;
    //---------
    // forward
    // def scene_normal(p, solid, solids__kinds, solids__rotations, solids__centers, solids__extents):       <L 1>
    // field = solid_field(point_in_solid(p, solid, solids__rotations, solids__centers), solids__extents[solid], solids__kinds[solid])       <L 2>
    var_0 = point_in_solid_0(var_p, var_solid, var_solids__rotations, var_solids__centers);
    var_1 = wp::address(var_solids__extents, var_solid);
    var_2 = wp::address(var_solids__kinds, var_solid);
    var_4 = wp::load(var_1);
    var_5 = wp::load(var_2);
    var_3 = solid_field_0(var_0, var_4, var_5);
    // return transpose(solids__rotations[solid]) @ vec3d(field[0], field[1], field[2])       <L 3>
    var_6 = wp::address(var_solids__rotations, var_solid);
    var_8 = wp::load(var_6);
    var_7 = wp::transpose(var_8);
    var_10 = wp::extract(var_3, var_9);
    var_12 = wp::extract(var_3, var_11);
    var_14 = wp::extract(var_3, var_13);
    var_15 = wp::vec_t<3, wp::float64>(var_10, var_12, var_14);
    var_16 = wp::mul(var_7, var_15);
    return var_16;
}


// /work/main/src/pointloom/kernels/algebra/transform.py:32
static wp::vec_t<3, wp::float32> narrow_0(
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


// <pointloom.kernels.scenes.room.read_grid>:1
static wp::vec_t<2, wp::float32> read_grid_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::array_t<wp::vec_t<2, wp::float32>> var_nodes,
    wp::vec_t<3, wp::float32> var_light__low,
    wp::float32 var_light__step,
    wp::vec_t<3, wp::int32> var_light__size)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32> var_0;
    wp::vec_t<3, wp::float32> var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    const wp::float32 var_4 = 0.0;
    wp::float32 var_5;
    const wp::int32 var_6 = 0;
    wp::int32 var_7;
    const wp::int32 var_8 = 1;
    wp::int32 var_9;
    wp::float32 var_10;
    const wp::float32 var_11 = 0.001;
    wp::float32 var_12;
    wp::float32 var_13;
    const wp::int32 var_14 = 1;
    wp::float32 var_15;
    const wp::float32 var_16 = 0.0;
    wp::float32 var_17;
    const wp::int32 var_18 = 1;
    wp::int32 var_19;
    const wp::int32 var_20 = 1;
    wp::int32 var_21;
    wp::float32 var_22;
    const wp::float32 var_23 = 0.001;
    wp::float32 var_24;
    wp::float32 var_25;
    const wp::int32 var_26 = 2;
    wp::float32 var_27;
    const wp::float32 var_28 = 0.0;
    wp::float32 var_29;
    const wp::int32 var_30 = 2;
    wp::int32 var_31;
    const wp::int32 var_32 = 1;
    wp::int32 var_33;
    wp::float32 var_34;
    const wp::float32 var_35 = 0.001;
    wp::float32 var_36;
    wp::float32 var_37;
    wp::int32 var_38;
    wp::int32 var_39;
    wp::int32 var_40;
    wp::float32 var_41;
    wp::float32 var_42;
    wp::float32 var_43;
    wp::float32 var_44;
    wp::float32 var_45;
    wp::float32 var_46;
    const wp::int32 var_47 = 1;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::int32 var_50;
    const wp::int32 var_51 = 2;
    wp::int32 var_52;
    wp::int32 var_53;
    wp::int32 var_54;
    const wp::int32 var_55 = 2;
    wp::int32 var_56;
    wp::int32 var_57;
    const wp::int32 var_58 = 1;
    wp::int32 var_59;
    const wp::int32 var_60 = 2;
    wp::int32 var_61;
    wp::int32 var_62;
    wp::int32 var_63;
    const wp::int32 var_64 = 2;
    wp::int32 var_65;
    wp::int32 var_66;
    wp::vec_t<2, wp::float32>* var_67;
    const wp::float32 var_68 = 1.0;
    wp::float32 var_69;
    wp::vec_t<2, wp::float32> var_70;
    wp::vec_t<2, wp::float32> var_71;
    const wp::int32 var_72 = 1;
    wp::int32 var_73;
    wp::vec_t<2, wp::float32>* var_74;
    wp::vec_t<2, wp::float32> var_75;
    wp::vec_t<2, wp::float32> var_76;
    wp::vec_t<2, wp::float32> var_77;
    const wp::float32 var_78 = 1.0;
    wp::float32 var_79;
    wp::vec_t<2, wp::float32> var_80;
    wp::vec_t<2, wp::float32>* var_81;
    const wp::float32 var_82 = 1.0;
    wp::float32 var_83;
    wp::vec_t<2, wp::float32> var_84;
    wp::vec_t<2, wp::float32> var_85;
    const wp::int32 var_86 = 1;
    wp::int32 var_87;
    wp::vec_t<2, wp::float32>* var_88;
    wp::vec_t<2, wp::float32> var_89;
    wp::vec_t<2, wp::float32> var_90;
    wp::vec_t<2, wp::float32> var_91;
    wp::vec_t<2, wp::float32> var_92;
    wp::vec_t<2, wp::float32> var_93;
    wp::vec_t<2, wp::float32>* var_94;
    const wp::float32 var_95 = 1.0;
    wp::float32 var_96;
    wp::vec_t<2, wp::float32> var_97;
    wp::vec_t<2, wp::float32> var_98;
    const wp::int32 var_99 = 1;
    wp::int32 var_100;
    wp::vec_t<2, wp::float32>* var_101;
    wp::vec_t<2, wp::float32> var_102;
    wp::vec_t<2, wp::float32> var_103;
    wp::vec_t<2, wp::float32> var_104;
    const wp::float32 var_105 = 1.0;
    wp::float32 var_106;
    wp::vec_t<2, wp::float32> var_107;
    wp::vec_t<2, wp::float32>* var_108;
    const wp::float32 var_109 = 1.0;
    wp::float32 var_110;
    wp::vec_t<2, wp::float32> var_111;
    wp::vec_t<2, wp::float32> var_112;
    const wp::int32 var_113 = 1;
    wp::int32 var_114;
    wp::vec_t<2, wp::float32>* var_115;
    wp::vec_t<2, wp::float32> var_116;
    wp::vec_t<2, wp::float32> var_117;
    wp::vec_t<2, wp::float32> var_118;
    wp::vec_t<2, wp::float32> var_119;
    wp::vec_t<2, wp::float32> var_120;
    const wp::float32 var_121 = 1.0;
    wp::float32 var_122;
    wp::vec_t<2, wp::float32> var_123;
    wp::vec_t<2, wp::float32> var_124;
    wp::vec_t<2, wp::float32> var_125;
    //---------
    // forward
    // def read_grid(p, nodes, light__low, light__step, light__size):                         <L 1>
    // u = (p - light__low) / light__step                                                     <L 2>
    var_0 = wp::sub(var_p, var_light__low);
    var_1 = wp::div(var_0, var_light__step);
    // x = min(max(u[0], 0.0), float(light__size[0] - 1) - 0.001)                             <L 3>
    var_3 = wp::extract(var_1, var_2);
    var_5 = wp::max(var_3, var_4);
    var_7 = wp::extract(var_light__size, var_6);
    var_9 = wp::sub(var_7, var_8);
    var_10 = wp::float(var_9);
    var_12 = wp::sub(var_10, var_11);
    var_13 = wp::min(var_5, var_12);
    // y = min(max(u[1], 0.0), float(light__size[1] - 1) - 0.001)                             <L 4>
    var_15 = wp::extract(var_1, var_14);
    var_17 = wp::max(var_15, var_16);
    var_19 = wp::extract(var_light__size, var_18);
    var_21 = wp::sub(var_19, var_20);
    var_22 = wp::float(var_21);
    var_24 = wp::sub(var_22, var_23);
    var_25 = wp::min(var_17, var_24);
    // z = min(max(u[2], 0.0), float(light__size[2] - 1) - 0.001)                             <L 5>
    var_27 = wp::extract(var_1, var_26);
    var_29 = wp::max(var_27, var_28);
    var_31 = wp::extract(var_light__size, var_30);
    var_33 = wp::sub(var_31, var_32);
    var_34 = wp::float(var_33);
    var_36 = wp::sub(var_34, var_35);
    var_37 = wp::min(var_29, var_36);
    // ix = int(x)                                                                            <L 6>
    var_38 = wp::int(var_13);
    // iy = int(y)                                                                            <L 7>
    var_39 = wp::int(var_25);
    // iz = int(z)                                                                            <L 8>
    var_40 = wp::int(var_37);
    // fx = x - float(ix)                                                                     <L 9>
    var_41 = wp::float(var_38);
    var_42 = wp::sub(var_13, var_41);
    // fy = y - float(iy)                                                                     <L 10>
    var_43 = wp::float(var_39);
    var_44 = wp::sub(var_25, var_43);
    // fz = z - float(iz)                                                                     <L 11>
    var_45 = wp::float(var_40);
    var_46 = wp::sub(var_37, var_45);
    // a = (ix * light__size[1] + iy) * light__size[2] + iz                                   <L 12>
    var_48 = wp::extract(var_light__size, var_47);
    var_49 = wp::mul(var_38, var_48);
    var_50 = wp::add(var_49, var_39);
    var_52 = wp::extract(var_light__size, var_51);
    var_53 = wp::mul(var_50, var_52);
    var_54 = wp::add(var_53, var_40);
    // b = a + light__size[2]                                                                 <L 13>
    var_56 = wp::extract(var_light__size, var_55);
    var_57 = wp::add(var_54, var_56);
    // c = a + light__size[1] * light__size[2]                                                <L 14>
    var_59 = wp::extract(var_light__size, var_58);
    var_61 = wp::extract(var_light__size, var_60);
    var_62 = wp::mul(var_59, var_61);
    var_63 = wp::add(var_54, var_62);
    // d = c + light__size[2]                                                                 <L 15>
    var_65 = wp::extract(var_light__size, var_64);
    var_66 = wp::add(var_63, var_65);
    // near = (nodes[a] * (1.0 - fz) + nodes[a + 1] * fz) * (1.0 - fy) + (nodes[b] * (1.0 - fz) + nodes[b + 1] * fz) * fy       <L 16>
    var_67 = wp::address(var_nodes, var_54);
    var_69 = wp::sub(var_68, var_46);
    var_71 = wp::load(var_67);
    var_70 = wp::mul(var_71, var_69);
    var_73 = wp::add(var_54, var_72);
    var_74 = wp::address(var_nodes, var_73);
    var_76 = wp::load(var_74);
    var_75 = wp::mul(var_76, var_46);
    var_77 = wp::add(var_70, var_75);
    var_79 = wp::sub(var_78, var_44);
    var_80 = wp::mul(var_77, var_79);
    var_81 = wp::address(var_nodes, var_57);
    var_83 = wp::sub(var_82, var_46);
    var_85 = wp::load(var_81);
    var_84 = wp::mul(var_85, var_83);
    var_87 = wp::add(var_57, var_86);
    var_88 = wp::address(var_nodes, var_87);
    var_90 = wp::load(var_88);
    var_89 = wp::mul(var_90, var_46);
    var_91 = wp::add(var_84, var_89);
    var_92 = wp::mul(var_91, var_44);
    var_93 = wp::add(var_80, var_92);
    // far = (nodes[c] * (1.0 - fz) + nodes[c + 1] * fz) * (1.0 - fy) + (nodes[d] * (1.0 - fz) + nodes[d + 1] * fz) * fy       <L 17>
    var_94 = wp::address(var_nodes, var_63);
    var_96 = wp::sub(var_95, var_46);
    var_98 = wp::load(var_94);
    var_97 = wp::mul(var_98, var_96);
    var_100 = wp::add(var_63, var_99);
    var_101 = wp::address(var_nodes, var_100);
    var_103 = wp::load(var_101);
    var_102 = wp::mul(var_103, var_46);
    var_104 = wp::add(var_97, var_102);
    var_106 = wp::sub(var_105, var_44);
    var_107 = wp::mul(var_104, var_106);
    var_108 = wp::address(var_nodes, var_66);
    var_110 = wp::sub(var_109, var_46);
    var_112 = wp::load(var_108);
    var_111 = wp::mul(var_112, var_110);
    var_114 = wp::add(var_66, var_113);
    var_115 = wp::address(var_nodes, var_114);
    var_117 = wp::load(var_115);
    var_116 = wp::mul(var_117, var_46);
    var_118 = wp::add(var_111, var_116);
    var_119 = wp::mul(var_118, var_44);
    var_120 = wp::add(var_107, var_119);
    // return near * (1.0 - fx) + far * fx                                                    <L 18>
    var_122 = wp::sub(var_121, var_42);
    var_123 = wp::mul(var_93, var_122);
    var_124 = wp::mul(var_120, var_42);
    var_125 = wp::add(var_123, var_124);
    return var_125;
}


// <pointloom.kernels.scenes.room.light_surface>:1
static wp::float32 light_surface_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_normal,
    wp::vec_t<3, wp::float32> var_light__lamp,
    wp::vec_t<3, wp::float32> var_light__low,
    wp::float32 var_light__step,
    wp::vec_t<3, wp::int32> var_light__size,
    wp::array_t<wp::vec_t<2, wp::float32>> var_light__nodes)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.07;
    wp::vec_t<3, wp::float32> var_1;
    wp::vec_t<3, wp::float32> var_2;
    wp::vec_t<2, wp::float32> var_3;
    const wp::float32 var_4 = 0.28;
    wp::vec_t<3, wp::float32> var_5;
    wp::vec_t<3, wp::float32> var_6;
    wp::vec_t<2, wp::float32> var_7;
    const wp::float32 var_8 = 0.4;
    const wp::int32 var_9 = 0;
    wp::float32 var_10;
    wp::float32 var_11;
    wp::float32 var_12;
    const wp::float32 var_13 = 0.6;
    const wp::int32 var_14 = 0;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    const wp::float32 var_19 = 0.35;
    const wp::float32 var_20 = 0.65;
    const wp::float32 var_21 = 0.0;
    wp::float32 var_22;
    const wp::float32 var_23 = 1.0;
    wp::float32 var_24;
    wp::float32 var_25;
    wp::float32 var_26;
    wp::vec_t<3, wp::float32> var_27;
    wp::float32 var_28;
    wp::float32 var_29;
    wp::float32 var_30;
    const wp::float32 var_31 = 0.0;
    wp::float32 var_32;
    const wp::int32 var_33 = 1;
    wp::float32 var_34;
    wp::float32 var_35;
    const wp::float32 var_36 = 1.0;
    const wp::float32 var_37 = 1.0;
    wp::float32 var_38;
    const wp::float32 var_39 = 3.2;
    wp::float32 var_40;
    wp::float32 var_41;
    wp::float32 var_42;
    wp::float32 var_43;
    const wp::float32 var_44 = 0.54;
    const wp::float32 var_45 = 0.04;
    const wp::int32 var_46 = 2;
    wp::float32 var_47;
    wp::float32 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    const wp::float32 var_51 = 0.85;
    wp::float32 var_52;
    wp::float32 var_53;
    const wp::float32 var_54 = 0.6;
    const wp::float32 var_55 = 0.4;
    wp::float32 var_56;
    wp::float32 var_57;
    wp::float32 var_58;
    wp::float32 var_59;
    //---------
    // forward
    // def light_surface(p, normal, light__lamp, light__low, light__step, light__size, light__nodes):       <L 1>
    // near = read_grid(p + normal * NEAR_CORNER, light__nodes, light__low, light__step, light__size)       <L 3>
    var_1 = wp::mul(var_normal, var_0);
    var_2 = wp::add(var_p, var_1);
    var_3 = read_grid_0(var_2, var_light__nodes, var_light__low, var_light__step, var_light__size);
    // far = read_grid(p + normal * FAR_CORNER, light__nodes, light__low, light__step, light__size)       <L 4>
    var_5 = wp::mul(var_normal, var_4);
    var_6 = wp::add(var_p, var_5);
    var_7 = read_grid_0(var_6, var_light__nodes, var_light__low, var_light__step, var_light__size);
    // open_share = 0.4 * near[0] / NEAR_CORNER + 0.6 * far[0] / FAR_CORNER                   <L 5>
    var_10 = wp::extract(var_3, var_9);
    var_11 = wp::mul(var_8, var_10);
    var_12 = wp::div(var_11, var_0);
    var_15 = wp::extract(var_7, var_14);
    var_16 = wp::mul(var_13, var_15);
    var_17 = wp::div(var_16, var_4);
    var_18 = wp::add(var_12, var_17);
    // openness = 0.35 + 0.65 * min(max(open_share, 0.0), 1.0)                                <L 6>
    var_22 = wp::max(var_18, var_21);
    var_24 = wp::min(var_22, var_23);
    var_25 = wp::mul(var_20, var_24);
    var_26 = wp::add(var_19, var_25);
    // way = light__lamp - p                                                                  <L 7>
    var_27 = wp::sub(var_light__lamp, var_p);
    // distance = length(way)                                                                 <L 8>
    var_28 = wp::length(var_27);
    // lit = max(dot(normal, way) / distance, 0.0) * near[1]                                  <L 9>
    var_29 = wp::dot(var_normal, var_27);
    var_30 = wp::div(var_29, var_28);
    var_32 = wp::max(var_30, var_31);
    var_34 = wp::extract(var_3, var_33);
    var_35 = wp::mul(var_32, var_34);
    // fall = 1.0 / (1.0 + distance * distance / (LAMP_RANGE * LAMP_RANGE))                   <L 10>
    var_38 = wp::mul(var_28, var_28);
    var_40 = wp::mul(var_39, var_39);
    var_41 = wp::div(var_38, var_40);
    var_42 = wp::add(var_37, var_41);
    var_43 = wp::div(var_36, var_42);
    // return (AMBIENT + SKY * normal[2]) * openness + LAMP * lit * fall * (0.6 + 0.4 * openness)       <L 11>
    var_47 = wp::extract(var_normal, var_46);
    var_48 = wp::mul(var_45, var_47);
    var_49 = wp::add(var_44, var_48);
    var_50 = wp::mul(var_49, var_26);
    var_52 = wp::mul(var_51, var_35);
    var_53 = wp::mul(var_52, var_43);
    var_56 = wp::mul(var_55, var_26);
    var_57 = wp::add(var_54, var_56);
    var_58 = wp::mul(var_53, var_57);
    var_59 = wp::add(var_50, var_58);
    return var_59;
}


// <pointloom.kernels.scenes.room.pattern_weight>:1
static wp::float32 pattern_weight_0(
    wp::vec_t<3, wp::float32> var_q,
    wp::int32 var_kind,
    wp::float32 var_size)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32> var_0;
    const wp::float32 var_1 = 0.137;
    wp::vec_t<3, wp::float32> var_2;
    wp::vec_t<3, wp::float32> var_3;
    const wp::float32 var_4 = 0.0;
    wp::float32 var_5;
    const wp::int32 var_6 = 1;
    bool var_7;
    const wp::int32 var_8 = 0;
    wp::float32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 1;
    wp::float32 var_12;
    wp::float32 var_13;
    wp::float32 var_14;
    const wp::int32 var_15 = 2;
    wp::float32 var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    const wp::float32 var_19 = 2.0;
    const wp::float32 var_20 = 0.5;
    wp::float32 var_21;
    wp::float32 var_22;
    wp::float32 var_23;
    wp::float32 var_24;
    const wp::int32 var_25 = 2;
    bool var_26;
    const wp::int32 var_27 = 0;
    wp::float32 var_28;
    wp::float32 var_29;
    const wp::float32 var_30 = 2.0;
    const wp::int32 var_31 = 0;
    wp::float32 var_32;
    const wp::float32 var_33 = 0.5;
    wp::float32 var_34;
    wp::float32 var_35;
    wp::float32 var_36;
    wp::float32 var_37;
    const wp::int32 var_38 = 3;
    bool var_39;
    const wp::int32 var_40 = 1;
    wp::float32 var_41;
    wp::float32 var_42;
    const wp::int32 var_43 = 0;
    wp::float32 var_44;
    const wp::float32 var_45 = 5.0;
    wp::float32 var_46;
    const wp::float32 var_47 = 0.381966;
    wp::float32 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    const wp::float32 var_51 = 7.13;
    wp::float32 var_52;
    const wp::float32 var_53 = 3.71;
    wp::float32 var_54;
    wp::float32 var_55;
    const wp::float32 var_56 = 0.75;
    const wp::float32 var_57 = 0.618034;
    wp::float32 var_58;
    const wp::float32 var_59 = 0.618034;
    wp::float32 var_60;
    wp::float32 var_61;
    wp::float32 var_62;
    wp::float32 var_63;
    bool var_64;
    const wp::int32 var_65 = 1;
    wp::float32 var_66;
    wp::float32 var_67;
    const wp::float32 var_68 = 0.04;
    bool var_69;
    wp::float32 var_70;
    wp::float32 var_71;
    wp::float32 var_72;
    const wp::float32 var_73 = 0.04;
    bool var_74;
    const wp::float32 var_75 = 1.0;
    wp::float32 var_76;
    wp::float32 var_77;
    wp::float32 var_78;
    wp::float32 var_79;
    //---------
    // forward
    // def pattern_weight(q, kind, size):                                                     <L 1>
    // u = q / size + vec3(SEAM, SEAM, SEAM)                                                  <L 3>
    var_0 = wp::div(var_q, var_size);
    var_2 = wp::vec_t<3, wp::float32>(var_1, var_1, var_1);
    var_3 = wp::add(var_0, var_2);
    // weight = float(0.0)                                                                    <L 4>
    var_5 = wp::float(var_4);
    // if kind == CHECKER:                                                                    <L 5>
    var_7 = (var_kind == var_6);
    if (var_7) {
        // total = floor(u[0]) + floor(u[1]) + floor(u[2])                                    <L 6>
        var_9 = wp::extract(var_3, var_8);
        var_10 = wp::floor(var_9);
        var_12 = wp::extract(var_3, var_11);
        var_13 = wp::floor(var_12);
        var_14 = wp::add(var_10, var_13);
        var_16 = wp::extract(var_3, var_15);
        var_17 = wp::floor(var_16);
        var_18 = wp::add(var_14, var_17);
        // weight = total - 2.0 * floor(total * 0.5)                                          <L 7>
        var_21 = wp::mul(var_18, var_20);
        var_22 = wp::floor(var_21);
        var_23 = wp::mul(var_19, var_22);
        var_24 = wp::sub(var_18, var_23);
    }
    if (!var_7) {
        // elif kind == STRIPES:                                                              <L 8>
        var_26 = (var_kind == var_25);
        if (var_26) {
            // weight = floor(u[0]) - 2.0 * floor(u[0] * 0.5)                                 <L 9>
            var_28 = wp::extract(var_3, var_27);
            var_29 = wp::floor(var_28);
            var_32 = wp::extract(var_3, var_31);
            var_34 = wp::mul(var_32, var_33);
            var_35 = wp::floor(var_34);
            var_36 = wp::mul(var_30, var_35);
            var_37 = wp::sub(var_29, var_36);
        }
        if (!var_26) {
            // elif kind == PLANKS:                                                           <L 10>
            var_39 = (var_kind == var_38);
            if (var_39) {
                // row = floor(u[1])                                                          <L 11>
                var_41 = wp::extract(var_3, var_40);
                var_42 = wp::floor(var_41);
                // coordinate = u[0] / PLANK_LENGTH + row * 0.381966                          <L 12>
                var_44 = wp::extract(var_3, var_43);
                var_46 = wp::div(var_44, var_45);
                var_48 = wp::mul(var_42, var_47);
                var_49 = wp::add(var_46, var_48);
                // plank = floor(coordinate) * 7.13 + row * 3.71                              <L 13>
                var_50 = wp::floor(var_49);
                var_52 = wp::mul(var_50, var_51);
                var_54 = wp::mul(var_42, var_53);
                var_55 = wp::add(var_52, var_54);
                // weight = 0.75 * (plank * 0.618034 - floor(plank * 0.618034))               <L 14>
                var_58 = wp::mul(var_55, var_57);
                var_60 = wp::mul(var_55, var_59);
                var_61 = wp::floor(var_60);
                var_62 = wp::sub(var_58, var_61);
                var_63 = wp::mul(var_56, var_62);
                // if u[1] - row < 0.04 or (coordinate - floor(coordinate)) * PLANK_LENGTH < 0.04:       <L 15>
                var_66 = wp::extract(var_3, var_65);
                var_67 = wp::sub(var_66, var_42);
                var_69 = (var_67 < var_68);
                var_64 = var_69;
                if (!var_64) {
                    var_70 = wp::floor(var_49);
                    var_71 = wp::sub(var_49, var_70);
                    var_72 = wp::mul(var_71, var_45);
                    var_74 = (var_72 < var_73);
                    var_64 = var_64 || var_74;
                }
                if (var_64) {
                    // weight = 1.0                                                           <L 16>
                }
                var_76 = wp::where(var_64, var_75, var_63);
            }
            var_77 = wp::where(var_39, var_76, var_5);
        }
        var_78 = wp::where(var_26, var_37, var_77);
    }
    var_79 = wp::where(var_7, var_24, var_78);
    // return weight                                                                          <L 17>
    return var_79;
}


// <pointloom.kernels.scenes.room.color_at>:1
static wp::vec_t<3, wp::float32> color_at_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::vec_t<3, wp::float64> var_normal,
    wp::int32 var_solid,
    wp::array_t<wp::mat_t<3, 3, wp::float64>> var_room__solids__rotations,
    wp::array_t<wp::vec_t<3, wp::float64>> var_room__solids__centers,
    wp::array_t<wp::vec_t<3, wp::float32>> var_room__paints,
    wp::array_t<wp::vec_t<2, wp::float32>> var_room__patterns,
    wp::vec_t<3, wp::float32> var_room__light__lamp,
    wp::vec_t<3, wp::float32> var_room__light__low,
    wp::float32 var_room__light__step,
    wp::vec_t<3, wp::int32> var_room__light__size,
    wp::array_t<wp::vec_t<2, wp::float32>> var_room__light__nodes)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float64> var_0;
    wp::vec_t<3, wp::float32> var_1;
    wp::vec_t<3, wp::float32> var_2;
    wp::float32 var_3;
    wp::vec_t<2, wp::float32>* var_4;
    wp::vec_t<2, wp::float32> var_5;
    wp::vec_t<2, wp::float32> var_6;
    const wp::int32 var_7 = 0;
    wp::float32 var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 4;
    bool var_11;
    const wp::float32 var_12 = 1.0;
    wp::float32 var_13;
    wp::vec_t<3, wp::float32> var_14;
    const wp::int32 var_15 = 0;
    wp::float32 var_16;
    wp::int32 var_17;
    const wp::int32 var_18 = 1;
    wp::float32 var_19;
    wp::float32 var_20;
    const wp::int32 var_21 = 2;
    wp::int32 var_22;
    wp::vec_t<3, wp::float32>* var_23;
    const wp::float32 var_24 = 1.0;
    wp::float32 var_25;
    wp::vec_t<3, wp::float32> var_26;
    wp::vec_t<3, wp::float32> var_27;
    const wp::int32 var_28 = 2;
    wp::int32 var_29;
    const wp::int32 var_30 = 1;
    wp::int32 var_31;
    wp::vec_t<3, wp::float32>* var_32;
    wp::vec_t<3, wp::float32> var_33;
    wp::vec_t<3, wp::float32> var_34;
    wp::vec_t<3, wp::float32> var_35;
    wp::vec_t<3, wp::float32> var_36;
    //---------
    // forward
    // def color_at(p, normal, solid, room__solids__rotations, room__solids__centers, room__paints, room__patterns, room__light__lamp, room__light__low, room__light__step, room__light__size, room__light__nodes):       <L 1>
    // q = point_in_solid(p, solid, room__solids__rotations, room__solids__centers)           <L 2>
    var_0 = point_in_solid_0(var_p, var_solid, var_room__solids__rotations, var_room__solids__centers);
    // light = light_surface(narrow(p), narrow(normal), room__light__lamp, room__light__low, room__light__step, room__light__size, room__light__nodes)       <L 3>
    var_1 = narrow_0(var_p);
    var_2 = narrow_0(var_normal);
    var_3 = light_surface_0(var_1, var_2, var_room__light__lamp, var_room__light__low, var_room__light__step, var_room__light__size, var_room__light__nodes);
    // pattern = room__patterns[solid]                                                        <L 4>
    var_4 = wp::address(var_room__patterns, var_solid);
    var_6 = wp::load(var_4);
    var_5 = wp::copy(var_6);
    // if int(pattern[0]) == GLOW:                                                            <L 5>
    var_8 = wp::extract(var_5, var_7);
    var_9 = wp::int(var_8);
    var_11 = (var_9 == var_10);
    if (var_11) {
        // light = 1.0                                                                        <L 6>
    }
    var_13 = wp::where(var_11, var_12, var_3);
    // weight = pattern_weight(narrow(q), int(pattern[0]), pattern[1])                        <L 7>
    var_14 = narrow_0(var_0);
    var_16 = wp::extract(var_5, var_15);
    var_17 = wp::int(var_16);
    var_19 = wp::extract(var_5, var_18);
    var_20 = pattern_weight_0(var_14, var_17, var_19);
    // return (room__paints[2 * solid] * (1.0 - weight) + room__paints[2 * solid + 1] * weight) * light       <L 8>
    var_22 = wp::mul(var_21, var_solid);
    var_23 = wp::address(var_room__paints, var_22);
    var_25 = wp::sub(var_24, var_20);
    var_27 = wp::load(var_23);
    var_26 = wp::mul(var_27, var_25);
    var_29 = wp::mul(var_28, var_solid);
    var_31 = wp::add(var_29, var_30);
    var_32 = wp::address(var_room__paints, var_31);
    var_34 = wp::load(var_32);
    var_33 = wp::mul(var_34, var_20);
    var_35 = wp::add(var_26, var_33);
    var_36 = wp::mul(var_35, var_13);
    return var_36;
}


// /work/main/src/pointloom/kernels/drawing/shading.py:144
static wp::uint8 color_byte_0(
    wp::float32 var_value)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    wp::float32 var_1;
    const wp::float32 var_2 = 1.0;
    wp::float32 var_3;
    const wp::float32 var_4 = 255.0;
    wp::float32 var_5;
    const wp::float32 var_6 = 0.5;
    wp::float32 var_7;
    wp::int32 var_8;
    wp::uint8 var_9;
    //---------
    // forward
    // def color_byte(value: float) -> uint8:                                                 <L 145>
    // return uint8(int(min(max(value, 0.0), 1.0) * 255.0 + 0.5))                             <L 146>
    var_1 = wp::max(var_value, var_0);
    var_3 = wp::min(var_1, var_2);
    var_5 = wp::mul(var_3, var_4);
    var_7 = wp::add(var_5, var_6);
    var_8 = wp::int(var_7);
    var_9 = wp::uint8(var_8);
    return var_9;
}


// <pointloom.kernels.scenes.room.node_index>:1
static void adj_node_index_0(
    wp::int32 var_i,
    wp::vec_t<3, wp::int32> var_light__size,
    wp::int32 & adj_i,
    wp::vec_t<3, wp::int32> & adj_light__size,
    wp::vec_t<3, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.scenes.primitives.point_in_solid>:1
static void adj_point_in_solid_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::int32 var_solid,
    wp::array_t<wp::mat_t<3, 3, wp::float64>> var_solids__rotations,
    wp::array_t<wp::vec_t<3, wp::float64>> var_solids__centers,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::int32 & adj_solid,
    wp::array_t<wp::mat_t<3, 3, wp::float64>> & adj_solids__rotations,
    wp::array_t<wp::vec_t<3, wp::float64>> & adj_solids__centers,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/scenes/primitives.py:41
static void adj_box_field_0(
    wp::vec_t<3, wp::float64> var_q,
    wp::vec_t<4, wp::float64> var_extent,
    wp::vec_t<3, wp::float64> & adj_q,
    wp::vec_t<4, wp::float64> & adj_extent,
    wp::vec_t<4, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/scenes/primitives.py:71
static void adj_cylinder_field_0(
    wp::vec_t<3, wp::float64> var_q,
    wp::vec_t<4, wp::float64> var_extent,
    wp::vec_t<3, wp::float64> & adj_q,
    wp::vec_t<4, wp::float64> & adj_extent,
    wp::vec_t<4, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/scenes/primitives.py:84
static void adj_solid_field_0(
    wp::vec_t<3, wp::float64> var_q,
    wp::vec_t<4, wp::float64> var_extent,
    wp::int32 var_kind,
    wp::vec_t<3, wp::float64> & adj_q,
    wp::vec_t<4, wp::float64> & adj_extent,
    wp::int32 & adj_kind,
    wp::vec_t<4, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.scenes.primitives.scene_distance>:1
static void adj_scene_distance_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::array_t<wp::int32> var_solids__kinds,
    wp::array_t<wp::mat_t<3, 3, wp::float64>> var_solids__rotations,
    wp::array_t<wp::vec_t<3, wp::float64>> var_solids__centers,
    wp::array_t<wp::vec_t<4, wp::float64>> var_solids__extents,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::array_t<wp::int32> & adj_solids__kinds,
    wp::array_t<wp::mat_t<3, 3, wp::float64>> & adj_solids__rotations,
    wp::array_t<wp::vec_t<3, wp::float64>> & adj_solids__centers,
    wp::array_t<wp::vec_t<4, wp::float64>> & adj_solids__extents,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.camera.pixel_ray>:1
static void adj_pixel_ray_0(
    wp::float64 var_u,
    wp::float64 var_v,
    wp::float64 var_camera__fx,
    wp::float64 var_camera__fy,
    wp::float64 var_camera__cx,
    wp::float64 var_camera__cy,
    wp::float64 & adj_u,
    wp::float64 & adj_v,
    wp::float64 & adj_camera__fx,
    wp::float64 & adj_camera__fy,
    wp::float64 & adj_camera__cx,
    wp::float64 & adj_camera__cy,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.scenes.primitives.meet_solid>:1
static void adj_meet_solid_0(
    wp::vec_t<3, wp::float64> var_origin,
    wp::vec_t<3, wp::float64> var_direction,
    wp::vec_t<4, wp::float64> var_extent,
    wp::int32 var_kind,
    wp::float64 var_limit,
    wp::vec_t<3, wp::float64> & adj_origin,
    wp::vec_t<3, wp::float64> & adj_direction,
    wp::vec_t<4, wp::float64> & adj_extent,
    wp::int32 & adj_kind,
    wp::float64 & adj_limit,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.scenes.primitives.scene_normal>:1
static void adj_scene_normal_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::int32 var_solid,
    wp::array_t<wp::int32> var_solids__kinds,
    wp::array_t<wp::mat_t<3, 3, wp::float64>> var_solids__rotations,
    wp::array_t<wp::vec_t<3, wp::float64>> var_solids__centers,
    wp::array_t<wp::vec_t<4, wp::float64>> var_solids__extents,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::int32 & adj_solid,
    wp::array_t<wp::int32> & adj_solids__kinds,
    wp::array_t<wp::mat_t<3, 3, wp::float64>> & adj_solids__rotations,
    wp::array_t<wp::vec_t<3, wp::float64>> & adj_solids__centers,
    wp::array_t<wp::vec_t<4, wp::float64>> & adj_solids__extents,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/transform.py:32
static void adj_narrow_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.scenes.room.read_grid>:1
static void adj_read_grid_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::array_t<wp::vec_t<2, wp::float32>> var_nodes,
    wp::vec_t<3, wp::float32> var_light__low,
    wp::float32 var_light__step,
    wp::vec_t<3, wp::int32> var_light__size,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::array_t<wp::vec_t<2, wp::float32>> & adj_nodes,
    wp::vec_t<3, wp::float32> & adj_light__low,
    wp::float32 & adj_light__step,
    wp::vec_t<3, wp::int32> & adj_light__size,
    wp::vec_t<2, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.scenes.room.light_surface>:1
static void adj_light_surface_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_normal,
    wp::vec_t<3, wp::float32> var_light__lamp,
    wp::vec_t<3, wp::float32> var_light__low,
    wp::float32 var_light__step,
    wp::vec_t<3, wp::int32> var_light__size,
    wp::array_t<wp::vec_t<2, wp::float32>> var_light__nodes,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_normal,
    wp::vec_t<3, wp::float32> & adj_light__lamp,
    wp::vec_t<3, wp::float32> & adj_light__low,
    wp::float32 & adj_light__step,
    wp::vec_t<3, wp::int32> & adj_light__size,
    wp::array_t<wp::vec_t<2, wp::float32>> & adj_light__nodes,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.scenes.room.pattern_weight>:1
static void adj_pattern_weight_0(
    wp::vec_t<3, wp::float32> var_q,
    wp::int32 var_kind,
    wp::float32 var_size,
    wp::vec_t<3, wp::float32> & adj_q,
    wp::int32 & adj_kind,
    wp::float32 & adj_size,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.scenes.room.color_at>:1
static void adj_color_at_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::vec_t<3, wp::float64> var_normal,
    wp::int32 var_solid,
    wp::array_t<wp::mat_t<3, 3, wp::float64>> var_room__solids__rotations,
    wp::array_t<wp::vec_t<3, wp::float64>> var_room__solids__centers,
    wp::array_t<wp::vec_t<3, wp::float32>> var_room__paints,
    wp::array_t<wp::vec_t<2, wp::float32>> var_room__patterns,
    wp::vec_t<3, wp::float32> var_room__light__lamp,
    wp::vec_t<3, wp::float32> var_room__light__low,
    wp::float32 var_room__light__step,
    wp::vec_t<3, wp::int32> var_room__light__size,
    wp::array_t<wp::vec_t<2, wp::float32>> var_room__light__nodes,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::vec_t<3, wp::float64> & adj_normal,
    wp::int32 & adj_solid,
    wp::array_t<wp::mat_t<3, 3, wp::float64>> & adj_room__solids__rotations,
    wp::array_t<wp::vec_t<3, wp::float64>> & adj_room__solids__centers,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_room__paints,
    wp::array_t<wp::vec_t<2, wp::float32>> & adj_room__patterns,
    wp::vec_t<3, wp::float32> & adj_room__light__lamp,
    wp::vec_t<3, wp::float32> & adj_room__light__low,
    wp::float32 & adj_room__light__step,
    wp::vec_t<3, wp::int32> & adj_room__light__size,
    wp::array_t<wp::vec_t<2, wp::float32>> & adj_room__light__nodes,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/drawing/shading.py:144
static void adj_color_byte_0(
    wp::float32 var_value,
    wp::float32 & adj_value,
    wp::uint8 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}

struct wp_args_sample_distances_kernel_1b709d4f {
    wp::vec_t<3, wp::int32> light__size;
    wp::vec_t<3, wp::float64> low;
    wp::float64 step;
    wp::array_t<wp::int32> solids__kinds;
    wp::array_t<wp::mat_t<3, 3, wp::float64>> solids__rotations;
    wp::array_t<wp::vec_t<3, wp::float64>> solids__centers;
    wp::array_t<wp::vec_t<4, wp::float64>> solids__extents;
    wp::array_t<wp::vec_t<2, wp::float32>> distances;
};


template <bool wp_linear_contiguous>
static void sample_distances_kernel_1b709d4f_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args_sample_distances_kernel_1b709d4f *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;
    wp_args_sample_distances_kernel_1b709d4f wp_contiguous_args;
    if constexpr (wp_linear_contiguous)
    {
        wp_contiguous_args = *_wp_args;
        wp_contiguous_args.solids__kinds.strides[0] = sizeof(wp::int32);
        wp_contiguous_args.solids__rotations.strides[0] = sizeof(wp::mat_t<3, 3, wp::float64>);
        wp_contiguous_args.solids__centers.strides[0] = sizeof(wp::vec_t<3, wp::float64>);
        wp_contiguous_args.solids__extents.strides[0] = sizeof(wp::vec_t<4, wp::float64>);
        wp_contiguous_args.distances.strides[0] = sizeof(wp::vec_t<2, wp::float32>);
        _wp_args = &wp_contiguous_args;
    }
    //---------
    // argument vars
    wp::vec_t<3, wp::int32> var_light__size = _wp_args->light__size;
    wp::vec_t<3, wp::float64> var_low = _wp_args->low;
    wp::float64 var_step = _wp_args->step;
    wp::array_t<wp::int32> var_solids__kinds = _wp_args->solids__kinds;
    wp::array_t<wp::mat_t<3, 3, wp::float64>> var_solids__rotations = _wp_args->solids__rotations;
    wp::array_t<wp::vec_t<3, wp::float64>> var_solids__centers = _wp_args->solids__centers;
    wp::array_t<wp::vec_t<4, wp::float64>> var_solids__extents = _wp_args->solids__extents;
    wp::array_t<wp::vec_t<2, wp::float32>> var_distances = _wp_args->distances;
    //---------
    // primal vars
    wp::int32 var_0;
    wp::vec_t<3, wp::int32> var_1;
    const wp::int32 var_2 = 0;
    wp::int32 var_3;
    wp::float64 var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    wp::float64 var_7;
    const wp::int32 var_8 = 2;
    wp::int32 var_9;
    wp::float64 var_10;
    wp::vec_t<3, wp::float64> var_11;
    wp::vec_t<3, wp::float64> var_12;
    wp::vec_t<3, wp::float64> var_13;
    wp::float64 var_14;
    wp::float32 var_15;
    const wp::float32 var_16 = 1.0;
    wp::vec_t<2, wp::float32> var_17;
    //---------
    // forward
    // def sample_distances_kernel(light__size, low, step, solids__kinds, solids__rotations, solids__centers, solids__extents, distances):       <L 1>
    // i = tid()                                                                              <L 3>
    var_0 = builtin_tid1d();
    // node = node_index(i, light__size)                                                      <L 4>
    var_1 = node_index_0(var_0, var_light__size);
    // p = low + vec3d(float64(node[0]), float64(node[1]), float64(node[2])) * step           <L 5>
    var_3 = wp::extract(var_1, var_2);
    var_4 = wp::float64(var_3);
    var_6 = wp::extract(var_1, var_5);
    var_7 = wp::float64(var_6);
    var_9 = wp::extract(var_1, var_8);
    var_10 = wp::float64(var_9);
    var_11 = wp::vec_t<3, wp::float64>(var_4, var_7, var_10);
    var_12 = wp::mul(var_11, var_step);
    var_13 = wp::add(var_low, var_12);
    // distances[i] = vec2(float32(scene_distance(p, solids__kinds, solids__rotations, solids__centers, solids__extents)), 1.0)       <L 6>
    var_14 = scene_distance_0(var_13, var_solids__kinds, var_solids__rotations, var_solids__centers, var_solids__extents);
    var_15 = wp::float32(var_14);
    var_17 = wp::vec_t<2, wp::float32>(var_15, var_16);
    wp::array_store(var_distances, var_0, var_17);
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void sample_distances_kernel_1b709d4f_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args_sample_distances_kernel_1b709d4f *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        sample_distances_kernel_1b709d4f_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void sample_distances_kernel_1b709d4f_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args_sample_distances_kernel_1b709d4f *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    const bool wp_linear_contiguous = dim->coord_mult == 1 && ((_wp_args->solids__kinds.strides[0] == (int)sizeof(wp::int32)) & (_wp_args->solids__rotations.strides[0] == (int)sizeof(wp::mat_t<3, 3, wp::float64>)) & (_wp_args->solids__centers.strides[0] == (int)sizeof(wp::vec_t<3, wp::float64>)) & (_wp_args->solids__extents.strides[0] == (int)sizeof(wp::vec_t<4, wp::float64>)) & (_wp_args->distances.strides[0] == (int)sizeof(wp::vec_t<2, wp::float32>)));
    if (wp_linear_contiguous)
        sample_distances_kernel_1b709d4f_cpu_forward_tasks<true>(dim, _wp_args);
    else
        sample_distances_kernel_1b709d4f_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void sample_distances_kernel_1b709d4f_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args_sample_distances_kernel_1b709d4f *_wp_args)
{
    sample_distances_kernel_1b709d4f_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

struct wp_args_render_pixels_kernel_7ac1cdc9 {
    wp::int32 camera__width;
    wp::float64 camera__fx;
    wp::float64 camera__fy;
    wp::float64 camera__cx;
    wp::float64 camera__cy;
    wp::mat_t<3, 3, wp::float64> T_world_camera__R;
    wp::vec_t<3, wp::float64> T_world_camera__t;
    wp::int32 tiles__columns;
    wp::array_t<wp::int32> tiles__counts;
    wp::array_t<wp::int32> tiles__lists;
    wp::array_t<wp::int32> room__solids__kinds;
    wp::array_t<wp::mat_t<3, 3, wp::float64>> room__solids__rotations;
    wp::array_t<wp::vec_t<3, wp::float64>> room__solids__centers;
    wp::array_t<wp::vec_t<4, wp::float64>> room__solids__extents;
    wp::array_t<wp::vec_t<3, wp::float32>> room__paints;
    wp::array_t<wp::vec_t<2, wp::float32>> room__patterns;
    wp::vec_t<3, wp::float32> room__light__lamp;
    wp::vec_t<3, wp::float32> room__light__low;
    wp::float32 room__light__step;
    wp::vec_t<3, wp::int32> room__light__size;
    wp::array_t<wp::vec_t<2, wp::float32>> room__light__nodes;
    wp::array_t<wp::float32> depth;
    wp::array_t<wp::float32> incidence;
    wp::array_t<wp::uint8> colors;
};


template <bool wp_linear_contiguous>
static void render_pixels_kernel_7ac1cdc9_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args_render_pixels_kernel_7ac1cdc9 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;
    wp_args_render_pixels_kernel_7ac1cdc9 wp_contiguous_args;
    if constexpr (wp_linear_contiguous)
    {
        wp_contiguous_args = *_wp_args;
        wp_contiguous_args.tiles__counts.strides[0] = sizeof(wp::int32);
        wp_contiguous_args.tiles__lists.strides[0] = sizeof(wp::int32);
        wp_contiguous_args.room__solids__kinds.strides[0] = sizeof(wp::int32);
        wp_contiguous_args.room__solids__rotations.strides[0] = sizeof(wp::mat_t<3, 3, wp::float64>);
        wp_contiguous_args.room__solids__centers.strides[0] = sizeof(wp::vec_t<3, wp::float64>);
        wp_contiguous_args.room__solids__extents.strides[0] = sizeof(wp::vec_t<4, wp::float64>);
        wp_contiguous_args.room__paints.strides[0] = sizeof(wp::vec_t<3, wp::float32>);
        wp_contiguous_args.room__patterns.strides[0] = sizeof(wp::vec_t<2, wp::float32>);
        wp_contiguous_args.room__light__nodes.strides[0] = sizeof(wp::vec_t<2, wp::float32>);
        wp_contiguous_args.depth.strides[0] = sizeof(wp::float32);
        wp_contiguous_args.incidence.strides[0] = sizeof(wp::float32);
        wp_contiguous_args.colors.strides[0] = sizeof(wp::uint8);
        _wp_args = &wp_contiguous_args;
    }
    //---------
    // argument vars
    wp::int32 var_camera__width = _wp_args->camera__width;
    wp::float64 var_camera__fx = _wp_args->camera__fx;
    wp::float64 var_camera__fy = _wp_args->camera__fy;
    wp::float64 var_camera__cx = _wp_args->camera__cx;
    wp::float64 var_camera__cy = _wp_args->camera__cy;
    wp::mat_t<3, 3, wp::float64> var_T_world_camera__R = _wp_args->T_world_camera__R;
    wp::vec_t<3, wp::float64> var_T_world_camera__t = _wp_args->T_world_camera__t;
    wp::int32 var_tiles__columns = _wp_args->tiles__columns;
    wp::array_t<wp::int32> var_tiles__counts = _wp_args->tiles__counts;
    wp::array_t<wp::int32> var_tiles__lists = _wp_args->tiles__lists;
    wp::array_t<wp::int32> var_room__solids__kinds = _wp_args->room__solids__kinds;
    wp::array_t<wp::mat_t<3, 3, wp::float64>> var_room__solids__rotations = _wp_args->room__solids__rotations;
    wp::array_t<wp::vec_t<3, wp::float64>> var_room__solids__centers = _wp_args->room__solids__centers;
    wp::array_t<wp::vec_t<4, wp::float64>> var_room__solids__extents = _wp_args->room__solids__extents;
    wp::array_t<wp::vec_t<3, wp::float32>> var_room__paints = _wp_args->room__paints;
    wp::array_t<wp::vec_t<2, wp::float32>> var_room__patterns = _wp_args->room__patterns;
    wp::vec_t<3, wp::float32> var_room__light__lamp = _wp_args->room__light__lamp;
    wp::vec_t<3, wp::float32> var_room__light__low = _wp_args->room__light__low;
    wp::float32 var_room__light__step = _wp_args->room__light__step;
    wp::vec_t<3, wp::int32> var_room__light__size = _wp_args->room__light__size;
    wp::array_t<wp::vec_t<2, wp::float32>> var_room__light__nodes = _wp_args->room__light__nodes;
    wp::array_t<wp::float32> var_depth = _wp_args->depth;
    wp::array_t<wp::float32> var_incidence = _wp_args->incidence;
    wp::array_t<wp::uint8> var_colors = _wp_args->colors;
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    wp::int32 var_2;
    const wp::int32 var_3 = 16;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::int32 var_7;
    wp::float64 var_8;
    wp::float64 var_9;
    wp::vec_t<3, wp::float64> var_10;
    wp::vec_t<3, wp::float64> var_11;
    wp::vec_t<3, wp::float64> var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    wp::float64 var_15;
    const wp::int32 var_16 = -1;
    wp::int32 var_17;
    wp::int32* var_18;
    wp::range_t var_19;
    wp::int32 var_20;
    wp::int32 var_21;
    wp::shape_t* var_22;
    const wp::int32 var_23 = 0;
    wp::int32 var_24;
    wp::shape_t var_25;
    wp::int32 var_26;
    wp::int32 var_27;
    wp::int32* var_28;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::vec_t<3, wp::float64> var_31;
    wp::mat_t<3, 3, wp::float64>* var_32;
    wp::vec_t<3, wp::float64> var_33;
    wp::mat_t<3, 3, wp::float64> var_34;
    wp::vec_t<4, wp::float64>* var_35;
    wp::int32* var_36;
    wp::float64 var_37;
    wp::vec_t<4, wp::float64> var_38;
    wp::int32 var_39;
    bool var_40;
    wp::float64 var_41;
    wp::int32 var_42;
    wp::float64 var_43;
    wp::int32 var_44;
    const wp::float32 var_45 = 0.0;
    wp::float32 var_46;
    const wp::float32 var_47 = 0.0;
    wp::float32 var_48;
    const wp::float32 var_49 = 0.0;
    wp::float32 var_50;
    const wp::float32 var_51 = 0.0;
    wp::float32 var_52;
    const wp::float32 var_53 = 0.0;
    wp::float32 var_54;
    const wp::int32 var_55 = 0;
    bool var_56;
    wp::vec_t<3, wp::float64> var_57;
    wp::vec_t<3, wp::float64> var_58;
    wp::vec_t<3, wp::float64> var_59;
    wp::float32 var_60;
    wp::float64 var_61;
    wp::float64 var_62;
    wp::float64 var_63;
    wp::float64 var_64;
    wp::float32 var_65;
    wp::vec_t<3, wp::float32> var_66;
    const wp::int32 var_67 = 0;
    wp::float32 var_68;
    const wp::int32 var_69 = 1;
    wp::float32 var_70;
    const wp::int32 var_71 = 2;
    wp::float32 var_72;
    wp::float32 var_73;
    wp::float32 var_74;
    wp::float32 var_75;
    wp::float32 var_76;
    wp::float32 var_77;
    wp::uint8 var_78;
    const wp::int32 var_79 = 3;
    wp::int32 var_80;
    wp::uint8 var_81;
    const wp::int32 var_82 = 3;
    wp::int32 var_83;
    const wp::int32 var_84 = 1;
    wp::int32 var_85;
    wp::uint8 var_86;
    const wp::int32 var_87 = 3;
    wp::int32 var_88;
    const wp::int32 var_89 = 2;
    wp::int32 var_90;
    //---------
    // forward
    // def render_pixels_kernel(camera__width, camera__fx, camera__fy, camera__cx, camera__cy, T_world_camera__R, T_world_camera__t, tiles__columns, tiles__counts, tiles__lists, room__solids__kinds, room__solids__rotations, room__solids__centers, room__solids__extents, room__paints, room__patterns, room__light__lamp, room__light__low, room__light__step, room__light__size, room__light__nodes, depth, incidence, colors):       <L 1>
    // i = tid()                                                                              <L 3>
    var_0 = builtin_tid1d();
    // column = i % camera__width                                                             <L 4>
    var_1 = wp::mod(var_0, var_camera__width);
    // row = i // camera__width                                                               <L 5>
    var_2 = wp::floordiv(var_0, var_camera__width);
    // tile = row // TILE * tiles__columns + column // TILE                                   <L 6>
    var_4 = wp::floordiv(var_2, var_3);
    var_5 = wp::mul(var_4, var_tiles__columns);
    var_6 = wp::floordiv(var_1, var_3);
    var_7 = wp::add(var_5, var_6);
    // view = pixel_ray(float64(column), float64(row), camera__fx, camera__fy, camera__cx, camera__cy)       <L 7>
    var_8 = wp::float64(var_1);
    var_9 = wp::float64(var_2);
    var_10 = pixel_ray_0(var_8, var_9, var_camera__fx, var_camera__fy, var_camera__cx, var_camera__cy);
    // ray = T_world_camera__R @ view                                                         <L 8>
    var_11 = wp::mul(var_T_world_camera__R, var_10);
    // eye = T_world_camera__t                                                                <L 9>
    var_12 = wp::copy(var_T_world_camera__t);
    // t = float64(INFINITY) + float64(0.0)                                                   <L 10>
    var_13 = INFINITY;
    var_14 = 0.0;
    var_15 = wp::add(var_13, var_14);
    // solid = int(-1)                                                                        <L 11>
    var_17 = wp::int(var_16);
    // for j in range(tiles__counts[tile]):                                                   <L 12>
    var_18 = wp::address(var_tiles__counts, var_7);
    var_20 = wp::load(var_18);
    var_19 = wp::range(var_20);
    start_for_0:;
        if (iter_cmp(var_19) == 0) goto end_for_0;
        var_21 = wp::iter_next(var_19);
        // s = tiles__lists[tile * room__solids__kinds.shape[0] + j]                          <L 13>
        var_22 = &(var_room__solids__kinds.shape);
        var_25 = wp::load(var_22);
        var_24 = wp::extract(var_25, var_23);
        var_26 = wp::mul(var_7, var_24);
        var_27 = wp::add(var_26, var_21);
        var_28 = wp::address(var_tiles__lists, var_27);
        var_30 = wp::load(var_28);
        var_29 = wp::copy(var_30);
        // origin = point_in_solid(eye, s, room__solids__rotations, room__solids__centers)       <L 14>
        var_31 = point_in_solid_0(var_12, var_29, var_room__solids__rotations, var_room__solids__centers);
        // way = room__solids__rotations[s] @ ray                                             <L 15>
        var_32 = wp::address(var_room__solids__rotations, var_29);
        var_34 = wp::load(var_32);
        var_33 = wp::mul(var_34, var_11);
        // met = meet_solid(origin, way, room__solids__extents[s], room__solids__kinds[s], t)       <L 16>
        var_35 = wp::address(var_room__solids__extents, var_29);
        var_36 = wp::address(var_room__solids__kinds, var_29);
        var_38 = wp::load(var_35);
        var_39 = wp::load(var_36);
        var_37 = meet_solid_0(var_31, var_33, var_38, var_39, var_15);
        // if met < t:                                                                        <L 17>
        var_40 = (var_37 < var_15);
        if (var_40) {
            // t = met                                                                        <L 18>
            var_41 = wp::copy(var_37);
            // solid = s                                                                      <L 19>
            var_42 = wp::copy(var_29);
        }
        var_43 = wp::where(var_40, var_41, var_15);
        var_44 = wp::where(var_40, var_42, var_17);
        wp::assign(var_15, var_43);
        wp::assign(var_17, var_44);
        goto start_for_0;
    end_for_0:;
    // red = float(0.0)                                                                       <L 20>
    var_46 = wp::float(var_45);
    // green = float(0.0)                                                                     <L 21>
    var_48 = wp::float(var_47);
    // blue = float(0.0)                                                                      <L 22>
    var_50 = wp::float(var_49);
    // z = float(0.0)                                                                         <L 23>
    var_52 = wp::float(var_51);
    // cosine = float(0.0)                                                                    <L 24>
    var_54 = wp::float(var_53);
    // if solid >= 0:                                                                         <L 25>
    var_56 = (var_17 >= var_55);
    if (var_56) {
        // p = eye + ray * t                                                                  <L 26>
        var_57 = wp::mul(var_11, var_15);
        var_58 = wp::add(var_12, var_57);
        // normal = scene_normal(p, solid, room__solids__kinds, room__solids__rotations, room__solids__centers, room__solids__extents)       <L 27>
        var_59 = scene_normal_0(var_58, var_17, var_room__solids__kinds, var_room__solids__rotations, var_room__solids__centers, var_room__solids__extents);
        // z = float32(t)                                                                     <L 28>
        var_60 = wp::float32(var_15);
        // cosine = float32(-dot(normal, ray) / length(ray))                                  <L 29>
        var_61 = wp::dot(var_59, var_11);
        var_62 = wp::neg(var_61);
        var_63 = wp::length(var_11);
        var_64 = wp::div(var_62, var_63);
        var_65 = wp::float32(var_64);
        // color = color_at(p, normal, solid, room__solids__rotations, room__solids__centers, room__paints, room__patterns, room__light__lamp, room__light__low, room__light__step, room__light__size, room__light__nodes)       <L 30>
        var_66 = color_at_0(var_58, var_59, var_17, var_room__solids__rotations, var_room__solids__centers, var_room__paints, var_room__patterns, var_room__light__lamp, var_room__light__low, var_room__light__step, var_room__light__size, var_room__light__nodes);
        // red = color[0]                                                                     <L 31>
        var_68 = wp::extract(var_66, var_67);
        // green = color[1]                                                                   <L 32>
        var_70 = wp::extract(var_66, var_69);
        // blue = color[2]                                                                    <L 33>
        var_72 = wp::extract(var_66, var_71);
    }
    var_73 = wp::where(var_56, var_68, var_46);
    var_74 = wp::where(var_56, var_70, var_48);
    var_75 = wp::where(var_56, var_72, var_50);
    var_76 = wp::where(var_56, var_60, var_52);
    var_77 = wp::where(var_56, var_65, var_54);
    // depth[i] = z                                                                           <L 34>
    wp::array_store(var_depth, var_0, var_76);
    // incidence[i] = cosine                                                                  <L 35>
    wp::array_store(var_incidence, var_0, var_77);
    // colors[3 * i] = color_byte(red)                                                        <L 36>
    var_78 = color_byte_0(var_73);
    var_80 = wp::mul(var_79, var_0);
    wp::array_store(var_colors, var_80, var_78);
    // colors[3 * i + 1] = color_byte(green)                                                  <L 37>
    var_81 = color_byte_0(var_74);
    var_83 = wp::mul(var_82, var_0);
    var_85 = wp::add(var_83, var_84);
    wp::array_store(var_colors, var_85, var_81);
    // colors[3 * i + 2] = color_byte(blue)                                                   <L 38>
    var_86 = color_byte_0(var_75);
    var_88 = wp::mul(var_87, var_0);
    var_90 = wp::add(var_88, var_89);
    wp::array_store(var_colors, var_90, var_86);
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void render_pixels_kernel_7ac1cdc9_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args_render_pixels_kernel_7ac1cdc9 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        render_pixels_kernel_7ac1cdc9_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void render_pixels_kernel_7ac1cdc9_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args_render_pixels_kernel_7ac1cdc9 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    const bool wp_linear_contiguous = dim->coord_mult == 1 && ((_wp_args->tiles__counts.strides[0] == (int)sizeof(wp::int32)) & (_wp_args->tiles__lists.strides[0] == (int)sizeof(wp::int32)) & (_wp_args->room__solids__kinds.strides[0] == (int)sizeof(wp::int32)) & (_wp_args->room__solids__rotations.strides[0] == (int)sizeof(wp::mat_t<3, 3, wp::float64>)) & (_wp_args->room__solids__centers.strides[0] == (int)sizeof(wp::vec_t<3, wp::float64>)) & (_wp_args->room__solids__extents.strides[0] == (int)sizeof(wp::vec_t<4, wp::float64>)) & (_wp_args->room__paints.strides[0] == (int)sizeof(wp::vec_t<3, wp::float32>)) & (_wp_args->room__patterns.strides[0] == (int)sizeof(wp::vec_t<2, wp::float32>)) & (_wp_args->room__light__nodes.strides[0] == (int)sizeof(wp::vec_t<2, wp::float32>)) & (_wp_args->depth.strides[0] == (int)sizeof(wp::float32)) & (_wp_args->incidence.strides[0] == (int)sizeof(wp::float32)) & (_wp_args->colors.strides[0] == (int)sizeof(wp::uint8)));
    if (wp_linear_contiguous)
        render_pixels_kernel_7ac1cdc9_cpu_forward_tasks<true>(dim, _wp_args);
    else
        render_pixels_kernel_7ac1cdc9_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void render_pixels_kernel_7ac1cdc9_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args_render_pixels_kernel_7ac1cdc9 *_wp_args)
{
    render_pixels_kernel_7ac1cdc9_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

struct wp_args_sample_shadows_kernel_98373c54 {
    wp::vec_t<3, wp::float32> light__lamp;
    wp::vec_t<3, wp::float32> light__low;
    wp::float32 light__step;
    wp::vec_t<3, wp::int32> light__size;
    wp::array_t<wp::vec_t<2, wp::float32>> light__nodes;
    wp::array_t<wp::vec_t<2, wp::float32>> distances;
};


template <bool wp_linear_contiguous>
static void sample_shadows_kernel_98373c54_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args_sample_shadows_kernel_98373c54 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;
    wp_args_sample_shadows_kernel_98373c54 wp_contiguous_args;
    if constexpr (wp_linear_contiguous)
    {
        wp_contiguous_args = *_wp_args;
        wp_contiguous_args.light__nodes.strides[0] = sizeof(wp::vec_t<2, wp::float32>);
        wp_contiguous_args.distances.strides[0] = sizeof(wp::vec_t<2, wp::float32>);
        _wp_args = &wp_contiguous_args;
    }
    //---------
    // argument vars
    wp::vec_t<3, wp::float32> var_light__lamp = _wp_args->light__lamp;
    wp::vec_t<3, wp::float32> var_light__low = _wp_args->light__low;
    wp::float32 var_light__step = _wp_args->light__step;
    wp::vec_t<3, wp::int32> var_light__size = _wp_args->light__size;
    wp::array_t<wp::vec_t<2, wp::float32>> var_light__nodes = _wp_args->light__nodes;
    wp::array_t<wp::vec_t<2, wp::float32>> var_distances = _wp_args->distances;
    //---------
    // primal vars
    wp::int32 var_0;
    wp::vec_t<3, wp::int32> var_1;
    const wp::int32 var_2 = 0;
    wp::int32 var_3;
    wp::float32 var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    wp::float32 var_7;
    const wp::int32 var_8 = 2;
    wp::int32 var_9;
    wp::float32 var_10;
    wp::vec_t<3, wp::float32> var_11;
    wp::vec_t<3, wp::float32> var_12;
    wp::vec_t<3, wp::float32> var_13;
    wp::vec_t<3, wp::float32> var_14;
    wp::float32 var_15;
    const wp::float32 var_16 = 1.0;
    wp::float32 var_17;
    const wp::float32 var_18 = 0.04;
    wp::float32 var_19;
    bool var_20;
    const wp::float32 var_21 = 0.25;
    wp::float32 var_22;
    bool var_23;
    const wp::float32 var_24 = 0.0;
    bool var_25;
    wp::float32 var_26;
    wp::vec_t<3, wp::float32> var_27;
    wp::vec_t<3, wp::float32> var_28;
    wp::vec_t<2, wp::float32> var_29;
    const wp::int32 var_30 = 0;
    wp::float32 var_31;
    const wp::float32 var_32 = 0.5;
    const wp::float32 var_33 = 0.5;
    const wp::float32 var_34 = 6.0;
    wp::float32 var_35;
    wp::float32 var_36;
    wp::float32 var_37;
    wp::float32 var_38;
    wp::float32 var_39;
    const wp::float32 var_40 = 0.5;
    wp::float32 var_41;
    wp::float32 var_42;
    const wp::float32 var_43 = 0.12;
    wp::float32 var_44;
    wp::float32 var_45;
    const wp::float32 var_46 = 0.0;
    wp::float32 var_47;
    const wp::float32 var_48 = 1.0;
    wp::float32 var_49;
    wp::vec_t<2, wp::float32>* var_50;
    const wp::int32 var_51 = 0;
    wp::float32 var_52;
    wp::vec_t<2, wp::float32> var_53;
    wp::float32 var_54;
    const wp::float32 var_55 = 3.0;
    const wp::float32 var_56 = 2.0;
    wp::float32 var_57;
    wp::float32 var_58;
    wp::float32 var_59;
    wp::vec_t<2, wp::float32> var_60;
    //---------
    // forward
    // def sample_shadows_kernel(light__lamp, light__low, light__step, light__size, light__nodes, distances):       <L 1>
    // i = tid()                                                                              <L 3>
    var_0 = builtin_tid1d();
    // node = node_index(i, light__size)                                                      <L 4>
    var_1 = node_index_0(var_0, var_light__size);
    // p = light__low + vec3(float(node[0]), float(node[1]), float(node[2])) * light__step       <L 5>
    var_3 = wp::extract(var_1, var_2);
    var_4 = wp::float(var_3);
    var_6 = wp::extract(var_1, var_5);
    var_7 = wp::float(var_6);
    var_9 = wp::extract(var_1, var_8);
    var_10 = wp::float(var_9);
    var_11 = wp::vec_t<3, wp::float32>(var_4, var_7, var_10);
    var_12 = wp::mul(var_11, var_light__step);
    var_13 = wp::add(var_light__low, var_12);
    // way = light__lamp - p                                                                  <L 6>
    var_14 = wp::sub(var_light__lamp, var_13);
    // distance = length(way)                                                                 <L 7>
    var_15 = wp::length(var_14);
    // clear = float(1.0)                                                                     <L 8>
    var_17 = wp::float(var_16);
    // t = float(SHADOW_STEP)                                                                 <L 9>
    var_19 = wp::float(var_18);
    // while t < distance - LAMP_RADIUS and clear > 0.0:                                      <L 10>
    start_while_0:;
    var_22 = wp::sub(var_15, var_21);
    var_23 = (var_19 < var_22);
    var_20 = var_23;
    if (var_20) {
        var_25 = (var_17 > var_24);
        var_20 = var_20 && var_25;
    }
    if ((var_20) == false) goto end_while_0;
        // d = read_grid(p + way * (t / distance), distances, light__low, light__step, light__size)[0]       <L 11>
        var_26 = wp::div(var_19, var_15);
        var_27 = wp::mul(var_14, var_26);
        var_28 = wp::add(var_13, var_27);
        var_29 = read_grid_0(var_28, var_distances, var_light__low, var_light__step, var_light__size);
        var_31 = wp::extract(var_29, var_30);
        // clear = min(clear, 0.5 + 0.5 * PENUMBRA * d / t)                                   <L 12>
        var_35 = wp::mul(var_33, var_34);
        var_36 = wp::mul(var_35, var_31);
        var_37 = wp::div(var_36, var_19);
        var_38 = wp::add(var_32, var_37);
        var_39 = wp::min(var_17, var_38);
        // t = t + min(max(0.5 * d, SHADOW_STEP), SHADOW_STRIDE)                              <L 13>
        var_41 = wp::mul(var_40, var_31);
        var_42 = wp::max(var_41, var_18);
        var_44 = wp::min(var_42, var_43);
        var_45 = wp::add(var_19, var_44);
        wp::assign(var_17, var_39);
        wp::assign(var_19, var_45);
    goto start_while_0;
    end_while_0:;
    // share = min(max(clear, 0.0), 1.0)                                                      <L 14>
    var_47 = wp::max(var_17, var_46);
    var_49 = wp::min(var_47, var_48);
    // light__nodes[i] = vec2(distances[i][0], share * share * (3.0 - 2.0 * share))           <L 15>
    var_50 = wp::address(var_distances, var_0);
    var_53 = wp::load(var_50);
    var_52 = wp::extract(var_53, var_51);
    var_54 = wp::mul(var_49, var_49);
    var_57 = wp::mul(var_56, var_49);
    var_58 = wp::sub(var_55, var_57);
    var_59 = wp::mul(var_54, var_58);
    var_60 = wp::vec_t<2, wp::float32>(var_52, var_59);
    wp::array_store(var_light__nodes, var_0, var_60);
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void sample_shadows_kernel_98373c54_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args_sample_shadows_kernel_98373c54 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        sample_shadows_kernel_98373c54_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void sample_shadows_kernel_98373c54_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args_sample_shadows_kernel_98373c54 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    const bool wp_linear_contiguous = dim->coord_mult == 1 && ((_wp_args->light__nodes.strides[0] == (int)sizeof(wp::vec_t<2, wp::float32>)) & (_wp_args->distances.strides[0] == (int)sizeof(wp::vec_t<2, wp::float32>)));
    if (wp_linear_contiguous)
        sample_shadows_kernel_98373c54_cpu_forward_tasks<true>(dim, _wp_args);
    else
        sample_shadows_kernel_98373c54_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void sample_shadows_kernel_98373c54_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args_sample_shadows_kernel_98373c54 *_wp_args)
{
    sample_shadows_kernel_98373c54_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

struct wp_args_list_solids_kernel_a109d4a8 {
    wp::float64 camera__fx;
    wp::float64 camera__fy;
    wp::float64 camera__cx;
    wp::float64 camera__cy;
    wp::mat_t<3, 3, wp::float64> T_world_camera__R;
    wp::vec_t<3, wp::float64> T_world_camera__t;
    wp::array_t<wp::vec_t<3, wp::float64>> solids__centers;
    wp::array_t<wp::vec_t<4, wp::float64>> solids__extents;
    wp::int32 tiles__columns;
    wp::array_t<wp::int32> tiles__counts;
    wp::array_t<wp::int32> tiles__lists;
};


template <bool wp_linear_contiguous>
static void list_solids_kernel_a109d4a8_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args_list_solids_kernel_a109d4a8 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;
    wp_args_list_solids_kernel_a109d4a8 wp_contiguous_args;
    if constexpr (wp_linear_contiguous)
    {
        wp_contiguous_args = *_wp_args;
        wp_contiguous_args.solids__centers.strides[0] = sizeof(wp::vec_t<3, wp::float64>);
        wp_contiguous_args.solids__extents.strides[0] = sizeof(wp::vec_t<4, wp::float64>);
        wp_contiguous_args.tiles__counts.strides[0] = sizeof(wp::int32);
        wp_contiguous_args.tiles__lists.strides[0] = sizeof(wp::int32);
        _wp_args = &wp_contiguous_args;
    }
    //---------
    // argument vars
    wp::float64 var_camera__fx = _wp_args->camera__fx;
    wp::float64 var_camera__fy = _wp_args->camera__fy;
    wp::float64 var_camera__cx = _wp_args->camera__cx;
    wp::float64 var_camera__cy = _wp_args->camera__cy;
    wp::mat_t<3, 3, wp::float64> var_T_world_camera__R = _wp_args->T_world_camera__R;
    wp::vec_t<3, wp::float64> var_T_world_camera__t = _wp_args->T_world_camera__t;
    wp::array_t<wp::vec_t<3, wp::float64>> var_solids__centers = _wp_args->solids__centers;
    wp::array_t<wp::vec_t<4, wp::float64>> var_solids__extents = _wp_args->solids__extents;
    wp::int32 var_tiles__columns = _wp_args->tiles__columns;
    wp::array_t<wp::int32> var_tiles__counts = _wp_args->tiles__counts;
    wp::array_t<wp::int32> var_tiles__lists = _wp_args->tiles__lists;
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    const wp::int32 var_2 = 16;
    wp::int32 var_3;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    wp::float64 var_15;
    wp::float64 var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::vec_t<3, wp::float64> var_19;
    wp::vec_t<3, wp::float64> var_20;
    wp::float64 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    const wp::int32 var_24 = 2;
    wp::int32 var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    wp::float64 var_28;
    const wp::int32 var_29 = 2;
    wp::int32 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    wp::float64 var_33;
    wp::vec_t<3, wp::float64> var_34;
    wp::vec_t<3, wp::float64> var_35;
    wp::float64 var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    wp::vec_t<3, wp::float64> var_39;
    const wp::int32 var_40 = 0;
    wp::int32 var_41;
    wp::shape_t* var_42;
    const wp::int32 var_43 = 0;
    wp::int32 var_44;
    wp::shape_t var_45;
    wp::range_t var_46;
    wp::int32 var_47;
    wp::vec_t<3, wp::float64>* var_48;
    wp::vec_t<3, wp::float64> var_49;
    wp::vec_t<3, wp::float64> var_50;
    wp::vec_t<4, wp::float64>* var_51;
    wp::vec_t<4, wp::float64> var_52;
    wp::vec_t<4, wp::float64> var_53;
    const wp::int32 var_54 = 0;
    wp::float64 var_55;
    const wp::int32 var_56 = 0;
    wp::float64 var_57;
    wp::float64 var_58;
    const wp::int32 var_59 = 1;
    wp::float64 var_60;
    const wp::int32 var_61 = 1;
    wp::float64 var_62;
    wp::float64 var_63;
    wp::float64 var_64;
    const wp::int32 var_65 = 2;
    wp::float64 var_66;
    const wp::int32 var_67 = 2;
    wp::float64 var_68;
    wp::float64 var_69;
    wp::float64 var_70;
    wp::float64 var_71;
    const wp::int32 var_72 = 3;
    wp::float64 var_73;
    wp::float64 var_74;
    wp::float64 var_75;
    const wp::int32 var_76 = 1;
    wp::int32 var_77;
    bool var_78;
    wp::float64 var_79;
    wp::float64 var_80;
    wp::float64 var_81;
    wp::float64 var_82;
    wp::float64 var_83;
    wp::float64 var_84;
    wp::float64 var_85;
    wp::float64 var_86;
    wp::float64 var_87;
    wp::float64 var_88;
    wp::float64 var_89;
    wp::float64 var_90;
    bool var_91;
    const wp::int32 var_92 = 0;
    wp::int32 var_93;
    wp::int32 var_94;
    const wp::int32 var_95 = 1;
    bool var_96;
    wp::shape_t* var_97;
    const wp::int32 var_98 = 0;
    wp::int32 var_99;
    wp::shape_t var_100;
    wp::int32 var_101;
    wp::int32 var_102;
    const wp::int32 var_103 = 1;
    wp::int32 var_104;
    wp::int32 var_105;
    //---------
    // forward
    // def list_solids_kernel(camera__fx, camera__fy, camera__cx, camera__cy, T_world_camera__R, T_world_camera__t, solids__centers, solids__extents, tiles__columns, tiles__counts, tiles__lists):       <L 1>
    // i = tid()                                                                              <L 2>
    var_0 = builtin_tid1d();
    // x0 = float64(i % tiles__columns * TILE) - float64(0.5)                                 <L 3>
    var_1 = wp::mod(var_0, var_tiles__columns);
    var_3 = wp::mul(var_1, var_2);
    var_4 = wp::float64(var_3);
    var_5 = 0.5;
    var_6 = wp::sub(var_4, var_5);
    // y0 = float64(i // tiles__columns * TILE) - float64(0.5)                                <L 4>
    var_7 = wp::floordiv(var_0, var_tiles__columns);
    var_8 = wp::mul(var_7, var_2);
    var_9 = wp::float64(var_8);
    var_10 = 0.5;
    var_11 = wp::sub(var_9, var_10);
    // size = float64(TILE_SIZE)                                                              <L 5>
    var_12 = 16.0;
    // middle = normalize(pixel_ray(x0 + size * float64(0.5), y0 + size * float64(0.5), camera__fx, camera__fy, camera__cx, camera__cy))       <L 6>
    var_13 = 0.5;
    var_14 = wp::mul(var_12, var_13);
    var_15 = wp::add(var_6, var_14);
    var_16 = 0.5;
    var_17 = wp::mul(var_12, var_16);
    var_18 = wp::add(var_11, var_17);
    var_19 = pixel_ray_0(var_15, var_18, var_camera__fx, var_camera__fy, var_camera__cx, var_camera__cy);
    var_20 = wp::normalize(var_19);
    // cosine = float64(1.0)                                                                  <L 7>
    var_21 = 1.0;
    // for corner in range(4):                                                                <L 8>
    var_22 = 0;
    start_for_0:;
        if (var_22 >= 4) goto end_for_0;
        var_23 = var_22;
        var_22 += 1;
        // x = x0 + size * float64(corner % 2)                                                <L 9>
        var_25 = wp::mod(var_23, var_24);
        var_26 = wp::float64(var_25);
        var_27 = wp::mul(var_12, var_26);
        var_28 = wp::add(var_6, var_27);
        // y = y0 + size * float64(corner // 2)                                               <L 10>
        var_30 = wp::floordiv(var_23, var_29);
        var_31 = wp::float64(var_30);
        var_32 = wp::mul(var_12, var_31);
        var_33 = wp::add(var_11, var_32);
        // cosine = min(cosine, dot(middle, normalize(pixel_ray(x, y, camera__fx, camera__fy, camera__cx, camera__cy))))       <L 11>
        var_34 = pixel_ray_0(var_28, var_33, var_camera__fx, var_camera__fy, var_camera__cx, var_camera__cy);
        var_35 = wp::normalize(var_34);
        var_36 = wp::dot(var_20, var_35);
        var_37 = wp::min(var_21, var_36);
        wp::assign(var_21, var_37);
        goto start_for_0;
    end_for_0:;
    // half_angle = acos(cosine)                                                              <L 12>
    var_38 = wp::acos(var_21);
    // axis = T_world_camera__R @ middle                                                      <L 13>
    var_39 = wp::mul(var_T_world_camera__R, var_20);
    // count = int(0)                                                                         <L 14>
    var_41 = wp::int(var_40);
    // for s in range(solids__centers.shape[0]):                                              <L 15>
    var_42 = &(var_solids__centers.shape);
    var_45 = wp::load(var_42);
    var_44 = wp::extract(var_45, var_43);
    var_46 = wp::range(var_44);
    start_for_2:;
        if (iter_cmp(var_46) == 0) goto end_for_2;
        var_47 = wp::iter_next(var_46);
        // way = solids__centers[s] - T_world_camera__t                                       <L 16>
        var_48 = wp::address(var_solids__centers, var_47);
        var_50 = wp::load(var_48);
        var_49 = wp::sub(var_50, var_T_world_camera__t);
        // e = solids__extents[s]                                                             <L 17>
        var_51 = wp::address(var_solids__extents, var_47);
        var_53 = wp::load(var_51);
        var_52 = wp::copy(var_53);
        // radius = sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]) + e[3]                      <L 18>
        var_55 = wp::extract(var_52, var_54);
        var_57 = wp::extract(var_52, var_56);
        var_58 = wp::mul(var_55, var_57);
        var_60 = wp::extract(var_52, var_59);
        var_62 = wp::extract(var_52, var_61);
        var_63 = wp::mul(var_60, var_62);
        var_64 = wp::add(var_58, var_63);
        var_66 = wp::extract(var_52, var_65);
        var_68 = wp::extract(var_52, var_67);
        var_69 = wp::mul(var_66, var_68);
        var_70 = wp::add(var_64, var_69);
        var_71 = wp::sqrt(var_70);
        var_73 = wp::extract(var_52, var_72);
        var_74 = wp::add(var_71, var_73);
        // distance = length(way)                                                             <L 19>
        var_75 = wp::length(var_49);
        // touched = int(1)                                                                   <L 20>
        var_77 = wp::int(var_76);
        // if distance > radius:                                                              <L 21>
        var_78 = (var_75 > var_74);
        if (var_78) {
            // angle = acos(min(max(dot(axis, way) / distance, float64(-1.0)), float64(1.0)))       <L 22>
            var_79 = wp::dot(var_39, var_49);
            var_80 = wp::div(var_79, var_75);
            var_81 = -1.0;
            var_82 = wp::max(var_80, var_81);
            var_83 = 1.0;
            var_84 = wp::min(var_82, var_83);
            var_85 = wp::acos(var_84);
            // if angle > half_angle + asin(radius / distance) + float64(1e-06):              <L 23>
            var_86 = wp::div(var_74, var_75);
            var_87 = wp::asin(var_86);
            var_88 = wp::add(var_38, var_87);
            var_89 = 1e-06;
            var_90 = wp::add(var_88, var_89);
            var_91 = (var_85 > var_90);
            if (var_91) {
                // touched = 0                                                                <L 24>
            }
            var_93 = wp::where(var_91, var_92, var_77);
        }
        var_94 = wp::where(var_78, var_93, var_77);
        // if touched == 1:                                                                   <L 25>
        var_96 = (var_94 == var_95);
        if (var_96) {
            // tiles__lists[i * solids__centers.shape[0] + count] = s                         <L 26>
            var_97 = &(var_solids__centers.shape);
            var_100 = wp::load(var_97);
            var_99 = wp::extract(var_100, var_98);
            var_101 = wp::mul(var_0, var_99);
            var_102 = wp::add(var_101, var_41);
            wp::array_store(var_tiles__lists, var_102, var_47);
            // count += 1                                                                     <L 27>
            var_104 = wp::add(var_41, var_103);
        }
        var_105 = wp::where(var_96, var_104, var_41);
        wp::assign(var_41, var_105);
        goto start_for_2;
    end_for_2:;
    // tiles__counts[i] = count                                                               <L 28>
    wp::array_store(var_tiles__counts, var_0, var_41);
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void list_solids_kernel_a109d4a8_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args_list_solids_kernel_a109d4a8 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        list_solids_kernel_a109d4a8_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void list_solids_kernel_a109d4a8_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args_list_solids_kernel_a109d4a8 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    const bool wp_linear_contiguous = dim->coord_mult == 1 && ((_wp_args->solids__centers.strides[0] == (int)sizeof(wp::vec_t<3, wp::float64>)) & (_wp_args->solids__extents.strides[0] == (int)sizeof(wp::vec_t<4, wp::float64>)) & (_wp_args->tiles__counts.strides[0] == (int)sizeof(wp::int32)) & (_wp_args->tiles__lists.strides[0] == (int)sizeof(wp::int32)));
    if (wp_linear_contiguous)
        list_solids_kernel_a109d4a8_cpu_forward_tasks<true>(dim, _wp_args);
    else
        list_solids_kernel_a109d4a8_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void list_solids_kernel_a109d4a8_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args_list_solids_kernel_a109d4a8 *_wp_args)
{
    list_solids_kernel_a109d4a8_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C


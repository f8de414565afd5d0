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


// /work/main/src/pointloom/kernels/language/pool_code.py:118
static CUDA_CALLABLE void _serve_0(
    wp::uint64 pool,
    wp::uint64 worker)
{
#define forward_ p[16]
#define arguments_ p[17]
#define chunks_ p[18]
#define chunk_ p[19]
#define total_ p[20]
#define first_ p[21]
#define over_ p[24]
#define wait_ p[25]
#define post_ p[26]
#define give_way_ p[27]
#define workers_ p[28]
#define spins_ p[29]

    typedef unsigned long long word;
    typedef signed (*waiter)(void*, word, void*);  // int is Warp's name for a cast here
    typedef void (*yielder)();
    word* p = (word*)pool;
    auto pause = []() {
#if defined(__x86_64__)
        __builtin_ia32_pause();
#elif defined(__aarch64__)
        __builtin_arm_yield();
#endif
    };
    auto is_open = [p]() {
        return !(__atomic_load_n(&p[0], __ATOMIC_SEQ_CST) >> 32)
            && __atomic_load_n(&p[8], __ATOMIC_RELAXED) < __atomic_load_n(&chunks_, __ATOMIC_RELAXED);
    };
    auto wake = [p](word w) {
        word wanted = chunks_ - 1 < workers_ ? chunks_ - 1 : workers_;
        word* its = p + 32 + 8 * w;
        if (w < wanted && __atomic_exchange_n(&its[0], (word)0, __ATOMIC_SEQ_CST))
            ((waiter)post_)((void*)its[1], 1, nullptr);
    };
    auto work = [p]() {
        void (*forward)(void*, void*) = (void (*)(void*, void*))forward_;
        void* arguments = (void*)arguments_;
        const word chunks = chunks_, chunk = chunk_, total = total_, first = first_;
        wp::launch_bounds_t<1> bounds = {{0}, 0, 1};
        for (;;) {
            const word c = __atomic_fetch_add(&p[8], (word)1, __ATOMIC_RELAXED);
            if (c >= chunks) break;
            const word begin = c * chunk;
            bounds.shape[0] = (unsigned)(0x80000000u | (first + begin));
            bounds.size = total - begin < chunk ? total - begin : chunk;
            forward(&bounds, arguments);
        }
    };
    
    word* own = p + 32 + 8 * worker;
    for (;;) {
        for (word tries = 0;;) {  // until it is inside a launch
            if (__atomic_load_n(&over_, __ATOMIC_ACQUIRE)) return;
            if (is_open()) {
                word state = __atomic_load_n(&p[0], __ATOMIC_RELAXED);
                if (!(state >> 32) && __atomic_compare_exchange_n(
                    &p[0], &state, state + 1, false, __ATOMIC_ACQ_REL, __ATOMIC_RELAXED)) break;
                continue;
            }
            if (tries++ < spins_) { pause(); continue; }
            __atomic_store_n(&own[0], (word)1, __ATOMIC_SEQ_CST);
            // A launch that opened before this saw no sleeper; who clears the mark is who ends the sleep.
            if ((is_open() || __atomic_load_n(&over_, __ATOMIC_SEQ_CST))
                && __atomic_exchange_n(&own[0], (word)0, __ATOMIC_SEQ_CST)) continue;
            while (((waiter)wait_)((void*)own[1], ~0ull, nullptr)) {}  // a signal interrupts it
            tries = 0;
        }
        wake(2 * worker + 2);
        wake(2 * worker + 3);
        work();
        __atomic_fetch_sub(&p[0], (word)1, __ATOMIC_ACQ_REL);
    }
}


// /work/main/src/pointloom/kernels/language/pool_code.py:112
static CUDA_CALLABLE void _share_0(
    wp::uint64 pool,
    wp::uint64 forward,
    wp::uint64 arguments,
    wp::uint64 total,
    wp::uint64 chunk,
    wp::uint64 first)
{
#define forward_ p[16]
#define arguments_ p[17]
#define chunks_ p[18]
#define chunk_ p[19]
#define total_ p[20]
#define first_ p[21]
#define over_ p[24]
#define wait_ p[25]
#define post_ p[26]
#define give_way_ p[27]
#define workers_ p[28]
#define spins_ p[29]

    typedef unsigned long long word;
    typedef signed (*waiter)(void*, word, void*);  // int is Warp's name for a cast here
    typedef void (*yielder)();
    word* p = (word*)pool;
    auto pause = []() {
#if defined(__x86_64__)
        __builtin_ia32_pause();
#elif defined(__aarch64__)
        __builtin_arm_yield();
#endif
    };
    auto is_open = [p]() {
        return !(__atomic_load_n(&p[0], __ATOMIC_SEQ_CST) >> 32)
            && __atomic_load_n(&p[8], __ATOMIC_RELAXED) < __atomic_load_n(&chunks_, __ATOMIC_RELAXED);
    };
    auto wake = [p](word w) {
        word wanted = chunks_ - 1 < workers_ ? chunks_ - 1 : workers_;
        word* its = p + 32 + 8 * w;
        if (w < wanted && __atomic_exchange_n(&its[0], (word)0, __ATOMIC_SEQ_CST))
            ((waiter)post_)((void*)its[1], 1, nullptr);
    };
    auto work = [p]() {
        void (*forward)(void*, void*) = (void (*)(void*, void*))forward_;
        void* arguments = (void*)arguments_;
        const word chunks = chunks_, chunk = chunk_, total = total_, first = first_;
        wp::launch_bounds_t<1> bounds = {{0}, 0, 1};
        for (;;) {
            const word c = __atomic_fetch_add(&p[8], (word)1, __ATOMIC_RELAXED);
            if (c >= chunks) break;
            const word begin = c * chunk;
            bounds.shape[0] = (unsigned)(0x80000000u | (first + begin));
            bounds.size = total - begin < chunk ? total - begin : chunk;
            forward(&bounds, arguments);
        }
    };
    
    forward_ = forward; arguments_ = arguments; total_ = total; chunk_ = chunk; first_ = first;
    __atomic_store_n(&chunks_, (total + chunk - 1) / chunk, __ATOMIC_RELAXED);
    __atomic_store_n(&p[8], (word)0, __ATOMIC_RELAXED);
    __atomic_store_n(&p[0], (word)0, __ATOMIC_SEQ_CST);  // open, nobody inside
    wake(0);
    wake(1);
    work();
    __atomic_fetch_or(&p[0], 1ull << 32, __ATOMIC_SEQ_CST);
    for (word tries = 0; __atomic_load_n(&p[0], __ATOMIC_ACQUIRE) & 0xffffffffull; ++tries)
        if (tries < spins_) pause(); else ((yielder)give_way_)();  // a worker without a core may want this one
}


// /work/main/src/pointloom/kernels/language/pool_code.py:118
static CUDA_CALLABLE void adj__serve_0(
    wp::uint64 pool,
    wp::uint64 worker,
    wp::uint64 & adj_pool,
    wp::uint64 & adj_worker)
{
}


// /work/main/src/pointloom/kernels/language/pool_code.py:112
static CUDA_CALLABLE void adj__share_0(
    wp::uint64 pool,
    wp::uint64 forward,
    wp::uint64 arguments,
    wp::uint64 total,
    wp::uint64 chunk,
    wp::uint64 first,
    wp::uint64 & adj_pool,
    wp::uint64 & adj_forward,
    wp::uint64 & adj_arguments,
    wp::uint64 & adj_total,
    wp::uint64 & adj_chunk,
    wp::uint64 & adj_first)
{
}

struct wp_args__serve_kernel_039cf530 {
    wp::uint64 pool;
    wp::uint64 worker;
};


template <bool wp_linear_contiguous>
static void _serve_kernel_039cf530_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args__serve_kernel_039cf530 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;

    //---------
    // argument vars
    wp::uint64 var_pool = _wp_args->pool;
    wp::uint64 var_worker = _wp_args->worker;
    //---------
    // primal vars
    //---------
    // forward
    // def _serve_kernel(pool: wp.uint64, worker: wp.uint64) -> None:                         <L 128>
    // _serve(pool, worker)                                                                   <L 129>
    _serve_0(var_pool, var_worker);
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void _serve_kernel_039cf530_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args__serve_kernel_039cf530 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        _serve_kernel_039cf530_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void _serve_kernel_039cf530_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args__serve_kernel_039cf530 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    _serve_kernel_039cf530_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void _serve_kernel_039cf530_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args__serve_kernel_039cf530 *_wp_args)
{
    _serve_kernel_039cf530_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

struct wp_args__share_kernel_4f5f54b3 {
    wp::uint64 pool;
    wp::uint64 forward;
    wp::uint64 arguments;
    wp::uint64 total;
    wp::uint64 chunk;
    wp::uint64 first;
};


template <bool wp_linear_contiguous>
static void _share_kernel_4f5f54b3_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args__share_kernel_4f5f54b3 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;

    //---------
    // argument vars
    wp::uint64 var_pool = _wp_args->pool;
    wp::uint64 var_forward = _wp_args->forward;
    wp::uint64 var_arguments = _wp_args->arguments;
    wp::uint64 var_total = _wp_args->total;
    wp::uint64 var_chunk = _wp_args->chunk;
    wp::uint64 var_first = _wp_args->first;
    //---------
    // primal vars
    //---------
    // forward
    // def _share_kernel(                                                                     <L 122>
    // _share(pool, forward, arguments, total, chunk, first)                                  <L 125>
    _share_0(var_pool, var_forward, var_arguments, var_total, var_chunk, var_first);
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void _share_kernel_4f5f54b3_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args__share_kernel_4f5f54b3 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        _share_kernel_4f5f54b3_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void _share_kernel_4f5f54b3_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args__share_kernel_4f5f54b3 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    _share_kernel_4f5f54b3_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void _share_kernel_4f5f54b3_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args__share_kernel_4f5f54b3 *_wp_args)
{
    _share_kernel_4f5f54b3_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

struct wp_args__try_kernel_d21526e6 {
    wp::array_t<wp::vec_t<3, wp::float32>> given;
    wp::int32 count;
    wp::array_t<wp::float32> out;
};


template <bool wp_linear_contiguous>
static void _try_kernel_d21526e6_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args__try_kernel_d21526e6 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;

    //---------
    // argument vars
    wp::array_t<wp::vec_t<3, wp::float32>> var_given = _wp_args->given;
    wp::int32 var_count = _wp_args->count;
    wp::array_t<wp::float32> var_out = _wp_args->out;
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::float32 var_1 = 0.0;
    wp::float32 var_2;
    wp::range_t var_3;
    wp::int32 var_4;
    wp::vec_t<3, wp::float32>* var_5;
    bool var_6;
    wp::vec_t<3, wp::float32> var_7;
    wp::vec_t<3, wp::float32>* var_8;
    wp::float32 var_9;
    wp::vec_t<3, wp::float32> var_10;
    wp::float32 var_11;
    wp::float32 var_12;
    const wp::int32 var_13 = 0;
    const wp::int32 var_14 = 1;
    const wp::float32 var_15 = 1.0;
    wp::float32 var_16;
    //---------
    // forward
    // def _try_kernel(given: wp.array(dtype=wp.vec3), count: int, out: wp.array2d(dtype=wp.float32)):  # type: ignore[valid-type]       <L 132>
    // i = wp.tid()                                                                           <L 133>
    var_0 = builtin_tid1d();
    // total = wp.float32(0.0)                                                                <L 134>
    var_2 = wp::float32(var_1);
    // for k in range(count):                                                                 <L 135>
    var_3 = wp::range(var_count);
    start_for_0:;
        if (iter_cmp(var_3) == 0) goto end_for_0;
        var_4 = wp::iter_next(var_3);
        // if wp.isfinite(given[i]):                                                          <L 136>
        var_5 = wp::address(var_given, var_0);
        var_7 = wp::load(var_5);
        var_6 = wp::isfinite(var_7);
        if (var_6) {
            // total += given[i][k]                                                           <L 137>
            var_8 = wp::address(var_given, var_0);
            var_10 = wp::load(var_8);
            var_9 = wp::extract(var_10, var_4);
            var_11 = wp::add(var_2, var_9);
        }
        var_12 = wp::where(var_6, var_11, var_2);
        wp::assign(var_2, var_12);
        goto start_for_0;
    end_for_0:;
    // out[i, 0] = total                                                                      <L 138>
    wp::array_store(var_out, var_0, var_13, var_2);
    // wp.atomic_add(out, i, 1, 1.0)                                                          <L 139>
    var_16 = wp::atomic_add(var_out, var_0, var_14, var_15);
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void _try_kernel_d21526e6_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args__try_kernel_d21526e6 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        _try_kernel_d21526e6_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void _try_kernel_d21526e6_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args__try_kernel_d21526e6 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    _try_kernel_d21526e6_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void _try_kernel_d21526e6_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args__try_kernel_d21526e6 *_wp_args)
{
    _try_kernel_d21526e6_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C


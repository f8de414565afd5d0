// The thread pool of CPU launches: its memory, which cpu_pool.py makes (`PoolMemory` of pool_code.py has the same layout),
// and the code of its threads. Included after Warp's headers and cpu_access.h.

namespace pointloom {

typedef unsigned long long word;
typedef signed (*waiter)(void*, word, void*);  // `int` may be a macro of Warp's
typedef void (*yielder)();
typedef void (*kernel)(void*, void*);

const word CLOSED = 1ull << 32;        // in Pool::state: no launch is open
const unsigned PART = 0x80000000u;     // in an extent: the other bits are the first thread, see linear_tid of cpu_access.h

struct alignas(64) Worker {         // a cache line of its own
    word sleeps, semaphore;
};

struct Pool {
    alignas(64) word state;         // workers inside a launch, or CLOSED
    alignas(64) word next;          // chunk
    alignas(64) word forward;       // machine code of the launch
    word arguments, chunks, chunk, total, first;
    alignas(64) word over;          // 1: the workers end
    word wait, post, give_way, workers, spins;

    Worker& worker(word k) { return ((Worker*)(this + 1))[k]; }

    bool is_open()
    {
        return !(__atomic_load_n(&state, __ATOMIC_SEQ_CST) >> 32)
            && __atomic_load_n(&next, __ATOMIC_RELAXED) < __atomic_load_n(&chunks, __ATOMIC_RELAXED);
    }
    // Wake a worker if the launch has a chunk for it.
    void wake(word k)
    {
        const word wanted = chunks - 1 < workers ? chunks - 1 : workers;
        if (k < wanted && __atomic_exchange_n(&worker(k).sleeps, (word)0, __ATOMIC_SEQ_CST))
            ((waiter)post)((void*)worker(k).semaphore, 1, nullptr);
    }
    // Run chunks until none is left.
    void work()
    {
        const word count = chunks, size = chunk, end = total, begin = first;
        const kernel run = (kernel)forward;
        void* const given = (void*)arguments;
        wp::launch_bounds_t<1> bounds = {{0}, 0, 1};
        for (;;) {
            const word c = __atomic_fetch_add(&next, (word)1, __ATOMIC_RELAXED);
            if (c >= count) break;
            bounds.shape[0] = (unsigned)(PART | (begin + c * size));
            bounds.size = end - c * size < size ? end - c * size : size;
            run(&bounds, given);
        }
    }
};
static_assert(sizeof(Worker) == 64 && sizeof(Pool) == 256, "the layout of PoolMemory");

inline void pause()
{
#if defined(__x86_64__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    __builtin_arm_yield();
#endif
}

// Launch on the calling thread and the workers, and wait for all.
inline void share(Pool& p, word forward, word arguments, word total, word chunk, word first)
{
    p.forward = forward, p.arguments = arguments, p.total = total, p.chunk = chunk, p.first = first;
    __atomic_store_n(&p.chunks, (total + chunk - 1) / chunk, __ATOMIC_RELAXED);
    __atomic_store_n(&p.next, (word)0, __ATOMIC_RELAXED);
    __atomic_store_n(&p.state, (word)0, __ATOMIC_SEQ_CST);  // open, without workers
    p.wake(0);
    p.wake(1);
    p.work();
    __atomic_fetch_or(&p.state, CLOSED, __ATOMIC_SEQ_CST);
    for (word tries = 0; __atomic_load_n(&p.state, __ATOMIC_ACQUIRE) & (CLOSED - 1); ++tries)
        if (tries < p.spins) pause(); else ((yielder)p.give_way)();  // a worker without a core may want this one
}

// The loop of a worker, until the pool is over.
inline void serve(Pool& p, word number)
{
    Worker& own = p.worker(number);
    for (;;) {
        for (word tries = 0;;) {  // until it is inside a launch
            if (__atomic_load_n(&p.over, __ATOMIC_ACQUIRE)) return;
            if (p.is_open()) {
                word state = __atomic_load_n(&p.state, __ATOMIC_RELAXED);
                if (!(state >> 32) && __atomic_compare_exchange_n(
                    &p.state, &state, state + 1, false, __ATOMIC_ACQ_REL, __ATOMIC_RELAXED)) break;
                continue;
            }
            if (tries++ < p.spins) { pause(); continue; }
            __atomic_store_n(&own.sleeps, (word)1, __ATOMIC_SEQ_CST);
            // A launch that opened before this found no sleeping worker. The one that resets the flag ends the sleep.
            if ((p.is_open() || __atomic_load_n(&p.over, __ATOMIC_SEQ_CST))
                && __atomic_exchange_n(&own.sleeps, (word)0, __ATOMIC_SEQ_CST)) continue;
            while (((waiter)p.wait)((void*)own.semaphore, ~0ull, nullptr)) {}  // a signal interrupts it
            tries = 0;
        }
        p.wake(2 * number + 2);
        p.wake(2 * number + 3);
        p.work();
        __atomic_fetch_sub(&p.state, (word)1, __ATOMIC_ACQ_REL);
    }
}

}

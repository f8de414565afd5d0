/* Runs the threads of a launch in the order that was asked for.

   Threads that never wait run one after the other on the host's stack. Threads that wait for each other, and those that
   are to be interrupted between memory accesses, are fibers: each has a stack, and one that waits hands over to the
   next directly. */
#define _GNU_SOURCE
#include "scheduler.h"
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>

enum Order { FORWARD, BACKWARD, SHUFFLED, INTERLEAVED };
enum { FIBERS = 1024, NOBODY = -1, PAGE = 4096 };
enum { UNDER_WAY = 96 };   /* threads at once, of kernels that never wait, when they are interleaved */
enum { APART_ALONE = 24, APART_IN_BLOCK = 16 }; /* memory accesses between switches, at most */
/* A stack, and how far the next one is: an odd number of cache lines more, else all stacks share the same few sets. */
enum { STACK = 256 << 10, STRIDE = STACK + 17 * 64 };

typedef void (*Entry)(const u8 *parameters, Thread *);

/* The i-th of a number of things in some order: forward, backward or i * factor + shift, which meets each once. */
typedef struct Permutation {
    u64 count, factor, shift;
    u32 order;
} Permutation;

typedef struct Fiber {
    void *stack_pointer;
    Thread thread;
} Fiber;

static struct {
    Entry entry;
    const u8 *parameters;
    u32 grid[3], block[3];
    u32 order, waits;
    Permutation blocks, threads;
    u64 next, total; /* threads that have started, and all, where they are interleaved alone */
} launch;

/* Memory accesses of the last launch, and those of its longest thread; approximate if threads are interleaved. */
struct { u64 accesses, longest; } emulator_work;
extern u64 emulator_accesses[]; /* of memory.c; not in a header, since all modules are compiled again if one changes */

static Fiber *fibers;
static u8 *stacks;
static void *host_stack_pointer;
static int current = NOBODY;
static u32 ready[32], ready_warps; /* fibers that could run, by warps of 32, and which warps have some */
static u32 unfinished;

u64 scheduler_random(void)
{
    u64 x = EMULATOR.random;
    x ^= x << 13;
    x ^= x >> 7;
    x ^= x << 17;
    return EMULATOR.random = x;
}

/* ------------------------------------------------------------------------------------------------ permutations */

static u64 greatest_divisor(u64 a, u64 b)
{
    while (b) {
        u64 rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

static Permutation permutation_of(u64 count, u32 order)
{
    Permutation p = { count, 1, 0, order };
    if (order >= SHUFFLED && count > 1) {
        do
            p.factor = 1 + scheduler_random() % (count - 1);
        while (greatest_divisor(p.factor, count) != 1);
        p.shift = scheduler_random() % count;
    }
    return p;
}

static u64 at(const Permutation *p, u64 i)
{
    if (p->order == FORWARD)
        return i;
    if (p->order == BACKWARD)
        return p->count - 1 - i;
    return (u64)(((u128)i * p->factor + p->shift) % p->count);
}

static void place_block(Thread *t, u64 block)
{
    t->ctaid[0] = (u32)(block % launch.grid[0]);
    t->ctaid[1] = (u32)(block / launch.grid[0] % launch.grid[1]);
    t->ctaid[2] = (u32)(block / launch.grid[0] / launch.grid[1]);
    memcpy(t->ntid, launch.block, sizeof t->ntid);
    memcpy(t->nctaid, launch.grid, sizeof t->nctaid);
}

static void place_thread(Thread *t, u64 block, u32 thread)
{
    t->tid[0] = thread % launch.block[0];
    t->tid[1] = thread / launch.block[0] % launch.block[1];
    t->tid[2] = thread / launch.block[0] / launch.block[1];
    t->linear = thread;
    t->lane = thread & 31;
    t->global = (u32)(block * EMULATOR.block_threads + thread);
}

/* ------------------------------------------------------------------------------------------------ the scheduler */

void switch_stacks(void **save, void *load);
__asm__(".text\n.globl switch_stacks\n.hidden switch_stacks\n.type switch_stacks,@function\nswitch_stacks:\n"
        "push %rbp\npush %rbx\npush %r12\npush %r13\npush %r14\npush %r15\n"
        "mov %rsp,(%rdi)\nmov %rsi,%rsp\n"
        "pop %r15\npop %r14\npop %r13\npop %r12\npop %rbx\npop %rbp\nret\n");

static u32 first_from(u32 set, u32 from)
{
    u32 turned = set >> from | set << (-from & 31);
    return ((u32)__builtin_ctz(turned) + from) & 31;
}

static u32 last_up_to(u32 set, u32 to)
{
    u32 turned = set << (31 - to) | set >> ((to + 1) & 31);
    return (to - (u32)__builtin_clz(turned)) & 31;
}

/* A warp that can go on does, until it waits for others; interleaved threads change at any time. */
static int next_fiber(void)
{
    if (!ready_warps)
        return NOBODY;
    u32 warp = current == NOBODY ? 0 : (u32)current >> 5, lane = (u32)current & 31;
    int stays = current != NOBODY && ready[warp] && launch.order != INTERLEAVED;
    if (launch.order == FORWARD) {
        if (!stays) {
            warp = first_from(ready_warps, current == NOBODY ? 0 : (warp + 1) & 31);
            lane = 31;
        }
        return (int)(warp * 32 + first_from(ready[warp], (lane + 1) & 31));
    }
    if (launch.order == BACKWARD) {
        if (!stays) {
            warp = last_up_to(ready_warps, current == NOBODY ? 31 : (warp - 1) & 31);
            lane = 0;
        }
        return (int)(warp * 32 + last_up_to(ready[warp], (lane - 1) & 31));
    }
    u64 dice = scheduler_random() >> 20;
    if (!stays)
        warp = first_from(ready_warps, dice & 31);
    return (int)(warp * 32 + first_from(ready[warp], dice >> 5 & 31));
}

static void forget(int fiber)
{
    u32 warp = (u32)fiber >> 5;
    ready[warp] &= ~(1u << (fiber & 31));
    if (!ready[warp])
        ready_warps &= ~(1u << warp);
}

void scheduler_wake(u32 warp, u32 lanes)
{
    ready[warp] |= lanes;
    ready_warps |= 1u << warp;
}

static void report_deadlock(Thread *t)
{
    u32 in_warps = 0;
    for (int k = 0; k < 32; k++)
        in_warps += (u32)__builtin_popcount(t->block->warps[k].waiting);
    snprintf(EMULATOR.fault_text, sizeof EMULATOR.fault_text, "%u wait at a barrier, %u in meetings of their warps, %u have ended",
        t->block->arrived, in_warps, EMULATOR.block_threads - t->block->live);
    emulator_fault(t, FAULT_DEADLOCK, 0, 0, 0, 0);
}

static void hand_over(void)
{
    int from = current, to = next_fiber();
    if (to == from)
        return;
    if (to == NOBODY)
        report_deadlock(&fibers[from].thread);
    current = to;
    switch_stacks(&fibers[from].stack_pointer, fibers[to].stack_pointer);
}

void scheduler_wait(Thread *t)
{
    (void)t;
    forget(current);
    hand_over();
}

void emulator_switch_threads(void)
{
    EMULATOR.countdown = 1 + (s32)(scheduler_random() % (u64)EMULATOR.interval);
    if (current != NOBODY)
        hand_over();
}

static void end_fiber(void)
{
    forget(current);
    if (--unfinished)
        hand_over();
    int last = current;
    current = NOBODY;
    switch_stacks(&fibers[last].stack_pointer, host_stack_pointer);
}

static void run_fiber(void)
{
    Thread *t = &fibers[current].thread;
    if (launch.waits) {
        launch.entry(launch.parameters, t);
        meeting_without(t);
    } else {
        while (launch.next < launch.total) {
            u64 k = launch.next++;
            u64 block = at(&launch.blocks, k / EMULATOR.block_threads);
            place_block(t, block);
            place_thread(t, block, (u32)at(&launch.threads, k % EMULATOR.block_threads));
            launch.entry(launch.parameters, t);
        }
    }
    end_fiber();
}

static void make_fibers(void)
{
    size_t size = (size_t)FIBERS * STRIDE + PAGE;
    fibers = calloc(FIBERS, sizeof(Fiber));
    stacks = mmap(0, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (!fibers || stacks == MAP_FAILED)
        abort();
    for (size_t k = 0; k < FIBERS; k++) {
        u8 *low = stacks + k * STRIDE;
        u8 *guard = low + (PAGE - (uintptr_t)low % PAGE) % PAGE;
        mprotect(guard, PAGE, PROT_NONE); /* who runs over its stack dies at once */
        fibers[k].thread.stack_low = (u64)(uintptr_t)low;
        fibers[k].thread.stack_high = (u64)(uintptr_t)(low + STACK);
    }
}

static void prepare_fiber(Fiber *f)
{
    u64 *top = (u64 *)((f->thread.stack_high & ~63ull) - 64);
    *--top = 0; /* so that run_fiber finds the stack aligned as after a call */
    *--top = (u64)(uintptr_t)run_fiber;
    for (int k = 0; k < 6; k++)
        *--top = 0; /* the registers that switch_stacks takes off */
    f->stack_pointer = top;
}

static void run_fibers(u32 count)
{
    ready_warps = 0;
    for (u32 k = 0; k < 32; k++) {
        u32 lanes = count <= 32 * k ? 0 : count - 32 * k;
        ready[k] = lanes >= 32 ? ~0u : (1u << lanes) - 1;
        if (ready[k])
            ready_warps |= 1u << k;
    }
    unfinished = count;
    current = NOBODY;
    current = next_fiber();
    switch_stacks(&host_stack_pointer, fibers[current].stack_pointer);
}

/* ------------------------------------------------------------------------------------------------ launches */

static void add_up_accesses(void)
{
    for (u32 k = 0; k < EMULATOR.block_threads; k++) {
        emulator_work.accesses += emulator_accesses[k];
        if (emulator_accesses[k] > emulator_work.longest)
            emulator_work.longest = emulator_accesses[k];
    }
    memset(emulator_accesses, 0, EMULATOR.block_threads * sizeof emulator_accesses[0]);
}

static void run_waiting_block(u64 block, u8 *shared, u32 shared_size)
{
    static Block meeting;
    u32 threads = EMULATOR.block_threads;
    memset(&meeting, 0, sizeof meeting);
    meeting.live = threads;
    for (u32 k = 0; k < threads; k++) {
        Thread *t = &fibers[k].thread;
        prepare_fiber(&fibers[k]);
        place_block(t, block);
        place_thread(t, block, k);
        t->block = &meeting;
        t->shared = shared;
        t->shared_size = shared_size;
        meeting.warps[k >> 5].live |= 1u << (k & 31);
    }
    run_fibers(threads);
    add_up_accesses();
}

static void run_interleaved(u8 *shared, u32 shared_size)
{
    launch.next = 0;
    launch.total = launch.blocks.count * EMULATOR.block_threads;
    u32 count = launch.total < UNDER_WAY ? (u32)launch.total : UNDER_WAY;
    for (u32 k = 0; k < count; k++) {
        Thread *t = &fibers[k].thread;
        prepare_fiber(&fibers[k]);
        t->block = 0;
        t->shared = shared;
        t->shared_size = shared_size;
    }
    run_fibers(count);
    add_up_accesses();
}

static void run_in_turn(u8 *shared, u32 shared_size)
{
    Thread t;
    memset(&t, 0, sizeof t);
    t.shared = shared;
    t.shared_size = shared_size;
    t.stack_high = (u64)(uintptr_t)__builtin_frame_address(0) + PAGE;
    t.stack_low = t.stack_high - (8 << 20);
    for (u64 i = 0; i < launch.blocks.count; i++) {
        u64 block = at(&launch.blocks, i);
        place_block(&t, block);
        if (shared_size)
            memset(shared, 0xCB, shared_size);
        for (u32 k = 0; k < EMULATOR.block_threads; k++) {
            place_thread(&t, block, (u32)at(&launch.threads, k));
            launch.entry(launch.parameters, &t);
        }
        add_up_accesses();
    }
}

static u8 *shared_memory(u32 size)
{
    static u8 *memory;
    static u32 room;
    if (size > room) {
        free(memory);
        if (posix_memalign((void **)&memory, 1024, size))
            abort();
        room = size;
    }
    if (size)
        memset(memory, 0xCB, size);
    return memory;
}

/* Run one launch; 0, or the fault that ended it. */
u32 emulator_launch(Entry entry, const u8 *parameters, const u32 *grid, const u32 *block, u32 shared_size, u32 waits,
    u32 order, u64 seed)
{
    launch.entry = entry;
    launch.parameters = parameters;
    launch.order = order;
    launch.waits = waits;
    memcpy(launch.grid, grid, sizeof launch.grid);
    memcpy(launch.block, block, sizeof launch.block);
    EMULATOR.block_threads = block[0] * block[1] * block[2];
    EMULATOR.random = (seed * 0x9E3779B97F4A7C15ull + 0x1234567ull) | 1;
    for (int k = 0; k < 4; k++)
        scheduler_random();
    EMULATOR.fault = FAULT_NONE;
    EMULATOR.fault_text[0] = 0;
    EMULATOR.launch++;
    emulator_work.accesses = emulator_work.longest = 0;
    memset(emulator_accesses, 0, EMULATOR.block_threads * sizeof emulator_accesses[0]); /* of a launch with a fault */
    EMULATOR.interval = 0;
    u8 *shared = shared_memory(shared_size);
    if (!fibers)
        make_fibers();
    launch.blocks = permutation_of((u64)grid[0] * grid[1] * grid[2], order);
    launch.threads = permutation_of(EMULATOR.block_threads, order);
    if (__builtin_setjmp(EMULATOR.jump)) {
        current = NOBODY;
        EMULATOR.interval = 0;
        return EMULATOR.fault;
    }
    if (order == INTERLEAVED) {
        EMULATOR.interval = waits ? APART_IN_BLOCK : APART_ALONE;
        EMULATOR.countdown = 8;
    }
    if (waits) {
        for (u64 i = 0; i < launch.blocks.count; i++) {
            if (shared_size)
                memset(shared, 0xCB, shared_size);
            run_waiting_block(at(&launch.blocks, i), shared, shared_size);
        }
    } else if (order == INTERLEAVED) {
        run_interleaved(shared, shared_size);
    } else {
        run_in_turn(shared, shared_size);
    }
    EMULATOR.interval = 0;
    return FAULT_NONE;
}

/* What is counted of a launch: its sampled blocks leave traces, which are run again as warps (counters.c). */
#pragma once
#include "caches.h"

enum Space { SPACE_LOCAL, SPACE_SHARED, SPACE_GLOBAL, SPACE_GENERIC, SPACES };

/* Sums of one space and kind of access, or of one instruction. */
typedef struct Traffic {
    u64 requests;   /* of a warp */
    u64 lanes;      /* that took part */
    u64 bytes;      /* that they asked for */
    u64 sectors;    /* distinct ones of 32 bytes, request by request; of shared memory none */
    u64 wavefronts; /* turns: distinct words in the fullest bank; in the L1 at least one for four lines of 128 bytes */
    u64 missed;     /* sectors that the L1 did not have, and all of stores and atomics: they go to the L2 */
} Traffic;

/* `counters.Tables` and `counters.Counts` in Python are twins of what follows. */
typedef struct Counters {
    /* of the module: by basic block */
    u32 block_count, site_count;
    const s32 *meets;      /* where lanes that part at its end meet again; -1: at the function's end */
    const s32 *after_call; /* where lanes go on after the call at its end; -1: there is none */
    const u32 *cycles;     /* of its longest chain of dependent instructions, but for loads */
    const u32 *issued;     /* instructions */
    /* of the module: by instruction that accesses memory */
    const u8 *space, *size, *access;
    const u8 *level; /* of how many loads before it in its basic block its address depends; 255: none waits for it */
    /* of the launch */
    u64 first, every; /* block i is sampled where i % every == first */
    u32 l1_lines;     /* of 128 bytes, that a block of threads has for itself */
    u32 alone;        /* 1: no other blocks run than those that are sampled */
    u32 hit_cycles, miss_cycles;
    u64 *issues, *lanes; /* by basic block: warps and lanes that ran it */
    Traffic *sites;      /* by instruction */
    Traffic traffic[3][3]; /* by space and kind of access */
    u64 blocks, warps;     /* that were sampled */
    u64 chain;             /* cycles: dependent instructions of all warps */
    u64 hits, misses;      /* loads that a warp waits for, one after the other, that the L1 had and had not */
    u64 longest;           /* cycles, sums over the blocks of threads of the slowest warp, waits for memory included */
    u64 slowest;           /* cycles of the slowest warp of all */
    u64 cut;               /* lanes whose trace was too long */
    u64 hot_atomics;       /* atomics of the sampled blocks at the one address that most of them go to */
} Counters;

#define BLOCK_EVENT (1ull << 63)

void emulator_more_trace(Thread *) COLD;
/* A sampled block of threads: it begins, its threads leave traces, its warps run again, it ends. */
void counters_begin_block(void);
void counters_trace(Thread *, u32 thread);
void counters_ended(Thread *);
void counters_replay(Thread *, u32 first, u32 lanes);
void counters_end_block(void);
extern Counters *COUNTERS;

INLINE void block_begins(Thread *t, u64 id)
{
    if (UNLIKELY(t->trace != 0)) {
        *t->trace++ = id | BLOCK_EVENT;
        if (UNLIKELY(t->trace == t->trace_end))
            emulator_more_trace(t);
    }
}

/* The address of an access, which is noted. */
INLINE u64 traced(Thread *t, u64 site, u64 address)
{
    if (UNLIKELY(t->trace != 0)) {
        *t->trace++ = site << 48 | (address & 0xFFFFFFFFFFFFull);
        if (UNLIKELY(t->trace == t->trace_end))
            emulator_more_trace(t);
    }
    return address;
}

INLINE u64 touched(Thread *t, u64 site, u64 address, u32 write)
{
    u64 offset = address - EMULATOR.base;
    if (offset < EMULATOR.size) {
        u32 stamp = LEVEL2.stamps[offset >> 5];
        if (UNLIKELY(LEVEL2.clock - (stamp >> 1) > JUST_BEFORE || (write & ~stamp)))
            emulator_touch(offset >> 5, write);
    }
    return traced(t, site, address);
}

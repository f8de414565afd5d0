/* The caches that are counted (caches.c). */
#pragma once
#include "emulator.h"

/* The L2, of all accesses of all threads: a sector is there that was touched less than its capacity ago. */
typedef struct Level2 {
    u32 *stamps; /* by sector: when it was touched last, times two, and whether it is to be written back */
    u32 clock, capacity; /* sectors touched so far, but for those touched just before */
    u64 reads, writes;   /* sectors from and to memory, of this launch */
} Level2;

extern Level2 LEVEL2;

enum { JUST_BEFORE = 2048 }; /* sectors: within this, a touch is no news */

void emulator_touch(u64 sector, u32 write) COLD;
void start_level2(u32 capacity);
/* The L1 of a block of threads, empty, with so many lines of 128 bytes. */
void empty_l1(u32 lines);
/* Which of the sectors of a line the L1 has; a load fetches the others. */
u8 look_up(u64 line, u8 sectors, int fetch);

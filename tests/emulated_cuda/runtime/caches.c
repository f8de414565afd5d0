/* The caches of the model: an L2 of all threads by the age of its sectors, and the L1 of a block of threads. */
#include "caches.h"
#include <stdlib.h>
#include <sys/mman.h>

enum { WAYS = 4, MOST_LINES = 4096 };

Level2 LEVEL2;

/* ------------------------------------------------------------------------------------------------ the L2 */

void emulator_touch(u64 sector, u32 write)
{
    u32 *stamp = LEVEL2.stamps + sector, dirty = *stamp & 1;
    if (LEVEL2.clock - (*stamp >> 1) > LEVEL2.capacity) {
        dirty = 0;
        LEVEL2.reads += !write;
    }
    LEVEL2.writes += write & ~dirty & 1;
    *stamp = ++LEVEL2.clock << 1 | (dirty | write);
}

void emulator_touch_range(u64 address, u64 bytes, u32 write)
{
    u64 offset = address - EMULATOR.base;
    if (offset >= EMULATOR.size || !bytes)
        return;
    for (u64 sector = offset >> 5; sector <= (offset + bytes - 1) >> 5; sector++)
        emulator_touch(sector, write);
}

void start_level2(u32 capacity)
{
    if (!LEVEL2.stamps && capacity) {
        u64 size = (EMULATOR.size >> 5) * sizeof(u32);
        LEVEL2.stamps = mmap(0, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        if (LEVEL2.stamps == MAP_FAILED)
            abort();
        LEVEL2.clock = capacity + JUST_BEFORE + 1;
    }
    LEVEL2.capacity = capacity;
    LEVEL2.reads = LEVEL2.writes = 0;
}

void emulator_level2(u64 *reads, u64 *writes)
{
    *reads = LEVEL2.reads;
    *writes = LEVEL2.writes;
}

/* ------------------------------------------------------------------------------------------------ the L1 */

typedef struct Line {
    u64 tag; /* plus one; 0: empty */
    u32 used;
    u8 sectors;
} Line;

static Line lines[MOST_LINES];
static u32 line_count, line_clock;

void empty_l1(u32 count)
{
    line_count = count < WAYS ? WAYS : count > MOST_LINES ? MOST_LINES : count;
    line_count -= line_count % WAYS;
    memset(lines, 0, line_count * sizeof(Line));
    line_clock = 0;
}

u8 look_up(u64 line, u8 sectors, int fetch)
{
    u32 sets = line_count / WAYS;
    Line *set = lines + WAYS * (u32)((line * 0x9E3779B97F4A7C15ull >> 32) % sets), *oldest = set;
    for (int k = 0; k < WAYS; k++) {
        if (set[k].tag == line + 1) {
            u8 there = set[k].sectors & sectors;
            set[k].used = ++line_clock;
            if (fetch)
                set[k].sectors |= sectors;
            return there;
        }
        if (set[k].used < oldest->used)
            oldest = set + k;
    }
    if (fetch)
        *oldest = (Line) { line + 1, ++line_clock, sectors };
    return 0;
}

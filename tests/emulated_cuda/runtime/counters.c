/* Warps of sampled blocks, run again from the traces of their threads.

   A trace is the basic blocks that a thread ran and the addresses that it touched. Lanes of a warp run together as long
   as they go the same way; where they part, each part runs alone until the block where all ways meet again (the
   immediate post-dominator), as compilers place it. */
#include "caches.h"
#include "counters.h"
#include <stdlib.h>

enum { LANES = 32, MOST_THREADS = 1024, START_ROOM = 1 << 12, MOST_ROOM = 1 << 22 };
enum { TAGS = 4 }; /* lines that the L1 looks up a cycle */
enum { END = -2, MOST_LEVELS = 8, HOT = 4096 };
static const u64 LOCAL_LINE = 1ull << 62;

Counters *COUNTERS;

/* ------------------------------------------------------------------------------------------------ traces */

typedef struct Trace {
    u64 *events, *end; /* of what was written */
    u64 room, top;     /* top: of the thread's stack, from which its local memory is counted */
} Trace;

static Trace traces[MOST_THREADS];

void counters_trace(Thread *t, u32 thread)
{
    Trace *k = &traces[thread];
    if (!k->events) {
        k->room = START_ROOM;
        k->events = malloc(k->room * sizeof(u64));
        if (!k->events)
            abort();
    }
    k->end = 0;
    k->top = t->stack_high & ~63ull;
    t->traced = thread;
    t->trace = k->events;
    t->trace_end = k->events + k->room;
}

void counters_ended(Thread *t)
{
    if (t->trace)
        traces[t->traced].end = t->trace;
    t->trace = 0;
}

void emulator_more_trace(Thread *t)
{
    Trace *k = &traces[t->traced];
    u64 used = (u64)(t->trace - k->events);
    if (k->room >= MOST_ROOM) {
        k->end = t->trace;
        t->trace = 0;
        COUNTERS->cut++;
        return;
    }
    k->room *= 2;
    k->events = realloc(k->events, k->room * sizeof(u64));
    if (!k->events)
        abort();
    t->trace = k->events + used;
    t->trace_end = k->events + k->room;
}

/* Count a launch, or none; the L2 has so many sectors. */
void emulator_count(Counters *counters, u32 capacity)
{
    COUNTERS = counters;
    start_level2(capacity);
}

/* ------------------------------------------------------------------------------------------------ one request */

typedef struct Request {
    u32 count, site;
    u64 addresses[LANES];
    u8 lane[LANES];
} Request;

static struct {
    u64 address, count;
} hot[HOT];

static void add(Traffic *to, const Traffic *x)
{
    to->requests += x->requests;
    to->lanes += x->lanes;
    to->bytes += x->bytes;
    to->sectors += x->sectors;
    to->wavefronts += x->wavefronts;
    to->missed += x->missed;
}

static u32 space_of(u32 space, u64 address, const Thread *t)
{
    if (space != SPACE_GENERIC)
        return space;
    if (address - EMULATOR.base < EMULATOR.size)
        return SPACE_GLOBAL;
    return address - ((u64)(uintptr_t)t->shared & 0xFFFFFFFFFFFFull) < t->shared_size ? SPACE_SHARED : SPACE_LOCAL;
}

/* Distinct words of four bytes in the fullest of 32 banks: turns that the data take, of shared memory and of the L1. */
static u32 turns_in_banks(const Request *r, u32 size)
{
    u64 words[32][LANES];
    u32 in_bank[32] = { 0 }, most = 1;
    for (u32 k = 0; k < r->count; k++)
        for (u32 w = 0; w < (size + 3) / 4; w++) {
            u64 word = r->addresses[k] / 4 + w;
            u32 bank = word & 31, known = in_bank[bank];
            while (known && words[bank][known - 1] != word)
                known--;
            if (known)
                continue;
            words[bank][in_bank[bank]++] = word;
            if (in_bank[bank] > most)
                most = in_bank[bank];
        }
    return most;
}

/* A warp's own data: sectors that it writes and loads again. Those of all resident warps share the L2, which the model of
   it does not know, since it sees one warp after the other. */
enum { OWN = 1 << 15, PROBES = 16 };

typedef struct Own {
    u64 sector;
    u32 warp, stores;
    u8 is_loaded;
} Own;

static Own own[OWN];
static struct {
    u64 sectors, loads, stores; /* of all sampled warps; loads that the L1 does not have */
} owned;
static u32 own_warp;

static Own *own_place(u64 sector, int make)
{
    u32 h = (u32)(sector * 0x9E3779B97F4A7C15ull >> 49);
    for (u32 k = 0; k < PROBES; k++) {
        Own *place = &own[(h + k) % OWN];
        if (place->warp == own_warp && place->sector == sector)
            return place;
        if (place->warp != own_warp) {
            if (make)
                *place = (Own) { sector, own_warp, 0, 0 };
            return make ? place : 0;
        }
    }
    return 0;
}

static void note_own(u64 line, u8 sectors, u32 access)
{
    for (u32 k = 0; k < 4; k++) {
        Own *place = sectors >> k & 1 ? own_place(line << 2 | k, access == STORE) : 0;
        if (!place)
            continue;
        if (access == STORE) {
            owned.stores += place->is_loaded;
            place->stores++;
            continue;
        }
        owned.loads++;
        if (!place->is_loaded) {
            place->is_loaded = 1;
            owned.sectors++;
            owned.stores += place->stores;
        }
    }
}

void emulator_own(u64 *found)
{
    found[0] = owned.sectors;
    found[1] = owned.loads;
    found[2] = owned.stores;
    memset(&owned, 0, sizeof owned);
}

static void take_line(u64 line, u8 sectors, u32 access, Traffic *x)
{
    u32 wanted = (u32)__builtin_popcount(sectors);
    u8 there = access == ATOMIC ? 0 : look_up(line, sectors, access == LOAD);
    if (access != ATOMIC && !(line & LOCAL_LINE))
        note_own(line, access == LOAD ? sectors & (u8)~there : sectors, access);
    x->sectors += wanted;
    x->missed += access == LOAD ? wanted - (u32)__builtin_popcount(there) : wanted;
}

static void meet_lines(const Request *r, u32 size, u32 access, Traffic *x)
{
    u64 found[LANES * 2];
    u8 sectors[LANES * 2];
    u32 count = 0;
    for (u32 k = 0; k < r->count; k++) {
        u64 first = r->addresses[k] >> 5, last = (r->addresses[k] + size - 1) >> 5;
        for (u64 s = first; s <= last; s++) {
            u32 known = count;
            while (known && found[known - 1] != s >> 2)
                known--;
            if (!known) {
                found[count] = s >> 2;
                sectors[count] = 0;
                known = ++count;
            }
            sectors[known - 1] |= (u8)(1u << (s & 3));
        }
    }
    for (u32 k = 0; k < count; k++)
        take_line(found[k], sectors[k], access, x);
    u32 turns = turns_in_banks(r, size), tags = (count + TAGS - 1) / TAGS;
    x->wavefronts = turns > tags ? turns : tags;
}

/* Local memory is interleaved: word w of lane l lies at 4 * (32 * w + l). */
static void meet_local(const Request *r, u32 size, u32 access, u64 warp, const u64 *tops, Traffic *x)
{
    u64 found[LANES * 4];
    u8 sectors[LANES * 4];
    u32 count = 0;
    for (u32 k = 0; k < r->count; k++)
        for (u32 w = 0; w < (size + 3) / 4; w++) {
            u64 line = LOCAL_LINE | warp << 40 | (((tops[r->lane[k]] - r->addresses[k]) / 4 - w) & 0xFFFFFFFFFF);
            u32 known = count;
            while (known && found[known - 1] != line)
                known--;
            if (!known) {
                found[count] = line;
                sectors[count] = 0;
                known = ++count;
            }
            sectors[known - 1] |= (u8)(1u << (r->lane[k] >> 3));
        }
    for (u32 k = 0; k < count; k++)
        take_line(found[k], sectors[k], access, x);
    x->wavefronts = count; /* each word of a lane is in the bank of its lane */
}

static void note_hot(const Request *r)
{
    for (u32 k = 0; k < r->count; k++) {
        u64 a = r->addresses[k], h = (a * 0x9E3779B97F4A7C15ull) >> 52;
        if (hot[h].address == a)
            hot[h].count++;
        else if (!hot[h].count)
            hot[h].address = a, hot[h].count = 1;
        else
            hot[h].count--;
    }
}

/* ------------------------------------------------------------------------------------------------ a warp */

static struct {
    Thread *t;
    const u64 *at[LANES], *end[LANES];
    u64 tops[LANES];
    u64 number, chain, waits;
} warp;

static s32 next_of(u32 lane)
{
    return warp.at[lane] == warp.end[lane] ? END : (s32)(*warp.at[lane] & 0x7FFFFFFF);
}

/* All that a basic block accesses; for each level of loads that wait for each other, 1: in the L1, 2: not. */
static void access_memory(u32 group, u8 *waits)
{
    Counters *c = COUNTERS;
    for (;;) {
        Request r;
        r.count = 0;
        r.site = ~0u;
        for (u32 rest = group; rest; rest &= rest - 1) {
            u32 lane = (u32)__builtin_ctz(rest);
            if (warp.at[lane] == warp.end[lane] || *warp.at[lane] & BLOCK_EVENT)
                continue;
            u32 site = (u32)(*warp.at[lane] >> 48);
            if (site < r.site) {
                r.site = site;
                r.count = 0;
            }
            if (site == r.site) {
                r.addresses[r.count] = *warp.at[lane] & 0xFFFFFFFFFFFFull;
                r.lane[r.count++] = (u8)lane;
            }
        }
        if (!r.count)
            return;
        u32 size = c->size[r.site], access = c->access[r.site];
        u32 space = space_of(c->space[r.site], r.addresses[0], warp.t);
        Traffic x = { 1, r.count, (u64)r.count * size, 0, 0, 0 };
        if (space == SPACE_SHARED)
            x.wavefronts = turns_in_banks(&r, size);
        else if (space == SPACE_LOCAL)
            meet_local(&r, size, access, warp.number, warp.tops, &x);
        else
            meet_lines(&r, size, access, &x);
        if (space == SPACE_GLOBAL && access == ATOMIC)
            note_hot(&r);
        add(&c->traffic[space][access], &x);
        add(&c->sites[r.site], &x);
        u8 level = c->level[r.site];
        if (space != SPACE_SHARED && level < MOST_LEVELS && waits[level] < (x.missed ? 2 : 1))
            waits[level] = x.missed ? 2 : 1;
        for (u32 k = 0; k < r.count; k++)
            warp.at[r.lane[k]]++;
    }
}

static void issue(s32 block, u32 group)
{
    Counters *c = COUNTERS;
    u8 waits[MOST_LEVELS] = { 0 };
    for (u32 rest = group; rest; rest &= rest - 1)
        warp.at[__builtin_ctz(rest)]++;
    c->issues[block]++;
    c->lanes[block] += (u32)__builtin_popcount(group);
    access_memory(group, waits);
    warp.chain += c->cycles[block] > c->issued[block] ? c->cycles[block] : c->issued[block];
    for (int k = 0; k < MOST_LEVELS; k++) {
        c->hits += waits[k] == 1;
        c->misses += waits[k] == 2;
        warp.waits += waits[k] == 1 ? c->hit_cycles : waits[k] == 2 ? c->miss_cycles : 0;
    }
}

/* Where ways lead back: by the first block of a loop its last, plus one; 0 where none begins. */
enum { MOST_BLOCKS = 1 << 16 };
static u32 loop_ends[MOST_BLOCKS];

static void note_loops(s32 block, u32 group, s32 back)
{
    for (u32 rest = group; rest; rest &= rest - 1) {
        s32 next = next_of((u32)__builtin_ctz(rest));
        if (next >= 0 && next <= block && next != back && block < MOST_BLOCKS && loop_ends[next] < (u32)block + 1)
            loop_ends[next] = (u32)block + 1;
    }
}

void emulator_loops(u32 *found, u32 count)
{
    count = count < MOST_BLOCKS ? count : MOST_BLOCKS;
    memcpy(found, loop_ends, count * sizeof(u32));
    memset(loop_ends, 0, count * sizeof(u32));
}

/* Run lanes until all are at `stop`; a function's end is where its caller goes on. */
static void run_until(u32 lanes, s32 stop, s32 back)
{
    for (;;) {
        u32 group = 0;
        s32 block = 0;
        for (u32 rest = lanes; rest; rest &= rest - 1) {
            u32 lane = (u32)__builtin_ctz(rest);
            s32 next = next_of(lane);
            if (next == stop || next == END)
                continue;
            if (!group || next < block) {
                block = next;
                group = 0;
            }
            if (next == block)
                group |= 1u << lane;
        }
        if (!group)
            return;
        issue(block, group);
        s32 after = COUNTERS->after_call[block];
        if (after >= 0) {
            run_until(group, after, after);
            continue;
        }
        note_loops(block, group, back);
        s32 meets = COUNTERS->meets[block];
        if (meets < 0)
            meets = back;
        s32 way = next_of((u32)__builtin_ctz(group));
        u32 parted = 0;
        for (u32 rest = group; rest; rest &= rest - 1)
            parted |= next_of((u32)__builtin_ctz(rest)) != way;
        while (parted && group) {
            u32 same = 0;
            way = next_of((u32)__builtin_ctz(group));
            for (u32 rest = group; rest; rest &= rest - 1)
                same |= (u32)(next_of((u32)__builtin_ctz(rest)) == way) << __builtin_ctz(rest);
            run_until(same, meets, back);
            group &= ~same;
        }
    }
}

static u64 longest;

void counters_begin_block(void)
{
    empty_l1(COUNTERS->l1_lines);
    longest = 0;
    COUNTERS->blocks++;
}

void counters_replay(Thread *t, u32 first, u32 lanes)
{
    u32 here = 0;
    memset(&warp, 0, sizeof warp);
    own_warp++;
    warp.t = t;
    warp.number = first / LANES;
    for (u32 k = 0; k < lanes; k++) {
        Trace *trace = &traces[first + k];
        warp.at[k] = trace->events;
        warp.end[k] = trace->end;
        warp.tops[k] = trace->top & 0xFFFFFFFFFFFFull;
        if (trace->end)
            here |= 1u << k;
    }
    run_until(here, END, END);
    COUNTERS->warps++;
    COUNTERS->chain += warp.chain;
    u64 cycles = warp.chain + warp.waits;
    if (cycles > longest)
        longest = cycles;
    if (cycles > COUNTERS->slowest)
        COUNTERS->slowest = cycles;
}

void counters_end_block(void) { COUNTERS->longest += longest; }

void emulator_hot_atomics(void)
{
    u64 most = 0;
    for (u32 k = 0; k < HOT; k++)
        most = hot[k].count > most ? hot[k].count : most;
    COUNTERS->hot_atomics = most;
    memset(hot, 0, sizeof hot);
}

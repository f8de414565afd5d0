/* Where threads wait for each other: barriers of a block, shuffles and votes of a warp.

   The last lane that arrives works out the results of all 32 and goes on; the others find theirs when they run again.
   So a meeting costs one switch of stacks a lane and no turn of the scheduler. */
#include "scheduler.h"

enum Kind { SYNC, SHUFFLE, VOTE, REDUX, MATCH, ACTIVE };
enum { POISON = 0xCB };

static Warp *warp_of(Thread *t) { return &t->block->warps[t->linear >> 5]; }

static void shuffle_all(Thread *t, Warp *w, u32 group, u32 statement)
{
    for (u32 rest = group; rest; rest &= rest - 1) {
        u32 lane = (u32)__builtin_ctz(rest);
        Arrival *a = &w->arrivals[lane];
        u32 segment = (a->clamp >> 8) & 31, clamp = a->clamp & 31, distance = a->distance & 31;
        u32 low = lane & segment, last = low | (clamp & ~segment);
        u32 source, inside;
        switch (a->mode) {
        case SHUFFLE_UP:
            source = lane - distance;
            inside = (s32)source >= (s32)last;
            break;
        case SHUFFLE_DOWN:
            source = lane + distance;
            inside = source <= last;
            break;
        case SHUFFLE_XOR:
            source = lane ^ distance;
            inside = source <= last;
            break;
        default:
            source = low | (distance & ~segment);
            inside = source <= last;
        }
        if (!inside)
            source = lane;
        a->flag = (u8)inside;
        if (group >> source & 1) {
            if (a->count != w->arrivals[source].count)
                emulator_fault(t, FAULT_MEETING, 0, 0, 0, statement);
            memcpy(a->received, w->arrivals[source].sent, a->count * sizeof(u32));
        } else {
            memset(a->received, POISON, a->count * sizeof(u32)); /* undefined on CUDA */
            emulator_note(t, NOTE_MISSING_LANES, 0, statement, source);
        }
    }
}

static void vote_all(Warp *w, u32 group)
{
    u32 ballot = 0;
    for (u32 rest = group; rest; rest &= rest - 1) {
        u32 lane = (u32)__builtin_ctz(rest);
        ballot |= (u32)(w->arrivals[lane].value != 0) << lane;
    }
    for (u32 rest = group; rest; rest &= rest - 1) {
        Arrival *a = &w->arrivals[__builtin_ctz(rest)];
        switch (a->mode) {
        case VOTE_BALLOT:
            a->result = ballot;
            break;
        case VOTE_ALL:
            a->result = ballot == group;
            break;
        case VOTE_ANY:
            a->result = ballot != 0;
            break;
        default:
            a->result = ballot == group || ballot == 0;
        }
    }
}

static u32 combine(u32 mode, u32 x, u32 y)
{
    switch (mode) {
    case REDUX_ADD:
        return x + y;
    case REDUX_MIN_S:
        return (s32)x < (s32)y ? x : y;
    case REDUX_MAX_S:
        return (s32)x > (s32)y ? x : y;
    case REDUX_MIN_U:
        return x < y ? x : y;
    case REDUX_MAX_U:
        return x > y ? x : y;
    case REDUX_AND:
        return x & y;
    case REDUX_OR:
        return x | y;
    default:
        return x ^ y;
    }
}

static void redux_all(Warp *w, u32 group)
{
    u32 first = (u32)__builtin_ctz(group);
    u32 result = (u32)w->arrivals[first].value;
    for (u32 rest = group & (group - 1); rest; rest &= rest - 1) {
        Arrival *a = &w->arrivals[__builtin_ctz(rest)];
        result = combine(a->mode, result, (u32)a->value);
    }
    for (u32 rest = group; rest; rest &= rest - 1)
        w->arrivals[__builtin_ctz(rest)].result = result;
}

static void match_all(Warp *w, u32 group)
{
    for (u32 rest = group; rest; rest &= rest - 1) {
        Arrival *a = &w->arrivals[__builtin_ctz(rest)];
        u32 same = 0;
        for (u32 other = group; other; other &= other - 1) {
            u32 lane = (u32)__builtin_ctz(other);
            same |= (u32)(w->arrivals[lane].value == a->value) << lane;
        }
        a->flag = same == group;
        a->result = a->mode && same != group ? 0 : same;
    }
}

static int all_wait(const Warp *w, u32 mask) { return (w->waiting & mask & w->live) == (mask & w->live); }

/* Whether lanes that all wait are in the same meeting; then they have their results and may go on. */
static int complete(Thread *t, Warp *w, u32 mask, u32 statement)
{
    u32 group = mask & w->live;
    u32 kind = w->arrivals[__builtin_ctz(group)].kind;
    for (u32 rest = group; rest; rest &= rest - 1) {
        Arrival *a = &w->arrivals[__builtin_ctz(rest)];
        if (a->mask != mask)
            return 0;
        if (a->kind != kind)
            emulator_fault(t, FAULT_MEETING, 0, 0, 0, statement);
    }
    if (UNLIKELY(mask & ~w->live))
        emulator_note(t, NOTE_MISSING_LANES, 0, statement, mask & ~w->live);
    switch (kind) {
    case SHUFFLE:
        shuffle_all(t, w, group, statement);
        break;
    case VOTE:
        vote_all(w, group);
        break;
    case REDUX:
        redux_all(w, group);
        break;
    case MATCH:
        match_all(w, group);
        break;
    case SYNC:
        w->syncs += group == w->live;
        break;
    }
    w->waiting &= ~group;
    scheduler_wake(t->linear >> 5, group);
    return 1;
}

/* The lane's place in its warp, filled field by field: a copy of the whole would wait for the single stores. */
static Arrival *arrival_of(Thread *t, u32 kind, u32 mode, u32 mask, u64 value)
{
    Arrival *a = &warp_of(t)->arrivals[t->lane];
    a->kind = kind;
    a->mode = mode;
    a->mask = mask | 1u << t->lane;
    a->value = value;
    return a;
}

/* Lanes that ask who is active are so together if they ask in the same place, once no other lane of theirs can go on. */
static void tell_active(Thread *t, Warp *w)
{
    u32 asking = 0, first = ~0u, group = 0;
    if (w->live & ~(w->waiting | w->at_barrier))
        return;
    for (u32 rest = w->waiting; rest; rest &= rest - 1) {
        u32 lane = (u32)__builtin_ctz(rest);
        if (w->arrivals[lane].kind == ACTIVE) {
            asking |= 1u << lane;
            first = w->arrivals[lane].mode < first ? w->arrivals[lane].mode : first;
        }
    }
    for (u32 rest = asking; rest; rest &= rest - 1)
        group |= (u32)(w->arrivals[__builtin_ctz(rest)].mode == first) << __builtin_ctz(rest);
    for (u32 rest = group; rest; rest &= rest - 1)
        w->arrivals[__builtin_ctz(rest)].result = group;
    w->waiting &= ~group;
    if (group)
        scheduler_wake(t->linear >> 5, group);
}

static void meet(Thread *t, u32 mask, u32 statement)
{
    Warp *w = warp_of(t);
    u32 self = 1u << t->lane;
    if (UNLIKELY(!(mask & self)))
        emulator_note(t, NOTE_MISSING_LANES, 0, statement, self);
    w->waiting |= self;
    if (!all_wait(w, mask | self) || !complete(t, w, mask | self, statement)) {
        tell_active(t, w);
        scheduler_wait(t);
    }
}

void emulator_sync_warp(Thread *t, u32 mask, u32 statement)
{
    arrival_of(t, SYNC, 0, mask, 0);
    meet(t, mask, statement);
}

u8 emulator_shuffle(Thread *t, u32 mode, u32 count, const u32 *sent, u32 *received, u32 distance, u32 clamp, u32 mask,
    u32 statement)
{
    Arrival *a = arrival_of(t, SHUFFLE, mode, mask, 0);
    a->count = count;
    a->sent = sent;
    a->received = received;
    a->distance = distance;
    a->clamp = clamp;
    meet(t, mask, statement);
    return a->flag;
}

u32 emulator_vote(Thread *t, u32 mode, u32 value, u32 mask, u32 statement)
{
    Arrival *a = arrival_of(t, VOTE, mode, mask, value);
    meet(t, mask, statement);
    return a->result;
}

u32 emulator_redux(Thread *t, u32 mode, u32 value, u32 mask, u32 statement)
{
    Arrival *a = arrival_of(t, REDUX, mode, mask, value);
    meet(t, mask, statement);
    return a->result;
}

u32 emulator_match(Thread *t, u32 mode, u64 value, u32 mask, u8 *all, u32 statement)
{
    Arrival *a = arrival_of(t, MATCH, mode, mask, value);
    meet(t, mask, statement);
    if (all)
        *all = a->flag;
    return a->result;
}

u32 emulator_active_lanes(Thread *t, u32 statement)
{
    Warp *w = warp_of(t);
    Arrival *a = arrival_of(t, ACTIVE, statement, 0, 0);
    w->waiting |= 1u << t->lane;
    tell_active(t, w);
    if (w->waiting >> t->lane & 1)
        scheduler_wait(t);
    return a->result;
}

/* ------------------------------------------------------------------------------------------------ the block */

static int open_barrier(Block *b)
{
    if (!b->arrived || b->arrived < b->live)
        return 0;
    b->arrived = 0;
    b->barriers++;
    for (u32 k = 0; k < 32; k++) {
        u32 lanes = b->warps[k].at_barrier;
        b->warps[k].at_barrier = 0;
        if (lanes)
            scheduler_wake(k, lanes);
    }
    return 1;
}

void emulator_barrier(Thread *t, u32 statement)
{
    (void)statement;
    t->block->arrived++;
    warp_of(t)->at_barrier |= 1u << t->lane;
    if (!open_barrier(t->block)) {
        tell_active(t, warp_of(t));
        scheduler_wait(t);
    }
}

void meeting_without(Thread *t)
{
    Warp *w = warp_of(t);
    w->live &= ~(1u << t->lane);
    t->block->live--;
    open_barrier(t->block);
    for (u32 rest = w->waiting; rest; rest &= rest - 1) {
        u32 lane = (u32)__builtin_ctz(rest), mask = w->arrivals[lane].mask;
        if (w->arrivals[lane].kind == ACTIVE)
            continue;
        if (w->waiting >> lane & 1 && all_wait(w, mask)) /* still: an earlier turn may have let it go */
            complete(t, w, mask, 0);
    }
    tell_active(t, w);
}

/* Checked memory: the spaces of PTX, faults, notes and the race detector. */
#include "scheduler.h"
#include <stdio.h>

Emulator EMULATOR;
u64 emulator_accesses[1024]; /* to memory, by each thread of the running block */

void emulator_fault(Thread *t, u32 kind, u64 address, u32 size, u32 access, u32 statement)
{
    EMULATOR.fault = kind;
    EMULATOR.fault_address = address;
    EMULATOR.fault_size = size;
    EMULATOR.fault_access = access;
    EMULATOR.fault_statement = statement;
    memcpy(EMULATOR.fault_tid, t->tid, sizeof t->tid);
    memcpy(EMULATOR.fault_ctaid, t->ctaid, sizeof t->ctaid);
    __builtin_longjmp(EMULATOR.jump, 1);
}

void emulator_assertion(Thread *t, const char *text, u32 statement)
{
    snprintf(EMULATOR.fault_text, sizeof EMULATOR.fault_text, "%s", text);
    emulator_fault(t, FAULT_ASSERTION, 0, 0, 0, statement);
}

void emulator_note(Thread *t, u32 kind, u64 address, u32 statement, u32 other)
{
    if (EMULATOR.note_count[kind]++)
        return;
    EMULATOR.note_address[kind] = address;
    EMULATOR.note_statement[kind] = statement;
    EMULATOR.note_thread[kind] = t->global;
    EMULATOR.note_other[kind] = other;
}

/* ------------------------------------------------------------------------------------------------ races
   Two threads of one launch at the same bytes, one of them a write that changes them, no barrier of their block
   and no bar.warp.sync of all lanes of their warp between. */

static u16 barriers_of(const Thread *t) { return t->block ? (u16)t->block->barriers : 0; }

static u16 syncs_of(const Thread *t) { return t->block ? (u16)t->block->warps[t->linear >> 5].syncs : 0; }

static int same_warp(const Thread *t, u32 other)
{
    u32 block = t->global - t->linear;
    return other >= block && (other - block) >> 5 == t->linear >> 5;
}

static int same_block(const Thread *t, u32 other)
{
    return other / EMULATOR.block_threads == t->global / EMULATOR.block_threads;
}

static int unordered(const Thread *t, u32 other, u16 barriers, u16 syncs)
{
    if (other == t->global)
        return 0;
    if (!t->block || !same_block(t, other))
        return 1;
    return barriers == barriers_of(t) && !(same_warp(t, other) && syncs != syncs_of(t));
}

/* many_readers after a read by t. Earlier reads do not count if a barrier orders all of them before this one. */
static u8 readers_with(const Thread *t, const Track *k)
{
    u8 many = k->reader == t->global ? 0 : same_warp(t, k->reader) ? 1 : same_block(t, k->reader) ? 2 : 3;
    if (many < k->many_readers)
        many = k->many_readers;
    int ordered = (many < 3 && k->read_barriers != barriers_of(t)) || (many < 2 && k->read_syncs != syncs_of(t));
    return ordered ? 0 : many;
}

static void track_read(Thread *t, Track *k, u64 address, u32 statement)
{
    u32 now = EMULATOR.launch;
    if (k->write_launch == now && unordered(t, k->writer, k->write_barriers, k->write_syncs))
        emulator_note(t, k->atomic ? NOTE_ATOMIC_AND_PLAIN : NOTE_READ_AND_WRITE, address, statement, k->writer);
    k->many_readers = k->read_launch == now ? readers_with(t, k) : 0;
    k->read_launch = now;
    k->reader = t->global;
    k->read_barriers = barriers_of(t);
    k->read_syncs = syncs_of(t);
}

static void track_write(Thread *t, Track *k, u64 address, u32 access, u32 statement)
{
    u32 now = EMULATOR.launch;
    int atomic = access == ATOMIC;
    if (k->write_launch == now && unordered(t, k->writer, k->write_barriers, k->write_syncs)
        && !(atomic && k->atomic))
        emulator_note(t, atomic || k->atomic ? NOTE_ATOMIC_AND_PLAIN : NOTE_TWO_WRITES, address, statement, k->writer);
    int current = k->many_readers == 3 || k->read_barriers == barriers_of(t);
    if (k->many_readers == 1 && same_warp(t, k->reader))
        current = current && k->read_syncs == syncs_of(t);
    if (k->read_launch == now
        && (unordered(t, k->reader, k->read_barriers, k->read_syncs) || (k->many_readers && current)))
        emulator_note(t, atomic ? NOTE_ATOMIC_AND_PLAIN : NOTE_READ_AND_WRITE, address, statement, k->reader);
    k->write_launch = now;
    k->writer = t->global;
    k->write_barriers = barriers_of(t);
    k->write_syncs = syncs_of(t);
    k->atomic = (u8)atomic;
}

static void track(Thread *t, Track *k, u64 address, u32 access, u32 statement)
{
    if (access == LOAD)
        track_read(t, k, address, statement);
    else
        track_write(t, k, address, access, statement);
}

/* Arrays of one or two bytes an element have threads side by side in a word, which do not meet. */
static void track_bytes(Thread *t, Track *word, u64 offset, u32 size, u32 access, u32 statement)
{
    Track *each = EMULATOR.byte_tracks + (offset & ~3ull);
    if (word->split_launch != EMULATOR.launch) {
        word->split_launch = EMULATOR.launch;
        for (u32 k = 0; k < 4; k++)
            each[k] = *word;
    }
    for (u32 k = 0; k < size; k++)
        track(t, each + (offset & 3) + k, EMULATOR.base + offset + k, access, statement);
}

void emulator_track(Thread *t, u64 address, u32 size, u32 access, u32 statement, const void *value)
{
    u64 offset = address - EMULATOR.base;
    if (access == STORE && value && memcmp(value, EMULATOR.bytes + offset, size) == 0)
        return;
    if (size < 4) {
        track_bytes(t, EMULATOR.tracks + (offset >> 2), offset, size, access, statement);
        return;
    }
    for (u64 at = offset; at < offset + size; at += 4) {
        Track *word = EMULATOR.tracks + (at >> 2);
        if (word->split_launch == EMULATOR.launch)
            track_bytes(t, word, at, 4, access, statement);
        else
            track(t, word, EMULATOR.base + at, access, statement);
    }
}

/* ------------------------------------------------------------------------------------------------ spaces */

/* Whether all bytes were written. `size` is a constant where this is expanded: one comparison. */
INLINE int all_written(const u8 *written, u32 size)
{
    u64 ones = 0x0101010101010101ull, found = 0;
    if (size < 8) {
        memcpy(&found, written, size);
        return found == (ones & ((1ull << (8 * size)) - 1));
    }
    for (u32 k = 0; k < size; k += 8) {
        memcpy(&found, written + k, 8);
        if (found != ones)
            return 0;
    }
    return 1;
}

INLINE u8 *global_bytes(Thread *t, u64 address, u32 size, u32 access, u32 statement, const void *value)
{
    u64 offset = address - EMULATOR.base;
    if (UNLIKELY(offset >= EMULATOR.size)) {
        u64 at = address - (u64)(uintptr_t)t->data;
        if (at < t->data_size && at + size <= t->data_size)
            return t->data + at;
        emulator_fault(t, FAULT_OUTSIDE, address, size, access, statement);
    }
    if (UNLIKELY(address & (size - 1)))
        emulator_fault(t, FAULT_MISALIGNED, address, size, access, statement);
    const u8 *valid = EMULATOR.valid + (offset >> 3);
    u32 last = size == 16 ? 8 : (u32)(offset & 7) + size;
    if (UNLIKELY(valid[0] < last || (size == 16 && valid[1] < 8)))
        emulator_fault(t, FAULT_NO_ARRAY, address, size, access, statement);
    emulator_accesses[t->linear]++;
    if (UNLIKELY(EMULATOR.interval) && --EMULATOR.countdown <= 0)
        emulator_switch_threads();
    EMULATOR.atomics += access == ATOMIC;
    if (EMULATOR.written) {
        u8 *written = EMULATOR.written + offset;
        if (access != STORE && UNLIKELY(!all_written(written, size)))
            emulator_note(t, NOTE_UNWRITTEN, address, statement, 0);
        if (access != LOAD)
            memset(written, 1, size);
    }
    if (UNLIKELY(EMULATOR.tracks != 0) && !t->is_ordered)
        emulator_track(t, address, size, access, statement, value);
    return EMULATOR.bytes + offset;
}

INLINE u8 *shared_bytes(Thread *t, u64 address, u32 size, u32 access, u32 statement)
{
    if (UNLIKELY(address >= t->shared_size || address + size > t->shared_size))
        emulator_fault(t, FAULT_SHARED, address, size, access, statement);
    if (UNLIKELY(address & (size - 1)))
        emulator_fault(t, FAULT_MISALIGNED, address, size, access, statement);
    emulator_accesses[t->linear]++;
    if (UNLIKELY(EMULATOR.interval) && --EMULATOR.countdown <= 0)
        emulator_switch_threads();
    return t->shared + address;
}

INLINE u8 *generic_bytes(Thread *t, u64 address, u32 size, u32 access, u32 statement, const void *value)
{
    if (address - EMULATOR.base < EMULATOR.size)
        return global_bytes(t, address, size, access, statement, value);
    u64 in_shared = address - (u64)(uintptr_t)t->shared;
    if (in_shared < t->shared_size)
        return shared_bytes(t, in_shared, size, access, statement);
    if (address >= t->stack_low && address < t->stack_high)
        return (u8 *)(uintptr_t)address;
    u64 in_data = address - (u64)(uintptr_t)t->data;
    if (in_data < t->data_size && in_data + size <= t->data_size)
        return (u8 *)(uintptr_t)address;
    emulator_fault(t, FAULT_OUTSIDE, address, size, access, statement);
}

#define ACCESS(size)                                                                          \
    const u8 *global_load_##size(Thread *t, u64 a, u32 s)                                     \
    {                                                                                         \
        return global_bytes(t, a, size, LOAD, s, 0);                                          \
    }                                                                                         \
    u8 *global_store_##size(Thread *t, u64 a, u32 s, const void *value)                       \
    {                                                                                         \
        return global_bytes(t, a, size, STORE, s, value);                                     \
    }                                                                                         \
    u8 *global_atomic_##size(Thread *t, u64 a, u32 s)                                         \
    {                                                                                         \
        return global_bytes(t, a, size, ATOMIC, s, 0);                                        \
    }                                                                                         \
    const u8 *shared_load_##size(Thread *t, u64 a, u32 s)                                     \
    {                                                                                         \
        return shared_bytes(t, a, size, LOAD, s);                                             \
    }                                                                                         \
    u8 *shared_store_##size(Thread *t, u64 a, u32 s, const void *value)                       \
    {                                                                                         \
        return shared_bytes(t, a, size, STORE, s);                                            \
    }                                                                                         \
    u8 *shared_atomic_##size(Thread *t, u64 a, u32 s)                                         \
    {                                                                                         \
        return shared_bytes(t, a, size, ATOMIC, s);                                           \
    }                                                                                         \
    const u8 *generic_load_##size(Thread *t, u64 a, u32 s)                                    \
    {                                                                                         \
        return generic_bytes(t, a, size, LOAD, s, 0);                                         \
    }                                                                                         \
    u8 *generic_store_##size(Thread *t, u64 a, u32 s, const void *value)                      \
    {                                                                                         \
        return generic_bytes(t, a, size, STORE, s, value);                                    \
    }                                                                                         \
    u8 *generic_atomic_##size(Thread *t, u64 a, u32 s)                                        \
    {                                                                                         \
        return generic_bytes(t, a, size, ATOMIC, s, 0);                                       \
    }
ACCESS(1)
ACCESS(2)
ACCESS(4)
ACCESS(8)
ACCESS(16)

/* ------------------------------------------------------------------------------------------------ printf */

void emulator_print(const char *format, const u8 *arguments)
{
    char out[1024];
    size_t length = 0;
    u32 at = 0;
    for (const char *f = format; *f && length < sizeof out - 64; f++) {
        if (*f != '%') {
            out[length++] = *f;
            continue;
        }
        if (*++f == '%') {
            out[length++] = '%';
            continue;
        }
        char specifier[32] = "%";
        int n = 1, wide = 0;
        for (; *f && !strchr("diouxXeEfgGcsp", *f) && n < 28; f++) {
            wide |= *f == 'l' || *f == 'z';
            specifier[n++] = *f;
        }
        specifier[n++] = *f;
        specifier[n] = 0;
        int real = strchr("eEfgG", *f) != 0;
        u32 size = real || wide || *f == 'p' || *f == 's' ? 8 : 4;
        u64 x = 0;
        at = (at + size - 1) & ~(size - 1);
        memcpy(&x, arguments + at, size);
        at += size;
        if (real) {
            f64 y;
            memcpy(&y, &x, 8);
            length += (size_t)snprintf(out + length, 64, specifier, y);
        } else {
            length += (size_t)snprintf(out + length, 64, specifier, x);
        }
    }
    fwrite(out, 1, length, stdout);
}

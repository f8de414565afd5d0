/* What the C translation of a PTX module is compiled against: threads, checked memory, meetings of a warp.

   Three kinds of names: PTX's types (u8 .. f64), `emulator_...` for what the runtime does for a thread, and the state
   that runtime and Python share (`struct Emulator`, whose twin is `State` in launches.py). */
#pragma once
#include <math.h>
#include <stdint.h>
#include <string.h>

typedef uint8_t u8;
typedef uint16_t u16;
typedef uint32_t u32;
typedef uint64_t u64;
typedef int8_t s8;
typedef int16_t s16;
typedef int32_t s32;
typedef int64_t s64;
typedef float f32;
typedef double f64;
typedef unsigned __int128 u128;
typedef __int128 s128;

#define INLINE static inline __attribute__((always_inline))
#define COLD __attribute__((cold, noinline))
#define UNLIKELY(x) __builtin_expect(!!(x), 0)

/* The numbers stand in findings.py too. */
enum Fault {
    FAULT_NONE,
    FAULT_OUTSIDE,    /* no address of the device */
    FAULT_NO_ARRAY,   /* of the device, but of no live array */
    FAULT_MISALIGNED,
    FAULT_SHARED,     /* outside the block's shared memory */
    FAULT_TRAP,
    FAULT_ASSERTION,
    FAULT_DEADLOCK,   /* all threads wait for each other */
    FAULT_MEETING,    /* threads of a warp meet in different instructions */
};
enum Note {
    NOTE_UNWRITTEN,       /* read of a byte that nobody wrote */
    NOTE_TWO_WRITES,      /* race */
    NOTE_READ_AND_WRITE,  /* race */
    NOTE_ATOMIC_AND_PLAIN,
    NOTE_DIVISION_BY_ZERO,
    NOTE_CAST_OUT_OF_RANGE,
    NOTE_MISSING_LANES,   /* a meeting names lanes that have ended or take no part */
    NOTES
};
enum Access { LOAD, STORE, ATOMIC };
enum Shuffle { SHUFFLE_UP, SHUFFLE_DOWN, SHUFFLE_XOR, SHUFFLE_INDEX };
enum Vote { VOTE_BALLOT, VOTE_ALL, VOTE_ANY, VOTE_UNIFORM };
enum Redux { REDUX_ADD, REDUX_MIN_S, REDUX_MAX_S, REDUX_MIN_U, REDUX_MAX_U, REDUX_AND, REDUX_OR, REDUX_XOR };

/* What a lane brings to a meeting of its warp, and what it takes away. */
typedef struct Arrival {
    u64 value;
    u32 mask, kind, mode;
    u32 distance, clamp, count; /* of shuffles: count words go from `sent` to other lanes' `received` */
    const u32 *sent;
    u32 *received;
    u32 result;
    u8 flag; /* shuffle: the source was inside; match.all: all agree */
} Arrival;

typedef struct Warp {
    u32 live;       /* lanes that have not ended */
    u32 waiting;    /* lanes that wait in a meeting */
    u32 at_barrier; /* lanes that wait for the block */
    u32 syncs;      /* bar.warp.sync of all its lanes, passed so far */
    Arrival arrivals[32];
} Warp;

typedef struct Block {
    u32 live, arrived;
    u32 barriers; /* passed so far */
    Warp warps[32];
} Block;

typedef struct Thread {
    u32 tid[3], ctaid[3], ntid[3], nctaid[3];
    u32 linear, lane, global; /* in the block, in the warp, in the launch */
    u32 shared_size;
    u8 *shared;
    Block *block; /* NULL in kernels whose threads never wait for each other */
    u64 stack_low, stack_high;
    u8 *data; /* the module's own variables */
    u64 data_size;
    u32 is_ordered; /* within a load past the L1 cache, which the race detector skips */
} Thread;

/* The last accesses to four bytes, or to one, for the race detector. */
typedef struct Track {
    u32 write_launch, writer, read_launch, reader;
    u32 split_launch; /* of four bytes: the launch that touches one or two of them alone, and so has a track for each */
    u16 write_barriers, read_barriers;
    u16 write_syncs, read_syncs; /* of the warp */
    u8 atomic, many_readers; /* 1: lanes of one warp, 2: of several, 3: of several blocks */
} Track;

typedef struct Emulator {
    u64 base, size; /* device addresses, which the host cannot touch */
    u8 *bytes;      /* where their bytes really are */
    u8 *valid;      /* of each 8 bytes, how many belong to a live array */
    u8 *written;    /* 1 for each byte that was written; NULL: not looked at */
    Track *tracks;  /* one for each 4 bytes; NULL: races not looked at */
    Track *byte_tracks;
    u32 launch, block_threads;
    s32 interval, countdown; /* mean memory accesses between switches of threads (0: none), and those left */
    u64 random;
    u32 fault, fault_size, fault_access, fault_statement;
    u64 fault_address;
    u32 fault_tid[3], fault_ctaid[3];
    char fault_text[256];
    u64 note_count[NOTES], note_address[NOTES];
    u32 note_statement[NOTES], note_thread[NOTES], note_other[NOTES];
    void *jump[5];
    u8 *covered; /* 4 bytes a mark: kernel_coverage.py */
    u64 atomics; /* on global memory, of the launch */
} Emulator;

extern Emulator EMULATOR;

void emulator_fault(Thread *, u32 kind, u64 address, u32 size, u32 access, u32 statement) __attribute__((noreturn, cold));
void emulator_assertion(Thread *, const char *text, u32 statement) __attribute__((noreturn, cold));
void emulator_note(Thread *, u32 kind, u64 address, u32 statement, u32 other) COLD;
void emulator_track(Thread *, u64 address, u32 size, u32 access, u32 statement, const void *value) COLD;
void emulator_switch_threads(void) COLD;
void emulator_print(const char *format, const u8 *arguments);

/* Where the bytes of an access are. A store's value tells writes that change nothing, which are no race. */
#define ACCESS(space, size)                                                                 \
    const u8 *space##_load_##size(Thread *, u64 address, u32 statement);                    \
    u8 *space##_store_##size(Thread *, u64 address, u32 statement, const void *value);      \
    u8 *space##_atomic_##size(Thread *, u64 address, u32 statement);
#define ACCESSES(space) ACCESS(space, 1) ACCESS(space, 2) ACCESS(space, 4) ACCESS(space, 8) ACCESS(space, 16)
ACCESSES(global)
ACCESSES(shared)
ACCESSES(generic)
#undef ACCESSES
#undef ACCESS

void emulator_barrier(Thread *, u32 statement);
void emulator_sync_warp(Thread *, u32 mask, u32 statement);
u8 emulator_shuffle(Thread *, u32 mode, u32 count, const u32 *sent, u32 *received, u32 distance, u32 clamp,
    u32 mask, u32 statement);
u32 emulator_vote(Thread *, u32 mode, u32 value, u32 mask, u32 statement);
u32 emulator_redux(Thread *, u32 mode, u32 value, u32 mask, u32 statement);
u32 emulator_match(Thread *, u32 mode, u64 value, u32 mask, u8 *all, u32 statement);
u32 emulator_active_lanes(Thread *, u32 statement);

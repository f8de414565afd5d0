/* Between the runtime's own files: who runs next. */
#pragma once
#include "emulator.h"

u64 scheduler_random(void);
/* The running thread waits until scheduler_wake names it. */
void scheduler_wait(Thread *);
void scheduler_wake(u32 warp, u32 lanes);
/* A thread's end can complete what others wait for. */
void meeting_without(Thread *);

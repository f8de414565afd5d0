"""Run with EMULATED_CUDA_RACES=1: prints which kernels race, and how, as JSON."""

import json
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from emulated_cuda.install import install, installed

install()

import warp as wp  # noqa: E402  after the device
from emulated_cuda.ptx_programs import Programs  # noqa: E402

from pointloom.kernels.arrays.segment_blocks import SegmentBlocks  # noqa: E402
from pointloom.kernels.icp.jobs import first_moments, sum_moments  # noqa: E402
from pointloom.kernels.lang import reduce_segments  # noqa: E402

wp.config.quiet = True
DEVICE = "cuda:0"


@wp.kernel(enable_backward=False)
def two_writes_kernel(a: wp.array(dtype=int)):
    a[0] = wp.tid()


@wp.kernel(enable_backward=False)
def same_value_kernel(a: wp.array(dtype=int)):
    a[0] = 7


@wp.kernel(enable_backward=False)
def own_element_kernel(a: wp.array(dtype=int)):
    i = wp.tid()
    a[i] = a[i] + 1


@wp.kernel(enable_backward=False)
def read_of_another_kernel(a: wp.array(dtype=int)):
    i = wp.tid()
    if i > 0:
        a[i] = a[i - 1] + 1


@wp.kernel(enable_backward=False)
def atomics_kernel(a: wp.array(dtype=int)):
    wp.atomic_add(a, 0, 1)


@wp.kernel(enable_backward=False)
def atomic_and_plain_kernel(a: wp.array(dtype=int)):
    i = wp.tid()
    wp.atomic_add(a, 0, 1)
    a[1 + i] = a[0]


@wp.kernel(enable_backward=False)
def bytes_of_a_word_kernel(a: wp.array(dtype=wp.uint8)):
    i = wp.tid()
    a[i] = wp.uint8(i)


@wp.kernel(enable_backward=False)
def own_byte_kernel(a: wp.array(dtype=wp.uint8)):
    i = wp.tid()
    a[i] = a[i] + wp.uint8(1)


@wp.kernel(enable_backward=False)
def byte_of_another_kernel(a: wp.array(dtype=wp.uint8)):
    i = wp.tid()
    if i > 0:
        a[i] = a[i - 1] + wp.uint8(1)


@wp.kernel(enable_backward=False)
def two_writes_of_a_byte_kernel(a: wp.array(dtype=wp.uint8)):
    a[wp.tid() // 64] = wp.uint8(1 + wp.tid())


@wp.kernel(enable_backward=False)
def own_half_kernel(a: wp.array(dtype=wp.uint16)):
    i = wp.tid()
    a[i] = a[i] + wp.uint16(1)


@wp.kernel(enable_backward=False)
def tiles_kernel(a: wp.array(dtype=int), out: wp.array(dtype=int)):
    i = wp.tid()
    x = a[i] + 0
    wp.tile_store(out, wp.tile_sum(wp.tile(x)), offset=i // 64)


# Each thread writes its word and reads that of another.
NEIGHBOR = """
.visible .entry NAME(.param .u64 a)
{
    .reg .b32 %r<5>; .reg .b64 %rd<5>;
    ld.param.u64 %rd1, [a];
    mov.u32 %r1, %tid.x;
    mul.wide.u32 %rd2, %r1, 4;
    add.s64 %rd2, %rd1, %rd2;
    xor.b32 %r2, %r1, OTHER;
    mul.wide.u32 %rd3, %r2, 4;
    add.s64 %rd3, %rd1, %rd3;
    add.s32 %r3, %r1, 1;
    st.global.u32 [%rd2], %r3;
    BARRIER
    ld.global.u32 %r4, [%rd3];
    ret;
}
"""
NEIGHBORS = (
    ("with_barrier", "1", "bar.sync 0;"),
    ("without_barrier", "1", ""),
    ("with_warp_barrier", "1", "bar.warp.sync 0xffffffff;"),
    ("with_warp_barrier_between_warps", "32", "bar.warp.sync 0xffffffff;"),
)
# All threads read a word. After the barrier the first thread reads it again and writes it.
READERS = """
.visible .entry NAME(.param .u64 a)
{
    .reg .b32 %r<5>; .reg .b64 %rd<2>; .reg .pred %p<2>;
    ld.param.u64 %rd1, [a];
    ld.global.u32 %r1, [%rd1];
    BARRIER
    mov.u32 %r2, %tid.x;
    mov.u32 %r3, %ctaid.x;
    or.b32 %r2, %r2, %r3;
    setp.ne.u32 %p1, %r2, 0;
    @%p1 bra DONE;
    ld.global.u32 %r4, [%rd1];
    add.s32 %r4, %r4, 1;
    st.global.u32 [%rd1], %r4;
DONE:
    ret;
}
"""
READER_CASES = (  # name, threads, barrier; blocks have 64 threads
    ("readers_before_barrier", 64, "bar.sync 0;"),
    ("readers_without_barrier", 64, ""),
    ("readers_before_warp_barrier", 32, "bar.warp.sync 0xffffffff;"),
    ("readers_of_two_warps_before_warp_barrier", 64, "bar.warp.sync 0xffffffff;"),
    ("readers_of_two_blocks_before_barrier", 128, "bar.sync 0;"),
)


def main() -> None:
    numbers = (two_writes_kernel, same_value_kernel, own_element_kernel, read_of_another_kernel, atomics_kernel)
    for kernel in (*numbers, atomic_and_plain_kernel):
        wp.launch(kernel, 128, [wp.zeros(256, dtype=int, device=DEVICE)], device=DEVICE)
    for kernel in (bytes_of_a_word_kernel, own_byte_kernel, byte_of_another_kernel, two_writes_of_a_byte_kernel):
        wp.launch(kernel, 128, [wp.zeros(128, dtype=wp.uint8, device=DEVICE)], device=DEVICE)
    wp.launch(own_half_kernel, 128, [wp.zeros(128, dtype=wp.uint16, device=DEVICE)], device=DEVICE)
    given, out = wp.zeros(256, dtype=int, device=DEVICE), wp.zeros(4, dtype=int, device=DEVICE)
    wp.launch(tiles_kernel, 256, [given, out], device=DEVICE, block_dim=64)
    blocks = SegmentBlocks([0, 5000], [5000, 100], wp.get_device(DEVICE))
    points, live = wp.zeros(5100, dtype=wp.vec3, device=DEVICE), wp.full(2, 1, dtype=int, device=DEVICE)
    for _ in range(2):
        out = wp.zeros(2, dtype=first_moments, device=DEVICE)
        reduce_segments(sum_moments, blocks, live, [points], blocks.partials(first_moments), out)
    device = installed()
    assert device is not None
    with tempfile.TemporaryDirectory() as folder:
        programs = Programs(device, Path(folder))
        for name, other, barrier in NEIGHBORS:
            text = NEIGHBOR.replace("NAME", name).replace("BARRIER", barrier).replace("OTHER", other)
            a = wp.zeros(64, dtype=int, device=DEVICE)
            programs.launch(text, [a], threads=64, block=64, name=name)
        for name, threads, barrier in READER_CASES:
            text = READERS.replace("NAME", name).replace("BARRIER", barrier)
            a = wp.zeros(64, dtype=int, device=DEVICE)
            programs.launch(text, [a], threads=threads, block=min(threads, 64), name=name)
    wp.synchronize()
    notes = sorted(device.findings.notes)
    kinds = {name: [kind for kernel, kind in notes if kernel == name] for name in device.findings.launches}
    print(json.dumps({name: ", ".join(found) or "none" for name, found in kinds.items()}))


if __name__ == "__main__":
    main()

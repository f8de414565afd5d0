"""Blocks, warps and orders of threads."""

import numpy as np
import pytest
import warp as wp

from .findings import CudaFault
from .test_captures import add_kernel

DEVICE = "cuda:0"
ORDERS = pytest.mark.parametrize("order", [0, 1, 2, 3])
HEAD = """
.visible .entry k(.param .u64 out)
{
    .reg .pred %p<9>; .reg .b32 %r<19>; .reg .b64 %rd<9>;
    .shared .align 4 .b8 mine[1024];
    mov.u32 %r1, %tid.x; ld.param.u64 %rd1, [out]; mul.wide.u32 %rd2, %r1, 4; add.s64 %rd1, %rd1, %rd2;
"""
TAIL = """
    st.global.u32 [%rd1], %r9;
    ret;
}
"""
ONE_STAYS_AWAY = """
    setp.eq.u32 %p1, %r1, 5; @%p1 bra AWAY; bar.warp.sync 0xffffffff; bra OUT;
AWAY: bar.sync 0;
OUT: mov.u32 %r9, 1;
"""
OTHER_MEETING = """
    setp.eq.u32 %p1, %r1, 5; @%p1 bra OTHER; vote.sync.ballot.b32 %r9, %p1, 0xffffffff; bra OUT;
OTHER: activemask.b32 %r9; bar.warp.sync 0xffffffff;
OUT: mov.u32 %r9, 1;
"""
ROTATE = "add.s32 %r2, %r1, 1; shfl.sync.idx.b32 %r9, %r1, %r2, 31, 0xffffffff;"
DOWN = "shfl.sync.down.b32 %r9|%p1, %r1, 8, 31, 0xffffffff; @!%p1 mov.u32 %r9, 1000;"
UP_IN_EIGHTS = "shfl.sync.up.b32 %r9|%p1, %r1, 3, 0x1800, 0xffffffff; @!%p1 mov.u32 %r9, 1000;"
BUTTERFLY = "shfl.sync.bfly.b32 %r9, %r1, 5, 31, 0xffffffff;"
PAIRED = """
    mul.lo.s32 %r2, %r1, 100; mov.u32 %r4, 1; shfl.sync.down.b32 %r3, %r1, %r4, 31, 0xffffffff;
    add.s32 %r5, %r3, 7; mov.u32 %r4, 2; shfl.sync.down.b32 %r6, %r2, 1, 31, 0xffffffff;
    shfl.sync.down.b32 %r7, %r5, 1, 31, 0xffffffff; mov.u32 %r2, 0;
    add.s32 %r8, %r6, %r7; add.s32 %r9, %r8, %r2;
"""
CHAINED = "shfl.sync.down.b32 %r2, %r1, 1, 31, 0xffffffff; shfl.sync.down.b32 %r9, %r2, 1, 31, 0xffffffff;"
CARRIED = "shfl.sync.down.b32 %r2, %r1, 1, 31, 0xffffffff; add.cc.u32 %r3, %r2, 0xfffffff0; addc.u32 %r9, 0, 0;"
ROTATE_SHARED = """
    mov.u32 %r2, mine; shl.b32 %r3, %r1, 2; add.s32 %r4, %r2, %r3; st.shared.u32 [%r4], %r1;
    bar.sync 0;
    mov.u32 %r5, %ntid.x; sub.s32 %r5, %r5, %r1; sub.s32 %r5, %r5, 1; shl.b32 %r5, %r5, 2; add.s32 %r5, %r2, %r5;
    ld.shared.u32 %r9, [%r5];
"""
OUT_OF_SHARED = "ld.shared.u32 %r9, [mine+1024];"
UNWRITTEN_SHARED = "ld.shared.u32 %r9, [mine+8];"
REDUX = "redux.sync.max.s32 %r9, %r1, 0xffffffff;"
MATCH = "shr.u32 %r2, %r1, 4; match.any.sync.b32 %r9, %r2, 0xffffffff;"
TRAP = "setp.eq.u32 %p1, %r1, 7; @%p1 trap; mov.u32 %r9, 0;"


@pytest.fixture
def run(programs):
    """A function (body, threads): what each thread of one block has in %r9 at the end."""

    def launch(body: str, threads: int = 64) -> np.ndarray:
        out = wp.zeros(threads, dtype=wp.int32, device=DEVICE)
        assert programs.launch(HEAD + body + TAIL, [out], threads=threads, block=threads) == 0
        return out.numpy()

    return launch


@pytest.fixture
def fault(run, emulated):
    """A function (pattern, body, threads): the launch must fail with a matching fault."""

    def check(pattern: str, body: str, threads: int = 64) -> None:
        with emulated.findings.expected(), pytest.raises(CudaFault, match=pattern):
            run(body, threads)

    return check


LANES = np.arange(64)
WARP = LANES // 32 * 32


@ORDERS
@pytest.mark.parametrize(
    ("body", "expected"),
    [
        (ROTATE, WARP + (LANES + 1) % 32),
        (DOWN, np.where(LANES % 32 < 24, LANES + 8, 1000)),
        (UP_IN_EIGHTS, np.where(LANES % 8 >= 3, LANES - 3, 1000)),
        (BUTTERFLY, LANES ^ 5),
        (ROTATE_SHARED, LANES[::-1]),
        (REDUX, WARP + 31),
        (MATCH, np.where(LANES % 32 < 16, 0xFFFF, -0x10000)),
        (CHAINED, np.where(LANES % 32 < 30, LANES + 2, WARP + 31)),
        (CARRIED, np.where(LANES % 32 < 31, LANES + 1, LANES) >= 16),
    ],
    ids=["rotate", "down", "up in eights", "butterfly", "shared memory", "redux", "match", "chained", "carried"],
)
def test_threads_of_a_block_exchange_values(run, settings, order, body, expected):
    settings(order=order)
    np.testing.assert_array_equal(run(body), expected)


def test_consecutive_shuffles_use_their_own_values(run):
    lane = LANES % 32
    first = np.where(lane < 31, LANES + 1, LANES)
    seventh = np.append((first + 7)[1:], 0)
    expected = np.where(lane < 31, LANES * 100 + 100 + seventh, LANES * 100 + first + 7)
    np.testing.assert_array_equal(run(PAIRED), expected)


@ORDERS
def test_a_barrier_that_one_thread_misses_is_a_fault(fault, settings, order):
    settings(order=order)
    fault("threads wait for each other for ever.*1 wait at a barrier, 31 in meetings", ONE_STAYS_AWAY, 32)


def test_lanes_in_different_meetings_are_a_fault(fault):
    fault("threads of a warp meet in different instructions", OTHER_MEETING, 32)


def test_ended_threads_are_not_awaited(run):
    body = "setp.ge.u32 %p1, %r1, 40; @%p1 ret; bar.sync 0; mov.u32 %r9, 1;"
    np.testing.assert_array_equal(run(body), LANES < 40)


@pytest.mark.parametrize("meeting", [DOWN, "vote.sync.ballot.b32 %r9, %p1, 0xffffffff;"], ids=["shuffle", "vote"])
def test_a_meeting_that_names_lanes_which_have_ended_is_noted(run, emulated, meeting):
    emulated.findings.notes.pop(("k", "meeting without all lanes"), None)
    run("setp.ge.u32 %p1, %r1, 20; @%p1 ret; " + meeting, 32)
    assert ("k", "meeting without all lanes") in emulated.findings.notes


def test_shared_memory_ends(fault, run):
    fault("address outside shared memory: read of 4 bytes", OUT_OF_SHARED)
    assert (run(UNWRITTEN_SHARED).view(np.uint32) == 0xCBCBCBCB).all()


def test_a_trap_is_a_fault_of_its_thread(fault):
    fault(r"k: trap: block \(0, 0, 0\), thread \(7, 0, 0\)", TRAP)


@pytest.mark.parametrize(
    ("threads", "shared", "reason"),
    [(2048, 0, "2048 threads a block, 1024 at most"), (32, (48 << 10) + 4, "bytes of dynamic shared memory")],
)
def test_a_block_has_1024_threads_at_most_and_must_request_shared_memory(programs, emulated, threads, shared, reason):
    out = wp.zeros(threads, dtype=wp.int32, device=DEVICE)
    with emulated.findings.expected():
        assert programs.launch(HEAD + ROTATE + TAIL, [out], threads=threads, block=threads, shared=shared) != 0
    assert reason in emulated.findings.error


@wp.kernel(enable_backward=False)
def last_one_kernel(a: wp.array(dtype=int)):
    i = wp.tid()
    a[0] = i


@wp.kernel(enable_backward=False)
def count_up_kernel(a: wp.array(dtype=int)):
    i = wp.tid()
    a[0] = a[0] + i


@wp.kernel(enable_backward=False)
def atomic_sum_kernel(a: wp.array(dtype=float), out: wp.array(dtype=float)):
    i = wp.tid()
    wp.atomic_add(out, 0, a[i])


@wp.kernel(enable_backward=False)
def sum_tiles_kernel(a: wp.array(dtype=float), out: wp.array(dtype=float)):
    i = wp.tid()
    x = a[i] + 0.0
    wp.tile_store(out, wp.tile_sum(wp.tile(x)), offset=i // 64)


def _last(order, seed, settings) -> int:
    settings(order=order, seed=seed)
    a = wp.zeros(1, dtype=int, device=DEVICE)
    wp.launch(last_one_kernel, 1000, [a], device=DEVICE)
    return int(a.numpy()[0])


def test_orders_run_forward_backward_and_shuffled(settings):
    assert (_last(0, 1, settings), _last(1, 1, settings)) == (999, 0)
    for order in (2, 3):
        assert len({_last(order, seed, settings) for seed in range(6)}) > 2


def test_interleaved_threads_lose_updates_in_the_same_way_for_the_same_seed(settings, emulated):
    def total() -> int:
        settings(order=3)
        emulated.findings.counts["launches"] = 0  # the seed of a launch is made of both
        a = wp.zeros(1, dtype=int, device=DEVICE)
        wp.launch(count_up_kernel, 256, [a], device=DEVICE)
        return int(a.numpy()[0])

    known = emulated.findings.counts["launches"]
    first = total()
    assert first == total() != sum(range(256))
    emulated.findings.counts["launches"] += known


@ORDERS
def test_tiles_sum_full_blocks(rng, settings, order):
    settings(order=order)
    a = rng.integers(0, 100, 256).astype(np.float32)
    out = wp.zeros(4, dtype=float, device=DEVICE)
    wp.launch(sum_tiles_kernel, 256, [wp.array(a, device=DEVICE), out], device=DEVICE, block_dim=64)
    np.testing.assert_array_equal(out.numpy(), a.reshape(4, 64).sum(axis=1))


def test_atomics_are_counted_and_those_of_floats_named(emulated):
    out = wp.zeros(1, dtype=float, device=DEVICE)
    before = emulated.findings.atomics["atomic_sum_kernel"]
    wp.launch(atomic_sum_kernel, 64, [wp.ones(64, dtype=float, device=DEVICE), out], device=DEVICE)
    assert out.numpy()[0] == 64 == emulated.findings.atomics["atomic_sum_kernel"] - before
    assert any("atom.add.f32: the sum depends" in text for text in emulated.findings.kernels["atomic_sum_kernel"])


def test_a_large_launch_has_all_its_threads(settings):
    settings(order=2)
    a = wp.zeros(70_001, dtype=int, device=DEVICE)
    wp.launch(add_kernel, 70_001, [a, 1], device=DEVICE)
    np.testing.assert_array_equal(a.numpy(), 1)

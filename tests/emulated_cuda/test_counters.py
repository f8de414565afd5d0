"""Counts of kernels that are small enough to be counted by hand."""

from __future__ import annotations

import numpy as np
import pytest
import warp as wp

from .counters import HIT_CYCLES, LaunchCounts
from .ptx.blocks import END, post_dominators
from .ptx_programs import Programs

HEAD = """
.visible .entry k(.param .u64 a, .param .u64 b)
{
    .reg .pred %p<4>; .reg .b32 %r<16>; .reg .b64 %rd<8>; .reg .f32 %f<8>; .reg .f64 %fd<4>;
    .local .align 4 .b8 depot[64];
    .shared .align 4 .b8 tile[8192];
    ld.param.u64 %rd1, [a];
    ld.param.u64 %rd2, [b];
    mov.u32 %r1, %tid.x;
    mov.u32 %r2, %ctaid.x;
    mov.u32 %r3, %ntid.x;
    mad.lo.u32 %r4, %r2, %r3, %r1;
"""
END_OF_KERNEL = "\n    ret;\n}\n"
THREADS = 256


@pytest.fixture
def count(emulated, settings, tmp_path):
    """A function (body, threads): the counts of a launch of a kernel, all of whose blocks are sampled."""
    settings(counters=10**6)
    programs, counters = Programs(emulated, tmp_path), emulated.launches.counters

    def run(body: str, threads: int = THREADS, arrays: tuple = (), **values) -> LaunchCounts:
        given = arrays or [wp.zeros(64 * THREADS, dtype=wp.float32, device="cuda:0") for _ in range(2)]
        wp.synchronize()
        counters.launches.clear()
        counters.known.clear()
        assert programs.launch(HEAD + body + END_OF_KERNEL, given, threads=threads, block=THREADS, **values) == 0
        wp.synchronize()
        return next(x for x in counters.launches if x.kernel == "k")

    return run


def copy(stride: int) -> str:
    """Thread i copies a float32 at i * stride bytes."""
    return f"""
    mul.wide.u32 %rd3, %r4, {stride};
    add.s64 %rd4, %rd1, %rd3;
    add.s64 %rd5, %rd2, %rd3;
    ld.global.f32 %f1, [%rd4];
    st.global.f32 [%rd5], %f1;"""


@pytest.mark.parametrize(
    ("stride", "sectors", "turns"), [(0, 1, 1), (4, 4, 1), (8, 8, 2), (32, 32, 8), (128, 32, 32), (132, 32, 8)]
)
def test_a_copy_asks_for_the_sectors_that_its_stride_spreads_it_over(count, stride, sectors, turns):
    # turns: words in one bank, or lines four by four
    found = count(copy(stride))
    for access in ("global load", "global store"):
        traffic = found.traffic[access]
        assert (traffic["requests"], traffic["lanes"], traffic["bytes"]) == (1, 32, 128)
        assert (traffic["sectors"], traffic["wavefronts"]) == (sectors, turns)
    assert found.traffic["global store"]["missed"] == sectors  # stores go through
    assert found.active_lanes == 1


def test_loads_of_16_bytes_are_16_sectors_a_request(count):
    found = count("""
    mul.wide.u32 %rd3, %r4, 16;
    add.s64 %rd4, %rd1, %rd3;
    ld.global.v4.f32 {%f1, %f2, %f3, %f4}, [%rd4];""")
    assert found.traffic["global load"]["sectors"] == 16
    assert found.traffic["global load"]["bytes"] == 512


def test_memory_is_read_and_written_once(count):
    arrays = [wp.zeros(1 << 16, dtype=wp.float32, device="cuda:0") for _ in range(2)]
    found = count(copy(4), threads=1 << 16, arrays=arrays)
    assert (found.blocks, found.warps, found.sampled_warps) == (256, 2048, 2048)
    # zeros were filled just before, and are in the L2 still: nothing comes from memory, and nothing is written anew
    assert (found.memory_reads, found.memory_writes) == (0, 0)


def test_what_the_l2_has_lost_comes_from_memory(count, emulated):
    arrays = [wp.zeros(1 << 16, dtype=wp.float32, device="cuda:0") for _ in range(2)]
    wp.zeros(64 << 20, dtype=wp.uint8, device="cuda:0")  # more than the L2 holds
    found = count(copy(4), threads=1 << 16, arrays=arrays)
    assert (found.memory_reads, found.memory_writes) == (1 << 18, 1 << 18)


def test_a_branch_that_parts_the_lanes_halves_those_that_are_active(count):
    work = "\n".join(f"    add.f32 %f{k}, %f{k}, %f{k};" for k in (1, 2, 3, 4) for _ in range(50))
    found = count(f"""
    and.b32 %r5, %r1, 1;
    setp.eq.u32 %p1, %r5, 0;
    @%p1 bra EVEN;
{work}
    bra JOIN;
EVEN:
{work}
JOIN:
    mov.u32 %r6, 0;""")
    assert found.active_lanes == pytest.approx(0.5, abs=0.02)
    assert found.units["fma"] == 400 + 2  # both ways, 200 each, and the product of the thread's number


def test_lanes_that_go_the_same_way_run_it_once(count):
    work = "\n".join("    add.f32 %f1, %f1, %f1;" for _ in range(100))
    found = count(f"""
    setp.lt.u32 %p1, %r1, 32;
    @%p1 bra JOIN;
{work}
JOIN:
    mov.u32 %r6, 0;""")
    assert found.units["fma"] == 100 * 7 / 8 + 2
    assert found.active_lanes == 1


LOOP = """
    mov.u32 %r6, 0;
AGAIN:
    add.f32 %f1, %f1, %f1;
    add.u32 %r6, %r6, 1;
    setp.lt.u32 %p1, %r6, %r5;
    @%p1 bra AGAIN;"""


def test_a_loop_runs_as_often_as_the_lane_that_stays_longest(count):
    found = count("    and.b32 %r5, %r1, 31;\n    add.u32 %r5, %r5, 1;" + LOOP)
    assert found.units["fma"] - 2 == 32  # lane k turns k + 1 times
    lanes = found.lane_statements - 32 * (found.warp_statements - 4 * 32)
    assert lanes == 4 * sum(range(1, 33))


def test_an_inner_loop_waits_for_its_slowest_lane_in_each_turn(count):
    # turn t of the outer loop: lane t turns 10 times in the inner one, all others once
    found = count(
        """
    and.b32 %r7, %r1, 31;
    mov.u32 %r8, 0;
OUTER:
    setp.eq.u32 %p2, %r7, %r8;
    selp.b32 %r5, 10, 1, %p2;"""
        + LOOP
        + """
    add.u32 %r8, %r8, 1;
    setp.lt.u32 %p3, %r8, 32;
    @%p3 bra OUTER;"""
    )
    assert found.units["fma"] - 2 == 32 * 10  # not 10 + 31, which is what each lane turns


def test_lanes_that_leave_early_are_not_active(count):
    work = "\n".join("    add.f32 %f1, %f1, %f1;" for _ in range(200))
    found = count(f"""
    and.b32 %r5, %r1, 31;
    setp.gt.u32 %p1, %r5, 7;
    @%p1 bra OUT;
{work}
OUT:""")
    assert found.active_lanes == pytest.approx(0.25, abs=0.05)


def test_calls_run_together_and_part_inside(count, emulated):
    found = count(
        """
    { .param .b32 x; .param .b32 y;
    st.param.b32 [x], %r1;
    call.uni (y), twice, (x);
    ld.param.b32 %r5, [y]; }
    add.f32 %f1, %f1, %f1;"""
        + END_OF_KERNEL
        + """
.func (.param .b32 y) twice(.param .b32 x)
{
    .reg .pred %p<2>; .reg .b32 %r<4>; .reg .f32 %f<4>;
    ld.param.u32 %r1, [x];
    and.b32 %r2, %r1, 1;
    setp.eq.u32 %p1, %r2, 0;
    @%p1 bra EVEN;
    add.f32 %f1, %f1, %f1;
    st.param.b32 [y], %r1;
    ret;
EVEN:
    add.f32 %f2, %f2, %f2;
    st.param.b32 [y], %r2;"""
    )
    assert found.units["fma"] - 2 == 3  # both ways, and once after the call


def test_local_arrays_are_one_sector_for_eight_lanes(count):
    found = count("    st.local.u32 [depot+8], %r1;\n    ld.local.u32 %r5, [depot+8];")
    for access in ("local load", "local store"):
        assert found.traffic[access]["bytes"] == 128
        assert found.traffic[access]["sectors"] == 4
    assert found.traffic["local store"]["missed"] == 4


def test_local_arrays_with_an_index_of_each_lane_spread(count):
    found = count("""
    mov.u64 %rd3, depot;
    and.b32 %r5, %r1, 7;
    mul.wide.u32 %rd4, %r5, 4;
    add.s64 %rd5, %rd3, %rd4;
    st.local.u32 [%rd5], %r1;""")
    assert found.traffic["local store"]["sectors"] == 32  # 8 words, in each 4 sectors of 8 lanes: all touched
    assert found.traffic["local store"]["wavefronts"] == 8


@pytest.mark.parametrize(("stride", "turns"), [(0, 1), (4, 1), (8, 2), (32, 8), (128, 32)])
def test_shared_memory_takes_a_turn_for_each_word_in_its_fullest_bank(count, stride, turns):
    found = count(f"""
    and.b32 %r5, %r1, 31;
    mul.lo.u32 %r5, %r5, {stride};
    mov.u32 %r6, tile;
    add.u32 %r5, %r5, %r6;
    st.shared.u32 [%r5], %r1;""")
    assert found.traffic["shared store"]["wavefronts"] == turns
    assert found.traffic["shared store"]["missed"] == 0


def test_atomics_go_to_the_l2_and_the_address_that_all_want_is_known(count):
    found = count("    atom.global.add.u32 %r5, [%rd1], 1;", threads=1024)
    assert found.traffic["global atomic"]["lanes"] == 32
    assert found.traffic["global atomic"]["missed"] == 1
    assert found.hot_atomics == 1024
    apart = count(f"{copy(4)}\n    red.global.add.u32 [%rd4], 1;", threads=1024)
    assert apart.traffic["global atomic"]["missed"] == 4
    assert apart.hot_atomics == 1


def test_shuffles_votes_and_barriers_are_counted_where_threads_wait_for_each_other(count):
    found = count("""
    shfl.sync.bfly.b32 %r5, %r1, 1, 31, -1;
    shfl.sync.bfly.b32 %r6, %r5, 2, 31, -1;
    setp.ne.u32 %p1, %r6, 0;
    vote.sync.ballot.b32 %r7, %p1, -1;
    bar.sync 0;
    add.f32 %f1, %f1, %f1;""")
    assert found.units["lsu"] == 2 * 4
    assert found.units["fma"] == 1 + 2
    assert found.active_lanes == 1
    assert found.chain >= 2 * 24 + 12  # shuffle after shuffle, then the vote


def test_doubles_keep_their_unit_busy_twice_as_long(count):
    found = count("    add.f64 %fd1, %fd1, %fd2;\n    cvt.rn.f32.f64 %f1, %fd1;")
    assert found.units["fp64"] == 2
    assert found.units["xu"] == 8


def test_loads_that_wait_for_loads_are_waits_after_one_another(count):
    chase = "\n".join(["    ld.global.u64 %rd1, [%rd1];"] * 3)
    pointers = wp.zeros(8, dtype=wp.uint64, device="cuda:0")
    pointers.fill_(pointers.ptr)
    found = count(chase, arrays=(pointers, pointers))
    assert found.hits + found.misses == 3
    beside = "\n".join(f"    ld.global.f32 %f{k}, [%rd1+{4 * k}];" for k in range(3))
    found = count(beside, arrays=(pointers, pointers))
    assert found.hits + found.misses == 1  # all at once
    assert found.slowest >= found.chain + HIT_CYCLES * found.hits


def test_lines_of_the_source_have_their_instructions_those_of_headers_where_they_were_called(count, emulated):
    emulated.launches.counters.places.clear()
    count(
        """
    .loc 1 7 3
    add.f32 %f1, %f1, %f1;
    add.f32 %f1, %f1, %f1;
    .loc 2 99 1, function_name $L__name, inlined_at 1 8 5
    add.f32 %f1, %f1, %f1;
    .loc 2 44 1, function_name $L__name, inlined_at 2 99 1
    ld.global.f32 %f2, [%rd1];"""
        + END_OF_KERNEL
        + """
    .file 1 "kernels/room.py"
    .file 2 "site-packages/warp/native/vec.h"
    .func unused() {"""
    )
    places = {place: found for (kernel, place), found in emulated.launches.counters.places.items() if kernel == "k"}
    warps = THREADS / 32
    assert places["kernels/room.py:7"].instructions == 2 * warps
    assert places["kernels/room.py:8"].lane_statements == 3 * THREADS  # with the return
    assert places["kernels/room.py:8"].sectors == warps  # one address of all


def test_some_blocks_stand_for_all(count, settings):
    settings(counters=4)
    arrays = [wp.zeros(1 << 16, dtype=wp.float32, device="cuda:0") for _ in range(2)]
    found = count(copy(4), threads=1 << 16, arrays=arrays)
    assert (found.warps, found.sampled_warps) == (2048, 32)
    assert found.traffic["global load"]["requests"] == 1


def test_blocks_that_are_not_counted_can_be_left_out(count, settings):
    settings(counters=4, counted_alone="k|other")
    arrays = [wp.zeros(1 << 16, dtype=wp.float32, device="cuda:0") for _ in range(2)]
    arrays[0].fill_(1.0)
    wp.zeros(64 << 20, dtype=wp.uint8, device="cuda:0")  # the L2 has nothing of the arrays left
    found = count(copy(4), threads=1 << 16, arrays=arrays)
    assert (found.warps, found.sampled_warps) == (2048, 32)
    assert arrays[1].numpy().sum() == 32 * 32
    assert found.memory_reads == 1 << 18  # as all would have


def test_results_are_the_same_with_counters(emulated, settings, tmp_path):
    found = []
    for counters in (0, 10**6):
        settings(counters=counters)
        a = wp.array(np.arange(512, dtype=np.float32), device="cuda:0")
        b = wp.zeros(512, dtype=wp.float32, device="cuda:0")
        Programs(emulated, tmp_path).launch(HEAD + copy(4) + END_OF_KERNEL, [a, b], threads=512, block=THREADS)
        found.append(b.numpy())
    np.testing.assert_array_equal(*found)
    assert found[0][511] == 511


def test_ways_meet_at_their_immediate_post_dominator():
    # 0 parts to 1 and 2; 1 parts to 3 and 4, which meet in 5; 2 and 5 meet in 6; 6 loops to itself or ends
    ways = {0: {1, 2}, 1: {3, 4}, 2: {6}, 3: {5}, 4: {5}, 5: {6}, 6: {6, END}}
    assert post_dominators(ways) == {0: 6, 1: 5, 2: 6, 3: 5, 4: 5, 5: 6, 6: END}


@pytest.fixture
def happened(emulated, settings):
    """A function (work): what was counted while it ran, which wait included."""
    settings(counters=10**6)

    def run(work) -> list[LaunchCounts]:
        wp.synchronize()
        emulated.launches.counters.launches.clear()
        work()
        wp.synchronize()
        return list(emulated.launches.counters.launches)

    return run


def test_copies_fills_and_waits_stand_in_the_order_in_which_they_happened(happened):
    a, b = (wp.empty(1000, dtype=wp.float32, device="cuda:0") for _ in range(2))

    def work() -> None:
        a.zero_()
        wp.copy(b, a)
        b.numpy()

    found = happened(work)
    assert [x.kernel for x in found] == ["(memset)", "(copy)", "(copy to host)", "(wait)"]
    assert [(x.bytes_read, x.bytes_written) for x in found] == [(0, 4000), (4000, 4000), (4000, 0), (0, 0)]
    assert found[1].memory_reads == 0  # filled just before: the L2 has it


def test_a_sort_is_its_passes(happened):
    keys, values = (wp.zeros(2000, dtype=kind, device="cuda:0") for kind in (wp.int64, wp.int32))
    found = happened(lambda: wp.utils.radix_sort_pairs(keys, values, 1000))
    sort = next(x for x in found if x.kernel == "(radix sort)")
    assert sort.bytes_written == 8 * 1000 * 12  # 64 bits, 8 at a time
    assert sort.bytes_read == 8 * 1000 * 12 + 8 * 1000  # and once for the histograms


def test_what_a_graph_does_is_known_from_what_the_host_launches(happened):
    a, b = (wp.zeros(1000, dtype=wp.float32, device="cuda:0") for _ in range(2))

    def work() -> None:
        with wp.ScopedCapture("cuda:0") as capture:
            for _ in range(3):
                wp.copy(b, a)
        wp.capture_launch(capture.graph)

    found = [x for x in happened(work) if x.kernel != "(wait)"]
    assert [x.kernel for x in found] == ["(graph made)", "(graph launch)", "(copy)", "(copy)", "(copy)"]
    assert [x.in_graph for x in found] == [False, False, True, True, True]
    assert found[0].nodes == 3


# ------------------------------------------------------------------------------------------------ loops, own data


def turned(body: str, turns: int, register: int = 5) -> str:
    """A loop around a body."""
    return f"""
    mov.u32 %r{register}, 0;
LOOP{register}:
{body}
    add.s32 %r{register}, %r{register}, 1;
    setp.lt.s32 %p1, %r{register}, {turns};
    @%p1 bra LOOP{register};"""


def test_instructions_are_counted_by_the_loops_that_they_are_in(count):
    inner = turned("    add.s32 %r7, %r7, %r1;", 4, register=6)
    found = count(turned(inner, 3))
    plain, once, twice = found.issued_by_depth
    assert sum(found.issued_by_depth) == pytest.approx(found.units["issued"])
    alone = count(turned("    add.s32 %r7, %r7, %r1;", 12, register=6))
    assert twice == alone.issued_by_depth[1]  # as often, in one loop
    assert len(alone.issued_by_depth) == 2 and plain < once < twice
    assert alone.issued_by_depth == [alone.code_by_depth[0], 12 * alone.code_by_depth[1]]


def test_a_loop_that_never_turns_is_none(count):
    assert len(count(turned("    add.s32 %r7, %r7, %r1;", 1)).issued_by_depth) == 1


def test_what_a_warp_writes_and_loads_again_is_its_own(count):
    place = """
    mul.wide.u32 %rd3, %r4, 4;
    add.s64 %rd4, %rd1, %rd3;"""
    write, read = "\n    st.global.f32 [%rd4], %f2;", "\n    ld.global.f32 %f1, [%rd4];"
    again = count(place + write + read + write)
    assert again.own_sectors == 4  # 128 bytes of a warp
    assert (again.own_loads, again.own_stores) == (4, 8)  # a load that the L1 does not have, and two stores
    kept = count(place + write + read + read)
    assert (kept.own_loads, kept.own_stores) == (4, 4)  # the second load finds it in the L1
    for body in (place + read + write, place + write + write, place + read + read):
        assert count(body).own_sectors == 0

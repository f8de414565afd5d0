"""The model of a GPU in benchmarks/gpu_machine.py: arithmetic that can be done by hand."""

from __future__ import annotations

import json
import struct
import sys
from pathlib import Path

import pytest

BENCHMARKS = str(Path(__file__).parents[1] / "benchmarks")
sys.path.append(BENCHMARKS)
import gpu_float64  # noqa: E402
import gpu_host  # noqa: E402
import gpu_machine as machine  # noqa: E402
import gpu_results  # noqa: E402
import gpu_sass  # noqa: E402
from gpu_chips import H100, H200, RTX_4090  # noqa: E402
from gpu_machine import Resources, Timeline, predict_kernel, predict_other, resident_blocks  # noqa: E402
from gpu_operations import OPERATIONS  # noqa: E402
from gpu_prediction import predict, resources_of  # noqa: E402

sys.path.remove(BENCHMARKS)

UNITS = ("issued", "alu", "sums", "fma", "fp64", "xu", "lsu")


def launch(**values: object) -> dict:
    """A launch of which nothing but what is given was counted."""
    zero = {
        **{"kernel": "k", "symbol": "k", "blocks": 132 * 100, "threads": 256, "shared_bytes": 0, "in_graph": False},
        **{"units": {}, "traffic": {}, "chain": 0.0, "hits": 0.0, "misses": 0.0, "imbalance": 1.0},
        **{"memory_reads": 0, "memory_writes": 0, "bytes_read": 0, "bytes_written": 0, "nodes": 0, "hot_atomics": 0.0},
        **{"lane_statements": 0.0, "warp_statements": 0.0},
    }
    return {**zero, **values}


@pytest.mark.parametrize(
    ("registers", "threads", "shared", "blocks"),
    [
        *[(32, 256, 0, 8), (64, 256, 0, 4), (128, 256, 0, 2), (129, 256, 0, 1), (255, 256, 0, 1)],
        *[(32, 64, 0, 32), (32, 256, 112 << 10, 2), (32, 256, 1024, 8), (255, 1024, 0, 1)],
    ],
)
def test_blocks_on_an_sm_are_bounded_by_registers_threads_and_shared_memory(registers, threads, shared, blocks):
    assert resident_blocks(Resources(registers), threads, shared) == blocks


def test_a_schedulers_instructions_are_given_out_one_a_cycle():
    found = predict_kernel(launch(units={"issued": 1000.0}), Resources())
    cycles = 100 * 8 / 4 * 1000  # blocks of an SM, warps of a block, schedulers
    assert found.limits["instructions"] == pytest.approx(cycles / H200.clock)
    assert found.seconds == pytest.approx(cycles / H200.clock / machine.EFFICIENCY)
    assert found.bound == "instructions"


def test_few_blocks_leave_most_of_the_chip_idle():
    full = predict_kernel(launch(units={"issued": 1000.0}), Resources())
    one = predict_kernel(launch(units={"issued": 1000.0}, blocks=1), Resources())
    assert one.limits["instructions"] == pytest.approx(full.limits["instructions"] / 100)  # not / 13,200
    assert one.occupancy == pytest.approx(8 / 64 / (132 * 8) * 8)


def test_sums_go_to_the_unit_that_is_less_busy():
    found = predict_kernel(launch(units={"alu": 10.0, "sums": 8.0, "fma": 4.0}), Resources())
    assert found.limits["alu"] == found.limits["fma"] > 0
    found = predict_kernel(launch(units={"alu": 1.0, "sums": 2.0, "fma": 40.0}), Resources())
    assert found.limits["fma"] == pytest.approx(found.limits["alu"] * 40 / 3)


def test_bytes_take_what_the_memory_gives():
    found = predict_kernel(launch(memory_reads=43 * 10**8), Resources())
    assert found.limits["memory"] == pytest.approx(1e-3)
    assert found.bound == "memory"


def test_warps_that_wait_alone_are_bound_by_latency():
    counts = {"misses": 100.0, "units": {"issued": 200.0}, "chain": 800.0}
    alone = predict_kernel(launch(blocks=132, **counts), Resources(255))
    assert alone.bound == "latency"
    assert alone.limits["latency"] == pytest.approx((800 + 100 * H200.l2_cycles) / H200.clock)
    # eight times the blocks on an SM that holds one at once, or eight
    crowd = predict_kernel(launch(blocks=132 * 8, **counts), Resources(255))
    beside = predict_kernel(launch(blocks=132 * 8, **counts), Resources(32))
    assert crowd.limits["latency"] == pytest.approx(8 * beside.limits["latency"])


def test_atomics_at_one_address_go_one_after_the_other():
    found = predict_kernel(launch(hot_atomics=1e6), Resources())
    assert found.limits["atomics"] == pytest.approx(1e6 / H200.clock)


def test_the_machines_instructions_scale_those_of_the_table():
    assert Resources(instructions=240, statements=200).instruction_ratio == 1.2
    assert Resources().instruction_ratio == 1.0
    unrolled = Resources(instructions=800, statements=200)
    assert unrolled.instruction_ratio == machine.MOST_RATIO  # the code is longer, it does not run more often
    assert unrolled.turns_together == 4
    waits = [predict_kernel(launch(misses=100.0), r).limits["latency"] for r in (Resources(), unrolled)]
    assert waits[0] == pytest.approx(4 * waits[1])


def test_a_host_that_is_slower_than_the_device_is_what_the_caller_waits_for():
    timeline = Timeline()
    for _ in range(10):
        timeline.add(launch(), 1e-6, 1)
    assert timeline.device == pytest.approx(10 * (1e-6 + H200.launch))
    assert timeline.call == pytest.approx(10 * H200.host_launch + 1e-6 + H200.launch)
    graph = Timeline()
    graph.add(launch(kernel="(graph launch)"), 0.0, 0)
    for _ in range(10):
        graph.add(launch(in_graph=True), 1e-6, 1)
    assert graph.call == pytest.approx(H200.host_graph + 10 * (1e-6 + H200.graph_node))


def test_a_copy_to_the_host_is_a_wait():
    timeline = Timeline()
    timeline.add(launch(), 1e-3, 1)
    copy = launch(kernel="(copy to host)", bytes_read=20_000)
    timeline.add(copy, *((p := predict_other(copy))[0].seconds, p[1]))
    timeline.add(launch(), 1e-6, 1)
    timeline.add(launch(kernel="(wait)"), 0.0, 0)
    assert timeline.waits == 2
    timeline.add(launch(kernel="(wait)"), 0.0, 0)
    assert timeline.waits == 2  # nothing to wait for
    assert timeline.call > 1e-3 + H200.wait


def test_counts_come_back_from_their_file(tmp_path):
    counts = {"operation": "o", "size": 7, "host": {"launches": 1}, "launches": [launch(units={"issued": 1 / 3})]}
    file = tmp_path / "counts.json"
    gpu_results.keep(file, counts)
    gpu_results.keep(file, {**counts, "size": 8})
    gpu_results.keep(file, counts)
    assert len(json.loads(file.read_text())) == 2
    found = gpu_results.kept(file)[0]["launches"][0]
    assert found["units"]["issued"] == pytest.approx(1 / 3, rel=1e-4)
    assert found["shared_bytes"] == 0


def test_many_launches_of_a_kernel_are_kept_as_their_mean():
    many = [launch(memory_reads=k, units={"issued": float(k)}) for k in range(100)]
    many[99]["traffic"] = {"global load": {"requests": 92.0}}  # the only one that loads
    found = gpu_results.merged(many)
    assert len(found) == gpu_results.ONE_BY_ONE + 1
    assert found[-1]["times"] == 100 - gpu_results.ONE_BY_ONE
    assert sum(x["units"]["issued"] * x.get("times", 1) for x in found) == sum(range(100))
    assert found[-1]["traffic"]["global load"]["requests"] * found[-1]["times"] == 92


def test_launches_of_other_sizes_or_inside_graphs_are_not_in_a_mean():
    small, large = launch(blocks=1, in_graph=True), launch(blocks=5000)
    found = gpu_results.merged([small, large] * 300 + [launch(blocks=5000, in_graph=True)])
    assert [(x["blocks"], x["in_graph"], x.get("times", 1)) for x in found] == [
        *[(1, True, 1), (5000, False, 1), (1, True, 299), (5000, False, 299), (5000, True, 1)]
    ]


# ------------------------------------------------------------------------------------------------ spills, code, caches


def test_spilled_registers_take_turns_in_the_l1_as_often_as_the_code_around_them_runs():
    held = Resources(64, 16, 400, 400, code=[200, 200], local_loads=[10, 20], local_stores=[10, 0])
    found = predict_kernel(launch(issued_by_depth=[200.0, 2000.0], code_by_depth=[200, 200]), held)
    times = 10 + 10 + 20 * 10  # once each, and ten turns of the loop
    assert found.limits["L1"] == pytest.approx(100 * 8 * times / H200.clock)
    assert found.spilled == pytest.approx(132 * 100 * 8 * times * 128)
    assert found.limits["L2"] == 0  # 16 B of each of 1,024 threads stay in the L1
    assert predict_kernel(launch(), held).spilled == 0  # nothing is known of how often


def test_code_that_is_unrolled_has_more_spills_and_runs_less_often():
    plain = Resources(64, 16, 100, 100, code=[0, 100], local_loads=[0, 5], local_stores=[0, 0])
    unrolled = Resources(64, 16, 110, 100, code=[0, 400], local_loads=[0, 20], local_stores=[0, 0])
    counts = launch(issued_by_depth=[0.0, 1000.0], code_by_depth=[0, 100])
    one, other = (predict_kernel(counts, resources).spilled for resources in (plain, unrolled))
    assert other == pytest.approx(1.1 * one)


def test_what_runs_most_often_is_the_deepest_code_whatever_loops_the_assembler_made():
    held = Resources(statements=200, code=[100, 100], local_loads=[0, 1], local_stores=[0, 0])
    deep = predict_kernel(launch(issued_by_depth=[100.0, 300.0, 600.0], code_by_depth=[100, 40, 60]), held)
    flat = predict_kernel(launch(issued_by_depth=[100.0, 900.0], code_by_depth=[100, 100]), held)
    assert deep.spilled == pytest.approx(flat.spilled) and flat.spilled > 0
    nested = Resources(statements=200, code=[0, 100, 100], local_loads=[0, 0, 1], local_stores=[0, 0, 0])
    turned_once = predict_kernel(launch(issued_by_depth=[100.0, 900.0], code_by_depth=[100, 100]), nested)
    assert turned_once.spilled == pytest.approx(flat.spilled)
    rare = predict_kernel(launch(issued_by_depth=[100.0, 900.0], code_by_depth=[50, 50]), held)  # half never runs
    assert rare.spilled == pytest.approx(132 * 100 * 8 * 128 * (900 + 100) / 100)


def test_spills_that_the_l1_cannot_hold_go_to_the_l2():
    held = Resources(128, 1024, 100, 100, code=[100], local_loads=[10], local_stores=[10])
    found = predict_kernel(launch(issued_by_depth=[100.0], code_by_depth=[100]), held)
    resident = 2 * 8  # warps of an SM, at 128 registers
    missed = 1 - (H200.l1_bytes - machine.RESERVED_SHARED) / (1024 * 32 * resident)
    assert found.limits["L2"] == pytest.approx(132 * 100 * 8 * 20 * 128 * missed / H200.l2_bandwidth)


def test_data_that_resident_warps_write_and_load_again_are_lost_where_they_outgrow_the_l2():
    counts = {"own_sectors": 500.0, "own_loads": 2000.0, "own_stores": 1000.0}
    traffic = {
        "global load": dict.fromkeys(("requests", "lanes", "bytes", "sectors", "wavefronts"), 0.0) | {"missed": 3e3}
    }
    many = predict_kernel(launch(traffic=traffic, **counts), Resources(32))
    footprint = 132 * 64 * 500 * 32  # bytes of 64 warps an SM
    assert footprint > H200.l2_bytes
    lost = (1 - H200.l2_bytes / footprint) * 132 * 100 * 8 * 3000 * 32
    assert many.lost == pytest.approx(lost)
    assert many.limits["memory"] == pytest.approx(lost / H200.memory_bandwidth)
    few = predict_kernel(launch(traffic=traffic, blocks=100, **counts), Resources(32))
    assert few.lost == 0


def test_code_of_loops_beyond_the_caches_is_fetched_again():
    size = 2 * H200.code_bytes // machine.INSTRUCTION_BYTES
    counts = launch(issued_by_depth=[0.0, 10.0 * size], code_by_depth=[0, size])
    large = predict_kernel(counts, Resources(statements=size + 100, code=[100, size]))
    fetched = 0.5 * 10 * size * machine.INSTRUCTION_BYTES
    assert large.limits["code"] == pytest.approx(100 * fetched / H200.fill_bytes / H200.clock)
    less = launch(issued_by_depth=[0.0, 10.0 * size], code_by_depth=[0, size // 2])
    assert predict_kernel(less, Resources(statements=size // 2 + 100, code=[100, size // 2])).limits["code"] == 0
    once = launch(issued_by_depth=[float(size)], code_by_depth=[size])
    assert predict_kernel(once, Resources(statements=size, code=[size, 10])).limits["code"] == 0  # straight through


# ------------------------------------------------------------------------------------------------ chips, hosts, links


def test_a_desks_float64_is_slow_and_its_sms_hold_fewer_warps():
    counts = launch(units={"issued": 100.0, "fp64": 100.0})
    ours, desk = predict_kernel(counts, Resources()), predict_kernel(counts, Resources(), RTX_4090)
    ratio = desk.limits["fp64"] / ours.limits["fp64"]
    assert ratio == pytest.approx(32 * H200.clock / RTX_4090.clock * (13_200 / 128) / 100)
    assert resident_blocks(Resources(32), 256, 0, RTX_4090) == 6
    moved = predict_kernel(launch(memory_reads=10**9), Resources(), H100)
    assert moved.limits["memory"] == pytest.approx(1 / 3000)


def test_a_chips_own_cubins_are_used_where_they_are_there():
    counts = {
        "resources": {"a": vars(Resources(80)), "b": vars(Resources(40))},
        "resources_of": {"89": {"a": vars(Resources(96))}},
    }
    assert {k: r.registers for k, r in resources_of(counts, RTX_4090).items()} == {"a": 96, "b": 40}
    assert resources_of(counts, H100)["a"].registers == 80


def test_copies_into_fresh_memory_are_slower_than_into_pinned():
    def seconds(name: str, size: int) -> float:
        return predict_other(launch(kernel=name, bytes_read=size))[0].seconds

    large = 100 << 20
    assert seconds("(copy to host)", large) == pytest.approx(large / H200.link_fresh)
    assert seconds("(copy to device)", large) == pytest.approx(large / H200.link_pageable)
    assert seconds("(pinned copy to host)", large) == pytest.approx(large / H200.link_pinned)
    assert seconds("(copy to host)", 1000) == pytest.approx(1000 / H200.link_pinned)  # the driver's own memory


def test_a_pinned_copy_to_the_host_is_waited_for_by_what_waits():
    timeline = Timeline()
    timeline.add(launch(), 1e-3, 1)
    timeline.add(launch(kernel="(pinned copy to host)"), 1e-6, 1)
    assert timeline.waits == 0 and timeline.device == pytest.approx(1e-3 + H200.launch)
    timeline.add(launch(kernel="(wait)"), 0.0, 0)
    assert timeline.waits == 1


def test_the_hosts_part_is_as_long_as_it_was_measured():
    counts = {"host": {"allocations": 3}, "resources": {"k": {}}, "launches": [launch(units={"issued": 1.0})] * 4}
    free = predict(counts).timeline
    assert free.host_clock == pytest.approx(3 * H200.host_allocation + 4 * H200.host_launch)
    told = predict(counts, H200, 2e-3).timeline
    assert told.host_clock == pytest.approx(2e-3)
    assert told.call > 2e-3 > free.call and told.device == free.device


# ------------------------------------------------------------------------------------------------ machine code


def instruction(kind: int, distance: int = 0, size: int = 4, architecture: int = 90, predicate: int = 7) -> bytes:
    """An instruction of which nothing is said but this; distances in instructions, from its end."""
    low, bytes_away = predicate << 12 | kind, 16 * distance
    if architecture < 90:
        low |= (bytes_away & 0xFFFFFFFF) << 32
    else:
        low |= (bytes_away // 4 & 0xFF) << 16 | (bytes_away // 4 >> 8 & 0x3FFFFFFF) << 34
    return struct.pack("<QQ", low, size << 9)


@pytest.mark.parametrize("architecture", [89, 90])
def test_spills_are_found_by_the_loops_that_hold_them(architecture):
    def branch(distance: int, predicate: int = 0) -> bytes:
        return instruction(gpu_sass.BRANCH, distance, architecture=architecture, predicate=predicate)

    load, store, other = (instruction(kind) for kind in (gpu_sass.LOAD_LOCAL, gpu_sass.STORE_LOCAL, 0x223))
    inner = other + load + branch(-3)
    four = instruction(gpu_sass.LOAD_LOCAL, size=6)
    text = store + other * 300 + inner + four + branch(-305) + instruction(0x94D)
    found = gpu_sass.read_code(text, architecture)
    assert found.code == [2, 302, 3]  # the store and the exit; a loop in a loop
    assert found.local_loads == [0, 4, 1] and found.local_stores == [1, 0, 0]
    # a rare way that stands behind the exit, and leads back to where it left
    rare = other + branch(4) + other * 3 + instruction(0x94D) + load + branch(-6, predicate=7)
    assert gpu_sass.read_code(rare, architecture).code == [8]


# ------------------------------------------------------------------------------------------------ hosts


def host_row(operation: str, **counts: int) -> dict:
    """A call whose host takes 20 us a launch, 40 an array, 30 a wait and 500 a graph, the driver's part within."""
    costs = {"launches": 20, "allocations": 40, "waits": 30, "copies to host": 0, "copies to device": 0, "graphs": 0}
    given = dict.fromkeys(costs, 0) | {"graphs made": 0} | counts
    inside = given["launches"] if given["graphs made"] else 0  # recorded, not launched
    us = sum(cost * given[name] for name, cost in costs.items()) - 20 * inside + 500 * given["graphs made"]
    driver = 1e6 * gpu_host.DRIVER * sum(given[name] for name in gpu_host.GIVEN)
    return {"operation": operation, "host_ms": (us - driver) / 1e3, **given}


def test_costs_of_the_host_come_from_what_calls_took():
    rows = [
        *(
            host_row("a", launches=n, allocations=m, waits=k)
            for n, m, k in ((1, 1, 0), (5, 2, 1), (9, 7, 0), (3, 0, 4))
        ),
        *(host_row("b", launches=80, allocations=m, graphs=1, **{"graphs made": 1}) for m in (3, 8)),
    ]
    found = gpu_host.costs(rows)
    assert found == pytest.approx(
        {"host_launch": 20e-6, "host_allocation": 40e-6, "wait": 30e-6, "graph_made": 500e-6, "graph_made_node": 0.0}
    )
    assert gpu_host.costs([]) == {} and gpu_host.costs(rows[:3]) == {}


def test_operations_whose_host_was_measured_take_its_seconds():
    rows = [host_row("rgbd frame", launches=5), host_row("rgbd alignment", launches=2), host_row("fpfh", launches=7)]
    found = gpu_host.measured_hosts(rows)
    assert found == pytest.approx({"rgbd_frame": 140e-6, "fpfh": 140e-6})
    assert set(gpu_host.NAMES) <= set(OPERATIONS)


def test_float64_keeps_a_desks_units_busy_for_sixteen_cycles_an_instruction():
    one = launch(blocks=128 * 100, threads=64, units={"fp64": 2.0})  # an instruction a warp, two warps a block
    assert gpu_float64.seconds(RTX_4090, one) == pytest.approx(100 * 2 * 16 / 2.52e9)
    few = launch(blocks=1, threads=32, units={"fp64": 20.0})
    assert gpu_float64.seconds(RTX_4090, few) == pytest.approx(10 * 16 / 2.52e9)
    assert gpu_float64.seconds(H200, few) == pytest.approx(10 * 0.5 / H200.clock)
    several = {"launches": [one, {**few, "times": 5}, launch(units={"alu": 9.0})]}
    millions, *seconds = gpu_float64.kernels_of(several)["k"]
    assert millions == pytest.approx((128 * 100 * 2 + 5 * 10) / 1e6)
    assert seconds[1] == pytest.approx((200 + 50) * 16 / 2.52e9)

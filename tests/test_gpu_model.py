"""The model of a GPU in benchmarks/gpu_machine.py: arithmetic that can be done by hand."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

BENCHMARKS = str(Path(__file__).parents[1] / "benchmarks")
sys.path.append(BENCHMARKS)
import gpu_float64  # noqa: E402
import gpu_machine as machine  # noqa: E402
import gpu_results  # noqa: E402
from gpu_machine import Resources, Timeline, predict_kernel, predict_other, resident_blocks  # noqa: E402

sys.path.remove(BENCHMARKS)

UNITS = ("issued", "alu", "sums", "fma", "fp64", "xu", "lsu")


def launch(**values: object) -> dict:
    """A launch of which nothing but what is given was counted."""
    zero = {
        **{"kernel": "k", "symbol": "k", "blocks": 132 * 100, "threads": 256, "shared_bytes": 0, "in_graph": False},
        **{"units": {}, "traffic": {}, "chain": 0.0, "hits": 0.0, "misses": 0.0, "imbalance": 1.0},
        **{"memory_reads": 0, "memory_writes": 0, "bytes_read": 0, "bytes_written": 0, "nodes": 0, "hot_atomics": 0.0},
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
    assert found.limits["instructions"] == pytest.approx(cycles / machine.CLOCK)
    assert found.seconds == pytest.approx(cycles / machine.CLOCK / machine.EFFICIENCY)
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
    assert alone.limits["latency"] == pytest.approx((800 + 100 * machine.L2_CYCLES) / machine.CLOCK)
    # eight times the blocks on an SM that holds one at once, or eight
    crowd = predict_kernel(launch(blocks=132 * 8, **counts), Resources(255))
    beside = predict_kernel(launch(blocks=132 * 8, **counts), Resources(32))
    assert crowd.limits["latency"] == pytest.approx(8 * beside.limits["latency"])


def test_atomics_at_one_address_go_one_after_the_other():
    found = predict_kernel(launch(hot_atomics=1e6), Resources())
    assert found.limits["atomics"] == pytest.approx(1e6 / machine.CLOCK)


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
    assert timeline.device == pytest.approx(10 * (1e-6 + machine.LAUNCH))
    assert timeline.call == pytest.approx(10 * machine.HOST_LAUNCH + 1e-6 + machine.LAUNCH)
    graph = Timeline()
    graph.add(launch(kernel="(graph launch)"), 0.0, 0)
    for _ in range(10):
        graph.add(launch(in_graph=True), 1e-6, 1)
    assert graph.call == pytest.approx(machine.HOST_GRAPH + 10 * (1e-6 + machine.GRAPH_NODE))


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
    assert timeline.call > 1e-3 + machine.WAIT


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


def test_float64_keeps_a_desks_units_busy_for_sixteen_cycles_an_instruction():
    one = launch(blocks=128 * 100, threads=64, units={"fp64": 2.0})  # an instruction a warp, two warps a block
    assert gpu_float64.RTX_4090.seconds(one) == pytest.approx(100 * 2 * 16 / 2.52e9)
    few = launch(blocks=1, threads=32, units={"fp64": 20.0})
    assert gpu_float64.RTX_4090.seconds(few) == pytest.approx(10 * 16 / 2.52e9)
    assert gpu_float64.H200.seconds(few) == pytest.approx(10 * 0.5 / machine.CLOCK)
    several = {"launches": [one, {**few, "times": 5}, launch(units={"alu": 9.0})]}
    millions, *seconds = gpu_float64.kernels_of(several)["k"]
    assert millions == pytest.approx((128 * 100 * 2 + 5 * 10) / 1e6)
    assert seconds[1] == pytest.approx((200 + 50) * 16 / 2.52e9)

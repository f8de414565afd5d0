"""How long a job of tiles takes on many machines: a simulation, held against runs that were measured.

    python benchmarks/scale_out.py --check            # the model of the smallest run against the larger ones
    python benchmarks/scale_out.py --points 1e12 --machines 32 --workers 64 --storage 5

Each worker claims one task after the other: files to be laid by tile, then, once all are laid, tiles. A task takes its
CPU time, two transactions in the manifest, which has one at a time, and its share of the storage, which serves all
bytes one after the other; per million points as `benchmarks/results/tiles-cpu.json` has them measured. A job is one
manifest; a survey is divided into jobs by `only=`, as many of them at once as have machines. Workers that die, at
random, lose their task.
"""

from __future__ import annotations

import argparse
import heapq
import json
import math
import random
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

RESULTS = Path(__file__).parent / "results" / "tiles-cpu.json"
DENSITY = 10.0  # points a square metre
FILE_POINTS = 10_000_000
TILE_POINTS = 2_000_000
LARGEST_JOB = 5_000_000_000  # points: what one manifest is given here
HOUR = 3600.0


@dataclass(frozen=True)
class Costs:
    """What tasks take, of one worker on one core.

    Attributes:
        start: Of a worker, until its first task [s].
        lay: Of a point that is laid by tile [s].
        read: Of each point that a tile reads, its own and those of its halo [s].
        finish: Of a point of the result, in one process [s].
        transaction: Of the manifest [s].
        left: Points of the result a point.
        file_bytes: A point in the files.
        laid_bytes: A point that is laid by tile.
        out_bytes: A point of the result, in the tiles' files.
        halo: Beside a tile [m].
    """

    start: float
    lay: float
    read: float
    finish: float
    transaction: float
    left: float
    file_bytes: float
    laid_bytes: float
    out_bytes: float
    halo: float


@dataclass(frozen=True)
class Place:
    """Where a job runs.

    Attributes:
        workers: At one manifest.
        storage: Bytes a second for all of them.
        lifetime: After which a worker dies, in the mean [s].
    """

    workers: int
    storage: float = math.inf
    lifetime: float = math.inf


@dataclass(frozen=True)
class Outcome:
    """What a simulated job took."""

    seconds: float
    cpu_seconds: float
    tiles: int
    deaths: int
    storage_busy: float
    manifest_busy: float
    finish: float


def tile_reads(points: float, costs: Costs) -> list[float]:
    """Points that each tile of a square survey reads: its own, and those of the halo inside the survey."""
    side = math.sqrt(points / DENSITY)
    along = math.ceil(side / math.sqrt(TILE_POINTS / DENSITY))
    edge = side / along
    spans = [min(side, (k + 1) * edge + costs.halo) - max(0.0, k * edge - costs.halo) for k in range(along)]
    return [DENSITY * width * height for height in spans for width in spans]


def simulate(points: float, costs: Costs, place: Place, seed: int = 0) -> Outcome:
    """One job, from the first worker's start to the file of all tiles."""
    reads, chance = tile_reads(points, costs), random.Random(seed)
    files = max(1, round(points / FILE_POINTS))
    share = points / files
    laying = [(costs.lay * share, (costs.file_bytes + costs.laid_bytes) * share)] * files
    own = points / len(reads)
    written = own * costs.left * costs.out_bytes
    tiling = [(costs.read * read, costs.laid_bytes * read + written) for read in reads]
    state = _State(costs, place, chance)
    state.work(laying)
    state.work(tiling)
    finish = points * costs.left * costs.finish
    return Outcome(state.end + finish, state.cpu + finish, len(reads), state.deaths, state.stored, state.told, finish)


class _State:
    """The clocks of workers, manifest and storage."""

    def __init__(self, costs: Costs, place: Place, chance: random.Random):
        self.costs, self.place, self.chance = costs, place, chance
        self.end = costs.start
        self.manifest = self.storage = 0.0
        self.cpu, self.stored, self.told, self.deaths = costs.start * place.workers, 0.0, 0.0, 0

    def work(self, tasks: list[tuple[float, float]]) -> None:
        """Work tasks of (CPU seconds, bytes) off; all begin when those before are over."""
        costs, place = self.costs, self.place
        waiting = [*reversed(tasks)]
        # (time, worker, the task that it has done, or None where it looks for one): served in the order of time
        begin = max(self.end, costs.start)
        events: list[tuple[float, int, tuple[float, float] | None]] = [(begin, k, None) for k in range(place.workers)]
        heapq.heapify(events)
        while events:
            time, worker, done = heapq.heappop(events)
            if done is not None:
                time = self._transact(time)
                self.end = max(self.end, time)
                heapq.heappush(events, (time, worker, None))
                continue
            if not waiting:
                continue
            cpu, size = waiting.pop()
            time = self._transact(time)
            self.storage = max(self.storage, time) + size / place.storage
            self.stored += size / place.storage
            over = max(time + cpu, self.storage)  # read and written while it computes
            death = time + self.chance.expovariate(1 / place.lifetime) if place.lifetime < math.inf else math.inf
            if death < over:
                self.deaths += 1
                self.cpu += min(cpu, death - time)
                waiting.append((cpu, size))
                heapq.heappush(events, (death + costs.start, worker, None))
            else:
                self.cpu += cpu
                heapq.heappush(events, (over, worker, (cpu, size)))

    def _transact(self, time: float) -> float:
        self.manifest = max(self.manifest, time) + self.costs.transaction
        self.told += self.costs.transaction
        return self.manifest


def costs_of(run: dict[str, Any], **changed: float) -> Costs:
    """What a measured run says of costs: two workers that had a core each."""
    points, out = run["points"], run["points_out"]
    read = run["tile_cpu_s"] / run["points_read"]
    told = Costs(
        start=run["start_s"],
        lay=run["lay_cpu_s"] / points,
        read=read,
        finish=run["finish_s"] / out,
        transaction=run["transaction_s"],
        left=out / points,
        file_bytes=run["file_bytes"] / points,
        laid_bytes=run["laid_bytes"] / points,
        out_bytes=run["tile_bytes"] / out,
        halo=run["halo_m"],
    )
    return replace(told, **changed)


def checks(runs: list[dict[str, Any]]) -> Iterator[str]:
    """Each run beside what the smallest one's costs say of it."""
    first = min(runs, key=lambda run: run["points"])
    costs = costs_of(first)
    yield f"costs of {first['points']:,} points: " + ", ".join(f"{k} {v:.3g}" for k, v in vars(costs).items())
    for run in sorted(runs, key=lambda run: run["points"]):
        told = simulate(run["points"], costs, Place(run["workers"]))
        cpu = run["lay_cpu_s"] + run["tile_cpu_s"] + run["finish_s"]
        wall = f"{told.seconds:,.0f} s for {run['run_s'] + run['finish_s']:,.0f} s" if run["idle"] else "was not idle"
        yield (
            f"{run['points']:13,} points  tiles {told.tiles:,} for {run['tiles']:,}"
            f"  CPU {told.cpu_seconds:,.0f} s for {cpu:,.0f} s = {told.cpu_seconds / cpu:.2f}  time {wall}"
        )


def planned(points: float, costs: Costs, machines: int, place: Place) -> Iterator[str]:
    """A survey of any size on machines of so many workers, divided into jobs."""
    jobs = max(1, math.ceil(points / LARGEST_JOB))
    at_once = min(jobs, machines)
    together = replace(place, workers=place.workers * machines // at_once, storage=place.storage / at_once)
    one = simulate(points / jobs, costs, together)
    rounds = math.ceil(jobs / at_once)
    seconds = one.seconds * rounds
    busy = one.cpu_seconds / one.seconds / together.workers
    laid, out = points * costs.laid_bytes / 1e12, points * costs.left * costs.out_bytes / 1e12
    finish = one.finish * rounds / HOUR
    yield f"{points:,.0f} points = {points / DENSITY / 1e6:,.0f} km^2 at {DENSITY:g} a square metre"
    yield f"jobs         {jobs:,} of {one.tiles:,} tiles, {at_once:,} at once, {together.workers:,} workers each"
    yield f"time         {seconds / HOUR:,.1f} h, of which {finish:,.1f} h make the jobs' files"
    yield f"CPU time     {one.cpu_seconds * jobs / HOUR:,.0f} h; workers are busy {busy:.0%}"
    yield f"storage      busy {one.storage_busy / one.seconds:.0%}; the manifest {one.manifest_busy / one.seconds:.1%}"
    yield f"deaths       {one.deaths * jobs:,}"
    yield f"disk [TB]    {points * costs.file_bytes / 1e12:,.2f} in, {laid:,.2f} laid by tile, {out:,.2f} out;"
    yield f"             {at_once / jobs * (laid + out):,.2f} beside the input at once"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="hold the model against the runs that were measured")
    parser.add_argument("--points", type=float, default=1e12)
    parser.add_argument("--machines", type=int, default=32)
    parser.add_argument("--workers", type=int, default=64, help="of a machine (64)")
    parser.add_argument("--storage", type=float, default=5.0, help="GB/s for all machines (5)")
    parser.add_argument("--lifetime", type=float, default=1000.0, help="hours after which a worker dies (1000)")
    parser.add_argument(
        "--transaction", type=float, help="of a manifest that machines share [s]; as measured if not given"
    )
    told = parser.parse_args()
    runs = json.loads(RESULTS.read_text())["runs"]
    if told.check:
        print(*checks(runs), sep="\n")
        return
    costs = costs_of(min(runs, key=lambda run: run["points"]))
    if told.transaction is not None:
        costs = replace(costs, transaction=told.transaction)
    place = Place(told.workers, told.storage * 1e9, told.lifetime * HOUR)
    print(*planned(told.points, costs, told.machines, place), sep="\n")


if __name__ == "__main__":
    main()

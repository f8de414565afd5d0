"""Host work of operations on the emulated device, and its limits: launches, waits, allocations and bytes.

    python tests/emulated_cuda/host_calls.py [--only REGEX] [--sites] [--write]

The operations are those of docs/gpu.md (benchmarks/gpu_operations.py, at the size of a dry run), and the ones with most
launches among benchmarks/digests.py. Each has a row in host_calls.json, and may exceed each count of it by a tenth,
rounded up: by one at small counts, not at zero. `--write` writes the rows that exceed a limit, or could have a lower
one by more than this. `--sites` lists the lines with the most transfers to the host.
"""

import argparse
import contextlib
import functools
import json
import os
import re
import sys
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).resolve().parent


def parse_options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", default="", metavar="REGEX", help="operations whose names have this")
    parser.add_argument("--sites", action="store_true", help="the lines that transfer most to the host")
    parser.add_argument("--write", action="store_true", help="write the rows whose counts changed by over a tenth")
    return parser.parse_args()


if __name__ == "__main__":
    given = parse_options()
    os.environ.setdefault("POINTLOOM_VERBOSITY", "warning")
    sys.path.insert(0, str(FOLDER.parents[1]))
    from tests.emulated_cuda.install import install

    install()

import warp as wp  # noqa: E402  after the device

from pointloom.kernels.language import device_arrays  # noqa: E402
from tests.emulated_cuda.allocations import Allocations  # noqa: E402
from tests.emulated_cuda.install import installed  # noqa: E402
from tests.small_scenes import BENCHMARKS, COUNT, ON_CLOUDS, ONCE, SmallScenes, digest_scenes  # noqa: E402

TABLE, CUDA = FOLDER / "host_calls.json", "cuda:0"
MAX_RUNS = 3  # of an operation: the first fills caches
COLUMNS = {  # of the table: what the device counts
    "launches": "launches asked for",
    "waits": "waits",
    "allocations": "allocations",
    "uploaded": "bytes to device",
    "downloaded": "bytes to host",
}
NO_ROW = ("normals_scan", "poisson_depth_9")  # a file of POINTLOOM_DATA; the same code as poisson_depth_7
Counts = dict[str, int]
Work = Callable[[], Any]


class CountedScenes(SmallScenes):
    """Small scenes whose clouds return Warp arrays, so downloads are results or internal transfers."""

    def __init__(self) -> None:
        super().__init__(CUDA)
        self._surfaces: dict[int, digest_scenes.SampledSurface] = {}

    def cloud(self, points: Any, **attributes: Any) -> Any:
        return super().cloud(points, **attributes).to(CUDA, arrays="warp")

    @property
    def surface(self) -> digest_scenes.SampledSurface:
        return self.surfaces(COUNT)

    def surfaces(self, count: int) -> digest_scenes.SampledSurface:
        if count not in self._surfaces:
            made = self._surfaces[count] = self.sample(count, 10)
            _ = made.facing, made.source  # inputs of some operations
        return self._surfaces[count]


@contextlib.contextmanager
def conditions() -> Iterator[None]:
    """The conditions of all counts: frames are on the device, small arrays are in blocks, benchmarks are importable."""
    plain, blocks = digest_scenes.textured, device_arrays.blocks
    device_arrays.blocks = device_arrays.BLOCKS
    digest_scenes.textured = lambda *arguments: plain(*arguments).to(CUDA, arrays="warp")
    sys.path.append(BENCHMARKS)
    try:
        yield
    finally:
        sys.path.remove(BENCHMARKS)
        digest_scenes.textured, device_arrays.blocks = plain, blocks


def operations(scenes: CountedScenes) -> dict[str, Callable[[], Work]]:
    """The operations of the table: a function that makes the input of a call, and returns the call."""
    from gpu_operations import OPERATIONS

    timed = [o for o in OPERATIONS.values() if o.name not in NO_ROW and not o.name.endswith("_device")]
    return {
        **{o.name: functools.partial(o.prepare, o.small) for o in timed},
        **{n: lambda r=r: functools.partial(r, scenes) for n, r in ONCE.items() if r.counts_host_work},
        **{n: lambda r=r: functools.partial(r, scenes.surface) for n, r in ON_CLOUDS.items() if r.counts_host_work},
    }


def count_on_device(work: Work) -> Counts:
    """The counts of a call."""
    device = installed()
    assert device is not None
    with bytes_in_blocks() as in_blocks:
        before = device.memory.total
        requests = device.count_requests(work)
        allocated = device.memory.total - before + in_blocks[0]
    counts = {column: requests[name] for column, name in COLUMNS.items()} | {"allocated": allocated}
    return counts | {"waits": max(counts["waits"], requests["copies to host"])}  # Warp's own copies are no waits here


@contextlib.contextmanager
def bytes_in_blocks() -> Iterator[list[int]]:
    """The bytes of arrays in blocks, less those of the blocks. New ones: counts do not depend on earlier calls."""
    place, block, count = device_arrays._place_for, device_arrays.Block, [0]

    def counted_place(device: Any, stream: Any, size: int) -> Any:
        found = place(device, stream, size)
        count[0] += 0 if found is None else size
        return found

    def counted_block(device: Any, size: int) -> Any:
        count[0] -= size
        return block(device, size)

    device_arrays.drop_blocks(wp.get_device("cuda:0"))
    device_arrays._place_for, device_arrays.Block = counted_place, counted_block
    try:
        yield count
    finally:
        device_arrays._place_for, device_arrays.Block = place, block


class Sites:
    """Which lines copies to the host come from; made before the first of them."""

    def __init__(self) -> None:
        self.copies: dict[str, list[int]] = {}
        plain = Allocations.wp_memcpy_d2h

        def copy(device: Any, context: Any, to: Any, source: Any, size: int, *rest: Any) -> Any:
            entry = self.copies.setdefault(_line(), [0, 0])
            entry[:] = entry[0] + 1, entry[1] + size
            return plain(device, context, to, source, size, *rest)

        Allocations.wp_memcpy_d2h = copy  # type: ignore[method-assign]

    def print_largest(self) -> None:
        for site, (count, size) in sorted(self.copies.items(), key=lambda item: -item[1][1])[:9]:
            print(f"    {count:4} times, {size:9} B: {site}")


def _line() -> str:
    """The innermost lines of the library that are not its memory and launches."""
    frame, calls = sys._getframe(2), []
    while frame is not None and len(calls) < 2:
        name = frame.f_code.co_filename
        if "/pointloom/" in name and not re.search(r"kernels/(memory|launches)\.py|/language/", name):
            calls.append(f"{name.rsplit('/pointloom/', 1)[1]}:{frame.f_lineno}")
        frame = frame.f_back
    return " < ".join(calls)


def limit(count: int) -> int:
    """The limit of a stored count: a tenth more, rounded up."""
    return -(-11 * count // 10)


def exceeded(counts: Mapping[str, int], row: Mapping[str, int]) -> list[str]:
    """A message for each count above the limit of its row."""
    above = [column for column, n in row.items() if counts[column] > limit(n)]
    return [f"{column}: expected at most {limit(row[column]):,}, got {counts[column]:,}" for column in above]


def counted(prepare: Callable[[], Work], row: Mapping[str, int] | None = None) -> Counts:
    """The counts of the first run within the limits of a row, or of the last run."""
    for _ in range(MAX_RUNS):
        counts = count_on_device(prepare())
        if row is not None and not exceeded(counts, row):
            break
    return counts


def read_table() -> dict[str, Counts]:
    return json.loads(TABLE.read_text())


def main() -> int:
    table, sites, is_above = read_table(), Sites() if given.sites else None, False
    with conditions():
        works = operations(CountedScenes())
        rows = {name: row for name, row in table.items() if name in works}
        for name in filter(re.compile(given.only).search, works):
            if sites is not None:
                sites.copies.clear()
            counts, row = counted(works[name]), rows.get(name)
            print(f"{name:32} {' '.join(f'{column} {n}' for column, n in counts.items())}", flush=True)
            messages = [] if row is None else exceeded(counts, row)
            print("".join(f"    {message}\n" for message in messages), end="")
            is_above |= bool(messages)
            if sites is not None:
                sites.print_largest()
            if row is None or messages or exceeded(row, counts):
                rows[name] = counts
            if given.write:  # after each operation, so that a run may be interrupted
                lines = [f"{json.dumps(name)}: {json.dumps(rows[name])}" for name in works if name in rows]
                TABLE.write_text("{\n" + ",\n".join(lines) + "\n}\n")
    return int(is_above and not given.write)


if __name__ == "__main__":
    sys.exit(main())

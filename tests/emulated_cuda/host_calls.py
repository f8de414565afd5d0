"""Host work of every operation: device calls, transfers, allocations and Python calls.

    python tests/emulated_cuda/host_calls.py [--device cpu] [--only REGEX] [--sites] [--write [--why REASON]]

The default device is the emulated cuda:0. The operations are those of tests/host_work.py. Each runs until two
successive counts are equal. Counts above host_calls.json are printed. `--write` writes lower counts and new operations
to it, the limits of test_host_calls.py here and in tests/. Higher counts need a reason, `--why`, which is stored in the
row. `--sites` lists the lines with the most transfers to the host.
"""

import argparse
import contextlib
import os
import re
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

FOLDER = Path(__file__).resolve().parent


def parse_options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--device", choices=("cuda:0", "cpu"), default="cuda:0", help="cuda:0 is the emulated device")
    parser.add_argument("--only", default="", metavar="REGEX", help="operations whose names have this")
    parser.add_argument("--sites", action="store_true", help="the lines that transfer most to the host")
    parser.add_argument("--write", action="store_true", help="write lower counts and new operations")
    parser.add_argument("--why", metavar="REASON", help="with --write: write higher counts, too, for this reason")
    return parser.parse_args()


if __name__ == "__main__":
    given = parse_options()
    os.environ.setdefault("POINTLOOM_VERBOSITY", "warning")  # as in the tests: messages are calls, too
    sys.path.insert(0, str(FOLDER.parents[1]))
    if given.device != "cpu":
        from tests.emulated_cuda.install import install

        install()

import warp as wp  # noqa: E402  after the device

import pointloom as loom  # noqa: E402
from pointloom.kernels.language import device_arrays  # noqa: E402
from tests import host_work  # noqa: E402
from tests.emulated_cuda.allocations import Allocations  # noqa: E402
from tests.emulated_cuda.install import installed  # noqa: E402
from tests.host_work import Counts, Operations, PythonCalls, Row, Work  # noqa: E402
from tests.small_scenes import parts_of  # noqa: E402

COLUMNS = {  # of the table: what the device counts
    "launches": "launches asked for",
    "graphs": "graphs",
    "made": "graphs made",
    "waits": "waits",
    "allocations": "allocations",
    "up": "copies to device",
    "uploaded": "bytes to device",
    "down": "copies to host",
    "downloaded": "bytes to host",
}


def count_on_device(work: Work) -> Counts:
    """A row of the table, with the bytes downloaded beyond those of the result."""
    device, results, calls = installed(), [], PythonCalls()
    assert device is not None

    def run() -> None:
        with calls:
            results.append(work())

    with bytes_in_blocks() as in_blocks:
        before = device.memory.total
        requests = device.count_requests(run)
        allocated = device.memory.total - before + in_blocks[0]
    counts = {column: requests[name] for column, name in COLUMNS.items()} | {"allocated": allocated}
    return counts | {"beyond": max(0, counts["downloaded"] - host_bytes(results[0])), "python": calls.calls}


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


def host_bytes(result: Any) -> int:
    """Bytes of a result that the call has put on the host."""
    if isinstance(result, np.ndarray):
        return result.nbytes
    if result is None or isinstance(result, (wp.array, str, bool, int, float, np.generic, bytes)):
        return 0
    if isinstance(result, Mapping):
        return sum(map(host_bytes, result.values()))
    if isinstance(result, (list, tuple)):
        return sum(map(host_bytes, result))
    return _bytes_of_parts(result)


def _bytes_of_parts(result: Any) -> int:
    """Of an object; a part that is fetched only now is none of them."""
    if isinstance(result, loom.PointCloud):
        return 0  # Warp arrays
    device, sizes = installed(), []
    assert device is not None
    requests = device.count_requests(lambda: sizes.extend(map(host_bytes, parts_of(result).values())))
    return max(0, sum(sizes) - requests["bytes to host"])


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


def counted(works: Operations, name: str, sites: Sites | None) -> list[Counts]:
    """The counts of an operation at each size."""
    prepare, count = works.all[name], host_work.count_on_cpu if works.device == "cpu" else count_on_device

    def run(size: int) -> Counts:
        work = prepare(size)
        if sites is not None:
            sites.copies.clear()  # of earlier runs
        return count(work)

    return [host_work.settled_counts(lambda size=size: run(size)) for size in works.sizes_of(name)]


def updated(works: Operations, name: str, row: Row | None, counts: list[Counts]) -> tuple[Row, bool]:
    """The row to write, and whether a count rose without a reason. Prints each rise."""
    if row is None:
        return host_work.row_of(counts), False
    rises = host_work.rises(name, works.device, works.sizes_of(name), row, counts)
    for message in rises:
        print(f"    RISE {message}")
    return host_work.merged(row, counts, given.why if rises else None), bool(rises) and not given.why


def main() -> int:
    works, sites = Operations(given.device), Sites() if given.sites else None
    table = host_work.read_table()
    known = table.get(given.device, {})
    table[given.device] = rows = {name: row for name, row in known.items() if name in works.all}
    failed = rose = 0
    with host_work.conditions(given.device):
        for name in works.all:
            if not re.search(given.only, name):
                continue
            try:
                counts = counted(works, name, sites)
            except Exception as error:
                failed += 1
                print(f"{name:62} {type(error).__name__}: {error}", flush=True)
                continue
            row = host_work.row_of(counts)
            print(f"{name:62} {' '.join(f'{column} {n}' for column, n in row.items())}", flush=True)
            if sites is not None:
                sites.print_largest()
            rows[name], is_higher = updated(works, name, known.get(name), counts)
            rose += is_higher
            if given.write:  # after each operation, so that a run may be interrupted
                host_work.write_table(table)
    if rose:
        print(f"{rose} operations do more host work than {host_work.TABLE.name} allows. The limits of these counts")
        print("were not changed. Reduce the work, or state its reason: --write --why REASON.")
    return int(failed > 0 or rose > 0)


if __name__ == "__main__":
    sys.exit(main())

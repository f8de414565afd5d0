"""Device calls and transfers of every operation, on the emulated device.

    python tests/emulated_cuda/host_calls.py [--only REGEX] [--sites] [--write]

The operations are those of benchmarks/digests.py, on small scenes; clouds return Warp arrays, so downloads
are either results returned as NumPy or internal transfers of the library. Each runs once to warm up, and once to be
counted. `--write` writes host_calls.json, the limits of test_host_calls.py; `--sites` lists the lines with the most
transfers.
"""

import argparse
import json
import re
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

FOLDER = Path(__file__).resolve().parent
if __name__ == "__main__":
    sys.path.insert(0, str(FOLDER.parents[1]))
    from tests.emulated_cuda.install import install

    install()

import warp as wp  # noqa: E402  after the device

import pointloom as loom  # noqa: E402
from tests.emulated_cuda.allocations import Allocations  # noqa: E402
from tests.emulated_cuda.install import installed  # noqa: E402
from tests.small_scenes import COUNT, ON_CLOUDS, ON_HOST, ONCE, SmallScenes, digest_scenes, parts_of  # noqa: E402

TABLE = FOLDER / "host_calls.json"
DEVICE = "cuda:0"
COLUMNS = {  # of the table: what the device counts
    "launches": "launches asked for",
    "graphs": "graphs",
    "made": "graphs made",
    "waits": "waits",
    "down": "copies to host",
    "up": "copies to device",
    "bytes": "bytes to host",
}
FILES = (
    *("file ", "write and read", "read_las_chunks", "tsdf, save and load", "distance field, save", "occupancy, save"),
    *("mesh, write", "pose graph, write and read"),
)
_textured = digest_scenes.textured


class DeviceScenes(SmallScenes):
    """Small scenes whose clouds live on the device and answer in Warp arrays."""

    def __init__(self, count: int = COUNT) -> None:
        super().__init__(DEVICE)
        self.count = count

    def cloud(self, points: Any, **attributes: Any) -> Any:
        return super().cloud(points, **attributes).to(DEVICE, arrays="warp")

    @property
    def surface(self) -> Any:
        return self.surfaces(self.count)

    def surfaces(self, count: int) -> Any:
        if count not in (made := self.__dict__.setdefault("_surfaces", {})):
            made[count] = self.sample(count, 10)
        return made[count]


def operations(scenes: DeviceScenes) -> dict[str, Callable[[], Any]]:
    works: dict[str, Callable[[], Any]] = {
        name: lambda on_cloud=on_cloud: on_cloud(scenes.surface) for name, on_cloud in ON_CLOUDS.items()
    }
    works |= {name: lambda once=once: once(scenes) for name, once in ONCE.items() if not name.endswith("far")}
    return {name: work for name, work in works.items() if not name.startswith((*ON_HOST, *FILES, "ransac, checkers"))}


@contextmanager
def device_clouds() -> Iterator[None]:
    digest_scenes.textured = lambda *given: _textured(*given).to(DEVICE, arrays="warp")
    try:
        yield
    finally:
        digest_scenes.textured = _textured


def counted(work: Callable[[], Any]) -> tuple[Any, dict[str, int]]:
    device, results = installed(), []
    assert device is not None
    counts = device.count_requests(lambda: results.append(work()))
    return results[0], counts


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
    sizes: list[int] = []
    _, counts = counted(lambda: sizes.extend(map(host_bytes, parts_of(result).values())))
    return max(0, sum(sizes) - counts["bytes to host"])


def measured(work: Callable[[], Any], *, warm: bool = False) -> dict[str, int]:
    """A row of the table: a warm call's numbers, and the bytes that it took beyond those of its result."""
    if not warm:
        work()
    result, counts = counted(work)
    row = {column: counts[name] for column, name in COLUMNS.items()}
    return row | {"beyond": max(0, row["bytes"] - host_bytes(result))}


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


def _line() -> str:
    """The innermost lines of the library that are not its memory and launches."""
    frame, calls = sys._getframe(2), []
    while frame is not None and len(calls) < 2:
        name = frame.f_code.co_filename
        if "/pointloom/" in name and not re.search(r"kernels/(memory|launches)\.py|/language/", name):
            calls.append(f"{name.rsplit('/pointloom/', 1)[1]}:{frame.f_lineno}")
        frame = frame.f_back
    return " < ".join(calls)


def main() -> int:
    given, sites = parse_options(), Sites()
    rows, failed = {}, 0
    with device_clouds():
        for name, work in operations(DeviceScenes(given.count)).items():
            if not re.search(given.only, name):
                continue
            try:
                work()
                sites.copies.clear()
                rows[name] = measured(work, warm=True)
            except Exception as error:
                failed += 1
                print(f"{name:62} {type(error).__name__}: {error}", flush=True)
                continue
            print(f"{name:62} {' '.join(f'{column} {n:6}' for column, n in rows[name].items())}", flush=True)
            if given.sites:
                for site, (count, size) in sorted(sites.copies.items(), key=lambda item: -item[1][1])[:9]:
                    print(f"    {count:4} times, {size:9} B: {site}")
    if given.write and not failed:
        known = json.loads(TABLE.read_text()) if TABLE.exists() else {}
        remaining = {name: row for name, row in known.items() if not re.search(given.only, name)}
        lines = [f"  {json.dumps(name)}: {json.dumps(row)}" for name, row in sorted((remaining | rows).items())]
        TABLE.write_text("{\n" + ",\n".join(lines) + "\n}\n")
    return int(failed > 0)


def parse_options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", default="", metavar="REGEX", help="operations whose names have this")
    parser.add_argument("--count", type=int, default=COUNT, help="points of the clouds")
    parser.add_argument("--sites", action="store_true", help="the lines that take most to the host")
    parser.add_argument("--write", action="store_true", help=f"write {TABLE.name}")
    return parser.parse_args()


if __name__ == "__main__":
    sys.exit(main())

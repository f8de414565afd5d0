"""Detect changed results: print a digest of the result of every operation, most of them on several small clouds.

    python benchmarks/digests.py [--compiler taichi|warp] [--device cpu] [--only PREFIX] > before.txt
    python benchmarks/digests.py [the same options] --against before.txt

Run this before and after a change that must not change results. A line contains an operation, the cloud in
brackets, and
the first 16 hex digits of the SHA-256 of the result: arrays with element type, shape and all bytes, and the public
parts
of objects; texts are ignored. On clouds of at most five points ([tiny]) an error is a result too, by its type. With
`--against` only differing lines are printed: before, now. The exit code is 1 if a line differs or an operation fails.

The inputs of some operations are results of others: normals, features and matches. If many lines differ, the first one
is the most informative.

The script calls public names only, so it runs before and after a refactoring. Compare runs of one compiler, device and
machine; `POINTLOOM_DATA` adds a real LiDAR scan to both or to neither.
"""

from __future__ import annotations

import argparse
import contextlib
import dataclasses
import hashlib
import os
import re
import sys
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER))

import numpy as np  # noqa: E402
import scenes  # noqa: E402
from digest_scenes import SampledSurface, Scenes, loom  # noqa: E402
from numpy.typing import NDArray  # noqa: E402
from operations_on_clouds import ON_CLOUDS  # noqa: E402
from operations_on_scenes import ONCE  # noqa: E402
from real_data import DataMissingError  # noqa: E402

DIGITS = 16

# Public parts of the results that are neither arrays, nor tuples, nor dataclasses.
PARTS = {
    "AxisAlignedBoundingBox": ("min_bound", "max_bound", "color"),
    "OrientedBoundingBox": ("center", "R", "extent", "color"),
    "PoseGraph": ("nodes", "edges", "report"),
    "RGBDImage": ("color", "depth"),
    "RayCast": ("colors", "depth", "normals", "points"),
    "RegistrationResult": (
        "transformation", "fitness", "inlier_rmse", "iterations", "converged", "degenerate_directions",
        "correspondence_set", "score",
    ),
    "TriangleMesh": ("origin", "vertices", "triangles", "vertex_normals", "vertex_colors"),
    "VoxelTrace": ("cloud", "cubic_id", "voxel_of_point", "indices", "offsets"),
}  # fmt: skip


def digest(result: Any) -> str:
    """The first hex digits of the SHA-256 of a result."""
    total = hashlib.sha256()
    for piece in pieces(result):
        total.update(piece)
    return total.hexdigest()[:DIGITS]


def pieces(value: Any) -> Iterator[bytes]:
    """The bytes of a value, with separators between values of different structure."""
    if isinstance(value, str):
        return
    if value is None:
        yield b"none;"
    elif isinstance(value, (bool, int, float, np.generic, np.ndarray)):
        yield from array_pieces(np.asarray(value))
    elif isinstance(value, Mapping):
        yield from named_pieces({name: value[name] for name in sorted(value)})
    elif isinstance(value, (list, tuple)):
        yield f"{len(value)} items;".encode()
        for item in value:
            yield from pieces(item)
    else:
        yield from named_pieces(parts_of(value))


def array_pieces(array: NDArray[Any]) -> Iterator[bytes]:
    if array.dtype.hasobject:
        raise TypeError(f"an array of {array.dtype} has no bytes of its own")
    yield f"{array.dtype.str} {array.shape};".encode()
    yield np.ascontiguousarray(array).tobytes()


def named_pieces(parts: Mapping[str, Any]) -> Iterator[bytes]:
    for name, part in parts.items():
        yield f"{name}:".encode()
        yield from pieces(part)


def parts_of(value: Any) -> dict[str, Any]:
    """The public parts of an object, by name."""
    if isinstance(value, loom().PointCloud):
        return cloud_parts(value)
    names = PARTS.get(type(value).__name__)
    if names is None and dataclasses.is_dataclass(value):
        names = sorted(field.name for field in dataclasses.fields(value) if not field.name.startswith("_"))
    if names is None:
        raise TypeError(f"digests.py defines no parts for the type {type(value).__name__}")
    return {name: getattr(value, name) for name in names}


def cloud_parts(cloud: Any) -> dict[str, Any]:
    """The complete contents of a cloud, with positions as stored on the device."""
    parts = {"origin": cloud.origin, "points": cloud.arrays["points"].numpy(), "grid": cloud.grid}
    parts |= {name: cloud[name] for name in ("normals", "colors") if name in cloud}
    return parts | {"attributes": cloud.attributes}


def on_each(work: Callable[[SampledSurface], Any], clouds: list[SampledSurface]) -> list[Any]:
    """A digest for each cloud, or the error type: some operations need more points."""
    digests = []
    for cloud in clouds:
        try:
            digests.append(np.frombuffer(digest(work(cloud)).encode(), np.uint8))
        except Exception as error:
            digests.append(np.frombuffer(type(error).__name__.encode(), np.uint8))
    return digests


def operations(device: str) -> dict[str, Callable[[], Any]]:
    """All operations by name; the clouds of an operation are consecutive."""
    data = Scenes(device)
    clouds = ["surface", "far", "dirty"]
    with contextlib.suppress(DataMissingError):
        scenes.real_scan_path()
        clouds.append("real")
    works: dict[str, Callable[[], Any]] = {}
    for name, on_cloud in ON_CLOUDS.items():
        for cloud in clouds:
            works[f"{name} [{cloud}]"] = lambda on_cloud=on_cloud, cloud=cloud: on_cloud(getattr(data, cloud))
        works[f"{name} [tiny]"] = lambda on_cloud=on_cloud: on_each(on_cloud, data.tiny)
    return works | {name: lambda once=once: once(data) for name, once in ONCE.items()}


def outcome(work: Callable[[], Any]) -> str:
    """The digest of an operation's result, or a description of the error."""
    try:
        return digest(work())
    except Exception as error:
        lines = str(error).splitlines() or [""]
        return f"ERROR {type(error).__name__}: {lines[0]}"


def read_lines(path: Path) -> dict[str, str]:
    """Read an earlier output: outcomes by name."""
    rows = [re.split(r"\s{2,}", line, maxsplit=1) for line in path.read_text().splitlines() if line.strip()]
    return {name: what for name, what in rows}


def line(name: str, *columns: str) -> str:
    return "  ".join([f"{name:62s}", *columns])


def main() -> int:
    """Run the operations. Returns the exit code: 1 if an operation failed or a result differs."""
    options = parse_options()
    if options.compiler:
        os.environ["POINTLOOM_CPU"] = options.compiler  # before the library is loaded
    prefixes = tuple(options.only or [""])
    before = read_lines(options.against) if options.against else None
    outcomes, differing = {}, 0
    for name, work in operations(options.device).items():
        if not name.startswith(prefixes):
            continue
        outcomes[name] = outcome(work)
        if before is None:
            print(line(name, outcomes[name]), flush=True)
        elif outcomes[name] != before.get(name):
            differing += 1
            print(line(name, before.get(name, "(not there)"), outcomes[name]), flush=True)
    if not outcomes:
        print(f"No operation starts with {' or '.join(prefixes)}.", file=sys.stderr)
        return 2
    failed = sum(what.startswith("ERROR") for what in outcomes.values())
    for name in [name for name in before or {} if name.startswith(prefixes) and name not in outcomes]:
        differing += 1
        print(line(name, before[name], "(not there)"))
    summary = "" if before is None else f", {differing} differ"
    print(f"{len(outcomes)} operations, {failed} failed{summary}", file=sys.stderr)
    return int(failed > 0 or differing > 0)


def parse_options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--compiler", choices=("taichi", "warp"), help="of the CPU; default: from the environment")
    parser.add_argument("--device", default="cpu")
    parser.add_argument("--only", action="append", metavar="PREFIX", help="operations whose names start with this")
    parser.add_argument("--against", type=Path, metavar="FILE", help="an earlier output: print only differing lines")
    return parser.parse_args()


if __name__ == "__main__":
    sys.exit(main())

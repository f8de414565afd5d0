"""Whether a change changes a result: a digest of what every operation returns, most of them on several small clouds.

    python benchmarks/digests.py [--compiler taichi|warp] [--device cpu] [--only PREFIX] > before.txt
    python benchmarks/digests.py [the same options] --against before.txt

A change that should change no result changes no bit: run this before it and after it. A line is an operation, the
cloud in brackets, and the first 16 hex digits of the SHA-256 of the result: arrays with element type, shape and all
bytes, objects by their public parts; texts do not count. On clouds of at most five points ([tiny]) an error is a result
too, of which its type counts. With `--against` only lines that differ are shown: before, now. The exit code is 1 where
one differs or an operation fails.

What operations are given is partly made by others: normals, features and matches. Where many lines differ, the first
that does says most.

Only names that users have are called, so the script runs on either side of a change of what lies beneath. Compare runs
of one compiler, device and machine; `POINTLOOM_DATA` adds a real LiDAR scan to both or to neither.
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
from digest_on_clouds import ON_CLOUDS  # noqa: E402
from digest_once import ONCE  # noqa: E402
from digest_scenes import Place, Scenes, loom  # noqa: E402
from numpy.typing import NDArray  # noqa: E402
from real_data import DataMissingError  # noqa: E402

DIGITS = 16

# Public parts of the results that are neither arrays, nor tuples, nor dataclasses.
PARTS = {
    "AxisAlignedBoundingBox": ("min_bound", "max_bound", "color"),
    "OrientedBoundingBox": ("center", "R", "extent", "color"),
    "PoseGraph": ("nodes", "edges", "report"),
    "RGBDImage": ("color", "depth"),
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
    """The bytes that make up a value, with what tells apart values of the same bytes."""
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
        raise TypeError(f"digests.py does not know the parts of a {type(value).__name__}")
    return {name: getattr(value, name) for name in names}


def cloud_parts(cloud: Any) -> dict[str, Any]:
    """All that a cloud holds, its positions as the device has them."""
    parts = {"origin": cloud.origin, "points": cloud.array("points").numpy(), "grid": cloud.grid}
    parts |= {name: cloud[name] for name in ("normals", "colors") if name in cloud}
    return parts | {"attributes": cloud.attributes}


def on_each(work: Callable[[Place], Any], places: list[Place]) -> list[Any]:
    """A digest for each place, or the kind of error: some operations need more points than there are."""
    found = []
    for place in places:
        try:
            found.append(np.frombuffer(digest(work(place)).encode(), np.uint8))
        except Exception as error:
            found.append(np.frombuffer(type(error).__name__.encode(), np.uint8))
    return found


def operations(device: str) -> dict[str, Callable[[], Any]]:
    """All operations by name; the clouds of a name stand side by side."""
    data = Scenes(device)
    places = ["surface", "far", "dirty"]
    with contextlib.suppress(DataMissingError):
        scenes.real_scan_path()
        places.append("real")
    found: dict[str, Callable[[], Any]] = {}
    for name, on_cloud in ON_CLOUDS.items():
        for place in places:
            found[f"{name} [{place}]"] = lambda on_cloud=on_cloud, place=place: on_cloud(getattr(data, place))
        found[f"{name} [tiny]"] = lambda on_cloud=on_cloud: on_each(on_cloud, data.tiny)
    return found | {name: lambda once=once: once(data) for name, once in ONCE.items()}


def outcome(work: Callable[[], Any]) -> str:
    """The digest of what an operation returns, or what went wrong."""
    try:
        return digest(work())
    except Exception as error:
        lines = str(error).splitlines() or [""]
        return f"ERROR {type(error).__name__}: {lines[0]}"


def read_lines(path: Path) -> dict[str, str]:
    """An earlier output: outcomes by name."""
    rows = [re.split(r"\s{2,}", line, maxsplit=1) for line in path.read_text().splitlines() if line.strip()]
    return {name: what for name, what in rows}


def line(name: str, *columns: str) -> str:
    return "  ".join([f"{name:62s}", *columns])


def main() -> int:
    """The exit code: 1 where an operation failed or a result is not as before."""
    options = parse_options()
    if options.compiler:
        os.environ["POINTLOOM_CPU"] = options.compiler  # before the library is loaded
    wanted = tuple(options.only or [""])
    before = read_lines(options.against) if options.against else None
    outcomes, differing = {}, 0
    for name, work in operations(options.device).items():
        if not name.startswith(wanted):
            continue
        outcomes[name] = outcome(work)
        if before is None:
            print(line(name, outcomes[name]), flush=True)
        elif outcomes[name] != before.get(name):
            differing += 1
            print(line(name, before.get(name, "(not there)"), outcomes[name]), flush=True)
    if not outcomes:
        print(f"No operation begins with {' or '.join(wanted)}.", file=sys.stderr)
        return 2
    failed = sum(what.startswith("ERROR") for what in outcomes.values())
    for name in [name for name in before or {} if name.startswith(wanted) and name not in outcomes]:
        differing += 1
        print(line(name, before[name], "(not there)"))
    told = "" if before is None else f", {differing} not as before"
    print(f"{len(outcomes)} operations, {failed} failed{told}", file=sys.stderr)
    return int(failed > 0 or differing > 0)


def parse_options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--compiler", choices=("taichi", "warp"), help="of the CPU; as the environment has it if none")
    parser.add_argument("--device", default="cpu")
    parser.add_argument("--only", action="append", metavar="PREFIX", help="operations whose names begin so")
    parser.add_argument("--against", type=Path, metavar="FILE", help="an earlier output: show what differs from it")
    return parser.parse_args()


if __name__ == "__main__":
    sys.exit(main())

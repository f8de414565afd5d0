"""Kill processes while they write: `python tests/fuzz/kill_writers.py --count 200 --seed 1`.

A child process writes two versions of a file alternately over each other and is killed by SIGKILL at a random time.
Then each file must be complete, no other visible file may exist, the result must be readable, and the next write must
succeed. A write to a full disk must raise `FileError` and keep the previous files. Formats of several files are
replaced file by file, the mesh last: "mixed" counts kills after which files of both versions remained. The exit code is
1 if there was a fault.
"""

from __future__ import annotations

import argparse
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import warnings
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import pointloom as loom
from pointloom.cameras.trajectory_formats import TRAJECTORY_FORMATS
from pointloom.core.errors import FileError
from pointloom.io.meshes.mesh_formats import MESH_FORMATS
from pointloom.io.points.formats import WRITTEN

POINTS = 30_000
MAX_DELAY = 0.25  # [s] from the first write to the kill: several versions of most formats


def _cloud(version: int) -> loom.PointCloud:
    points = np.random.default_rng(version).random((POINTS + 1000 * version, 3))
    return loom.PointCloud(points, colors=points, normals=points)


def _write_cloud(path: Path, cloud: loom.PointCloud) -> None:
    loom.write_point_cloud(path, cloud, drop_unsupported=True)


def _mesh(version: int) -> loom.TriangleMesh:
    mesh = loom.TriangleMesh.create_sphere(1.0 + version, 60 + version)
    mesh.triangle_uvs = np.random.default_rng(version).random((3 * len(mesh.triangles), 2))
    mesh.textures = [np.full((256, 256, 3), 50 * version, np.uint8)]
    mesh.triangle_material_ids = np.zeros(len(mesh.triangles), np.int32)
    return mesh


def _trajectory(version: int) -> loom.Trajectory:
    poses = np.tile(np.eye(4), (2000 + version, 1, 1))
    poses[:, 0, 3] = np.arange(len(poses)) * (1 + version)
    return loom.Trajectory(poses, np.arange(len(poses)) * 0.1)


def _graph(version: int) -> loom.registration.PoseGraph:
    poses = _trajectory(version).poses[:500]
    return loom.registration.PoseGraph([loom.registration.PoseGraphNode(pose) for pose in poses])


# name of the written path -> object of a version, writer, reader
CASES: dict[str, tuple[Callable[[int], Any], Callable[[Path, Any], Any], Callable[[Path], Any]]] = {
    **{f"cloud{ending}": (_cloud, _write_cloud, loom.read_point_cloud) for ending in (*WRITTEN, ".copc.laz")},
    **{f"mesh{ending}": (_mesh, loom.write_triangle_mesh, loom.read_triangle_mesh) for ending in MESH_FORMATS},
    **{
        f"poses{ending}": (_trajectory, loom.write_trajectory, loom.read_trajectory)
        for ending, names in TRAJECTORY_FORMATS.items()
        if len(names) == 1 and ending != ".json"  # which needs a camera
    },
    "graph.json": (_graph, loom.registration.write_pose_graph, loom.registration.read_pose_graph),
}


def contents(folder: Path) -> dict[str, bytes]:
    """Visible files below a folder by name."""
    paths = (path.relative_to(folder) for path in folder.rglob("*") if path.is_file())
    return {
        path.as_posix(): (folder / path).read_bytes()
        for path in sorted(paths)
        if not any(part.startswith(".") for part in path.parts)
    }


def write_forever(path: Path) -> None:
    """Write the versions alternately; the first byte of standard output announces the first write."""
    make, write, _ = CASES[path.name]
    versions = [make(1), make(2)]
    print("writing", flush=True)
    while True:
        for version in versions:
            write(path, version)


def outcome(name: str, folder: Path, versions: list[dict[str, bytes]], rng: random.Random) -> str:
    """Kill a writer in an empty folder at a random time. Returns "complete", "mixed" or the description of a fault."""
    _, write, read = CASES[name]
    command = [sys.executable, __file__, "--write", str(folder / name)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as writer:
        if writer.stdout is None or not writer.stdout.readline():
            raise RuntimeError(f"{name}: the writing process ended before its first write")
        time.sleep(rng.uniform(0, MAX_DELAY))
        writer.kill()
    files = contents(folder)
    for file, content in files.items():
        if content not in [version.get(file) for version in versions]:
            return f"{file} does not match any version"
    if name in files:
        read(folder / name)
    write(folder / name, CASES[name][0](1))
    if contents(folder) != versions[0]:
        return "the next write created other files"
    return "complete" if not files or files in versions else "mixed"


def survives_full_disk(name: str, folder: Path, versions: list[dict[str, bytes]]) -> bool:
    """True if a write that exceeds the file size limit raises `FileError` and leaves the previous files alone."""
    make, write, _ = CASES[name]
    write(folder / name, make(1))
    before, handler = resource.getrlimit(resource.RLIMIT_FSIZE), signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (len(versions[1][name]) // 2, before[1]))
    try:
        write(folder / name, make(2))
        return False
    except FileError:
        return contents(folder) == versions[0] and not [path for path in folder.iterdir() if path.name.startswith(".")]
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
        signal.signal(signal.SIGXFSZ, handler)


def main() -> int:
    """Run the kills and print one row for each written format; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=200, help="number of kills, at least one of each format")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--write", type=Path, help=argparse.SUPPRESS)
    options = parser.parse_args()
    warnings.simplefilter("ignore")
    if options.write:
        write_forever(options.write)
    rng, faults = random.Random(options.seed), 0
    print("| file | kills | complete | mixed | faults | full disk |\n|---|---|---|---|---|---|")
    for number, (name, (make, write, _)) in enumerate(CASES.items()):
        kills = max(1, options.count * (number + 1) // len(CASES) - options.count * number // len(CASES))
        with tempfile.TemporaryDirectory() as base:
            versions = []
            for version in (1, 2):
                (folder := Path(base) / f"version-{version}").mkdir()
                write(folder / name, make(version))
                versions.append(contents(folder))
            outcomes: Counter[str] = Counter()
            for _ in range(kills):
                (folder := Path(base) / "killed").mkdir()
                outcomes[outcome(name, folder, versions, rng)] += 1
                shutil.rmtree(folder)
            (folder := Path(base) / "full").mkdir()
            is_intact = survives_full_disk(name, folder, versions)
        complete, mixed = outcomes.pop("complete", 0), outcomes.pop("mixed", 0)
        full = "previous file kept" if is_intact else "FAULT"
        print(f"| {name} | {kills} | {complete} | {mixed} | {'; '.join(outcomes) or 0} | {full} |", flush=True)
        faults += outcomes.total() + (not is_intact)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

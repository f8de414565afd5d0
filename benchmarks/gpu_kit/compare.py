"""Times with the present code and with that before a change, in alternating processes on one machine.

    python -m gpu_kit.compare STATE SECONDS

The former code comes from an archive (pack.py), or on a machine with the repository from git. In a dry run it is the
present code.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from gpu_kit import device as devices
from gpu_kit.documents import keep_part, saved_part
from gpu_kit.runner import MORE

FOLDER = "POINTLOOM_GPU_BEFORE"  # set by call.sh: contains a folder for each change, with src and kernels.zip
KINDS = ("device", "call", "call")  # processes of each side, in order
AT_LEAST = 15.0  # seconds to start both sides
PACKAGES = ("src", "kernels", "pcd", "registration", "meshing")  # before links were reversed


@dataclass(frozen=True)
class Change:
    """A change of kernels: the commit before it, and the operations that use them."""

    name: str
    before: str
    calls: tuple[str, ...]

    @property
    def folder(self) -> str:
        return self.name.replace(" ", "-")


def sized(sizes: tuple[int, ...], *names: str) -> tuple[str, ...]:
    return tuple(f"{name}={size}" for name in names for size in sizes)


ROWS = ("register_globally", "segment_plane", "planar_patches", "ransac")
CHANGES = (
    Change(
        "poses in batches, loads before stores",  # evidence of all poses at once, planes in a block, scans, selection
        "59061b707^",
        (
            *sized((200_000,), "register_globally"),
            *sized((1_000_000,), "normals_k30", "knn20_device"),
            "decimation=128",
        ),
    ),
    Change(
        "one kernel per sum, eight lanes per pixel",  # also balls, small blocks, solves and levels of one launch
        "08a77bf4",
        (
            *sized((200_000,), "icp_plane", "gicp", "normals_k30"),
            *sized((307_200,), "rgbd_frame", "slam_frame"),
            *("mvs_pictures=57600", "lidar_odometry_scan=57600", "ball_pivoting=60000", "poisson_depth_7=60000"),
            "deform_arap=48",
        ),
    ),
    Change(
        "warps for rows",  # DBSCAN, compatibility graphs, main planes, disparities
        "7f661cb4^",
        (*sized((200_000, 1_000_000), "dbscan_device"), *sized((200_000,), *ROWS), "mvs_pictures=57600"),
    ),
)


def sources_of(change: Change, state: Path) -> Path | None:
    """The folder of the code before a change; None if neither the archive nor git has it."""
    packed = Path(os.environ.get(FOLDER, state / "before")) / change.folder
    if not packed.exists():
        packed.mkdir(parents=True)
        if not checked_out(change.before, packed):
            shutil.rmtree(packed)
            return None
    return packed


def checked_out(commit: str, folder: Path) -> bool:
    """Extract the packages of a commit; False if the repository does not have it."""
    try:
        archive = subprocess.run(
            ["git", "archive", commit, *PACKAGES], cwd=devices.ROOT, capture_output=True, check=False
        )
    except OSError:  # no git
        return False
    return archive.returncode == 0 and not subprocess.run(["tar", "x", "-C", folder], input=archive.stdout).returncode


def times_with(sources: Path | None, kind: str, calls: tuple[str, ...], seconds: float) -> dict[str, Any]:
    """Results of measure.py in another process; `sources` is the folder of the former code.

    Raises:
        RuntimeError, subprocess.TimeoutExpired: The process failed.
    """
    environment = dict(os.environ)
    if sources is not None:
        paths = [str(devices.ROOT / "benchmarks"), str(sources / "src"), environment.get("PYTHONPATH", "")]
        environment["PYTHONPATH"] = os.pathsep.join(paths)
        environment["POINTLOOM_CUDA_KERNELS"] = (
            str(sources / "kernels.zip") if (sources / "kernels.zip").exists() else ""
        )
        environment.pop("POINTLOOM_CPU_KERNELS", None)
    command = [sys.executable, "-m", "gpu_kit.measure", "--json", kind, *calls]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=seconds, check=False)
    lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
    if done.returncode or not lines:
        raise RuntimeError(f"exit {done.returncode}: {done.stderr[-400:]}")
    document = json.loads(lines[-1])
    if not Path(document["package"]).is_relative_to(sources or devices.ROOT):
        raise RuntimeError(f"expected the code of {sources}, got that of {document['package']}")
    errors = [f"{name}: {result['error']}" for name, result in document["results"].items() if "error" in result]
    if errors:
        raise RuntimeError("; ".join(errors))
    return document["results"]


def main() -> int:
    """Measure the remaining changes, each once before any again; returns MORE if some remain."""
    state, end = Path(sys.argv[1]), time.monotonic() + float(sys.argv[2])
    device, results, failed = devices.start(), saved_part(state, "comparisons"), False
    for lap, kind in enumerate(KINDS):
        for change in CHANGES:
            calls = ("voxel_down_sample=3000",) if devices.is_dry() else change.calls
            former = devices.ROOT if devices.is_dry() else sources_of(change, state)
            if former is None:
                print(f"{change.name}: skipped, neither an archive nor git has {change.before}")
                continue
            done = results.setdefault(change.name, {"before": change.before, "laps": []})["laps"]
            if len(done) > lap:
                continue
            if (left := end - time.monotonic()) < AT_LEAST:
                print(f"no time left before {change.name}, {kind}")
                return MORE
            try:
                sides = {"former": times_with(former, kind, calls, left)}
                sides["present"] = times_with(None, kind, calls, end - time.monotonic())
            except subprocess.TimeoutExpired:
                print(f"no time left in {change.name}, {kind}")
                return MORE
            except RuntimeError as error:
                print(f"{change.name}, {kind}: FAILED {error}")
                failed = True
                continue
            done.append({"kind": kind, **sides})
            keep_part(state, device, "comparisons", results)
            for key, times in compared(done).items():
                cells = [f"{kind} {a:.3f} -> {b:.3f} ms, {a / b:.2f}x" for kind, (a, b) in times.items()]
                print(f"{change.name}: {key}: {'; '.join(cells)}", flush=True)
    return 1 if failed else 0


def compared(laps: list[dict[str, Any]]) -> dict[str, dict[str, tuple[float, float]]]:
    """For each operation the best times before and after [ms], of the caller and of the device if measured."""
    result: dict[str, dict[str, tuple[float, float]]] = {}
    for key in laps[0]["present"] if laps else ():
        result[key] = {}
        for kind, field in (("call", "best_ms"), ("device", "device_ms")):
            sides = [
                [lap[side][key][field] for lap in laps if lap["kind"] == kind and field in lap[side].get(key, {})]
                for side in ("former", "present")
            ]
            if all(sides):
                result[key][kind] = (min(sides[0]), min(sides[1]))
    return result


if __name__ == "__main__":
    sys.exit(main())

"""Host time of calls on CUDA: CPU time of Python and Warp, without the emulated device's work.

    python benchmarks/gpu_host_time.py [PART OF A NAME ...] [--rounds 9] [--save FILE] [--against FILE] [--profile]

The emulated device works inside the functions of Warp's native library that it replaces. Their time is subtracted, and
the overhead of the clock around them. A host with a real GPU needs the remaining time too, plus the driver's part of
each native call, about 1 to 5 us; the table shows the numbers of calls, launches and allocations.

Clouds have 3,000 points, images 160 x 120 pixels: the host time hardly depends on the size, the emulator's time does.
Ten calls are made without synchronization, with warm CPU caches as between launches of a real GPU. Operations that
synchronize internally run the emulator in between, find cold caches, and take up to twice as long. Times are thread CPU
times, the lower quartile of the rounds. --save writes JSON, --against adds the ratio to such a file, and --profile
prints
the functions that need the time: cProfile slows all of them, small ones most.
"""

from __future__ import annotations

import argparse
import cProfile
import gc
import json
import os
import pstats
import statistics
import sys
import time
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

ROOT, DEVICE = Path(__file__).parents[1], "cuda:0"
CALIBRATION, WARM_UP, IN_A_ROW, PROFILED, PROFILE_LINES = 20_000, 2, 10, 20, 45
COUNTS = ("launches", "graphs", "graphs made", "copies to host", "copies to device", "allocations", "waits")
# Operations that synchronize dozens of times per call: caches are cold.
WAITING = ("register_globally", "odometry, a scan", "slam frame", "ransac", "planar patches")
clock = time.thread_time


class Inside:
    """Measures the time of the emulated device."""

    def __init__(self) -> None:
        self.seconds, self.calls, self.is_in, self.hook, self.start = 0.0, 0, False, 0.0, 0.0

    def timed(self, function: Callable[..., Any]) -> Callable[..., Any]:
        """Wrap a device function with a clock; nested calls are not counted twice."""

        def call(*arguments: Any) -> Any:
            if self.is_in:
                return function(*arguments)
            self.calls += 1
            self.is_in = True
            self.start = clock()
            try:
                return function(*arguments)
            finally:
                self.seconds += clock() - self.start
                self.is_in = False

        return call

    def calibrate(self) -> None:
        """Measure the overhead of the clock around a call."""
        call, nothing = self.timed(lambda *_: None), range(CALIBRATION)
        start = clock()
        for _ in nothing:
            pass
        loop = clock() - start
        self.seconds, start = 0.0, clock()
        for _ in nothing:
            call(0)
        self.hook = (clock() - start - self.seconds - loop) / CALIBRATION
        self.seconds, self.calls = 0.0, 0

    def outside(self) -> float:
        """A clock that stops while the device works."""
        return (self.start if self.is_in else clock()) - self.seconds

    def taken(self) -> float:
        """The time to subtract from a call."""
        return self.seconds + self.calls * self.hook


def install() -> tuple[Any, Inside]:
    """Install the emulated device as Warp's only GPU, with the clock."""
    os.environ.setdefault("EMULATED_CUDA_UNINITIALISED", "0")
    sys.path.append(str(ROOT / "tests"))
    from emulated_cuda import install as emulated  # pyright: ignore[reportMissingImports]

    inside, original = Inside(), emulated.Device.function

    def function(self: Any, name: str) -> Any:
        native = original(self, name)
        return None if native is None else inside.timed(native)

    emulated.Device.function = function
    emulated.install()
    warnings.simplefilter("ignore")
    import warp as wp

    import pointloom.kernels.lang  # noqa: F401  before Warp starts: it silences the banner

    wp.init()
    inside.calibrate()
    return emulated.installed(), inside


# ------------------------------------------------------------------------------------------------ operations


def cloud_operations() -> dict[str, Callable[[], Any]]:
    """Operations on a cloud with an existing tree."""
    import numpy as np
    import scenes

    import pointloom as loom

    cloud = loom.PointCloud(scenes.bumpy_surface(3000, 0), device=DEVICE).to(DEVICE, arrays="warp")
    facing = cloud.estimate_normals(max_nn=30)
    search = loom.NearestNeighborSearch(cloud)
    rooms = loom.PointCloud(np.concatenate([scenes.bumpy_surface(2000, k) + 3 * k for k in range(3)]), device=DEVICE)
    rooms = rooms.estimate_normals(max_nn=20)
    return {
        "normals k30": lambda: cloud.estimate_normals(max_nn=30),
        "voxel_down_sample": lambda: cloud.voxel_down_sample(0.2),
        "knn 20": lambda: search.knn_search(cloud.arrays["points"], 20),
        "statistical outliers": lambda: cloud.remove_statistical_outlier(20, 2.0),
        "planar patches": lambda: rooms.detect_planar_patches(max_nn=20),
        "dbscan": lambda: cloud.cluster_dbscan(0.1, 8),
        "fpfh": lambda: loom.compute_fpfh_feature(facing, radius=0.3, max_nn=50),
    }


def registration_operations() -> dict[str, Callable[[], Any]]:
    """Registration of two clouds, and odometry."""
    import scenes
    import street

    import pointloom as loom

    reg = loom.registration
    source = loom.PointCloud(scenes.bumpy_surface(3000, 0), device=DEVICE).to(DEVICE, arrays="warp")
    target = loom.PointCloud(scenes.bumpy_surface(3000, 1), device=DEVICE).estimate_normals(max_nn=20)
    steps = reg.ICPConvergenceCriteria(0, 0, 20)
    plane, general = reg.TransformationEstimationPointToPlane(), reg.TransformationEstimationForGeneralizedICP()
    drive = street.drive(WARM_UP + 14, sway=0.2, azimuths=225)
    scans = [loom.PointCloud(p, device=DEVICE, time=t) for p, t in zip(drive.scans, drive.times, strict=True)]
    run = reg.LidarOdometry(voxel_size=1.0, device=DEVICE)
    left = iter(scans)
    run.register(next(left))
    facing = [cloud.estimate_normals(max_nn=20) for cloud in (source, target)]
    features = [loom.compute_fpfh_feature(cloud, radius=0.4, max_nn=60) for cloud in facing]
    ransac, match = reg.registration_ransac_based_on_correspondence, reg.correspondences_from_features
    return {
        "ransac": lambda: ransac(source, target, match(*features, True), 0.15, seed=2),
        "icp plane, 20 steps": lambda: reg.registration_icp(source, target, 0.3, None, plane, steps),
        "gicp, 20 steps": lambda: reg.registration_icp(source, target, 0.3, None, general, steps),
        "register_globally": lambda: reg.register_globally(source, target, voxel_size=0.15),
        "odometry, a scan": lambda: run.register(next(left)),
    }


def frame_operations() -> dict[str, Callable[[], Any]]:
    """Depth images, volumes and rays."""
    from types import SimpleNamespace

    import numpy as np
    import scenes
    from bench_slam import room_frames
    from mesh_scenes import scene_in_pointloom, wavy_mesh

    import pointloom as loom

    frames = scenes.room_frames(2, 160, 120)
    camera = loom.PinholeCameraIntrinsic(160, 120, *frames.intrinsic)
    volume = loom.TSDFVolume(voxel_size=0.05, truncation=0.2, color=False, device=DEVICE)
    scale = {"depth_scale": 1000.0, "depth_max": 5.0}
    v, u = np.mgrid[:120, :160]
    shade = (127 + 60 * np.sin(u / 7) + 50 * np.cos(v / 9)).astype(np.uint8)
    first, second = (loom.rgbd.OdometryFrame(depth, camera, shade, device=DEVICE) for depth in frames.depths[:2])
    scene = scene_in_pointloom(wavy_mesh(24), DEVICE)
    rng = np.random.default_rng(0)
    rays = np.concatenate([rng.random((2_000, 3)) * 4 - 2, rng.standard_normal((2_000, 3))], axis=1).astype(np.float32)
    room = room_frames(WARM_UP + 14, 160, 120)
    slam = loom.rgbd.DenseSLAM(room.camera, voxel_size=0.04, device=DEVICE)
    left = iter([SimpleNamespace(depth=d, color=c) for d, c in zip(room.depths, room.colors, strict=True)])
    slam.step(next(left))
    return {
        "slam frame": lambda: slam.step(next(left)),
        "tsdf integrate": lambda: volume.integrate(frames.depths[1], camera, frames.extrinsics[1], **scale),
        "tsdf mesh": lambda: volume.extract_triangle_mesh(0),
        "rgbd frame": lambda: loom.rgbd.OdometryFrame(frames.depths[0], camera, shade, device=DEVICE),
        "rgbd alignment": lambda: loom.rgbd.align_frames(first, second),
        "cast_rays": lambda: scene.cast_rays(rays),
    }


# ------------------------------------------------------------------------------------------------ measuring


def measure(name: str, call: Callable[[], Any], rounds: int, device: Any, inside: Inside) -> dict[str, Any]:
    """The lower quartile of some calls, and the counts of the last one."""
    import warp as wp

    for _ in range(WARM_UP):
        _ = call()
    seconds, counts, calls, in_a_row = [], {}, 0, 1 if name in WAITING else IN_A_ROW
    gc.disable()  # its time depends on other objects of the process
    for _ in range(rounds):
        wp.synchronize()
        before = dict(device.findings.counts)
        inside.seconds, inside.calls, start = 0.0, 0, clock()
        for _ in range(in_a_row):
            result = call()
            del result  # releasing the result is included
        seconds.append((clock() - start - inside.taken()) / in_a_row)
        calls = inside.calls // in_a_row
        wp.synchronize()
        counts = {key: (device.findings.counts[key] - before.get(key, 0)) // in_a_row for key in COUNTS}
    gc.enable()
    return {"operation": name, "host_ms": 1e3 * statistics.quantiles(seconds, n=4)[0], "native calls": calls, **counts}


def printed(row: dict[str, Any], known: dict[str, Any] | None) -> str:
    """A line of the table."""
    ratio = f"{known['host_ms'] / row['host_ms']:7.2f}x" if known else ""
    counts = "".join(f"{row[key]:{len(key) + 2}}" for key in ("native calls", *COUNTS))
    return f"{row['operation']:22}{row['host_ms']:9.3f}{ratio}{counts}"


def print_profile(name: str, call: Callable[[], Any], inside: Inside) -> None:
    """Print the functions of a call by own and cumulative time."""
    for _ in range(WARM_UP):
        _ = call()
    gc.disable()
    profile = cProfile.Profile(inside.outside)
    profile.enable()
    calls = PROFILED if name not in WAITING else 10
    for _ in range(calls):
        result = call()
        del result
    profile.disable()
    gc.enable()
    rows = []
    for (file, line, function), (_, count, own, all_of_it, _) in pstats.Stats(profile).stats.items():  # type: ignore[attr-defined]
        location = f"{Path(file).parent.name}/{Path(file).name}:{line} {function}"
        rows.append((1e3 * own / calls, 1e3 * all_of_it / calls, count / calls, location))
    print(f"{name}: {sum(row[0] for row in rows):.3f} ms according to cProfile")
    print(f"  {'own ms':>8}{'with calls':>12}{'times':>8}")
    for key in (0, 1):
        for own, all_of_it, count, location in sorted(rows, key=lambda row: -row[key])[:PROFILE_LINES]:
            print(f"  {own:8.3f}{all_of_it:12.3f}{count:8.1f}  {location}")


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("names", nargs="*")
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--save", type=Path)
    parser.add_argument("--against", type=Path)
    parser.add_argument("--profile", action="store_true")
    chosen = parser.parse_args()
    device, inside = install()
    known = {row["operation"]: row for row in json.loads(chosen.against.read_text())} if chosen.against else {}
    if not chosen.profile:
        print(f"{'operation':22}{'host ms':>9}{'  before' if known else ''}  " + "  ".join(("native calls", *COUNTS)))
    rows = []
    for operations in (cloud_operations, registration_operations, frame_operations):
        for name, call in operations().items():
            if chosen.names and not any(part in name for part in chosen.names):
                continue
            if chosen.profile:
                print_profile(name, call, inside)
                continue
            rows.append(measure(name, call, chosen.rounds, device, inside))
            print(printed(rows[-1], known.get(name)), flush=True)
    if chosen.save and rows:
        chosen.save.write_text(json.dumps(rows, indent=1) + "\n")


if __name__ == "__main__":
    main()

"""Small surveys in several files, and the expected results of tiled steps, computed in memory."""

import os
import re
import subprocess
import sys

import numpy as np
import pytest

import pointloom as loom
from pointloom.io.points.las import read_las
from pointloom.io.points.las_writer import write_las
from pointloom.io.table import PointTable
from pointloom.tiling.manifest import Manifest

STEP = 1e-7  # [m] below float32 resolution here, so that files store means and moved points exactly
CORNER = np.array([500_000.0, 4_000_000.0, 100.0])
SIDE = 40.0
# Sides of tiles [m]: 4 tiles with points on their borders and slivers, one tile, and a number that is not round.
SIZES = [20.0, *(pytest.param(size, marks=pytest.mark.slow) for size in (100.0, 17.3))]
RADIUS = [{"step": "remove_radius_outlier", "nb_points": 4, "radius": 0.9}]


def survey(folder, *, count=6000, files=2, suffix=".laz", seed=0):
    """Write files of hilly ground with outliers above it, on a grid of 5 cm, so that many distances are equal.

    Some points are on the borders and corners of tiles of 10 and 20 m, and some are in both of the first files.
    """
    rng = np.random.default_rng(seed)
    positions = rng.random((count, 2)) * SIDE
    positions[: count // 20] = rng.integers(0, 5, (count // 20, 2)) * 10.0
    positions[count // 20 : count // 10, 0] = rng.integers(0, 9, count // 10 - count // 20) * 5.0
    height = np.sin(positions[:, 0] / 5) + 0.1 * rng.normal(size=count)
    height[::97] += rng.random(len(height[::97])) * 5
    points = np.round(np.column_stack([positions, height]) / 0.05) * 0.05 + CORNER
    points[0], points[1] = CORNER, CORNER + np.array([SIDE, SIDE, 0])
    paths, cuts = [], np.array_split(rng.permutation(count), files)
    for number, rows in enumerate(cuts):
        if number == 1:
            rows = np.concatenate([rows, cuts[0][:50]])
        file_points = points[rows]
        table = PointTable(file_points, attributes={
            "intensity": rng.integers(0, 60000, len(file_points)).astype(np.uint16),
            "gps_time": rng.random(len(file_points)),
            "range": rng.random(len(file_points)).astype(np.float32),
        })  # fmt: skip
        path = folder / f"part{number}{suffix}"
        write_las(path, table, scale=STEP, offset=CORNER)
        paths.append(path)
    return paths


def read_cloud(paths, origin):
    """Read all points of the files in order, relative to an origin."""
    tables = [read_las(path) for path in paths]
    names = tables[0].attributes
    attributes = {name: np.concatenate([table.attributes[name] for table in tables]) for name in names}
    normals = None if tables[0].normals is None else np.concatenate([table.normals for table in tables])
    points = np.concatenate([table.points for table in tables])
    return loom.PointCloud(points, normals=normals, origin=origin, **attributes)


def in_memory(cloud, steps, low):
    """The steps on a complete cloud. `low`: lowest coordinates of all files, for voxels after other steps."""
    for number, step in enumerate(steps):
        params = {name: value for name, value in step.items() if name != "step"}
        if step["step"] == "voxel_down_sample" and not number:
            cloud = cloud.voxel_down_sample(**params)
        elif step["step"] == "voxel_down_sample":
            corner = (np.array(low) - cloud.origin).astype(np.float32).astype(np.float64) - params["voxel_size"] / 2
            cloud = cloud.trace_grid(params["voxel_size"], corner).cloud
        elif step["step"] == "remove_radius_outlier":
            cloud, _ = cloud.remove_radius_outlier(**params)
        elif step["step"] == "remove_statistical_outlier":
            cloud, _ = cloud.remove_statistical_outlier(**params)
        elif step["step"] == "estimate_normals":
            cloud = cloud.estimate_normals(**params).orient_normals_to_align_with_direction()
        elif step["step"] == "smooth_mls":
            cloud = cloud.smooth_mls(**params)
        elif step["step"] == "crop":
            cloud = cloud.crop(loom.AxisAlignedBoundingBox(params["min_bound"], params["max_bound"]))
        else:
            raise ValueError(step)
    return cloud


def rows_of(cloud):
    """Points and attributes of a cloud as a sorted array of int64 rows; positions in units of STEP."""
    columns = [np.rint((cloud.points - cloud.origin) / STEP).astype(np.int64)]
    names = [name for name in cloud.attributes if name in ("intensity", "gps_time", "range")]
    columns += [np.asarray(cloud[name], np.float64)[:, None].view(np.int64) for name in sorted(names)]
    if cloud.has_normals:
        columns.append((cloud.normals + np.float32(0)).view(np.int32).astype(np.int64))
    rows = np.column_stack(columns)
    return rows[np.lexsort(rows.T)]


def kill_runner(call, job, stage, workers=0):
    """Start a run of a job and kill it when a task of this stage is done; its workers end too."""
    report = "lambda *words: print(*words, flush=True)"
    program = f"import sys, pointloom as loom; {call}(sys.argv[1], workers={workers}, progress={report})"
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}
    command = [sys.executable, "-c", program, str(job)]
    runner = subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True)
    with runner:
        done = re.compile(rf"{stage}.* [1-9]\d* \d+\n")
        assert any(done.fullmatch(line) for line in runner.stdout)
        # The workers share the pipe: it is closed when the last one ends.
        runner.kill()
        runner.stdout.read()


def watch_calls(monkeypatch, owner, name, note):
    """Call `note` with the arguments of each call of a function, before the call."""
    call = getattr(owner, name)
    monkeypatch.setattr(owner, name, lambda *given, **more: (note(*given), call(*given, **more))[1])


def plan_of(folder):
    with Manifest(folder) as manifest:
        return manifest.plan


def written(paths, steps, folder, *target, device="cpu", **options):
    """Plan, run and finish a job; return the path of the result."""
    loom.tiling.plan_tiles(paths, steps, folder, **options)
    status = loom.tiling.run_tiles(folder, device=device)
    assert status.is_finished, status
    return loom.tiling.finish_tiles(folder, *target)


def tiled(paths, steps, folder, device="cpu", **options):
    """Plan, run and finish a job; return the result relative to the origin of the plan, and the plan."""
    path, plan = written(paths, steps, folder, device=device, **options), plan_of(folder)
    return read_cloud([path], np.array(plan["origin"])), plan


def finished(folder):
    """The result of a job, relative to the origin of the plan."""
    return read_cloud([loom.tiling.finish_tiles(folder)], np.array(plan_of(folder)["origin"]))

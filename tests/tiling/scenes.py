"""Small surveys in several files, and the answer of one machine to what tiles do with them."""

from __future__ import annotations

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

STEP = 1e-7  # [m] below what float32 tells apart here, so that files hold means and moved points to the bit
CORNER = np.array([500_000.0, 4_000_000.0, 100.0])
SIDE = 40.0
# Sides of tiles [m]: 4 tiles with points on their borders and corner (and slivers); all in one; no round number.
SIZES = [20.0, *(pytest.param(size, marks=pytest.mark.slow) for size in (100.0, 17.3))]
RADIUS = [{"step": "remove_radius_outlier", "nb_points": 4, "radius": 0.9}]


def survey(folder, *, count=6000, files=2, suffix=".laz", seed=0):
    """Files of a hilly ground with strays above it; each point is a multiple of 5 cm, so that many are equally near.

    Some points lie on the borders and corners of tiles of 10 and 20 m, and some stand in both of the first files.
    """
    rng = np.random.default_rng(seed)
    places = rng.random((count, 2)) * SIDE
    places[: count // 20] = rng.integers(0, 5, (count // 20, 2)) * 10.0
    places[count // 20 : count // 10, 0] = rng.integers(0, 9, count // 10 - count // 20) * 5.0
    height = np.sin(places[:, 0] / 5) + 0.1 * rng.normal(size=count)
    height[::97] += rng.random(len(height[::97])) * 5
    points = np.round(np.column_stack([places, height]) / 0.05) * 0.05 + CORNER
    points[0], points[1] = CORNER, CORNER + np.array([SIDE, SIDE, 0])
    paths, cuts = [], np.array_split(rng.permutation(count), files)
    for number, rows in enumerate(cuts):
        if number == 1:
            rows = np.concatenate([rows, cuts[0][:50]])
        here = points[rows]
        table = PointTable(here, attributes={
            "intensity": rng.integers(0, 60000, len(here)).astype(np.uint16),
            "gps_time": rng.random(len(here)),
            "range": rng.random(len(here)).astype(np.float32),
        })  # fmt: skip
        path = folder / f"part{number}{suffix}"
        write_las(path, table, scale=STEP, offset=CORNER)
        paths.append(path)
    return paths


def whole_cloud(paths, origin):
    """All points of the files in their order, about an origin, as one machine reads them."""
    tables = [read_las(path) for path in paths]
    names = tables[0].attributes
    attributes = {name: np.concatenate([table.attributes[name] for table in tables]) for name in names}
    normals = None if tables[0].normals is None else np.concatenate([table.normals for table in tables])
    return loom.PointCloud(
        np.concatenate([table.points for table in tables]), normals=normals, origin=origin, **attributes
    )


def in_memory(cloud, steps, corner):
    """The steps on a cloud by the operations that users call."""
    for step in steps:
        params = {name: value for name, value in step.items() if name != "step"}
        if step["step"] == "voxel_down_sample":
            cloud = cloud.voxel_down_sample_and_trace(params["voxel_size"], min_bound=corner).cloud
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
    """What a cloud holds as a sorted array of rows of bytes; positions in steps of the files."""
    columns = [np.rint((cloud.points - cloud.origin) / STEP).astype(np.int64)]
    names = [name for name in cloud.attributes if name in ("intensity", "gps_time", "range")]
    columns += [np.asarray(cloud[name], np.float64)[:, None].view(np.int64) for name in sorted(names)]
    if cloud.has_normals:
        columns.append((cloud.normals + np.float32(0)).view(np.int32).astype(np.int64))
    rows = np.column_stack(columns)
    return rows[np.lexsort(rows.T)]


def kill_runner(call, job, stage, workers=0):
    """Start a run of a job, and kill its runner when a task of this stage is done; its workers end, too."""
    told = "lambda *words: print(*words, flush=True)"
    program = f"import sys, pointloom as loom; {call}(sys.argv[1], workers={workers}, progress={told})"
    runner = subprocess.Popen(
        [sys.executable, "-c", program, str(job)],
        env=os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)},
        stdout=subprocess.PIPE,
        text=True,
    )
    with runner:
        done = re.compile(rf"{stage}.* [1-9]\d* \d+\n")
        assert any(done.fullmatch(line) for line in runner.stdout)
        # The workers have the pipe, too: its end tells that none is left.
        runner.kill()
        runner.stdout.read()


def plan_of(folder):
    with Manifest(folder) as manifest:
        return manifest.plan


def tiled(paths, steps, folder, device="cpu", **how):
    """Plan, run and finish; the result as read back about the plan's origin, and the plan."""
    loom.tiling.plan_tiles(paths, steps, folder, **how)
    status = loom.tiling.run_tiles(folder, device=device)
    assert status.is_finished, status
    return finished(folder), plan_of(folder)


def finished(folder):
    """The result of a folder about the plan's origin."""
    return whole_cloud([loom.tiling.finish_tiles(folder)], np.array(plan_of(folder)["origin"]))

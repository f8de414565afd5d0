"""
A pipeline of shell commands
============================

Most operations on point clouds are available as shell commands. On this page you filter a scan, downsample it, and
segment its planes and objects from the command line. You read the reports of the commands as JSON and check their exit
codes.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

# %%
# Input
# -----
# The file contains a scan with outliers and non-finite points.
folder = Path(tempfile.mkdtemp())
room = loom.datasets.room_cloud().voxel_down_sample(0.04).without("normals")
room = room.select_by_mask(room.points[:, 2] < 2.2)
rng = np.random.default_rng(0)
outliers = loom.PointCloud(rng.uniform([-1, -1, 0], [6, 5, 3], (400, 3)), colors=np.full((400, 3), 0.5))
broken = loom.PointCloud(np.full((50, 3), np.nan), colors=np.full((50, 3), 0.5))
loom.write_point_cloud(folder / "scan.ply", loom.PointCloud.concatenate([room, outliers, broken]))


def shell(line, expected=0):
    """Run `pointloom LINE` in the folder and return its standard output. In a shell, enter the line unchanged."""
    print("$ pointloom", line)
    words = [sys.executable, "-m", "pointloom", *line.split()]
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == expected, done.stderr
    return done.stdout


# %%
# Inspect the file
# ----------------
# The report is available as text and as JSON.
facts = json.loads(shell("info scan.ply --json"))
print(json.dumps(facts, indent=1)[:600])

# %%
# Filter and downsample
# ---------------------
# All lengths are in the unit of the file, here meters.
print(shell("clean scan.ply clean.ply"))
print(shell("downsample clean.ply thin.ply --voxel 0.06"))
thin = loom.read_point_cloud(folder / "thin.ply")
assert np.isfinite(thin.points).all() and len(thin) < len(room)

# %%
# Planes and clusters
# -------------------
# ``pointloom plane`` labels the planes, and two lines of Python select the points on no plane. For a single plane,
# ``pointloom plane --invert`` does this. ``pointloom cluster`` finds the objects. ``--paint`` assigns a color to each.
print(shell("plane thin.ply planes.ply --distance 0.04 --planes 6 --min-points 400"))
planes = loom.read_point_cloud(folder / "planes.ply")
loom.write_point_cloud(folder / "things.ply", planes.select_by_mask(planes["plane"] < 0))
print(shell("cluster things.ply clusters.ply --radius 0.12 --paint"))
clusters = loom.read_point_cloud(folder / "clusters.ply")
assert 0 < len(clusters) < len(thin)

# %%
# Pipes
# -----
# ``-`` is standard input or standard output, so no intermediate files are needed. In a shell: ``cat scan.ply |
# pointloom clean - - --from ply --to ply | pointloom info - --from ply``
data = (folder / "scan.ply").read_bytes()
command = [sys.executable, "-m", "pointloom"]
cleaned = subprocess.run(
    [*command, "clean", "-", "-", "--from", "ply", "--to", "ply"], input=data, capture_output=True, check=True
)
assert cleaned.stdout == (folder / "clean.ply").read_bytes()
print(f"{len(data)} bytes in, {len(cleaned.stdout)} out: the same result as with files")

# %%
# Exit codes
# ----------
# The exit code is 0 on success, 1 for an error, 2 for wrong arguments, and 3 for an unreliable result. An existing
# output is not replaced without ``--force``.
shell("clean scan.ply clean.ply", expected=1)

# %%
# Image
# -----
# ``pointloom view clusters.ply --picture clusters.png`` renders an image without a display. The same from Python:
image = loom.render(clusters, loom.View.fit(clusters.points, direction=(-0.5, 0.62, -0.8), width=960, height=640))

# %%
# What to change
# --------------
# - ``--voxel`` [m]: 0.12 instead of 0.06 leaves about a quarter of the points.
# - ``--radius`` [m] of ``cluster``: 0.2 merges adjacent objects.
# - ``--planes``: the maximum number of planes.
#
# Next
# ----
# - :doc:`Command line </shell>`: common options and completion.
# - :doc:`When to trust a result </trust>`: exit code 3.

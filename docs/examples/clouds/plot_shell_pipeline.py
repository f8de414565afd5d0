"""
A pipeline in the shell
=======================

Most steps on clouds need no program: commands with files between them do, or pipes. Here a scan is cleaned,
thinned, its planes taken out and its objects told apart from the command line, and each command's report is read as
JSON. Exit codes say whether to go on.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

# %%
# A scan with some stray points and some that are not finite, as a file.
folder = Path(tempfile.mkdtemp())
room = loom.datasets.room_cloud().voxel_down_sample(0.04).without("normals")
room = room.select_by_mask(room.points[:, 2] < 2.2)
rng = np.random.default_rng(0)
stray = loom.PointCloud(rng.uniform([-1, -1, 0], [6, 5, 3], (400, 3)), colors=np.full((400, 3), 0.5))
broken = loom.PointCloud(np.full((50, 3), np.nan), colors=np.full((50, 3), 0.5))
loom.write_point_cloud(folder / "scan.ply", loom.PointCloud.concatenate([room, stray, broken]))


def shell(line, expected=0):
    """Run `pointloom LINE` in the folder; returns what it says on stdout. In a shell, type the line as it stands."""
    print("$ pointloom", line)
    words = [sys.executable, "-m", "pointloom", *line.split()]
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == expected, done.stderr
    return done.stdout


# %%
# What is in it? In words for the eye, as JSON for programs.
facts = json.loads(shell("info scan.ply --json"))
print(json.dumps(facts, indent=1)[:600])

# %%
# Without outliers, and one point every 6 cm. Lengths are in meters, as everywhere.
print(shell("clean scan.ply clean.ply"))
print(shell("downsample clean.ply thin.ply --voxel 0.06"))
thin = loom.read_point_cloud(folder / "thin.ply")
assert np.isfinite(thin.points).all() and len(thin) < len(room)

# %%
# The planes are labeled by the command, and two lines of Python keep what lies on none (for one plane alone,
# ``pointloom plane --invert`` does). Then what hangs together, each cluster in a color of its own (``--paint``).
print(shell("plane thin.ply planes.ply --distance 0.04 --planes 6 --min-points 400"))
planes = loom.read_point_cloud(folder / "planes.ply")
loom.write_point_cloud(folder / "things.ply", planes.select_by_mask(planes["plane"] < 0))
print(shell("cluster things.ply clusters.ply --radius 0.12 --paint"))
clusters = loom.read_point_cloud(folder / "clusters.ply")
assert 0 < len(clusters) < len(thin)

# %%
# **Pipes**: ``-`` is standard input or output, so that nothing lies in between. In a shell: ``cat scan.ply |
# pointloom clean - - --from ply --to ply | pointloom info - --from ply``
data = (folder / "scan.ply").read_bytes()
command = [sys.executable, "-m", "pointloom"]
cleaned = subprocess.run(
    [*command, "clean", "-", "-", "--from", "ply", "--to", "ply"], input=data, capture_output=True, check=True
)
assert cleaned.stdout == (folder / "clean.ply").read_bytes()
print(f"{len(data)} bytes in, {len(cleaned.stdout)} out: the same as by files")

# %%
# **Exit codes** guard a script: 0 done, 1 an error, 2 a wrong call, 3 done with an unreliable result. An existing
# output is not replaced without ``--force``.
shell("clean scan.ply clean.ply", expected=1)

# %%
# An image without a display ends the script: ``pointloom view clusters.ply --picture clusters.png``, or from Python:
image = loom.render(clusters, loom.View.fit(clusters.points, direction=(-0.5, 0.62, -0.8), width=960, height=640))

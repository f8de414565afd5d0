"""The number of threads does not change results bitwise: odometry, tracking, loops, fusion of submaps."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]

PROGRAM = f"""
import sys
sys.path.insert(0, {str(ROOT)!r})
import hashlib
import pytest
import pointloom as loom
from tests.rgbd.slam.slam_walks import begun, frame, frames, sequence

first, second = (loom.odometry.OdometryFrame(frame(k).depth, sequence().intrinsic, frame(k).color) for k in (0, 3))
pair = loom.odometry.align_frames(second, first)
slam = begun("cpu", submap_frames=3)
slam.run(frames(*range(7)))
tracked = slam.trajectory.poses.tobytes()
slam.close_loops()
mesh = slam.extract_triangle_mesh(0.0)
assert pair.reliable and len(mesh) > 100
for name, content in [
    ("pair", pair.transformation.tobytes() + pair.information.tobytes()), ("tracked", tracked),
    ("corrected", slam.trajectory.poses.tobytes()), ("mesh", mesh.vertices.tobytes() + mesh.triangles.tobytes()),
]:
    print(name, hashlib.sha256(content).hexdigest())
"""


@pytest.mark.slow
def test_the_number_of_threads_changes_no_bit_of_poses_and_surface():
    answers = []
    for threads in ("1", "2"):
        environment = os.environ | {"POINTLOOM_CPU_THREADS": threads, "PYTHONPATH": str(ROOT / "src")}
        done = subprocess.run(
            [sys.executable, "-c", PROGRAM], env=environment, stdout=subprocess.PIPE, text=True, check=True, timeout=300
        )
        answers.append(done.stdout.splitlines())
    assert len(answers[0]) == 4
    assert answers[0] == answers[1]

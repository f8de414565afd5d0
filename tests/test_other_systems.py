"""The package imports and computes without the functions of POSIX that Windows lacks."""

from __future__ import annotations

import importlib.util
import os
import subprocess
import sys

import pytest

from .test_imports import modules

# Modules of the standard library and of the dependencies are imported before the system is changed: they choose their
# code by the system at their import. Encodings that the locale chooses are errors, since that of Windows is not UTF-8.
PROGRAM = """
import asyncio, concurrent.futures.process, ctypes, http.server, importlib, logging.handlers, multiprocessing.managers
import multiprocessing.popen_spawn_posix, os, platform, shutil, signal, socket, sqlite3, ssl, subprocess, sys, tempfile
import urllib.request, webbrowser, xml.etree.ElementTree, zipfile
import click, numpy as np, PIL.Image, rich.console, rich.progress, scipy.optimize, scipy.sparse, scipy.spatial, warp
import warp._src.build, warp._src.codegen

POSIX = [
    "fork", "forkpty", "register_at_fork", "sched_getaffinity", "sched_setaffinity", "sysconf", "getuid", "geteuid",
    "getgid", "getpgid", "killpg", "setsid", "pread", "pwrite", "preadv", "statvfs", "fstatvfs", "uname", "mkfifo",
    "fchmod", "fchown", "chown", "nice", "getloadavg", "posix_fadvise", "O_CLOEXEC", "O_NOFOLLOW", "O_DIRECTORY",
    "O_NONBLOCK",
]
for name in ("fcntl", "resource", "pwd", "grp", "termios", "tty", "pty", "syslog", "readline"):
    sys.modules[name] = None
for name in POSIX:
    if hasattr(os, name):
        delattr(os, name)
for name in ("SIGKILL", "SIGHUP", "SIGPIPE", "SIGALRM", "SIGUSR1", "pause", "setitimer", "pthread_kill"):
    delattr(signal, name)
sys.platform, platform.system, platform.machine = "win32", lambda: "Windows", lambda: "AMD64"

for name in sys.argv[1:]:
    importlib.import_module(name)

import pointloom as loom
points = np.random.default_rng(0).random((1000, 3))
points[:, 2] = 0.1 * np.sin(6 * points[:, 0]) * np.cos(5 * points[:, 1])
cloud = loom.PointCloud(points).estimate_normals(radius=0.2, max_nn=30)
assert 50 < len(cloud.voxel_down_sample(0.1)) < 200
shift = np.eye(4)
shift[:3, 3] = 0.01, -0.008, 0.005
plane = loom.registration.TransformationEstimationPointToPlane()
result = loom.registration.registration_icp(cloud.transform(np.linalg.inv(shift)), cloud, 0.05, None, plane)
assert abs(result.transformation - shift).max() < 1e-5
with tempfile.TemporaryDirectory() as folder:
    loom.write_point_cloud(os.path.join(folder, "a.ply"), cloud)
    assert len(loom.read_point_cloud(os.path.join(folder, "a.ply"))) == 1000
print("threads", loom.core.threads.get_num_threads())
"""


@pytest.mark.slow
def test_every_module_imports_and_points_register_on_a_faked_windows():
    names = [f"pointloom.{path.removesuffix('.py').removesuffix('/__init__').replace('/', '.')}" for path in modules()]
    names = [name for name in names if not name.endswith(("__main__", "_worker"))]
    if importlib.util.find_spec("torch") is None:
        names = [name for name in names if not name.startswith("pointloom.torch.")]
    assert len(names) > 500
    environment = {name: value for name, value in os.environ.items() if not name.startswith("POINTLOOM_CPU")}
    options = ["-X", "warn_default_encoding", "-W", "error::EncodingWarning:pointloom"]
    command = [sys.executable, *options, "-c", PROGRAM, *names]
    done = subprocess.run(command, env=environment, capture_output=True, encoding="utf-8", timeout=300, check=False)
    assert (done.returncode, done.stdout) == (0, "threads 1\n"), done.stderr

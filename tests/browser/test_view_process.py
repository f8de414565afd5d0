"""`pointloom view` as users start it: a process with a page, until Ctrl-C."""

from __future__ import annotations

import os
import re
import signal
import socket
import subprocess
import sys
from pathlib import Path

import numpy as np

import pointloom as loom

from ..sigint import sigint_enabled
from .pixels import count_pixels, see
from .viewer_scenes import HEIGHT, RED, WIDTH, grid_cloud


def test_the_command_shows_a_file_until_ctrl_c(open_page, tmp_path):
    cloud = loom.PointCloud(grid_cloud().points, colors=np.tile(np.array(RED, np.uint8), (12**3, 1)))
    loom.write_point_cloud(tmp_path / "cloud.ply", cloud)
    command = [sys.executable, "-m", "pointloom", "view", str(tmp_path / "cloud.ply"), "--no-open", "--port", "0"]
    environment = os.environ | {"PYTHONPATH": str(Path(loom.__file__).parents[1])}
    environment.pop("SSH_CONNECTION", None)
    page = open_page("about:blank", width=WIDTH, height=HEIGHT, faults=False)  # it logs an error after Ctrl-C
    pipes = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    with sigint_enabled():
        process = subprocess.Popen(command, text=True, env=environment, **pipes)
    try:
        lines = []
        for line in process.stderr:  # until the process has ended, or is there
            lines.append(line)
            if match := re.search(r"viewer: (http://127\.0\.0\.1:(\d+)/\S*)", line):
                break
        assert match, lines
        page.goto(match[1])
        see(page, lambda image: count_pixels(image, RED) > 700)
        assert page.title() == "cloud.ply" and page.visit.faults == []
        process.send_signal(signal.SIGINT)
        output, rest = process.communicate(timeout=60)
        assert process.returncode == 130
    finally:
        process.kill()
        process.wait()
    assert output == ""
    lines += rest.splitlines()
    assert not [line for line in lines if "Traceback" in line or "Error" in line], lines
    with socket.socket() as free:
        free.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        free.bind(("127.0.0.1", int(match[2])))

"""`pointloom view` as people start it: a process with a page, until Ctrl-C."""

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

from .pixels import count_pixels, wait_for_picture, wait_until
from .viewer_scenes import HEIGHT, RED, WIDTH, grid_cloud

# A shell that starts the tests in the background has them, and all that they start, ignore Ctrl-C.
START = """import signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)
from pointloom.__main__ import main
sys.exit(main())"""


def test_the_command_shows_a_file_until_ctrl_c(open_page, tmp_path):
    cloud = loom.PointCloud(grid_cloud().points, colors=np.tile(np.array(RED, np.uint8), (12**3, 1)))
    loom.write_point_cloud(tmp_path / "cloud.ply", cloud)
    command = [sys.executable, "-c", START, "view", str(tmp_path / "cloud.ply"), "--no-open", "--port", "0"]
    environment = os.environ | {"PYTHONPATH": str(Path(loom.__file__).parents[1])}
    environment.pop("SSH_CONNECTION", None)
    said, answered = tmp_path / "stderr", tmp_path / "stdout"
    page = open_page("about:blank", width=WIDTH, height=HEIGHT, faults=False)  # it complains when its server has gone
    with answered.open("w") as out, said.open("w") as err:
        process = subprocess.Popen(command, stdout=out, stderr=err, stdin=subprocess.DEVNULL, env=environment)
    try:
        wait_until(page, lambda: "viewer: http" in said.read_text() or process.poll() is not None, said.read_text)
        found = re.search(r"viewer: (http://127\.0\.0\.1:(\d+)/\S*)", said.read_text())
        assert found, said.read_text()
        page.goto(found[1])
        wait_for_picture(page, lambda image: count_pixels(image, RED) > 700)
        assert page.title() == "cloud.ply" and page.visit.faults == []
        process.send_signal(signal.SIGINT)
        assert process.wait(60) == 130
    finally:
        process.kill()
        process.wait()
    assert answered.read_text() == ""
    lines = said.read_text().splitlines()
    assert not [line for line in lines if "Traceback" in line or "Error" in line], lines
    with socket.socket() as free:
        free.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        free.bind(("127.0.0.1", int(found[2])))

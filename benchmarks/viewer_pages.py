"""Cost of a scene in the browser: bytes transferred, CPU and memory of the server, until the page is idle.

    python benchmarks/viewer_pages.py [--only points-1M --only objects] [--with viser --with rerun]
                                      [--python viser=/venv/bin/python] [--pictures FOLDER] [--output FILE]

Each scene is served by a separate process and opened once in Chromium (software WebGL) through a proxy that counts
bytes. CPU and memory are those of the serving process alone, from before the scene is added until no byte was sent for
four seconds. Wall times and frame rates of software rendering are not meaningful and not measured. Baselines show the
same arrays with the calls of their documentation: viser 1.1's scene, rerun's web viewer. A baseline that is
installed in
another environment runs under another Python (`--python`).
"""

from __future__ import annotations

import argparse
import json
import shutil
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

QUIET, LONGEST = 4.0, 240.0  # [s]
FLAGS = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-gpu-rasterization"]

MADE = """
import numpy as np
rng = np.random.default_rng(0)
def wave(count):
    x, y = rng.random((2, count), np.float32) * 10
    return np.column_stack([x, y, np.sin(2 * x) * np.cos(3 * y) * 0.3]).astype(np.float32)
def paint(points):
    x, y, z = points.T
    return np.clip(np.column_stack([x * 25, y * 25, 128 + z * 300]), 0, 255).astype(np.uint8)
def sheet(k):
    x, y = np.mgrid[:k, :k].astype(np.float32) / k
    i = np.arange(k * k).reshape(k, k)
    a, b, c, d = i[:-1, :-1].ravel(), i[1:, :-1].ravel(), i[:-1, 1:].ravel(), i[1:, 1:].ravel()
    corners = np.stack([x, y, 0.05 * np.sin(20 * x) * np.cos(17 * y)], -1).reshape(-1, 3)
    return corners, np.concatenate([np.stack([a, b, c], 1), np.stack([b, d, c], 1)]).astype(np.int32)
"""
START = {
    "pointloom": "import pointloom as loom\nviewer = loom.Viewer(port=0)\nurl = viewer.url\n",
    "viser": "import viser\nserver = viser.ViserServer(host='127.0.0.1', port=PORT, verbose=False)\n"
    "url = f'http://127.0.0.1:{PORT}'\n",
    "rerun": "import rerun as rr\nrr.init('scene')\nuri = rr.serve_grpc(grpc_port=PORT)\n"
    "rr.serve_web_viewer(web_port=PORT + 1, open_browser=False, connect_to=uri)\n"
    "url = f'http://127.0.0.1:{PORT + 1}/?url={uri}'\n",
}
POINTS = {
    "pointloom": "viewer.add('cloud', loom.PointCloud(points, colors=colors))",
    "viser": "server.scene.add_point_cloud('/cloud', points, colors, point_size=0.01)",
    "rerun": "rr.log('cloud', rr.Points3D(points, colors=colors), static=True)",
}
OBJECTS = {
    "pointloom": """
box = loom.TriangleMesh.create_box(0.5, 0.5, 0.5)
def add(k): viewer.add(name(k), box, pose=at(k))
def move(k): viewer.set_pose(name(k), at(k))
""",
    "viser": """
handles = {}
def add(k): handles[k] = server.scene.add_box(name(k), dimensions=(0.5, 0.5, 0.5), position=at(k)[:3, 3])
def move(k): handles[k].position = at(k)[:3, 3] + 0.1
""",
    "rerun": """
def add(k): rr.log(name(k), rr.Boxes3D(half_sizes=[[0.25] * 3], centers=[at(k)[:3, 3]]), static=True)
def move(k): rr.log(name(k), rr.Transform3D(translation=at(k)[:3, 3]), static=True)
""",
}
MESHES = {
    "pointloom": "viewer.add('mesh', loom.TriangleMesh(corners, triangles))",
    "viser": "server.scene.add_mesh_simple('/mesh', corners, triangles)",
    "rerun": "rr.log('mesh', rr.Mesh3D(vertex_positions=corners, triangle_indices=triangles), static=True)",
}


def scenes() -> dict[str, dict[str, str]]:
    """The program that creates each scene, by contestant; the part after `# timed` is measured."""
    programs: dict[str, dict[str, str]] = {}
    for name, count in (("points-1M", 1_000_000), ("points-10M", 10_000_000)):
        head = f"points = wave({count})\ncolors = paint(points)\n# timed\n"
        programs[name] = {contestant: head + call for contestant, call in POINTS.items()}
    head = "corners, triangles = sheet(1582)\n# timed\n"
    programs["triangles-5M"] = {contestant: head + call for contestant, call in MESHES.items()}
    at = "def at(k):\n    T = np.eye(4)\n    T[:3, 3] = k % 100, k // 100 % 100, 0\n    return T\n"
    at += "def name(k): return f'boxes/{k // 100}/{k}'\n"
    report_code = (
        "import time\n# timed\ncosts = []\nfor k in range(COUNT):\n    t = time.process_time()\n    add(k)\n"
        "    costs.append(time.process_time() - t)\nt = time.process_time()\nfor k in range(100): move(k)\n"
        "told = {'add_first_100_ms': 10 * sum(costs[:100]), 'add_last_100_ms': 10 * sum(costs[-100:]),\n"
        "        'move_ms': 10 * (time.process_time() - t)}\n"
    )
    for name, count in (("objects-1k", 1000), ("objects-10k", 10_000)):
        programs[name] = {
            contestant: at + calls + "\n" + report_code.replace("COUNT", str(count))
            for contestant, calls in OBJECTS.items()
        }
    update = {
        "pointloom": "viewer.update('cloud', loom.PointCloud(points + k * 0.001, colors=colors))",
        "viser": "handle.points = points + np.float32(k * 0.001)",
        "rerun": "rr.log('cloud', rr.Points3D(points + np.float32(k * 0.001), colors=colors), static=True)",
    }
    first = POINTS | {"viser": f"handle = {POINTS['viser']}"}
    programs["updates-30Hz"] = {
        contestant: f"import time\npoints = wave(200_000)\ncolors = paint(points)\n{first[contestant]}\n"
        f"time.sleep(8)\n# timed\n"
        f"for k in range(300):\n    {call}\n    time.sleep(1 / 30)\n"
        for contestant, call in update.items()
    }
    return programs


def program(contestant: str, body: str, port: int) -> str:
    """A process that serves the scene: it prints its URL, creates the scene, and reports its costs on request."""
    head, timed = body.split("# timed\n")
    return f"""
import json, os, sys, time
answers = os.fdopen(os.dup(1), "w")
os.dup2(2, 1)  # what a peer prints is no answer
PORT = {port}
{MADE}
{START[contestant]}
told = {{}}
{head}
print(json.dumps(url), flush=True, file=answers)
sys.stdin.readline()
cpu = time.process_time()
{timed}
print(json.dumps(told), flush=True, file=answers)
sys.stdin.readline()
costs = {{"cpu_s": time.process_time() - cpu}}
status = dict(line.split(":", 1) for line in open("/proc/self/status"))
costs["peak_MB"] = int(status["VmHWM"].split()[0]) / 1024
print(json.dumps(costs), flush=True, file=answers)
sys.stdin.readline()
"""


class Proxy:
    """Forwards connections to a local port, and counts the bytes from there."""

    def __init__(self, port: int):
        self.port, self.bytes, self.last = port, 0, time.monotonic()
        self._server = socket.create_server(("127.0.0.1", 0))
        self.own = self._server.getsockname()[1]
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self) -> None:
        with suppress(OSError):
            while True:
                page, _ = self._server.accept()
                upstream = socket.create_connection(("127.0.0.1", self.port))
                threading.Thread(target=self._hand_on, args=(page, upstream, False), daemon=True).start()
                threading.Thread(target=self._hand_on, args=(upstream, page, True), daemon=True).start()

    def _hand_on(self, source: socket.socket, target: socket.socket, counted: bool) -> None:
        with suppress(OSError):
            while data := source.recv(1 << 16):
                if counted:
                    self.bytes += len(data)
                    self.last = time.monotonic()
                target.sendall(data)
        for one in (source, target):
            with suppress(OSError):
                one.shutdown(socket.SHUT_RDWR)

    def wait_until_quiet(self) -> None:
        """Wait until no data have arrived for a while."""
        end = time.monotonic() + LONGEST
        while time.monotonic() < end and time.monotonic() - self.last < QUIET:
            time.sleep(0.1)

    def close(self) -> None:
        """Stop accepting connections."""
        self._server.close()


@contextmanager
def opened(url: str, image: Path | None) -> Iterator[Any]:
    """Open the page in Chromium."""
    from playwright.sync_api import sync_playwright

    path = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=FLAGS, chromium_sandbox=False)
        page = browser.new_page(viewport={"width": 1280, "height": 800})
        page.goto(url, timeout=120_000, wait_until="commit")
        yield page
        if image is not None:
            with suppress(Exception):  # rendering may take minutes: the measurements are valid nevertheless
                page.screenshot(path=image, timeout=120_000)
        browser.close()


def measure(contestant: str, scene: str, body: str, python: str, images: Path | None) -> dict[str, Any]:
    """Measure one scene of one contestant."""
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    command = [python, "-W", "ignore", "-c", program(contestant, body, port)]
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    ) as process:
        assert process.stdin is not None and process.stdout is not None

        def query() -> Any:
            process.stdin.write("\n")
            process.stdin.flush()
            return json.loads(process.stdout.readline())

        try:
            url = json.loads(process.stdout.readline())
            server_port = int(url.split("//")[1].split("/")[0].split(":")[1])
            proxy = Proxy(server_port)
            seen = (
                url.replace(f":{server_port}/", f":{proxy.own}/", 1)
                if f":{server_port}/" in url
                else url.replace(str(server_port), str(proxy.own))
            )
            image = None if images is None else images / f"{scene}-{contestant}.png"
            with opened(seen, image):
                proxy.wait_until_quiet()
                page_bytes = proxy.bytes
                proxy.last = time.monotonic()
                figures = query()
                proxy.last = max(proxy.last, time.monotonic())
                proxy.wait_until_quiet()
                costs = query()
            proxy.close()
            return {
                "scene": scene, "who": contestant,
                "page_MB": page_bytes / 1e6, "scene_MB": (proxy.bytes - page_bytes) / 1e6,
                **costs, **figures,
            }  # fmt: skip
        finally:
            process.kill()


def main() -> None:
    """Measure, print one line of JSON for each, and a table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", action="append", help="a scene; default: all")
    parser.add_argument("--with", dest="peers", action="append", default=[], choices=("viser", "rerun"))
    parser.add_argument("--python", action="append", default=[], help="PEER=PATH")
    parser.add_argument("--pictures", type=Path)
    parser.add_argument("--output", type=Path)
    options = parser.parse_args()
    pythons = dict(entry.split("=", 1) for entry in options.python)
    rows = []
    for scene, bodies in scenes().items():
        if options.only and scene not in options.only:
            continue
        for contestant in ("pointloom", *options.peers):
            try:
                row = measure(
                    contestant, scene, bodies[contestant], pythons.get(contestant, sys.executable), options.images
                )
            except Exception as error:  # a failing contestant does not stop the others
                row = {"scene": scene, "who": contestant, "failed": f"{type(error).__name__}: {error}"[:200]}
            rows.append(row)
            print(json.dumps({key: round(v, 2) if isinstance(v, float) else v for key, v in row.items()}), flush=True)
    if options.output is not None:
        options.output.write_text(json.dumps(rows, indent=1) + "\n")


if __name__ == "__main__":
    main()

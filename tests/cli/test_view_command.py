"""view: images and pages of files, and the viewer's server."""

import json
import os
import re
import signal
import socket
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.visualization.viewer.detail_tree import DetailTree

from ..sigint import sigint_enabled
from .commands import answer, names_in, output_of, refusal, run

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def trajectory(tmp_path):
    poses = np.tile(np.eye(4), (4, 1, 1))
    poses[:, 0, 3] = np.arange(4) / 4
    loom.write_trajectory(tmp_path / "poses.log", loom.Trajectory(poses))
    return tmp_path / "poses.log"


def start(*words):
    environment = os.environ | {"PYTHONPATH": str(ROOT / "src"), "SSH_CONNECTION": "10.0.0.1 5 10.0.0.2 22"}
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    command = [sys.executable, "-m", "pointloom", "view", *map(str, words)]
    with sigint_enabled():
        return subprocess.Popen(command, env=environment, **pipes)


def red_pixels(path):
    red, green, blue = np.moveaxis(loom.read_color(path).astype(int), 2, 0)
    return ((red - green > 60) & (red - blue > 60)).sum()


@pytest.mark.slow
def test_the_up_axis_is_given_or_read_from_the_file(tmp_path):
    cone = loom.TriangleMesh.create_cone(0.5, 3.0)
    loom.write_triangle_mesh(tmp_path / "cone.glb", cone, up="z")
    loom.write_triangle_mesh(tmp_path / "cone.ply", loom.read_triangle_mesh(tmp_path / "cone.glb"))
    spans = {}
    for name, words in (("cone.glb", []), ("cone.ply", ["--up", "y"]), ("cone.ply", []), ("cone.glb", ["--up", "z"])):
        files = ["--screenshot", tmp_path / "a.png", "--save-html", tmp_path / "a.html", "--force"]
        answer("view", tmp_path / name, *words, *files)
        rows, columns = np.nonzero((loom.read_color(tmp_path / "a.png") != 255).any(axis=2))
        spans[name, *words] = np.ptp(rows) > 1.8 * np.ptp(columns)
    assert list(spans.values()) == [True, True, False, False]


def test_screenshots_and_pages_need_no_browser(cloud, mesh, trajectory, tmp_path):
    report = answer("view", cloud, mesh, trajectory, "--screenshot", tmp_path / "out.png")
    assert report["files"] == [str(tmp_path / "out.png")]
    kinds = {one["name"]: one["kind"] for one in report["geometries"]}
    assert kinds == {"cloud.ply": "PointCloud", "mesh.ply": "TriangleMesh", "poses.log": "Trajectory"}
    picture = loom.read_color(tmp_path / "out.png")
    assert picture.shape == (960, 1280, 3) and (picture < 250).any(axis=2).sum() > 10_000
    assert f"files    {tmp_path / 'out.html'}" in output_of("view", cloud, "--save-html", tmp_path / "out.html")
    assert (tmp_path / "out.html").read_text().startswith("<!doctype html>")


@pytest.mark.slow
def test_pictures_and_pages_need_no_server(cloud, tmp_path):
    words = ["pointloom", "view", str(cloud), "--screenshot", "a.png", "--save-html", "a.html"]
    program = f"import sys; sys.modules['websockets'] = None; sys.argv = {words}\n"
    program += "from pointloom.cli.shell.cli import main; main()"
    environment = os.environ | {"PYTHONPATH": str(ROOT / "src")}
    command, more = [sys.executable, "-c", program], {"capture_output": True, "text": True, "timeout": 300}
    done = subprocess.run(command, cwd=tmp_path, env=environment, **more)
    assert (done.returncode, done.stderr) == (0, "") and {"a.png", "a.html"} <= set(names_in(tmp_path))


def test_color_and_view_options_change_the_image(cloud, tmp_path):
    bounds = ([0, 0, 0], [1, 1, 1])
    loom.write_view(tmp_path / "view.json", loom.View.from_open3d(bounds, front=[0, 0, 1], up=[0, 1, 0]), bounds)
    images = []
    for k, words in enumerate(([], ["--color-by", "height", "--colormap", "jet"], ["--view", tmp_path / "view.json"])):
        answer("view", cloud, "--screenshot", tmp_path / f"{k}.png", *words)
        images.append(loom.read_color(tmp_path / f"{k}.png").tobytes())
    assert len(set(images)) == 3


def test_a_cloud_is_read_from_a_pipe(cloud, tmp_path):
    words = ["view", "-", "--from", "ply", "--color-by", "height", "--save-html", tmp_path / "a.html"]
    words += ["--screenshot", tmp_path / "a.png"]
    report = json.loads(run(*words, "--json", content=cloud.read_bytes()).stdout)
    assert report["inputs"] == ["standard input"]
    assert report["geometries"] == [{"name": "standard input", "kind": "PointCloud", "points": 500}]
    assert "standard input" in (tmp_path / "a.html").read_text()
    answer("view", cloud, "--color-by", "height", "--screenshot", tmp_path / "b.png")
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()
    result = run(*words, "--force", content=cloud.read_bytes()[:500])
    assert "error: standard input" in result.stderr and "truncated" in result.stderr


def test_without_websockets_the_install_command_is_printed_before_files_are_read(tmp_path, monkeypatch):
    loaded = ("websockets", "pointloom.visualization.viewer.link")
    for name in [name for name in sys.modules if name.startswith(loaded)]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "websockets", None)
    (tmp_path / "broken.ply").write_text("ply\n")
    refused = refusal("view", tmp_path / "broken.ply")
    assert refused.startswith("error: the viewer needs the package websockets") and "pip install websockets" in refused


def test_volumes_and_polygons_are_displayed(tmp_path, mesh):
    volume = loom.TSDFVolume(voxel_size=0.1)
    camera = loom.PinholeCameraIntrinsic(32, 24, 30, 30, 15.5, 11.5)
    volume.integrate(np.ones((24, 32), np.float32), camera, np.eye(4))
    volume.save(tmp_path / "volume.npz")
    polygon = loom.SelectionPolygonVolume([[0, 0, 0], [1, 0, 0], [1, 1, 0]], "Z", axis_min=0, axis_max=1)
    polygon.to_json(tmp_path / "cropped.json")
    files = tmp_path / "volume.npz", tmp_path / "cropped.json", mesh
    report = answer("view", *files, "--screenshot", tmp_path / "out.png")
    assert [one["kind"] for one in report["geometries"]] == ["TSDFVolume", "SelectionPolygonVolume", "TriangleMesh"]


@pytest.mark.slow
def test_a_large_cloud_is_read_in_levels_of_detail(tmp_path, rng):
    points, colors = rng.random((30_000, 3)), np.tile([[1.0, 0, 0]], (30_000, 1))
    loom.write_point_cloud(tmp_path / "large.ply", loom.PointCloud(points, colors=colors, intensity=points[:, 0]))
    words = ["view", tmp_path / "large.ply", "--max-points", 10_000, "--force", "--screenshot", tmp_path / "out.png"]
    assert answer(*words, "--save-html", tmp_path / "out.html")["geometries"][0]["points"] == 30_000
    assert red_pixels(tmp_path / "out.png") > 10_000 and (tmp_path / "out.html").stat().st_size < 600_000
    answer(*words, "--color-by", "intensity")
    assert red_pixels(tmp_path / "out.png") == 0


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (["missing.ply"], "missing.ply: does not exist"),
        (["."], "is a folder. Give its files"),
        (["broken.ply"], "broken.ply"),
        (["other.json"], "contains Other, which is not a geometry"),
        (["cloud.ply", "--color-by", "ring"], "no cloud here has 'ring'; there are rgb, height, x, y, intensity"),
        (["mesh.ply", "--color-by", "height"], "no cloud here has 'height'; there are no clouds"),
        (["cloud.ply", "--view", "other.json"], "other.json"),
        (["cloud.ply", "--save-html", "out.txt"], "ends in .html"),
        (["cloud.ply", "--screenshot", "cloud.png"], "cloud.png: exists already"),
    ],
)
def test_errors_are_one_line_and_nothing_is_written(cloud, mesh, tmp_path, monkeypatch, words, reason):
    monkeypatch.chdir(tmp_path)
    Path("notes.md").write_text("notes")
    Path("broken.ply").write_text("ply\nformat ascii 1.0\n")
    Path("other.json").write_text('{"class_name": "Other"}')
    Path("cloud.png").write_text("kept")
    before = names_in(tmp_path)
    output = [] if any(word.startswith("--s") for word in words) else ["--screenshot", "out.png"]
    message = refusal("view", *words, *output)
    assert message.startswith("error: ") and message.count("\n") == 1 and reason in message
    assert names_in(tmp_path) == before and Path("cloud.png").read_text() == "kept"


@pytest.mark.slow
def test_the_address_is_printed_to_stderr_and_ctrl_c_frees_the_port(cloud):
    with socket.create_server(("127.0.0.1", 0)) as line:
        port = line.getsockname()[1]
    process = start(cloud, "--port", port)
    address_line = process.stderr.readline()
    assert re.fullmatch(rf"viewer: http://127\.0\.0\.1:{port}/\?token=[\w-]+ \(Ctrl-C ends it\)\n", address_line)
    assert f"ssh -L {port}:127.0.0.1:{port} " in process.stderr.readline()
    with socket.create_connection(("127.0.0.1", port), timeout=5):
        pass
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=300)
    assert (process.returncode, out, err.strip()) == (130, "", "interrupted")
    with socket.create_server(("127.0.0.1", port)):
        pass


def test_a_large_file_is_displayed_while_it_is_read(tmp_path, rng, monkeypatch):
    loom.write_point_cloud(tmp_path / "large.ply", loom.PointCloud(rng.random((30_000, 3))))
    shown, waited = [], []

    def look(viewer, **options):
        shown.append({name: len(item.cloud) for name, item in viewer.items.items()})
        waited.append(options)

    add_named, open_tree = loom.Viewer.add_named, DetailTree.from_file
    viewers = []
    monkeypatch.setattr(loom.Viewer, "add_named", lambda self, *given: (viewers.append(self), add_named(self, *given)))
    monkeypatch.setattr(DetailTree, "from_file", lambda *some, **more: (look(viewers[0]), open_tree(*some, **more))[1])
    monkeypatch.setattr(loom.Viewer, "wait", look)
    result = run("view", tmp_path / "large.ply", "--max-points", 10_000, "--port", 0, "--no-open", "--keep-alive", 5)
    assert waited == [{}, {"keep_alive": 5.0}]
    assert result.exit_code == 0 and result.stderr.count("viewer: http://127.0.0.1:") == 1
    assert shown == [{"large.ply: a preview": 10_000}, {"large.ply": 30_000}]


@pytest.mark.slow
def test_json_prints_the_address_and_nothing_else(cloud):
    process = start(cloud, "--port", 0, "--json")
    assert process.stderr is not None and process.stderr.readline().startswith("viewer: ")
    lines = [process.stdout.readline()]  # printed while it serves, so that the caller can read the address
    while lines[-1].rstrip() != "}":
        lines.append(process.stdout.readline())
    process.send_signal(signal.SIGTERM)
    assert process.communicate(timeout=300)[0] == ""
    report = json.loads("".join(lines))
    assert report["url"].startswith("http://127.0.0.1:")
    assert report["geometries"] == [{"name": "cloud.ply", "kind": "PointCloud", "points": 500}]

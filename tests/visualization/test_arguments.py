"""Every argument of every public call of images, recordings and detail trees rejects invalid values by name."""

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pointloom as loom

from ..hostile import call_of, faults_of, faults_of_clouds, missing_from, public_arguments, read_table

CALLS = """
loom.render(geometries=cloud, camera=view, size=(16, 12), point_size=2.0, background=(1, 1, 1), shading="flat", labels=[("a", [0, 0, 0])], legend=[("a", (1, 0, 0))], color_bar=None, scale_bar=True, up="y", device="cpu")
loom.View(intrinsic=camera, T_world_camera=pose)
loom.View.from_open3d(bounds=bounds, zoom=0.7, front=[0, 0, 1.0], lookat=[0, 0, 0.0], up=[0, 1.0, 0], field_of_view=60.0, width=16, height=12)
view.to_open3d(bounds=bounds)
loom.View.fit(points=points, direction=(0, 1, 0), up=(0, 0, 1), width=16, height=12)
loom.read_view(path="view.json", width=16, height=12)
loom.write_view(path="view.json", view=view, bounds=bounds)
loom.write_image(path="picture.png", image=picture)
loom.CameraFrustum(intrinsic=camera, T_world_camera=pose, scale=0.2, color=(1, 0, 0))
loom.record(path="a.html", fps=10.0, size=(32, 24), max_points=100, max_frames=10, title="t", view=view, background=(1, 1, 1), progress=print)
loom.DetailTree.from_cloud(cloud=cloud)
loom.DetailTree.from_file(path="scan.ply", attributes=["label"], device="cpu", progress=None)
loom.DetailTree.sample(path="scan.ply", count=10)
tree.are_refined(nodes=[0])
tree.colors_of(indices=[0, 1])
tree.indices_of(i=0)
tree.node(i=0)
tree.pixels(view=view, lengths=tree.spacings)
tree.points_of(i=0)
tree.select(view=view, budget=100, counts=tree.counts, finest=0.5)
tree.fractions_in_view(view=view, nodes=[0])
"""  # noqa: E501
TABLE = read_table(CALLS, {"view": "View", "tree": "DetailTree"})
CASES = [(call, name) for call, (_, names) in TABLE.items() for name in names]


@cache
def things() -> dict[str, Any]:
    rng = np.random.default_rng(0)
    points, bounds = rng.random((60, 3)), ([0.0, 0.0, 0.0], [1.0, 1.0, 1.0])
    cloud = loom.PointCloud(points, colors=rng.random((60, 3)), label=np.arange(60, dtype=np.int32))
    return {
        "loom": loom, "cloud": cloud, "points": points, "bounds": bounds, "pose": np.eye(4),
        "tree": loom.DetailTree.from_cloud(cloud), "view": loom.View.from_open3d(bounds, width=16, height=12),
        "camera": loom.PinholeCameraIntrinsic(16, 12, 15.0, 15.0, 7.5, 5.5), "picture": np.zeros((12, 16, 3), np.uint8),
    }  # fmt: skip


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    loom.write_view("view.json", things()["view"], things()["bounds"])
    loom.write_point_cloud(Path("scan.ply"), things()["cloud"])


def test_the_table_names_every_argument_of_every_public_call():
    known = {"render", "write_image", "View", "read_view", "write_view", "CameraFrustum"}
    known |= {"record", "DetailTree"}
    assert missing_from(TABLE, public_arguments(loom, set(loom.__all__) - known)) == {}


@pytest.mark.parametrize("call", TABLE)
def test_the_good_arguments_are_taken(call):
    function, expressions = TABLE[call]
    eval(function, dict(things()))(**{name: eval(value, dict(things())) for name, value in expressions.items()})


@pytest.mark.parametrize(("call", "argument"), CASES)
def test_a_hostile_value_is_refused_by_name(call, argument):
    function, expressions = TABLE[call]
    good = {name: eval(expression, dict(things())) for name, expression in expressions.items()}
    also = {"geometries": "points", "bounds": "zoom"}.get(argument, "")
    clouds = argument == "cloud"
    faults = faults_of(call_of(function, things()), good, argument, also=also, clouds=clouds)
    assert not faults, "\n".join(faults)


def test_a_hostile_cloud_has_a_tree_without_a_warning():
    faults = faults_of_clouds(TABLE["DetailTree.from_cloud"], ("cloud", "other"), things())
    assert not faults, "\n".join(faults)

"""create_surface: the surface of `pointloom mesh` for a cloud in memory, and its report."""

import json

import numpy as np
import pytest
import warp as wp

import pointloom as loom
from pointloom.cli.jobs.mesh import mesh_file
from pointloom.core.wording import json_text


def ball(count: int = 1500, **attributes) -> loom.PointCloud:
    points = np.random.default_rng(0).normal(size=(count, 3))
    return loom.PointCloud(points / np.linalg.norm(points, axis=1, keepdims=True), **attributes)


@pytest.mark.parametrize(
    "settings", [{"depth": 4}, {"method": "ball"}, {"method": "alpha", "alpha": 2.0}], ids=["poisson", "ball", "alpha"]
)
def test_a_cloud_in_memory_gives_the_result_and_report_of_its_file(tmp_path, device, settings):
    loom.write_point_cloud(tmp_path / "ball.ply", ball(intensity=np.arange(1500.0, dtype=np.float32)))
    report = mesh_file(tmp_path / "ball.ply", tmp_path / "out.ply", device=device, **settings)
    result = loom.create_surface(loom.read_point_cloud(tmp_path / "ball.ply", device=device), **settings)
    written = loom.read_triangle_mesh(tmp_path / "out.ply")
    np.testing.assert_array_equal(written.vertices, result.mesh.vertices)
    np.testing.assert_array_equal(written.triangles, result.mesh.triangles)
    shared = json.loads(json_text(result.to_dict()))
    assert shared == {key: json.loads(json_text(report.to_dict()))[key] for key in shared}
    assert shared["not_carried"] == ["intensity"]
    fields = {label: value for label, value in report.fields() if label not in ("seconds", "files")}
    assert [line.split(maxsplit=1)[0] for line in str(result).splitlines()] == [label.split()[0] for label in fields]
    assert all(value in str(result) for value in fields.values())


def test_stages_are_reported_at_their_start():
    stages = []
    loom.create_surface(ball(), "ball", progress=lambda *stage: stages.append(stage))
    assert stages == [("normals", 0, 0), ("ball", 0, 0), ("check", 0, 0)]


def test_the_remedy_names_the_python_argument(recwarn):
    points = ball().points
    mixed = loom.PointCloud(points, normals=points * np.where(np.arange(1500) % 3 == 0, -1, 1)[:, None])
    result = loom.create_surface(mixed, depth=4)
    assert str(result).splitlines()[-1].split(maxsplit=1) == ["warning", result.warnings[-1]]
    assert result.normals.given and "new_normals" in str(result.warnings)
    assert not recwarn.list
    assert loom.create_surface(mixed, depth=4, new_normals=True).reliable


@pytest.mark.parametrize("method", ["poisson", "ball", "alpha"])
def test_without_a_finite_point_there_is_no_surface_and_no_error(method, device):
    for points in (np.full((4, 3), np.nan), np.zeros((0, 3))):
        result = loom.create_surface(loom.PointCloud(points, device=device), method)
        assert len(result.mesh) == 0 and result.warnings == ("no point is finite, so there is no surface",)
        assert (result.points_in, result.points, result.to_dict()["bounds"]) == (len(points), 0, None)
        assert result.mesh.device == loom.PointCloud(points, device=device).device


@pytest.mark.parametrize("tilt", [0, 0.3])
def test_no_alpha_is_advised_for_a_flat_cloud(tilt, recwarn):
    x, y = np.mgrid[0:1:12j, 0:1:12j].reshape(2, -1)
    result = loom.create_surface(loom.PointCloud(np.column_stack([x, y, tilt * x])), "alpha")
    assert len(result.mesh) == 0 and not recwarn.list
    text = str(result.warnings)
    assert "one plane" in text and "larger" not in text and "ball" in text


def test_the_mesh_has_the_arrays_of_the_cloud():
    cloud = loom.PointCloud(wp.array(ball().points.astype(np.float32), device="cpu"))
    result = loom.create_surface(cloud, depth=4)
    assert isinstance(result.mesh.cluster_connected_triangles()[0], wp.array)
    plain = loom.create_surface(cloud.to("cpu", arrays="numpy"), depth=4)
    np.testing.assert_array_equal(result.mesh.vertices, plain.mesh.vertices)
    assert result.to_dict() == plain.to_dict()

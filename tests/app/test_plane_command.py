"""plane: what lies on one plane, labels of several, and clouds without any."""

import numpy as np

import pointloom as loom

from .commands import answer, names_in, poor_answer, run
from .toolbox_scene import FIRST_BLOB, FLOOR, NOT_FINITE, REPEATED, SECOND_BLOB, STRAY, rows_of


def test_plane_writes_what_lies_on_it(scene, points, tmp_path, device):
    words = ["plane", scene, tmp_path / "out.npz", "--distance", "0.01", "--device", device]
    report = answer(*words)
    (found,) = report["planes"]
    model, inliers = loom.PointCloud(points, device=device).segment_plane(0.01, num_iterations=1000)
    assert rows_of(tmp_path / "out.npz") == inliers.tolist() == [*FLOOR, REPEATED]
    np.testing.assert_array_equal(found["model"], model)
    np.testing.assert_allclose(model, [0, 0, 1, 0], atol=1e-12)
    assert (report["points"], found["points"], found["share"]) == (601, 601, 601 / 852)
    answer(*words, "--invert", "--force")
    assert rows_of(tmp_path / "out.npz") == [*FIRST_BLOB, *SECOND_BLOB, STRAY, NOT_FINITE]
    shown = run(*words, "--force").stdout
    assert "0.000000000 0.000000000 1.000000000 0.000000: 601 points, 70.5%" in shown


def test_plane_labels_several(tmp_path, rng):
    floor = np.column_stack([rng.random((500, 2)), np.zeros(500)])
    wall = np.column_stack([np.zeros(300), rng.random((300, 2)) + 0.1])
    points = np.vstack([floor, wall, rng.random((40, 3)) + 0.2]) + np.array([5e5, 5e6, 100])
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud(points, plane=np.ones(840)))
    words = ["plane", tmp_path / "a.ply", tmp_path / "b.ply", "--distance", "0.005", "--planes", "5"]
    report = answer(*words)
    labels = loom.read_point_cloud(tmp_path / "b.ply")["plane"]
    assert labels.dtype == np.int32
    assert [(labels == label).sum() >= count for label, count in ((0, 500), (1, 300), (-1, 30))] == [True] * 3
    assert report["replaced"] == ["plane"]
    assert report["on_none"] == (labels == -1).sum()
    assert [plane["points"] for plane in report["planes"]] == np.bincount(labels[labels >= 0]).tolist()
    for plane, part in zip(report["planes"], (points[:500], points[500:800]), strict=True):
        a, b, c, d = plane["model"]
        assert np.abs(part @ [a, b, c] + d).max() < 0.005  # in the coordinates of the file
    assert len(answer(*words, "--min-points", "400", "--force")["planes"]) == 1
    assert len(answer(*words[:-1], "1", "--force")["planes"]) == 1
    shown = run(*words, "--force").stdout
    assert f"840, {report['on_none']} of them on no plane" in shown
    assert "plane of the input" in shown


def test_the_seed_of_planes_chooses_the_samples(cloud, tmp_path):
    words = ["plane", cloud, tmp_path / "out.ply", "--distance", "0.02", "--iterations", "20", "--force"]
    models = [answer(*words, "--seed", seed)["planes"][0]["model"] for seed in (1, 1, 2)]
    assert models[0] == models[1] != models[2]


def test_a_cloud_without_a_plane_is_a_poor_result(cloud, tmp_path):
    report = poor_answer("plane", cloud, tmp_path / "out.ply", "--distance", "1e-6")
    assert "the largest plane has only" in report["poor"]
    assert report["points"] == len(loom.read_point_cloud(tmp_path / "out.ply"))
    report = poor_answer("plane", cloud, tmp_path / "out.ply", "--distance", "1e-6", "--planes", "2", "--force")
    assert "no plane has 100 points within 1e-06 m" in report["poor"]
    assert (loom.read_point_cloud(tmp_path / "out.ply")["plane"] == -1).all()
    report = poor_answer("plane", cloud, tmp_path / "b.ply", "--distance", "9", "--invert")
    assert "all points lie on the plane" in report["poor"]
    line = np.column_stack([np.arange(50), np.zeros((50, 2))])
    loom.write_point_cloud(tmp_path / "line.ply", loom.PointCloud(line))
    assert "lie on lines" in poor_answer("plane", tmp_path / "line.ply", tmp_path / "b.ply", "--distance", "1")["poor"]
    assert "b.ply" not in names_in(tmp_path)

"""cluster: the library's labels, what is kept and painted, and which eps it proposes."""

import numpy as np

import pointloom as loom
from pointloom.app.jobs.cluster import TAB20

from .commands import answer, poor_answer, refusal, run
from .toolbox_scene import FIRST_BLOB, FLOOR, REPEATED, SECOND_BLOB, STRAY, rows_of


def test_cluster_labels_are_the_library_s(scene, points, tmp_path, device):
    output = tmp_path / "out.npz"
    report = answer("cluster", scene, output, "--radius", "0.2", "--device", device)
    labels = loom.read_point_cloud(output)["label"]
    assert labels.dtype == np.int32
    np.testing.assert_array_equal(labels, loom.PointCloud(points).cluster_dbscan(0.2, 10))
    assert [np.unique(labels[part]).tolist() for part in (FLOOR, FIRST_BLOB, SECOND_BLOB)] == [[0], [1], [2]]
    assert (report["clusters"], report["noise"], report["replaced"]) == (3, 2, [])
    sizes = [(cluster["label"], cluster["points"]) for cluster in report["largest"]]
    assert sizes == [(0, 601), (1, 150), (2, 100)]
    shown = run("cluster", scene, output, "--radius", "0.2", "--force").stdout
    assert "601 (label 0), 150 (label 1), 100 (label 2)" in shown
    assert "2 of 853 points, 0.2%" in shown


def test_cluster_keeps_the_largest_under_their_own_labels(scene, tmp_path):
    report = answer("cluster", scene, tmp_path / "out.npz", "--radius", "0.2", "--largest", "2")
    assert report["points"] == 751
    found = loom.read_point_cloud(tmp_path / "out.npz")
    assert np.unique(found["label"]).tolist() == [0, 1]
    assert found["row"].tolist() == [*FLOOR, *FIRST_BLOB, REPEATED]
    # the largest are those of the most points, whatever their labels
    words = [
        "cluster",
        tmp_path / "out.npz",
        tmp_path / "b.npz",
        "--radius",
        "0.2",
        "--neighbors",
        "1",
        "--largest",
        "1",
    ]
    assert answer("crop", scene, tmp_path / "out.npz", "--force", "--box", 0, 0, 0.1, 1, 1, 9)["points"] == 250
    loom.write_point_cloud(
        tmp_path / "out.npz", loom.read_point_cloud(tmp_path / "out.npz").select_by_index(range(249, -1, -1))
    )
    assert answer(*words)["largest"][0] == {"label": 1, "points": 150}
    assert sorted(rows_of(tmp_path / "b.npz")) == [*FIRST_BLOB]


def test_cluster_paints_labels_and_noise(scene, tmp_path):
    report = answer("cluster", scene, tmp_path / "out.npz", "--radius", "0.2", "--paint")
    assert report["replaced"] == ["colors"]
    found = loom.read_point_cloud(tmp_path / "out.npz")
    expected = np.vstack([TAB20 / 255, np.zeros(3)]).astype(np.float32)[found["label"]]
    np.testing.assert_array_equal(found.colors, expected)
    assert not found.colors[STRAY].any()
    assert len(np.unique(TAB20, axis=0)) == 20
    shown = run("cluster", tmp_path / "out.npz", tmp_path / "b.xyzrgb", "--radius", "0.2", "--paint").stdout
    assert "colors, label of the input" in shown
    assert len(loom.read_point_cloud(tmp_path / "b.xyzrgb")) == 853


def test_cluster_wants_a_format_that_holds_what_it_finds(scene, tmp_path):
    for suffix, options, reason in ((".xyzrgb", [], "labels are not"), (".xyz", ["--paint"], "labels or colours")):
        assert reason in refusal("cluster", scene, tmp_path / f"out{suffix}", "--radius", "0.2", *options)


def test_cluster_proposes_an_eps_where_all_is_noise(scene, tmp_path):
    words = ["cluster", scene, tmp_path / "out.npz", "--radius"]
    report = poor_answer(*words, "0.0001")
    assert (report["clusters"], report["noise"], report["points"]) == (0, 853, 853)
    better = report["poor"].split("as many within ")[1].split(" m")[0]
    report = answer(*words, better, "--force")
    assert report["noise"] < 427  # half of the points are cores then
    report = poor_answer(*words, "0.0001", "--largest", "1", "--force")
    assert (report["points"], report["files"]) == (0, [])
    assert "fewer --neighbors" in poor_answer(*words, "0.2", "--neighbors", "900", "--force")["poor"]


def test_cluster_proposes_an_eps_where_one_cluster_holds_everything(scene, tmp_path):
    words = ["cluster", scene, tmp_path / "out.npz", "--radius"]
    report = poor_answer(*words, "100")
    assert report["files"] == [str(tmp_path / "out.npz")]
    assert "one cluster holds all 852 finite points" in report["poor"]
    better = report["poor"].split("such as ")[1]
    assert answer(*words, better, "--force")["clusters"] == 3

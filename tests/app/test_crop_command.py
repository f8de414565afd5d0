"""crop: boxes and polygons."""

import pointloom as loom

from .commands import answer, names_in, poor_answer, refusal
from .toolbox_scene import FIRST_BLOB, FLOOR, NOT_FINITE, REPEATED, SECOND_BLOB, STRAY, rows_of


def test_crop_keeps_what_lies_in_the_box(scene, tmp_path, device):
    words = ["crop", scene, tmp_path / "out.npz", "--force", "--device", device, "--box"]
    answer(*words, 0, 0, 0.1, 0.5, 0.5, 1)
    assert rows_of(tmp_path / "out.npz") == [*FIRST_BLOB]
    answer(*words, "-inf", "-inf", 0.1, "inf", "inf", "inf")
    assert rows_of(tmp_path / "out.npz") == [*FIRST_BLOB, *SECOND_BLOB, STRAY]
    answer(*words, "-inf", "-inf", 0.1, "inf", "inf", "inf", "--invert")
    assert rows_of(tmp_path / "out.npz") == [*FLOOR, REPEATED, NOT_FINITE]


def test_crop_takes_a_polygon_of_open3d(scene, points, tmp_path, device):
    corners = [[0.5, 0.5, 0], [1, 0.5, 0], [1, 1, 0], [0.5, 1, 0]]
    volume = loom.SelectionPolygonVolume(corners, "Z", axis_min=0.1, axis_max=1)
    volume.to_json(tmp_path / "volume.json")
    words = ["crop", scene, tmp_path / "out.npz", "--polygon", tmp_path / "volume.json", "--device", device, "--force"]
    answer(*words)
    assert rows_of(tmp_path / "out.npz") == [*SECOND_BLOB]
    assert answer(*words, "--invert")["points"] == len(points) - 100
    (tmp_path / "volume.json").write_text("{}")
    assert refusal(*words).startswith(f"error: {tmp_path / 'volume.json'}")


def test_a_crop_that_leaves_nothing_is_a_poor_result(scene, tmp_path):
    report = poor_answer("crop", scene, tmp_path / "out.npz", "--box", 20, 20, 20, 30, 30, 30)
    assert report["files"] == []
    assert "to [9.0000, 9.0000, 9.0000]" in report["poor"]  # where the points are
    assert names_in(tmp_path) == ["scene.npz"]

"""sample: each way to choose points, and what the command tells of it."""

import numpy as np
import pytest

import pointloom as loom

from .commands import answer, names_in, poor_answer, refusal, run
from .toolbox_scene import rows_of


@pytest.mark.parametrize(
    ("options", "choose"),
    [
        (["--every", "7"], lambda cloud: cloud.uniform_down_sample(7)),
        (["--ratio", "0.25"], lambda cloud: cloud.random_down_sample(0.25)),
        (["--ratio", "0.25", "--seed", "5"], lambda cloud: cloud.random_down_sample(0.25, seed=5)),
        (["--farthest", "20"], lambda cloud: cloud.farthest_point_down_sample(20)),
        (["--voxel", "0.3", "--nearest"], lambda cloud: cloud.voxel_down_sample(0.3, "nearest")),
    ],
)
def test_sample_chooses_as_the_library_does(scene, points, tmp_path, device, options, choose):
    report = answer("sample", scene, tmp_path / "out.npz", *options, "--device", device)
    expected = choose(loom.PointCloud(points, device=device, row=np.arange(len(points))))["row"].tolist()
    assert rows_of(tmp_path / "out.npz") == expected
    assert report["points"] == len(expected)


def test_sample_writes_the_means_of_voxels(scene, tmp_path, device):
    report = answer("sample", scene, tmp_path / "out.npz", "--voxel", "0.3", "--device", device)
    expected = loom.read_point_cloud(scene, device=device).voxel_down_sample(0.3)
    found = loom.read_point_cloud(tmp_path / "out.npz")
    assert report["points"] == len(expected)
    for name in ("points", "colors", "normals", "time"):
        np.testing.assert_array_equal(found[name], expected[name])


@pytest.mark.parametrize(
    ("options", "way"),
    [
        ("--every 2", "427 of 853, one in 2"),
        ("--ratio 0.5 --seed 3", "426 of 853, a share of 0.5 at random, seed 3"),
        ("--farthest 5", "5 of 853, the farthest from each other"),
        ("--voxel 90", "1 of 853, one a voxel of 90 m, the mean"),
        ("--voxel 90 --nearest", "1 of 853, one a voxel of 90 m, the nearest to the mean"),
    ],
)
def test_sample_says_how_it_chose(scene, tmp_path, options, way):
    assert way in run("sample", scene, tmp_path / "out.ply", *options.split()).stdout


def test_farthest_points_begin_at_a_finite_one_and_are_not_more_than_there_are(tmp_path):
    points = [[np.nan, 0, 0], [0, 0, 0], [1, 0, 0], [5, 0, 0]]
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud(points, row=np.arange(4, dtype=np.int32)))
    words = ["sample", tmp_path / "a.ply", tmp_path / "b.ply", "--force", "--farthest"]
    answer(*words, 2)
    assert rows_of(tmp_path / "b.ply") == [1, 3]
    assert answer(*words, 3)["points"] == 3
    assert "a.ply: has 3 finite points, of which 4 cannot be chosen" in refusal(*words, 4)


def test_a_share_below_one_point_is_a_poor_result(cloud, tmp_path):
    assert poor_answer("sample", cloud, tmp_path / "out.ply", "--ratio", "1e-6")["files"] == []
    assert names_in(tmp_path) == ["cloud.ply"]

"""Clusters through any number of tiles have the labels of one machine."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.files.points.las_writer import write_las
from pointloom.files.table import PointTable
from pointloom.scale import tasks

from .scenes import CORNER, STEP, finished, in_memory, survey, tiled, whole_cloud

DBSCAN = {"step": "cluster_dbscan", "eps": 0.9, "min_points": 5}
EUCLIDEAN = {"step": "cluster_euclidean", "tolerance": 0.7, "min_cluster_size": 2}


def labels_in_memory(cloud, step):
    params = {name: value for name, value in step.items() if name != "step"}
    cloud = cloud.copy()
    cloud["cluster"] = getattr(cloud, step["step"])(**params)
    return cloud


def labelled(cloud):
    """Rows of position, label and what tells a point from its twin, sorted."""
    columns = [np.rint((cloud.points - cloud.origin) / STEP).astype(np.int64), np.asarray(cloud["cluster"])[:, None]]
    if "gps_time" in cloud.attributes:
        columns.append(np.asarray(cloud["gps_time"], np.float64)[:, None].view(np.int64))
    rows = np.column_stack(columns)
    return rows[np.lexsort(rows.T)]


def check(paths, steps, folder, **how):
    """Hold that tiles give the labels of one machine; those labels."""
    found, plan = tiled(paths, steps, folder, **how)
    cloud = whole_cloud(paths, np.array(plan["origin"]))
    cloud = in_memory(cloud, steps[:-1], plan["voxel_corner"])
    expected = labels_in_memory(cloud, steps[-1])
    np.testing.assert_array_equal(labelled(found), labelled(expected))
    assert np.asarray(found["cluster"]).dtype == np.int32
    return np.asarray(expected["cluster"])


def write(folder, points, files=1):
    """Points in files, in their order."""
    paths = []
    for number, rows in enumerate(np.array_split(np.asarray(points, np.float64) + CORNER, files)):
        paths.append(folder / f"part{number}.laz")
        write_las(paths[-1], PointTable(rows), scale=STEP, offset=CORNER)
    return paths


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    return survey(tmp_path_factory.mktemp("survey"), count=3000)


@pytest.mark.parametrize("size", [6.1, 10.0, 100.0])
@pytest.mark.parametrize("step", [DBSCAN, EUCLIDEAN], ids=lambda step: step["step"])
def test_labels_of_tiles_of_any_size_are_those_of_one_machine(files, tmp_path, step, size):
    labels = check(files, [step], tmp_path / "job", size=size)
    assert labels.max() > 20
    assert (labels < 0).any()


def test_labels_after_other_steps_are_those_of_one_machine(files, tmp_path):
    steps = [
        {"step": "remove_statistical_outlier", "nb_neighbors": 8, "std_ratio": 2.0},
        {"step": "voxel_down_sample", "voxel_size": 0.4},
        {"step": "cluster_dbscan", "eps": 0.7, "min_points": 3},
    ]
    labels = check(files, steps, tmp_path / "job", size=14.0)
    assert labels.max() > 10


def test_a_spiral_through_all_tiles_is_one_cluster(tmp_path):
    turn = np.sqrt(np.linspace(1, 400, 3000)) * 2 * np.pi * 0.45
    points = np.column_stack([20 + 0.3 * turn * np.cos(turn), 20 + 0.3 * turn * np.sin(turn), np.zeros(len(turn))])
    paths = write(tmp_path, np.random.default_rng(1).permutation(points), files=3)
    for size in (3.0, 9.0):
        labels = check(
            paths, [{"step": "cluster_dbscan", "eps": 0.4, "min_points": 3}], tmp_path / f"{size}", size=size
        )
        assert labels.max() == 0


def test_clusters_that_meet_at_a_corner_alone_are_one(tmp_path):
    ramp = np.arange(0, 20.01, 0.25)
    diagonal = np.column_stack([ramp, ramp, np.zeros(len(ramp))])
    ends = [[0, 0, 0], [20, 20, 0], [0, 20, 9]]
    paths = write(tmp_path, np.concatenate([ends, diagonal[::-1]]))
    for size in (5.0, 2.5):
        labels = check(
            paths, [{"step": "cluster_dbscan", "eps": 0.36, "min_points": 2}], tmp_path / f"{size}", size=size
        )
        assert labels.max() == 0
        assert (labels == -1).sum() == 1


def test_a_border_point_between_clusters_takes_the_one_of_the_lowest_row(tmp_path):
    """The middle point, on a tile's border, is as near to a core on the left as to one on the right."""
    side = np.array([[0.0, 0, 0], [-0.2, 0, 0], [-0.2, 0.2, 0], [-0.3, 0.1, 0]])
    left, right = side + np.array([9.1, 5, 0]), side * np.array([-1, 1, 1]) + np.array([10.9, 5, 0])
    far = [[0, 0, 0], [20, 10, 0]]
    for number, points in enumerate([(left, right), (right, left)]):
        folder = tmp_path / str(number)
        folder.mkdir()
        middle = [[10.0, 5, 0]]
        paths = write(folder, np.concatenate([far, middle, *points]))
        step = {"step": "cluster_dbscan", "eps": 0.95, "min_points": 4}
        for size in (10.0, 0.9, 40.0):
            labels = check(paths, [step], folder / f"{size}", size=size)
            assert labels.tolist() == [-1, -1, 0, 0, 0, 0, 0, 1, 1, 1, 1]


def test_reaches_larger_than_tiles_and_twins_of_other_files(files, tmp_path):
    labels = check(files, [{"step": "cluster_dbscan", "eps": 3.0, "min_points": 40}], tmp_path / "job", size=2.0)
    assert labels.max() >= 0
    assert (labels < 0).any()


def test_sizes_bound_connected_parts(files, tmp_path):
    bounded = EUCLIDEAN | {"min_cluster_size": 3, "max_cluster_size": 40}
    labels = check(files, [bounded], tmp_path / "job", size=9.0)
    assert labels.max() > 5
    assert np.bincount(labels[labels >= 0]).min() == 3
    assert np.bincount(labels[labels >= 0]).max() <= 40


def test_parts_of_an_array_job_join_what_all_of_them_left(files, tmp_path):
    """A part ends where it needs the others' tiles; whoever comes when all are through a pass joins it, once."""
    loom.scale.plan_tiles(files, [DBSCAN], tmp_path / "job", size=11.0)
    for part in ((1, 3), (2, 3), (3, 3)):
        assert loom.scale.run_tiles(tmp_path / "job", part=part).done < 16
    waiting = loom.scale.tile_status(tmp_path / "job").waiting
    assert waiting > 0
    with pytest.raises(loom.FileError, match="is not finished"):
        loom.scale.finish_tiles(tmp_path / "job")
    assert loom.scale.run_tiles(tmp_path / "job", workers=2).is_finished
    found = finished(tmp_path / "job")
    cloud = whole_cloud(files, found.origin)
    np.testing.assert_array_equal(labelled(found), labelled(labels_in_memory(cloud, DBSCAN)))
    assert not (tmp_path / "job" / "left").exists() and not (tmp_path / "job" / "joined").exists()


def test_what_a_tile_left_is_held_against_the_manifest(files, tmp_path, monkeypatch):
    loom.scale.plan_tiles(files, [DBSCAN], tmp_path / "job", size=20.0)
    join = tasks.join_step

    def spoiled(folder, number, step, left, owner):
        path = folder / "left" / str(number) / f"{left.tiles[0]}.npy"
        path.write_bytes(path.read_bytes()[:-100])
        return join(folder, number, step, left, owner)

    with monkeypatch.context() as patch:
        patch.setattr(tasks, "join_step", spoiled)
        with pytest.raises(loom.FileError, match=r"what tiles left in pass 1 cannot be joined: .*npy: is damaged"):
            loom.scale.run_tiles(tmp_path / "job")
    assert loom.scale.tile_status(tmp_path / "job").waiting == 9

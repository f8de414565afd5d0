"""Clusters across any number of tiles have the labels of a single machine."""

import os
import signal
import subprocess
import sys

import numpy as np
import pytest

import pointloom as loom
from pointloom.io.points.las_writer import write_las
from pointloom.io.table import PointTable
from pointloom.kernels.lang import int32, vec3
from pointloom.kernels.memory import download, full, upload
from pointloom.kernels.search.point_tree import PointTree
from pointloom.kernels.segmentation.border_labels import label_borders
from pointloom.kernels.segmentation.cluster_labels import NOISE_LABEL, rename_cores
from pointloom.kernels.segmentation.dbscan import cluster_cores
from pointloom.tiling import label_join, tasks
from pointloom.tiling.status import tile_status
from pointloom.tiling.steps import parse

from .scenes import CORNER, STEP, finished, in_memory, plan_of, read_cloud, survey, tiled

DBSCAN = {"step": "cluster_dbscan", "eps": 0.9, "min_points": 5}
EUCLIDEAN = {"step": "cluster_euclidean", "tolerance": 0.7, "min_cluster_size": 2}


def labels_in_memory(cloud, step):
    params = {name: value for name, value in step.items() if name != "step"}
    cloud = cloud.copy()
    cloud["cluster"] = getattr(cloud, step["step"])(**params)
    return cloud


def labeled(cloud):
    """Sorted rows of position, label and time, which distinguishes coincident points."""
    columns = [np.rint((cloud.points - cloud.origin) / STEP).astype(np.int64), np.asarray(cloud["cluster"])[:, None]]
    if "gps_time" in cloud.attributes:
        columns.append(np.asarray(cloud["gps_time"], np.float64)[:, None].view(np.int64))
    rows = np.column_stack(columns)
    return rows[np.lexsort(rows.T)]


def check(paths, steps, folder, device="cpu", dtype=np.int32, **options):
    """Check that tiles give the labels of a single machine; return these labels."""
    result, plan = tiled(paths, steps, folder, device, **options)
    cloud = read_cloud(paths, np.array(plan["origin"]))
    cloud = in_memory(cloud, steps[:-1], plan["voxel_low"])
    expected = labels_in_memory(cloud, steps[-1])
    np.testing.assert_array_equal(labeled(result), labeled(expected))
    assert np.asarray(result["cluster"]).dtype == dtype
    return np.asarray(expected["cluster"])


def write(folder, points, files=1):
    paths = []
    for number, rows in enumerate(np.array_split(np.asarray(points, np.float64) + CORNER, files)):
        paths.append(folder / f"part{number}.laz")
        write_las(paths[-1], PointTable(rows), scale=STEP, offset=CORNER)
    return paths


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    return survey(tmp_path_factory.mktemp("survey"), count=3000)


@pytest.mark.parametrize(
    ("step", "size"),
    [
        (DBSCAN, 14.0),
        (EUCLIDEAN, 20.0),
        *(pytest.param(*pair, marks=pytest.mark.slow) for pair in [(DBSCAN, 10.0), (EUCLIDEAN, 8.1), (DBSCAN, 100.0)]),
    ],
)
def test_labels_match_one_machine_for_any_tile_size(device, files, tmp_path, step, size):
    labels = check(files, [step], tmp_path / "job", device, size=size)
    assert labels.max() > 20 and (labels < 0).any()


def test_labels_after_other_steps_match_one_machine(files, tmp_path):
    steps = [
        {"step": "remove_statistical_outlier", "nb_neighbors": 8, "std_ratio": 2.0},
        {"step": "voxel_down_sample", "voxel_size": 0.4},
        {"step": "cluster_dbscan", "eps": 0.7, "min_points": 3},
    ]
    assert check(files, steps, tmp_path / "job", size=20.0).max() > 10


def test_clusters_that_touch_only_at_a_corner_are_joined(tmp_path):
    ramp = np.arange(0, 20.01, 0.25)
    diagonal = np.column_stack([ramp, ramp, np.zeros(len(ramp))])
    ends = [[0, 0, 0], [20, 20, 0], [0, 20, 9]]
    paths = write(tmp_path, np.concatenate([ends, diagonal[::-1]]))
    labels = check(paths, [{"step": "cluster_dbscan", "eps": 0.36, "min_points": 2}], tmp_path / "job", size=5.0)
    assert labels.max() == 0 and (labels == -1).sum() == 1


def test_a_border_point_between_clusters_joins_that_of_the_lowest_row(tmp_path):
    """The middle point, on the border of a tile, is equally near to a core point on each side."""
    side = np.array([[0.0, 0, 0], [-0.2, 0, 0], [-0.2, 0.2, 0], [-0.3, 0.1, 0]])
    left, right = side + np.array([9.1, 5, 0]), side * np.array([-1, 1, 1]) + np.array([10.9, 5, 0])
    far = [[0, 0, 0], [20, 10, 0]]
    for number, points in enumerate([(left, right), (right, left)]):
        folder = tmp_path / str(number)
        folder.mkdir()
        middle = [[10.0, 5, 0]]
        paths = write(folder, np.concatenate([far, middle, *points]))
        step = {"step": "cluster_dbscan", "eps": 0.95, "min_points": 4}
        assert check(paths, [step], folder / "job", size=10.0).tolist() == [-1, -1, 0, 0, 0, 0, 0, 1, 1, 1, 1]


@pytest.mark.slow
def test_radii_larger_than_tiles_and_duplicates_in_other_files(tmp_path):
    rng = np.random.default_rng(5)
    points = np.round(rng.random((400, 3)) * (9, 9, 1) / 0.05) * 0.05
    points[:40, :2] = rng.integers(0, 4, (40, 2)) * 3.0  # corners of tiles
    points = np.concatenate([[[0, 0, 0], [9, 9, 0]], points, points[::9]])  # duplicates, most of them in another file
    paths = write(tmp_path, points, files=3)
    labels = check(paths, [{"step": "cluster_dbscan", "eps": 3.4, "min_points": 150}], tmp_path / "job", size=3.0)
    assert labels.max() >= 0 and (labels < 0).any()


@pytest.mark.slow
def test_cluster_sizes_are_bounded(files, tmp_path):
    labels = check(files, [EUCLIDEAN | {"min_cluster_size": 3, "max_cluster_size": 40}], tmp_path / "job", size=9.0)
    assert labels.max() > 5 and np.bincount(labels[labels >= 0]).min() == 3
    assert np.bincount(labels[labels >= 0]).max() <= 40


def test_the_intermediate_file_of_a_tile_is_checked_against_the_manifest(files, tmp_path, monkeypatch):
    loom.tiling.plan_tiles(files, [DBSCAN], tmp_path / "job", size=20.0)
    join = tasks.join_step

    def damaged_join(folder, number, step, intermediate, owner):
        path = folder / "left" / str(number) / f"{intermediate.tiles[0]}.npy"
        path.write_bytes(path.read_bytes()[:-100])
        return join(folder, number, step, intermediate, owner)

    with monkeypatch.context() as patch:
        patch.setattr(tasks, "join_step", damaged_join)
        with pytest.raises(loom.FileError, match=r"/job:.*1"):
            loom.tiling.run_tiles(tmp_path / "job")
    status = tile_status(tmp_path / "job")
    assert status.waiting == 9 and (status.which_pass, status.through) == (2, 0)
    assert not [*(tmp_path / "job" / "joined").iterdir()]


CHANGED = """
import os, sys
from pathlib import Path
import numpy as np
from pointloom import FileError
from pointloom.tiling.border_merging import BorderData, write_border_data
folder = Path(sys.argv[1])
changes = {
    "truncated": lambda path: os.truncate(path, 5000),
    "extended": lambda path: os.truncate(path, path.stat().st_size + 1),
    "overwritten": lambda path: (path.open("r+b").write(bytes(9000)), os.utime(path, ns=(1, 1))),
}
for name, change in changes.items():
    write_border_data(folder, 1, 7, {"count": np.array([4]), "keys": np.arange(1 << 20)})
    tile = BorderData(folder, 1, {7: 4})[7]
    assert tile["keys"][5] == 5 and tile["keys"][-1] == (1 << 20) - 1
    change(folder / "left" / "1" / "7.npy")
    try:
        tile["keys"][1 << 18 :].sum()
    except FileError as error:
        print(name, error)
"""


@pytest.mark.slow
def test_border_data_that_another_program_changes_are_an_error(tmp_path):
    """In another process: with memory maps, the first change ended it (SIGBUS)."""
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}
    command = [sys.executable, "-c", CHANGED, str(tmp_path)]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True, timeout=120)
    lines = done.stdout.splitlines()
    assert [line.split()[0] for line in lines] == ["truncated", "extended", "overwritten"]
    assert all("/7.npy: was changed while it was read: expected 8,3" in line for line in lines)


@pytest.mark.parametrize("change", [lambda path: os.truncate(path, path.stat().st_size // 2), os.unlink])
def test_labels_that_another_program_changes_are_an_error(files, tmp_path, monkeypatch, change):
    monkeypatch.setattr(label_join, "MAX_RANKED", 7)
    rank = label_join._rank_stretch

    def changed(left, folder, *arguments):
        for path in folder.iterdir() if arguments[-1] else ():
            change(path)
        return rank(left, folder, *arguments)

    monkeypatch.setattr(label_join, "_rank_stretch", changed)
    loom.tiling.plan_tiles(files, [DBSCAN], tmp_path / "job", size=21.0)
    with pytest.raises(loom.FileError, match=r"\.ranks.* expected"):
        loom.tiling.run_tiles(tmp_path / "job")
    assert not [*(tmp_path / "job" / "joined").iterdir()]


@pytest.mark.parametrize(("step", "max_clusters"), [(DBSCAN, 2), pytest.param(EUCLIDEAN, 7, marks=pytest.mark.slow)])
def test_the_order_of_clusters_is_independent_of_the_sort_batch_size(files, tmp_path, monkeypatch, step, max_clusters):
    monkeypatch.setattr(label_join, "MAX_RANKED", max_clusters)
    ranked = []
    rank = label_join._rank_stretch

    def counted(*arguments):
        begin = arguments[-1]
        end = rank(*arguments)
        ranked.append(end - begin)
        return end

    monkeypatch.setattr(label_join, "_rank_stretch", counted)
    labels = check(files, [step], tmp_path / "job", size=21.0)
    assert len(ranked) > 1 and max(ranked) <= 2 * max_clusters and sum(ranked) == labels.max() + 1


def test_more_clusters_than_int32_allows_have_int64_labels(files, tmp_path, monkeypatch):
    for module in (label_join, parse):
        monkeypatch.setattr(module, "MAX_INT32", 5)
    check(files, [DBSCAN], tmp_path / "job", dtype=np.int64, size=21.0)


def test_steps_after_clustering_keep_the_labels(files, tmp_path):
    """Labels are from before the step; of two clustering steps, those of the second one."""
    steps = [EUCLIDEAN, DBSCAN, {"step": "remove_radius_outlier", "nb_points": 4, "radius": 0.8}]
    result, plan = tiled(files, steps, tmp_path / "job", size=21.0)
    cloud = labels_in_memory(read_cloud(files, np.array(plan["origin"])), DBSCAN)
    cloud = in_memory(cloud, steps[2:], plan["voxel_low"])
    assert 1000 < len(cloud) < 3000
    np.testing.assert_array_equal(labeled(result), labeled(cloud))


KILLED = """
import os, signal, sys
import pointloom as loom
from pointloom.tiling import runners, {module}
def die(*arguments, **named):
    os.kill(os.getpid(), signal.SIGKILL)
die.dumps = die
{module}.{name} = die
loom.tiling.run_tiles(sys.argv[1])
"""


@pytest.mark.slow
@pytest.mark.parametrize(
    ("module", "name"),
    [
        ("tasks", "join_step"),  # all tiles finished the first pass, nothing is joined
        ("label_join", "_rank_stretch"),  # the clusters are joined but have no numbers
        ("border_merging", "json"),  # all files are written but not renamed yet
        ("border_merging", "Joined"),  # the file is renamed, the manifest is not updated
        ("work_tile", "read_joined"),  # in the second pass
    ],
)
def test_runs_killed_between_passes_are_resumed(files, tmp_path, module, name):
    job = tmp_path / "job"
    loom.tiling.plan_tiles(files, [DBSCAN], job, size=14.0)
    program = KILLED.format(module=module, name=name)
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run([sys.executable, "-c", program, str(job)], env=environment, check=False, timeout=120)
    assert done.returncode == -signal.SIGKILL
    status = tile_status(job)
    assert status.done == 0 and (status.which_pass, status.passes) == (2, 2)
    assert loom.tiling.run_tiles(job).is_finished and not [*(job / "joined").glob("*.part")]
    cloud = labels_in_memory(read_cloud(files, np.array(plan_of(job)["origin"])), DBSCAN)
    np.testing.assert_array_equal(labeled(finished(job)), labeled(cloud))


@pytest.mark.parametrize(
    ("names", "expected"),
    [((5, 3), (5, 3, 3)), ((2, 7), (2, 2, 7)), ((-1, 4), (-1, 4, 4)), ((4, -1), (4, 4, -1)), ((-1, -1), (-1, -1, -1))],
)
def test_border_points_take_the_lowest_label_of_renamed_cores(device, names, expected):
    """The point between two clusters takes the lower label; clusters without a label do not count."""
    x = np.array([0.0, 0.1, 0.2, 0.3, 1.2, 2.1, 2.2, 2.3, 2.4])
    order = np.random.default_rng(2).permutation(9)
    order = order[np.argsort(x[order] > 1, kind="stable")]  # the left cluster's rows come first
    points = np.zeros((9, 3), np.float32)
    points[:, 0] = x[order]
    tree = PointTree(upload(points, vec3, device))
    labels = full(9, NOISE_LABEL, int32, tree.device)
    cores, count = cluster_cores(tree, 0.95, 4, labels)
    assert count == 2
    rename_cores(cores, upload(np.array(names, np.int32), int32, tree.device), labels)
    label_borders(cores, labels)
    assert download(labels).tolist() == np.repeat(np.array(expected), (4, 1, 4))[order].tolist()

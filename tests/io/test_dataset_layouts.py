"""Pairing of image files to frames by name, number and time."""

import re

import numpy as np
import pytest

from pointloom.core.errors import DatasetError, FileError
from pointloom.io.frames.dataset_layouts import associate, list_redwood, list_seven_scenes, list_tum

from .frame_folders import make, write_listing, write_log, write_poses


@pytest.mark.parametrize("part", ["pose.txt", "depth.png", "color.png"])
def test_seven_scenes_misses_any_part_of_a_frame(tmp_path, part):
    folder = make("7scenes", tmp_path / "set")
    (folder / f"frame-000001.{part}").unlink()
    with pytest.raises(DatasetError, match=rf"frame-000001\.{part}.*: missing"):
        list_seven_scenes(folder, every=2)


def test_seven_scenes_refuses_doubles(tmp_path):
    folder = make("7scenes", tmp_path / "set")
    (folder / "frame-01.depth.png").touch()
    with pytest.raises(DatasetError, match=r"/frame-01\.depth\.png:.*frame-000001"):
        list_seven_scenes(folder, every=1)
    (folder / "frame-01.depth.png").unlink()
    (folder / "frame-000001.color.jpg").touch()
    with pytest.raises(DatasetError, match=r"frame-000001\.color\.png"):
        list_seven_scenes(folder, every=1)


@pytest.mark.parametrize("text", ["nan " * 16, "1 0 0\n" * 4, "2 0 0 0\n0 2 0 0\n0 0 2 0\n0 0 0 1", "-1.#IND\n", ""])
def test_poses_that_are_no_motion_are_refused_by_name(tmp_path, text):
    folder = make("7scenes", tmp_path / "set")
    (folder / "frame-000002.pose.txt").write_text(text)
    with pytest.raises(FileError, match=r"frame-000002\.pose\.txt"):
        list_seven_scenes(folder, every=1)


def test_redwood_pairs_by_number_if_the_names_differ(tmp_path):
    """As in the original recordings: a counter from 1 and a separate time on each side."""
    folder = make("redwood", tmp_path / "set")
    for i in range(3):
        (folder / "depth" / f"{i:05d}.png").rename(folder / "depth" / f"{i + 1:07d}-{33369 * i:012d}.png")
        (folder / "color" / f"{i:05d}.jpg").rename(folder / "color" / f"{i + 1:07d}-{33360 * i:012d}.jpg")
    frames = list_redwood(folder)
    named = [(f.color and f.color.name[:7], f.T_world_camera[0, 3]) for f in frames]
    assert named == [("0000001", 0), ("0000002", 1), ("0000003", 2)]


def test_redwood_orders_by_number_and_not_by_letters(tmp_path):
    folder = make("redwood", tmp_path / "set", 11)
    for side, suffix in (("depth", "png"), ("color", "jpg")):
        for i in range(11):
            (folder / side / f"{i:05d}.{suffix}").rename(folder / side / f"{i}.{suffix}")
    assert [f.name for f in list_redwood(folder)] == [str(i) for i in range(11)]


@pytest.mark.parametrize("name", ["image", "rgb"])
def test_redwood_accepts_alternative_color_folder_names(tmp_path, name):
    folder = make("redwood", tmp_path / "set")
    (folder / "color").rename(folder / name)
    assert list_redwood(folder)[0].color == folder / name / "00000.jpg"
    (folder / "color").mkdir()
    with pytest.raises(DatasetError, match="Keep one folder of color"):
        list_redwood(folder)


def test_redwood_ids_name_the_frames_of_a_thinned_set(tmp_path):
    folder = make("redwood", tmp_path / "set", 6)
    for i in (0, 2, 3):
        (folder / "depth" / f"{i:05d}.png").unlink()
        (folder / "color" / f"{i:05d}.jpg").unlink()
    write_log(folder, [5, 1, 4])
    frames = list_redwood(folder)
    assert [(f.name, f.T_world_camera[0, 3]) for f in frames] == [("00001", 1), ("00004", 2), ("00005", 0)]


@pytest.mark.parametrize("ids", [[1, 2, 3], [0, 1, 1], [2, 1, 7], [0, 10, 20], range(2), range(4)])
def test_redwood_ids_that_name_no_frame_are_refused(tmp_path, ids):
    folder = make("redwood", tmp_path / "set")
    write_log(folder, ids)
    with pytest.raises(DatasetError, match=r"trajectory\.log"):
        list_redwood(folder)


def test_redwood_names_the_picture_without_a_depth_map(tmp_path):
    folder = make("redwood", tmp_path / "set")
    (folder / "color" / "00007.jpg").touch()
    with pytest.raises(DatasetError, match=r"00007\.jpg"):
        list_redwood(folder)


def test_redwood_names_that_do_not_pair_are_refused(tmp_path):
    folder = make("redwood", tmp_path / "set", 2)
    for i in range(2):
        (folder / "color" / f"{i:05d}.jpg").rename(folder / "color" / f"7-{i}.jpg")
    with pytest.raises(DatasetError, match=r"7-0\.jpg"):
        list_redwood(folder)


def test_hidden_and_foreign_files_do_no_harm(tmp_path):
    folder = make("redwood", tmp_path / "set")
    for name in (".DS_Store", "._00000.png", "Thumbs.db"):
        (folder / "depth" / name).write_bytes(b"?")
    assert len(list_redwood(folder)) == 3


def test_tum_reports_frames_without_a_partner(tmp_path):
    folder = make("tum", tmp_path / "set", 4)
    write_listing(folder, "rgb", [100.012, 100.225, 100.312])  # the second is 25 ms from its depth map
    write_poses(folder, [(100.0, 0), (100.1, 1), (100.2, 2), (100.275, 3)])  # and the last pose from the last one
    frames, left_out = list_tum(folder)
    assert [frame.name for frame in frames] == ["100.000000"]
    reasons = [text.split(": ")[1] for text in left_out]
    assert reasons == ["no color within 0.02 s", "no color within 0.02 s", "no pose within 0.02 s"]


def test_association_agrees_with_trying_all_pairs():
    generator = np.random.default_rng(0)
    for _ in range(50):
        first, second = (np.sort(generator.uniform(0, 1, generator.integers(0, 40))) for _ in range(2))
        free_first, free_second, expected = set(range(len(first))), set(range(len(second))), {}
        for _, i, j in sorted((abs(a - b), i, j) for i, a in enumerate(first) for j, b in enumerate(second)):
            if abs(first[i] - second[j]) < 0.02 and i in free_first and j in free_second:
                expected[i] = j
                free_first.remove(i)
                free_second.remove(j)
        assert associate(first, second, 0.02) == expected


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("depth.txt", "", "lists no image"),
        ("depth.txt", "soon depth/a.png\n", "line 1): not a number"),
        ("depth.txt", "100.0 ../../etc/x.png\n", "name of an image in the folder"),
        ("depth.txt", "100.1 depth/a.png\n100.0 depth/b.png\n", "line 2): expected increasing times"),
        ("groundtruth.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n", "has no times"),
        ("groundtruth.txt", "1 0 0 0 0 0 0 0\n", "unit quaternion"),
    ],
)
def test_tum_lists_are_checked_by_line(tmp_path, name, text, message):
    folder = make("tum", tmp_path / "set")
    (folder / name).write_text(text)
    with pytest.raises(FileError, match=re.escape(message)):
        list_tum(folder)


def test_tum_color_without_its_list_and_poses_of_another_clock_are_refused(tmp_path):
    folder = make("tum", tmp_path / "set")
    (folder / "rgb.txt").rename(tmp_path / "rgb.txt")
    with pytest.raises(DatasetError, match=r"rgb\.txt"):
        list_tum(folder)
    (tmp_path / "rgb.txt").rename(folder / "rgb.txt")
    write_poses(folder, [(5.0, 0), (5.1, 1)])
    with pytest.raises(DatasetError, match="clocks"):
        list_tum(folder)

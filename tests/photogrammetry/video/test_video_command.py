"""`pointloom video`: stages that run again, rejected calls, and messages of poor results."""

import json

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.work_folder import locked
from pointloom.io.pictures.image_files import write_png
from pointloom.photogrammetry.video import chain, motion

from ...cli.commands import answer, names_in, refusal, run, unreliable
from .conftest import COUNT

STAGES = ["frames", "features", "matches", "model", "undistorted", "depth", "fused", "mesh"]


@pytest.fixture
def output(tmp_path):
    return tmp_path / "room.ply"


def files_of(folder):
    """All files but the records and the report, which contain times."""
    paths = (p for p in folder.rglob("*") if p.is_file() and p.parent.name != "records" and p.name != "report.json")
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in paths}


def test_a_video_becomes_a_mesh_and_a_report_of_each_stage(quick, film, output, tmp_path):
    report = answer("video", film, "-o", output, "--work", tmp_path / "work")
    assert quick.ran == STAGES
    assert list(report["stages"]) == STAGES
    assert all(not stage["kept"] and stage["cpu_seconds"] >= 0 for stage in report["stages"].values())
    assert (report["model"]["registered_count"], report["fused"]["share"], report["reliable"]) == (COUNT, 0.6, True)
    assert report["files"] == [str(output)]
    assert json.loads((tmp_path / "work" / "report.json").read_text()) == report
    assert names_in(tmp_path / "work") == sorted([*STAGES, "records", "report.json", "video.json"])


def test_without_a_work_folder_nothing_is_left_but_the_outputs(quick, film, output, tmp_path):
    poses, cloud, picture = tmp_path / "poses.log", tmp_path / "cloud.ply", tmp_path / "room.png"
    others = ("--trajectory", poses, "--cloud", cloud, "--picture", picture)
    report = answer("video", film, "-o", output, *others)
    assert names_in(tmp_path) == ["cloud.ply", "poses.log", "room.ply", "room.png", "walk.mp4"]
    assert (len(report["files"]), report["work"]) == (4, None)
    path = loom.read_trajectory(poses)
    assert path.ids[:, 0].tolist() == list(range(0, 80, 10))  # the frames' own numbers
    assert len(loom.read_point_cloud(cloud)) == 3


def test_a_training_folder_is_written_in_the_unit_of_the_mesh(quick, film, output, tmp_path, monkeypatch):
    def take_frames(folder, report_progress, *, source, max_frames):
        (folder / motion.PICTURES).mkdir()
        for number in range(0, 10 * COUNT, 10):
            write_png(folder / motion.PICTURES / f"frame_{number:06d}.png", np.full((48, 64, 3), number, np.uint8))
        return {"kept": COUNT, "frames": 80, "notes": []}

    monkeypatch.setitem(chain.STAGES, "frames", take_frames)
    scene = tmp_path / "scene"
    report = answer("video", film, "-o", output, "--training", scene, "--scale", 2.5)
    assert report["files"] == [str(output), str(scene)]
    assert report["training"]["picture_count"] == COUNT == len(names_in(scene / "images"))
    model, twice = loom.read_colmap_model(scene / "sparse" / "0"), report["fit"]["scale"]
    assert twice == 2.5
    plain = answer("video", film, "-o", output, "--training", scene, "--force", "--align", "none")
    assert plain["fit"]["scale"] == 1.0
    np.testing.assert_allclose(model.centers, 2.5 * loom.read_colmap_model(scene / "sparse" / "0").centers, atol=1e-12)
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "notes.txt").write_text("mine")
    message = refusal("video", film, "-o", output, "--training", tmp_path / "other", "--force")
    assert "other: contains other files" in message


def test_the_summary_reports_the_use_of_the_pictures(quick, film, output):
    result = run("video", film, "-o", output)
    assert result.exit_code == 0, result.stderr
    texts = ("8 of 8 registered, chosen from 80, on ", "60.0% confirmed", "arbitrary: give --scale", "depth 0.0, ")
    assert all(text in result.stdout for text in (*texts, "80 of 90 frames were decoded"))


@pytest.mark.parametrize(
    ("changed", "ran"),
    [
        ([], []),
        (["--scale", "2"], ["mesh"]),
        (["--known", "0,10,3"], ["mesh"]),
        (["--max-size", "64"], ["undistorted"]),  # the pictures are no larger: later stages are reused
        (["--max-frames", "4"], STAGES),
        (["--seed", "1"], ["features", "matches", "model", "depth", "fused", "mesh"]),
        (["--picture", "room.png"], []),
    ],
)
def test_only_what_changed_runs_again(quick, film, output, tmp_path, monkeypatch, changed, ran):
    monkeypatch.chdir(tmp_path)
    answer("video", film, "-o", output, "--work", "work")
    quick.ran.clear()
    film.touch()  # the same bytes
    run("video", film, "-o", output, "--work", "work", "--resume", "--force", *changed)
    assert quick.ran == ran
    run("video", film, "-o", output, "--work", "whole", "--force", *changed)
    assert files_of(tmp_path / "work") == files_of(tmp_path / "whole")


def test_another_film_is_another_run(quick, film, output, tmp_path):
    answer("video", film, "-o", output, "--work", tmp_path / "work")
    quick.ran.clear()
    film.write_bytes(b"another film")
    answer("video", film, "-o", output, "--work", tmp_path / "work", "--resume", "--force")
    assert quick.ran[0] == "frames"


@pytest.mark.parametrize("stage", STAGES[::3] + STAGES[-1:])
def test_an_interrupted_run_resumes_to_bitwise_identical_files(quick, film, output, tmp_path, stage):
    answer("video", film, "-o", output, "--work", tmp_path / "whole")
    complete, mesh = files_of(tmp_path / "whole"), output.read_bytes()
    output.unlink()
    quick.ran.clear()
    quick.fail = stage
    assert run("video", film, "-o", output, "--work", tmp_path / "work").exit_code == 130
    assert not output.exists()
    finished = [name for name in names_in(tmp_path / "work") if name not in ("records", "video.json")]
    assert finished == sorted(STAGES[: STAGES.index(stage)])
    quick.ran.clear()
    quick.fail = None
    answer("video", film, "-o", output, "--work", tmp_path / "work", "--resume")
    assert quick.ran == STAGES[STAGES.index(stage) :]
    assert (files_of(tmp_path / "work"), output.read_bytes()) == (complete, mesh)


def test_an_interrupted_run_without_a_work_folder_leaves_nothing(quick, film, output, tmp_path):
    quick.fail = "depth"
    assert run("video", film, "-o", output).exit_code == 130
    assert names_in(tmp_path) == ["walk.mp4"]


def test_the_unit_is_written_to_the_file(quick, film, output, tmp_path):
    assert answer("video", film, "-o", output)["units"] == "arbitrary"
    assert b"\ncomment units arbitrary\n" in output.read_bytes()
    report = answer("video", film, "-o", output, "--scale", 3, "--force", "--trajectory", tmp_path / "poses.log")
    assert (report["units"], report["fit"]["scale"]) == ("meters", 3.0)
    assert b"\ncomment units meters\n" in output.read_bytes()
    np.testing.assert_allclose(loom.read_triangle_mesh(output).vertices.max(axis=0), [3, 3, 3])
    steps = np.linalg.norm(np.diff(loom.read_trajectory(tmp_path / "poses.log").poses[::2, :3, 3], axis=0), axis=1)
    np.testing.assert_allclose(steps, 3.0)  # two steps of half a unit


def test_known_positions_transform_the_mesh_and_the_poses(quick, film, output, tmp_path):
    (tmp_path / "places.txt").write_text("0 100 0 0\n10 101 2 0\n20 102 0 0\n30 103 2 0\n")
    report = answer("video", film, "-o", output, "--align", tmp_path / "places.txt")
    assert report["fit"]["places"] == 4
    assert report["fit"]["scale"] == pytest.approx(2.0)
    assert report["mesh"]["bounds"]["min"][0] == pytest.approx(100.0)


def test_a_camera_that_only_rotated_gives_no_mesh(quick, film, output, tmp_path):
    quick.only_rotated, quick.reasons = True, ["the camera hardly moved: move instead of only rotating"]
    report = unreliable("video", film, "-o", output, "--work", tmp_path / "work")
    assert report["warnings"] == [*quick.reasons, "nothing was written"]
    assert quick.ran == STAGES[:4]
    assert not output.exists()
    assert json.loads((tmp_path / "work" / "report.json").read_text())["warnings"] == report["warnings"]


def test_an_unreliable_mesh_is_written_with_advice(quick, film, output):
    quick.reasons, quick.share = ["only 4 of 8 pictures could be placed: film more slowly"], 0.15
    first, second = unreliable("video", film, "-o", output)["warnings"]
    assert first == "only 4 of 8 pictures could be placed: film more slowly"
    assert "the depth of only 15.0% of the pixels" in second
    assert output.exists()


def test_an_empty_mesh_is_not_written(quick, film, output):
    quick.triangles = 0
    assert "the mesh is empty" in str(unreliable("video", film, "-o", output)["warnings"])
    assert not output.exists()


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--scale", "2", "--known", "0,10,1"], "--scale and --known both define the unit"),
        (["--scale", "0"], "expected a number above 0"),
        (["--known", "0,10"], "expected two pictures and meters above 0"),
        (["--known", ",10,-1"], "expected two pictures and meters above 0"),
        (["--max-frames", "1"], "--max-frames"),
        (["--max-size", "10"], "--max-size"),
        (["--resume"], "--resume requires --work"),
        (["--cloud", "room.ply"], "--cloud is the same file as --output"),
    ],
)
def test_wrong_calls_are_refused(quick, film, tmp_path, monkeypatch, words, message):
    monkeypatch.chdir(tmp_path)
    result = run("video", film, "-o", "room.ply", *words)
    assert result.exit_code == 2
    assert message in result.stderr
    assert quick.ran == []


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["-o", "room.txt"], "meshes are not written to .txt"),
        (["-o", "there/room.ply"], "the folder there does not exist"),
        (["-o", "old.ply"], "exists already. Give another name, or --force"),
        (["-o", "room.ply", "--picture", "room.jpg"], "expected .png or .webp"),
        (["-o", "room.ply", "--cloud", "room.mp3"], "clouds are not written to .mp3"),
        (["-o", "room.ply", "--trajectory", "room.csv"], "poses are not written to .csv"),
        (["-o", "room.ply", "--align", "nowhere.txt"], "nowhere.txt: cannot be read: No such file"),
        (["-o", "room.ply", "--intrinsic", "nowhere.json"], "nowhere.json"),
        (["-o", "room.ply", "--work", "old.ply"], "is not a folder"),
        (["-o", "room.ply", "--work", "photos"], "contains files that do not belong to a run"),
    ],
)
def test_unwritable_outputs_are_rejected_early(quick, film, tmp_path, monkeypatch, words, message):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "old.ply").write_text("old")
    (tmp_path / "photos").mkdir()
    (tmp_path / "photos" / "a.jpg").write_text("a")
    assert message in refusal("video", film, *words)
    assert quick.ran == []
    assert names_in(tmp_path) == ["old.ply", "photos", "walk.mp4"]


def test_an_earlier_run_is_neither_mixed_in_nor_replaced_unasked(quick, film, output, tmp_path):
    work = ("--work", tmp_path / "work")
    answer("video", film, "-o", output, *work)
    message = refusal("video", film, "-o", tmp_path / "b.ply", *work)
    assert "contains an earlier run. Give --resume to continue" in message
    quick.ran.clear()
    answer("video", film, "-o", output, *work, "--force")
    assert quick.ran == STAGES


def test_two_runs_do_not_share_a_folder(quick, film, output, tmp_path):
    (tmp_path / "work").mkdir()
    with locked(tmp_path / "work"):
        assert "another run is using it" in refusal("video", film, "-o", output, "--work", tmp_path / "work")
    answer("video", film, "-o", output, "--work", tmp_path / "work")


def test_a_missing_source_is_an_error(quick, output, tmp_path):
    assert "walk.mp4: does not exist. Give a video" in refusal("video", tmp_path / "walk.mp4", "-o", output)


def test_a_missing_known_picture_is_an_error_after_the_frames(quick, film, output):
    assert "'7' matches no image" in refusal("video", film, "-o", output, "--known", "7,10,1")
    assert quick.ran == ["frames"]
    quick.registered = 3
    assert "'70' matches no image in the model" in refusal("video", film, "-o", output, "--known", "0,70,1")
    assert quick.ran[-1] == "model"

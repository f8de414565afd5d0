"""`pointloom video` and `reconstruct_video`: stages that run again, rejected calls, results, control and maps."""

import contextlib
import json

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.core.records import digest_of
from pointloom.core.stages import Chain
from pointloom.core.wording import json_text
from pointloom.core.work_folder import locked
from pointloom.io.images.image_files import write_png
from pointloom.photogrammetry.sfm.image_positions import ImagePosition, ImagePositions
from pointloom.photogrammetry.video import chain, motion

from ...cli.commands import answer, names_in, refusal, run, unreliable
from .conftest import COUNT, set_stage
from .made_flights import FRAME

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
    assert (report["model"]["registered_count"], report["fused"]["fraction"], report["reliable"]) == (COUNT, 0.6, True)
    assert report["files"] == [str(output)]
    assert json.loads((tmp_path / "work" / "report.json").read_text()) == report
    assert names_in(tmp_path / "work") == sorted([*STAGES, "records", "report.json", "video.json"])


def test_without_a_work_folder_the_stages_are_beside_the_outputs(quick, film, output, tmp_path):
    poses, cloud, image = tmp_path / "poses.log", tmp_path / "cloud.ply", tmp_path / "room.png"
    others = ("--trajectory", poses, "--cloud", cloud, "--picture", image)
    report = answer("video", film, "-o", output, *others)
    assert names_in(tmp_path) == ["cloud.ply", "poses.log", "room-video", "room.ply", "room.png", "walk.mp4"]
    assert (len(report["files"]), report["work"]) == (4, str(tmp_path / "room-video"))
    path = loom.read_trajectory(poses)
    assert path.ids[:, 0].tolist() == list(range(0, 80, 10))  # the frames' own numbers
    assert len(loom.read_point_cloud(cloud)) == 3


def test_a_training_folder_is_written_in_the_unit_of_the_mesh(quick, film, output, tmp_path, monkeypatch):
    def take_frames(folder, report_progress, *, source, max_frames):
        (folder / motion.IMAGES).mkdir()
        for number in range(0, 10 * COUNT, 10):
            write_png(folder / motion.IMAGES / f"frame_{number:06d}.png", np.full((48, 64, 3), number, np.uint8))
        return {"kept": COUNT, "frames": 80, "notes": []}

    set_stage(monkeypatch, "frames", take_frames)
    scene = tmp_path / "scene"
    report = answer("video", film, "-o", output, "--training", scene, "--scale", 2.5)
    assert report["files"] == [str(output), str(scene)]
    assert report["training"]["image_count"] == COUNT == len(names_in(scene / "images"))
    model, twice = loom.read_cameras(scene / "sparse" / "0"), report["fit"]["scale"]
    assert twice == 2.5
    plain = answer("video", film, "-o", output, "--training", scene, "--force", "--align", "none")
    assert plain["fit"]["scale"] == 1.0
    np.testing.assert_allclose(model.centers, 2.5 * loom.read_cameras(scene / "sparse" / "0").centers, atol=1e-12)
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "notes.txt").write_text("mine")
    message = refusal("video", film, "-o", output, "--training", tmp_path / "other", "--force")
    assert "other: contains other files" in message


def test_the_summary_reports_the_use_of_the_images(quick, film, output):
    result = run("video", film, "-o", output)
    assert result.exit_code == 0, result.stderr
    texts = ("8 of 8 registered, chosen from 80, on ", "60.0% confirmed", "arbitrary: give --scale", "depth 0.0, ")
    assert all(text in result.stdout for text in (*texts, "80 of 90 suitable frames are used"))


@pytest.mark.parametrize(
    ("changed", "ran"),
    [
        ([], []),
        (["--scale", "2"], ["mesh"]),
        (["--known", "0,10,3"], ["mesh"]),
        (["--max-size", "64"], ["undistorted"]),  # the images are no larger: later stages are reused
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


@pytest.mark.parametrize("stage", STAGES)
def test_an_interrupted_run_without_a_work_folder_continues(quick, film, output, tmp_path, stage):
    answer("video", film, "-o", tmp_path / "whole.ply")
    quick.fail = stage
    stopped = run("video", film, "-o", output)
    assert (stopped.exit_code, output.exists()) == (130, False)
    if stage != STAGES[0]:  # its first step is the first progress
        first, *_, last = (line for line in stopped.stderr.splitlines() if "room-video" in line)
        assert first.startswith("intermediate files: ") and "the same command continues" in first
        assert last.startswith("finished work is kept in ")
    quick.fail = None
    quick.ran.clear()
    answer("video", film, "-o", output)
    assert quick.ran == STAGES[STAGES.index(stage) :]
    assert output.read_bytes() == (tmp_path / "whole.ply").read_bytes()
    assert files_of(tmp_path / "room-video") == files_of(tmp_path / "whole-video")


def test_a_default_work_folder_of_another_film_is_made_again(quick, film, output, tmp_path):
    answer("video", film, "-o", output)
    other = tmp_path / "other.mp4"
    other.write_bytes(b"another film")
    answer("video", other, "-o", tmp_path / "whole.ply")
    answer("video", other, "-o", output, "--force")
    assert files_of(tmp_path / "room-video") == files_of(tmp_path / "whole-video")


def test_a_default_work_folder_that_is_in_use_or_belongs_to_others_is_an_error(quick, film, output, tmp_path):
    folder = tmp_path / "room-video"
    folder.mkdir()
    (folder / "notes.txt").write_text("mine")
    assert "room-video: contains files that do not belong to a run" in refusal("video", film, "-o", output)
    assert (quick.ran, names_in(folder)) == ([], ["notes.txt"])


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
    quick.reasons, quick.fraction = ["only 4 of 8 images could be placed: film more slowly"], 0.15
    quick.damage = ["the video is damaged or truncated: 80 of 90 frames were decoded"]
    first, damage, second = unreliable("video", film, "-o", output)["warnings"]
    assert [damage] == quick.damage and first == "only 4 of 8 images could be placed: film more slowly"
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
        (["--known", "0,10"], "expected two images and meters above 0"),
        (["--known", ",10,-1"], "expected two images and meters above 0"),
        (["--max-frames", "1"], "--max-frames"),
        (["--max-size", "10"], "--max-size"),
        (["--cloud", "room.ply"], "--cloud is the same file as --output"),
        (["--ortho", "o.tif"], "--cell"),
        (["--dem", "d.tif", "--cell", "0"], "--cell"),
        (["--ortho", "o.tif", "--dem", "o.tif", "--cell", "1"], "o.tif"),
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
        (["-o", "room.mp3"], "are not written to .mp3"),
        (["-o", "there/room.ply"], "the folder there does not exist"),
        (["-o", "old.ply"], "exists already. Give another name, or --force"),
        (["-o", "room.ply", "--picture", "room.jpg"], "expected .png or .webp"),
        (["-o", "room.ply", "--cloud", "room.mp3"], "clouds are not written to .mp3"),
        (["-o", "room.ply", "--dem", "d.png", "--cell", "1"], "d.png: is not a GeoTIFF file name"),
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


def test_a_missing_known_image_is_an_error_after_the_frames(quick, film, output):
    assert "'7' matches no image" in refusal("video", film, "-o", output, "--known", "7,10,1")
    assert quick.ran == ["frames"]
    quick.registered = 3
    assert "'70' matches no image in the model" in refusal("video", film, "-o", output, "--known", "0,70,1")
    assert quick.ran[-1] == "model"


def in_json(result):
    report = json.loads(json.dumps(result.to_dict()))
    return {name: value for name, value in report.items() if name not in ("stages", "peak_bytes")}


def test_a_film_becomes_objects_and_a_work_folder(quick, film, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    result = loom.photogrammetry.reconstruct_video(film)
    assert names_in(tmp_path) == ["walk-video", "walk.mp4"]
    assert (len(result.mesh), len(result.cloud), len(result.model)) == (2, 3, COUNT)
    assert (result.files, result.work, result.reliable, result.units) == ((), "walk-video", True, "arbitrary")
    figures = result.figures
    assert (figures.frame_count, figures.image_count, figures.quality.registered_count) == (80, COUNT, COUNT)
    assert (figures.image_size, figures.confirmed_fraction, figures.triangle_count) == ((64, 48), 0.6, 2)


def test_mesh_cloud_and_model_share_one_frame_and_unit(quick, film, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    arbitrary = loom.photogrammetry.reconstruct_video(film)
    meters = loom.photogrammetry.reconstruct_video(
        film, loom.photogrammetry.VideoSettings(units=loom.photogrammetry.VideoUnits(scale=3.0))
    )
    assert (meters.units, meters.fit.scale) == ("meters", 3.0)
    np.testing.assert_allclose(meters.mesh.vertices, 3 * arbitrary.mesh.vertices, atol=1e-6)
    np.testing.assert_allclose(meters.cloud.points, 3 * arbitrary.cloud.points, atol=1e-6)
    np.testing.assert_allclose(meters.model.centers, 3 * arbitrary.model.centers, atol=1e-6)


def test_the_command_prints_the_result_and_writes_its_report(quick, film, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    shown = run("video", film, "-o", "room.ply", "--cloud", "cloud.ply", "--work", "work", "--device", "cpu")
    settings = {"work": "work", "resume": True, "overwrite": True, "device": "cpu"}
    result = loom.photogrammetry.reconstruct_video(
        film, outputs=loom.photogrammetry.VideoOutputs("room.ply", cloud="cloud.ply"), **settings
    )
    *lines, following = shown.stdout.splitlines()
    assert following.split() == ["next", "pointloom", "view", "room.ply", "cloud.ply"]
    same = [line for line in lines if not line.startswith(("  seconds", "  memory"))]
    assert same == [line for line in str(result).splitlines() if not line.startswith(("  seconds", "  memory"))]
    assert json.loads((tmp_path / "work" / "report.json").read_text()) == json.loads(json.dumps(result.to_dict()))
    assert all(stage.is_reused for stage in result.stages.values())


def test_requested_outputs_are_written_and_stages_are_reported(quick, film, tmp_path):
    events = []
    outputs = loom.photogrammetry.VideoOutputs(trajectory=tmp_path / "path.log", picture=tmp_path / "room.png")
    options = {"work": tmp_path / "work", "device": "cpu", "progress": lambda *event: events.append(event)}
    result = loom.photogrammetry.reconstruct_video(
        film, loom.photogrammetry.VideoSettings(max_size=100), outputs=outputs, **options
    )
    assert len(loom.read_trajectory(tmp_path / "path.log").poses) == len(result.model) > 0
    assert loom.read_color(tmp_path / "room.png").shape[2] == 3 and events
    assert quick.max_size == 100


def test_a_given_up_axis_is_that_of_the_model_in_a_file(quick, film, tmp_path):
    rows = {}
    for up in ("y", "z"):
        outputs = loom.photogrammetry.VideoOutputs(tmp_path / f"{up}.glb", up=up)
        result = loom.photogrammetry.reconstruct_video(film, outputs=outputs, device="cpu", overwrite=True)
        read = loom.read_triangle_mesh(tmp_path / f"{up}.glb")
        assert read.up == result.mesh.up and np.allclose(read.vertices, result.mesh.vertices, atol=1e-5)
        rows[up] = loom.read_triangle_mesh(tmp_path / f"{up}.glb", up="y").vertices
    x, y, z = rows["z"].T
    assert np.allclose(rows["y"], np.stack([x, -z, y], axis=1), atol=1e-5)


def test_a_result_that_is_read_again_from_its_records_is_the_same(quick, film, tmp_path):
    quick.reasons, quick.fraction = ["only 4 of 8 images could be placed: film more slowly"], 0.15
    first = loom.photogrammetry.reconstruct_video(film, work=tmp_path / "work")
    quick.ran.clear()
    again = loom.photogrammetry.reconstruct_video(film, work=tmp_path / "work", resume=True)
    assert quick.ran == []
    assert again.figures == first.figures
    assert again.warnings == first.warnings and len(first.warnings) == 2
    assert in_json(again) == in_json(first)


@pytest.mark.parametrize("marker", ["{}", "clips", '{"command": "edit", "source": "walk.mp4"}'])
def test_a_folder_with_the_marker_of_another_program_is_not_used(quick, film, tmp_path, marker):
    (tmp_path / "work" / "frames").mkdir(parents=True)
    others = {tmp_path / "work" / name: name for name in ("frames/mine.png", "report.json")}
    for path, content in [*others.items(), (tmp_path / "work" / "video.json", marker)]:
        path.write_text(content)
    for options in ({"resume": True}, {"overwrite": True}):
        with pytest.raises(loom.FileError, match="do not belong to a run"):
            loom.photogrammetry.reconstruct_video(film, work=tmp_path / "work", **options)
    assert quick.ran == [] and all(path.read_text() == content for path, content in others.items())


def places(value, path=()):
    """The positions of all values in JSON, at most two of each list."""
    yield path
    inner = value.items() if isinstance(value, dict) else enumerate(value[:2]) if isinstance(value, list) else ()
    for key, each in inner:
        yield from places(each, (*path, key))


@pytest.mark.parametrize("stage", STAGES)
def test_a_record_of_other_values_is_made_again_or_an_error(quick, film, tmp_path, monkeypatch, stage):
    """Its digest matches, as in the folder of somebody else.

    The stage checks all records, and the job runs with those that it accepts and with the first that it rejects.
    """
    checks, run = {}, Chain.run
    monkeypatch.setattr(Chain, "run", lambda chain, stage: (checks.update({stage.name: stage}), run(chain, stage))[1])
    loom.photogrammetry.reconstruct_video(film, work=tmp_path / "work")
    record = tmp_path / "work" / "records" / f"{stage}.json"
    before = record.read_text()
    rejected = 0
    for path in list(places(json.loads(before)["result"]))[1:]:
        for value in ("x", None, [[1]], -1, "missing"):
            content = json.loads(before)
            content.pop("digest")
            at = content["result"]
            for key in path[:-1]:
                at = at[key]
            at[path[-1]] = value
            if value == "missing":
                del at[path[-1]]
            if not checks[stage].is_result(content["result"]):
                rejected += 1
                if rejected > 1:
                    continue
            record.write_text(json.dumps(content | {"digest": digest_of(content)}))
            quick.ran.clear()
            with contextlib.suppress(loom.FileError):
                result = loom.photogrammetry.reconstruct_video(film, work=tmp_path / "work", resume=True)
                assert str(result) and json_text(result.to_dict())
            if rejected == 1:
                assert stage in quick.ran
    assert rejected


def test_a_camera_is_taken_as_a_file_or_as_itself(quick, film, tmp_path):
    camera = loom.PinholeCameraIntrinsic(64, 48, 50.0, 50.0, 31.5, 23.5)
    camera.write(tmp_path / "camera.json")
    work = tmp_path / "work"
    loom.photogrammetry.reconstruct_video(
        film, loom.photogrammetry.VideoSettings(intrinsic=tmp_path / "camera.json"), work=work
    )
    quick.ran.clear()
    loom.photogrammetry.reconstruct_video(
        film, loom.photogrammetry.VideoSettings(intrinsic=camera), work=work, resume=True
    )
    assert quick.ran == []


POSITIONS = np.array([[5, 2, 40], [15, -11, 50], [25, 2, 45], [30, -8, 60], [10, -5, 35], [20, 0, 30]]) / 10


@pytest.fixture
def imaged(quick, film, tmp_path, monkeypatch):
    """The fast stages with images of the size of the lens, and control in a frame twice as large."""
    make = chain.STAGES["frames"].make

    def take_frames(folder, report, *, source, max_frames):
        contents = make(folder, report, source=source, max_frames=max_frames)
        for path in (folder / motion.IMAGES).iterdir():
            Image.new("RGB", (64, 48)).save(path)
        return contents

    set_stage(monkeypatch, "frames", take_frames)
    camera = loom.CameraModel("PINHOLE", 64, 48, [50, 50, 32, 24])
    lines = ["local"]
    for name, position in zip("ABCDEF", POSITIONS, strict=True):
        for k in range(8):
            center = np.array([0.5 * k, -(1.0 - k % 2), 0.0])  # of the poses of the fast stage `model`
            pixel = camera.project((position - center)[None])[0] + 0.5
            if (pixel > 0).all() and (pixel < (64, 48)).all():
                lines.append(" ".join(f"{value:.6f}" for value in (*(2 * position), *pixel)) + f" {10 * k} {name}")
    path = tmp_path / "gcp.txt"
    path.write_text("\n".join(lines))
    return path


@pytest.mark.slow
def test_control_is_reported_and_remakes_only_the_mesh(imaged, quick, film, output, tmp_path):
    args = ("video", film, "-o", output, "--work", tmp_path / "work", "--force")
    answer(*args)
    quick.ran.clear()
    report = answer(*args[:-1], "--force", "--resume", "--control", imaged)
    assert quick.ran == ["mesh"]
    assert (report["fit"]["by"], report["units"], report["reliable"]) == ("control", "meters", True)
    assert abs(report["fit"]["scale"] - 2) < 1e-4 and len(report["fit"]["control"]["points"]) == 6
    assert report["fit"]["control"]["control_rms_m"] < 1e-4
    quick.ran.clear()
    imaged.write_text(imaged.read_text().replace(" E", " CHK-E"))
    result = run(*args[:-1], "--force", "--resume", "--control", imaged)
    assert quick.ran == ["mesh"] and "5 control points" in result.stdout and "1 check point" in result.stdout


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (lambda text: text.replace(" 10 A", " 11 A"), "'11' matches no image"),
        (lambda text: text + "\n1 2 9 70 20 30 G", "outside of 30 of 64 x 48"),
    ],
)
def test_impossible_marks_are_rejected_early(imaged, quick, film, output, change, reason):
    imaged.write_text(change(imaged.read_text()))
    message = refusal("video", film, "-o", output, "--control", imaged)
    assert reason in message and "gcp.txt (line " in message
    assert quick.ran == ["frames"]


def test_a_blunder_has_exit_code_3_and_its_name(imaged, film, output):
    text = imaged.read_text()
    first = next(line for line in text.splitlines() if line.endswith(" C"))
    coordinates = " ".join(first.split()[:3])
    imaged.write_text(text.replace(coordinates, f"{float(first.split()[0]) + 40} {' '.join(first.split()[1:3])}"))
    assert "C by 40" in str(unreliable("video", film, "-o", output, "--control", imaged)["warnings"])


def test_scale_bars_alone_set_the_size(imaged, film, output, tmp_path):
    bars = tmp_path / "bars.txt"
    marks = [line.split() for line in imaged.read_text().splitlines()[1:]]
    length = 2 * np.linalg.norm(POSITIONS[0] - POSITIONS[3])
    bars.write_text("\n".join([*(f"mark {w[6]} {w[5]} {w[3]} {w[4]}" for w in marks), f"bar A D {length}"]))
    report = answer("video", film, "-o", output, "--scale-bars", bars)
    assert report["fit"]["by"] == "scale_bars" and abs(report["fit"]["scale"] - 2) < 1e-3


def gps_positions(count=COUNT, size=20.0, level=True):
    """GPS of the fast stages' images for a unit of `size` meters, with x east and y north as in their poses."""
    k = np.arange(count)
    enu = size * np.column_stack([0.5 * k, np.where(k % 2 == 0, -1.0, 0.0), np.zeros(count)])
    enu[:, 1] *= level
    sigmas, rows = {"horizontal_sigma": 0.02, "vertical_sigma": 0.02}, FRAME.to_geodetic(enu).tolist()
    positions = [ImagePosition(f"frame_{10 * k:06d}.png", *row, **sigmas) for k, row in enumerate(rows)]
    return ImagePositions(tuple(positions), {}, {}, COUNT)


def settings_with(positions, **units):
    return loom.photogrammetry.VideoSettings(units=loom.photogrammetry.VideoUnits(places=positions, **units))


def outputs(folder, cell=0.5):
    return loom.photogrammetry.VideoOutputs(
        folder / "m.ply", ortho=folder / "ortho.tif", dem=folder / "dem.tif", cell=cell
    )


def test_maps_are_georeferenced_by_gps(quick, film, tmp_path):
    rasterio = pytest.importorskip("rasterio")
    result = loom.photogrammetry.reconstruct_video(
        film, settings_with(gps_positions()), outputs=outputs(tmp_path), device="cpu"
    )
    assert result.fit is not None and result.fit.by == "exif" and result.mesh is not None
    assert [name.rsplit("/", 1)[1] for name in result.files] == ["m.ply", "ortho.tif", "dem.tif"]
    vertices = result.fit.frame.to_utm(result.mesh.vertices)
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    first_camera = FRAME.to_utm([[0.0, 0, 0]])[0]
    assert np.abs(first_camera[:2] - low[:2]).max() < 1 and np.abs(high[:2] - low[:2] - 20).max() < 1
    with rasterio.open(tmp_path / "ortho.tif") as ortho, rasterio.open(tmp_path / "dem.tif") as dem:
        assert ortho.crs.to_epsg() == dem.crs.to_epsg() == result.fit.frame.epsg == 32632
        assert (ortho.bounds, ortho.res) == (dem.bounds, (0.5, 0.5))
        assert np.abs(np.array(ortho.bounds) - (*low[:2], *high[:2])).max() <= 0.5
        colors, heights = ortho.read(), dem.read(1, masked=True)
    assert (colors[:3, colors[3] == 255] == 255).all()
    assert (colors[3] == 255).sum() * 0.25 == pytest.approx(400, rel=0.1)
    assert heights.min() >= low[2] - 1e-3 and heights.max() <= high[2] + 1e-3
    np.testing.assert_array_equal(heights.mask, colors[3] == 0)


@pytest.mark.parametrize(
    ("settings", "ran"),
    [
        (loom.photogrammetry.VideoSettings(), []),  # a film
        (loom.photogrammetry.VideoSettings(units=loom.photogrammetry.VideoUnits(scale=2.0)), []),
        (settings_with(gps_positions(2)), []),
        (settings_with(gps_positions(), align="none"), []),
        (settings_with(gps_positions(level=False)), STAGES[:4]),  # on a line, which only the model shows
    ],
)
def test_maps_without_georeference_are_rejected_early(quick, film, tmp_path, settings, ran):
    pytest.importorskip("rasterio")
    with pytest.raises(loom.FileError, match=r"ortho\.tif"):
        loom.photogrammetry.reconstruct_video(film, settings, outputs=outputs(tmp_path))
    assert (quick.ran, names_in(tmp_path)) == (ran, ["m-video"] * bool(ran) + ["walk.mp4"])


def test_too_many_cells_are_rejected_early(quick, film, tmp_path, monkeypatch):
    pytest.importorskip("rasterio")
    read = motion.read_model

    def with_points(made):
        model = read(made)
        points = np.random.default_rng(0).uniform(0, 1, (50, 3))
        return loom.SfmModel(model.names, model.cameras, model.T_camera_world, points)

    monkeypatch.setattr(motion, "read_model", with_points)
    with pytest.raises(ValueError, match="cell:"):
        loom.photogrammetry.reconstruct_video(film, settings_with(gps_positions()), outputs=outputs(tmp_path, 1e-5))
    assert quick.ran == STAGES[:4]


@pytest.mark.parametrize("given", [{"ortho": "o.tif"}, {"cell": 1.0}, {"dem": "d.tif", "cell": -1.0}])
def test_maps_and_cells_go_together(given):
    with pytest.raises(ValueError, match="cell: "):
        loom.photogrammetry.VideoOutputs("m.ply", **given)

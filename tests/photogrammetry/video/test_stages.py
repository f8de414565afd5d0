"""A stage is complete or absent, and is remade only if its inputs changed; the stages after the model."""

import errno
import json
import os
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.core.stages import Chain, Stage, StageResult
from pointloom.photogrammetry.mvs.depth_maps import DepthMap, DepthMaps
from pointloom.photogrammetry.video import motion, surface
from pointloom.photogrammetry.video.units import VideoUnits

from ...interruptions import run_lines
from ..sfm.conftest import silent
from ..sfm.made_features import seen_model

NAMES = ("first", "second", "third")


class Job:
    """Three stages: each appends a setting to the text of the previous one."""

    def __init__(self, root, *, resume=True, **settings):
        root.mkdir(exist_ok=True)
        self.settings = {"first": "a", "second": "b", "third": "c"} | settings
        self.ran, self.reported = [], []
        self.chain = Chain(root, NAMES, resume=resume, progress=lambda *step: self.reported.append(step))

    def run(self):
        made = None
        for name in NAMES:
            made = self.chain.run(self.stage(name, () if made is None else (made,)))
        return self.chain.made

    def stage(self, name, after):
        def make(folder, report):
            self.ran.append(name)
            report("letter", 1, 2)
            before = "".join((made.folder / "deep" / "text").read_text() for made in after)
            (folder / "deep").mkdir()
            # only the letter counts, not its case: another setting may give the same files
            (folder / "deep" / "text").write_text(before + self.settings[name].lower())
            return {"length": len(before) + 1, "fraction": float("nan")}

        return Stage(name, make, {"letter": self.settings[name]}, after)


def files_in(root):
    """All files but the records, which contain times."""
    paths = (path for path in root.rglob("*") if path.is_file() and path.parent.name != "records")
    return {path.relative_to(root).as_posix(): path.read_bytes() for path in paths}


def test_a_finished_job_is_reused(tmp_path):
    first = Job(tmp_path)
    made = first.run()
    assert first.ran == [*NAMES]
    again = Job(tmp_path)
    reused = again.run()
    assert again.ran == []
    assert [m.is_reused for m in made.values()] == [False] * 3
    assert [m.is_reused for m in reused.values()] == [True] * 3
    assert [m.report for m in reused.values()] == [m.report for m in made.values()]
    assert [m.cost for m in reused.values()] == [m.cost for m in made.values()]
    assert made["third"].report == {"length": 3, "fraction": None}
    assert set(made["third"].cost) == {"seconds", "cpu_seconds", "peak_bytes"}
    assert (tmp_path / "third" / "deep" / "text").read_text() == "abc"
    assert first.reported == [(f"{name}: letter", 1, 2) for name in NAMES]


@pytest.mark.parametrize(
    ("changed", "ran"),
    [
        ({"first": "x"}, ["first", "second", "third"]),
        ({"second": "x"}, ["second", "third"]),
        ({"third": "x"}, ["third"]),
        ({"first": "A"}, ["first"]),  # another setting that gives the same file: later stages are reused
        ({}, []),
    ],
)
def test_only_what_changed_is_made_again(tmp_path, changed, ran):
    Job(tmp_path / "resumed").run()
    job = Job(tmp_path / "resumed", **changed)
    job.run()
    assert job.ran == ran
    Job(tmp_path / "whole", **changed).run()
    assert files_in(tmp_path / "resumed") == files_in(tmp_path / "whole")


@pytest.mark.parametrize(
    "damage", ["cut off", "removed", "record cut off", "record changed", "record removed", "folder removed"]
)
def test_a_damaged_stage_is_made_again(tmp_path, damage):
    Job(tmp_path).run()
    complete, text, record = files_in(tmp_path), tmp_path / "second/deep/text", tmp_path / "records/second.json"
    if damage == "cut off":
        text.write_text("a")
    elif damage == "record cut off":
        record.write_text(record.read_text()[:40])
    elif damage == "record changed":
        content = json.loads(record.read_text())
        record.write_text(json.dumps(content | {"result": content["result"] | {"told": None}}))
    elif damage == "folder removed":
        text.unlink()
        text.parent.rmdir()
        text.parent.parent.rmdir()
    else:
        (record if "record" in damage else text).unlink()
    job = Job(tmp_path)
    job.run()
    assert job.ran == ["second"]  # bitwise identical: the third is reused
    assert files_in(tmp_path) == complete


@pytest.mark.parametrize("record", ["sound", "cut off", "removed"])
@pytest.mark.parametrize("resume", [True, False])
@pytest.mark.parametrize("name", ["second/notes.txt", "second/deep/mine", "second"])
def test_a_file_that_is_not_of_the_run_stays(tmp_path, resume, record, name):
    """Also where the record of the stage cannot be read, so that its files are known only when they are made again."""
    Job(tmp_path).run()
    complete, file = files_in(tmp_path), tmp_path / "records/second.json"
    if name == "second":
        (tmp_path / "second" / "deep" / "text").unlink()
        (tmp_path / "second" / "deep").rmdir()
        (tmp_path / "second").rmdir()
    (tmp_path / name).write_text("mine")
    {"cut off": lambda: file.write_text(file.read_text()[:40]), "removed": file.unlink}.get(record, lambda: 0)()
    with pytest.raises(FileError, match=rf"{name}: is not a file of the run, which replaces the folder second\. Move"):
        Job(tmp_path, resume=resume, second="x").run()
    assert (tmp_path / name).read_text() == "mine"
    (tmp_path / name).unlink()
    Job(tmp_path).run()
    assert files_in(tmp_path) == complete


def test_another_version_of_a_stage_makes_it_again(tmp_path):
    chain = Job(tmp_path).chain
    ran = []
    for version in (1, 1, 2):
        chain.run(Stage("first", lambda folder, report, v=version: ran.append(v) or {}, version=version))
    assert ran == [1, 2]


def test_stages_of_another_version_are_remade_and_reported(tmp_path):
    def run(**code):
        return Job(tmp_path).chain.run(Stage("first", lambda folder, report: {}, code=code))

    assert run(pointloom="1.0").outdated == "" and run(pointloom="1.0").is_reused
    newer = run(pointloom="1.1")
    assert not newer.is_reused and newer.outdated == "pointloom 1.0, now 1.1"
    other = Job(tmp_path).chain.run(Stage("first", lambda folder, report: {}, {"a": 1}, code={"pointloom": "1.1"}))
    assert not other.is_reused and other.outdated == ""  # a setting was changed, not the version


def test_an_interrupted_stage_finds_its_partial_files(tmp_path):
    seen = []

    def make(folder, report, going, *, fail):
        seen.append(sorted(path.name for path in going.iterdir() if path.name.isdigit()))
        (going / str(len(seen))).write_text("so far")
        if fail:
            raise KeyboardInterrupt
        (folder / "text").write_text("whole")
        return {}

    def run(fail, setting=1, resume=True):
        chain = Job(tmp_path, resume=resume).chain
        chain.run(Stage("first", lambda *given: make(*given, fail=fail), {"setting": setting}, goes_on=True))

    for fail, setting in ((True, 1), (True, 1), (True, 2), (False, 2)):
        if fail:
            with pytest.raises(KeyboardInterrupt):
                run(fail, setting)
        else:
            run(fail, setting)
    assert seen == [[], ["1"], [], ["3"]]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["first", "records"]
    with pytest.raises(KeyboardInterrupt):
        run(True, 3)
    Job(tmp_path, resume=False)
    assert not (tmp_path / "first.going").exists()


def test_without_resume_all_stages_are_remade(tmp_path):
    Job(tmp_path).run()
    job = Job(tmp_path, resume=False)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["records"]
    job.run()
    assert job.ran == [*NAMES]


def test_an_interrupted_job_resumes_to_bitwise_identical_files(tmp_path):
    files = ("core/stages.py", __file__)
    lines = run_lines(lambda: Job(tmp_path / "whole").run(), files)
    complete = files_in(tmp_path / "whole")
    for stop in range(1, lines, 5):
        root = tmp_path / str(stop)
        assert run_lines(lambda root=root: Job(root).run(), files, stop) == stop
        for name in NAMES:  # the folder of a stage is complete or absent
            assert not (root / name).exists() or (root / name / "deep" / "text").is_file()
        assert Job(root).run()["third"].report["length"] == 3
        assert files_in(root) == complete


def test_a_stage_that_fails_leaves_nothing_of_itself(tmp_path):
    job = Job(tmp_path)

    def fail(folder, report):
        (folder / "half").write_text("half")
        raise ValueError("no")

    first = job.chain.run(job.stage("first", ()))
    with pytest.raises(ValueError, match="no"):
        job.chain.run(Stage("second", fail, {}, (first,)))
    assert sorted(path.name for path in tmp_path.iterdir()) == ["first", "records"]


def test_a_full_disk_is_an_error_and_finished_stages_remain(tmp_path):
    job = Job(tmp_path)

    def full(folder, report):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(folder / "big"))

    first = job.chain.run(job.stage("first", ()))
    with pytest.raises(FileError, match=r"second\.part/big: cannot be written: No space left"):
        job.chain.run(Stage("second", full, {}, (first,)))
    again = Job(tmp_path)
    again.run()
    assert again.ran == ["second", "third"]


def test_a_killed_run_leaves_a_part_that_the_next_removes(tmp_path):
    (tmp_path / "second.part").mkdir()
    (tmp_path / "second.part" / "half").write_text("half")
    Job(tmp_path).run()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["first", "records", "second", "third"]


WIDTH, HEIGHT = 96, 64
IMAGE_NAMES = ("frame_000003.jpg", "frame_000010.jpg", "frame_000020.jpg")


def made(folder):
    return StageResult(folder.name, folder, "", {}, {}, False)


@pytest.fixture
def before(tmp_path, rng):
    frames, model = tmp_path / "frames", tmp_path / "model"
    (frames / motion.IMAGES).mkdir(parents=True)
    for name in IMAGE_NAMES:
        pixels = rng.integers(0, 256, (HEIGHT, WIDTH, 3), np.uint8)
        Image.fromarray(pixels).save(frames / motion.IMAGES / name)
    camera = loom.CameraModel("SIMPLE_RADIAL", WIDTH, HEIGHT, [80.0, 47.0, 33.0, -0.12])
    loom.write_colmap_model(model / motion.MODEL, seen_model(camera, IMAGE_NAMES, angle=0))
    return made(frames), made(model)


@pytest.fixture
def straight(before, tmp_path):
    return straighten(before, tmp_path, 1000)


def straighten(before, tmp_path, max_size):
    folder = tmp_path / "undistorted"
    folder.mkdir()
    given = {"frames": before[0], "model": before[1], "max_size": max_size}
    report = surface.straighten(folder, silent, **given, device="cpu")
    return StageResult("undistorted", folder, "", report, {}, False)


@pytest.mark.parametrize("max_size", [1000, 64, 40])
def test_undistorted_images_show_sparse_points_as_a_pinhole(before, tmp_path, max_size):
    result = straighten(before, tmp_path, max_size)
    model, paths, cameras = surface.open_straightened(result)
    assert model.names == tuple(f"{Path(name).stem}.png" for name in IMAGE_NAMES)
    assert len(model.observations) > 60
    for k, (path, camera) in enumerate(zip(paths, cameras, strict=True)):
        assert loom.read_color(path).shape == (camera.intrinsic.height, camera.intrinsic.width, 3)
        mine = model.observations[:, 0] == k
        points = model.points[model.observations[mine, 1]]
        local = points @ camera.T_camera_world[:3, :3].T + camera.T_camera_world[:3, 3]
        lens = camera.intrinsic
        pixels = local[:, :2] / local[:, 2:] * (lens.fx, lens.fy) + (lens.cx, lens.cy)
        np.testing.assert_allclose(pixels, model.pixels[mine], atol=1e-6)
    size = result.report["sizes"][0]
    assert max(size) == max_size if max_size < WIDTH else max(size) >= WIDTH - 10


def empty_mesh(straight, tmp_path, units):
    """Reports of the last two stages without depth."""
    _, _, cameras = surface.open_straightened(straight)
    lens = cameras[0].intrinsic
    empty = DepthMap(*(np.zeros((lens.height, lens.width, *rest)) for rest in ((), (3,), ())))
    DepthMaps(cameras, [(1,), (0, 2), (1,)], [empty] * 3, folder=tmp_path / "depth" / surface.MAPS)
    for name in ("fused", "mesh"):
        (tmp_path / name).mkdir()
    where = {"undistorted": straight, "device": "cpu"}
    fused = surface.fuse_points(tmp_path / "fused", silent, depth=made(tmp_path / "depth"), **where)
    given = {"model": straight, "fused": made(tmp_path / "fused"), "units": units}
    return fused, surface.make_mesh(tmp_path / "mesh", silent, **given, **where)


def test_no_depth_gives_no_points_and_an_empty_mesh(straight, tmp_path):
    fused, mesh = empty_mesh(straight, tmp_path, VideoUnits())
    assert fused == {"fraction": 0.0, "points": 0}
    assert (mesh["triangles"], mesh["bounds"]) == (0, None)


@pytest.mark.parametrize("scale", [None, 30.0])
def test_poses_beside_the_mesh_carry_the_numbers_of_their_images_and_its_unit(straight, tmp_path, scale):
    empty_mesh(straight, tmp_path, VideoUnits(scale=scale))
    path = loom.read_trajectory(tmp_path / "mesh" / surface.POSES_LOG)
    assert path.ids[:, 0].tolist() == [3, 10, 20]
    expected = np.array([0, 0.1, 0.2]) * (scale or 1.0)
    np.testing.assert_allclose(path.poses[:, 0, 3], expected, atol=1e-9)
    model = loom.read_cameras(tmp_path / "mesh" / surface.SPARSE)
    np.testing.assert_allclose(model.centers[:, 0], expected, atol=1e-9)


def test_the_share_of_a_masked_image_counts_unmasked_pixels(tmp_path):
    Image.fromarray(np.repeat(np.array([[255, 0, 0, 0]], np.uint8), 3, axis=0)).save(tmp_path / "small.png")
    Image.fromarray(np.zeros((3, 4), np.uint8)).save(tmp_path / "hidden.png")
    depth = np.zeros((3, 4))
    depth[:2, 0] = 1.0  # 2 of the 3 pixels that are left, 2 of 12 of all
    one, none = (DepthMap(z, np.zeros((3, 4, 3)), np.zeros((3, 4))) for z in (depth, 0 * depth))
    assert surface.mean_fraction([one], [tmp_path / "small.png"]) == pytest.approx(2 / 3)
    assert surface.mean_fraction([one, none], [None, tmp_path / "hidden.png"]) == pytest.approx(1 / 12)


def test_small_floating_parts_are_removed():
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], float)
    vertices = np.concatenate([corners, 0.5 * corners + 3, 0.05 * corners + 9])
    mesh = loom.TriangleMesh(vertices, np.arange(9).reshape(3, 3))
    assert len(surface.without_floaters(mesh)) == 2
    assert len(surface.without_floaters(loom.TriangleMesh())) == 0

"""`pointloom depth`: input and output files, exit codes, messages."""

import json
import shutil

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.io.points import ply
from pointloom.photogrammetry.depth.presets import DEFAULT

from ...cli.commands import answer, names_in, refusal, run, unreliable
from .test_estimation import CAMERA, IMAGE, SIDE, scene, sparse_model
from .tiny_networks import fixed_map


@pytest.fixture
def folder(tmp_path):
    """An image, a network that gives its depth up to scale and shift, and its true depth."""
    z = scene()
    fixed_map(tmp_path / "net.onnx", 37 / z + 5)
    Image.fromarray(IMAGE).save(tmp_path / "photo.png")
    np.save(tmp_path / "z.npy", z.astype(np.float32))
    CAMERA.write(tmp_path / "camera.json")
    return tmp_path


def words(folder, *more, output="out.ply", image="photo.png"):
    return ["depth", folder / image, "--model", folder / "net.onnx", "-o", folder / output, "--device", "cpu", *more]


def test_an_image_becomes_a_cloud_in_meters(folder):
    extras = ["--picture", folder / "out.png", "--depth-map", folder / "depth.npy"]
    report = answer(*words(folder, "--align", folder / "z.npy", "--intrinsic", folder / "camera.json", *extras))
    (each,) = report["images"]
    assert (report["provider"], report["preset"], report["reliable"]) == ("CPUExecutionProvider", DEFAULT, True)
    assert (each["unit"], each["is_metric"], each["inlier_fraction"], each["references"]) == ("m", True, 1.0, SIDE**2)
    assert each["camera"] == {
        "fx": 500.0, "fy": 510.0, "cx": 250.0, "cy": 262.0, "width": SIDE, "height": SIDE, "source": "given"
    }  # fmt: skip
    assert report["files"] == [str(folder / name) for name in ("out.ply", "depth.npy", "out.png")]
    cloud = loom.read_point_cloud(folder / "out.ply")
    assert len(cloud) == each["points"] > 0.98 * SIDE**2
    np.testing.assert_allclose(loom.read_depth(folder / "depth.npy"), scene(), rtol=1e-3)
    assert b"\ncomment pointloom depth: meters\n" in (folder / "out.ply").read_bytes()[:400]
    image = loom.read_color(folder / "out.png")
    assert image.shape == (SIDE, SIDE, 3)
    assert (image != image[0, 0]).any(2).mean() > 0.3


def test_the_unit_is_reported_arbitrary_without_references(folder):
    result = run(*words(folder))
    assert result.exit_code == 3 and "shapes are distorted if it differs; pass intrinsic (--intrinsic)" in result.stderr
    for part in (
        "units arbitrary: the nearest pixel is at 1; --align gives meters", "from assumed 60 degrees",
        "CPUExecutionProvider", "Apache-2.0",
        "518 x 518, 518 x 518 for the network",
    ):  # fmt: skip
        assert part in result.stdout
    assert b"comment pointloom depth: units arbitrary" in (folder / "out.ply").read_bytes()[:400]
    assert loom.read_point_cloud(folder / "out.ply").points[:, 2].min() == pytest.approx(1, rel=1e-5)


def test_references_that_do_not_agree_are_rejected_and_nothing_is_written(folder):
    before = names_in(folder)
    np.save(folder / "falling.npy", (8.0 - scene()).astype(np.float32))
    report = unreliable(*words(folder, "--align", folder / "falling.npy", "--picture", folder / "out.png"))
    assert "check that they belong to this image" in str(report["warnings"])
    assert "nothing was written" in str(report["warnings"])
    assert report["files"] == []
    assert names_in(folder) == sorted([*before, "falling.npy"])


def test_few_references_that_agree_are_unreliable(folder):
    sensor = scene()
    rows = np.random.default_rng(0).random(sensor.shape)
    sensor[rows < 0.8] *= np.random.default_rng(1).uniform(1.3, 9, (rows < 0.8).sum())
    np.save(folder / "noisy.npy", sensor.astype(np.float32))
    report = unreliable(*words(folder, "--align", folder / "noisy.npy"))
    assert "references agree with the map within 10%" in str(report["warnings"])
    assert (folder / "out.ply").exists()


def test_a_map_with_little_valid_depth_is_unreliable(folder):
    # most pixels are over ten times beyond the range of the sensor
    v = np.tile(np.linspace(0, 1, SIDE)[:, None] ** 30, SIDE)
    fixed_map(folder / "net.onnx", v)
    sensor = np.where(v > 0.3, 1 / np.maximum(v, 0.3) * 0.3, 0)
    np.save(folder / "near.npy", sensor.astype(np.float32))
    report = unreliable(*words(folder, "--align", folder / "near.npy"))
    assert "of the pixels became points" in str(report["warnings"])


@pytest.mark.slow
def test_a_folder_keeps_names_and_takes_references_by_name(folder):
    images, sensors = folder / "images", folder / "sensors"
    for folder_path in (images, sensors):
        folder_path.mkdir()
    for name in ("b.jpg", "a.png", "c.PNG"):
        Image.fromarray(IMAGE).save(images / name)
        shutil.copy(folder / "z.npy", sensors / f"{name[0]}.npy")
    (images / "notes.txt").write_text("no image")
    report = unreliable(*words(folder, "--align", sensors, image="images", output="clouds"))
    assert "the camera is assumed 60 degrees" in str(report["warnings"])
    assert names_in(folder / "clouds") == ["a.ply", "b.ply", "c.ply"]
    assert [each["image"] for each in report["images"]] == [str(images / n) for n in ("a.png", "b.jpg", "c.PNG")]
    assert all(each["is_metric"] for each in report["images"])
    assert "exists already" in refusal(*words(folder, image="images", output="clouds"))
    shown = run(*words(folder, "--force", image="images", output="clouds"))
    assert shown.exit_code == 3
    assert "a.png" in shown.stdout
    assert "units arbitrary" in shown.stdout


def test_a_folder_is_aligned_to_one_colmap_model(folder):
    images = folder / "images"
    images.mkdir()
    for name in ("left.png", "photo.png"):
        Image.fromarray(IMAGE).save(images / name)
    loom.write_colmap_model(folder / "work" / "sparse" / "0", sparse_model(scene()))
    report = unreliable(*words(folder, "--align", folder / "work", image="images", output="clouds"))
    (each,) = report["images"]
    assert (each["unit"], each["is_metric"], each["references"]) == ("the sparse model's", False, 120)
    message = "1 of 2 images failed: align: expected at least 20 references inside the image, got 2"
    assert "; ".join(report["warnings"]).startswith(message)
    assert b"comment pointloom depth: in the unit of the sparse model" in (folder / "clouds" / "photo.ply").read_bytes()


def test_a_damaged_image_of_a_folder_does_not_stop_the_others(folder):
    images = folder / "images"
    images.mkdir()
    Image.fromarray(IMAGE).save(images / "good.png")
    (images / "bad.png").write_bytes(b"no image")
    report = unreliable(*words(folder, image="images", output="clouds"))
    assert names_in(folder / "clouds") == ["good.ply"]
    assert [each["image"] for each in report["failures"]] == [str(images / "bad.png")]
    assert "1 of 2 images failed" in str(report["warnings"])
    (images / "good.png").unlink()
    assert "neither PNG nor JPEG" in refusal(*words(folder, "--force", image="images", output="clouds"))


@pytest.mark.parametrize(
    ("more", "reason"),
    [
        (["--device", "cuda:0"], "cuda:0"),
        (["--preset", "metric3d-v2"], "fails on an input of"),
        (["--align", "none.npy"], "none.npy: cannot be read"),
        (["--intrinsic", "none.json"], "none.json"),
        (["--picture", "out.jpg"], "ends in .png"),
        (["--depth-map", "depth.png"], "ends in .npy"),
        (["-o", "cloud.obj"], "clouds are not written to .obj"),
        (["-o", "no/out.ply"], "Make the folder first"),
        (["--model", "camera.json"], "not a usable ONNX model"),
        (["--model", "none.onnx"], "none.onnx: does not exist"),
    ],
)
def test_errors_name_the_file_and_leave_nothing(folder, monkeypatch, more, reason):
    monkeypatch.chdir(folder)
    before = names_in(folder)
    assert reason in refusal(*words(folder, *more))
    assert names_in(folder) == before


def test_colliding_names_in_a_folder_are_an_error(folder):
    images = folder / "images"
    images.mkdir()
    given = {"image": "images", "output": "clouds"}
    assert "contains no images" in refusal(*words(folder, **given))
    for name in ("a.png", "a.jpg"):
        Image.fromarray(IMAGE).save(images / name)
    assert "another image would also be written to a.ply" in refusal(*words(folder, **given))
    assert "is a single cloud, but the source is a folder" in refusal(*words(folder, image="images"))
    (images / "a.jpg").unlink()
    more = ["--picture", folder / "out.png"]
    assert "--picture requires a single image" in refusal(*words(folder, *more, **given))


@pytest.mark.parametrize(
    ("more", "hint"),
    [
        ("", "missing argument"), ("photo.png", "missing option"), ("photo.png --model m.onnx", "missing option '-o'"),
        ("p.png --model m.onnx -o a.ply --preset monodepth2", "--preset"),
        ("p.png --model m.onnx -o a.ply --tiles 0", "--tiles"),
        ("p.png --model m.onnx -o a.png --picture a.png", "--picture is the same file as --output"),
        ("p.png --model m.onnx -o a.ply --depth-scale nan", "--depth-scale"),
    ],
)  # fmt: skip
def test_wrong_calls_exit_with_2(more, hint):
    result = run("depth", *more.split())
    assert result.exit_code == 2
    assert hint in result.stderr


def test_a_full_disk_leaves_no_half_cloud(folder, monkeypatch):
    def full(*_args, **_options):
        raise OSError(28, "No space left on device")

    before = names_in(folder)
    monkeypatch.setattr(ply, "_write_columns", full)
    assert "cannot be written: No space left on device" in refusal(*words(folder))
    assert names_in(folder) == before


def test_other_formats_and_existing_files(folder):
    assert "the camera is assumed" in str(unreliable(*words(folder, output="out.npz"))["warnings"])
    assert len(loom.read_point_cloud(folder / "out.npz")) > 0.9 * SIDE**2
    assert "exists already" in refusal(*words(folder, output="out.npz"))
    assert json.loads(run(*words(folder, "--json", "--force", output="out.npz")).stdout)["command"] == "depth"

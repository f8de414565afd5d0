"""Training folders for splats: undistorted images, COLMAP's files and transforms.json agree with the model."""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.cameras.undistortion import Undistortion
from pointloom.core.errors import FileError

from .conftest import has_pycolmap
from .made_features import seen_model

SIZE = (96, 64)
LENSES = {
    "PINHOLE": [80.0, 82.0, 47.0, 33.0],
    "OPENCV": [80.0, 82.0, 47.0, 33.0, -0.12, 0.02, 0.002, -0.001],
    "OPENCV_FISHEYE": [50.0, 51.0, 47.0, 33.0, 0.02, -0.01, 0.001, 0.0],
    "METASHAPE": [80.0, 0.4, -0.6, -0.05, 0.01, 0.0, 0.001, 0.0, 0.0, 1.0, 0.0],
}
UTM = np.array([465_123.25, 5_243_871.5, 431.0])


def model_of(kind="OPENCV", *, origin=(0.0, 0.0, 0.0), names=("day 1/a.jpg", "day 2/b.jpg", "c.png")) -> loom.SfmModel:
    T = np.eye(4)
    T[:3, 3] = origin
    return seen_model(loom.CameraModel(kind, *SIZE, LENSES[kind]), names).transform(T)


def photographs(folder: Path, model: loom.SfmModel) -> Path:
    rng = np.random.default_rng(1)
    for name in model.names:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        Image.fromarray(rng.integers(0, 256, (SIZE[1], SIZE[0], 3), np.uint8)).save(path)
    return folder


def source_of(model: loom.SfmModel, name: str) -> int:
    """Index of the model's image for an image of the folder, whose order may differ."""
    return [Path(each).stem for each in model.names].index(Path(name).stem)


def written(tmp_path, model, **options):
    images = photographs(tmp_path / "photos", model)
    report = loom.photogrammetry.write_training_folder(tmp_path / "scene", model, images, **options)
    return report, tmp_path / "scene"


@pytest.mark.parametrize(("kind", "max_size"), [*zip(LENSES, (50, None, 50, None), strict=True)])
def test_points_project_to_undistorted_observations(tmp_path, kind, max_size):
    model = model_of(kind)
    report, scene = written(tmp_path, model, max_size=max_size)
    result = loom.read_cameras(scene / "sparse" / "0")
    assert {camera.model for camera in result.cameras} == {"PINHOLE"}
    np.testing.assert_array_equal(result.colors, model.colors)
    assert len(result.observations) > 0.8 * len(model.observations)
    sizes = np.array([(camera.width, camera.height) for camera in result.cameras])[result.observations[:, 0]]
    assert ((result.pixels >= -0.5) & (result.pixels <= sizes - 0.5)).all()
    straight = Undistortion(model.cameras[0], max_size=max_size).intrinsic
    for k, camera in enumerate(result.cameras):
        with Image.open(scene / "images" / result.names[k]) as image:
            assert image.size == (camera.width, camera.height) == (straight.width, straight.height)
        assert (camera.intrinsic.cx, camera.intrinsic.cy) == pytest.approx((straight.cx, straight.cy), abs=1e-9)
        mine = result.observations[result.observations[:, 0] == k, 1]
        T, own = result.T_camera_world[k], source_of(model, result.names[k])
        at = camera.project(result.points[mine] @ T[:3, :3].T + T[:3, 3])
        # where the image that the lens took has this very point, as the pinhole draws its ray
        before = model.pixels[(model.observations[:, 0] == own) & np.isin(model.observations[:, 1], mine)]
        rays = model.cameras[own].unproject(before)
        expected = rays[:, :2] * (straight.fx, straight.fy) + (straight.cx, straight.cy)
        assert np.abs(at - expected).max() < 0.05
    assert result.errors[result.view_counts > 0].max() < 1e-3
    assert report.straightened_count == (1 if kind != "PINHOLE" or max_size else 0) * 3
    assert max(max(size) for size in report.sizes) <= (max_size or 200)


@pytest.mark.parametrize("kind", ["PINHOLE", "OPENCV"])
def test_transforms_match_the_colmap_files(tmp_path, kind):
    _, scene = written(tmp_path, model_of(kind))
    sparse, nerf = loom.read_cameras(scene / "sparse" / "0"), loom.read_cameras(scene / "transforms.json")
    assert nerf.names == tuple(f"images/{name}" for name in sparse.names)
    np.testing.assert_allclose(nerf.T_camera_world, sparse.T_camera_world, atol=1e-12)
    assert [camera.intrinsic for camera in nerf.cameras] == [camera.intrinsic for camera in sparse.cameras]
    cloud = loom.read_point_cloud(scene / "sparse_pc.ply")
    np.testing.assert_allclose(cloud.points, sparse.points, atol=1e-6)


def test_undistorted_pixels_match_the_camera_model(tmp_path):
    """Images whose brightness is the column or the row show the points at their original pixels."""
    model = model_of("OPENCV")
    v, u = np.mgrid[: SIZE[1], : SIZE[0]]
    for axis, ramp in enumerate((u, v)):
        images = [np.rint(ramp * 2.5).astype(np.uint8)] * 3
        loom.photogrammetry.write_training_folder(tmp_path / f"{axis}", model, images)
        result, off = loom.read_cameras(tmp_path / f"{axis}" / "sparse" / "0"), []
        for k, name in enumerate(result.names):
            shown = loom.read_color(tmp_path / f"{axis}" / "images" / name)[..., 0] / 2.5
            mine, first = (m.observations[:, 0] == n for m, n in ((result, k), (model, source_of(model, name))))
            x, y = result.pixels[mine].T
            i, j = np.floor(x).astype(int).clip(0, len(shown[0]) - 2), np.floor(y).astype(int).clip(0, len(shown) - 2)
            read = (shown[j, i] * (1 - x + i) + shown[j, i + 1] * (x - i)) * (1 - y + j)
            read += (shown[j + 1, i] * (1 - x + i) + shown[j + 1, i + 1] * (x - i)) * (y - j)
            expected = dict(zip(model.observations[first, 1].tolist(), model.pixels[first, axis].tolist(), strict=True))
            off += (read - [expected[point] for point in result.observations[mine, 1].tolist()]).tolist()
        assert abs(np.mean(off)) < 0.05 and np.abs(off).max() < 0.4  # a step of gray is 0.4 px


def test_only_undistorted_upright_images_are_copied(tmp_path):
    model = model_of("PINHOLE")
    images = photographs(tmp_path / "photos", model)
    exif = Image.Exif()
    exif[0x0112] = 3
    with Image.open(images / "day 2" / "b.jpg") as image:
        image.save(images / "day 2" / "b.jpg", exif=exif)
    with Image.open(images / "day 2" / "b.jpg") as image:
        pixels = np.array(image)
    report = loom.photogrammetry.write_training_folder(tmp_path / "scene", model, images)
    copies = tmp_path / "scene" / "images"
    assert sorted(path.name for path in copies.iterdir()) == ["a.jpg", "b.png", "c.png"]
    assert (copies / "a.jpg").read_bytes() == (images / "day 1" / "a.jpg").read_bytes()
    with Image.open(copies / "b.png") as image:
        assert image.getexif().get(0x0112, 1) == 1 and np.array_equal(np.array(image), pixels)
    assert report.straightened_count == 1


def test_points_outside_the_undistorted_images_have_no_observation(tmp_path):
    camera = loom.CameraModel("OPENCV_FISHEYE", *SIZE, LENSES["OPENCV_FISHEYE"])
    corner, middle = camera.unproject([[0.0, 0.0], [48.0, 32.0]]) * 2
    seen = {"observations": [[0, 0], [0, 1]], "pixels": [[0.0, 0.0], [48.0, 32.0]]}
    model = loom.SfmModel(["a.png"], [camera], np.eye(4)[None], points=[corner, middle], **seen)
    loom.photogrammetry.write_training_folder(tmp_path / "scene", model, [np.zeros((SIZE[1], SIZE[0], 3), np.uint8)])
    assert loom.read_cameras(tmp_path / "scene" / "sparse" / "0").observations.tolist() == [[0, 1]]


def test_names_differing_by_folder_or_case_stay_distinct(tmp_path):
    _, scene = written(tmp_path, model_of(names=("day 1/a.jpg", "day 2/a.jpg", "day 2/A.png")))
    names = sorted(path.name for path in (scene / "images").iterdir())
    assert names == ["day 1_a.jpg.png", "day 2_A.png.png", "day 2_a.jpg.png"]
    assert tuple(names) == loom.read_cameras(scene / "sparse" / "0").names
    assert len({name.casefold() for name in names}) == 3


@pytest.mark.parametrize("shift", [True, False])
def test_utm_coordinates_are_shifted_and_reported_or_stay_exact(tmp_path, shift):
    model = model_of("OPENCV", origin=UTM)
    report, scene = written(tmp_path, model, shift=shift)
    result = loom.read_cameras(scene / "sparse" / "0")
    content = json.loads((scene / "transforms.json").read_text())
    np.testing.assert_allclose(result.points + report.origin, model.points, atol=2e-9, rtol=0)
    centers = model.centers[[source_of(model, name) for name in result.names]]
    np.testing.assert_allclose(result.centers + report.origin, centers, atol=5e-9, rtol=0)
    frames = np.array([frame["transform_matrix"] for frame in content["frames"]])
    np.testing.assert_allclose(frames[:, :3, 3] + report.origin, centers, atol=5e-9, rtol=0)
    if shift:
        assert np.abs(result.centers).max() < 10 and "subtracted from all coordinates" in str(report)
        applied = np.array(content["applied_transform"])
        np.testing.assert_array_equal(applied, np.column_stack([np.eye(3), -np.array(report.origin)]))
        assert content["applied_scale"] == 1
    else:
        assert report.origin == (0, 0, 0) and "applied_transform" not in content
    assert loom.photogrammetry.write_training_folder(tmp_path / "near", model_of(), tmp_path / "photos").origin == (
        0,
        0,
        0,
    )


def test_masks_are_undistorted_and_complete(tmp_path):
    model = model_of("OPENCV")
    mask = np.zeros(SIZE[::-1], np.uint8)
    mask[:, :47] = 255
    (tmp_path / "masks" / "day 1").mkdir(parents=True)
    Image.fromarray(mask).save(tmp_path / "masks" / "day 1" / "a.jpg.png")
    report, scene = written(tmp_path, model, masks=tmp_path / "masks")
    frames = json.loads((scene / "transforms.json").read_text())["frames"]
    assert [frame["mask_path"] for frame in frames] == [f"masks/{name}.png" for name in ("a.png", "b.png", "c.png")]
    first, second = (np.array(Image.open(scene / frame["mask_path"])) for frame in frames[:2])
    lens = loom.read_cameras(scene / "sparse" / "0").cameras[0].intrinsic
    middle = round(lens.cx)
    assert first.shape == (lens.height, lens.width) and report.mask_count == 3
    assert first[3:-3, 2 : middle - 1].min() == 255 and first[:, middle + 2 :].max() == 0 and second.min() == 255
    given = loom.photogrammetry.write_training_folder(
        tmp_path / "again", model, tmp_path / "photos", masks=[None, mask > 0, mask]
    )
    again = np.array(Image.open(tmp_path / "again" / "masks" / "a.png.png"))
    assert given.mask_count == 3 and np.array_equal(again, first)


def test_images_may_be_arrays_and_models_without_points(tmp_path):
    model = model_of("OPENCV")
    bare = loom.SfmModel(model.names, model.cameras, model.T_camera_world)
    images = [np.full((SIZE[1], SIZE[0]), 90, np.uint8)] * 3
    report = loom.photogrammetry.write_training_folder(tmp_path / "scene", bare, images)
    assert report.point_count == 0 and not (tmp_path / "scene" / "sparse_pc.ply").exists()
    assert len(loom.read_cameras(tmp_path / "scene" / "sparse" / "0")) == 3


def test_invalid_inputs_are_named_and_nothing_is_written(tmp_path):
    model = model_of("PINHOLE")
    images = photographs(tmp_path / "photos", model)
    write = loom.photogrammetry.write_training_folder
    for given, reason in (
        (tmp_path / "nowhere", "c.png: does not exist"),
        ([np.zeros((9, 9, 3), np.uint8)] * 3, r"images\[0\]: expected shape \[64, 96, 3\]"),
        ([np.zeros((64, 96, 3), np.uint8)] * 2, "images: expected one for each of the 3"),
        ([np.zeros((64, 96, 3))] * 3, r"images\[0\]: expected a path or uint8"),
    ):
        with pytest.raises((FileError, ValueError, TypeError), match=reason):
            write(tmp_path / "scene", model, given)
    with pytest.raises(FileError, match=r"/photos:.*c\.png\.png"):
        write(tmp_path / "scene", model, images, masks=tmp_path / "photos")
    Image.new("RGB", (50, 40)).save(images / "c.png")
    with pytest.raises(FileError, match=r"c\.png:"):
        write(tmp_path / "scene", model, images)
    photographs(tmp_path / "photos", model)
    data = (images / "day 2" / "b.jpg").read_bytes()
    (images / "day 2" / "b.jpg").write_bytes(data[: len(data) // 2])
    with pytest.raises(FileError, match=r"b.jpg"):
        write(tmp_path / "scene", model, images)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["photos"]


def test_a_folder_of_this_kind_alone_is_replaced(tmp_path):
    model = model_of("PINHOLE")
    _, scene = written(tmp_path, model)
    before = {path: path.read_bytes() for path in scene.rglob("*") if path.is_file()}
    with pytest.raises(FileError, match="exists already"):
        loom.photogrammetry.write_training_folder(scene, model, tmp_path / "photos")
    loom.photogrammetry.write_training_folder(scene, model, tmp_path / "photos", overwrite=True)
    assert {path: path.read_bytes() for path in scene.rglob("*") if path.is_file()} == before
    with pytest.raises(FileError, match="/photos:"):
        loom.photogrammetry.write_training_folder(tmp_path / "photos", model, tmp_path / "photos", overwrite=True)


PYCOLMAP = """
import json, sys, numpy as np, pycolmap
model = pycolmap.Reconstruction(sys.argv[1])
out = {}
for image in model.images.values():
    points = [p for p in image.points2D if p.has_point3D()]
    xyz = np.array([model.point3D(p.point3D_id).xyz for p in points])
    off = image.camera.img_from_cam(image.cam_from_world() * xyz) - np.array([p.xy for p in points])
    out[image.name] = [image.camera.model.name, image.camera.width, image.camera.height,
                       list(image.camera.params), len(points), float(np.abs(off).max())]
colors = [p.color.tolist() for _, p in sorted(model.points3D.items())]
tracks = sum(p.track.length() for p in model.points3D.values())
print(json.dumps([out, colors, tracks]))
"""


@pytest.mark.slow
@pytest.mark.skipif(not has_pycolmap(), reason="pycolmap is not installed")
def test_pycolmap_reads_the_folder_and_projects_the_points_where_they_are_seen(tmp_path):
    model = model_of("OPENCV")
    _, scene = written(tmp_path, model)
    command = [sys.executable, "-c", PYCOLMAP, str(scene / "sparse" / "0")]
    images, colors, tracks = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
    straight = Undistortion(model.cameras[0]).intrinsic
    assert sorted(images) == ["a.png", "b.png", "c.png"] and colors == model.colors.tolist()
    expected = [straight.fx, straight.fy, straight.cx + 0.5, straight.cy + 0.5]
    for kind, width, height, params, count, off in images.values():
        assert (kind, width, height, params) == ("PINHOLE", straight.width, straight.height, pytest.approx(expected))
        assert count > 30 and off < 0.05
    assert tracks == sum(count for *_, count, _ in images.values())


def test_images_are_reported_and_undistorted_on_the_device(tmp_path, device):
    events, model = [], model_of()
    written(tmp_path, model, device=device, progress=lambda *event: events.append(event))
    count = len(model.names)
    assert events == [("images", k, count) for k in range(count + 1)]

"""Undistorted images and faces of panoramas: each pixel shows its original position, as in COLMAP."""

import contextlib

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.cameras.panoramas import Panorama
from pointloom.cameras.undistortion import Undistortion

from .colmap_oracle import query_colmap
from .test_camera_models import PARAMETERS

WIDTH, HEIGHT = 96, 72
STRONG = {}
for model, params in PARAMETERS.items():  # the numbers that have no unit are those of the larger camera
    scaled = [x * 0.15 if abs(x) > 100 or (model.startswith("META") and i > 8) else x for i, x in enumerate(params)]
    STRONG[model] = loom.CameraModel(model, WIDTH, HEIGHT, scaled)


def ramp(size=(WIDTH, HEIGHT)) -> np.ndarray:
    """Red grows with the column and green with the row, as finely as bytes can; blue is a pattern."""
    v, u = np.mgrid[: size[1], : size[0]]
    return np.stack([2 * u, 3 * v, 50 * (u // 3 % 2) + 50 * (v // 3 % 2)], axis=2).astype(np.uint8)


def source_pixels(camera: loom.CameraModel, intrinsic: loom.PinholeCameraIntrinsic) -> np.ndarray:
    """The position of each pinhole pixel in the distorted image, shape [h, w, 2], by NumPy formulas."""
    v, u = np.mgrid[: intrinsic.height, : intrinsic.width].astype(float)
    rays = np.stack([(u - intrinsic.cx) / intrinsic.fx, (v - intrinsic.cy) / intrinsic.fy, np.ones_like(u)], axis=2)
    return camera.project(rays.reshape(-1, 3)).reshape(*u.shape, 2)


def bilinear(image: np.ndarray, positions: np.ndarray) -> np.ndarray:
    """The oracle of reading between pixels, in float64; NaN outside."""
    h, w = image.shape[:2]
    inside = (np.abs(positions - [(w - 1) / 2, (h - 1) / 2]) <= [w / 2, h / 2]).all(axis=2)
    x, y = np.clip(np.where(inside[..., None], positions, 0), 0, [w - 1, h - 1]).transpose(2, 0, 1)
    left, top = np.floor(x).astype(int), np.floor(y).astype(int)
    right, bottom = np.minimum(left + 1, w - 1), np.minimum(top + 1, h - 1)
    a, b = (x - left)[..., None], (y - top)[..., None]
    p = image.astype(float)
    upper, lower = (p[row, left] * (1 - a) + p[row, right] * a for row in (top, bottom))
    return np.where(inside[..., None], upper * (1 - b) + lower * b, np.nan)


MADE = {  # lenses, and the fraction of blank pixels
    "folds": (loom.CameraModel("SIMPLE_RADIAL", WIDTH, HEIGHT, [70, 48, 36, -0.3]), 1.0),  # before the corners
    "thin": (loom.CameraModel("FOV", WIDTH, HEIGHT, [70, 70, 48, 36, 1e-3]), 0.7),  # nearly a pinhole: a series
    "middle": (loom.CameraModel("FOV", WIDTH, HEIGHT, [70, 70, 48, 36, 0.9]), 0.0),  # a pixel is on the axis
    "division": (loom.CameraModel("SIMPLE_DIVISION", WIDTH, HEIGHT, [40, 48, 36, 0.3]), 1.0),  # no rays beyond a cone
    "unified": (loom.CameraModel("EUCM", WIDTH, HEIGHT, [70, 70, 48, 36, 0.95, 2.0]), 1.0),
}


@pytest.mark.parametrize("model", [*PARAMETERS, *MADE])
def test_each_pixel_shows_its_original_position(device, model):
    camera, blank = MADE[model] if model in MADE else (STRONG[model], 0.7)
    undistortion = Undistortion(camera, blank_fraction=blank, device=device)
    expected = bilinear(ramp(), source_pixels(camera, undistortion.intrinsic))
    straight = undistortion.apply(ramp())
    visible = ~np.isnan(expected[..., 0])
    assert np.array_equal(undistortion.seen, visible) and visible.any()
    assert np.abs(straight - expected)[visible].max() <= 0.501
    assert np.array_equal(undistortion.apply(ramp()[..., 1]), straight[..., 1])
    assert (straight[~visible] == 0).all()


@pytest.mark.parametrize("model", ["SIMPLE_RADIAL", "OPENCV_FISHEYE"])
@pytest.mark.parametrize("longest", [40, 21, 7, 1])
def test_a_smaller_image_contains_local_means(device, model, longest):
    """On a ramp the mean of a square is the value in its middle; two roundings are a level."""
    camera = STRONG[model]
    undistortion = Undistortion(camera, max_size=longest, device=device)
    positions = source_pixels(camera, undistortion.intrinsic)
    straight = undistortion.apply(ramp())
    assert max(straight.shape[:2]) == longest
    side = undistortion._side
    assert side >= 2
    middles = np.array([WIDTH // side, HEIGHT // side]) * side - (side + 1) / 2  # of the last whole squares
    inner = undistortion.seen & ((positions >= (side - 1) / 2) & (positions <= middles)).all(axis=2)
    assert inner.mean() > 0.5 or longest < 21
    off = np.abs(straight[..., :2] - bilinear(ramp()[..., :2], positions))[inner]
    assert off.max(initial=0) <= 1.01


def test_a_pinhole_camera_does_not_change_the_image(device):
    camera = loom.CameraModel("PINHOLE", WIDTH, HEIGHT, [80, 81, 47.3, 36.9])
    for image in (ramp(), ramp()[..., 0]):
        straight, intrinsic = loom.undistort_image(image, camera, device=device)
        assert np.array_equal(straight, image) and intrinsic == camera.intrinsic


@pytest.mark.slow
def test_colmap_gives_the_same_image(tmp_path):
    rng = np.random.default_rng(0)
    image = np.asarray(Image.fromarray(rng.integers(30, 226, (30, 40, 3)).astype(np.uint8)).resize((640, 480)))
    Image.fromarray(image).save(tmp_path / "lens.png")
    jobs = []
    for model in ("OPENCV", "OPENCV_FISHEYE", "FULL_OPENCV"):
        for blank, longest in ((0.0, -1), (1.0, 500)):
            target = str(tmp_path / f"{model}{longest}.png")
            jobs.append([[model, 640, 480, PARAMETERS[model]], [blank, longest], str(tmp_path / "lens.png"), target])
    query_colmap("undistort_images", jobs)
    for (model, *_), (blank, longest), _, target in jobs:
        expected = np.asarray(Image.open(target)).astype(int)
        camera = loom.CameraModel(model, 640, 480, PARAMETERS[model])
        undistortion = Undistortion(camera, blank_fraction=blank, max_size=None if longest < 0 else longest)
        undistorted = undistortion.apply(image).astype(int)
        both = (expected.max(axis=2) > 0) & undistortion.seen
        if undistortion._side == 1 and undistortion.intrinsic.fx > 0.5 * camera._lens.focal[0]:  # COLMAP smooths below
            assert np.abs(undistorted - expected)[both].max() <= 1, model
            assert (both != undistortion.seen).mean() < 0.01, model  # the border's outer half pixel
            assert not ((expected.max(axis=2) > 0) & ~undistortion.seen).any(), model


def test_invalid_cameras_images_and_sizes_are_refused():
    image = ramp()
    with pytest.raises(ValueError, match=r"^image:.*96.*72.*72.*96"):
        loom.undistort_image(np.zeros((WIDTH, HEIGHT), np.uint8), STRONG["OPENCV"])
    with pytest.raises(ValueError, match="image:"):
        loom.undistort_image(np.zeros((HEIGHT, WIDTH, 4), np.uint8), STRONG["OPENCV"])
    with pytest.raises(TypeError, match="camera:"):
        loom.undistort_image(image, STRONG["PINHOLE"].intrinsic)  # pyright: ignore[reportArgumentType]
    with pytest.raises(ValueError, match="max_size, size:"):
        loom.undistort_image(image, STRONG["OPENCV"], size=(4, 4), max_size=3)
    with pytest.raises(ValueError, match="size:"):
        loom.undistort_image(image, STRONG["OPENCV"], size=(4, 4, 4))  # pyright: ignore[reportArgumentType]


def test_a_lens_of_extreme_numbers_sees_little_or_has_no_inverse(device):
    for has_inverse, model, params in (
        (False, "SIMPLE_RADIAL", [80, 48, 36, -50.0]),
        (False, "SIMPLE_RADIAL", [80, 48, 36, 1e90]),
        (True, "FULL_OPENCV", [80, 80, 48, 36, 0, 0, 0, 0, 0, -1e6, 0, 0]),
        (True, "SIMPLE_RADIAL", [1e-3, 48, 36, 0.1]),
        (False, "SIMPLE_RADIAL", [80, 1e30, 36, 0.1]),
    ):
        camera = loom.CameraModel(model, WIDTH, HEIGHT, params)
        with contextlib.nullcontext() if has_inverse else pytest.raises(ValueError, match=r"params: .* has no inverse"):
            assert loom.undistort_image(ramp(), camera, max_size=200, device=device)[0].dtype == np.uint8


SPHERE_WIDTH, SPHERE_HEIGHT = 256, 128


def colors(rays: np.ndarray) -> np.ndarray:
    unit = rays / np.linalg.norm(rays, axis=-1, keepdims=True)
    return 127.5 + 90 * np.sin(3 * unit + [0.3, 1.1, 2.0])


def sphere() -> np.ndarray:
    row, column = np.mgrid[:SPHERE_HEIGHT, :SPHERE_WIDTH]
    across, down = ((column + 0.5) / SPHERE_WIDTH - 0.5) * 2 * np.pi, ((row + 0.5) / SPHERE_HEIGHT - 0.5) * np.pi
    rays = np.stack([np.sin(across) * np.cos(down), np.sin(down), np.cos(across) * np.cos(down)], axis=-1)
    return np.rint(colors(rays)).astype(np.uint8)


def test_each_face_shows_its_directions(device):
    panorama = Panorama(SPHERE_WIDTH, SPHERE_HEIGHT, device=device)
    faces = panorama.apply(sphere())
    assert faces.shape == (6, 81, 81, 3) and panorama.intrinsic.fx == 40.5  # 90 degrees
    v, u = np.mgrid[:81, :81]
    rays = np.stack([(u - 40) / 40.5, (v - 40) / 40.5, np.ones(u.shape)], axis=-1)
    for face, rotation in zip(faces, panorama.turns, strict=True):
        assert np.abs(face - colors(rays @ rotation.T)).max() < 2.5


def test_faces_are_named_by_where_they_look():
    panorama = Panorama(SPHERE_WIDTH, SPHERE_HEIGHT)
    forward = dict(zip(panorama.names, panorama.turns[:, :, 2].tolist(), strict=True))
    assert forward["right"] == [1, 0, 0] and forward["up"] == [0, -1, 0] and forward["back"] == [0, 0, -1]
    assert np.allclose(np.linalg.det(panorama.turns), 1)
    assert np.array_equal(panorama.apply(sphere()[..., 0]), panorama.apply(sphere())[..., 0])

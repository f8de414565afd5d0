"""Straight pictures: what each pixel shows lies where the lens saw it; and COLMAP makes the same of them."""

from __future__ import annotations

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.cameras.undistortion import Undistortion

from .colmap_oracle import ask_colmap
from .test_camera_models import OURS

WIDTH, HEIGHT = 96, 72
STRONG = {  # the numbers that have no unit are those of the larger camera, the rest is scaled
    model: loom.CameraModel(
        model,
        WIDTH,
        HEIGHT,
        [x * 0.15 if abs(x) > 100 or (model.startswith("META") and i > 8) else x for i, x in enumerate(p)],
    )
    for model, p in OURS.items()
}


def ramp(size=(WIDTH, HEIGHT)) -> np.ndarray:
    """Red grows with the column and green with the row, as finely as bytes can; blue is a pattern."""
    v, u = np.mgrid[: size[1], : size[0]]
    return np.stack([2 * u, 3 * v, 50 * (u // 3 % 2) + 50 * (v // 3 % 2)], axis=2).astype(np.uint8)


def places_of(camera: loom.CameraModel, intrinsic: loom.PinholeCameraIntrinsic) -> np.ndarray:
    """Where each pixel of the pinhole lies in the lens's picture, shape [h, w, 2]; by the host's own formulas."""
    v, u = np.mgrid[: intrinsic.height, : intrinsic.width].astype(float)
    rays = np.stack([(u - intrinsic.cx) / intrinsic.fx, (v - intrinsic.cy) / intrinsic.fy, np.ones_like(u)], axis=2)
    return camera.project(rays.reshape(-1, 3)).reshape(*u.shape, 2)


def bilinear(picture: np.ndarray, places: np.ndarray) -> np.ndarray:
    """The oracle of reading between pixels, in float64; NaN outside."""
    h, w = picture.shape[:2]
    inside = (np.abs(places - [(w - 1) / 2, (h - 1) / 2]) <= [w / 2, h / 2]).all(axis=2)
    x, y = np.clip(np.where(inside[..., None], places, 0), 0, [w - 1, h - 1]).transpose(2, 0, 1)
    left, top = np.floor(x).astype(int), np.floor(y).astype(int)
    right, bottom = np.minimum(left + 1, w - 1), np.minimum(top + 1, h - 1)
    a, b = (x - left)[..., None], (y - top)[..., None]
    p = picture.astype(float)
    value = (p[top, left] * (1 - a) + p[top, right] * a) * (1 - b) + (
        p[bottom, left] * (1 - a) + p[bottom, right] * a
    ) * b
    return np.where(inside[..., None], value, np.nan)


MADE = {  # lenses, and the share of blank pixels
    "folds": (loom.CameraModel("SIMPLE_RADIAL", WIDTH, HEIGHT, [70, 48, 36, -0.3]), 1.0),  # before the corners
    "thin": (loom.CameraModel("FOV", WIDTH, HEIGHT, [70, 70, 48, 36, 1e-3]), 0.7),  # nearly a pinhole: a series
    "middle": (loom.CameraModel("FOV", WIDTH, HEIGHT, [70, 70, 48, 36, 0.9]), 0.0),  # a pixel lies on the axis
    "division": (loom.CameraModel("SIMPLE_DIVISION", WIDTH, HEIGHT, [40, 48, 36, 0.3]), 1.0),  # no rays beyond a cone
    "unified": (loom.CameraModel("EUCM", WIDTH, HEIGHT, [70, 70, 48, 36, 0.95, 2.0]), 1.0),
}
FOLDS = MADE["folds"][0]


@pytest.mark.parametrize("model", [*OURS, *MADE])
def test_each_pixel_shows_what_lies_where_the_lens_saw_it(device, model):
    camera, blank = MADE[model] if model in MADE else (STRONG[model], 0.7)
    undistortion = Undistortion(camera, blank_share=blank, device=device)
    expected = bilinear(ramp(), places_of(camera, undistortion.intrinsic))
    straight = undistortion.apply(ramp())
    seen = ~np.isnan(expected[..., 0])
    assert np.array_equal(undistortion.seen, seen)
    assert seen.any()
    assert np.abs(straight - expected)[seen].max() <= 0.501
    assert np.array_equal(undistortion.apply(ramp()[..., 1]), straight[..., 1])
    assert (straight[~seen] == 0).all()


@pytest.mark.parametrize("model", ["SIMPLE_RADIAL", "OPENCV_FISHEYE"])
@pytest.mark.parametrize("longest", [40, 21, 7, 1])
def test_a_smaller_picture_shows_means_of_what_lies_there(device, model, longest):
    """On a ramp the mean of a square is the value in its middle; two roundings are a level."""
    camera = STRONG[model]
    undistortion = Undistortion(camera, max_size=longest, device=device)
    places = places_of(camera, undistortion.intrinsic)
    straight = undistortion.apply(ramp())
    assert max(straight.shape[:2]) == longest
    side = undistortion._side
    assert side >= 2
    middles = np.array([WIDTH // side, HEIGHT // side]) * side - (side + 1) / 2  # of the last whole squares
    inner = undistortion.seen & ((places >= (side - 1) / 2) & (places <= middles)).all(axis=2)
    assert inner.mean() > 0.5 or longest < 21
    off = np.abs(straight[..., :2] - bilinear(ramp()[..., :2], places))[inner]
    assert off.max(initial=0) <= 1.01


def test_a_pinhole_leaves_the_picture_as_it_is(device):
    camera = loom.CameraModel("PINHOLE", WIDTH, HEIGHT, [80, 81, 47.3, 36.9])
    for picture in (ramp(), ramp()[..., 0]):
        straight, intrinsic = loom.undistort_picture(picture, camera, device=device)
        assert np.array_equal(straight, picture)
        assert intrinsic == camera.intrinsic


def test_straight_lines_become_straight(device):
    """A grid of straight lines, drawn as a strong lens sees it, has its lines straight again."""
    camera = loom.CameraModel("SIMPLE_RADIAL", 320, 240, [250, 160, 120, -0.15])
    v, u = np.mgrid[:240, :320].astype(float)
    rays = camera.unproject(np.stack([u, v], axis=2).reshape(-1, 2)).reshape(240, 320, 3)
    known = np.isfinite(rays[..., 0])
    picture = np.where(known & (rays[..., 0] < 0.31), 200, 20).astype(np.uint8)  # an edge at x = 0.31
    straight, intrinsic = loom.undistort_picture(picture, camera, device=device)
    edge = (straight > 110).sum(axis=1)
    expected = 0.31 * intrinsic.fx + intrinsic.cx
    assert np.abs(edge - expected - 0.5).max() < 1.01


@pytest.mark.slow
def test_colmap_makes_the_same_picture(tmp_path):
    rng = np.random.default_rng(0)
    picture = np.asarray(Image.fromarray(rng.integers(30, 226, (30, 40, 3)).astype(np.uint8)).resize((640, 480)))
    Image.fromarray(picture).save(tmp_path / "lens.png")
    asked = []
    for model in ("OPENCV", "OPENCV_FISHEYE", "FULL_OPENCV"):
        for blank, longest in ((0.0, -1), (1.0, 500)):
            target = str(tmp_path / f"{model}{longest}.png")
            asked.append([[model, 640, 480, OURS[model]], [blank, longest], str(tmp_path / "lens.png"), target])
    ask_colmap("undistort_pictures", asked)
    for (model, *_), (blank, longest), _, target in asked:
        theirs = np.asarray(Image.open(target)).astype(int)
        camera = loom.CameraModel(model, 640, 480, OURS[model])
        undistortion = Undistortion(camera, blank_share=blank, max_size=None if longest < 0 else longest)
        ours = undistortion.apply(picture).astype(int)
        both = (theirs.max(axis=2) > 0) & undistortion.seen
        if undistortion._side == 1 and undistortion.intrinsic.fx > 0.5 * camera._lens.focal[0]:  # COLMAP smooths below
            assert np.abs(ours - theirs)[both].max() <= 1, model
            assert (both != undistortion.seen).mean() < 0.01, model  # the border's outer half pixel
            assert not ((theirs.max(axis=2) > 0) & ~undistortion.seen).any(), model


def test_what_is_no_lens_picture_or_size_is_refused():
    picture = ramp()
    with pytest.raises(ValueError, match=r"^picture:.*96.*72.*72.*96"):
        loom.undistort_picture(np.zeros((WIDTH, HEIGHT), np.uint8), STRONG["OPENCV"])
    with pytest.raises(ValueError, match="picture:"):
        loom.undistort_picture(np.zeros((HEIGHT, WIDTH, 4), np.uint8), STRONG["OPENCV"])
    with pytest.raises(TypeError, match="camera:"):
        loom.undistort_picture(picture, STRONG["PINHOLE"].intrinsic)  # pyright: ignore[reportArgumentType]
    with pytest.raises(ValueError, match="max_size, size:"):
        loom.undistort_picture(picture, STRONG["OPENCV"], size=(4, 4), max_size=3)
    with pytest.raises(ValueError, match="size:"):
        loom.undistort_picture(picture, STRONG["OPENCV"], size=(4, 4, 4))  # pyright: ignore[reportArgumentType]


def test_a_lens_of_extreme_numbers_sees_little_and_never_fails(device):
    for model, params in (
        ("SIMPLE_RADIAL", [80, 48, 36, -50.0]),
        ("SIMPLE_RADIAL", [80, 48, 36, 1e90]),
        ("FULL_OPENCV", [80, 80, 48, 36, 0, 0, 0, 0, 0, -1e6, 0, 0]),
        ("SIMPLE_RADIAL", [1e-3, 48, 36, 0.1]),
        ("SIMPLE_RADIAL", [80, 1e30, 36, 0.1]),
    ):
        camera = loom.CameraModel(model, WIDTH, HEIGHT, params)
        try:
            straight, _ = loom.undistort_picture(ramp(), camera, max_size=200, device=device)
        except ValueError as error:
            assert "no inverse" in str(error) or "c" in str(error)
        else:
            assert straight.dtype == np.uint8

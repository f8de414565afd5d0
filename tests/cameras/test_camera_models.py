"""Cameras with lenses: where they see what, against COLMAP's own answers; and that no answer is a wrong one."""

import math
import pickle

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom.cameras.camera_models import MODELS

from .colmap_oracle import query_colmap

WIDTH, HEIGHT = 640, 480
LENSES = {
    "SIMPLE_PINHOLE": [500.0, 322.5, 238.0],
    "PINHOLE": [500.0, 510.0, 322.5, 238.0],
    "SIMPLE_RADIAL": [500.0, 322.5, 238.0, -0.12],
    "RADIAL": [500.0, 322.5, 238.0, -0.25, 0.08],
    "OPENCV": [500.0, 510.0, 322.5, 238.0, -0.28, 0.07, 1e-3, -2e-3],
    "OPENCV_FISHEYE": [300.0, 305.0, 322.5, 238.0, -0.02, 0.005, -1e-3, 2e-4],
    "FULL_OPENCV": [500.0, 510.0, 322.5, 238.0, 0.1, -0.05, 1e-3, -2e-3, 0.02, 0.15, -0.02, 0.01],
    "FOV": [400.0, 410.0, 322.5, 238.0, 0.9],
    "SIMPLE_RADIAL_FISHEYE": [300.0, 322.5, 238.0, 0.03],
    "RADIAL_FISHEYE": [300.0, 322.5, 238.0, 0.03, -0.01],
    "THIN_PRISM_FISHEYE": [300.0, 305.0, 322.5, 238.0, 0.02, -0.01, 1e-3, -2e-3, 3e-3, -1e-3, 1e-3, -1e-3],
    "SIMPLE_DIVISION": [500.0, 322.5, 238.0, -0.3],
    "DIVISION": [500.0, 510.0, 322.5, 238.0, 0.2],
    "SIMPLE_FISHEYE": [300.0, 322.5, 238.0],
    "FISHEYE": [300.0, 305.0, 322.5, 238.0],
    "EUCM": [300.0, 305.0, 322.5, 238.0, 0.6, 1.1],
}
METASHAPE = [500.0, 322.5, 238.0, -0.2, 0.08, -0.02, 0.005, 1e-3, -2e-3, 3.0, -2.0]
PARAMETERS = {**LENSES, "METASHAPE": METASHAPE, "METASHAPE_FISHEYE": [300.0, *METASHAPE[1:]]}
GRID = np.stack(np.meshgrid(np.linspace(-0.5, WIDTH - 0.5, 24), np.linspace(-0.5, HEIGHT - 0.5, 18)), -1).reshape(-1, 2)
RAYS = np.stack(np.meshgrid(np.linspace(-2, 2, 21), np.linspace(-2, 2, 21), [1.0]), -1).reshape(-1, 3)
EARLY = 5e-8  # [px] where COLMAP ends its search: projected again, its rays are up to 1.5e-8 px off, pointloom's 1e-12


def camera_of(model: str, params=None) -> loom.CameraModel:
    return loom.CameraModel(model, WIDTH, HEIGHT, PARAMETERS[model] if params is None else params)


@pytest.fixture(scope="module")
def colmap():
    """COLMAP's rays of the grid and, of those rays at other depths, its pixels; by model."""
    rays = {model: camera_of(model).unproject(GRID) for model in LENSES}
    cameras = [[model, WIDTH, HEIGHT, params] for model, params in LENSES.items()]
    depths = np.linspace(0.5, 20.0, len(GRID))[:, None]
    points = [(rays[model] * depths).tolist() for model in LENSES]
    seen = query_colmap("unproject", [[camera, (GRID + 0.5).tolist()] for camera in cameras])
    shown = query_colmap("project", list(zip(cameras, points, strict=True)))
    return {model: (np.array(points[i]), np.array(shown[i]) - 0.5, np.array(seen[i])) for i, model in enumerate(LENSES)}


@pytest.mark.parametrize("model", LENSES)
def test_points_and_pixels_are_where_colmap_has_them(colmap, model):
    points, pixels, rays = colmap[model]
    assert np.isfinite(points).all() and np.abs(camera_of(model).project(points) - pixels).max() < 1e-9
    off = np.abs(camera_of(model).unproject(GRID)[:, :2] - rays)
    assert (off / (1 + (rays**2).sum(axis=1, keepdims=True)) * LENSES[model][0]).max() < EARLY


@pytest.mark.parametrize("model", PARAMETERS)
def test_pixels_round_trip_through_their_rays(model):
    camera = camera_of(model)
    rays = camera.unproject(GRID)
    assert np.isfinite(rays).all() and (rays[:, 2] == 1).all()
    assert np.abs(camera.project(rays * 7.5) - GRID).max() < 1e-9


def test_a_ray_beyond_the_fold_between_two_directions_has_no_pixel():
    """A strong lens with a tangential term reverses sooner in some directions than in the tested ones."""
    camera = camera_of("METASHAPE_FISHEYE", [100.0, 0, 0, 0, 0, 1.0, -1.0, 0, 1 / 64, 0, 0])
    rays = np.array([[0.2, -1.4, 1.0], [0.19950373, -1.39647562, 1.0]])
    pixels = camera.project(rays)
    assert np.isnan(pixels[0]).all() and np.abs(camera.unproject(pixels[1:]) - rays[1:]).max() < 1e-6


@settings(max_examples=25, deadline=None, derandomize=True)
@given(st.data())
def test_projections_of_any_lens_are_never_wrong(data):
    """What has a ray comes back to its pixel, and no two rays that the lens sees share a pixel.

    Radial factors may be anything; tangential and prism ones are small, as those of lenses: with large ones two rays
    do share a pixel.
    """
    model = data.draw(st.sampled_from(sorted(PARAMETERS)))
    names = MODELS[model].params.split(", ")
    ranges = {"f": (100, 2000), "c": (0, 640), "p": (-0.02, 0.02), "s": (-0.02, 0.02)}
    params = [data.draw(st.floats(*ranges.get(name[0], (-2, 2)))) for name in names]
    assume(model != "EUCM" or (0 <= params[-2] <= 1 and params[-1] > 0))
    camera = camera_of(model, params)
    rays = camera.unproject(GRID)
    known = np.isfinite(rays).all(axis=1)
    assert (np.isnan(rays[~known])).all()
    back = camera.project(rays[known])
    slack = 1e-6 * (1 + np.abs(rays[known]).max(axis=1)) ** 2  # [px] near the horizon a ray's digits are few
    assert (np.abs(back - GRID[known]).max(axis=1, initial=0) <= slack).all()
    pixels = camera.project(RAYS)
    visible = np.isfinite(pixels).all(axis=1)
    again = camera.unproject(pixels[visible])[:, :2]
    off = np.abs(again - RAYS[visible, :2]).max(axis=1, initial=0) / (1 + (RAYS[visible, :2] ** 2).sum(axis=1))
    assert not (off > 1e-4).any()  # NaN is not wrong; close to the maximum of the distortion digits are lost


@pytest.mark.parametrize("model", ["SIMPLE_RADIAL", "OPENCV", "OPENCV_FISHEYE", "METASHAPE"])
def test_nothing_is_visible_beyond_the_maximum_of_the_distortion(model):
    params = {"SIMPLE_RADIAL": [200, 320, 240, -0.2], "OPENCV": [200, 200, 320, 240, -0.2, 0, 1e-3, 1e-3]}
    params |= {"OPENCV_FISHEYE": [200, 200, 320, 240, -0.2, 0, 0, 0], "METASHAPE": [200, 320, 240, -0.2, *[0] * 7]}
    camera = camera_of(model, params[model])
    turning = math.sqrt(1 / 0.6)  # of r - 0.2 r^3
    radii = np.linspace(0.01, 2.5, 400)
    angles = radii if model == "OPENCV_FISHEYE" else None
    tangents = radii if angles is None else np.tan(np.minimum(angles, 1.55))
    columns = camera.project(np.stack([tangents, 0 * tangents, np.ones_like(tangents)], axis=1))[:, 0]
    inside = radii < turning * 0.98
    assert np.isfinite(columns[inside]).all() and (np.diff(columns[inside]) > 0).all()
    assert np.isnan(columns[radii > turning * 1.001]).all()
    assert np.isnan(camera.unproject([[319.5 + 200, 239.5]])).all()


@pytest.mark.parametrize("model", ["OPENCV", "FULL_OPENCV", "METASHAPE"])
def test_a_solution_beyond_the_fold_is_no_ray(model):
    """Roots that Newton's method finds beyond the maximum of a distortion with tangential terms."""
    k1, k2, p1, p2 = -0.3, 0.02, 2e-3, -1e-3
    params = {"OPENCV": [200, 200, 320, 240, k1, k2, p1, p2], "METASHAPE": [200, 320, 240, k1, k2, 0, 0, p2, p1, 0, 0]}
    camera = camera_of(model, params.get(model, [*params["OPENCV"], 0, 0, 0, 0]))
    pixels = np.stack(np.meshgrid(np.linspace(-2000, 3000, 60), np.linspace(-2000, 3000, 60)), -1).reshape(-1, 2)
    rays = camera.unproject(pixels)
    known = np.isfinite(rays[:, 0])
    assert 0 < known.sum() < 16 and np.abs(camera.project(rays[known]) - pixels[known]).max() < 1e-9
    assert np.hypot(*rays[known, :2].T).max() < 1.2  # r - 0.3 r^3 + 0.02 r^5 has its maximum at 1.12


def test_a_fisheye_sees_up_to_a_right_angle():
    camera = camera_of("SIMPLE_FISHEYE", [200.0, 320.0, 240.0])
    at = 200 * np.array([math.pi / 2 - 1e-3, math.pi / 2 + 1e-3])
    rays = camera.unproject([[319.5 + at[0], 239.5], [319.5 + at[1], 239.5]])
    assert math.degrees(math.atan(rays[0, 0])) == pytest.approx(90 - math.degrees(1e-3))
    assert np.isnan(rays[1]).all()
    assert np.isnan(camera.project([[1, 0, 0], [1, 0, -0.1], [0, 0, -1], [0, 0, 0]])).all()


def test_metashapes_formula_gives_the_pixel():
    """The user manual's: u = w / 2 + cx + x' f + x' B1 + y' B2, pixel corners at whole numbers."""
    f, cx, cy, k1, k2, k3, k4, p1, p2, b1, b2 = METASHAPE
    x, y = 0.31, -0.22
    r2 = x * x + y * y
    radial = 1 + k1 * r2 + k2 * r2**2 + k3 * r2**3 + k4 * r2**4
    xd = x * radial + p1 * (r2 + 2 * x * x) + 2 * p2 * x * y
    yd = y * radial + p2 * (r2 + 2 * y * y) + 2 * p1 * x * y
    expected = [cx + xd * f + xd * b1 + yd * b2 - 0.5, cy + yd * f - 0.5]
    assert camera_of("METASHAPE").project([[x, y, 1]])[0].tolist() == pytest.approx(expected, abs=1e-10)


# ------------------------------------------------------------------------------------------------ straight cameras


def test_the_undistorted_camera_matches_colmap():
    settings = [(blank, longest) for blank in (0.0, 0.4, 1.0) for longest in (-1, 300)]
    cases = [([model, WIDTH, HEIGHT, p], setting) for model, p in LENSES.items() for setting in settings]
    results = query_colmap("undistort_cameras", cases)
    for ((model, *_), (blank, longest)), (_, width, height, params) in zip(cases, results, strict=True):
        undistorted = camera_of(model).undistorted(blank_fraction=blank, max_size=None if longest < 0 else longest)
        fx, fy, cx, cy = params if len(params) == 4 else [params[0], *params]
        assert (undistorted.width, undistorted.height) == (width, height), (model, blank, longest)
        principal = [undistorted.cx + 0.5, undistorted.cy + 0.5]
        assert [undistorted.fx, undistorted.fy, *principal] == pytest.approx([fx, fy, cx, cy], abs=1e-9), model


def test_a_pinhole_stays_as_it_is():
    camera = camera_of("PINHOLE")
    assert camera.is_pinhole and camera.undistorted() == camera.intrinsic
    assert loom.CameraModel.from_intrinsic(camera.intrinsic) == camera
    assert camera_of("OPENCV", [500, 510, 322.5, 238, 0, 0, 0, 0]).intrinsic == camera.intrinsic


def test_undistorted_camera_has_the_requested_size():
    camera = camera_of("SIMPLE_RADIAL")
    straight, small = camera.undistorted(), camera.undistorted(size=(320, 320))
    assert (small.width, small.height) == (320, 320)
    assert small.fx / 320 == pytest.approx(straight.fx / straight.width)
    assert (small.cy + 0.5) / 320 == pytest.approx((straight.cy + 0.5) / straight.height)


def test_a_lens_has_no_intrinsic_and_without_an_inverse_along_a_border_no_straight_camera():
    with pytest.raises(ValueError, match="undistort_image"):
        _ = camera_of("SIMPLE_RADIAL").intrinsic
    with pytest.raises(ValueError, match=r"^params:"):
        camera_of("SIMPLE_RADIAL", [100, 320, 240, -0.3]).undistorted()


def test_non_finite_points_are_not_visible():
    points = [[np.nan, 0, 1], [np.inf, 0, 1], [0, 0, np.inf], [0, 0, np.nan], [1e200, 0, 1e-200], [0, 0, 1]]
    for model in PARAMETERS:
        pixels = camera_of(model).project(points)
        assert np.isnan(pixels[[0, 1, 3, 4]]).all(), model
        assert np.isfinite(pixels[5]).all(), model
        assert np.isnan(camera_of(model).unproject([[np.nan, 0], [np.inf, 0], [1e200, 1e200]])[:2]).all(), model


def test_equal_cameras_are_one():
    assert len({camera_of("OPENCV"), camera_of("OPENCV"), camera_of("FOV")}) == 2
    camera = camera_of("OPENCV")
    camera.project([[0, 0, 1]])
    assert pickle.loads(pickle.dumps(camera)) == camera

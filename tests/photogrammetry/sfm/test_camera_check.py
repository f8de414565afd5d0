"""Checks of focal lengths: messages from given figures, and profiles of models by COLMAP's process."""

import dataclasses
import json
import math
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.photogrammetry.sfm import colmap_worker
from pointloom.photogrammetry.sfm.camera_check import CameraCheck
from pointloom.photogrammetry.sfm.model_quality import ModelQuality, assess_model

from .conftest import has_pycolmap
from .test_model_quality import FOCAL, HEIGHT, WIDTH, model_of, views


def warnings_of(**figures: float) -> str:
    return "; ".join(CameraCheck(**figures).reasons())


def test_a_given_camera_is_reported_with_both_numbers():
    message = warnings_of(given=600, found=526, error=0.85, freed_error=0.5)
    assert "given focal length is 600 px, but 526 px fits the images better" in message
    assert "(the error falls from 0.85 to 0.5 px)" in message
    assert "given focal length is 600 px" in warnings_of(given=600, found=526, error=0.5, freed_error=0.45, spread=0.02)


@pytest.mark.parametrize(
    "figures",
    [
        {"given": 600, "found": 526, "error": 0.5, "freed_error": 0.45},  # the pictures do not determine it
        {"given": 600, "found": 526, "error": 0.5, "freed_error": 0.45, "spread": 0.03},  # nor do parts of them
        {"given": 526, "found": 530, "error": 0.85, "freed_error": 0.5},  # it was something else
        {"given": 526, "found": 526, "error": 0.5, "freed_error": 0.5, "own_error": 0.45},
        {"found": 526, "rise": 0.01, "spread": 0.02, "error": 0.5, "own_error": 0.45},
        {},
    ],
)
def test_a_camera_that_fits_is_not_reported(figures):
    assert warnings_of(**figures) == ""


def test_an_undetermined_focal_length_is_reported():
    message = warnings_of(found=663, rise=0.0, error=0.4)
    assert "the images do not determine the focal length (with a focal length 15% off 663 px" in message
    message = warnings_of(found=663, rise=0.026, spread=0.046, error=0.4)
    assert "the error rises by 2.6%, and subsets of the images" in message
    assert "or a lens with more distortion, change the focal length by 5%" in message
    assert "the 525 px of EXIF fit worse" in warnings_of(found=663, rise=0, error=0.4, exif=525, freed_error=0.6)


def test_exif_determines_the_focal_length_if_the_pictures_do_not():
    check = CameraCheck(found=663, rise=0.0, error=0.4, exif=525, freed_error=0.401)
    assert check.reasons() == []
    (remark,) = check.notes()
    assert "EXIF's 525 px are used" in remark and "across the viewing direction may be off by 5%" in remark


def test_several_focal_lengths_are_reported_or_get_separate_cameras():
    figures = {"found": 600.0, "rise": 0.1, "error": 1.4, "own_error": 0.4}
    message = warnings_of(**figures)
    assert "several focal lengths (with one focal length per image the error falls from 1.4 to 0.4 px)" in message
    parted = CameraCheck(**figures | {"parted": 2})
    assert parted.reasons() == [] and "2 cameras with different focal lengths do" in parted.notes()[0]
    assert "several focal lengths" in warnings_of(given=525, freed_error=1.2, **figures)


def test_a_check_and_a_quality_are_read_again_from_json():
    check = CameraCheck(found=663, rise=0.0, error=0.4)
    quality = dataclasses.replace(assess_model(None, 3), focal=check)
    again = ModelQuality.from_json(json.loads(json.dumps(quality.to_dict(), allow_nan=False)))
    assert again.focal is not None and again.focal.reasons() == check.reasons() and math.isnan(again.focal.given)
    older = {key: value for key, value in quality.to_dict().items() if key not in ("focal", "notes")}
    assert ModelQuality.from_json(older).focal is None


@pytest.fixture
def points(rng):
    return np.column_stack([rng.uniform(-4, 4, (400, 2)), rng.uniform(3, 8, 400)])


def test_reprojection_errors_above_a_pixel_are_reported(points):
    model = model_of(views(4, side=1.0, angle=0.3), points)
    for error, size, refused in ((0.9, 1, False), (1.1, 1, True), (1.5, 4, False), (1.7, 4, True)):
        cameras = [loom.CameraModel("PINHOLE", size * WIDTH, size * HEIGHT, [FOCAL, FOCAL, 9, 9])] * len(model)
        scaled = dataclasses.replace(model, cameras=cameras, errors=np.full(len(points), error))
        warnings = assess_model(scaled, 4, focal=CameraCheck()).warnings
        assert ("the reprojection error is" in str(warnings)) == refused


def test_the_check_of_the_focal_length_makes_a_warning(points):
    model = model_of(views(4, side=1.0, angle=0.3), points)
    quality = assess_model(model, 4, focal=CameraCheck(found=600, rise=0.001, error=0.4))
    assert not quality.reliable
    assert quality.warnings[0].startswith("the images do not determine the focal length")
    noted = assess_model(model, 4, focal=CameraCheck(found=600, rise=0.001, error=0.4, exif=1, freed_error=0.4))
    assert noted.reliable and noted.to_dict()["notes"] == list(noted.notes) != []


SCRIPT = """
import json, pathlib, runpy, sys
import pycolmap
pycolmap.logging.minloglevel = 2
script = runpy.run_path(sys.argv[1])
results = {}
for path in sorted(pathlib.Path(sys.argv[2]).iterdir()):
    model = pycolmap.Reconstruction(str(path))
    shared, own, lengths = script["own_focal_lengths"](pycolmap, model)
    results[path.name] = script["profile"](pycolmap, model) | {"own": own / shared}
    results[path.name] |= script["judge_given"](pycolmap, model)
    results[path.name]["clusters"] = sorted(len(group) for group in script["clusters"](lengths))
print(json.dumps(results))
"""


def zoomed(poses, points) -> loom.SfmModel:
    """A model with one camera, although every second picture has another focal length."""
    near, far = (model_of(poses, points, focal=focal, noise=0.2) for focal in (FOCAL, 1.3 * FOCAL))
    parts = [(model, model.observations[:, 0] % 2 == k) for k, model in enumerate((near, far))]
    seen = np.concatenate([model.observations[mine] for model, mine in parts])
    pixels = np.concatenate([model.pixels[mine] for model, mine in parts])
    return dataclasses.replace(near, observations=seen, pixels=pixels)


@pytest.fixture(scope="module")
def results(tmp_path_factory) -> dict:
    """Results of COLMAP's process for models of synthetic points, without pictures."""
    if not has_pycolmap():
        pytest.skip("pycolmap is not installed")
    rng = np.random.default_rng(0)
    points = np.column_stack([rng.uniform(-4, 4, (300, 2)), rng.uniform(3, 8, 300)])
    around, ahead = views(8, side=2.0, angle=0.5), [np.eye(4) for _ in range(8)]
    for k, T in enumerate(ahead):
        T[2, 3] = -0.2 * k
    models = {
        "around": model_of(around, points, noise=0.2),
        "ahead": model_of(ahead, points, noise=0.2),
        "wrong": model_of(around, points, noise=0.2, wrong_focal=1.15),
        "zoom": zoomed(around, points),
    }
    folder = tmp_path_factory.mktemp("models")
    for name, model in models.items():
        loom.write_colmap_model(folder / name, model)
    script = Path(colmap_worker.__file__).with_name("colmap_cameras.py")
    command = [sys.executable, "-P", "-c", SCRIPT, str(script), str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=300)
    return json.loads(done.stdout.splitlines()[-1])


def test_sideways_motion_determines_the_focal_length_and_forward_motion_does_not(results):
    assert results["around"]["rise"] > 0.1 and results["around"]["found"] == pytest.approx(FOCAL, rel=0.01)
    assert results["ahead"]["rise"] < 0.002


def test_a_given_focal_length_is_checked_against_the_pictures(results):
    assert CameraCheck.from_json(results["around"]).reasons() == []
    check = CameraCheck.from_json(results["wrong"])
    assert check.given == pytest.approx(1.15 * FOCAL) and check.found == pytest.approx(FOCAL, rel=0.01)
    assert check.freed_error < 0.6 * check.error


def test_pictures_of_two_focal_lengths_form_two_clusters(results):
    assert results["zoom"]["own"] < 0.5 < 0.9 < results["around"]["own"]
    assert results["zoom"]["clusters"] == [4, 4] and results["around"]["clusters"] == [8]

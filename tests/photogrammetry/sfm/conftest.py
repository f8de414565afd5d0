"""Images of the synthetic scene, their features, and videos."""

import importlib.util
import shutil
import subprocess
from collections.abc import Callable, Sequence
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

from pointloom.photogrammetry.sfm.features import find_features
from pointloom.photogrammetry.sfm.mapping import map_images
from pointloom.photogrammetry.sfm.matches import match_features
from pointloom.photogrammetry.sfm.settings import SfmSettings

from .scene import camera_path, image

COUNT = 8
FEATURES = 1200


def write_images(folder: Path, images: Sequence[np.ndarray], names: Sequence[str] = ()) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    for number, pixels in enumerate(images):
        Image.fromarray(pixels).save(folder / (names[number] if names else f"view {number}.png"))
    return folder


def silent(*_step) -> None:
    """Progress that is not reported."""


def left_half(shape) -> np.ndarray:
    """A mask that keeps the left half of an image."""
    mask = np.zeros(shape, np.uint8)
    mask[:, : shape[1] // 2] = 255
    return mask


@pytest.fixture(scope="session")
def scene_images() -> list[np.ndarray]:
    return [image(T) for T in camera_path(COUNT)]


@pytest.fixture(scope="session")
def stages(scene_images, tmp_path_factory) -> SimpleNamespace:
    """Features, matches and the model of 8 images, in a folder with spaces and non-ASCII characters."""
    pytest.importorskip("sqlite3")
    if not has_pycolmap():
        pytest.skip("pycolmap is not installed")
    work = tmp_path_factory.mktemp("sfm") / "Küche 1 ✓"
    images = write_images(work / "Bilder", scene_images)
    features_db, matches_db, sparse = work / "features.db", work / "matches.db", work / "sparse"
    steps: list[tuple[str, int, int]] = []

    def progress(*step):
        steps.append(step)

    features = find_features(images, features_db, SfmSettings(max_features=FEATURES), progress=progress)
    before = features_db.read_bytes()
    matches = match_features(features_db, matches_db, progress=progress)
    assert features_db.read_bytes() == before
    before = matches_db.read_bytes()
    result = map_images(images, matches_db, sparse, progress=progress)
    assert matches_db.read_bytes() == before
    return SimpleNamespace(**locals())


def has_pycolmap() -> bool:
    """True if pycolmap is installed; importing it beside other packages may hang."""
    return importlib.util.find_spec("pycolmap") is not None


@pytest.fixture
def make_video(tmp_path) -> Callable[..., Path]:
    """A function (name, frames, options of ffmpeg) -> path of a video."""
    if shutil.which("ffmpeg") is None:
        pytest.skip("ffmpeg is not installed")

    def make(name: str, frames: Sequence[np.ndarray], *options: str, rate: int = 10) -> Path:
        path, (height, width) = tmp_path / name, frames[0].shape
        given = ["-f", "rawvideo", "-pix_fmt", "gray", "-s", f"{width}x{height}", "-r", str(rate), "-i", "-"]
        command = ["ffmpeg", "-v", "error", "-y", *given, "-c:v", "mpeg4", "-q:v", "2", *options, str(path)]
        subprocess.run(command, input=b"".join(frame.tobytes() for frame in frames), check=True, timeout=60)
        return path

    return make


@pytest.fixture(scope="session")
def panned() -> list[np.ndarray]:
    """40 frames of 160 x 120 that move by 3 pixels each."""
    wide = np.array(Image.fromarray(image(camera_path(2)[0])).resize((640, 120), Image.Resampling.BOX))
    return [np.ascontiguousarray(wide[:, 3 * k : 3 * k + 160]) for k in range(40)]

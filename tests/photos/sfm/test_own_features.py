"""Features of our own in COLMAP's database, and beside those that COLMAP and OpenCV find."""

import subprocess
import sys
from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom
from pointloom.photos import sfm
from pointloom.photos.sfm import triangulation
from pointloom.photos.video import known_motion, motion

from .conftest import has_pycolmap, write_pictures
from .scene import FOCAL, HEIGHT, WIDTH, walk

# In a process of its own: beside other packages pycolmap may hang.
READ = """
import sys
import numpy as np, pycolmap
from PIL import Image
database = pycolmap.Database.open(sys.argv[1])
a, b = (image.image_id for image in sorted(database.read_all_images(), key=lambda image: image.name))
found = {"geometry": database.read_two_view_geometry(a, b).inlier_matches, "matches": database.read_matches(a, b)}
for name, number in (("a", a), ("b", b)):
    descriptors = database.read_descriptors(number)
    found["keypoints_" + name] = database.read_keypoints(number)
    found["descriptors_" + name] = getattr(descriptors, "data", descriptors)
options = pycolmap.FeatureExtractionOptions()
options.use_gpu, options.num_threads = False, 1
grey = np.asarray(Image.open(sys.argv[2]))
places, descriptors = pycolmap.Sift(options, device=pycolmap.Device.cpu).extract(grey)
np.savez(sys.argv[3], colmap_places=places, colmap_descriptors=descriptors, **found)
"""
OPENCV = """
import sys
import cv2, numpy as np
from PIL import Image
found = cv2.SIFT_create(contrastThreshold=0.02, edgeThreshold=10, sigma=1.6).detect(np.asarray(Image.open(sys.argv[1])))
np.savez(sys.argv[2], places=[(*each.pt, each.size / 2) for each in found])
"""


@pytest.fixture(scope="module")
def own(walked, tmp_path_factory) -> SimpleNamespace:
    """Features and matches of two pictures by our kernels, as COLMAP reads them, and COLMAP's features of the first."""
    if not has_pycolmap():
        pytest.skip("pycolmap is not installed")
    work = tmp_path_factory.mktemp("own")
    pictures = write_pictures(work / "pictures", [walked[2], walked[4]])
    sfm.find_features(pictures, work / "features.db", finder="pointloom")
    report = sfm.match(work / "features.db", work / "matches.db", finder="pointloom")
    paths = [str(work / "matches.db"), str(pictures / "view 0.png"), str(work / "read.npz")]
    subprocess.run([sys.executable, "-c", READ, *paths], check=True, timeout=120)
    kinds = [loom.sfm.detect_keypoints(walked[k]) for k in (2, 4)]
    return SimpleNamespace(**np.load(work / "read.npz"), report=report, kinds=kinds, picture=paths[1])


@pytest.mark.slow
def test_colmap_reads_the_features_that_were_found(own):
    for kinds, places, descriptors in zip(
        own.kinds, (own.keypoints_a, own.keypoints_b), (own.descriptors_a, own.descriptors_b), strict=True
    ):
        assert len(kinds) > 300
        np.testing.assert_array_equal(descriptors, kinds.descriptors)
        np.testing.assert_allclose(places[:, :2] - 0.5, kinds.positions, atol=1e-4)
        np.testing.assert_allclose(np.hypot(places[:, 2], places[:, 4]), kinds.scales, rtol=1e-5)
        turns = np.arctan2(places[:, 4], places[:, 2]) - kinds.orientations
        np.testing.assert_allclose(np.angle(np.exp(1j * turns)), 0, atol=1e-5)


@pytest.mark.slow
def test_colmap_reads_the_matches_that_were_found(own):
    pairs = loom.sfm.match_keypoints(*own.kinds)
    assert len(pairs) > 100
    np.testing.assert_array_equal(own.matches, pairs)


def nearest(
    places: np.ndarray, scales: np.ndarray, kinds: loom.sfm.Keypoints, turns: np.ndarray | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """Gap [px] to the nearest of our features of a like scale (a quarter octave) and orientation, and its row."""
    gaps = np.linalg.norm(places[:, None] - kinds.positions[None], axis=2)
    gaps[np.abs(np.log2(scales[:, None] / kinds.scales[None])) > 0.25] = np.inf
    if turns is not None:
        gaps[np.abs(np.angle(np.exp(1j * (turns[:, None] - kinds.orientations[None])))) > 0.05] = np.inf
    return gaps.min(axis=1), gaps.argmin(axis=1)


@pytest.mark.slow
def test_colmaps_features_are_ours_too_and_look_the_same(own):
    kinds = own.kinds[0]
    places, scales, turns = own.colmap_places[:, :2] - 0.5, own.colmap_places[:, 2], own.colmap_places[:, 3]
    gaps, rows = nearest(places, scales, kinds, turns)
    same = gaps < 0.1
    assert same.mean() > 0.98 and abs(len(gaps) - len(kinds)) < 0.02 * len(kinds)
    theirs = np.round(own.colmap_descriptors[same] * 512)
    off = np.linalg.norm(theirs - kinds.descriptors[rows[same]], axis=1)
    others = np.linalg.norm(theirs - kinds.descriptors[np.roll(rows[same], 1)], axis=1)
    assert np.quantile(off, 0.95) < 20 and np.median(others) > 200  # of descriptors of length 512


@pytest.mark.slow
def test_most_of_opencvs_features_are_ours_too(own, tmp_path):
    pytest.importorskip("cv2")
    subprocess.run([sys.executable, "-c", OPENCV, own.picture, str(tmp_path / "f.npz")], check=True, timeout=120)
    found = np.load(tmp_path / "f.npz")["places"]
    gaps, _ = nearest(found[:, :2], found[:, 2], own.kinds[0])
    assert np.mean(gaps < 0.5) > 0.85  # OpenCV's lie some quarter of a pixel beside


@pytest.mark.parametrize("finder", ["colmap", "pointloom"])
def test_stages_of_videos_pass_the_finder_on(monkeypatch, tmp_path, finder):
    seen = []

    def noted(*_, **options):
        seen.append((options["finder"], options["device"]))
        return SimpleNamespace(to_json=dict)

    monkeypatch.setattr(sfm, "find_features", noted)
    monkeypatch.setattr(sfm, "match", noted)
    made = SimpleNamespace(folder=tmp_path)
    own = {"finder": finder, "seed": 0, "device": "cpu"}
    options = {"intrinsic": None, "camera_model": "PINHOLE", "max_features": 64, "panorama": False}
    motion.find_features(tmp_path, print, frames=made, **options, **own)
    motion.match(tmp_path, print, frames=made, features=made, pairs="auto", **own)
    known_motion.find_features(tmp_path, print, frames=made, max_features=64, **own)
    assert seen == 3 * [(finder, "cpu")]


def test_known_poses_take_the_finder_too(monkeypatch, walked, tmp_path):
    class SeenError(Exception):
        pass

    def noted(*_, **options):
        raise SeenError(options["finder"])

    monkeypatch.setattr(triangulation, "find_features", noted)
    folder = write_pictures(tmp_path / "p", walked[:2])
    camera = loom.CameraModel("PINHOLE", WIDTH, HEIGHT, [FOCAL, FOCAL, WIDTH / 2, HEIGHT / 2])
    model = loom.SfmModel(["view 0", "view 1"], [camera] * 2, np.array(walk(8)[:2]))
    with pytest.raises(SeenError, match="pointloom"):
        loom.sfm.triangulate(folder, model, finder="pointloom", device="cpu")
    with pytest.raises(ValueError, match="finder"):
        loom.sfm.triangulate(folder, model, finder="best")

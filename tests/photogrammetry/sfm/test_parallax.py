"""Parallax: the choice of compared pictures, and mirrored pictures."""

import numpy as np

import pointloom as loom
from pointloom.photogrammetry.sfm import model_quality as module

CAMERA = loom.CameraModel("PINHOLE", 640, 480, [500, 500, 320, 240])


def model_of(centers, seen, pixels=None):
    """Cameras on the x axis, each of which sees a number of the first points."""
    poses = np.tile(np.eye(4), (len(centers), 1, 1))
    poses[:, 0, 3] = np.negative(centers)
    points = np.random.default_rng(0).uniform([-1, -1, 4], [1, 1, 6], (max(seen), 3))
    observations = np.array([[picture, k] for picture, count in enumerate(seen) for k in range(count)])
    if pixels is None:
        pixels = np.zeros((len(observations), 2))
    names = [str(k) for k in range(len(centers))]
    return loom.SfmModel(names, [CAMERA] * len(centers), poses, points=points, observations=observations, pixels=pixels)


def test_a_picture_is_compared_with_one_that_is_far_and_sees_much_of_the_same(monkeypatch):
    monkeypatch.setattr(module, "_MAX_PAIRS", 1)  # for the first picture alone
    # distance times the root of the number of shared points: 45, 54 and 42
    assert module._far_pairs(model_of([0.0, 10.0, 7.0, 3.0], [200, 20, 60, 200])) == [(0, 2)]


def test_a_mirrored_picture_is_no_rotated_one():
    rays = np.random.default_rng(1).uniform(-0.5, 0.5, (60, 2))
    once = rays * 500 + [319.5, 239.5]
    for second, is_rotated in ((once, True), ((rays * [-1, 1]) * 500 + [319.5, 239.5], False)):
        off = module.parallax(model_of([0.0, 1.0], [60, 60], np.concatenate([once, second])), fixed=True)
        assert (off < 1e-6) is is_rotated and (off > 50) is not is_rotated

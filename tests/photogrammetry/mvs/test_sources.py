"""Choice of sources by greedy cover, compared with a plain loop."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.spatial import KDTree

import pointloom as loom
from pointloom.photogrammetry.mvs.posed_pictures import SparsePoints
from pointloom.photogrammetry.mvs.sources import _step, choose_sources

from .made_maps import moved, pose

LENS = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)


def camera_at(x, y=0.0, z=0.0, angle=0.0):
    T = pose(x, y, angle)
    T[:3, 3] -= T[:3, 2] * z
    return loom.mvs.PosedCamera(LENS, T)


def scattered(rng, count=9, points=300):
    """Cameras in a row and points that some of them see."""
    cameras = [camera_at(*rng.normal(0, 0.5, 2)) for _ in range(count)]
    positions = rng.normal((0, 0, 6), 1, (points, 3))
    return cameras, SparsePoints(positions, np.argwhere(rng.random((count, points)) < 0.4))


def plain_cover(cameras, sparse, count):
    """The greedy choice with one matrix per picture."""
    centers, out = np.array([camera.center for camera in cameras]), []
    for i in range(len(cameras)):
        mine = sparse.seen_by(i)
        weights = np.zeros((len(cameras), len(mine)))
        for j in range(len(cameras)):
            if j == i:
                continue
            a, b = sparse.points[mine] - centers[i], sparse.points[mine] - centers[j]
            cosine = (a * b).sum(1) / np.linalg.norm(a, axis=1) / np.linalg.norm(b, axis=1)
            angle = np.degrees(np.arccos(np.clip(cosine, -1, 1)))
            weight = np.clip(angle / 3, 0, 1) * np.exp(-np.maximum(angle - 10, 0) / 10)
            weights[j] = np.isin(mine, sparse.seen_by(j)) * weight
        left, chosen = np.full(len(mine), 3.0), []
        for _ in range(count):
            gain = np.minimum(weights, left).sum(1)
            gain[chosen] = -1
            if gain.max() <= 0:
                break
            chosen.append(int(gain.argmax()))
            left = np.maximum(left - weights[chosen[-1]], 0)
        out.append(tuple(chosen))
    return tuple(out)


@pytest.mark.parametrize("count", [1, 4, 8])
def test_the_choice_matches_a_plain_loop(rng, count):
    cameras, sparse = scattered(rng)
    assert choose_sources(cameras, sparse, count=count) == plain_cover(cameras, sparse, count)


def test_a_source_covering_unseen_points_precedes_better_ones():
    """Pictures 1 to 4 see the left half well; only picture 5 sees the right half, at a poorer angle."""
    cameras = [camera_at(x) for x in (0.0, 0.5, 0.52, 0.54, 0.56, 0.15)]
    points = np.stack([np.linspace(-1, 1, 40), np.zeros(40), np.full(40, 5.0)], axis=1)
    left = np.flatnonzero(points[:, 0] < 0).tolist()
    right = np.flatnonzero(points[:, 0] > 0).tolist()
    seen = [(0, k) for k in range(40)] + [(j, k) for j in (1, 2, 3, 4) for k in left] + [(5, k) for k in right]
    chosen = choose_sources(cameras, SparsePoints(points, seen), count=4)[0]
    assert chosen.index(5) == 3  # after three good views of the left half a fourth adds nothing
    assert choose_sources(cameras, SparsePoints(points, seen), count=8)[0] == chosen


def test_angles_of_some_degrees_are_preferred():
    degrees = np.array([0.0, 0.3, 6.0, 40.0, 85.0])
    cameras = [camera_at(5 * np.sin(a), 0, 5 - 5 * np.cos(a)) for a in np.radians(degrees)]
    sparse = SparsePoints([[0.0, 0.0, 5.0]], [(i, 0) for i in range(5)])
    assert choose_sources(cameras, sparse)[0] == (2, 1, 3, 4)


def test_sources_are_independent_of_origin_and_unit(rng):
    cameras, sparse = scattered(rng)
    expected = choose_sources(cameras, sparse)
    for scale, shift in ((1.0, (5e5, 5.4e6, 300.0)), (1e-6, np.zeros(3)), (1e6, np.zeros(3))):
        points = SparsePoints(sparse.points * scale + shift, sparse.observations)
        assert choose_sources(moved(cameras, scale, shift), points) == expected


def test_nearby_cameras_of_the_same_direction_are_sources_without_points():
    cameras = [camera_at(0.1 * k) for k in range(6)] + [camera_at(0.05, angle=3.0)]
    none = SparsePoints(np.zeros((0, 3)), np.zeros((0, 2), int))
    chosen = choose_sources(cameras, none, count=3)
    assert chosen == choose_sources(cameras, None, count=3)
    assert set(chosen[0]) <= {1, 2, 3, 4}
    assert set(chosen[3]) <= {1, 2, 4, 5}
    assert all(6 not in each for each in chosen[:6])  # it looks the other way
    assert chosen[6] == ()


@pytest.mark.parametrize("kind", ["scattered", "rounded", "a row", "a circle", "far away"])
def test_a_step_is_the_median_distance_to_the_nearest_camera_elsewhere(kind, rng):
    angle = np.linspace(0, 2 * np.pi, 400)
    centers = {
        "scattered": rng.normal(size=(300, 3)),
        "rounded": rng.normal(size=(300, 3)).round(1),
        "a row": rng.permutation(np.outer(np.linspace(0, 9, 200) ** 2, [0.1, 0.2, 0.3])),
        "a circle": np.column_stack([np.cos(angle), np.sin(angle), 0 * angle]),
        "far away": rng.normal(size=(300, 3)) + 1e6,
    }[kind]
    distinct = np.unique(centers, axis=0)
    assert _step(centers) == np.median(KDTree(distinct).query(distinct, k=2)[0][:, 1])
    assert _step(centers[:1]) == _step(np.repeat(centers[:1], 5, axis=0)) == 0


def test_a_model_of_structure_from_motion_is_taken_for_its_points(rng):
    cameras, sparse = scattered(rng)
    model = SimpleNamespace(points=sparse.points, observations=sparse.observations, names=("a.jpg",) * 9)
    assert choose_sources(cameras, model) == choose_sources(cameras, sparse)


def test_only_a_picture_without_shared_points_is_chosen_for_by_its_camera(rng):
    cameras, sparse = scattered(rng)
    bare = SparsePoints(sparse.points, sparse.observations[sparse.observations[:, 0] != 4])
    chosen = choose_sources(cameras, bare, count=3)
    assert len(chosen[4]) == 3
    assert all(4 not in each for i, each in enumerate(chosen) if i != 4)


def test_cameras_at_one_position_have_no_sources():
    for count in (0, 1, 3):
        assert choose_sources([camera_at(0.0)] * count, None) == ((),) * count
    sparse = SparsePoints([[0.0, 0.0, 2.0]], [(0, 0), (1, 0), (2, 0)])
    assert choose_sources([camera_at(0.0)] * 3, sparse) == ((), (), ())


def test_an_observation_by_a_picture_that_is_not_there_is_refused():
    sparse = SparsePoints([[0.0, 0.0, 2.0]], [(3, 0)])
    with pytest.raises(ValueError, match="sparse:"):
        choose_sources([camera_at(0.0)] * 2, sparse)

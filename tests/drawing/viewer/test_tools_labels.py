"""Which points a shape on the screen means, and labels that are painted and taken back."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.drawing.render.view import fit_view
from pointloom.drawing.viewer.tools.labels import Painting, brush, meant_points
from pointloom.drawing.viewer.tools.picking import Target, project
from pointloom.kernels.lang import uint8
from pointloom.kernels.memory import upload

UTM = np.array([412_345.0, 5_412_345.0, 300.0])


def walls():
    """Two walls, one behind the other, and the view that sees the first alone."""
    y, z = (a.ravel() for a in np.mgrid[0:4:0.02, 0:3:0.02])
    near, far = np.column_stack([0 * y, y, z]), np.column_stack([0 * y + 2, y, z])
    view = fit_view(near + UTM, direction=(1, 0, 0), width=400, height=300)
    return near + UTM, far + UTM, view


def pixels(view, points):
    return np.array([project(view, point)[:2] for point in points])


def test_a_brush_means_what_is_seen_or_all_behind_it():
    near, far, view = walls()
    cloud = loom.PointCloud(np.vstack([near, far]))
    middle = pixels(view, [UTM + np.array([0, 2, 1.5])])[0]
    shape = brush(*middle, 40.0)
    inside = np.hypot(*(pixels(view, cloud.points) - middle).T) < 40
    all_through = meant_points(Target("a", cloud), [], view, shape, through=True)
    assert abs(len(all_through) - inside.sum()) < 0.01 * inside.sum() and (all_through >= len(near)).any()
    seen = meant_points(Target("a", cloud), [], view, shape, through=False)
    np.testing.assert_array_equal(seen, all_through[all_through < len(near)])


def test_other_clouds_stand_before_a_cloud_unless_they_are_hidden():
    near, far, view = walls()
    shape = brush(*pixels(view, [UTM + np.array([0, 2, 1.5])])[0], 40.0)
    back, front = Target("far", loom.PointCloud(far)), loom.PointCloud(near)
    assert len(meant_points(back, [Target("near", front)], view, shape, through=False)) == 0
    hidden = upload(np.ones(len(near), np.uint8), uint8, front.device)
    shown = meant_points(back, [Target("near", front, hidden=hidden)], view, shape, through=False)
    np.testing.assert_array_equal(shown, meant_points(back, [], view, shape, through=True))
    itself = Target("near", front, hidden=hidden)
    assert len(meant_points(itself, [], view, shape, through=True)) == 0


def test_strokes_are_taken_back_and_done_again_to_the_last_point(rng):
    before = rng.integers(0, 7, 1000).astype(np.int32)
    painting = Painting("classification", 1000, before)
    strokes = [painting.paint(rng.permutation(1000)[:300], label) for label in (2, 6, 2)]
    after = painting.labels.copy()
    for stroke in reversed(strokes):
        painting.take_back(stroke)
    np.testing.assert_array_equal(painting.labels, before)
    for stroke in strokes:
        painting.redo(stroke)
    np.testing.assert_array_equal(painting.labels, after)
    assert painting.unsaved == 9 and sum(painting.counts().values()) == 1000 and painting.classes[2].name == "ground"


def test_a_painted_cloud_holds_the_labels_and_leaves_the_given_one_alone(rng):
    cloud = loom.PointCloud(
        rng.random((50, 3)) + UTM, intensity=rng.random(50), colors=rng.random((50, 3)), unit="foot"
    )
    painting = Painting("label", 50)
    painting.paint([3, 4, 40], 2)
    painted = painting.on(cloud)
    assert np.flatnonzero(painted["label"] == 2).tolist() == [3, 4, 40] and "label" not in cloud
    np.testing.assert_array_equal(painted.points, cloud.points)
    assert painted.has_colors and painted.unit == "foot" and list(painted.attributes) == ["intensity", "label"]


def test_classes_are_named_coloured_and_added():
    painting = Painting("label", 4, [0, 1, 1, 9])
    assert sorted(painting.classes) == [0, 1, 2, 9] and painting.free_number() == 3
    painting.add_class(3, "kerb", (255, 0, 128))
    painting.paint([0], 3)
    assert painting.colors_of([0]).tolist() == [[255, 0, 128]] and painting.counts() == {0: 0, 1: 2, 2: 0, 3: 1, 9: 1}
    with pytest.raises(ValueError, match="0 to 255"):
        painting.add_class(256, "more", (0, 0, 0))


@pytest.mark.parametrize("labels", [[0, 300], [-1, 0], [0.5, 1.0], [[0, 1]], [0]])
def test_labels_that_no_byte_holds_are_refused(labels):
    with pytest.raises(ValueError, match="label"):
        Painting("label", 2, labels)

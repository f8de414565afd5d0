"""Where pictures are taken from: views that frame what they show, whatever it is."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.upward import check_up
from pointloom.drawing.render.upward import direction_under, level_up
from pointloom.drawing.render.view import fit_view


@pytest.mark.parametrize("offset", [(0, 0, 0), (5e5, 5.4e6, 300.0)])
def test_a_fitted_view_frames_all_points_tightly(offset):
    points = np.random.default_rng(0).uniform((-2, 0, 5), (3, 1, 9), (2000, 3)) + offset
    view = loom.fit_view(points, width=320, height=240)
    local = (points - view.T_world_camera[:3, 3]) @ view.T_world_camera[:3, :3]
    u = view.intrinsic.fx * local[:, 0] / local[:, 2] + view.intrinsic.cx
    v = view.intrinsic.fy * local[:, 1] / local[:, 2] + view.intrinsic.cy
    assert local[:, 2].min() > 0
    assert u.min() > 0 and u.max() < 319 and v.min() > 0 and v.max() < 239
    assert np.ptp(u) > 0.9 * 320 or np.ptp(v) > 0.9 * 240


@pytest.mark.parametrize("points", [[[1.0, 2.0, 3.0]], [[0, 0, 0], [0, 0, 4.0]], np.empty((0, 3)), [[np.nan, 0, 0]]])
def test_a_view_of_few_points_is_still_a_view(points):
    with pytest.raises(ValueError, match="direction"):
        loom.fit_view(points, direction=(0, 0, -1))  # along up
    view = loom.fit_view(points, width=160, height=120)
    assert np.isfinite(view.T_world_camera).all()


@pytest.mark.parametrize("up", ["x", "y", "z"])
def test_a_camera_is_level_to_the_axis_that_its_view_was_fitted_to(up):
    axis = np.array(check_up(up))
    x, y, z = direction_under(check_up(up))
    T = fit_view([[0, 0, 0], [1, 2, 3]], direction=(x, y, z), up=tuple(axis.tolist())).T_world_camera
    assert level_up(T[:3, 0], -T[:3, 1]).tolist() == axis.tolist()
    tilted = np.array([0.36, 0.48, 0.8])  # level to none
    assert level_up(np.cross(tilted, [0.8, -0.6, 0.0]), tilted) is tilted

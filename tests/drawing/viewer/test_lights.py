"""The page's light is that of our pictures, as nearly as lamps and its tone mapping can make it."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.drawing.viewer.lights import EVERYWHERE, KEY, KEY_DIRECTION, LAMP, page_light
from pointloom.drawing.viewer.surfaces import as_seen, sent_colors, tone_mapped

FAR = 2000.0  # [m]: every ray meets the ball alike


def ball():
    """The picture of a ball straight ahead, and its normals in the camera's frame, away from it, at each pixel [n]."""
    mesh = loom.TriangleMesh.create_sphere(1.0, 60)
    mesh = mesh.compute_vertex_normals()
    pose = np.eye(4)
    pose[2, 3] = -FAR
    view = loom.View(loom.PinholeCameraIntrinsic(120, 120, 55 * FAR, 55 * FAR, 59.5, 59.5), pose)
    v, u = np.mgrid[:120, :120]
    x, y = (u - 59.5) / 55, (v - 59.5) / 55
    inside = x**2 + y**2 < 0.93
    normals = np.stack([-x, -y, np.sqrt(1 - (x**2 + y**2) * inside)], axis=-1)[inside]
    return mesh, view, normals, inside


def in_the_page(color, normals):
    sent = sent_colors(np.array([color]), lit=True).astype(np.float64)
    return 255 * as_seen(tone_mapped(sent * page_light(normals)[:, None]))


# What is left, as mean and largest difference [levels of 255]. The page's tones fall off more steeply, and its white
# is 243; what is pure turns paler or darker there.
LEFT = {
    "as without colours": ((0.80, 0.78, 0.74), 7, 26),
    "grey": ((0.5, 0.5, 0.5), 6, 20),
    "brick": ((0.8, 0.25, 0.2), 7, 30),
    "Open3D's orange": ((1.0, 0.706, 0.0), 13, 46),
    "Open3D's blue": ((0.0, 0.651, 0.929), 13, 58),
}


@pytest.mark.parametrize("name", LEFT)
def test_a_ball_in_the_page_looks_as_in_our_picture(name):
    color, mean, most = LEFT[name]
    mesh, view, normals, inside = ball()
    picture = loom.render({"geometry": mesh, "color": color}, view)[inside].astype(float)
    apart = np.abs(in_the_page(color, normals) - picture)
    assert apart.mean() < mean and apart.max() < most, (apart.mean(), apart.max())


def test_the_lamps_are_the_nearest_ones_to_our_picture():
    mesh, view, normals, inside = ball()
    picture = loom.render(mesh, view)[inside].astype(float)
    sent = sent_colors(np.array([(0.80, 0.78, 0.74)]), lit=True).astype(np.float64)
    shares = np.stack([np.ones(len(normals)), normals[:, 2], np.maximum(normals @ KEY_DIRECTION, 0)], axis=1)

    def misses(strengths):
        return np.square(255 * as_seen(tone_mapped(sent * (shares @ strengths)[:, None])) - picture).mean()

    best = misses([EVERYWHERE, LAMP, KEY])
    for number in range(3):
        for factor in (0.9, 1.1):
            tried = np.array([EVERYWHERE, LAMP, KEY])
            tried[number] *= factor
            assert misses(tried) > best, (number, factor)

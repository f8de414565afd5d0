"""The z-buffer: what is in front wins, neighbours leave no gaps, and the bits do not depend on the order of threads."""

import numpy as np
import pytest

from pointloom.kernels import memory
from pointloom.kernels.algebra.camera import Camera
from pointloom.kernels.arrays.packed_keys import NO_KEY
from pointloom.kernels.drawing.z_buffer import View, draw_points, draw_triangles
from pointloom.kernels.lang import int32, vec3

WIDTH, HEIGHT = 64, 48
VIEW = View(Camera(WIDTH, HEIGHT, 50.0, 50.0, 31.5, 23.5), np.eye(3), np.zeros(3))


def draw(device, vertices, triangles, *, cull=False):
    """Depth [h, w] (0 where empty) and triangle [h, w] (-1 where empty)."""
    points = memory.upload(np.asarray(vertices, np.float32), vec3, device)
    indices = memory.upload(np.asarray(triangles, np.int32).ravel(), int32, device)
    return unpack(draw_triangles(points, indices, VIEW, cull=cull))


def unpack(buffer):
    words = buffer.words.numpy().reshape(HEIGHT, WIDTH)
    empty = words == NO_KEY
    depth = (words >> 32).astype(np.int32).view(np.float32)
    return np.where(empty, 0, depth), np.where(empty, -1, words & 0xFFFFFFFF)


def square(z, half):
    return [[-half, -half, z], [half, -half, z], [half, half, z], [-half, half, z]]


TWO = [[0, 2, 1], [0, 3, 2]]  # counterclockwise seen from the origin, where y runs down in the picture


def test_the_nearer_of_two_triangles_is_seen_whatever_their_order(device):
    near, far = square(2.0, 0.3), square(3.0, 0.6)
    for vertices, nearer in (([*near, *far], {0, 1}), ([*far, *near], {2, 3})):
        depth, seen = draw(device, vertices, [*TWO, *(np.array(TWO) + 4)])
        inner = depth[20:28, 28:36]
        assert np.allclose(inner, 2.0, atol=1e-6)
        assert set(np.unique(seen[20:28, 28:36])) == nearer
        assert depth.max() == pytest.approx(3.0, abs=1e-6)


def test_equal_depths_go_to_the_smaller_index(device):
    _, seen = draw(device, square(2.0, 0.3), [TWO[0], TWO[1], TWO[0], TWO[1]])
    assert set(np.unique(seen)) == {-1, 0, 1}


def test_a_fan_of_thin_triangles_leaves_no_gap(device):
    angles = np.linspace(0, 2 * np.pi, 90, endpoint=False)
    rim = np.column_stack([0.8 * np.cos(angles), 0.8 * np.sin(angles), np.full(90, 2.0)])
    vertices = np.vstack([[0.013, 0.007, 2.0], rim])
    triangles = [[0, 1 + i, 1 + (i + 1) % 90] for i in range(90)]
    depth, _ = draw(device, vertices, triangles)
    v, u = np.mgrid[0:HEIGHT, 0:WIDTH]
    inside = np.hypot((u - 31.5) / 25, (v - 23.5) / 25) < 0.77
    outside = np.hypot((u - 31.5) / 25, (v - 23.5) / 25) > 0.83
    assert (depth[inside] > 0).all()
    assert (depth[outside] == 0).all()


def test_pixels_whose_centres_lie_on_an_edge_are_drawn(device):
    """A square whose corners, and so its diagonal, lie on centres of pixels: no gap between its two triangles."""
    left, right = 2 * (np.array([11, 41]) - 31.5) / 50
    top, bottom = 2 * (np.array([9, 39]) - 23.5) / 50
    depth, _ = draw(device, [[left, top, 2], [right, top, 2], [right, bottom, 2], [left, bottom, 2]], TWO)
    expected = np.zeros((HEIGHT, WIDTH), bool)
    expected[9:40, 11:42] = True
    np.testing.assert_array_equal(depth > 0, expected)


def test_depth_of_a_tilted_triangle_is_that_of_its_plane(device):
    vertices = np.array([[-1.0, -0.8, 2.0], [1.5, -0.6, 4.0], [0.1, 1.2, 3.0]])
    depth, _ = draw(device, vertices, [[0, 1, 2]])
    normal = np.cross(vertices[1] - vertices[0], vertices[2] - vertices[0])
    v, u = np.nonzero(depth)
    rays = np.column_stack([(u - 31.5) / 50, (v - 23.5) / 50, np.ones(len(u))])
    expected = (vertices[0] @ normal) / (rays @ normal)
    assert len(u) > 200
    # corners lie on a grid of 1/256 cell, so depth is off by that part of a cell's slope
    assert np.abs(depth[v, u] - expected).max() < 1e-3


def test_culling_leaves_what_looks_at_the_camera(device):
    vertices = square(2.0, 0.3)
    backward = [t[::-1] for t in TWO]
    assert (draw(device, vertices, TWO, cull=True)[0] > 0).any()
    assert not (draw(device, vertices, backward, cull=True)[0] > 0).any()
    assert np.array_equal(draw(device, vertices, TWO)[0] > 0, draw(device, vertices, backward)[0] > 0)


@pytest.mark.parametrize(
    "vertices",
    [
        [[0, 0, -1], [1, 0, -1], [0, 1, -1]],
        [[0, 0, 2], [1, 0, 2], [0, 1, -1]],
        [[0, 0, 2], [1, 0, np.nan], [0, 1, 2]],
        [[0, 0, 2], [1, 0, 2], [np.inf, 1, 2]],
        [[0, 0, 2], [1e9, 0, 2], [0, 1, 2]],
        [[0, 0, 2], [0.5, 0, 2], [1, 0, 2]],
        [[50, 50, 2], [51, 50, 2], [50, 51, 2]],
    ],
    ids=["behind", "through the eye", "NaN", "infinite", "beyond the guard band", "flat", "outside"],
)
def test_triangles_that_cannot_be_drawn_are_left_out(device, vertices):
    assert not (draw(device, vertices, [[0, 1, 2]])[0] > 0).any()


def test_a_triangle_larger_than_the_picture_covers_it(device):
    depth, _ = draw(device, [[-90, -90, 2], [90, -90, 2], [0, 180, 2]], [[0, 1, 2]])
    assert np.allclose(depth, 2.0, atol=1e-5)


def test_no_triangles_leave_the_buffer_empty(device):
    assert (draw(device, np.empty((0, 3)), np.empty((0, 3)))[1] == -1).all()


def test_many_overlapping_triangles_give_the_same_bits_each_time(device):
    rng = np.random.default_rng(0)
    vertices = rng.uniform((-1, -1, 1), (1, 1, 4), (3000, 3))
    triangles = rng.integers(0, 3000, (4001, 3))
    first, second = draw(device, vertices, triangles), draw(device, vertices, triangles)
    assert first[0].tobytes() == second[0].tobytes() and first[1].tobytes() == second[1].tobytes()


def test_points_are_discs_and_the_nearest_is_seen(device):
    cloud = memory.upload(np.array([[0, 0, 2], [0, 0, 1], [0, 0, -1], [np.nan, 0, 1]], np.float32), vec3, device)
    depth, seen = unpack(draw_points(cloud, VIEW, radius=6.0))
    assert set(np.unique(seen)) == {-1, 1}
    assert abs((depth > 0).sum() - np.pi * 36) < 12

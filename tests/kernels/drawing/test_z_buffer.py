"""The z-buffer: what is in front wins, neighbors leave no gaps, and the bits do not depend on the order of threads."""

import numpy as np
import pytest

from pointloom.kernels import memory
from pointloom.kernels.algebra.camera import Camera
from pointloom.kernels.arrays.packed_keys import NO_KEY
from pointloom.kernels.drawing import triangles as tri
from pointloom.kernels.drawing.lines import Pen, draw_lines
from pointloom.kernels.drawing.points import Splat, count_in_squares, draw_points, gather_middles, spread_middles_kernel
from pointloom.kernels.drawing.z_buffer import DepthBuffer, View
from pointloom.kernels.lang import int32, int64, launch

from ..vectors import vectors

WIDTH, HEIGHT = 64, 48
CAMERA = Camera(WIDTH, HEIGHT, 50.0, 50.0, 31.5, 23.5)
VIEW = View(CAMERA, np.eye(3), np.zeros(3))


def draw(device, vertices, triangles, *, cull=False):
    """Depth [h, w] (0 where empty) and triangle [h, w] (-1 where empty)."""
    indices = memory.upload(np.asarray(triangles, np.int32).ravel(), int32, device)
    buffer = DepthBuffer(WIDTH, HEIGHT, device)
    tri.draw_triangles(vectors(device, vertices), indices, VIEW, buffer, cull=cull)
    return unpack(buffer)


def splat(device, points, size, *, radius=0.0, start=0):
    buffer = DepthBuffer(WIDTH, HEIGHT, device)
    draw_points(vectors(device, points), VIEW, buffer, splat=Splat(size, radius), start=start)
    return unpack(buffer)


def stroke(device, points, lines, radius):
    buffer = DepthBuffer(WIDTH, HEIGHT, device)
    indices = memory.upload(np.asarray(lines, np.int32).ravel(), int32, device)
    draw_lines(vectors(device, points), indices, VIEW, buffer, pen=Pen(radius, CAMERA))
    return unpack(buffer)


def unpack(buffer):
    words = memory.download(buffer.words).reshape(HEIGHT, WIDTH)
    empty = words == NO_KEY
    depth = (words >> 32).astype(np.int32).view(np.float32)
    return np.where(empty, 0, depth), np.where(empty, -1, words & 0xFFFFFFFF)


def square(z, half):
    return [[-half, -half, z], [half, -half, z], [half, half, z], [-half, half, z]]


def rays():
    v, u = np.mgrid[0:HEIGHT, 0:WIDTH]
    return np.stack([(u - 31.5) / 50, (v - 23.5) / 50, np.ones((HEIGHT, WIDTH))], -1)


def cast(vertices, triangle):
    """Depth [h, w] of the triangle that rays through the cells' centers meet before the camera; 0 where none does."""
    a, b, c = np.asarray(vertices, float)[list(triangle)]
    weights = np.linalg.solve(np.column_stack([a, b, c]), rays().reshape(-1, 3).T).T.reshape(HEIGHT, WIDTH, 3)
    with np.errstate(divide="ignore"):
        return np.where((weights > 0).all(axis=-1), 1 / weights.sum(axis=-1), 0.0)


def distance_to_edges(vertices, triangle):
    """Distances [cells], shape [h, w], of the cell centers from the projected edges of the triangle."""
    a, b, c = np.asarray(vertices, float)[list(triangle)]
    edges = np.stack([np.cross(b, c), np.cross(c, a), np.cross(a, b)])
    return (np.abs(rays() @ edges.T) / (np.linalg.norm(edges[:, :2], axis=1) / 50)).min(axis=-1)


TWO = [[0, 2, 1], [0, 3, 2]]  # counterclockwise seen from the origin, where y runs down in the picture


def test_the_nearer_of_two_triangles_is_visible_in_any_order(device):
    near, far = square(2.0, 0.3), square(3.0, 0.6)
    for vertices, nearer in (([*near, *far], {0, 1}), ([*far, *near], {2, 3})):
        depth, drawn = draw(device, vertices, [*TWO, *(np.array(TWO) + 4)])
        inner = depth[20:28, 28:36]
        assert np.allclose(inner, 2.0, atol=1e-6)
        assert set(np.unique(drawn[20:28, 28:36])) == nearer and depth.max() == pytest.approx(3.0, abs=1e-6)


def test_equal_depths_go_to_the_smaller_index(device):
    _, drawn = draw(device, square(2.0, 0.3), [TWO[0], TWO[1], TWO[0], TWO[1]])
    assert set(np.unique(drawn)) == {-1, 0, 1}


def test_pixels_with_centers_on_an_edge_are_drawn(device):
    """A square with its corners and diagonal on pixel centers: no gap between its two triangles."""
    left, right = 2 * (np.array([11, 41]) - 31.5) / 50
    top, bottom = 2 * (np.array([9, 39]) - 23.5) / 50
    depth, _ = draw(device, [[left, top, 2], [right, top, 2], [right, bottom, 2], [left, bottom, 2]], TWO)
    expected = np.zeros((HEIGHT, WIDTH), bool)
    expected[9:40, 11:42] = True
    np.testing.assert_array_equal(depth > 0, expected)


def test_culling_keeps_front_faces(device):
    vertices = square(2.0, 0.3)
    backward = [t[::-1] for t in TWO]
    assert (draw(device, vertices, TWO, cull=True)[0] > 0).any()
    assert not (draw(device, vertices, backward, cull=True)[0] > 0).any()
    assert np.array_equal(draw(device, vertices, TWO)[0] > 0, draw(device, vertices, backward)[0] > 0)


UNSEEN = {
    "behind": [[0, 0, -1], [1, 0, -1], [0, 1, -1]],
    "NaN": [[0, 0, 2], [1, 0, np.nan], [0, 1, 2]],
    "infinite": [[0, 0, 2], [1, 0, 2], [np.inf, 1, 2]],
    "flat": [[0, 0, 2], [0.5, 0, 2], [1, 0, 2]],
    "outside": [[50, 50, 2], [51, 50, 2], [50, 51, 2]],
    "a plane through the eye": [[-1, 0, -1], [1, 0, 3], [1, 0, -1]],
}
CLIPPED = {
    "one corner behind": [[-1, -1, 3], [1, -1, 2], [0.2, 0.6, -1]],
    "two behind": [[-1, -1, -3], [0.3, -0.2, 2], [0.2, 0.9, -1]],
    "a floor under the camera": [[-40, 3, 5], [40, 3, 9], [0, 3, -200]],
    "beyond the guard band": [[0, -1, 2], [1e7, 3, 2], [0, 1, 2]],
    "a corner at the eye": [[0.1, 0.1, 0], [3, 0.2, 5], [1, 4, 5]],
}


@pytest.mark.parametrize("name", UNSEEN)
def test_triangles_that_cannot_be_seen_are_left_out(device, name):
    assert not (draw(device, UNSEEN[name], [[0, 1, 2]])[0] > 0).any()


@pytest.mark.parametrize("name", CLIPPED)
def test_triangles_are_clipped_in_front_of_the_camera(device, name):
    vertices = CLIPPED[name]
    depth, _ = draw(device, vertices, [[0, 1, 2]])
    expected = cast(vertices, (0, 1, 2))
    both = (depth > 0) & (expected > 0)
    assert (expected > 0).sum() > 20
    # edges extend 1/128 of a cell further, by the sum of both axes
    assert distance_to_edges(vertices, (0, 1, 2))[(depth > 0) != (expected > 0)].max(initial=0) < 0.0115
    assert np.abs(depth[both] / expected[both] - 1).max() < 1e-4


def test_a_room_around_the_camera_has_no_gaps(device):
    vertices = np.array([[x, y, z] for x in (-2.0, 2.1) for y in (-1.5, 1.3) for z in (-3.1, 3.0)])
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    triangles = [t for a, b, c, d in faces for t in ([a, b, c], [a, c, d])]
    angle = 0.7
    rotation = np.array([[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]])
    depth, _ = draw(device, vertices @ rotation, triangles)
    assert (depth > 0).all()


def test_a_triangle_larger_than_the_image_covers_it(device):
    depth, _ = draw(device, [[-90, -90, 2], [90, -90, 2], [0, 180, 2]], [[0, 1, 2]])
    assert np.allclose(depth, 2.0, atol=1e-5)


@pytest.mark.parametrize("cull", [False, True])
def test_triangles_drawn_in_tiles_give_the_same_bits(device, cull, monkeypatch):
    rng = np.random.default_rng(3)
    sizes = np.repeat([0.02, 0.2, 1.0, 4.0], 20)[:, None, None]
    middles = rng.normal(size=(80, 1, 3)) * [0.5, 0.4, 0.6] + [0, 0, 1.5]
    vertices = (middles + sizes * rng.normal(size=(80, 3, 3))).reshape(-1, 3)  # some extend behind the camera
    triangles = memory.upload(np.arange(240, dtype=np.int32), int32, device)
    points, behind = vectors(device, vertices), None
    for _ in range(3):  # layer behind layer
        words = []
        in_tiles = ((tri.draw_in_tiles, 3 * tri.TILE_SIDE), (tri.draw_in_tiles, tri.NUM_THREADS))
        for draw_them, threads in ((tri.draw_triangles, tri.NUM_THREADS), *in_tiles):
            buffer = DepthBuffer(WIDTH, HEIGHT, device, behind=behind)
            with monkeypatch.context() as patch:
                patch.setattr(tri, "NUM_THREADS", threads)
                draw_them(points, triangles, VIEW, buffer, cull=cull, start=7)
            words.append(memory.download(buffer.words))
        assert np.unique(words[0]).size > 20 and (words[0] == words[1]).all() and (words[0] == words[2]).all()
        behind = buffer.words


def test_no_triangles_leave_the_buffer_empty(device):
    assert (draw(device, np.empty((0, 3)), np.empty((0, 3)))[1] == -1).all()


def test_points_are_discs_and_the_nearest_is_visible(device):
    depth, drawn = splat(device, [[0, 0, 2], [0, 0, 1], [0, 0, -1], [np.nan, 0, 1]], 6.0, start=100)
    assert set(np.unique(drawn)) == {-1, 101}
    assert abs((depth > 0).sum() - np.pi * 36) < 12


def test_points_smaller_than_a_cell_are_still_visible(device):
    depth, _ = splat(device, [[0.013, 0.007, 1.0]], 0.01)
    assert (depth > 0).sum() == 1


@pytest.mark.parametrize("radius", [0.4, 1.0, 2.9, 3.1, 6.0])
@pytest.mark.parametrize("count", [5, 5000])
def test_each_cell_shows_its_nearest_disc(device, radius, count):
    """Of many points the foremost in each cell are drawn around it: within a cell of what is exact."""
    rng = np.random.default_rng(5)
    points = rng.uniform((-0.7, -0.5, 1), (0.7, 0.5, 3), (count, 3)).astype(np.float32)
    depth, drawn = splat(device, points, radius)
    u, v = 50 * points[:, :2].T / points[:, 2] + np.array([[31.5], [23.5]])
    rows, columns = np.nonzero(depth)
    shown = drawn[rows, columns].astype(int)
    assert (points[shown, 2] == depth[rows, columns]).all()
    distances = np.hypot(columns - u[shown], rows - v[shown])
    assert distances.max() <= radius + 0.75
    for row, column in zip(rows[::7], columns[::7], strict=True):  # nothing nearer is well over the cell
        over = np.hypot(column - u, row - v) < radius - 0.75
        assert not over.any() or points[over, 2].min() >= depth[row, column] or count > 1000
    if count > 1000:  # of each cell the foremost middle is drawn there or hidden by a nearer one
        nearest = np.full((HEIGHT, WIDTH), np.inf)
        inside = (np.rint(u) >= 0) & (np.rint(v) >= 0) & (np.rint(u) < WIDTH) & (np.rint(v) < HEIGHT)
        cells = np.floor(v[inside] + 0.5).astype(int), np.floor(u[inside] + 0.5).astype(int)
        np.minimum.at(nearest, cells, points[inside, 2])
        assert (depth[nearest < np.inf] <= nearest[nearest < np.inf]).all()


@pytest.mark.parametrize("width", [5, 32, 70])
@pytest.mark.parametrize("radius", [0.5, 1.0, 2.9, 4.0])
def test_cells_that_gather_discs_show_what_discs_that_are_spread_show(device, width, radius):
    words = np.random.default_rng(6).integers(0, 100, 11 * width)
    words[words > 30] = NO_KEY
    before = np.random.default_rng(7).integers(0, 60, 11 * width)
    middles, gathered, spread = (
        DepthBuffer(width, 11, device, words=memory.upload(each, int64, device)) for each in (words, before, before)
    )
    gather_middles(middles, radius, gathered)
    launch(spread_middles_kernel, words.size, [middles, Splat(radius), spread])
    assert (memory.download(gathered.words) == memory.download(spread.words)).all()
    assert (memory.download(spread.words) < before).any()


def test_points_are_counted_where_they_are_visible(device):
    points = vectors(device, [[0.1, 0, 2]] * 7 + [[0.1, 0, 3]] * 5 + [[-0.5, 0, 1]] * 3 + [[0, 0, -2]])
    counts, depths = count_in_squares(points, VIEW)
    assert counts.tolist() == [3.0, 7.0] and depths.tolist() == [1.0, 2.0]  # those behind others do not count


def test_a_line_has_the_given_width_and_round_ends(device):
    depth, _ = stroke(device, [[-0.4, 0.1, 1.0], [0.4, 0.1, 1.0]], [[0, 1]], 3.0)
    assert (depth > 0).sum() == pytest.approx(40 * 6 + np.pi * 9, rel=0.05)
    assert (depth[:, 31] > 0).sum() == 6


@pytest.mark.parametrize("angle", np.linspace(0, np.pi, 9))
def test_lines_of_all_slopes_have_no_gaps_and_the_same_area(device, angle):
    x, y = 0.4 * np.cos(angle), 0.4 * np.sin(angle)
    depth, _ = stroke(device, [[-x, -y, 1], [x, y, 1]], [[0, 1]], 1.0)
    assert (depth > 0).sum() == pytest.approx(40 * 2 + np.pi, rel=0.12)


@pytest.mark.parametrize(
    "ends",
    [[[0, 0.5, -5.0], [0.0, 0.5, 5.0]], [[-1e6, 0.1, 1.0], [1e6, 0.1, 1.0]], [[0.0, 0.1, 0.0], [0.0, 0.1, 3.0]]],
    ids=["from behind", "far out on both sides", "from beside the eye"],
)
def test_lines_are_clipped_to_the_image(device, ends):
    depth, _ = stroke(device, ends, [[0, 1]], 1.0)
    assert (depth > 0).sum() > 15


def test_lines_that_cannot_be_seen_are_left_out(device):
    points = [[0, 0, -1], [1, 0, -2], [np.nan, 0, 1], [0, 0, 1], [50, 0, 1], [60, 0, 1]]
    assert not (stroke(device, points, [[0, 1], [2, 3], [4, 5]], 2.0)[0] > 0).any()


def test_a_line_of_no_length_is_a_disc(device):
    depth, _ = stroke(device, [[0, 0, 1], [0, 0, 1]], [[0, 1]], 4.0)
    assert (depth > 0).sum() == pytest.approx(np.pi * 16, rel=0.1)


def test_a_line_in_a_tilted_surface_is_fully_visible(device):
    vertices = np.array([[-1, -1, 2], [1, -1, 2.5], [1, 1, 4], [-1, 1, 3.5]])
    surface, _ = draw(device, vertices, TWO)
    corners = vertices[0] * 0.8 + vertices[2] * 0.2, vertices[0] * 0.2 + vertices[2] * 0.8
    line, _ = stroke(device, corners, [[0, 1]], 1.0)
    on_both = (line > 0) & (surface > 0)
    assert on_both.sum() > 20 and (line[on_both] < surface[on_both]).all()

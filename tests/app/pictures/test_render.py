"""Pictures: silhouettes of the right size, colours where they belong, the same bits each time, clear refusals."""

from types import SimpleNamespace

import numpy as np
import pytest

from pointloom.app.pictures.picture_files import save_picture
from pointloom.app.pictures.render import render_mesh, render_point_cloud
from pointloom.app.pictures.view import View, fit_view
from pointloom.pcd.camera import PinholeCameraIntrinsic
from pointloom.pcd.errors import FileError
from pointloom.pcd.io.image_files import read_color

SMALL = {"width": 160, "height": 120}


def sphere(radius=1.0, rings=60, center=(0.0, 0.0, 0.0)):
    """A sphere whose triangles look outward."""
    theta, phi = np.meshgrid(np.linspace(0, np.pi, rings + 1), np.linspace(0, 2 * np.pi, 2 * rings, endpoint=False))
    points = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], -1)
    i, j = np.meshgrid(np.arange(2 * rings), np.arange(rings), indexing="ij")
    a, b = i * (rings + 1) + j, ((i + 1) % (2 * rings)) * (rings + 1) + j
    triangles = np.concatenate([np.stack([a, a + 1, b], -1), np.stack([b, a + 1, b + 1], -1)]).reshape(-1, 3)
    normals = points.reshape(-1, 3)
    return SimpleNamespace(vertices=radius * normals + center, triangles=triangles, vertex_normals=normals)


def straight_view(distance, focal=200.0):
    """A camera on the negative z axis that looks along z."""
    T = np.eye(4)
    T[2, 3] = -distance
    return View(PinholeCameraIntrinsic(160, 120, focal, focal, 79.5, 59.5), T)


def coverage(image):
    """The covered area [px] of a picture on white, edges by their share, of a mesh that is black."""
    return (255 - image[..., 0].astype(float)).sum() / 255


def test_a_sphere_has_the_silhouette_of_a_sphere(device):
    view, distance = straight_view(5.0), 5.0
    image = render_mesh(sphere(), view=view, color=(0, 0, 0), device=device)
    expected = np.pi * 200.0**2 / (distance**2 - 1)  # the tangent cone of a sphere on the axis
    assert coverage(image) == pytest.approx(expected, rel=0.01)
    rows, columns = np.nonzero(image[..., 0] < 128)
    assert rows.mean() == pytest.approx(59.5, abs=0.1) and columns.mean() == pytest.approx(79.5, abs=0.1)


def test_vertex_colours_are_interpolated_in_perspective(device):
    vertices = np.array([[-1.0, -1.0, 2.0], [1.0, -1.0, 6.0], [1.0, 1.0, 6.0], [-1.0, 1.0, 2.0]])
    ramp = np.column_stack([(vertices[:, 0] + 1) / 2, np.zeros(4), np.zeros(4)])
    mesh = SimpleNamespace(vertices=vertices, triangles=[[0, 2, 1], [0, 3, 2]], vertex_colors=ramp)
    view = View(PinholeCameraIntrinsic(160, 120, 60.0, 60.0, 79.5, 59.5), np.eye(4))
    row = render_mesh(mesh, view=view, shaded=False, cull=False, device=device)[59, :, 0].astype(float) / 255
    for column in range(60, 88):  # x = 2 share - 1 lies on the plane z = 4 + 2 x
        slope = (column - 79.5) / 60
        x = 4 * slope / (1 - 2 * slope)
        assert row[column] == pytest.approx((x + 1) / 2, abs=0.01)


def test_one_looks_into_a_closed_box_through_its_near_walls(device):
    inward = sphere()
    inward.triangles, inward.vertex_colors = inward.triangles[:, ::-1], np.clip(inward.vertices, 0, 1)
    culled = render_mesh(inward, view=straight_view(5.0), device=device)
    closed = render_mesh(inward, view=straight_view(5.0), cull=False, device=device)
    assert culled[60, 80, 2] > 240 and closed[60, 80, 2] < 15


def test_the_order_of_triangles_does_not_change_the_picture(device):
    mesh = sphere(rings=30)
    first = render_mesh(mesh, **SMALL, device=device)
    assert first.tobytes() == render_mesh(mesh, **SMALL, device=device).tobytes()
    mesh.triangles = mesh.triangles[::-1]
    # triangles with the same depth in a sample may change places there
    assert (first != render_mesh(mesh, **SMALL, device=device)).mean() < 0.01


def test_a_cloud_without_normals_and_colors_is_drawn(rng):
    import pointloom as loom

    image = render_point_cloud(loom.PointCloud(rng.random((500, 3))), width=64, height=48)
    assert (image < 250).any()


def test_an_empty_mesh_and_cloud_give_the_background(device):
    nothing = SimpleNamespace(vertices=np.empty((0, 3)), triangles=np.empty((0, 3), int), points=np.empty((0, 3)))
    for render in (render_mesh, render_point_cloud):
        image = render(nothing, **SMALL, background=(0.2, 0.4, 1.0), device=device)
        assert image.shape == (120, 160, 3) and image.dtype == np.uint8
        assert np.unique(image.reshape(-1, 3), axis=0).tolist() == [[51, 102, 255]]


def test_points_keep_their_colours_and_one_point_is_a_disc(device):
    cloud = SimpleNamespace(points=np.zeros((1, 3)), colors=[[1.0, 0.0, 0.0]])
    image = render_point_cloud(cloud, view=straight_view(2.0), point_size=20, shaded=False, device=device)
    assert (image[60, 80] == (255, 0, 0)).all()
    assert (255 - image[..., 1].astype(float)).sum() / 255 == pytest.approx(np.pi * 100, rel=0.03)


def test_points_that_are_not_finite_are_left_out(device):
    cloud = SimpleNamespace(points=[[np.nan, 0, 0], [0, 0, 0], [np.inf, 1, 1]])
    image = render_point_cloud(cloud, view=straight_view(2.0), point_size=8, color=(0, 0, 0), device=device)
    assert coverage(image) == pytest.approx(np.pi * 16, rel=0.1)


def test_coordinates_of_a_map_grid_are_drawn_as_exactly_as_small_ones(device):
    far = sphere(center=(5e5, 5.4e6, 300.0))
    near = render_mesh(sphere(), **SMALL, device=device).astype(int)
    assert np.abs(near - render_mesh(far, **SMALL, device=device)).mean() < 0.5


def test_the_automatic_view_frames_all_points_tightly():
    points = np.random.default_rng(0).uniform((-2, 0, 5), (3, 1, 9), (2000, 3))
    view = fit_view(points, width=320, height=240)
    local = (points - view.T_world_camera[:3, 3]) @ view.T_world_camera[:3, :3]
    u = view.intrinsic.fx * local[:, 0] / local[:, 2] + view.intrinsic.cx
    v = view.intrinsic.fy * local[:, 1] / local[:, 2] + view.intrinsic.cy
    assert local[:, 2].min() > 0
    assert u.min() > 0 and u.max() < 319 and v.min() > 0 and v.max() < 239
    assert np.ptp(u) > 0.9 * 320 or np.ptp(v) > 0.9 * 240


@pytest.mark.parametrize("points", [[[1.0, 2.0, 3.0]], [[0, 0, 0], [0, 0, 4.0]], np.empty((0, 3))])
def test_a_view_of_few_points_is_still_a_view(points):
    view = fit_view(points, **SMALL)
    assert np.isfinite(view.T_world_camera).all()


def test_a_picture_is_written_and_not_replaced_unasked(tmp_path):
    image = render_mesh(sphere(rings=8), **SMALL)
    save_picture(tmp_path / "a.png", image)
    assert np.array_equal(read_color(tmp_path / "a.png"), image)
    with pytest.raises(FileError, match="exists already"):
        save_picture(tmp_path / "a.png", image, overwrite=False)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"width": 0}, "width"),
        ({"height": -3}, "height"),
        ({"background": (1.0, 1.0)}, "background"),
    ],
)
def test_options_out_of_range_are_refused(change, message):
    with pytest.raises(ValueError, match=message):
        render_mesh(sphere(rings=4), **{**SMALL, **change})


def test_arrays_that_do_not_belong_together_are_refused():
    mesh = sphere(rings=4)
    mesh.triangles = mesh.triangles + 1
    with pytest.raises(ValueError, match="triangles"):
        render_mesh(mesh, **SMALL)
    with pytest.raises(ValueError, match="colors"):
        render_point_cloud(SimpleNamespace(points=np.zeros((3, 3)), colors=np.zeros((2, 3))), **SMALL)
    with pytest.raises(ValueError, match="point_size"):
        render_point_cloud(SimpleNamespace(points=np.zeros((3, 3))), point_size=0, **SMALL)
    with pytest.raises(ValueError, match="direction"):
        fit_view(np.zeros((3, 3)), direction=(0, 0, -1))
    with pytest.raises(TypeError, match="view"):
        render_mesh(sphere(rings=4), view=np.eye(4))

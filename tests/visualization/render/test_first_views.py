"""First views without options: colors of plain clouds, clouds of depth images upright, meshes from the front."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.visualization.render.camera_frame import is_in_camera_frame
from pointloom.visualization.render.geometries import CLOUD_COLORS, named_geometries
from pointloom.visualization.render.up_axis import CAMERA_UP, VIEW_DIRECTION, look_of

SMALL = {"size": (120, 90)}
CAMERA = loom.PinholeCameraIntrinsic(96, 72, 80.0, 80.0, 47.5, 35.5)


def slope(**attributes):
    x, y = np.mgrid[:30, :30].reshape(2, -1) / 10.0
    return loom.PointCloud(np.column_stack([x, y, 0.5 * x + 0.1 * y]), **attributes)


def styles(geometries, colored=()):
    return [(style.color_by, style.color) for _, _, style in named_geometries(geometries, colored)]


def test_a_single_cloud_without_colors_is_colored_by_height(device):
    cloud = slope(device=device, intensity=np.arange(900.0))
    stored = sorted(cloud.attributes), cloud.has_colors
    image = loom.render(cloud, **SMALL)
    np.testing.assert_array_equal(image, loom.render({"geometry": cloud, "color_by": "height"}, **SMALL))
    np.testing.assert_array_equal(image, loom.render(np.asarray(cloud.points), **SMALL))
    assert (sorted(cloud.attributes), cloud.has_colors) == stored
    assert styles([cloud, loom.TriangleMesh.create_box()])[0] == ("height", None)


def test_other_clouds_keep_their_colors():
    colored = slope(colors=np.full((900, 3), 0.3))
    red = {"geometry": slope(), "color": (1, 0, 0)}
    by = {"geometry": slope(label=np.zeros(900, np.int32)), "color_by": "label"}
    assert styles(colored) == [(None, None)]
    assert styles([colored, slope()]) == [(None, None), ("height", None)]
    assert styles(red) == [(None, (1, 0, 0))] and styles(by) == [("label", None)]
    assert styles([slope(), red, slope()]) == [(None, CLOUD_COLORS[0]), (None, (1, 0, 0)), (None, CLOUD_COLORS[1])]
    assert styles({"large": slope()}, {"large"}) == [(None, None)]


@pytest.mark.parametrize("points", [[], [[0, 0, 1]], [[0, 0, 1], [5, 0, 1]], [[np.nan, 0, 0], [1, 0, 2]]])
def test_a_cloud_without_height_differences_has_one_color(points):
    assert styles(loom.PointCloud(np.reshape(points, (-1, 3)))) == [(None, None)]


def depth_image():
    u, v = np.meshgrid(np.arange(96), np.arange(72))
    depth = (1500 + 3 * u + 200 * (v > 40) + (u * v) % 7).astype(np.uint16)
    depth[10:20, 10:30] = 0
    return depth


def seen(**options):
    return loom.PointCloud.create_from_depth_image(depth_image(), CAMERA, **options)


def pose(*angles):
    turned = np.eye(4)
    for axis, angle in zip("xyz", angles, strict=True):
        R, (i, j) = np.eye(4), {"x": (1, 2), "y": (0, 2), "z": (0, 1)}[axis]
        R[[i, j, i, j], [i, j, j, i]] = np.cos(angle), np.cos(angle), -np.sin(angle), np.sin(angle)
        turned = turned @ R
    return turned


def grid(height):
    y, x = np.mgrid[-20:21, -30:31].reshape(2, -1) / 10.0
    return loom.PointCloud(np.column_stack([x, y, height(x, y)]))


def test_clouds_of_depth_images_are_upright(device):
    cloud = seen(device=device)
    assert look_of([(cloud, None)])[1] == CAMERA_UP
    np.testing.assert_array_equal(loom.render(cloud, **SMALL), loom.render(cloud, up=CAMERA_UP, **SMALL))


IN_CAMERA_FRAME = {
    "depth image": lambda: seen(),
    "with invalid pixels": lambda: seen(project_valid_depth_only=False),
    "every third pixel": lambda: seen(stride=3),
    "some of its points": lambda: seen().select_by_index(np.arange(0, 5000, 2)),
    "with normals": lambda: seen(with_normals=True),
    "pitched, y still down": lambda: seen().transform(pose(0.1, 0, 0)),
    "identity frustum": lambda: loom.CameraFrustum(CAMERA, np.eye(4)),
    "first camera, tilted by 10 degrees": lambda: loom.CameraFrustum(CAMERA, pose(0.17, 0.1, 0.05)),
}
OTHERS = {
    "rolled": lambda: seen().transform(pose(0, 0, 0.1)),
    "world frame": lambda: seen(extrinsic=pose(np.pi / 2, 0, 0)),
    "in another order": lambda: seen().select_by_index(np.random.default_rng(0).permutation(5000)),
    "voxels": lambda: seen().voxel_down_sample(0.02),
    "far from the origin": lambda: seen().translate([4e5, 5e6, 0]),
    "plane as a grid": lambda: grid(lambda x, y: 1 + 0 * x),
    "heights as a grid": lambda: grid(lambda x, y: 2 + 0.3 * np.sin(x) + 0.1 * y),
    "high above the origin": lambda: grid(lambda x, y: 300 + 0.3 * np.sin(x) + 0.1 * y),
    "nothing": lambda: loom.PointCloud(),
    "one row": lambda: seen().select_by_index(np.arange(90)),
    "mesh": lambda: loom.TriangleMesh.create_box(),
    "camera of a drone": lambda: loom.CameraFrustum(CAMERA, pose(np.pi, 0, 0)),
    "camera in a room": lambda: loom.CameraFrustum(CAMERA, pose(-np.pi / 2, 0, 0)),
}


@pytest.mark.parametrize("name", [*IN_CAMERA_FRAME, *OTHERS])
def test_the_frame_of_a_camera_is_recognized(name):
    geometry = (IN_CAMERA_FRAME | OTHERS)[name]()
    assert is_in_camera_frame(geometry) == (name in IN_CAMERA_FRAME)


def wall(angle, *, tilt=0.0):
    """A square whose front faces along (0, -1, 0), rotated about z: the default view sees it at angle 0."""
    square = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [1, tilt, 1], [0, tilt, 1]], [[0, 1, 2], [0, 2, 3]])
    return square.transform(pose(0, 0, angle))


@pytest.mark.parametrize("angle", np.linspace(0, 2 * np.pi, 9)[:8])
def test_open_meshes_are_seen_from_the_front(device, angle):
    mesh = wall(angle).to(device)
    front = np.asarray(mesh.triangle_normals[0], float)
    for placed in ((mesh, None), (wall(0.3).to(device), pose(0, 0, angle - 0.3))):
        direction, up = look_of([placed])
        assert up == (0, 0, 1) and direction[2] == pytest.approx(VIEW_DIRECTION[2])
        assert front @ direction < 0
        assert np.linalg.norm(direction) == pytest.approx(np.linalg.norm(VIEW_DIRECTION))


@pytest.mark.parametrize(
    "mesh",
    [
        loom.TriangleMesh(),
        loom.TriangleMesh.create_sphere(),
        loom.TriangleMesh.create_torus(),
        wall(0),
        loom.TriangleMesh([[0, 0, 0], [4, 0, 0], [4, 4, 1], [0, 4, 1]], [[0, 1, 2], [0, 2, 3]]),  # a hillside
        loom.TriangleMesh([[0, 0, 0], [4, 0, 0], [0, 4, 0]], [[0, 2, 1]]),  # a ceiling, a back from everywhere
        loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 0, np.nan]], [[0, 2, 1]]),
    ],
)
def test_other_meshes_are_seen_as_before(mesh):
    assert look_of([(mesh, None)]) == (VIEW_DIRECTION, (0, 0, 1))
    mesh.up = "y"
    assert look_of([(mesh, None)])[1] == (0, 1, 0)

"""Textures from posed images: colors, occlusion, gutters, files, and bad input."""

import numpy as np
import pytest

import pointloom as loom

from .color_scenes import WALL, make_scene, paint

ROWS = 25


def with_uvs(mesh, rows=ROWS):
    """The wall in the lower left quarter of the texture, the ball in the lower right quarter."""
    triangles, vertices = mesh.triangles, mesh.vertices
    half = len(triangles) // 2
    uvs = np.zeros((len(triangles), 3, 2))
    uvs[:half] = (vertices[triangles[:half]][..., :2] + 1) / 2 * 0.48 + 0.01
    index = triangles[half:] - rows * rows
    uvs[half:, :, 0] = index % rows / (rows - 1) * 0.48 + 0.51
    uvs[half:, :, 1] = index // rows / (rows - 1) * 0.48 + 0.01
    mesh = mesh.copy()
    mesh.triangle_uvs = uvs.reshape(-1, 2)
    return mesh


def bake(scene, size=128, mesh=None, images=None):
    mesh = with_uvs(scene.mesh) if mesh is None else mesh
    images = [frame.color for frame in scene.frames] if images is None else images
    extrinsics = [np.linalg.inv(pose) for pose in scene.poses]
    return mesh.project_images_to_albedo(images, scene.camera, extrinsics, size)


def wall_texels(size):
    """Wall positions [m] of the texels of the lower left quarter, and their rows and columns."""
    row, column = np.mgrid[:size, :size]
    u, v = (column + 0.5) / size, 1 - (row + 0.5) / size
    inside = (u > 0.02) & (u < 0.48) & (v > 0.02) & (v < 0.48)
    x, y = ((t[inside] - 0.01) / 0.48 * 2 - 1 for t in (u, v))
    return np.stack([x, y, np.full_like(x, WALL)], -1), row[inside], column[inside]


def test_texels_have_the_color_of_their_position(device):
    scene = make_scene(device, rows=ROWS)
    texture = bake(scene).textures[0]
    positions, row, column = wall_texels(128)
    result = texture[row, column] / 255
    seen = result.max(axis=1) > 0
    errors = np.abs(result - paint(positions))[seen].max(axis=1)
    assert seen.mean() > 0.5
    # bilinear between pixels of 10 mm, two roundings to bytes
    assert np.median(errors) < 0.01 and errors.max() < 0.1


def test_foreground_and_background_do_not_mix_colors(device):
    """A red ball in front of a wall of another color: no red on the wall, no wall color on the ball."""
    scene = make_scene(device, rows=ROWS)
    plain = []
    for frame, pose in zip(scene.frames, scene.poses, strict=True):
        v, u = np.mgrid[: scene.camera.height, : scene.camera.width]
        x, y = (u - scene.camera.cx) / scene.camera.fx, (v - scene.camera.cy) / scene.camera.fy
        z = (np.stack([x, y, np.ones_like(x)], -1) @ pose[:3, :3].T * frame.depth[..., None] + pose[:3, 3])[..., 2]
        plain.append(np.where((z > WALL - 1e-3)[..., None], (0, 120, 250), (250, 0, 0)).astype(np.uint8))
    texture = bake(scene, images=plain).textures[0]
    wall = texture[70:122, 6:58].reshape(-1, 3)
    ball = texture[70:122, 70:122].reshape(-1, 3)
    assert set(map(tuple, wall.tolist())) == {(0, 120, 250), (0, 0, 0)}
    assert set(map(tuple, ball.tolist())) == {(250, 0, 0), (0, 0, 0)}


def test_back_facing_triangles_are_not_painted(device):
    camera = loom.PinholeCameraIntrinsic(64, 48, 30.0, 30.0, 31.5, 23.5)
    corners, uvs = [[-1, -1, 2], [1, -1, 2], [-1, 1, 2]], [[0, 0], [1, 0], [0, 1]]
    white = np.full((48, 64, 3), 255, np.uint8)
    sums = []
    for triangle in ([0, 1, 2], [0, 2, 1]):
        mesh = loom.TriangleMesh(corners, [triangle], device=device)
        mesh.triangle_uvs = [uvs[k] for k in triangle]
        sums.append(int(mesh.project_images_to_albedo([white], camera, [np.eye(4)], 16).textures[0].sum()))
    assert sums[0] == 0 and sums[1] > 0


def test_the_nearer_image_has_more_weight(device):
    camera = loom.PinholeCameraIntrinsic(64, 48, 150.0, 150.0, 31.5, 23.5)
    mesh = loom.TriangleMesh([[-0.3, -0.3, 2], [0.3, -0.3, 2], [-0.3, 0.3, 2]], [[0, 2, 1]], device=device)
    mesh.triangle_uvs = [[0, 0], [0, 1], [1, 0]]
    red, blue = (np.full((48, 64, 3), c, np.uint8) for c in ((240, 0, 0), (0, 0, 240)))
    back = np.eye(4)
    back[2, 3] = 2.0  # twice as far: a sixteenth of the weight
    texture = mesh.project_images_to_albedo([red, blue], [camera, camera.matrix], [np.eye(4), back], 32).textures[0]
    ratio = texture[20, 9].astype(float)
    # the viewing angle decreases as well: cos^4 / z^4
    x, y = -0.3 + 0.6 * (9.5 / 32), -0.3 + 0.6 * (1 - 20.5 / 32)
    weights = [(z / np.sqrt(x * x + y * y + z * z) / z) ** 4 for z in (2.0, 4.0)]
    assert np.abs(ratio[[0, 2]] - 240 * np.array(weights) / sum(weights)).max() <= 1


def test_texels_beside_a_triangle_repeat_it(device):
    mesh = loom.TriangleMesh([[-1, -1, 2], [1, -1, 2], [-1, 1, 2]], [[0, 2, 1]], device=device)
    mesh.vertex_colors = np.tile([0, 99 / 255, 0], (3, 1))  # where the image ends
    mesh.triangle_uvs = [[0.5, 0.5], [0.5, 0.75], [0.75, 0.5]]
    camera = loom.PinholeCameraIntrinsic(64, 48, 20.0, 20.0, 31.5, 23.5)
    green = np.full((48, 64, 3), (0, 99, 0), np.uint8)
    texture = mesh.project_images_to_albedo([green], camera, [np.eye(4)], 64).textures[0]
    assert texture[31 + 8, 36].tolist() == [0, 99, 0] and texture[31 + 9, 36].tolist() == [0, 0, 0]
    assert set(map(tuple, texture.reshape(-1, 3).tolist())) == {(0, 99, 0), (0, 0, 0)}


def test_unseen_texels_take_the_vertex_colors(device):
    scene = make_scene(device, rows=ROWS)
    mesh = with_uvs(scene.mesh)
    mesh.vertex_colors = paint(mesh.vertices)
    texture = bake(scene, mesh=mesh).textures[0]
    positions, row, column = wall_texels(128)
    # linear across triangles of 8 cm
    assert np.median(np.abs(texture[row, column] / 255 - paint(positions)).max(axis=1)) < 0.02
    assert texture[row, column].max(axis=1).min() > 0


def test_scale_and_position_do_not_matter(device):
    scene = make_scene(device, rows=ROWS, width=80, height=60)
    expected = bake(scene, 64).textures[0].astype(int)
    for scale, shift in ((1e-6, 0), (1e6, 0), (1.0, (5e5, 5.4e6, 120))):
        mesh = loom.TriangleMesh(scene.mesh.vertices * scale + shift, scene.mesh.triangles, device=device)
        poses = scene.poses.copy()
        poses[:, :3, 3] = poses[:, :3, 3] * scale + shift
        moved = make_scene(device, rows=ROWS, width=80, height=60)
        moved.mesh, moved.poses = mesh, poses
        mesh.triangle_uvs = with_uvs(scene.mesh).triangle_uvs
        result = bake(moved, 64, mesh=mesh).textures[0].astype(int)
        # a texel beside an edge may belong to either side
        assert (np.abs(result - expected).max(axis=-1) > 2).mean() < 0.01


def test_bad_input_is_named():
    scene = make_scene(rows=ROWS, width=32, height=24)
    mesh, camera = with_uvs(scene.mesh), scene.camera
    images, poses = [frame.color for frame in scene.frames], list(scene.poses)
    flat, nan = loom.TriangleMesh([[0, 0, 0]]), [np.full((4, 4), np.nan), *poses[1:]]
    wrong = [*images[:2], np.zeros((2, 2, 3), np.uint8), *images[3:]]
    for one, given, named in (
        (scene.mesh, (images, camera, poses), "expected triangle_uvs"),
        (flat, (images, camera, poses), "expected triangles"),
        (mesh, (images, camera, poses[:4]), "expected 5, one per image, got 4"),
        (mesh, (images, [camera], poses), "expected 5, one per image, got 1"),
        (mesh, (wrong, camera, poses), r"images\[2\]"),
        (mesh, (images, camera, poses, 0), "tex_size"),
        (mesh, (images, camera, nan), r"extrinsic_matrices\[0\]"),
    ):
        with pytest.raises(ValueError, match=named):
            one.project_images_to_albedo(*given)
    outside = mesh.copy()
    outside.triangle_uvs = np.asarray(mesh.triangle_uvs) + 5
    with pytest.raises(ValueError, match=r"^mesh:"):
        outside.project_images_to_albedo(images, camera, poses)
    broken = np.array(mesh.triangle_uvs)
    broken[:30] = np.nan
    mesh.triangle_uvs = broken
    assert mesh.project_images_to_albedo(images, camera, poses, 16).textures[0].shape == (16, 16, 3)

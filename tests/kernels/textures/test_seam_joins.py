"""Strips and joins at seams: three pictures that meet have one color there, and both sides are drawn alike."""

import numpy as np

import pointloom as loom

from ...meshing.picture_scenes import CAMERA, sampled, wall_scene

texture = loom.color_map.texture_from_pictures
POSITIONS = np.linspace(0.02, 0.98, 9)


def wedges(device):
    """Three triangles about a point, and pictures that differ by constants, of which each is the best for one."""
    scene = wall_scene((1.0, 1.0, 1.0), device)
    around = [(0.3 * np.cos(t), 0.3 * np.sin(t), 0.0) for t in np.radians((90, 210, 330))]
    mesh = loom.TriangleMesh([(0.0, 0.0, 0.0), *around], [[0, 2, 1], [0, 3, 2], [0, 1, 3]], device=device)
    v, u = np.mgrid[: CAMERA.height, : CAMERA.width]
    angle = np.degrees(np.arctan2(v - CAMERA.cy, u - CAMERA.cx)) % 360
    pictures = []
    for k, level in enumerate((90, 120, 180)):
        middle = (150, 270, 30)[k]
        detail = 12.0 * (np.abs((angle - middle + 180) % 360 - 180) < 58) * ((u + v) % 4 < 2)
        pictures.append(np.repeat((level + detail)[..., None], 3, 2).astype(np.uint8))
    return mesh, pictures, [scene.extrinsics[1]] * 3


def steps_at(result, positions):
    """The steps between each two of the triangles, along the edge from the middle, in the mean of channels."""
    steps = []
    triangles = np.asarray(result.mesh.triangles)
    for a in range(3):
        b = (a + 1) % 3
        shared = next(v for v in triangles[a] if v and v in triangles[b])
        for position in positions:
            colors = []
            for row in (a, b):
                share = np.zeros(3)
                share[triangles[row] == 0], share[triangles[row] == shared] = 1 - position, position
                colors.append(sampled(result.mesh, row, share))
            steps.append(np.abs(colors[0] - colors[1]).mean())
    return np.array(steps)


def test_three_adjacent_images_have_one_color_at_their_corner(device):
    mesh, pictures, poses = wedges(device)
    how = {"exposures": False, "seam_leveling": False, "smoothness": 0.0, "outliers": False}
    plain = texture(mesh, pictures, CAMERA, poses, local_leveling=False, **how)
    assert len(set(plain.views.tolist())) == 3 and steps_at(plain, POSITIONS).min() > 15
    result = texture(mesh, pictures, CAMERA, poses, **how)
    assert steps_at(result, POSITIONS).max() < 1.5
    middle = [sampled(result.mesh, row, np.asarray(result.mesh.triangles)[row] == 0).mean() for row in range(3)]
    assert np.ptp(middle) < 1.5
    assert 126 < np.mean(middle) < 142  # 130, the mean of all three, with up to 12 of detail


def test_far_from_seams_nothing_changes(device):
    mesh, pictures, poses = wedges(device)
    large = loom.PinholeCameraIntrinsic(CAMERA.width * 4, CAMERA.height * 4, 360.0, 360.0, 191.5, 143.5)
    finer = [np.repeat(np.repeat(picture, 4, 0), 4, 1) for picture in pictures]
    how = {"exposures": False, "seam_leveling": False, "smoothness": 0.0, "outliers": False}
    plain = texture(mesh, finer, large, poses, local_leveling=False, **how)
    result = texture(mesh, finer, large, poses, **how)
    for row in range(3):
        outer = np.where(np.asarray(mesh.triangles)[row] == 0, 0.2, 0.4)
        assert np.array_equal(sampled(result.mesh, row, outer), sampled(plain.mesh, row, outer))

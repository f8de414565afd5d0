"""Faces of a cube show what a picture of all directions shows there, without a seam."""

import numpy as np

from pointloom.cameras.panoramas import Panorama

WIDTH, HEIGHT = 256, 128


def colors(rays: np.ndarray) -> np.ndarray:
    unit = rays / np.linalg.norm(rays, axis=-1, keepdims=True)
    return 127.5 + 90 * np.sin(3 * unit + [0.3, 1.1, 2.0])


def sphere() -> np.ndarray:
    row, column = np.mgrid[:HEIGHT, :WIDTH]
    across, down = ((column + 0.5) / WIDTH - 0.5) * 2 * np.pi, ((row + 0.5) / HEIGHT - 0.5) * np.pi
    rays = np.stack([np.sin(across) * np.cos(down), np.sin(down), np.cos(across) * np.cos(down)], axis=-1)
    return np.rint(colors(rays)).astype(np.uint8)


def test_each_face_shows_its_directions(device):
    panorama = Panorama(WIDTH, HEIGHT, device=device)
    faces = panorama.apply(sphere())
    assert faces.shape == (6, 81, 81, 3) and panorama.intrinsic.fx == 40.5  # 90 degrees
    v, u = np.mgrid[:81, :81]
    rays = np.stack([(u - 40) / 40.5, (v - 40) / 40.5, np.ones(u.shape)], axis=-1)
    for face, rotation in zip(faces, panorama.turns, strict=True):
        expected = colors(rays @ rotation.T)
        assert np.abs(face - expected).max() < 2.5


def test_faces_are_named_by_where_they_look():
    panorama = Panorama(WIDTH, HEIGHT)
    forward = dict(zip(panorama.names, panorama.turns[:, :, 2].tolist(), strict=True))
    assert forward["right"] == [1, 0, 0] and forward["up"] == [0, -1, 0] and forward["back"] == [0, 0, -1]
    assert np.allclose(np.linalg.det(panorama.turns), 1)
    gray = panorama.apply(sphere()[..., 0])
    assert np.array_equal(gray, panorama.apply(sphere())[..., 0])

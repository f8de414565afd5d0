"""The textured room: a texture fixed to the surface, unchanged geometry, and sensor noise."""

import numpy as np
import pytest

from pointloom.datasets.scenes.room import room_loop_sequence, room_sequence

SMALL = {"width": 160, "height": 120}


def local_contrast(picture):
    """Fraction of 8 x 8 px blocks in which brightness varies by more than 3 %."""
    gray = picture.astype(float).mean(axis=2)
    blocks = gray.reshape(gray.shape[0] // 8, 8, -1, 8).swapaxes(1, 2).reshape(-1, 64)
    return (blocks.std(axis=1) > 0.03 * 255).mean()


def test_texture_changes_colors_and_no_depth(device):
    plain, textured = (room_sequence(40, **SMALL, noise=False, texture=t, device=device).read(0) for t in (False, True))
    assert np.array_equal(plain.depth, textured.depth) and (plain.color != textured.color).mean() > 0.9
    assert abs(textured.color.astype(float).mean() / plain.color.astype(float).mean() - 1) < 0.05
    assert local_contrast(textured.color) > 0.95 > 0.5 > local_contrast(plain.color)


def test_texture_is_fixed_to_the_surface_not_the_view(device):
    sequence = room_sequence(400, width=320, height=240, noise=False, texture=True, color_noise=0, device=device)
    first, second = sequence.read(0), sequence.read(1)
    v, u = np.mgrid[:240, :320].reshape(2, -1)
    camera, z = first.intrinsic, first.depth.reshape(-1).astype(float)
    points = np.stack([(u - camera.cx) / camera.fx * z, (v - camera.cy) / camera.fy * z, z, np.ones(z.shape)])
    x, y, away, _ = np.linalg.inv(second.T_world_camera) @ first.T_world_camera @ points
    parts = (camera.fx, x, camera.cx), (camera.fy, y, camera.cy)
    column, row = (np.rint(f * a / away + c).astype(int) for f, a, c in parts)
    visible = (column >= 0) & (column < 320) & (row >= 0) & (row < 240)
    visible[visible] = np.abs(second.depth[row[visible], column[visible]] - away[visible]) < 0.01
    one = first.color[v[visible], u[visible]].astype(float)
    other = second.color[row[visible], column[visible]].astype(float)
    assert visible.mean() > 0.5
    assert np.corrcoef(one.mean(axis=1), other.mean(axis=1))[0, 1] > 0.98  # up to half a pixel


def test_frames_differ_by_noise_of_the_requested_deviation(device):
    clean, noisy, other = (
        room_sequence(40, **SMALL, texture=True, color_noise=sigma, seed=seed, device=device)
        .read(3)
        .color.astype(float)
        for sigma, seed in ((0, 0), (4, 0), (4, 1))
    )
    inside = (clean > 20) & (clean < 235)
    for made in (noisy, other):
        assert abs((made - clean)[inside].std() - 4) < 0.1
    assert abs((noisy - other)[inside].std() - 4 * 2**0.5) < 0.15


def test_noise_of_colors_is_two_with_texture_and_none_without():
    textured, clean = (room_sequence(40, **SMALL, texture=True, color_noise=n).read(3).color for n in (None, 0))
    assert 1.5 < (textured.astype(float) - clean).std() < 2.1
    plain, clean = (room_sequence(40, **SMALL, color_noise=n).read(3).color for n in (None, 0))
    assert np.array_equal(plain, clean)


def test_a_loop_has_texture_too_and_blur_takes_it_away(device):
    same = SMALL | {"texture": True, "color_noise": 0, "device": device}
    sharp, blurred = (room_loop_sequence(300, **same, blur=blur).read(10).color for blur in (0.0, 4.0))
    detail = [np.abs(np.diff(color.astype(float), axis=1)).mean() for color in (sharp, blurred)]
    assert detail[1] < 0.6 * detail[0]


def test_a_covered_lens_still_has_the_sensors_noise_whose_range_is_checked():
    frame = room_loop_sequence(9, **SMALL, texture=True, covered=(2, 4)).read(2)
    assert 0 < frame.color.max() < 20
    for make in (room_sequence, room_loop_sequence):
        for value in (-1, 256, np.nan):
            with pytest.raises(ValueError, match="color_noise"):
                make(9, **SMALL, color_noise=value)

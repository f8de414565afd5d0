"""TSDFVolume: large coordinates, reproducibility, and rejected input."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom.kernels.lang import uint16

from .tsdf_scenes import SMALL, TRUNCATION, VOXEL, fingerprint, voxels_of

DEPTH, E = np.full((24, 32), 1.0), np.eye(4)
MIRROR, SCALED = np.diag([-1.0, 1, 1, 1]), np.diag([2.0, 2, 2, 1])
OTHER = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
COLOR = np.zeros((24, 32, 3), np.uint8)
FAR = np.eye(4)
FAR[0, 3] = 1e9


WRONG = {
    ValueError: {
        "depth": [DEPTH[0], DEPTH[None], np.full((24, 32), 70_000)], "intrinsic": [OTHER],
        "extrinsic": [MIRROR, SCALED, FAR], "color": [COLOR[:12]], "depth_max": [0, np.nan], "depth_scale": [0],
    },
    TypeError: {
        "depth": [DEPTH.astype(complex)], "intrinsic": ["prime sense"], "extrinsic": ["pose"], "color": [COLOR / 255]
    },
}  # fmt: skip
ROWS = [(error, name, value) for error, named in WRONG.items() for name, values in named.items() for value in values]


@pytest.mark.parametrize(("error", "name", "value"), ROWS)
def test_a_rejected_frame_leaves_the_volume_unchanged(device, error, name, value):
    given = {"depth": DEPTH, "intrinsic": SMALL, "extrinsic": E, "color": COLOR} | {name: value}
    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    for filled in (False, True):
        before = fingerprint(volume) if filled else b""
        state = (volume.frame_count, volume.block_count, volume.origin.tolist(), volume.memory_bytes)
        if value is not FAR or filled:  # the first camera sets the origin at any position
            with pytest.raises(error, match=rf"(^|\b){name}\b.*:"):
                volume.integrate(**given)
            assert state == (volume.frame_count, volume.block_count, volume.origin.tolist(), volume.memory_bytes)
            assert not filled or fingerprint(volume) == before
        if not filled:
            volume.integrate(DEPTH, SMALL, E, color=COLOR)


def test_color_for_a_volume_without_color_is_rejected(device):
    volume = loom.TSDFVolume(voxel_size=VOXEL, color=False, device=device)
    with pytest.raises(ValueError, match="color:"):
        volume.integrate(DEPTH, SMALL, E, color=COLOR)
    assert volume.frame_count == 0


@pytest.mark.parametrize(
    ("name", "value"),
    [*(("voxel_size", value) for value in (0, 1e300, 5e-324)), ("truncation", 1e300), ("truncation", 0.019)],
)
def test_invalid_volume_sizes_are_rejected(name, value):
    with pytest.raises(ValueError, match=f"^{name}: "):
        loom.TSDFVolume(**{"voxel_size": 0.02} | {name: value})


@pytest.mark.filterwarnings("ignore:depth_scale, depth_max")  # true of 1e30 m
@settings(deadline=None, derandomize=True, max_examples=15)
@given(
    st.lists(
        st.sampled_from([0.0, -1.0, np.nan, np.inf, 1e-30, 0.3, 0.31, 1.0, 2.999, 3.0, 1e30]), min_size=4, max_size=4
    ),
    st.floats(0.01, 0.2),
)
def test_any_depth_gives_finite_voxels_within_one(values, voxel_size):
    volume = loom.TSDFVolume(voxel_size=voxel_size, color=False)
    depth = np.resize(np.array(values, np.float32), (24, 32))
    volume.integrate(depth, SMALL, E)
    _, distances, weights, _ = voxels_of(volume)
    assert (np.abs(distances) <= 1).all() and weights.max(initial=0) <= 1
    assert np.isfinite(volume.extract_triangle_mesh(0).vertices).all()
    assert uint16 == volume._blocks.weights.dtype


def test_a_rejected_far_first_frame_sets_no_origin(device):
    """Its camera would have become the origin; the next frame is near zero."""
    volume, far = loom.TSDFVolume(voxel_size=1e-7, device=device), np.eye(4)
    far[0, 3] = -1e6
    with pytest.raises(ValueError, match="extrinsic:"):
        volume.integrate(DEPTH, SMALL, far)
    assert volume.origin.tolist() == [0, 0, 0] and (volume.frame_count, volume.block_count) == (0, 0)
    volume.integrate(np.zeros((24, 32)), SMALL, far)
    assert volume.origin.tolist() != [0, 0, 0] and volume.frame_count == 1


def test_an_outlier_pixel_uses_few_blocks_or_is_rejected():
    camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)

    def volume_of(pixel):
        depth = np.full((48, 64), 1.0, np.float32)
        depth[20, 40] = pixel
        volume = loom.TSDFVolume(voxel_size=0.01, color=False)
        volume.integrate(depth, camera, np.eye(4), depth_max=np.inf)
        return volume

    plain = volume_of(1.0)
    for pixel in (1000.0, 80_000.0):
        wild = volume_of(pixel)
        assert wild.block_count <= plain.block_count + 20 and wild.memory_bytes <= 2 * plain.memory_bytes
    for pixel in (1e6, 1e30):
        with pytest.raises(ValueError, match=r"depth, extrinsic:.*0\.01"):
            volume_of(pixel)

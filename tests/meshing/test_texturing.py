"""texture_mesh: frames in memory color a mesh; errors name invalid frames, poses or meshes."""

import dataclasses
from typing import Any

import numpy as np
import pytest

import pointloom as loom
from pointloom.meshing.color_map.results import NothingSeenError

from ..hostile import faults_of

CAMERA = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
POSE = np.eye(4)


def wall(**options: Any) -> loom.TriangleMesh:
    """A wall 1 m in front of the camera, slightly larger than its field of view."""
    x, y = np.meshgrid(np.linspace(-0.42, 0.42, 13), np.linspace(-0.3, 0.3, 11))
    indices = np.arange(143).reshape(11, 13)
    a, b, c, d = indices[:-1, :-1].ravel(), indices[:-1, 1:].ravel(), indices[1:, 1:].ravel(), indices[1:, :-1].ravel()
    vertices = np.stack([x.ravel(), y.ravel(), np.ones(143)], 1)
    return loom.TriangleMesh(vertices, np.concatenate([np.stack([a, c, b], 1), np.stack([a, d, c], 1)]), **options)


def frames(count: int = 2, color: Any = (0, 255, 0)) -> Any:
    picture = np.full((48, 64, 3), color, np.uint8)
    return loom.frames_from([(picture, np.full((48, 64), 1000, np.uint16))] * count, CAMERA)


def test_frames_in_memory_color_a_mesh(device):
    stages = []
    options = {"method": "none", "progress": lambda *stage: stages.append(stage)}
    result = loom.color_map.texture_mesh(wall(device=device), frames(), [POSE] * 2, **options)
    assert (result.mesh.vertex_colors == (0, 1, 0)).all() and result.reliable
    assert result.frame_count == 2 and result.blind_frames == 0 and 0.3 < result.seen_share < 0.9
    assert result.texel_share is None and (result.turned, result.moved) == (0.0, 0.0)
    assert stages == [("frames", 0, 2), ("frames", 1, 2), ("frames", 2, 2), ("colors", 0, 0)]


def test_a_texture_replaces_vertex_colors():
    mesh = wall()
    mesh.triangle_uvs = (mesh.vertices[mesh.triangles][..., :2] + 0.42).reshape(-1, 2) / 0.84
    result = loom.color_map.texture_mesh(mesh, frames(), loom.Trajectory([POSE] * 2), size=32)
    assert result.mesh.vertex_colors is None and result.mesh.textures[0].shape == (32, 32, 3)
    assert result.size == 32 and 0.3 < result.texel_share < 0.9
    assert "32 x 32, " in str(result).splitlines()[-1]
    assert (result.colors.mesh.vertex_colors == (0, 1, 0)).all()


def test_images_without_improved_agreement_are_unreliable():
    good = loom.color_map.texture_mesh(wall(), frames(10), [POSE] * 10, method="none")

    def warnings(method: str, before: float, after: float, blind: int = 0) -> tuple[str, ...]:
        views = np.where(np.arange(10) < blind, 0, 9)
        colors = dataclasses.replace(good.colors, residual_before=before, residual=after, view_counts=views)
        return dataclasses.replace(good, method=method, colors=colors).warnings

    assert "do not agree better" in str(warnings("rigid", 0.05, 0.0499))
    assert "Compare with method='none'" in str(warnings("rigid", 0.05, 0.0499))
    assert not warnings("none", 0.05, 0.0499)
    assert not warnings("rigid", 0.05, 0.03)
    assert not warnings("rigid", 0.005, 0.005)
    assert "6 of 10 frames" in str(warnings("rigid", 0.05, 0.0, blind=6))


def test_invalid_frames_are_rejected_by_name():
    def texture(given: Any, poses: Any = (POSE,), mesh: Any = None) -> None:
        loom.color_map.texture_mesh(wall() if mesh is None else mesh, given, poses)

    gray = loom.frames_from([(None, np.full((48, 64), 1000, np.uint16))], CAMERA)
    for given, poses, message in (
        (gray, [POSE], "frames: frame-000000 has no color"),
        (frames(1), None, "frames: frame-000000 has no pose. Pass poses"),
        (frames(0), [], "frames: expected at least one frame"),
        (frames(2), [POSE], "poses: expected one per frame, got 1 for more frames"),
        (frames(1), [POSE] * 2, "poses: expected 1, one per frame, got 2"),
        (frames(1), [2 * POSE], r"poses\[0\]"),
    ):
        with pytest.raises(ValueError, match=message):
            texture(given, poses)
    with pytest.raises(ValueError, match="mesh:"):
        texture(frames(1), mesh=loom.TriangleMesh())
    with pytest.raises(ValueError, match="mesh:"):
        loom.color_map.texture_mesh(loom.TriangleMesh(), frames(1), [POSE], size=8)
    with pytest.raises(NothingSeenError):
        texture(frames(1), mesh=wall().translate([0, 0, 100]))


ARGUMENTS = {"method": "none", "size": 8, "depth_max": 4.0, "progress": None}


@pytest.mark.parametrize("argument", ["mesh", "frames", "poses", *ARGUMENTS])
def test_a_hostile_value_is_rejected_by_name(argument):
    mesh = wall()
    mesh.triangle_uvs = (mesh.vertices[mesh.triangles][..., :2] + 0.42).reshape(-1, 2) / 0.84
    good = {"mesh": mesh, "frames": frames(1), "poses": [POSE], **ARGUMENTS}
    faults = faults_of(loom.color_map.texture_mesh, good, argument)
    assert not faults, "\n".join(faults)

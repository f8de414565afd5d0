"""Fusing depth frames at 1 cm and extracting the mesh, beside Open3D's VoxelBlockGrid.

Open3D's legacy volume is not here: in 0.20.0 it stays empty. Both volumes hold distance and weight alone, cut at 4 cm,
in blocks of 8^3. VoxelBlockGrid gets its block count beforehand; ours grows inside the timed region. Times of the
integration are per frame and include choosing the frame's blocks. Both take the depth as uint16: on the GPU Open3D's
images are uploaded beforehand, ours goes up inside the timed region.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
import scenes
from contest import OURS, Contestant, Operation, Trial, load_open3d, open3d_device, timed, waiting

VOXEL_SIZE = 0.01  # [m]
TRUNCATION_VOXELS = 4.0
DEPTH_MAX = 5.0  # [m]
BLOCK_COUNT = 60_000  # VoxelBlockGrid's room; the frames touch a seventh of it


def integration_pointloom(frames: scenes.Frames, device: str) -> Trial:
    import pointloom as loom

    height, width = frames.depths.shape[1:]
    camera = loom.PinholeCameraIntrinsic(width, height, *frames.intrinsic)

    def make() -> Any:
        return loom.TSDFVolume(
            voxel_size=VOXEL_SIZE, truncation=TRUNCATION_VOXELS * VOXEL_SIZE, color=False, device=device
        )

    def integrate(volume: Any) -> Any:
        for depth, extrinsic in zip(frames.depths, frames.extrinsics, strict=True):
            volume.integrate(depth, camera, extrinsic, depth_scale=1000.0, depth_max=DEPTH_MAX)
        return volume

    return Trial(waiting(integrate, device, "warp"), setup=make)


def integration_open3d(frames: scenes.Frames, device: str) -> Trial:
    o3d = load_open3d()
    where = open3d_device(device)
    intrinsic = o3d.core.Tensor(frames.matrix)
    extrinsics = [o3d.core.Tensor(extrinsic) for extrinsic in frames.extrinsics]
    images = [o3d.t.geometry.Image(o3d.core.Tensor(depth)).to(where) for depth in frames.depths]

    def make() -> Any:
        types = (o3d.core.float32, o3d.core.float32)
        return o3d.t.geometry.VoxelBlockGrid(
            ("tsdf", "weight"), types, ((1), (1)), VOXEL_SIZE, 8, BLOCK_COUNT, where
        )  # fmt: skip

    def integrate(grid: Any) -> Any:
        limits = (1000.0, DEPTH_MAX, TRUNCATION_VOXELS)
        for image, extrinsic in zip(images, extrinsics, strict=True):
            blocks = grid.compute_unique_block_coordinates(image, intrinsic, extrinsic, *limits)
            grid.integrate(blocks, image, intrinsic, extrinsic, *limits)
        return grid

    return Trial(waiting(integrate, device, "open3d"), setup=make)


def extraction_pointloom(frames: scenes.Frames, device: str) -> Any:
    volume = integration_pointloom(frames, device).once()
    return waiting(lambda: volume.extract_triangle_mesh(weight_threshold=0), device, "warp")


def extraction_open3d(frames: scenes.Frames, device: str) -> Any:
    grid = integration_open3d(frames, device).once()
    return waiting(lambda: grid.extract_triangle_mesh(0.0), device, "open3d")


def mesh_facts(mesh: Any) -> tuple[np.ndarray, int]:
    if hasattr(mesh, "vertices"):
        return np.asarray(mesh.vertices), len(mesh.triangles)
    return mesh.vertex.positions.cpu().numpy(), mesh.triangle.indices.shape[0]


def check(ours: tuple[np.ndarray, int], theirs: tuple[np.ndarray, int], peer: str) -> None:
    """As many triangles within 5 %, each surface within half a voxel of the other and 99 % of it within two voxels.

    The blocks that a frame touches, and the pixel that a voxel falls on, are found differently: ours walks every ray
    through its blocks, VoxelBlockGrid samples rays of every fourth pixel, and so has some blocks fewer.
    """
    from scipy.spatial import cKDTree

    (left, left_count), (right, right_count) = ours, theirs
    assert abs(left_count - right_count) < 0.05 * right_count, f"{left_count} triangles, {peer} {right_count}"
    for a, b in ((left, right), (right, left)):
        distances, _ = cKDTree(b).query(a[:: max(1, len(a) // 2000)])
        median, most = np.quantile(distances, (0.5, 0.99))
        assert median < VOXEL_SIZE / 2, f"the median distance between the surfaces is {median:.4f} m"
        assert most < 2 * VOXEL_SIZE, f"1 % of the surfaces are more than {most:.4f} m apart"


INTEGRATE = Operation(
    name="tsdf_integrate",
    scenes={"30 frames": partial(scenes.room_frames, 30)},
    quick={"3 frames": partial(scenes.room_frames, 3)},
    contestants=(
        Contestant(
            OURS,
            integration_pointloom,
            lambda volume: mesh_facts(volume.extract_triangle_mesh(weight_threshold=0)),
            ("cpu", "cuda"),
        ),
        Contestant(
            "open3d-tensor",
            integration_open3d,
            lambda grid: mesh_facts(grid.extract_triangle_mesh(0.0)),
            ("cpu", "cuda"),
        ),
    ),
    check=check,
    unit_count=len,
)
MESH = Operation(
    name="tsdf_mesh",
    scenes=INTEGRATE.scenes,
    quick=INTEGRATE.quick,
    contestants=(
        Contestant(OURS, extraction_pointloom, mesh_facts, ("cpu", "cuda")),
        Contestant("open3d-tensor", extraction_open3d, mesh_facts, ("cpu", "cuda")),
    ),
    check=check,
)
OPERATIONS = (INTEGRATE, MESH)


@timed(INTEGRATE)
def test_tsdf_integrate(turn) -> None:
    turn()


@timed(MESH)
def test_tsdf_mesh(turn) -> None:
    turn()

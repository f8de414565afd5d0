"""Fusing depth frames at 1 cm, extracting the mesh and ray casting, beside Open3D's VoxelBlockGrid.

Open3D's legacy volume is not included: in 0.20.0 it stays empty. Both volumes store distance and weight alone,
truncated at 4 cm, in blocks of 8^3. VoxelBlockGrid gets its block count beforehand; pointloom's volume grows in the
timed region. Integration times are per frame and include the selection of the frame's blocks. Both take the depth as
uint16. In `tsdf_integrate` both upload NumPy frames in the timed region, in `tsdf_integrate_device` both have uploaded
them before. In `tsdf_integrate_frames` pointloom gets all NumPy frames in one call. The results of `tsdf_ray_cast` stay
on the device.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
import scenes
from contest import POINTLOOM, Contestant, Operation, Trial, load_open3d, open3d_device, timed, waiting

VOXEL_SIZE = 0.01  # [m]
TRUNCATION_VOXELS = 4.0
NEAREST, DEPTH_MAX = 0.1, 5.0  # [m]
BLOCK_COUNT = 60_000  # capacity of VoxelBlockGrid; the frames touch a seventh of it


def loom_camera(width: int, height: int, frames: scenes.Frames) -> Any:
    import pointloom as loom

    return loom.PinholeCameraIntrinsic(width, height, *frames.intrinsic)


def integration_pointloom(
    frames: scenes.Frames, device: str, *, is_uploaded: bool = False, is_together: bool = False
) -> Trial:
    import pointloom as loom

    height, width = frames.depths.shape[1:]
    camera = loom_camera(width, height, frames)
    depths: Any = frames.depths
    if is_uploaded and device != "cpu":
        import warp as wp

        depths = [wp.array(depth, dtype=wp.uint16, device=device) for depth in frames.depths]
    limits = {"depth_scale": 1000.0, "depth_max": DEPTH_MAX}

    def make() -> Any:
        return loom.TSDFVolume(
            voxel_size=VOXEL_SIZE, truncation=TRUNCATION_VOXELS * VOXEL_SIZE, color=False, device=device
        )

    def integrate(volume: Any) -> Any:
        if is_together:
            volume.integrate_frames(depths, camera, frames.extrinsics, **limits)
            return volume
        for depth, extrinsic in zip(depths, frames.extrinsics, strict=True):
            volume.integrate(depth, camera, extrinsic, **limits)
        return volume

    return Trial(waiting(integrate, device, "warp"), setup=make)


def integration_open3d(frames: scenes.Frames, device: str, *, is_uploaded: bool = False) -> Trial:
    o3d = load_open3d()
    where = open3d_device(device)
    intrinsic = o3d.core.Tensor(frames.matrix)
    extrinsics = [o3d.core.Tensor(extrinsic) for extrinsic in frames.extrinsics]

    def upload(depth: np.ndarray) -> Any:
        return o3d.t.geometry.Image(o3d.core.Tensor(depth)).to(where)

    uploaded = [upload(depth) for depth in frames.depths] if is_uploaded else None

    def make() -> Any:
        types = (o3d.core.float32, o3d.core.float32)
        return o3d.t.geometry.VoxelBlockGrid(
            ("tsdf", "weight"), types, ((1), (1)), VOXEL_SIZE, 8, BLOCK_COUNT, where
        )  # fmt: skip

    def integrate(grid: Any) -> Any:
        limits = (1000.0, DEPTH_MAX, TRUNCATION_VOXELS)
        images = map(upload, frames.depths) if uploaded is None else uploaded
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


def ray_casting_pointloom(frames: scenes.Frames, device: str) -> Any:
    """Depth, points and normals. They stay on the GPU, as those of Open3D."""
    volume = integration_pointloom(frames, device, is_uploaded=True).once()
    height, width = frames.depths.shape[1:]
    camera = loom_camera(width, height, frames)
    extrinsic = frames.extrinsics[len(frames) // 4]
    return waiting(
        lambda: (frames, volume.ray_cast(camera, extrinsic, depth_max=DEPTH_MAX, weight_threshold=0).depth),
        device,
        "warp",
    )


def ray_casting_open3d(frames: scenes.Frames, device: str) -> Any:
    """Depth, points and normals, of the blocks that the frame's depth touches, as in Open3D's examples."""
    o3d = load_open3d()
    grid = integration_open3d(frames, device).once()
    k, (height, width) = len(frames) // 4, frames.depths.shape[1:]
    intrinsic, extrinsic = o3d.core.Tensor(frames.matrix), o3d.core.Tensor(frames.extrinsics[k])
    image = o3d.t.geometry.Image(o3d.core.Tensor(frames.depths[k])).to(open3d_device(device))
    blocks = grid.compute_unique_block_coordinates(image, intrinsic, extrinsic, 1000.0, DEPTH_MAX, TRUNCATION_VOXELS)
    wanted = ["depth", "vertex", "normal"]
    limits = (1000.0, NEAREST, DEPTH_MAX, 0.0, TRUNCATION_VOXELS, 8)

    def cast() -> Any:
        return frames, grid.ray_cast(blocks, intrinsic, extrinsic, width, height, wanted, *limits)["depth"]

    return waiting(cast, device, "open3d")


def depth_facts(result: Any) -> tuple[scenes.Frames, np.ndarray]:
    frames, depth = result
    if hasattr(depth, "cpu"):  # a tensor of Open3D, in millimeters
        return frames, depth.cpu().numpy()[..., 0] / 1000
    return frames, depth if isinstance(depth, np.ndarray) else depth.numpy()


def check_depth(
    actual: tuple[scenes.Frames, np.ndarray], reference: tuple[scenes.Frames, np.ndarray], peer: str
) -> None:
    """Check that nearly every pixel is hit, and that the depth error is not larger than the baseline's."""
    frames, depth = actual
    true = frames.depths[len(frames) // 4] / 1000
    errors = [np.abs(cast - true)[(cast > 0) & (true > 0)] for cast in (depth, reference[1])]
    assert len(errors[0]) > 0.99 * len(errors[1]), f"{len(errors[0])} pixels are hit, {len(errors[1])} for {peer}"
    medians = [float(np.median(error)) for error in errors]
    assert medians[0] <= medians[1], f"the median error is {medians[0]:.4f} m, {medians[1]:.4f} m for {peer}"


def mesh_facts(mesh: Any) -> tuple[np.ndarray, int]:
    if hasattr(mesh, "vertices"):
        return np.asarray(mesh.vertices), len(mesh.triangles)
    return mesh.vertex.positions.cpu().numpy(), mesh.triangle.indices.shape[0]


def check(actual: tuple[np.ndarray, int], reference: tuple[np.ndarray, int], peer: str) -> None:
    """Check for the same number of triangles within 5 %, and surfaces within half a voxel (median) and two voxels (99
    %).

    The blocks of a frame and the pixel of a voxel are computed differently: pointloom traverses every ray,
    VoxelBlockGrid
    samples every fourth pixel, so it has slightly fewer blocks.
    """
    from scipy.spatial import cKDTree

    (left, left_count), (right, right_count) = actual, reference
    assert abs(left_count - right_count) < 0.05 * right_count, f"{left_count} triangles, {peer} {right_count}"
    for a, b in ((left, right), (right, left)):
        distances, _ = cKDTree(b).query(a[:: max(1, len(a) // 2000)])
        median, largest = np.quantile(distances, (0.5, 0.99))
        assert median < VOXEL_SIZE / 2, f"the median distance between the surfaces is {median:.4f} m"
        assert largest < 2 * VOXEL_SIZE, f"1 % of the surfaces are more than {largest:.4f} m apart"


def integration(name: str, **options: bool) -> Operation:
    """An operation that integrates frames; `options` are those of `integration_pointloom`."""
    uploaded = {"is_uploaded": True} if options.get("is_uploaded") else {}
    return Operation(
        name=name,
        scenes={"30 frames": partial(scenes.room_frames, 30)},
        quick={"3 frames": partial(scenes.room_frames, 3)},
        contestants=(
            Contestant(
                POINTLOOM,
                partial(integration_pointloom, **options),
                lambda volume: mesh_facts(volume.extract_triangle_mesh(weight_threshold=0)),
                ("cpu", "cuda"),
            ),
            Contestant(
                "open3d-tensor",
                partial(integration_open3d, **uploaded),
                lambda grid: mesh_facts(grid.extract_triangle_mesh(0.0)),
                ("cpu", "cuda"),
            ),
        ),
        check=check,
        unit_count=len,
    )


INTEGRATE = replace(integration("tsdf_integrate"), targets={"30 frames": 2})
INTEGRATE_DEVICE = integration("tsdf_integrate_device", is_uploaded=True)
INTEGRATE_FRAMES = integration("tsdf_integrate_frames", is_together=True)
MESH = Operation(
    name="tsdf_mesh",
    scenes={"30 frames": INTEGRATE.scenes["30 frames"]},
    quick=INTEGRATE.quick,
    contestants=(
        Contestant(POINTLOOM, extraction_pointloom, mesh_facts, ("cpu", "cuda")),
        Contestant("open3d-tensor", extraction_open3d, mesh_facts, ("cpu", "cuda")),
    ),
    check=check,
    targets={"30 frames": 4},
)
RAY_CAST = Operation(
    name="tsdf_ray_cast",
    scenes={"30 frames": INTEGRATE.scenes["30 frames"]},
    quick=INTEGRATE.quick,
    contestants=(
        Contestant(POINTLOOM, ray_casting_pointloom, depth_facts, ("cpu", "cuda")),
        Contestant("open3d-tensor", ray_casting_open3d, depth_facts, ("cpu", "cuda")),
    ),
    check=check_depth,
    targets={"30 frames": 3},
    reasons={
        "30 frames": (
            "Of the CPU time, 72 % is 7.8 steps a ray, 1.8 of them in cells that may contain a surface, and "
            "25 % normals."
        )
    },
)
OPERATIONS = (INTEGRATE, INTEGRATE_DEVICE, INTEGRATE_FRAMES, MESH, RAY_CAST)


@timed(INTEGRATE)
def test_tsdf_integrate(time_lap) -> None:
    time_lap()


@timed(INTEGRATE_DEVICE)
def test_tsdf_integrate_device(time_lap) -> None:
    time_lap()


@timed(INTEGRATE_FRAMES)
def test_tsdf_integrate_frames(time_lap) -> None:
    time_lap()


@timed(MESH)
def test_tsdf_mesh(time_lap) -> None:
    time_lap()


@timed(RAY_CAST)
def test_tsdf_ray_cast(time_lap) -> None:
    time_lap()

"""More operations timed on a GPU, with many launches: registration, frames, surfaces and meshes."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import scenes
from gpu_operation import DEVICE, FULL_HD, UHD, VGA, Operation, cloud_of, image_size, surface_of
from mesh_scenes import in_pointloom, torn_mesh, wavy_mesh

Call = Callable[[], Any]
VIEWS = 3  # of multi-view stereo
AZIMUTHS, BEAMS = 900, 64  # of a LiDAR
CALLS = 10  # number of prepared frames


def package(*names: str) -> Any:
    """The first public package of pointloom that exists: gpu_kit/compare.py measures code before a change, too."""
    import pointloom as loom

    return next(getattr(loom, name) for name in names if hasattr(loom, name))


# ------------------------------------------------------------------------------------------------ registration


def _gicp(size: int) -> Call:
    import pointloom as loom

    reg, shift = loom.registration, [0.01, 0.01, 0.0]
    source, target = loom.PointCloud(surface_of(size, 1) + shift, device=DEVICE), cloud_of(size)
    method = reg.TransformationEstimationForGeneralizedICP()
    return lambda: reg.registration_icp(source, target, 0.1, None, method)


def _globally(size: int) -> Call:
    import pointloom as loom

    T, (c, s), clouds = np.eye(4), (np.cos(1.3), np.sin(1.3)), []
    T[:2, :2], T[:3, 3] = [[c, -s], [s, c]], [0.5, -0.2, 0.1]
    for seed, low in ((50, -2.0), (51, -1.0)):  # with two thirds overlap
        points = surface_of(size, seed)
        clouds.append(loom.PointCloud(points[(points[:, 0] > low) & (points[:, 0] < low + 3)], device=DEVICE))
    source = clouds[0].transform(T)
    return lambda: loom.registration.register_globally(source, clouds[1], voxel_size=0.05)


def _lidar(size: int) -> Call:
    from street import drive

    import pointloom as loom

    road = drive(3 + CALLS, beams=BEAMS, azimuths=size // BEAMS)
    clouds = [loom.PointCloud(p, time=t, device=DEVICE) for p, t in zip(road.scans, road.times, strict=True)]
    odometry, rest = loom.registration.LidarOdometry(voxel_size=1.0), iter(clouds)
    for _ in range(3):  # so that the map and the velocity exist
        odometry.register(next(rest))
    return lambda: odometry.register(next(rest))


# ------------------------------------------------------------------------------------------------ frames


def _rgbd_frame(pixels: int) -> Call:
    """A tracked frame: prepared, and aligned with the previous one."""
    import pointloom as loom

    rgbd = package("rgbd", "odometry")
    width, height = image_size(pixels)
    frames = scenes.room_frames(2, width, height)
    camera = loom.PinholeCameraIntrinsic(width, height, *frames.intrinsic)
    v, u = np.mgrid[:height, :width] * (640 / width)
    shade = (127 + 60 * np.sin(u / 7 + v / 19) + 50 * np.cos(v / 9 - u / 31)).astype(np.uint8)
    first = rgbd.OdometryFrame(frames.depths[0], camera, shade, device=DEVICE)

    def call() -> Any:
        return rgbd.align_frames(rgbd.OdometryFrame(frames.depths[1], camera, shade, device=DEVICE), first)

    return call


def _slam_frame(pixels: int) -> Call:
    from room_loops import room_loop_sequence

    width, height = image_size(pixels)
    room = room_loop_sequence(300, width=width, height=height, device=DEVICE)
    system = package("rgbd", "slam").DenseSLAM(room.intrinsic, voxel_size=6.4 / width, device=DEVICE)  # 1 cm at VGA
    read = [room.read(k) for k in range(2 + CALLS)]
    frames = iter([SimpleNamespace(depth=f.depth, color=f.color, timestamp=f.timestamp) for f in read])

    def call() -> Any:
        return system.step(next(frames))

    for _ in range(2):
        call()
    return call


def _mvs(pixels: int) -> Call:
    import mvs_scenes

    room, mvs = mvs_scenes.room(VIEWS, image_size(pixels // VIEWS)[0]), package("photogrammetry", "mvs")
    return lambda: list(mvs.estimate_depth_maps(room.images, room.cameras, device=DEVICE))


def _fuse(_: int) -> Call:
    from digest_mvs import noisy_depth_maps

    import pointloom as loom

    maps = noisy_depth_maps(None)
    colors = list(np.random.default_rng(8).integers(0, 256, (4, 72, 96, 3)).astype(np.uint8))
    return lambda: loom.photogrammetry.fuse_depth_maps(maps, colors, to="points", device=DEVICE)


# ------------------------------------------------------------------------------------------------ surfaces, meshes


def _oriented(size: int) -> Any:
    return cloud_of(size).estimate_normals(max_nn=20).orient_normals_to_align_with_direction()


def of_surface(name: str, *given: Any, **options: Any) -> Callable[[int], Call]:
    """A mesh from oriented points."""

    def prepare(size: int) -> Call:
        import pointloom as loom

        cloud = _oriented(size)
        make = getattr(loom.TriangleMesh, f"create_from_point_cloud_{name}")
        return lambda: make(cloud, *given, **options)

    return prepare


def of_mesh(arrays: Callable[[int], Any], call: Callable[[Any], Any]) -> Callable[[int], Call]:
    """An operation on a mesh; its size is that of the source grid."""

    def prepare(cells: int) -> Call:
        mesh = in_pointloom(arrays(cells), DEVICE)
        return lambda: call(mesh)

    return prepare


def _deformed(mesh: Any) -> Any:
    """Deform with the lowest vertices fixed and the highest ones moved."""
    heights = np.asarray(mesh.vertices)[:, 2]
    rows = np.argsort(heights)[[*range(40), *range(-40, 0)]]
    positions = np.asarray(mesh.vertices)[rows].copy()
    positions[40:, 2] += 0.1 * np.ptp(heights)
    return mesh.deform_as_rigid_as_possible(rows, positions, 5)


def _patches(size: int) -> Call:
    cloud = _oriented(size)
    cloud.search_tree()
    return lambda: cloud.detect_planar_patches(max_nn=20)


def _kitti(_: int) -> Call:
    import pointloom as loom

    cloud = loom.PointCloud(scenes.real_scan(zeros=False), device=DEVICE)
    cloud.search_tree()
    return lambda: cloud.estimate_normals(max_nn=30)


MORE_ROWS = (
    Operation("normals_scan", _kitti, (69_088,)),  # a real LiDAR scan from POINTLOOM_DATA
    Operation("gicp", _gicp, (200_000,)),
    Operation("register_globally", _globally, (200_000,)),
    Operation("lidar_odometry_scan", _lidar, (BEAMS * AZIMUTHS,), small=BEAMS * 225),
    Operation("rgbd_frame", _rgbd_frame, (VGA, FULL_HD, UHD), small=160 * 120),
    Operation("slam_frame", _slam_frame, (VGA,), small=160 * 120),
    Operation("mvs_pictures", _mvs, (VIEWS * 160 * 120, VIEWS * VGA), small=VIEWS * 64 * 48),
    Operation("mvs_fuse", _fuse, (4 * 72 * 96,), small=4 * 72 * 96),
    Operation("poisson_depth_7", of_surface("poisson", depth=7), (60_000,)),
    Operation("poisson_depth_9", of_surface("poisson", depth=9), (1_000_000,)),
    Operation("ball_pivoting", of_surface("ball_pivoting"), (60_000, 300_000)),
    Operation("alpha_shape", of_surface("alpha_shape", 0.1), (20_000,)),
    Operation("planar_patches", _patches, (60_000, 500_000)),
    Operation(
        "decimation",
        of_mesh(wavy_mesh, lambda mesh: mesh.simplify_quadric_decimation(len(mesh.triangles) // 10)),
        (128, 512),
        small=16,
    ),
    Operation("repair", of_mesh(torn_mesh, lambda mesh: mesh.repair()), (64, 256), small=8),
    Operation("deform_arap", of_mesh(wavy_mesh, _deformed), (48, 128), small=16),
)

"""Pipeline stages from an SfM model to a surface: undistortion, depth, fused points, mesh."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ...cameras.image_names import number_of
from ...cameras.pose_files import trajectory_of
from ...cameras.trajectory import Trajectory, write_trajectory
from ...cameras.undistortion import Undistortion
from ...core.devices import DeviceLike
from ...core.progress import ReportProgress
from ...core.stages import StageResult
from ...io.images.image_files import read_color, write_png
from ...io.models.colmap import read_colmap_model, write_colmap_model
from ...io.models.sfm_model import SfmModel
from ...io.points.point_cloud import write_point_cloud
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.mesh.mesh_files import write_triangle_mesh
from ...meshing.mesh.mesh_summary import describe_mesh
from ...pcd.cloud import PointCloud
from ..mvs.depth_maps import DepthMap, DepthMaps
from ..mvs.estimation import estimate_depth_maps
from ..mvs.filtering import filter_depth_maps
from ..mvs.fusion import fuse_depth_maps
from ..mvs.posed_images import PosedCamera
from ..sfm.masks import MASK_THRESHOLD, mask_file, masks_in, write_mask
from ..sfm.straightened import straightened_model
from . import motion
from .units import VideoUnits, fit_units

IMAGES, SPARSE = "images", "sparse"  # COLMAP's names in a folder of undistorted images
MAPS, MASKS = "maps", "masks"
CLOUD, MESH = "cloud.ply", "mesh.ply"
POSES_LOG, POSES_TUM = "poses.log", "poses.txt"

MIN_RELATIVE_AREA = 0.005  # smaller parts are removed, relative to the largest area


def straighten(
    folder: Path, report: ReportProgress, *, frames: StageResult, model: StageResult, max_size: int, device: DeviceLike
) -> dict[str, Any]:
    sparse, images = motion.read_model(model), folder / IMAGES
    images.mkdir()
    names = [f"{Path(name).stem}.png" for name in sparse.names]
    lenses = {
        camera: Undistortion(camera, max_size=max_size, device=device) for camera in dict.fromkeys(sparse.cameras)
    }
    for k, (name, camera) in enumerate(zip(sparse.names, sparse.cameras, strict=True)):
        report("images", k, len(names))
        color = read_color(frames.folder / motion.IMAGES / name)
        write_png(images / names[k], lenses[camera].apply(color))
        mask = mask_file(frames.folder / motion.MASKS, name)
        if mask.is_file():
            (folder / MASKS).mkdir(exist_ok=True)
            straightened = lenses[camera].apply(read_color(mask)[..., 0])
            write_mask(folder / MASKS, names[k], straightened >= MASK_THRESHOLD)
    report("images", len(names), len(names))
    straight = [lenses[camera].intrinsic for camera in sparse.cameras]
    write_colmap_model(folder / SPARSE, straightened_model(sparse, names, straight))
    sizes = dict.fromkeys((camera.width, camera.height) for camera in straight)
    return {"images": len(names), "sizes": [list(size) for size in sizes]}


def estimate(
    folder: Path, report: ReportProgress, checkpoints: Path, *, undistorted: StageResult, seed: int, device: DeviceLike
) -> dict[str, Any]:
    model, images, cameras = open_straightened(undistorted)
    masks = masks_in(undistorted.folder / MASKS, [path.name for path in images])
    where = {"device": device, "folder": folder / MAPS, "masks": masks, "resume_from": checkpoints, "progress": report}
    maps = estimate_depth_maps(images, cameras, model, seed=seed, **where)
    return {"images": len(maps), "fraction": mean_fraction(maps, masks)}


def fuse_points(
    folder: Path, report: ReportProgress, *, undistorted: StageResult, depth: StageResult, device: DeviceLike
) -> dict[str, Any]:
    _, images, _ = open_straightened(undistorted)
    where = {"device": device, "progress": report}
    maps = filter_depth_maps(DepthMaps.open(depth.folder / MAPS), folder=folder / MAPS, **where)
    cloud = fuse_depth_maps(maps, images, to="points", **where)
    assert isinstance(cloud, PointCloud)
    write_point_cloud(folder / CLOUD, cloud)
    masks = masks_in(undistorted.folder / MASKS, [path.name for path in images])
    return {"fraction": mean_fraction(maps, masks), "points": len(cloud)}


def make_mesh(
    folder: Path,
    report: ReportProgress,
    *,
    model: StageResult,
    undistorted: StageResult,
    fused: StageResult,
    units: VideoUnits,
    device: DeviceLike,
) -> dict[str, Any]:
    straight, images, _ = open_straightened(undistorted)
    where = {"device": device, "progress": report}
    full = fuse_depth_maps(DepthMaps.open(fused.folder / MAPS), images, to="tsdf", **where)
    assert isinstance(full, TriangleMesh)
    cleaned, fit = without_floaters(full), fit_units(units, motion.read_model(model))
    mesh = cleaned.transform(fit.T_world_model)
    transformed = straight.transform(fit.T_world_model)
    write_triangle_mesh(folder / MESH, mesh)
    write_colmap_model(folder / SPARSE, transformed)
    for name, form in ((POSES_LOG, "log"), (POSES_TUM, "tum")):
        write_trajectory(folder / name, poses_of(transformed), format=form)
    return {**describe_mesh(mesh).to_dict(), "floaters": len(full) - len(mesh)}


def poses_of(model: SfmModel) -> Trajectory:
    numbers = [number_of(name) for name in model.names]
    frame_numbers = [number for number in numbers if number is not None]
    if len(set(frame_numbers)) < len(model):
        frame_numbers = list(range(len(model)))
    order = np.argsort(frame_numbers, kind="stable")
    return trajectory_of(model.T_world_camera[order], [frame_numbers[k] for k in order], [None] * len(frame_numbers))


def open_straightened(undistorted: StageResult) -> tuple[SfmModel, list[Path], list[PosedCamera]]:
    model = read_colmap_model(undistorted.folder / SPARSE)
    cameras = [
        PosedCamera(camera.intrinsic, pose) for camera, pose in zip(model.cameras, model.T_camera_world, strict=True)
    ]
    return model, [undistorted.folder / IMAGES / name for name in model.names], cameras


def without_floaters(mesh: TriangleMesh) -> TriangleMesh:
    if not len(mesh):
        return mesh
    _, _, areas = mesh.cluster_connected_triangles()
    return mesh.remove_small_components(min_area=MIN_RELATIVE_AREA * float(areas.max()))


def mean_fraction(maps: Iterable[DepthMap], masks: Sequence[Path | None]) -> float:
    fractions = []
    for each, mask in zip(maps, masks, strict=True):
        left = 1.0 if mask is None else float((read_color(mask)[..., 0] >= MASK_THRESHOLD).mean())
        fractions.append(each.fraction / left if left else 0.0)
    return float(np.mean(fractions)) if fractions else 0.0

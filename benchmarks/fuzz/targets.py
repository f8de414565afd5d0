"""The list of all functions that read files, with the fuzz cases that cover each of them.

`PUBLIC` has the public functions of pointloom and `pointloom.open3d` that take a path or bytes, `MODULES` the modules
that open files. tests/io/test_fuzzed_files.py compares both with the code. A value is the names of cases, or `LeftOut`
with the reason. Functions that only write are recognized by their names (`WRITERS`).
"""

from __future__ import annotations

import ast
import inspect
import re
from collections.abc import Iterator
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any


class LeftOut(str):
    """Why a function has no case."""


PARAMETERS = re.compile(r"path|file|folder|bytes|database|scans")
TYPES = re.compile(r"PathLike|FilePath|\bPath\b|\bbytes\b")
WRITERS = re.compile(r"\.(write_\w+|write|save\w*|to_json|capture_\w+|export_\w+|record\w*|screenshot|add_\w+)$")
OPENERS = {"input_path", "open_source", "read_json_object", "read_text", "read_bytes", "connect", "ZipFile", "load"}
HOLDERS = {"np", "sqlite3", "zipfile"}  # of `load`, `connect` and `ZipFile`

CLOUDS = ("cloud .ply", "cloud .pcd", "cloud .npz", "cloud .xyz", "cloud .xyzn", "cloud .xyzrgb", "cloud .pts",
          "cloud .csv", "cloud .txt", "cloud .asc", "cloud .bin", "cloud .las", "cloud .laz", "cloud .copc.laz",
          "cloud .e57", "cloud .ptx")  # fmt: skip
MESHES = ("mesh .ply", "mesh .obj", "mesh .stl", "mesh .off", "mesh .glb", "mesh .gltf")
POSES = ("trajectory .log", "trajectory .tum", "trajectory .kitti", "trajectory .json")
MODELS = ("COLMAP cameras.txt", "COLMAP images.txt", "COLMAP points3D.txt", "COLMAP cameras.bin", "COLMAP images.bin",
          "COLMAP points3D.bin")  # fmt: skip
DATASETS = ("data set, camera", "data set, pose", "data set, depth", "data set, color", "TUM, list", "TUM, poses",
            "recorded frames, times")  # fmt: skip
IMAGES = ("color .png", "color .jpg")
DEPTHS = ("depth .png", "depth .npy")
TILES = ("plan of a manifest", "manifest")
JOBS = ("job of registration, plan", "job of registration, task", "job of fusion, plan", "job of fusion, task")
PAGED = ("paged volume, state", "paged volume, page")
MAPS = ("depth maps, index", "depth maps, map")
RECORDINGS = ("recording .bag", "recording .mcap", "recording .db3")

OF_SDK = LeftOut("recordings of a camera are read by its driver")
BY_ONNX = LeftOut("networks are read by ONNX Runtime (SECURITY.md)")
OF_MEMORY = LeftOut("takes objects in memory; the path is of an output")
BY_COLMAP = LeftOut("COLMAP's database, which the same process has written")
OF_JOB = LeftOut("continues a job from records with digests of files; a damaged record is computed again")
OF_SAMPLES = LeftOut("contains paths of files and reads none")

PUBLIC: dict[str, tuple[str, ...] | LeftOut] = {
    "loom.AzureKinectCamera": OF_SDK,
    "loom.DepthModel": BY_ONNX,
    "loom.DetailTree.from_file": ("detail tree",),
    "loom.DistanceField.load": ("distance field",),
    "loom.FrameRecorder": OF_MEMORY,
    "loom.OccupancyGrid.load": ("occupancy grid",),
    "loom.PagedTSDFVolume": PAGED,
    "loom.PagedTSDFVolume.load": PAGED,
    "loom.RealSenseCamera": OF_SDK,
    "loom.SelectionPolygonVolume.from_json": ("polygon volume",),
    "loom.TSDFVolume.load": ("volume",),
    "loom.TriangleMesh.revolve": LeftOut("takes a profile, which is an array"),
    "loom.change.draw": OF_MEMORY,
    "loom.datasets.fetch": LeftOut("checks a digest before a file is read"),
    "loom.draw_slice": OF_MEMORY,
    "loom.estimate_depth": BY_ONNX,
    "loom.mvs.DepthMaps": OF_MEMORY,
    "loom.mvs.DepthMaps.open": MAPS,
    "loom.mvs.estimate_depth_maps": MAPS,
    "loom.mvs.filter_depth_maps": OF_MEMORY,
    "loom.mvs.read_depth_bundle": ("depth bundle",),
    "loom.open_dataset": DATASETS,
    "loom.open_frames": DATASETS,
    "loom.open_recording": RECORDINGS,
    "loom.read_cameras": ("cameras of frames", "Metashape", *MODELS),
    "loom.read_colmap_model": MODELS,
    "loom.read_color": IMAGES,
    "loom.read_copc": ("COPC",),
    "loom.read_depth": DEPTHS,
    "loom.read_las_chunks": ("chunks of LAS",),
    "loom.read_metashape_cameras": ("Metashape",),
    "loom.read_pinhole_camera_intrinsic": ("camera .json",),
    "loom.read_point_cloud": CLOUDS,
    "loom.read_splats": ("splats .ply", "splats .splat", "splats .spz"),
    "loom.read_stations": ("stations .e57", "stations .ptx"),
    "loom.read_trajectory": POSES,
    "loom.read_triangle_mesh": MESHES,
    "loom.read_view": ("view",),
    "loom.reconstruction.FragmentOptions": OF_MEMORY,
    "loom.reconstruction.ReconstructionConfig": OF_MEMORY,
    "loom.reconstruction.ReconstructionConfig.read": ("configuration",),
    "loom.reconstruction.integrate_scene": OF_JOB,
    "loom.reconstruction.make_fragments": OF_JOB,
    "loom.reconstruction.refine_registration": OF_JOB,
    "loom.reconstruction.refine_with_slac": OF_JOB,
    "loom.reconstruction.register_fragments": OF_JOB,
    "loom.reconstruction.run_rigid_optimizer_for_fragments": ("cloud .ply",),
    "loom.reconstruction.run_slac_optimizer_for_fragments": ("cloud .ply",),
    "loom.reconstruction.run_system": OF_JOB,
    "loom.registration.iterate_odometry": CLOUDS,
    "loom.registration.list_scans": LeftOut("lists the names of a folder"),
    "loom.registration.read_pose_graph": ("pose graph",),
    "loom.registration.read_positions": ("positions",),
    "loom.registration.run_odometry": CLOUDS,
    "loom.sample_file": LeftOut("paths of files of the package"),
    "loom.sfm.choose_frames": LeftOut("videos are decoded by ffmpeg; images: see loom.sfm.find_features"),
    "loom.sfm.find_features": IMAGES,
    "loom.sfm.map_pictures": BY_COLMAP,
    "loom.sfm.match": BY_COLMAP,
    "loom.sfm.read_picture_places": ("positions of photos",),
    "loom.sfm.reconstruct": IMAGES,
    "loom.sfm.triangulate": IMAGES,
    "loom.tiling.finish_fusion": JOBS,
    "loom.tiling.finish_registration": JOBS,
    "loom.tiling.finish_tiles": TILES,
    "loom.tiling.job_status": JOBS,
    "loom.tiling.plan_fusion": DATASETS,
    "loom.tiling.plan_registration": CLOUDS,
    "loom.tiling.plan_tiles": ("steps", "steps of a job", "VPC", "area"),
    "loom.tiling.retry_job": JOBS,
    "loom.tiling.retry_tiles": TILES,
    "loom.tiling.run_job": JOBS,
    "loom.tiling.run_tiles": TILES,
    "loom.video.GroundControl": ("ground control", "ground control .csv", "scale bars"),
    "loom.video.Outputs": OF_MEMORY,
    "loom.video.Settings": ("camera .json", "cameras of frames", *IMAGES),
    "loom.video.Units": ("positions", *POSES, "ground control", "scale bars"),
    "loom.video.reconstruct": LeftOut("videos are decoded by ffmpeg; images: see loom.sfm.find_features"),
    "o3d.core.HashMap.load": ("open3d hash map",),
    "o3d.core.HashSet.load": ("open3d hash set",),
    "o3d.core.Tensor.load": ("open3d tensor",),
    "o3d.io.read_feature": ("open3d feature",),
    "o3d.io.read_file_geometry_type": ("open3d contents",),
    "o3d.io.read_image": ("open3d image .png",),
    "o3d.io.read_line_set": ("open3d line set",),
    "o3d.io.read_octree": ("open3d octree",),
    "o3d.io.read_pinhole_camera_intrinsic": ("open3d intrinsic",),
    "o3d.io.read_pinhole_camera_parameters": ("open3d parameters",),
    "o3d.io.read_pinhole_camera_trajectory": ("open3d trajectory .json", "open3d trajectory .log"),
    "o3d.io.read_point_cloud": ("open3d cloud .ply", "open3d cloud .pcd", "open3d cloud .xyz", "open3d cloud .xyzn",
                                "open3d cloud .xyzrgb", "open3d cloud .pts"),
    "o3d.io.read_point_cloud_from_bytes": ("open3d bytes ply", "open3d bytes pcd", "open3d bytes xyz",
                                           "open3d bytes pts"),
    "o3d.io.read_pose_graph": ("open3d pose graph",),
    "o3d.io.read_triangle_mesh": ("open3d mesh", "open3d mesh .stl"),
    "o3d.io.read_voxel_grid": ("open3d voxel grid",),
    "o3d.t.geometry.VoxelBlockGrid.load": ("open3d voxel block grid",),
    "o3d.t.io.read_image": ("open3d image .jpg",),
    "o3d.t.io.read_point_cloud": ("open3d tensor cloud .ply", "open3d tensor cloud .pcd", "open3d tensor cloud .npz",
                                  "open3d tensor cloud .xyz", "open3d tensor cloud .las"),
    "o3d.t.io.read_triangle_mesh": ("open3d tensor mesh", "open3d tensor mesh .glb", "open3d tensor mesh .npz"),
    "o3d.visualization.RenderOption.load_from_json": ("open3d options",),
    "o3d.visualization.read_selection_polygon_volume": ("open3d polygon",),
}  # fmt: skip
SAMPLES = "o3d.data."  # classes of data sets: `OF_SAMPLES`


def public_readers(loom: ModuleType, o3d: ModuleType) -> Iterator[str]:
    """Names of the public functions, classes and methods that take a path or bytes, and do not only write."""
    for top, prefix in ((loom, "loom"), (o3d, "o3d")):
        for name, value in _members(top, prefix):
            if takes_file(value) and not WRITERS.search(name) and not name.startswith(SAMPLES):
                yield name


def takes_file(value: Any) -> bool:
    """True if a parameter is a path or bytes, by its name or type."""
    try:
        parameters = inspect.signature(value).parameters.values()
    except (TypeError, ValueError):
        return False
    return any(PARAMETERS.search(each.name) or TYPES.search(str(each.annotation)) for each in parameters)


def _members(module: ModuleType, prefix: str) -> Iterator[tuple[str, Any]]:
    for name in sorted(getattr(module, "__all__", None) or [each for each in vars(module) if not each.startswith("_")]):
        value = getattr(module, name)
        if isinstance(value, ModuleType):
            if name not in ("open3d", "pybind") and value.__name__.startswith("pointloom"):
                yield from _members(value, f"{prefix}.{name}")
        elif inspect.isclass(value) and not issubclass(value, BaseException):
            yield f"{prefix}.{name}", value
            for part in dir(value):
                kind = inspect.getattr_static(value, part)
                if not part.startswith("_") and isinstance(kind, staticmethod | classmethod | FunctionType):
                    yield f"{prefix}.{name}.{part}", getattr(value, part)
        elif callable(value) and not inspect.isclass(value):
            yield f"{prefix}.{name}", value


def opening_modules(root: Path) -> set[str]:
    """The modules of pointloom that open an input file, as paths in the package. Follows links."""
    package, found = root / "src" / "pointloom", set()
    for path in _files(package):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        if any(isinstance(node, ast.Call) and _opens(node) for node in ast.walk(tree)):
            found.add(path.relative_to(package).as_posix())
    return found


def _files(folder: Path) -> Iterator[Path]:
    for entry in sorted(folder.iterdir()):
        if entry.is_dir():
            yield from _files(entry)
        elif entry.suffix == ".py":
            yield entry


def _opens(call: ast.Call) -> bool:
    """True for `input_path(...)`, `path.read_bytes()`, `np.load(...)`, `path.open("rb")` and the like."""
    function = call.func
    name = function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")
    if name in ("load", "connect", "ZipFile"):
        return isinstance(function, ast.Attribute) and getattr(function.value, "id", "") in HOLDERS
    is_binary = any(isinstance(each, ast.Constant) and each.value == "rb" for each in call.args)
    return name in OPENERS or (name == "open" and is_binary)

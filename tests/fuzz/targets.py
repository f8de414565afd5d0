"""The list of all functions that read files, with the fuzz cases that cover each of them.

`PUBLIC` has the public functions of pointloom and `pointloom.open3d` that take a path or bytes, `MODULES` the modules
that open files, without the readers in the tables of formats. tests/io/test_fuzzed_files.py compares both with the
code. A value is the names of cases, or `LeftOut` with the reason. Functions that only write are recognized by
their names (`WRITERS`).
"""

from __future__ import annotations

import ast
import functools
import inspect
import re
from collections.abc import Iterator
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any

from pointloom.core import paths
from pointloom.io.meshes.mesh_formats import MESH_FORMATS
from pointloom.io.points.formats import CLOUD_FORMATS
from pointloom.io.splats.splat_files import EXTENSIONS


class LeftOut(str):
    """Why a function has no case."""


PARAMETERS = re.compile(r"path|file|folder|bytes|database|scans")
TYPES = re.compile(r"PathLike|FilePath|\bPath\b|\bbytes\b")
WRITERS = re.compile(r"\.(write_\w+|write|save\w*|to_json|capture_\w+|export_\w+|record\w*|screenshot|add_\w+)$")
OPENERS = {"input_path", "open_source", "read_json_object", "read_text", "read_bytes", "read_arrays", "read_npy",
           "read_part_of_job"}  # fmt: skip
_MAY_OPEN = re.compile("|".join([*OPENERS, r'"rb"', r"\.(?:load|connect|ZipFile)\("]))
HOLDERS = {"np", "sqlite3", "zipfile"}  # of `load`, `connect` and `ZipFile`

CLOUDS = tuple(f"cloud {extension}" for extension in (*CLOUD_FORMATS, ".copc.laz"))
MESHES = tuple(f"mesh {extension}" for extension in MESH_FORMATS)
POSES = ("trajectory .log", "trajectory .tum", "trajectory .kitti", "trajectory .json")
MODELS = ("COLMAP cameras.txt", "COLMAP images.txt", "COLMAP points3D.txt", "COLMAP cameras.bin", "COLMAP images.bin",
          "COLMAP points3D.bin")  # fmt: skip
DATASETS = ("data set, camera", "data set, matrix", "data set, pose", "data set, depth", "data set, color", "TUM, list",
            "TUM, poses", "recorded frames, times")  # fmt: skip
IMAGES = ("color .png", "color .jpg")
DEPTHS = ("depth .png", "depth .npy")
TILES = ("plan of a manifest", "manifest")
JOBS = ("job of registration, plan", "job of registration, task", "job of fusion, plan", "job of fusion, task")
PAGED = ("paged volume, state", "paged volume, page")
MAPS = ("depth maps, index", "depth maps, map")
RECORDINGS = tuple(f"recording {extension}" for extension in paths.RECORDINGS)
SPLATS = tuple(f"splats {extension}" for extension in EXTENSIONS)

PHOTOS = ("photo .heic", "photo .dng", "photo .tif", "photo .webp")
VIDEOS = ("video .mp4", "video .mkv", "video .avi", "video .ts", "video .mov")
FEATURES = ("features, bytes", "features, cells")
DATABASES = (*FEATURES, "matches, bytes", "matches, cells")
RECONSTRUCTION = ("reconstruction, record fragment_000", "reconstruction, record register",
                  "reconstruction, record refine", "reconstruction, record slac", "reconstruction, record integrate",
                  "reconstruction, configuration", "reconstruction, graph", "reconstruction, cloud",
                  "reconstruction, grid", "reconstruction, mesh")  # fmt: skip
WORK = ("video, record frames", "video, record features", "video, record matches", "video, record model",
        "video, record undistorted", "video, record depth", "video, record fused", "video, record mesh",
        "video, marker", "video, report", "video, model", "video, depth", "video, mesh")  # fmt: skip
NETWORK = ("network",)

OF_SDK = LeftOut("recordings of a camera are read by its driver")
OF_MEMORY = LeftOut("takes objects in memory; the path is of an output")

PUBLIC: dict[str, tuple[str, ...] | LeftOut] = {
    "loom.AzureKinectCamera": OF_SDK,
    "loom.photogrammetry.DepthModel": NETWORK,
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
    "loom.draw_change": OF_MEMORY,
    "loom.datasets.fetch": LeftOut("checks a digest before a file is read"),
    "loom.draw_slice": OF_MEMORY,
    "loom.photogrammetry.estimate_depth": NETWORK,
    "loom.photogrammetry.DepthMaps": OF_MEMORY,
    "loom.photogrammetry.DepthMaps.open": MAPS,
    "loom.photogrammetry.estimate_depth_maps": MAPS,
    "loom.photogrammetry.filter_depth_maps": OF_MEMORY,
    "loom.photogrammetry.read_depth_bundle": ("depth bundle",),
    "loom.open_dataset": DATASETS,
    "loom.open_frames": DATASETS,
    "loom.open_recording": RECORDINGS,
    "loom.read_cameras": ("cameras of frames", "Metashape", *MODELS),
    "loom.read_color": IMAGES,
    "loom.read_copc": ("COPC",),
    "loom.read_depth": DEPTHS,
    "loom.read_e57_chunks": ("chunks of E57",),
    "loom.read_las_chunks": ("chunks of LAS",),
    "loom.PinholeCameraIntrinsic.read": ("camera .json",),
    "loom.read_point_cloud": CLOUDS,
    "loom.read_raster": ("raster .tif",),
    "loom.read_splats": SPLATS,
    "loom.read_stations": ("stations .e57", "stations .ptx"),
    "loom.read_trajectory": POSES,
    "loom.read_triangle_mesh": MESHES,
    "loom.read_view": ("view",),
    "loom.rgbd.FragmentOptions": OF_MEMORY,
    "loom.rgbd.ReconstructionConfig": OF_MEMORY,
    "loom.rgbd.ReconstructionConfig.read": ("configuration",),
    "loom.rgbd.run_rigid_optimizer_for_fragments": ("cloud .ply",),
    "loom.rgbd.run_slac_optimizer_for_fragments": ("cloud .ply",),
    "loom.rgbd.run_reconstruction_system": RECONSTRUCTION,
    "loom.registration.LidarSLAM": ("LiDAR submap",),
    "loom.registration.LidarSLAM.open": ("LiDAR map",),
    "loom.registration.PositionReadings.read": ("given positions",),
    "loom.registration.read_control_points": ("control of stations",),
    "loom.registration.read_pose_graph": ("pose graph",),
    "loom.registration.read_positions": ("positions",),
    "loom.registration.read_targets": ("targets of stations",),
    "loom.registration.run_odometry": CLOUDS,
    "loom.DetailTree.sample": LeftOut("paths of files of the package"),
    "loom.photogrammetry.choose_frames": (*VIDEOS, *IMAGES),
    "loom.photogrammetry.find_features": (*IMAGES, *PHOTOS),
    "loom.photogrammetry.map_images": DATABASES,
    "loom.photogrammetry.match_features": FEATURES,
    "loom.photogrammetry.read_image_positions": ("positions of photos",),
    "loom.photogrammetry.reconstruct_images": IMAGES,
    "loom.photogrammetry.triangulate": IMAGES,
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
    "loom.photogrammetry.GroundControl": ("ground control", "ground control .csv", "scale bars"),
    "loom.photogrammetry.VideoOutputs": OF_MEMORY,
    "loom.photogrammetry.VideoSettings": ("camera .json", "cameras of frames", *IMAGES),
    "loom.photogrammetry.VideoUnits": ("positions", *POSES, "ground control", "scale bars"),
    "loom.meshing.texture_from_images": LeftOut("work is a folder of kept steps, see core/kept_arrays.py"),
    "loom.meshing.texture_mesh": LeftOut("work is a folder of kept steps, see core/kept_arrays.py"),
    "loom.photogrammetry.reconstruct_video": WORK,
    "o3d.core.Tensor.load": ("open3d tensor",),
    "o3d.io.read_feature": ("open3d feature",),
    "o3d.io.read_image": ("open3d image .png",),
    "o3d.io.read_line_set": ("open3d line set",),
    "o3d.io.read_pinhole_camera_intrinsic": ("open3d intrinsic",),
    "o3d.io.read_pinhole_camera_parameters": ("open3d parameters",),
    "o3d.io.read_pinhole_camera_trajectory": ("open3d trajectory .json", "open3d trajectory .log"),
    "o3d.io.read_point_cloud": ("open3d cloud .ply", "open3d cloud .pcd", "open3d cloud .xyz", "open3d cloud .xyzn",
                                "open3d cloud .xyzrgb", "open3d cloud .pts"),
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
SAMPLES = "o3d.data."  # classes of paths of files, which read none


JOB_TILES = ("job of tiles, buckets", "job of tiles, blocks", "job of tiles, labels", "job of tiles, joined labels",
             "job of tiles, summary", "job of tiles, tile", "job of tiles, raster")  # fmt: skip
OF_PACKAGE = LeftOut("files of the package itself")
OF_WRITER = LeftOut("reads what the same call has written")
OF_SYSTEM = LeftOut("files of the operating system")
OF_PAGE = LeftOut("a page, image or video that the same call has written")

OF_STEPS = LeftOut("a damaged step is computed again (tests/test_run_folders.py)")

MODULES: dict[str, tuple[str, ...] | LeftOut] = {
    "cameras/camera.py": ("camera .json",),
    "cameras/pose_text.py": ("trajectory .log", "extrinsic"),
    "cameras/trajectory.py": POSES,
    "cli/jobs/info.py": ("described .txt", "described .json", "described folder"),
    "cli/shell/chapters.py": OF_PACKAGE,
    "cli/shell/help_commands.py": OF_PACKAGE,
    "cli/shell/pipes.py": LeftOut("copies standard input to a file, which a reader reads"),
    "core/atomic.py": OF_WRITER,
    "core/cuda_driver.py": OF_SYSTEM,
    "core/json_files.py": ("camera .json",),
    "core/kept_arrays.py": OF_STEPS,
    "core/open3d_names.py": OF_PACKAGE,
    "core/paths.py": LeftOut("compares the first bytes of a file with those of a pointer of Git LFS"),
    "core/records.py": (*RECONSTRUCTION, *WORK),
    "core/stages.py": WORK,
    "core/timing.py": OF_SYSTEM,
    "datasets/array_cache.py": LeftOut("a cache of made scenes in the user's own folder"),
    "datasets/public/fetching.py": LeftOut("checks a digest before a file is read"),
    "io/bags/bag1.py": RECORDINGS,
    "io/bags/db3.py": RECORDINGS,
    "io/bags/mcap.py": RECORDINGS,
    "io/frames/dataset_layouts.py": DATASETS,
    "io/frames/datasets.py": DATASETS,
    "io/meshes/glb.py": ("mesh .glb", "GLB"),
    "io/meshes/gltf_file.py": ("mesh .gltf", "glTF"),
    "io/meshes/obj.py": ("mesh .obj", "OBJ", "OBJ corners"),
    "io/number_tables.py": (
        *("control of stations", "targets of stations", "distances"),
        *("ground control", "ground control .csv", "scale bars"),
    ),
    "io/obj_statements.py": ("mesh .obj", "cloud .obj", "OBJ", "OBJ corners"),
    "io/meshes/off.py": ("mesh .off", "OFF"),
    "io/meshes/stl.py": ("mesh .stl", "STL"),
    "io/meshes/tables.py": ("mesh .ply",),
    "io/models/camera_files.py": ("cameras of frames",),
    "io/models/colmap_binary.py": MODELS,
    "io/models/colmap_text.py": MODELS,
    "io/models/frame_cameras.py": ("transforms.json", "cameras of frames"),
    "io/models/metashape.py": ("Metashape",),
    "io/images/image_files.py": (*IMAGES, *DEPTHS),
    "io/images/photo_files.py": (*PHOTOS, "EXIF"),
    "io/images/texture_files.py": MESHES,
    "io/points/archives.py": ("volume", "occupancy grid", "distance field", "control grid"),
    "io/points/copc.py": ("COPC",),
    "io/points/copc_nodes.py": ("COPC",),
    "io/points/e57_writer.py": OF_WRITER,
    "io/points/header_units.py": ("cloud .ply", "cloud .pcd"),
    "io/points/in_parts.py": ("detail tree",),
    "io/points/laz_chunks.py": ("chunks of LAS",),
    "io/points/npz.py": ("cloud .npz", "NPZ", "open3d tensor"),
    "io/points/pcd.py": ("cloud .pcd", "PCD"),
    "io/points/ply.py": ("cloud .ply", "PLY mesh, text", "PLY mesh, binary"),
    "io/points/text.py": ("cloud .xyz", "XYZ"),
    "io/points/text_parts.py": ("detail tree .xyz",),
    "io/points/text_table.py": ("cloud .csv", "CSV"),
    "io/source.py": CLOUDS,
    "io/vtk_legacy.py": ("cloud .vtk", "mesh .vtk"),
    "io/vtk_xml.py": ("cloud .vtp", "mesh .vtp"),
    "io/splats/splat_ply.py": ("splats .ply",),
    "io/splats/splat_rows.py": ("splats .splat",),
    "io/splats/spz.py": ("splats .spz",),
    "meshing/color_map/image_texturing.py": OF_STEPS,
    "meshing/color_map/optimizers.py": OF_STEPS,
    "meshing/color_map/results.py": OF_STEPS,
    "meshing/color_map/texturing.py": OF_STEPS,
    "open3d/core/tensor.py": ("open3d tensor",),
    "open3d/io/cameras.py": ("open3d parameters", "open3d trajectory .json"),
    "open3d/io/images.py": ("open3d image .png", "open3d image .jpg"),
    "open3d/io/ply_elements.py": ("open3d line set", "open3d voxel grid"),
    "open3d/io/registration.py": ("open3d feature",),
    "open3d/io/shapes.py": ("open3d mesh",),
    "open3d/t/io/clouds.py": ("open3d tensor cloud .ply",),
    "open3d/t/io/meshes.py": ("open3d tensor mesh .npz",),
    "open3d/visualization/render_option.py": ("open3d options",),
    "open3d/visualization/visualizer.py": OF_PAGE,
    "pcd/contour_files.py": OF_WRITER,
    "pcd/geotiff.py": ("raster .tif",),
    "pcd/polygon_volume.py": ("polygon volume",),
    "photogrammetry/depth/network.py": NETWORK,
    "photogrammetry/depth/photos.py": ("EXIF", *IMAGES),
    "photogrammetry/mvs/depth_bundles.py": ("depth bundle",),
    "photogrammetry/mvs/depth_maps.py": MAPS,
    "photogrammetry/mvs/plane_search.py": ("checkpoint of a search",),
    "photogrammetry/sfm/colmap_cameras.py": DATABASES,
    "photogrammetry/sfm/colmap_jobs.py": DATABASES,
    "photogrammetry/sfm/colmap_worker.py": DATABASES,
    "photogrammetry/sfm/guided_matches.py": OF_WRITER,
    "photogrammetry/sfm/limited_process.py": OF_SYSTEM,
    "photogrammetry/sfm/masks.py": IMAGES,
    "photogrammetry/sfm/matches.py": DATABASES,
    "photogrammetry/sfm/image_choice.py": IMAGES,
    "photogrammetry/sfm/training_folder.py": LeftOut("copies images that were read before"),
    "photogrammetry/sfm/triangulation.py": OF_WRITER,
    "photogrammetry/sfm/video_files.py": VIDEOS,
    "photogrammetry/video/job.py": LeftOut(
        "only the marker of a folder (tests/photogrammetry/video/test_video_command.py)"
    ),
    "photogrammetry/video/known_motion.py": LeftOut("copies images that were read before"),
    "registration/deformable/control_grid_files.py": ("control grid",),
    "registration/lidar/lidar_sessions.py": ("LiDAR map",),
    "registration/lidar/lidar_submaps.py": ("LiDAR submap",),
    "registration/pose_graphs/pose_graph_files.py": ("pose graph",),
    "rgbd/reconstruction/config.py": ("configuration",),
    "rgbd/reconstruction/job_files.py": ("configuration",),
    "tiling/border_merging.py": JOB_TILES,
    "tiling/buckets.py": JOB_TILES,
    "tiling/jobs/fused_mesh.py": ("job of fusion, cube", "job of fusion, result"),
    "tiling/jobs/scans.py": ("job of registration, surface", "job of registration, result"),
    "tiling/label_join.py": OF_WRITER,
    "tiling/manifest.py": (*TILES, *JOBS),
    "tiling/polygons.py": ("area",),
    "tiling/schema.py": LeftOut("a database in memory"),
    "tiling/sources.py": ("VPC",),
    "tiling/steps/parse.py": ("steps", "steps of a job"),
    "tiling/work_tile.py": JOB_TILES,
    "visualization/page/sources.py": OF_PACKAGE,
    "visualization/recording/cell_output.py": OF_PAGE,
    "visualization/recording/exports.py": OF_WRITER,
    "visualization/recording/shared_player.py": OF_PAGE,
    "visualization/recording/writers.py": OF_PAGE,
    "visualization/render/colormaps.py": OF_PACKAGE,
    "visualization/render/lettering.py": OF_PACKAGE,
    "visualization/render/open3d_views.py": ("view",),
    "visualization/viewer/draw.py": OF_PAGE,
    "visualization/viewer/page_actions.py": OF_PAGE,
    "visualization/viewer/tools/stage.py": OF_PAGE,
    "visualization/viewer/view_files.py": ("viewed file .npz", "viewed file .json"),
}
# The modules of the readers of formats are added by `modules_of_formats`.
TRUSTED = "kernels/"  # modules of caches and archives of kernels, which are trusted (SECURITY.md)


def modules_of_formats() -> dict[str, tuple[str, ...]]:
    """The modules of the readers in the tables of formats, with the cases of their formats."""
    found: dict[str, tuple[str, ...]] = {}
    for kind, formats in (("cloud", CLOUD_FORMATS), ("mesh", MESH_FORMATS)):
        for extension, format in formats.items():
            name = inspect.unwrap(format.codec.read).__module__.removeprefix("pointloom.").replace(".", "/") + ".py"
            found[name] = (*found.get(name, ()), f"{kind} {extension}")
    return found


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
    from pointloom.public_names import results_of

    results = results_of(module.__name__) if prefix.startswith("loom") else frozenset()
    for name in sorted(getattr(module, "__all__", None) or [each for each in vars(module) if not each.startswith("_")]):
        if name in results:
            continue
        value = getattr(module, name)
        if isinstance(value, ModuleType):
            if name not in ("open3d", "torch") and value.__name__.startswith("pointloom"):
                yield from _members(value, f"{prefix}.{name}")
        elif inspect.isclass(value) and not issubclass(value, BaseException):
            yield f"{prefix}.{name}", value
            for part in dir(value):
                kind = inspect.getattr_static(value, part)
                if not part.startswith("_") and isinstance(kind, staticmethod | classmethod | FunctionType):
                    yield f"{prefix}.{name}.{part}", getattr(value, part)
        elif callable(value) and not inspect.isclass(value):
            yield f"{prefix}.{name}", value


@functools.cache
def opening_modules(root: Path) -> frozenset[str]:
    """The modules of pointloom that open an input file, as paths in the package."""
    package, found = root / "src" / "pointloom", set()
    for path in sorted(package.rglob("*.py")):
        text = path.read_text(encoding="utf-8")
        if _MAY_OPEN.search(text):
            tree = ast.parse(text)
            if any(isinstance(node, ast.Call) and _opens(node) for node in ast.walk(tree)):
                found.add(path.relative_to(package).as_posix())
    return frozenset(found)


def _opens(call: ast.Call) -> bool:
    """True for `input_path(...)`, `path.read_bytes()`, `np.load(...)`, `path.open("rb")` and the like."""
    function = call.func
    name = function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")
    if name in ("load", "connect", "ZipFile"):
        return isinstance(function, ast.Attribute) and getattr(function.value, "id", "") in HOLDERS
    is_binary = any(isinstance(each, ast.Constant) and each.value == "rb" for each in call.args)
    return name in OPENERS or (name == "open" and is_binary)


def uncovered(root: Path, loom: ModuleType, o3d: ModuleType, cases: set[str]) -> list[str]:
    """Differences between the two lists, the code and the names of the cases, one line each."""
    readers, modules = set(public_readers(loom, o3d)), opening_modules(root)
    modules = {name for name in modules if not name.startswith(TRUSTED)}
    listed = {name: value for name, value in modules_of_formats().items() if name in modules} | MODULES
    lines = [f"{name}: reads a file, and is not in the list" for name in sorted(readers - PUBLIC.keys())]
    lines += [f"{name}: opens a file, and is not in the list" for name in sorted(modules - listed.keys())]
    lines += [f"{name}: is in the list, and is no public reader" for name in sorted(PUBLIC.keys() - readers)]
    lines += [f"{name}: is in the list, and opens no file" for name in sorted(MODULES.keys() - modules)]
    used: set[str] = set()
    for name, value in (PUBLIC | listed).items():
        if isinstance(value, LeftOut):
            lines += [] if value else [f"{name}: has neither a case nor a reason"]
            continue
        used |= set(value)
        lines += [f"{name}: there is no case {case!r}" for case in value if case not in cases]
        lines += [] if value else [f"{name}: has neither a case nor a reason"]
    return [*lines, *(f"{case!r}: no reader of the list has this case" for case in sorted(cases - used))]

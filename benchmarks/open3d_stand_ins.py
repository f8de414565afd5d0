"""Stand-ins for the files and windows of scripts written for Open3D, the same ones for both packages.

python -m benchmarks.open3d_stand_ins FOLDER   writes the data sets of `o3d.data` and the files of `replace`

The files are scans, frames and meshes of POINTLOOM_DATA, reduced to some 10,000 points. Open3D writes them.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
from PIL import Image

EVERY = 9  # of the points of scans
READERS = ("read_point_cloud", "read_triangle_mesh", "read_image", "read_pose_graph", "read_pinhole_camera_trajectory")
CLOUDS = (".ply", ".pcd", ".xyz", ".pts", ".xyzn", ".xyzrgb")
MESHES = (".obj", ".stl", ".off", ".glb", ".gltf")
TEXTURES = {"MetalTexture": "Metal008", "TilesTexture": "Tiles074", "TerrazzoTexture": "Terrazzo018"}


def make(folder: Path) -> None:
    """Write the sample data sets and the stand-ins."""
    import open3d as o3d

    data = Path(os.environ["POINTLOOM_DATA"])
    (folder / "stand_ins").mkdir(parents=True, exist_ok=True)

    def place(name: str) -> str:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        return str(folder / name)

    _write_frames(data / "rgbd-cupoch-redwood5", folder, place)
    fragment = o3d.io.read_point_cloud(str(data / "cloud-cupoch/fragment.pcd")).uniform_down_sample(EVERY)
    for name in ("PLYPointCloud", "DemoCropPointCloud", "DemoCustomVisualization"):
        o3d.io.write_point_cloud(place(f"{name}/fragment.ply"), fragment)
    o3d.io.write_point_cloud(place("PCDPointCloud/fragment.pcd"), fragment)
    o3d.io.write_point_cloud(place("EaglePointCloud/EaglePointCloud.ply"), fragment)
    for suffix in CLOUDS:
        o3d.io.write_point_cloud(place(f"stand_ins/cloud{suffix}"), fragment)
    low, high = fragment.get_min_bound(), fragment.get_max_bound()
    middle, size = (low + high) / 2, (high - low) / 4
    corners = [[middle[0] + x * size[0], 0.0, middle[2] + z * size[2]] for x, z in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    polygon = {"axis_max": high[1], "axis_min": low[1], "bounding_polygon": corners, "orthogonal_axis": "Y"}
    polygon |= {"class_name": "SelectionPolygonVolume", "version_major": 1, "version_minor": 0}
    Path(place("DemoCropPointCloud/cropped.json")).write_text(json.dumps(polygon))
    _write_scans(o3d, data, place)
    _write_meshes(o3d, data, place)
    for name, stem in TEXTURES.items():
        for part in ("Color", "NormalDX", "Roughness", "Metalness"):
            Image.new("RGB", (32, 32), (120, 130, 200)).save(place(f"{name}/{stem}_{part}.jpg"))
    _write_pose_graphs(o3d, place)


def _write_frames(source: Path, folder: Path, place: Callable[[str], str]) -> None:
    shutil.copytree(source, folder / "SampleRedwoodRGBDImages", dirs_exist_ok=True)
    for kind, suffixes in {"SUN": ("jpg", "png"), "TUM": ("png", "png"), "NYU": ("ppm", "pgm")}.items():
        for part, suffix in zip(("color", "depth"), suffixes, strict=True):
            name = f"{kind}_{part}.{suffix}"
            shutil.copy(source / "other_formats" / name, place(f"Sample{kind}RGBDImage/{name}"))
    color = next(iter(sorted((source / "color").glob("*.jpg"))))
    shutil.copy(color, place("JuneauImage/JuneauImage.jpg"))
    shutil.copy(color, place("stand_ins/color.jpg"))
    Image.open(color).save(place("stand_ins/color.png"))
    shutil.copy(next(iter(sorted((source / "depth").glob("*.png")))), place("stand_ins/depth.png"))
    camera = {"width": 640, "height": 480, "intrinsic_matrix": [525.0, 0, 0, 0, 525.0, 0, 319.5, 239.5, 1]}
    Path(place("SampleRedwoodRGBDImages/camera_primesense.json")).write_text(json.dumps(camera))


def _write_scans(o3d: ModuleType, data: Path, place: Callable[[str], str]) -> None:
    """Clouds of neighboring frames, with colors and normals, for registration."""
    frames, camera = data / "rgbd-cupoch-redwood5", o3d.camera.PinholeCameraIntrinsic(640, 480, 525, 525, 319.5, 239.5)
    for i in range(3):
        images = [
            o3d.io.read_image(str(path)) for path in (_numbered(frames, "color", i), _numbered(frames, "depth", i))
        ]
        rgbd = o3d.geometry.RGBDImage.create_from_color_and_depth(*images, 1000.0, 4.0, False)
        cloud = o3d.geometry.PointCloud.create_from_rgbd_image(rgbd, camera).uniform_down_sample(EVERY * 2)
        cloud.estimate_normals(o3d.geometry.KDTreeSearchParamHybrid(0.1, 30))
        cloud.orient_normals_towards_camera_location()
        o3d.io.write_point_cloud(place(f"DemoICPPointClouds/cloud_bin_{i}.pcd"), cloud)
        if i < 2:
            o3d.io.write_point_cloud(place(f"DemoColoredICPPointClouds/frag_{115 + i}.ply"), cloud)
            o3d.io.write_point_cloud(place(f"DemoFeatureMatchingPointClouds/cloud_bin_{i}.pcd"), cloud)
            feature = o3d.pipelines.registration.compute_fpfh_feature(
                cloud, o3d.geometry.KDTreeSearchParamHybrid(0.25, 50)
            )
            for kind in ("fpfh", "d32"):
                name = f"DemoFeatureMatchingPointClouds/cloud_bin_{i}.{kind}.bin"
                o3d.io.write_feature(place(name), feature)
    Path(place("DemoICPPointClouds/init.log")).write_text("0 1 2\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n")


def _numbered(frames: Path, kind: str, number: int) -> Path:
    return sorted((frames / kind).iterdir())[number]


def _write_meshes(o3d: ModuleType, data: Path, place: Callable[[str], str]) -> None:
    common = data / "mesh-common3d"
    for name, source in {"BunnyMesh": "stanford-bunny", "ArmadilloMesh": "nefertiti", "KnotMesh": "fandisk"}.items():
        mesh = o3d.io.read_triangle_mesh(str(common / f"{source}.obj"))
        mesh = mesh.simplify_quadric_decimation(6000) if len(mesh.triangles) > 6000 else mesh
        mesh.compute_vertex_normals()
        o3d.io.write_triangle_mesh(place(f"{name}/{name}.ply"), mesh)
        if name == "BunnyMesh":
            for suffix in (".ply", *MESHES):
                o3d.io.write_triangle_mesh(place(f"stand_ins/mesh{suffix}"), mesh)
    box = o3d.geometry.TriangleMesh.create_box(create_uv_map=True)
    image = Image.fromarray(np.random.default_rng(0).integers(0, 255, (64, 64, 3)).astype(np.uint8))
    for folder, stem, texture in (("CrateModel", "crate", "crate.jpg"), ("MonkeyModel", "monkey", "albedo.png"),
                                  ("SwordModel", "UV", "UV_blinn1SG_BaseColor.png")):  # fmt: skip
        corners, uvs = np.asarray(box.vertices), np.asarray(box.triangle_uvs)
        lines = [f"mtllib {stem}.mtl", "usemtl a", *(f"v {x} {y} {z}" for x, y, z in corners)]
        lines += [f"vt {u} {v}" for u, v in uvs]
        for i, row in enumerate(np.asarray(box.triangles)):
            lines.append("f " + " ".join(f"{vertex + 1}/{3 * i + k + 1}" for k, vertex in enumerate(row)))
        Path(place(f"{folder}/{stem}.obj")).write_text("\n".join(lines) + "\n")
        Path(place(f"{folder}/{stem}.mtl")).write_text(f"newmtl a\nKd 0.8 0.8 0.8\nmap_Kd {texture}\n")
        image.save(place(f"{folder}/{texture}"))
    for part in ("ao", "metallic", "normal", "roughness"):
        image.save(place(f"MonkeyModel/{part}.png"))
    for part in ("Metallic", "Normal", "Roughness"):
        image.save(place(f"SwordModel/UV_blinn1SG_{part}.png"))
    mesh = o3d.io.read_triangle_mesh(place("BunnyMesh/BunnyMesh.ply"))
    o3d.io.write_triangle_mesh(place("AvocadoModel/AvocadoModel.glb"), mesh)
    o3d.io.write_triangle_mesh(place("DamagedHelmetModel/DamagedHelmetModel.glb"), mesh)


def _write_pose_graphs(o3d: ModuleType, place: Callable[[str], str]) -> None:
    """A ring of 8 poses with noise."""
    r, random = o3d.pipelines.registration, np.random.default_rng(3)
    step = np.eye(4)
    step[:3, :3] = o3d.geometry.get_rotation_matrix_from_xyz([0, 0, np.pi / 4])
    step[:3, 3] = 1, 0, 0
    graph, pose = r.PoseGraph(), np.eye(4)
    for i in range(8):
        graph.nodes.append(r.PoseGraphNode(pose))
        noise = np.eye(4)
        noise[:3, :3] = o3d.geometry.get_rotation_matrix_from_xyz(random.normal(0, 0.01, 3))
        graph.edges.append(r.PoseGraphEdge((i + 1) % 8, i, step @ noise, np.eye(6) * 100, uncertain=i == 7))
        pose = pose @ step @ noise
    for kind in ("fragment", "global"):
        o3d.io.write_pose_graph(place(f"DemoPoseGraphOptimization/pose_graph_example_{kind}.json"), graph)
    o3d.io.write_pose_graph(place("stand_ins/graph.json"), graph)


class Window:
    """A window that shows nothing: it records its geometries, and its event loop ends at once."""

    drawn: list[Any]

    def __init__(self, *_: Any, **__: Any):
        pass

    def add_geometry(self, geometry: Any, *_: Any, **__: Any) -> bool:
        self.drawn.append(geometry)
        return True

    def create_window(self, *_: Any, **__: Any) -> bool:
        return True

    def poll_events(self) -> bool:
        return False

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return Anything()


class Anything:
    """The result of a control of a window: it can be called, and has all attributes."""

    def __len__(self) -> int:
        return 0

    def __float__(self) -> float:
        return 0.0

    def __call__(self, *_: Any, **__: Any) -> Any:
        return self

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return self


WINDOWS = ("Visualizer", "VisualizerWithKeyCallback", "VisualizerWithEditing")
DRAWS = ("draw_geometries", "draw", "draw_geometries_with_editing", "draw_geometries_with_vertex_selection",
         "draw_geometries_with_animation_callback", "draw_geometries_with_key_callbacks",
         "draw_geometries_with_custom_animation", "draw_plotly")  # fmt: skip


def replace(package: ModuleType, data: ModuleType, folder: Path | None) -> list[Any]:
    """Replace windows, data sets and missing files of a package. Return the list of drawn geometries.

    Without a folder, only windows are replaced.
    """
    drawn: list[Any] = []
    window = type("Window", (Window,), {"drawn": drawn})

    def draw(shapes: Any = (), *_: Any, **__: Any) -> None:
        drawn.extend(shapes if isinstance(shapes, list | tuple) else [shapes])

    for name in DRAWS:
        setattr(package.visualization, name, draw)
    for name in WINDOWS:
        setattr(package.visualization, name, window)
    if folder is None:
        return drawn
    package.data = data
    for module in (package.io, package.t.io):
        for name in READERS:
            if hasattr(module, name):
                setattr(module, name, _reader(getattr(module, name), name, folder / "stand_ins"))
    return drawn


def _reader(read: Any, name: str, folder: Path) -> Any:
    def read_or_replace(filename: Any = None, *given: Any, **options: Any) -> Any:
        path = Path(str(filename if filename is not None else options.pop("filename")))
        if not path.is_file():
            path = _stand_in(name, path, folder)
        return read(str(path), *given, **options)

    return read_or_replace


def _stand_in(name: str, path: Path, folder: Path) -> Path:
    suffix = path.suffix.lower()
    if name == "read_image":
        return folder / (
            "depth.png" if "depth" in str(path).lower() else "color.jpg" if suffix == ".jpg" else "color.png"
        )
    stem = {"read_point_cloud": "cloud", "read_triangle_mesh": "mesh", "read_pose_graph": "graph"}.get(name, "none")
    return folder / f"{stem}{suffix}" if (folder / f"{stem}{suffix}").is_file() else path


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    make(parser.parse_args().folder)

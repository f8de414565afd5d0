"""Public readers of one file, by format: clouds, meshes, splats, cameras, images, tables, recordings.

The bytes of sound files come from the writers, or are short texts. Formats with an independent parser are in cases.py.
"""

from __future__ import annotations

import base64
import io
import shutil
import tempfile
import warnings
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import job_cases
import mutations
import numpy as np
import other_cases
import PIL.Image
from job_cases import anything, arrays, values

import pointloom as loom
from pointloom.cli.jobs.evaluate import read_extrinsic
from pointloom.cli.jobs.info import describe
from pointloom.core.paths import RECORDINGS
from pointloom.io.file_formats import CloudFormat, MeshFormat
from pointloom.io.images.photo_files import read_exif, read_photo
from pointloom.io.meshes.mesh_formats import MESH_FORMATS
from pointloom.io.points.formats import CLOUD_FORMATS, WRITTEN
from pointloom.io.splats.splat_files import EXTENSIONS
from pointloom.photogrammetry.depth.estimation import read_distances
from pointloom.photogrammetry.video.control_files import read_ground_control
from pointloom.visualization.viewer.view_files import read_geometry

Seeds = Callable[[], list[bytes]]


def written(suffix: str, *writers: Callable[[Path], Any]) -> Seeds:
    """The files that functions write to a path with this suffix."""

    def seeds() -> list[bytes]:
        contents = []
        with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
            warnings.simplefilter("ignore")
            for number, write in enumerate(writers):
                write(path := Path(folder) / f"{number}{suffix}")
                contents.append(path.read_bytes())
        return contents

    return seeds


def text(*contents: str) -> Seeds:
    """Files of text."""
    return lambda: [content.encode() for content in contents]


def cloud() -> loom.PointCloud:
    rng = np.random.default_rng(8)
    return loom.PointCloud(rng.random((6, 3)), colors=rng.random((6, 3)), intensity=np.arange(6, dtype=np.uint16))


def mesh(*, textured: bool = False) -> loom.TriangleMesh:
    made = loom.TriangleMesh.create_box()
    if textured:
        made.triangle_uvs = np.random.default_rng(9).random((3 * len(made), 2))
        made.textures = [np.full((4, 4, 3), 90, np.uint8)]
    return made


def splats() -> loom.GaussianSplats:
    rng = np.random.default_rng(10)
    rotations = np.tile([1.0, 0, 0, 0], (4, 1))
    return loom.GaussianSplats(
        rng.random((4, 3)), rng.random((4, 3)) + 0.1, rotations, rng.random(4), rng.random((4, 1, 3))
    )


def trajectory(path: Path) -> None:
    poses = np.tile(np.eye(4), (2, 1, 1))
    poses[1, 0, 3] = 1.5
    loom.write_trajectory(path, loom.Trajectory(poses))


def camera_list(path: Path) -> None:
    trajectory(log := path.with_suffix(".log"))
    import pointloom.open3d as o3d

    o3d.io.write_pinhole_camera_trajectory(path, o3d.io.read_pinhole_camera_trajectory(log))


def graph(path: Path) -> None:
    reg = loom.registration
    reg.write_pose_graph(path, reg.PoseGraph([reg.PoseGraphNode(), reg.PoseGraphNode()], [reg.PoseGraphEdge(0, 1)]))


def polygon(path: Path) -> None:
    corners = [[0, 0, 0], [4, 0, 0], [0, 4, 0]]
    loom.SelectionPolygonVolume(corners, "Z", axis_min=0, axis_max=2).to_json(path)


def view(path: Path) -> None:
    camera = loom.PinholeCameraIntrinsic(640, 480, 500.0, 500.0, 319.5, 239.5)
    pose = np.eye(4)
    pose[2, 3] = -3
    loom.write_view(path, loom.View(camera, pose), ([0, 0, 0], [1, 1, 1]))


def image(kind: str, mode: str = "RGB", **options: Any) -> bytes:
    """An image of 8 x 6 pixels."""
    buffer = io.BytesIO()
    pixels = np.random.default_rng(11).integers(0, 255, (6, 8, 3), dtype=np.uint8)
    made = PIL.Image.fromarray(pixels).convert(mode)
    made.save(buffer, kind, **options)
    return buffer.getvalue()


def photo() -> bytes:
    """A JPEG with camera, orientation, focal length and position."""
    exif = PIL.Image.Exif()
    exif.update({271: "maker", 272: "model", 274: 6})
    exif.get_ifd(0x8769).update({37386: 4.5, 41989: 28})
    exif.get_ifd(0x8825).update({1: "N", 2: (47.0, 30.0, 0.0), 3: "E", 4: (8.0, 15.0, 0.0), 6: 430.0})
    return image("JPEG", exif=exif)


def depth_png() -> bytes:
    buffer = io.BytesIO()
    PIL.Image.fromarray(np.arange(48, dtype=np.uint16).reshape(6, 8) * 100).save(buffer, "PNG")
    return buffer.getvalue()


def array(values_of_array: Any) -> bytes:
    buffer = io.BytesIO()
    np.save(buffer, values_of_array)
    return buffer.getvalue()


def recording(suffix: str) -> Seeds:
    """A recording of two texts and two IMU readings, of ROS 1 (.bag) or ROS 2 (.mcap, .db3)."""

    def seeds() -> list[bytes]:
        from rosbags import rosbag1, rosbag2
        from rosbags.typesys import Stores, get_typestore

        kind, imu, is_first = "std_msgs/msg/String", "sensor_msgs/msg/Imu", suffix == ".bag"
        store = get_typestore(Stores.ROS1_NOETIC if is_first else Stores.ROS2_HUMBLE)
        plugin = rosbag2.StoragePlugin.MCAP if suffix == ".mcap" else rosbag2.StoragePlugin.SQLITE3
        encode = store.serialize_ros1 if is_first else store.serialize_cdr
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / f"run{suffix if is_first else ''}"
            with rosbag1.Writer(path) if is_first else rosbag2.Writer(path, version=9, storage_plugin=plugin) as writer:
                connection = writer.add_connection("/text", kind, typestore=store)
                for second in range(2):
                    message = store.types[kind](f"text {second}")
                    writer.write(connection, (second + 1) * 10**9, encode(message, kind))
                connection = writer.add_connection("/imu", imu, typestore=store)
                for second in range(2):
                    writer.write(connection, (second + 1) * 10**9, encode(reading(store.types, second), imu))
            return [(path if is_first else next(path.glob(f"*{suffix}"))).read_bytes()]

    return seeds


def reading(types: Any, second: int) -> Any:
    """An Imu message."""
    stamp, header = types["builtin_interfaces/msg/Time"](second, 0), types["std_msgs/msg/Header"]
    stamped = header(0, stamp, "imu") if "seq" in header.__dataclass_fields__ else header(stamp, "imu")
    vector, rotation = types["geometry_msgs/msg/Vector3"], types["geometry_msgs/msg/Quaternion"](0.0, 0.0, 0.0, 1.0)
    values = rotation, np.zeros(9), vector(0.0, 0.0, 0.1), np.zeros(9), vector(0.0, 0.0, 9.8), np.zeros(9)
    return types["sensor_msgs/msg/Imu"](stamped, *values)


def read_recording(path: Path) -> Any:
    """Open a recording, read its IMU and list its messages."""
    recording = loom.open_recording(path)
    if "sensor_msgs/msg/Imu" in recording.topic_types().values():
        recording.imu(frame="lidar")
    return [[repr(recording), *recording.messages(topic.name)] for topic in recording.topics]


def sound_points(path: Path, result: loom.PointCloud) -> str | None:
    """Check that all attributes have as many rows as the points."""
    wrong = [name for name, column in result.attributes.items() if len(column) != len(result)]
    return f"{wrong} have other lengths" if wrong else None


def sound_surface(path: Path, result: loom.TriangleMesh) -> str | None:
    """Check that triangles are indices of vertices."""
    ends = np.asarray(result.triangles)
    if ends.size and (ends.min() < 0 or ends.max() >= len(result.vertices)):
        return "triangle indices are out of range"
    return None


TEXTS = {
    ".csv": "x,y,z,label\n1,2,3,4\n-1.5,2e3,3,5\n", ".txt": "# x y z\n1 2 3\n4 5 6\n",
    ".asc": "x y z intensity\n1 2 3 7\n4 5 6 8\n", ".obj": "v 1 2 3 0.5 0 1\nv 4 5 6 0 1 0\nvn 0 0 1\nvn 0 1 0\n",
    ".ptx": "2\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n1 2 3 0.5\n4 5 6 0.25\n",
}  # fmt: skip
BIN_ROWS = np.arange(12, dtype="<f4").tobytes()


def write_cloud(path: Path) -> None:
    """Write a cloud with the arrays that its format stores."""
    made = cloud()
    if "colors" not in CLOUD_FORMATS[path.suffix].stores:
        made.normals = np.tile([0, 0, 1.0], (6, 1))
    loom.write_point_cloud(path, made, drop_unsupported=True)


def mutation_of(format: CloudFormat | MeshFormat) -> mutations.Mutation:
    return mutations.text if format.encoding == "text" else mutations.binary


def clouds() -> list[Any]:
    """`loom.read_point_cloud` for each format."""
    seeds = {end: written(end, write_cloud) for end in (*WRITTEN, ".copc.laz")}
    seeds |= {end: text(content) for end, content in TEXTS.items()} | {".bin": lambda: [BIN_ROWS]}
    return [
        (
            f"cloud {end}", end, made, mutation_of(CLOUD_FORMATS[Path(f"a{end}").suffix]), loom.read_point_cloud,
            sound_points,
        )
        for end, made in seeds.items()
    ]  # fmt: skip


def write_mesh(path: Path) -> None:
    loom.write_triangle_mesh(path, mesh())


PACKED_POINTS = zlib.compress(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], "<f4").tobytes())


def write_textured(path: Path) -> None:
    loom.write_triangle_mesh(path, mesh(textured=True))


def write_ascii(path: Path) -> None:
    loom.write_triangle_mesh(path, mesh(), write_ascii=True)


# A triangle with its points in base64, one compressed block each.
VTP = b"""<VTKFile type="PolyData" byte_order="LittleEndian" compressor="vtkZLibDataCompressor"><PolyData>
<Piece NumberOfPoints="3" NumberOfPolys="1"><Points><DataArray type="Float32" NumberOfComponents="3" format="binary">
%s%s</DataArray></Points><Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">3</DataArray></Polys></Piece></PolyData></VTKFile>""" % (
    base64.b64encode(np.array([1, 36, 0, len(PACKED_POINTS)], "<u4").tobytes()),
    base64.b64encode(PACKED_POINTS),
)


def meshes() -> list[Any]:
    """`loom.read_triangle_mesh` for each format."""
    seeds = {end: written(end, write_mesh) for end in MESH_FORMATS}
    seeds |= {end: written(end, write_mesh, write_textured) for end in (".ply", ".glb")}
    seeds |= {".vtk": written(".vtk", write_mesh, write_ascii), ".vtp": lambda: [*written(".vtp", write_mesh)(), VTP]}
    seeds |= {".gltf": other_cases.gltfs}
    return [
        (f"mesh {end}", end, made, mutation_of(MESH_FORMATS[end]), loom.read_triangle_mesh, sound_surface)
        for end, made in seeds.items()
    ]  # fmt: skip


def splat_files() -> list[Any]:
    """`loom.read_splats` for each format."""
    return [
        (
            f"splats {end}", end, written(end, lambda p: loom.write_splats(p, splats())), mutations.binary,
            loom.read_splats, anything,
        )
        for end in EXTENSIONS
    ]  # fmt: skip


GCP = "EPSG:32632\n447000 5260000 410 320 240 a.jpg A\n447000 5260000 410 100 240 b.jpg A\n"
BARS = "bar A B 2 0.01\nmark A a.jpg 1 2\nmark B a.jpg 3 4\nmark A b.jpg 1 2\nmark B b.jpg 3 4\n"
GCP_CSV = "# crs EPSG:25832\nname,x,y,z,image,column,row\nA,447000,5260000,410,a.jpg,320,240\nmark B b.jpg 1 2\n"
CONTROL = "name,x,y,z,sigma\nA,1,2,3,0.01\nB,4,5,6,0.02\n"
TARGETS = "station,name,x,y,z\n0,A,1,2,3\n1,A,4,5,6\n"
MATRIX = "1 0 0 0\n0 1 0 0\n0 0 1 2\n0 0 0 1\n"
POSITIONS = "a 1 0 0\nb 3 0 0.5\n"
GNSS = ["0 1 2 3\n1 2 3 4\n", "time,x,y,z,sigma\n0,1,2,3,0.5\n1,2,3,4,0.5\n", "0 1 2 3 0 0 0 1\n1 2 3 4 0 0 0 1\n"]
NAMES = ["0001_a.jpg", "0002_b.jpg"]


def _places(path: Path) -> Any:
    return loom.photogrammetry.read_image_positions([path])


def _describe_folder(path: Path) -> Any:
    shutil.rmtree(folder := path.parent / "several", ignore_errors=True)
    folder.mkdir()
    shutil.copyfile(path, folder / path.name)
    report = describe(folder)
    if "Error" in str(report.broken) and "FileError" not in str(report.broken):
        raise ValueError(report.broken)
    return [repr(report), report.fields(), report.to_dict()]


def _plan(path: Path) -> Any:
    """Plan a job with steps. Errors may name a file that the steps name."""
    shutil.rmtree(folder := path.parent / "planned", ignore_errors=True)
    try:
        return loom.tiling.plan_tiles([job_cases.job().parent / "in.laz"], path, folder)
    except loom.FileError as error:
        if error.path == str(path) or not Path(error.path).is_absolute():
            raise
        raise loom.FileError(path, str(error)) from error


# name, suffix, seeds, mutate, read, oracle: as in cases.Case
PUBLIC = [
    *clouds(),
    *meshes(),
    *splat_files(),
    ("chunks of LAS", ".laz", written(".laz", write_cloud), mutations.binary, lambda p: list(loom.read_las_chunks(p)),
     anything),
    ("chunks of E57", ".e57", written(".e57", write_cloud), mutations.binary, lambda p: list(loom.read_e57_chunks(p)),
     anything),
    ("raster .tif", ".tif", written(".tif", lambda p: loom.rasterize(cloud(), 0.25, "dsm").write(p)), mutations.binary,
     loom.read_raster, anything),
    ("COPC", ".copc.laz", written(".copc.laz", write_cloud), mutations.binary, loom.read_copc, sound_points),
    ("detail tree", ".ply", written(".ply", write_cloud), mutations.binary, loom.DetailTree.from_file, anything),
    ("detail tree .xyz", ".xyz", written(".xyz", write_cloud), mutations.text, loom.DetailTree.from_file, anything),
    ("viewed file .npz", ".npz", written(".npz", write_cloud, job_cases.write_volume), arrays, read_geometry, anything),
    ("viewed file .json", ".json", written(".json", camera_list, polygon), values, read_geometry, anything),
    ("stations .e57", ".e57", written(".e57", write_cloud), mutations.binary, loom.read_stations, anything),
    ("stations .ptx", ".ptx", text(TEXTS[".ptx"]), mutations.text, loom.read_stations, anything),
    ("trajectory .json", ".json", written(".json", camera_list), values, loom.read_trajectory, anything),
    ("pose graph", ".json", written(".json", graph), values, loom.registration.read_pose_graph, anything),
    ("polygon volume", ".json", written(".json", polygon), values, loom.SelectionPolygonVolume.from_json, anything),
    ("view", ".json", written(".json", view), values, loom.read_view, anything),
    ("positions", ".txt", text(POSITIONS), mutations.text,
     lambda p: loom.registration.read_positions(p, NAMES), anything),
    ("given positions", ".txt", text(*GNSS), mutations.text, loom.registration.PositionReadings.read, anything),
    ("cameras of frames", ".json", job_cases.transforms, values, loom.read_cameras, anything),
    ("color .png", ".png", lambda: [image("PNG"), image("PNG", "P")], mutations.binary, loom.read_color, anything),
    ("color .jpg", ".jpg", lambda: [image("JPEG"), image("JPEG", "CMYK")], mutations.binary, loom.read_color, anything),
    ("depth .png", ".png", lambda: [depth_png()], mutations.binary, loom.read_depth, anything),
    ("depth .npy", ".npy", lambda: [array(np.ones((3, 4), np.float32))], mutations.binary, loom.read_depth, anything),
    ("photo .tif", ".tif", lambda: [image("TIFF"), image("TIFF", compression="tiff_lzw")], mutations.binary,
     read_photo, anything),
    ("photo .webp", ".webp", lambda: [image("WEBP"), image("WEBP", "RGBA")], mutations.binary, read_photo, anything),
    ("EXIF", ".jpg", lambda: [photo()], mutations.binary, read_exif, anything),
    ("positions of photos", ".jpg", lambda: [photo()], mutations.binary, _places, anything),
    *((f"recording {end}", end, recording(end), mutations.binary, read_recording, anything)
      for end in RECORDINGS),
    ("ground control", ".txt", text(GCP), mutations.text, read_ground_control, anything),
    ("ground control .csv", ".csv", text(GCP_CSV), mutations.text, read_ground_control, anything),
    ("scale bars", ".txt", text(BARS), mutations.text,
     lambda p: read_ground_control(None, scale_bars=p), anything),
    ("control of stations", ".csv", text(CONTROL), mutations.text,
     loom.registration.read_control_points, anything),
    ("targets of stations", ".csv", text(TARGETS), mutations.text,
     lambda p: loom.registration.read_targets(p, ["A", "B"]), anything),
    ("extrinsic", ".txt", text(MATRIX), mutations.text, read_extrinsic, anything),
    ("described .txt", ".txt", text(MATRIX, "525 0 80\n0 525 60\n0 0 1\n"), mutations.text, describe, anything),
    ("described .json", ".json", written(".json", camera_list, graph, polygon, view), values, describe, anything),
    ("described folder", ".ply", written(".ply", write_cloud), mutations.binary, _describe_folder, anything),
    ("distances", ".txt", text("u v meters\n1 2 3.5\n2 3 4\n"), mutations.text, read_distances, anything),
    ("steps of a job", ".toml", job_cases.steps, mutations.text, _plan, anything),
]  # fmt: skip

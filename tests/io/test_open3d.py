"""Files written by Open3D are read (stored copies in quick tests), and Open3D reads files written by pointloom."""

from contextlib import nullcontext
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.cameras.camera import PinholeCameraIntrinsic
from pointloom.cameras.trajectory import Trajectory, read_trajectory, write_trajectory
from pointloom.io.color_space import linear_to_srgb
from pointloom.io.images.image_files import read_color, read_depth, write_png
from pointloom.io.meshes.by_extension import write_mesh
from pointloom.io.points.by_extension import read_points, write_table
from pointloom.io.points.codecs import WriteOptions
from pointloom.io.points.pcd import read_pcd, write_pcd
from pointloom.io.points.ply import read_ply, read_ply_mesh
from pointloom.io.points.text import read_text
from pointloom.io.table import MeshTable, PointTable
from pointloom.kernels.linear_algebra import inv

from ..pcd.test_splats import made
from ..scan_cases import on_sets
from .textured_meshes import CORNERS, IMAGE, seen_at_corners, square

CLOUDS = ["binary.ply", "ascii.ply", "binary.pcd", "ascii.pcd", "binary_compressed.pcd", "a.xyz", "a.xyzn", "a.xyzrgb",
          "a.pts"]  # fmt: skip
MESHES = ["m.ply", "m.stl", "m.off", "m.glb", "m.obj"]
PATHS = ["t.log", "t.txt", "t.json"]
SPLATS = ["s.ply", "s.splat", "s.spz"]
FLIP = np.diag([1.0, -1, -1])  # of y and z, for SPZ, which Open3D does not convert


def files_of_open3d(o3d, write, name, *content):
    """The bytes of the files written by Open3D, by name."""
    with TemporaryDirectory() as folder:
        write(o3d, Path(folder) / name, *content)
        return {path.name: np.frombuffer(path.read_bytes(), np.uint8) for path in sorted(Path(folder).iterdir())}


@pytest.fixture
def open3d_file(oracle, tmp_path):
    def path(write, name, *content):
        for file, data in oracle(f"io/{name}", files_of_open3d, write, name, *content).items():
            (tmp_path / file).write_bytes(data.tobytes())
        return tmp_path / name

    return path


def cloud(name):
    """30 points with the normals, colors and attributes that the format supports."""
    rng, suffix = np.random.default_rng(4), Path(name).suffix
    is_text = suffix not in (".ply", ".pcd")
    points, normals = rng.normal(size=(2, 30, 3)).astype(np.float32)
    colors = (rng.integers(0, 256, (30, 3)) / 255).astype(np.float32)
    attributes = {"intensity": rng.random(30).astype(np.float32)}
    if suffix == ".ply":
        attributes["time"] = rng.random(30)
    return PointTable(
        points.astype(np.float64) if is_text else points,
        normals if not is_text or suffix == ".xyzn" else None,
        colors if not is_text or suffix in (".xyzrgb", ".pts") else None,
        {} if is_text else attributes,
    )


def write_cloud(o3d, path, table):
    o3d_cloud = o3d.t.geometry.PointCloud(o3d.core.Tensor(table.points))
    if table.normals is not None:
        o3d_cloud.point.normals = o3d.core.Tensor(table.normals)
    if table.colors is not None:
        o3d_cloud.point.colors = o3d.core.Tensor(np.rint(table.colors * 255).astype(np.uint8))
    for name, values in table.attributes.items():
        o3d_cloud.point[name] = o3d.core.Tensor(values[:, None])
    if path.suffix in (".ply", ".pcd"):
        how = {"write_ascii": path.stem == "ascii", "compressed": path.stem == "binary_compressed"}
        assert o3d.t.io.write_point_cloud(str(path), o3d_cloud, **how)
    else:
        assert o3d.io.write_point_cloud(str(path), o3d_cloud.to_legacy())


def assert_same_cloud(result, expected, tolerance):
    for name in ("points", "normals", "colors"):
        left, right = getattr(result, name), getattr(expected, name)
        assert (left is None) == (right is None), name
        if right is not None:
            np.testing.assert_allclose(left, right, rtol=tolerance, atol=1e-7 if name == "colors" else tolerance)
    for name, values in expected.attributes.items():
        np.testing.assert_allclose(np.ravel(result.attributes[name]), values, rtol=tolerance, atol=tolerance)


@pytest.mark.parametrize("name", CLOUDS)
def test_clouds_of_open3d_are_read(open3d_file, name):
    path = open3d_file(write_cloud, name, cloud(name))
    assert path.suffix != ".pcd" or f"DATA {path.stem}".encode() in path.read_bytes()
    digits = 2e-5 if path.stem == "ascii" else 1e-9 if path.stem == "a" else 0  # Open3D prints 6 digits, or 10
    assert_same_cloud(read_points(path), cloud(name), digits)


@pytest.mark.parametrize("name", CLOUDS)
def test_open3d_reads_written_clouds(o3d, tmp_path, name):
    path, table = tmp_path / name, cloud(name)
    if path.suffix == ".pcd":
        write_pcd(path, table, encoding=path.stem)
    else:
        write_table(path, table, WriteOptions(ascii=path.stem == "ascii", overwrite=True))
    if path.suffix in (".ply", ".pcd"):
        point = o3d.t.io.read_point_cloud(str(path)).point
        colors = np.float32(point.colors.numpy()) / np.float32(255)
        result = PointTable(point.positions.numpy(), point.normals.numpy(), colors)
        result.attributes = {name: point[name].numpy() for name in table.attributes}
    else:
        read = o3d.io.read_point_cloud(str(path))
        result = PointTable(
            np.asarray(read.points),
            np.asarray(read.normals) if read.has_normals() else None,
            np.asarray(read.colors) if read.has_colors() else None,
        )
    assert_same_cloud(result, table, 0 if path.suffix in (".ply", ".pcd") else 1e-7)


@on_sets(
    "pattern count",
    shipped=[("cloud-cupoch/*.pcd", 1), ("lidar-pcl-terrain/*.pcd", 7), ("pcl-tests/**/*.pcd", 2)],
    real=[
        ("cloud-cupoch/*.pcd", 1), ("lidar-pcl-terrain/*.pcd", 19), ("pcl-tests/**/*.pcd", 5),
        ("pcl-data-tutorials/**/*.pcd", 5), ("mvs-openmvs-sample/*.ply", 2), ("reg-cilantro/**/*.ply", 2),
        ("reg-small-gicp/**/*.ply", 2), ("reg-teaser-3dmatch/**/*.ply", 2), ("reg-bunny-scans/**/*.ply", 12),
        ("reg-simpleicp/*.xyz", 4), ("mesh-points2surf-abc/04_pts_vis/*.xyz", 1),
    ],
)  # fmt: skip
def test_real_clouds_agree_with_open3d(o3d, scan_file, pattern, count):
    folder, _, names = pattern.partition("/")
    paths = list(scan_file(folder).glob(names))
    assert len(paths) == count
    for real in paths:
        expected = o3d.io.read_point_cloud(str(real), remove_nan_points=False, remove_infinite_points=False)
        table = {".ply": read_ply, ".pcd": read_pcd, ".xyz": read_text}[real.suffix](real)
        np.testing.assert_array_equal(table.points, np.asarray(expected.points).astype(table.points.dtype))
        assert (table.normals is not None, table.colors is not None) == (expected.has_normals(), expected.has_colors())
        if table.normals is not None:
            np.testing.assert_array_equal(table.normals, np.asarray(expected.normals).astype(np.float32))
        if table.colors is not None:
            np.testing.assert_allclose(table.colors, np.asarray(expected.colors), atol=1e-7)


def mesh(name):
    """A closed surface with the normals and colors that each format supports; the square for OBJ."""
    if name == "m.obj":
        return square()
    corners = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], np.float32)
    normals, colors = corners / np.float32(3**0.5), np.float32([[255, 0, 51], [0, 102, 0], [0, 0, 153], [255, 255, 0]])
    table = MeshTable(corners * np.float32(1.234567), np.array([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]))
    if name != "m.stl":
        table.vertex_normals, table.vertex_colors = normals, colors / np.float32(255)
    return table


def write_open3d_mesh(o3d, path, table):
    vector = o3d.utility.Vector3dVector
    o3d_mesh = o3d.geometry.TriangleMesh(vector(table.vertices), o3d.utility.Vector3iVector(table.triangles))
    if table.textures:
        o3d_mesh.triangle_uvs = o3d.utility.Vector2dVector(table.triangle_uvs)
        o3d_mesh.textures = [o3d.geometry.Image(np.ascontiguousarray(IMAGE[::-1]))]
        o3d_mesh.triangle_material_ids = o3d.utility.IntVector([0, 0])
    elif table.vertex_normals is None:
        o3d_mesh.compute_triangle_normals()
    else:
        o3d_mesh.vertex_normals, o3d_mesh.vertex_colors = vector(table.vertex_normals), vector(table.vertex_colors)
    assert o3d.io.write_triangle_mesh(str(path), o3d_mesh)


def corners_of(mesh):
    """Position, normal and color of the corners of each triangle, sorted."""
    columns = [mesh.vertices, mesh.vertex_normals, mesh.vertex_colors]
    values = np.hstack([np.asarray(column, np.float64) for column in columns if column is not None])
    rows = values[np.asarray(mesh.triangles)].reshape(len(mesh.triangles), -1)
    return rows[np.lexsort(np.round(rows, 3).T)]


@pytest.mark.parametrize("name", MESHES)
def test_meshes_of_open3d_are_read(open3d_file, name):
    result = loom.read_triangle_mesh(open3d_file(write_open3d_mesh, name, mesh(name)))
    if name == "m.obj":
        assert seen_at_corners(result) == CORNERS
        return
    expected = mesh(name)
    if name == "m.glb":  # Open3D writes colors unchanged, which are linear light in the standard
        expected.vertex_colors = linear_to_srgb(expected.vertex_colors)
    digits = {"m.off": 1e-5, "m.glb": 1 / 255}.get(name, 1e-7)  # 6 digits; colors of 8 bits
    np.testing.assert_allclose(corners_of(result), corners_of(expected), rtol=0, atol=digits)
    assert result.is_watertight() or name == "m.glb"


@pytest.mark.parametrize("name", [*MESHES, "m.gltf"])
def test_open3d_reads_written_meshes(o3d, tmp_path, name):
    table = mesh(name)
    write_mesh(tmp_path / name, table, ascii=False, overwrite=True)
    read = o3d.io.read_triangle_mesh(str(tmp_path / name))
    result = MeshTable(np.asarray(read.vertices), np.asarray(read.triangles))
    if not table.textures:
        if table.vertex_normals is not None:
            result.vertex_normals = np.asarray(read.vertex_normals)
            result.vertex_colors = np.asarray(read.vertex_colors)
            if Path(name).suffix in (".glb", ".gltf"):  # Open3D reads colors unchanged, which are linear light
                result.vertex_colors = linear_to_srgb(result.vertex_colors)
        np.testing.assert_allclose(corners_of(result), corners_of(table), rtol=0, atol=1e-6)


@pytest.mark.parametrize("suffix", [".obj", ".glb", ".gltf"])
def test_open3d_reads_written_textures_upright(o3d, tmp_path, suffix):
    write_mesh(tmp_path / f"m{suffix}", square(), ascii=False, overwrite=True)
    read = o3d.io.read_triangle_mesh(str(tmp_path / f"m{suffix}"))
    (flipped,) = [image for image in map(np.asarray, read.textures) if image.ndim == 3]  # the other is assimp's
    vertices, triangles, uvs = map(np.asarray, (read.vertices, read.triangles, read.triangle_uvs))
    result = MeshTable(vertices, triangles, triangle_uvs=uvs)
    result.textures = (flipped[::-1],)  # Open3D stores images with the lowest row first
    assert seen_at_corners(result) == CORNERS


def test_real_meshes_agree_with_open3d(o3d, real_file):
    for name in (
        *("reg-bunny-scans/reconstruction/bun_zipper.ply", "reg-bunny-scans/reconstruction/bun_zipper_res2.ply"),
        "mvs-openmvs-sample/scene_mesh.ply",
        "mesh-common3d/fandisk.obj",
        "mesh-points2surf-abc/03_meshes/00011084_fddd53ce45f640f3ab922328_trimesh_019.ply",
    ):
        real = real_file(name)
        expected = o3d.io.read_triangle_mesh(str(real))
        result = loom.read_triangle_mesh(real) if real.suffix == ".obj" else read_ply_mesh(real)
        corners = [np.asarray(read.vertices)[np.asarray(read.triangles)] for read in (result, expected)]
        facets, rtol = [rows.astype(np.float32).reshape(-1, 9) for rows in corners], 0.0
        if real.suffix == ".obj":  # its order differs, and its decimals are rounded to the nearest float32
            facets, rtol = [rows[np.lexsort(rows.T)] for rows in facets], 2.5e-7
        np.testing.assert_allclose(*facets, rtol=rtol)


def trajectory():
    rotations = Rotation.random(6, random_state=0).as_matrix()
    rotations[:2] = Rotation.from_quat([[1, 0, 0, 0], [0.6, 0.8, 0, 0]]).as_matrix()  # rotations by 180 degrees
    poses = np.tile(np.eye(4), (6, 1, 1))
    poses[:, :3, :3], poses[:, :3, 3] = rotations, np.random.default_rng(0).normal(size=(6, 3)) * (1, 10, 100)
    return Trajectory(poses)


def write_open3d_path(o3d, path, poses):
    cameras = []
    for T_camera_world in inv(poses):  # of NumPy, it depends on the processor
        camera = o3d.camera.PinholeCameraParameters()
        camera.intrinsic = o3d.camera.PinholeCameraIntrinsic(640, 480, 525.0, 525.0, 319.5, 239.5)
        camera.extrinsic = T_camera_world
        cameras.append(camera)
    content = o3d.camera.PinholeCameraTrajectory()
    content.parameters = cameras
    assert o3d.io.write_pinhole_camera_trajectory(str(path), content)


@pytest.mark.parametrize("name", PATHS)
def test_trajectories_of_open3d_are_read(open3d_file, name):
    """Every pose to 6 decimals, including the first one of a .txt file, which Open3D itself skips after its comment."""
    result = read_trajectory(open3d_file(write_open3d_path, name, trajectory().poses))
    np.testing.assert_allclose(result.poses, trajectory().poses, rtol=0, atol=1e-11 if name == "t.json" else 3e-6)


@pytest.mark.parametrize("name", PATHS)
def test_open3d_reads_written_trajectories(o3d, tmp_path, name):
    camera = PinholeCameraIntrinsic.prime_sense_default()
    write_trajectory(tmp_path / name, trajectory(), format="tum" if name == "t.txt" else None, intrinsic=camera)
    cameras = o3d.io.read_pinhole_camera_trajectory(str(tmp_path / name)).parameters
    poses = np.linalg.inv([np.asarray(camera.extrinsic) for camera in cameras])
    np.testing.assert_allclose(poses, trajectory().poses, rtol=0, atol=1e-11)


def write_open3d_splats(o3d, path):
    splats, o3d_cloud = made(40, 2), o3d.t.geometry.PointCloud()
    columns = {"positions": splats.centers, "scale": splats.scales, "rot": splats.rotations}
    columns |= {"f_dc": splats.cloud["f_dc"], "opacity": splats.cloud["opacity"][:, None]}
    for name, values in (columns | {"f_rest": splats.harmonics[:, 1:]}).items():
        o3d_cloud.point[name] = o3d.core.Tensor(np.ascontiguousarray(values, np.float32))
    assert o3d.t.io.write_point_cloud(str(path), o3d_cloud)


def splats_in_open3d(o3d, path):
    point = o3d.t.io.read_point_cloud(str(path)).point
    names = ("positions", "scale", "opacity", "rot", "f_dc", "f_rest")
    return {name: point[name].numpy() for name in names if name in point}


def written_and_read(o3d, name):
    with TemporaryDirectory() as folder:
        write_open3d_splats(o3d, Path(folder) / name)
        return splats_in_open3d(o3d, Path(folder) / name)


def assert_same_splats(splats, expected):
    np.testing.assert_array_equal(splats.centers, expected["positions"])
    np.testing.assert_allclose(splats.scales, expected["scale"], rtol=1e-6)
    np.testing.assert_allclose(splats.cloud["opacity"], expected["opacity"][:, 0], atol=1e-6)
    np.testing.assert_allclose(splats.harmonics[:, 0], expected["f_dc"], atol=1e-6)
    axes = Rotation.from_quat(np.roll(expected["rot"], -1, axis=1)).as_matrix() * expected["scale"][:, None]
    np.testing.assert_allclose(splats.covariances(), axes @ axes.transpose(0, 2, 1), rtol=1e-4, atol=1e-5)
    if "f_rest" in expected and expected["f_rest"].size:
        np.testing.assert_allclose(splats.harmonics[:, 1:], expected["f_rest"], atol=1e-6)


def as_in_open3d(splats, name):
    return splats.rotate(FLIP, center=[0, 0, 0]) if name == "s.spz" else splats


@pytest.mark.parametrize("name", SPLATS)
def test_splats_of_open3d_are_read(open3d_file, oracle, name):
    result = as_in_open3d(loom.read_splats(open3d_file(write_open3d_splats, name)), name)
    assert_same_splats(result, oracle(f"io/read_{name}", written_and_read, name))


@pytest.mark.parametrize("name", SPLATS)
def test_open3d_reads_our_splats(o3d, tmp_path, name):
    with pytest.warns(UserWarning, match="f_rest left out") if name == "s.splat" else nullcontext():
        loom.write_splats(tmp_path / name, made(40, 2))
    assert_same_splats(as_in_open3d(loom.read_splats(tmp_path / name), name), splats_in_open3d(o3d, tmp_path / name))


def test_open3d_reads_our_images(o3d, tmp_path):
    rng = np.random.default_rng(0)
    depth, color = rng.integers(0, 2**16, (24, 32), np.uint16), rng.integers(0, 256, (24, 32, 3), np.uint8)
    for array in (depth, color, color[:, :, 0]):
        write_png(tmp_path / "p.png", array)
        assert np.array_equal(np.asarray(o3d.io.read_image(str(tmp_path / "p.png"))), array)


@on_sets("name", shipped=["rgbd-cupoch-redwood5/depth/00004"], real=["rgbd-7scenes-redkitchen/frame-000007.depth"])
def test_real_depth_is_read_as_open3d_reads_it(o3d, scan_file, name):
    path = scan_file(f"{name}.png")
    assert np.array_equal(read_depth(path), np.asarray(o3d.io.read_image(str(path))))


def test_real_color_is_read_as_open3d_reads_it(o3d, shipped_file):
    path = shipped_file("rgbd-cupoch-redwood5/color/00004.jpg")
    expected = np.asarray(o3d.io.read_image(str(path))).astype(int)
    assert np.abs(read_color(path).astype(int) - expected).max() <= 3  # two JPEG decoders round differently

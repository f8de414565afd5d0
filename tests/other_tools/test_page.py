"""The examples of docs/other-tools.md, each with the packages that are installed."""

import contextlib
import importlib.metadata
import importlib.util
import re
import warnings

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom

from ..page_blocks import blocks_of
from ..test_imports import ROOT

HERE = "tests/other_tools/test_page.py"
MODULES = {"rerun-sdk": "rerun", "foxglove-sdk": "foxglove"}
PAGE_TEXT = (ROOT / "docs/other-tools.md").read_text()
BLOCKS = [block for block in blocks_of("docs/other-tools.md") if HERE in (block.reason or "")]


def needs(reason: str) -> list[str]:
    """Modules of the packages that a block needs."""
    names = re.findall(r"[\w-]+", reason.partition(";")[0].removeprefix("needs"))
    return [MODULES.get(name, name) for name in names if name != "and"]


def test_the_page_has_an_example_of_each_tool():
    modules = {name for block in BLOCKS for name in needs(block.reason or "")}
    assert modules == {"torch", "jax", "open3d", "trimesh", "pyvista", "polyscope", "viser", "rerun", "foxglove",
                       "pycolmap", "gsplat"}  # fmt: skip


@pytest.mark.parametrize("block", BLOCKS, ids=lambda block: "-".join(needs(block.reason)) + f"-line-{block.line}")
def test_an_example_runs(block, tmp_path, monkeypatch):
    for name in needs(block.reason):
        if importlib.util.find_spec(name) is None:
            pytest.skip(f"{name} is not installed. `make test-other-tools` runs this example")
    monkeypatch.chdir(tmp_path)
    names, drawn = {"__name__": "page"}, []
    with warnings.catch_warnings():
        warnings.simplefilter("default")  # other packages warn of their own dependencies
        if "polyscope" in block.code:
            import polyscope

            start = polyscope.init
            monkeypatch.setattr(polyscope, "init", lambda: start("openGL_mock"))  # there is no display
            monkeypatch.setattr(polyscope, "show", lambda: None)
        if "viser" in block.code:
            import viser

            add = viser.SceneApi.add_point_cloud
            record = lambda *given, **options: drawn.append(add(*given, **options))  # noqa: E731
            monkeypatch.setattr(viser.SceneApi, "add_point_cloud", record)
        exec(compile(block.source(), block.page, "exec"), names)
    if "server" in names:
        names["server"].stop()
        np.testing.assert_allclose(drawn[0].points, names["cloud"].points, rtol=0, atol=1e-7)
    if isinstance(names.get("back"), loom.TriangleMesh):
        np.testing.assert_allclose(names["back"].vertices, names["mesh"].vertices, atol=1e-7)
        np.testing.assert_array_equal(names["back"].triangles, names["mesh"].triangles)
    if "legacy" in names:
        np.testing.assert_allclose(names["back"].points, names["cloud"].points, atol=1e-7)
        np.testing.assert_array_equal(names["again"].points, names["cloud"].points)
        np.testing.assert_array_equal(names["mesh_back"].triangles, names["mesh"].triangles)
        assert names["tensor"].point.positions.numpy().ctypes.data == names["cloud"].array("points").ctypes.data
    if "reconstruction" in names:
        assert names["reconstruction"].num_images() == 2


def cloud_of_100() -> loom.PointCloud:
    return loom.PointCloud(np.random.default_rng(0).random((100, 3)) - 0.5)


def test_a_tensor_and_its_cloud_show_what_is_written_to_the_other():
    torch = pytest.importorskip("torch", exc_type=ImportError)
    points = torch.rand(100, 3) - 0.5
    cloud = loom.PointCloud(points)
    points[0] = torch.tensor([0.25, 0.5, 0.75])
    np.testing.assert_array_equal(cloud.points[0], [0.25, 0.5, 0.75])
    cloud.array("points")[1] = torch.tensor([0.75, 0.5, 0.25])
    np.testing.assert_array_equal(points[1].numpy(), [0.75, 0.5, 0.25])
    mesh = loom.TriangleMesh(points, torch.arange(99, dtype=torch.int32).reshape(33, 3))
    points[2] = torch.tensor([0.5, 0.5, 0.5])
    np.testing.assert_array_equal(mesh.vertices[2], [0.5, 0.5, 0.5])


def test_an_array_of_jax_and_its_cloud_have_the_same_memory():
    """Arrays of JAX cannot be written."""
    jax = pytest.importorskip("jax", exc_type=ImportError)
    points = jax.numpy.asarray(np.random.default_rng(0).random((100, 3), np.float32) - 0.5)
    cloud = loom.PointCloud(points)
    assert cloud.array("points").unsafe_buffer_pointer() == points.unsafe_buffer_pointer()
    np.testing.assert_array_equal(cloud.points, np.asarray(points))
    with pytest.raises((TypeError, ValueError), match=r"traced|Tracer"):
        jax.jit(lambda given: loom.PointCloud(given).cluster_dbscan(0.1, 5))(points)


def test_tensors_of_open3d_share_an_array_of_a_cloud_and_a_cloud_copies_theirs():
    o3d = pytest.importorskip("open3d", exc_type=ImportError)
    cloud = cloud_of_100()
    tensor = o3d.t.geometry.PointCloud(o3d.core.Tensor.from_numpy(cloud.array("points")))
    tensor.point.positions[0] = o3d.core.Tensor([0.25, 0.5, 0.75], o3d.core.float32)
    np.testing.assert_array_equal(cloud.points[0], [0.25, 0.5, 0.75])
    cloud.array("points")[1] = [0.75, 0.5, 0.25]
    np.testing.assert_array_equal(tensor.point.positions.numpy()[1], [0.75, 0.5, 0.25])
    back, legacy = loom.PointCloud(tensor.point.positions.numpy()), tensor.to_legacy()
    tensor.point.positions[2] = o3d.core.Tensor([0.5, 0.5, 0.5], o3d.core.float32)
    assert (back.points[2] != 0.5).all()
    assert (np.asarray(legacy.points)[2] != 0.5).all()


def test_pyvista_shares_the_points_of_a_cloud_and_copies_the_vertices_of_a_mesh():
    pyvista = pytest.importorskip("pyvista", exc_type=ImportError)
    cloud, mesh = cloud_of_100(), loom.TriangleMesh.create_box()
    data = pyvista.PolyData(cloud.array("points"))
    data.points[0] = [0.25, 0.5, 0.75]
    np.testing.assert_array_equal(cloud.points[0], [0.25, 0.5, 0.75])
    cloud.array("points")[1] = [0.75, 0.5, 0.25]
    np.testing.assert_array_equal(data.points[1], [0.75, 0.5, 0.25])
    surface = pyvista.PolyData.from_regular_faces(mesh.vertices, mesh.triangles)
    before = mesh.vertices[0].copy()
    surface.points[0] = [9.0, 9.0, 9.0]
    np.testing.assert_array_equal(mesh.vertices[0], before)


def test_other_arrays_of_numpy_are_copied():
    points = np.random.default_rng(0).random((100, 3), np.float32) - 0.5
    cloud = loom.PointCloud(points)
    points[0] = 9.0
    assert (cloud.points[0] < 1.0).all()


def test_trimesh_gets_a_copy_that_only_to_trimesh_makes_writable():
    trimesh = pytest.importorskip("trimesh", exc_type=ImportError)
    mesh = loom.TriangleMesh.create_box()
    other = trimesh.Trimesh(mesh.vertices, mesh.triangles, process=False)
    with pytest.raises(ValueError, match="read-only"):
        other.vertices[0] = [9.0, 9.0, 9.0]
    copy = mesh.to_trimesh()
    copy.vertices[0] = [9.0, 9.0, 9.0]
    assert (mesh.vertices[0] < 2.0).all()


def test_the_versions_of_the_page_are_those_that_run_its_examples():
    rows = re.findall(r"^\| \[\w+\]\(#.*\| (\w[\w-]*) (\d[\d.]+)(?=[ ,|])", PAGE_TEXT, flags=re.MULTILINE)
    packages = "torch jax open3d trimesh pyvista polyscope viser rerun-sdk foxglove-sdk pycolmap gsplat nerfstudio"
    assert set(packages.split()) <= {name for name, _ in rows}
    installed: dict[str, str] = {}
    for name, _ in rows:
        with contextlib.suppress(importlib.metadata.PackageNotFoundError):
            installed[name] = importlib.metadata.version(name).partition("+")[0]
    if "gsplat" not in installed:
        pytest.skip("the tools are not installed. `make test-other-tools` runs this test")
    assert {name: version for name, version in rows if name in installed} == installed


def test_pycolmap_reads_the_cameras_poses_points_and_tracks_of_a_model_and_writes_them_back(tmp_path):
    pycolmap = pytest.importorskip("pycolmap", exc_type=ImportError)
    rng = np.random.default_rng(0)
    cameras = [
        loom.CameraModel("PINHOLE", 640, 480, [500, 510, 320, 240]),
        loom.CameraModel("OPENCV", 600, 400, [450, 455, 300, 200, -0.1, 0.02, 0.001, -0.002]),
        loom.CameraModel("OPENCV_FISHEYE", 640, 480, [300, 305, 320, 240, -0.02, 0.002, 0.001, -0.0002]),
    ]
    poses = np.tile(np.eye(4), (3, 1, 1))
    poses[:, :3, :3] = Rotation.from_rotvec(rng.normal(size=(3, 3)) * 0.1).as_matrix()
    poses[:, :3, 3] = rng.normal(size=(3, 3)) * 0.2
    points = rng.random((50, 3)) * [2, 2, 1] + [-1, -1, 4]
    colors = rng.integers(0, 256, (50, 3)).astype(np.uint8)
    observations = np.argwhere(rng.random((3, 50)) < 0.7)
    pixels = np.concatenate(
        [cameras[i].project(points[[j]] @ poses[i, :3, :3].T + poses[i, :3, 3]) for i, j in observations]
    )
    model = loom.SfmModel(
        ["a.png", "b.png", "c.png"],
        cameras,
        poses,
        points=points,
        colors=colors,
        observations=observations,
        pixels=pixels,
    )
    loom.write_colmap_model(tmp_path / "sparse", model)
    reconstruction = pycolmap.Reconstruction(tmp_path / "sparse")
    images = {image.name: image for image in reconstruction.images.values()}
    for name, camera, T in zip(model.names, cameras, poses, strict=True):
        np.testing.assert_allclose(images[name].cam_from_world().matrix(), T[:3], atol=1e-12)
        local = points @ T[:3, :3].T + T[:3, 3]
        projected = [images[name].camera.img_from_cam(point) for point in local]
        np.testing.assert_allclose(np.array(projected) - 0.5, camera.project(local), atol=1e-3)  # float32 [px]
    written = sorted(reconstruction.points3D.values(), key=lambda point: point.xyz[0])
    order = np.argsort(points[:, 0])
    np.testing.assert_allclose([point.xyz for point in written], points[order], atol=1e-12)
    np.testing.assert_array_equal([point.color for point in written], colors[order])
    for row, point in zip(order, written, strict=True):
        seen = {(reconstruction.images[element.image_id].name, element.point2D_idx) for element in point.track.elements}
        positions = {name: images[name].points2D[number].xy - 0.5 for name, number in seen}
        of_point = observations[:, 1] == row
        wanted = {model.names[i]: xy for i, xy in zip(observations[of_point, 0], pixels[of_point], strict=True)}
        assert set(positions) == set(wanted)
        for name, xy in wanted.items():
            np.testing.assert_allclose(positions[name], xy, atol=1e-9)
    (tmp_path / "again").mkdir()
    reconstruction.write(tmp_path / "again")
    back = loom.read_cameras(tmp_path / "again")
    assert list(back.names) == list(model.names)
    np.testing.assert_allclose(back.T_camera_world, poses, atol=1e-12)
    np.testing.assert_array_equal(back.observations[:, 0], model.observations[:, 0])
    np.testing.assert_allclose(back.pixels, model.pixels, atol=1e-9)
    assert [camera.params for camera in back.cameras] == [camera.params for camera in cameras]


def test_the_reference_projection_of_gsplat_puts_centers_where_a_camera_does():
    """gsplat.rasterization needs CUDA. Its reference projection on the CPU has the same conventions."""
    torch = pytest.importorskip("torch", exc_type=ImportError)
    pytest.importorskip("gsplat", exc_type=ImportError)
    from gsplat.cuda import _torch_impl as reference

    rng = np.random.default_rng(0)
    centers = rng.random((200, 3)) - 0.5 + [0.0, 0.0, 3.0]
    quats, scales = rng.normal(size=(200, 4)), rng.uniform(0.01, 0.1, (200, 3))
    splats = loom.GaussianSplats(centers, scales, quats, np.full(200, 0.5), np.zeros((200, 3)))
    K = torch.tensor([[[500.0, 0, 320], [0, 500, 240], [0, 0, 1]]], dtype=torch.float64)
    arrays = [torch.tensor(getattr(splats, name)) for name in ("centers", "rotations", "scales")]
    covariances = reference._quat_scale_to_covar_preci(arrays[1], arrays[2])[0]
    np.testing.assert_allclose(covariances, splats.covariances(), rtol=1e-5, atol=1e-9)
    means, _ = reference._world_to_cam(arrays[0].double(), covariances.double(), torch.eye(4).double()[None])
    pixels = (means[0] @ K[0].T).numpy()
    camera = loom.CameraModel.from_intrinsic(loom.PinholeCameraIntrinsic(640, 480, 500.0, 500.0, 319.5, 239.5))
    np.testing.assert_allclose(pixels[:, :2] / pixels[:, 2:] - 0.5, camera.project(splats.centers), atol=1e-3)

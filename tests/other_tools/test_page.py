"""The examples of docs/other-tools.md, each with the packages that are installed."""

import importlib.util
import re
import warnings

import numpy as np
import pytest

import pointloom as loom

from ..page_blocks import blocks_of

HERE = "tests/other_tools/test_page.py"
MODULES = {"rerun-sdk": "rerun", "foxglove-sdk": "foxglove"}
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
    names = {"__name__": "page"}
    with warnings.catch_warnings():
        warnings.simplefilter("default")  # other packages warn of their own dependencies
        if "polyscope" in block.code:
            import polyscope

            start = polyscope.init
            monkeypatch.setattr(polyscope, "init", lambda: start("openGL_mock"))  # there is no display
            monkeypatch.setattr(polyscope, "show", lambda: None)
        exec(compile(block.source(), block.page, "exec"), names)
    if "server" in names:
        names["server"].stop()
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


def test_pyvista_and_open3d_share_the_points_of_a_cloud():
    pyvista = pytest.importorskip("pyvista", exc_type=ImportError)
    cloud = loom.PointCloud(np.random.default_rng(0).random((100, 3)) - 0.5)
    assert np.shares_memory(pyvista.PolyData(cloud.array("points")).points, cloud.array("points"))


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

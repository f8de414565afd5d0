"""Real torch and jax: arrays are shared or converted as documented, or the error names the argument and the remedy.

test_array_libraries.py compares results. `make nightly` installs the newest versions for both files.
"""

import importlib.util
import itertools
import os
import subprocess
import sys
import warnings

import numpy as np
import pytest

import pointloom as loom

from ..array_library import fake_library

torch, jax = pytest.importorskip("torch"), pytest.importorskip("jax")


@pytest.fixture(params=["torch", "jax"])
def library(request, monkeypatch):
    """A library: `make` an array of its of NumPy's, its `address`, and `read` memory by DLPack."""
    module = importlib.import_module(request.param)
    made = fake_library(request.param, "cpu", monkeypatch)
    made.read = module.from_dlpack if request.param == "torch" else importlib.import_module("jax.dlpack").from_dlpack
    made.cast = lambda array, name: (
        array.to(getattr(module, name)) if request.param == "torch" else array.astype(getattr(module.numpy, name))
    )
    return made


@pytest.fixture
def points(rng):
    return rng.random((50, 3)).astype(np.float32)


@pytest.mark.parametrize("name", ["float32", "float64", "float16", "int32", "int64", "uint8", "bool"])
def test_each_type_is_converted_for_points_and_kept_for_attributes(library, points, name):
    if library.name == "jax" and name in ("float64", "int64"):
        pytest.skip("jax has 64 bits only with jax_enable_x64")
    given = library.cast(library.make(points * 10), name)
    expected = library.host(given)
    cloud = loom.PointCloud(given, a=given)
    assert (cloud.arrays["points"].ptr == library.address(given)) == (name == "float32")
    np.testing.assert_array_equal(cloud.points, expected.astype(np.float64))
    assert cloud.arrays["a"].ptr == library.address(given) and cloud["a"].dtype == name
    np.testing.assert_array_equal(cloud["a"], expected)
    assert loom.PointCloud.from_dlpack(library.make(points), a=given).arrays["a"].ptr == library.address(given)
    if name != "float32":
        with pytest.raises(TypeError, match=f"points: expected float32, the type of a cloud's arrays, got {name}"):
            loom.PointCloud.from_dlpack(given)


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("bfloat16", "bfloat16.*convert it to float32"),
        ("float8_e5m2", "float8_e5m2.*convert it to float32"),
        ("complex64", "complex64"),
    ],
)
def test_types_that_numpy_lacks_and_complex_numbers_are_rejected(library, points, name, reason):
    ours = library.make(points)
    given = library.cast(ours, name)
    cloud = loom.PointCloud(ours)
    calls = {
        "points": [lambda: loom.PointCloud(given), lambda: setattr(cloud, "points", given)],
        "a": [lambda: loom.PointCloud(ours, a=given), lambda: loom.PointCloud.from_dlpack(ours, a=given)],
        "queries": [lambda: loom.NearestNeighborSearch(cloud).knn_search(given, 2)],
        "normals": [lambda: loom.PointCloud(ours, normals=given)],
    }
    for argument, attempts in calls.items():
        for attempt in attempts:
            with pytest.raises(TypeError, match=f"^{argument}: expected (real )?numbers, got {reason}"):
                attempt()
    with pytest.raises(TypeError, match=f"^points: expected real numbers, got {reason}"):
        loom.PointCloud.from_dlpack(given)


def test_tensors_with_strides_are_copied_or_rejected(points):
    layouts = {
        "transposed": torch.tensor(points.T.copy()).T,
        "every second row": torch.tensor(np.repeat(points, 2, axis=0))[::2],
        "columns of four": torch.tensor(np.pad(points, ((0, 0), (0, 1))))[:, :3],
        "one row repeated": torch.tensor(points[:1]).expand(50, 3),
    }
    for name, given in layouts.items():
        cloud = loom.PointCloud(given, normals=given)
        np.testing.assert_array_equal(cloud.points, given.numpy().astype(np.float64), err_msg=name)
        np.testing.assert_array_equal(cloud.normals, given.numpy(), err_msg=name)
        assert cloud.arrays["points"].ptr != given.data_ptr()
        with pytest.raises(ValueError, match=r"points: expected a contiguous array, got strides .*; copy it first"):
            loom.PointCloud.from_dlpack(given)
    view = torch.tensor(np.repeat(points, 2, axis=0))[50:]  # contiguous, with an offset
    assert loom.PointCloud.from_dlpack(view).arrays["points"].ptr == view.data_ptr()
    with pytest.raises(ValueError, match=r"points: expected shape \[n, 3\], got \[3, 50\]; pass its transpose"):
        loom.PointCloud(layouts["transposed"].T)


def test_flipped_and_negated_views_have_their_numbers(points):
    np.testing.assert_array_equal(loom.PointCloud(torch.tensor(points).flip(0)).points, points[::-1])
    for given in (jax.numpy.asarray(points)[::-1], jax.numpy.asarray(points[::-1].T.copy()).T):
        np.testing.assert_array_equal(loom.PointCloud(given).points, points[::-1])
    imaginary = torch.complex(torch.tensor(points), torch.tensor(points)).conj().imag  # with torch's negative bit
    with pytest.raises(TypeError, match=r"points: .*resolve_neg"):
        loom.PointCloud(imaginary)


def test_empty_and_single_numbers(library, points):
    empty = library.make(np.zeros((0, 3), np.float32))
    for cloud in (loom.PointCloud(empty), loom.PointCloud.from_dlpack(empty)):
        assert len(cloud) == 0 and tuple(library.read(cloud).shape) == (0, 3)
        assert len(cloud.cluster_dbscan(0.1, 2)) == 0
    number = library.make(np.float32(3))
    for attempt in (loom.PointCloud, loom.PointCloud.from_dlpack):
        with pytest.raises(ValueError, match="points: expected "):
            attempt(number)
    assert len(loom.PointCloud(points).voxel_down_sample(library.make(np.float32(5)))) == 1


def test_a_cloud_is_read_by_each_library_at_its_address(library, points):
    cloud = loom.PointCloud(points, normals=points, label=np.arange(50, dtype=np.int32), a=points.astype(np.float16))
    for name in ("points", "normals", "label", "a"):
        seen = library.read(cloud.array(name))
        assert library.address(seen) == cloud.arrays[name].ptr
        np.testing.assert_array_equal(library.host(seen), cloud[name].astype(library.host(seen).dtype))
    assert library.address(library.read(cloud)) == cloud.arrays["points"].ptr
    labels = cloud.to("cpu", arrays="warp").cluster_dbscan(0.1, 4)
    assert library.address(library.read(labels)) == labels.ptr


def test_a_requested_copy_is_one(points):
    cloud = loom.PointCloud(points)
    torch.from_dlpack(cloud, copy=True)[:] = 0
    assert np.from_dlpack(cloud, copy=True).ctypes.data != cloud.arrays["points"].ptr
    np.testing.assert_array_equal(cloud.points, points.astype(np.float64))
    assert torch.from_dlpack(cloud, copy=False).data_ptr() == cloud.arrays["points"].ptr
    assert torch.from_dlpack(cloud, device="cpu").data_ptr() == cloud.arrays["points"].ptr
    with pytest.raises(BufferError, match=r"the points are on cpu. Use cloud.to\(device\)"):
        cloud.__dlpack__(dl_device=(2, 0))


def test_a_result_released_by_an_exception_does_not_replace_it(library, points):
    """Warp's own release is a Python function, which replaces an exception that is being raised."""
    cloud, plain = loom.PointCloud(library.make(points)), loom.PointCloud(points)
    for shared in (
        lambda: cloud.cluster_dbscan(0.1, 2),
        lambda: cloud.compute_nearest_neighbor_distance(),
        lambda: loom.NearestNeighborSearch(plain).knn_search(library.make(points), 2),
        lambda: library.read(plain),
        lambda: np.from_dlpack(plain),
    ):
        with pytest.raises(KeyError, match="absent"):
            print(shared(), {}["absent"])


def test_writes_of_torch_are_noticed(points):
    given = torch.tensor(points)
    cloud = loom.PointCloud(given)
    before = cloud.compute_nearest_neighbor_distance().clone()
    given.mul_(2)
    torch.testing.assert_close(cloud.compute_nearest_neighbor_distance(), 2 * before)
    torch.from_dlpack(cloud).mul_(0.5)
    torch.testing.assert_close(cloud.compute_nearest_neighbor_distance(), before)
    np.testing.assert_array_equal(given.numpy(), points)


def test_memory_of_jax_is_neither_written_nor_lost(points):
    given = jax.numpy.asarray(points)
    cloud = loom.PointCloud(given, normals=given)
    moved = cloud.estimate_normals(max_nn=5).translate([1, 0, 0]).voxel_down_sample(0.1)
    moved.scale(2.0, [0, 0, 0]).cluster_dbscan(0.1, 2)
    np.testing.assert_array_equal(np.asarray(given), points)
    jax.jit(lambda p: p * 0, donate_argnums=0)(given).block_until_ready()
    np.testing.assert_array_equal(cloud.points, points.astype(np.float64))


def test_tensors_that_require_a_gradient_are_rejected(points):
    leaf = torch.tensor(points, requires_grad=True)
    cloud, number = loom.PointCloud(points), torch.tensor(0.5, requires_grad=True)
    for given in (leaf, leaf * 2, torch.nn.Parameter(torch.tensor(points))):
        calls = {
            "points": [lambda g=given: loom.PointCloud(g), lambda g=given: loom.PointCloud.from_dlpack(g)],
            "a": [lambda g=given: loom.PointCloud(points, a=g), lambda g=given: cloud.__setitem__("a", g)],
            "queries": [lambda g=given: loom.NearestNeighborSearch(cloud).knn_search(g, 1)],
        }
        for argument, attempts in calls.items():
            for attempt in attempts:
                with pytest.raises(TypeError, match=rf"^{argument}: .*requires a gradient.*; pass tensor.detach\(\)"):
                    attempt()
        assert loom.PointCloud(given.detach()).arrays["points"].ptr == given.data_ptr()
    for argument, attempt in {
        "transformation": lambda: cloud.transform(torch.eye(4, requires_grad=True)),
        "voxel_size": lambda: cloud.voxel_down_sample(number),
        "scale": lambda: cloud.scale(number, [0, 0, 0]),
    }.items():
        with pytest.raises(TypeError, match=rf"^{argument}: .*requires a gradient.*; pass tensor.detach\(\)"):
            attempt()


def test_tensors_without_plain_numbers_are_rejected(points):
    ours, plain = torch.tensor(points), loom.PointCloud(points)
    with warnings.catch_warnings(action="ignore"):  # torch: its CSR tensors are in beta, its quantized ones deprecated
        quantized = torch.quantize_per_tensor(ours, 0.1, 0, torch.quint8)
        given = {
            r"a sparse Tensor; pass tensor.to_dense\(\)": [ours.to_sparse(), ours.to_sparse_csr()],
            r"a quantized Tensor of quint8; pass tensor.dequantize\(\)": [quantized],
            "a Tensor on the device meta": [torch.zeros((50, 3), device="meta")],
            "complex64": [ours.to(torch.complex64), ours.to(torch.complex64).conj()],
        }
    for reason, tensors in given.items():
        for tensor in tensors:
            for argument, attempt in {
                "points": lambda t=tensor: loom.PointCloud(t),
                "normals": lambda t=tensor: loom.PointCloud.from_dlpack(ours, normals=t),
                "a": lambda t=tensor: loom.PointCloud(ours, a=t),
                "queries": lambda t=tensor: loom.NearestNeighborSearch(plain).knn_search(t, 1),
                "cloud[...]": lambda t=tensor: plain[t],
            }.items():
                with pytest.raises(TypeError, match=f"expected (real )?numbers, got {reason}") as error:
                    attempt()
                assert str(error.value).startswith(f"{argument}: ")
    for argument, attempt in {
        "voxel_size": lambda: plain.voxel_down_sample(torch.tensor(0.3, device="meta")),
        "num_samples": lambda: plain.farthest_point_indices(torch.tensor(3, device="meta")),
    }.items():
        with pytest.raises(TypeError, match=f"{argument}: .*on the device meta"):
            attempt()


def test_traced_arrays_of_jax_are_rejected(points):
    given, cloud = jax.numpy.asarray(points), loom.PointCloud(points)
    reason = "Tracer, which has no numbers; call pointloom outside of jax.jit, jax.grad and jax.vmap"
    for transform in (jax.jit, jax.grad, jax.vmap):
        for argument, call in {
            "points": loom.PointCloud,
            "points ": loom.PointCloud.from_dlpack,
            "queries": lambda p: loom.NearestNeighborSearch(cloud).knn_search(p, 1),
        }.items():
            with pytest.raises(TypeError, match=f"^{argument.strip()}: .*{reason}"):
                transform(call)(given)
    with pytest.raises(TypeError, match=f"voxel_size: .*{reason}"):
        jax.jit(cloud.voxel_down_sample)(0.3)


USES = {
    "torch": "import torch; assert float(torch.ones(3).sum()) == 3",
    "open3d": "import open3d; assert len(open3d.geometry.TriangleMesh.create_box().vertices) == 8",
    "jax": "import jax.numpy; assert float(jax.numpy.ones(3).sum()) == 3",
    "numba": "import numba; assert numba.njit(lambda x: x + 1)(2) == 3",
    "pointloom": """
end_of_stderr = os.lseek(2, 0, os.SEEK_END)
import pointloom
assert len(pointloom.PointCloud(numpy.eye(3)).voxel_down_sample(9.0)) == 1
assert os.lseek(2, 0, os.SEEK_END) == end_of_stderr, "a line on stderr"
""",
}
ROTATIONS = [tuple([*USES][first:]) + tuple([*USES][:first]) for first in range(len(USES))]


@pytest.mark.nightly
@pytest.mark.parametrize("order", [*itertools.permutations(USES, 2), *ROTATIONS], ids="-".join)
def test_libraries_work_in_one_process_in_any_order(tmp_path, order):
    for name in order:
        if importlib.util.find_spec(name) is None:
            pytest.skip(f"{name} is not installed")
    program = "\n".join(["import os, numpy", *(USES[name] for name in order), *(USES[name] for name in order)])
    with (tmp_path / "stderr").open("w+") as stderr:
        environment = os.environ | {"POINTLOOM_VERBOSITY": "warning"}
        done = subprocess.run([sys.executable, "-c", program], stderr=stderr, env=environment, timeout=300)
    assert done.returncode == 0, (tmp_path / "stderr").read_text()

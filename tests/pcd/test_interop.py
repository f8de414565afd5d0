"""Clouds to and from Open3D, arrays shared with other libraries, and pickles."""

import copy
import gc
import pickle
import sys
import weakref

import numpy as np
import pytest
import warp as wp
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as st_numpy

import pointloom as loom
from pointloom.core import exchange

from .full_clouds import UTM, assert_same, contents, full_cloud


class Shared:
    """An array of another library that supports DLPack only."""

    def __init__(self, values):
        self.values = values

    def __dlpack__(self, stream=None):
        return self.values.__dlpack__()

    def __dlpack_device__(self):
        return self.values.__dlpack_device__()


class OnGpu:
    """An array of another library that supports `__cuda_array_interface__` only."""

    def __init__(self, values, strides=None):
        self.values = values
        self.__cuda_array_interface__ = {
            "shape": values.shape, "typestr": values.dtype.str, "data": (values.ctypes.data, False),
            "strides": strides, "version": 3, "stream": 1,
        }  # fmt: skip


@pytest.fixture
def cloud(rng, device):
    return full_cloud(rng, device, shift=UTM)


@pytest.mark.parametrize("wrap", [lambda values: values, Shared])
def test_arrays_of_another_library_are_shared(rng, wrap):
    points = rng.random((100, 3)).astype(np.float32)
    arrays = {"normals": points.copy(), "label": np.arange(100), "feature": np.zeros((100, 2))}
    shared = loom.PointCloud.from_dlpack(wrap(points), **arrays)
    out = np.from_dlpack(shared.array("points"))
    assert out.shape == (100, 3)
    assert np.shares_memory(out, points)
    np.testing.assert_array_equal(shared.points, points.astype(np.float64))
    points[7] = 1, 2, 3
    assert shared.points[7].tolist() == [1, 2, 3]
    assert shared.attributes["feature"].shape == (100, 2)
    assert shared["label"].dtype == np.int64


@pytest.mark.slow
def test_the_source_lives_as_long_as_the_cloud_and_no_longer():
    class Array(np.ndarray):
        pass

    points = np.arange(300, dtype=np.float32).reshape(100, 3).view(Array)
    reference = weakref.ref(points)
    shared = loom.PointCloud.from_dlpack(Shared(points))
    part, view = shared.copy(), np.from_dlpack(shared.array("points"))
    del points, shared
    gc.collect()
    assert reference() is not None
    np.testing.assert_array_equal(part.points, np.arange(300).reshape(100, 3))
    np.testing.assert_array_equal(view, np.arange(300).reshape(100, 3))
    del part, view
    gc.collect()
    assert reference() is None


def test_pointloom_arrays_are_shared_with_numpy_and_warp(cloud):
    for name, shape in (("points", (200, 3)), ("colors", (200, 3)), ("label", (200,)), ("pair", (200, 2))):
        array = cloud.array(name)
        if cloud.device.is_cpu:
            assert array.shape == shape and np.shares_memory(np.from_dlpack(cloud.arrays[name]), array)
        else:
            assert tuple(array.__cuda_array_interface__["shape"]) == shape
    arrays = {name: cloud.array(name) for name in ("colors", "label")}
    again = loom.PointCloud.from_dlpack(cloud.array("points"), origin=cloud.origin, **arrays)
    assert again.arrays["points"].ptr == cloud.arrays["points"].ptr
    assert again.device == cloud.device
    np.testing.assert_array_equal(again.points, cloud.points)


@settings(max_examples=25, derandomize=True, deadline=None, database=None)
@given(
    values=st_numpy.arrays(
        st.sampled_from([np.dtype(code) for code in ("f4", "f8", "i1", "u2", "i4", "u8", "?")]),
        st_numpy.array_shapes(min_dims=1, max_dims=2, min_side=0, max_side=6),
    )
)
def test_attribute_of_any_type_and_shape_is_shared(values):
    points = np.zeros((len(values), 3), np.float32)
    shared = loom.PointCloud.from_dlpack(points, values=values)
    assert len(shared) == len(values)
    assert shared["values"].dtype == values.dtype
    np.testing.assert_array_equal(shared["values"], values)


def test_bfloat16_of_warp_is_not_read_as_its_bits():
    points = np.zeros((50, 3), np.float32)
    given = wp.zeros((50, 3), dtype=wp.bfloat16, device="cpu")
    for attempt in (lambda: loom.PointCloud(points, a=given), lambda: loom.PointCloud.from_dlpack(points, a=given)):
        with pytest.raises(TypeError, match=r"a: expected real numbers, got bfloat16.*convert it to float32"):
            attempt()


def test_an_array_of_a_gpu_is_no_silent_copy(rng):
    with pytest.raises(TypeError, match="R:"):
        loom.PointCloud([[0, 0, 0]]).rotate(OnGpu(np.eye(3)))
    if wp.get_cuda_device_count():
        pytest.skip("there is a GPU here")
    for make in (loom.PointCloud, loom.PointCloud.from_dlpack):
        with pytest.raises(loom.DeviceError, match="points:"):
            make(OnGpu(rng.random((4, 3)).astype(np.float32)))


def test_cuda_array_interface_is_respected(rng, monkeypatch):
    """Uses host memory instead of a GPU: the address, type, shape and strides are read."""
    monkeypatch.setattr(wp, "get_cuda_device_count", lambda: 1)
    monkeypatch.setattr(wp, "get_cuda_device", lambda: wp.get_device("cpu"))
    waited_for = []
    monkeypatch.setattr(exchange, "_wait_for", lambda device, stream: waited_for.append(stream))
    points = rng.random((4, 3)).astype(np.float32)
    shared = loom.PointCloud.from_dlpack(OnGpu(points), label=OnGpu(np.arange(4, dtype=np.uint16), strides=(2,)))
    points[2] = 7
    assert waited_for == [1, 1]
    np.testing.assert_array_equal(shared.points, points)
    assert shared["label"].tolist() == [0, 1, 2, 3]
    with pytest.raises(ValueError, match="contiguous"):
        loom.PointCloud.from_dlpack(OnGpu(points, strides=(24, 4)))
    masked = OnGpu(points)
    masked.__cuda_array_interface__["mask"] = masked
    with pytest.raises(TypeError, match="mask"):
        loom.PointCloud.from_dlpack(masked)


def test_legacy_cloud_round_trip(fragment, legacy_fragment, device):
    cloud = loom.PointCloud.from_open3d(legacy_fragment, device=device)
    np.testing.assert_array_equal(cloud.points, fragment.points.astype(np.float32))
    np.testing.assert_array_equal(cloud.normals, fragment.normals.astype(np.float32))
    back = cloud.to_open3d()
    for name in ("points", "normals", "colors"):
        np.testing.assert_array_equal(np.asarray(getattr(back, name)), cloud[name].astype(np.float64))


def test_legacy_cloud_far_from_zero_keeps_its_position(rng, device, o3d, to_open3d, tolerances):
    points = rng.random((200, 3)) * 100 + np.array([5e5, 5.4e6, 100])
    legacy = to_open3d(points)
    legacy.estimate_covariances(o3d.geometry.KDTreeSearchParamKNN(10))
    cloud = loom.PointCloud.from_open3d(legacy, device=device)
    assert cloud.origin.any()
    np.testing.assert_allclose(cloud.points, points, rtol=0, atol=tolerances.position)
    np.testing.assert_array_equal(cloud["covariances"], np.asarray(legacy.covariances).reshape(-1, 9))
    back = cloud.to_open3d()
    np.testing.assert_array_equal(np.asarray(back.points), cloud.points)
    np.testing.assert_array_equal(np.asarray(back.covariances), np.asarray(legacy.covariances))
    tensor = cloud.to_open3d_tensor()
    np.testing.assert_array_equal(tensor.point.covariances.numpy(), np.asarray(legacy.covariances))
    assert tensor.point.positions.dtype == o3d.core.float64


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_tensor_cloud_round_trip_keeps_all_attributes(rng, device, dtype, o3d):
    tensor = o3d.t.geometry.PointCloud()
    arrays = {
        "positions": rng.random((30, 3)).astype(dtype),
        "normals": rng.random((30, 3)).astype(np.float32),
        "colors": rng.integers(0, 256, (30, 3)).astype(np.uint8),
        "intensity": rng.random((30, 1)).astype(np.float32),
        "label": rng.integers(0, 9, (30, 1)),
        "inside": rng.random((30, 1)) > 0.5,
        "blocks": rng.random((30, 2, 2)),
    }
    for name, values in arrays.items():
        tensor.point[name] = o3d.core.Tensor(values)
    cloud = loom.PointCloud.from_open3d(tensor, device=device)
    np.testing.assert_array_equal(cloud.points, arrays["positions"].astype(np.float32))
    np.testing.assert_array_equal(cloud.colors, arrays["colors"] / np.float32(255))
    np.testing.assert_array_equal(cloud["blocks"], arrays["blocks"].reshape(30, 4))
    back = cloud.to_open3d_tensor()
    assert back.point.positions.dtype == o3d.core.float32
    for name in ("normals", "intensity", "label", "inside"):
        np.testing.assert_array_equal(back.point[name].numpy(), arrays[name])
    assert loom.PointCloud(np.zeros((3, 3)), a=np.arange(3)).to_open3d_tensor().point["a"].shape == (3, 1)


def test_16_bit_colors_of_a_tensor_cloud_are_parts_of_65535(o3d):
    tensor = o3d.t.geometry.PointCloud(o3d.core.Tensor(np.zeros((1, 3), np.float32)))
    tensor.point.colors = o3d.core.Tensor(np.array([[0, 257, 65535]], np.uint16))
    np.testing.assert_allclose(loom.PointCloud.from_open3d(tensor).colors, [[0, 1 / 255, 1]], rtol=1e-6)


def test_empty_clouds_round_trip(device, o3d):
    for empty in (o3d.geometry.PointCloud(), o3d.t.geometry.PointCloud()):
        cloud = loom.PointCloud.from_open3d(empty, device=device)
        assert len(cloud) == 0
        assert cloud.to_open3d().is_empty()
        assert cloud.to_open3d_tensor().is_empty()


def test_other_objects_are_rejected(monkeypatch, o3d):
    for wrong in (np.zeros((3, 3)), loom.TriangleMesh(), None):
        with pytest.raises(TypeError, match="cloud:"):
            loom.PointCloud.from_open3d(wrong)
    with pytest.raises(TypeError, match="half:"):
        loom.PointCloud(np.zeros((2, 3)), half=np.zeros(2, np.float16)).to_open3d_tensor()
    monkeypatch.setitem(sys.modules, "open3d", None)
    for call in (loom.PointCloud().to_open3d, loom.PointCloud().to_open3d_tensor):
        with pytest.raises(ImportError, match="pip install open3d"):
            call()


@pytest.mark.parametrize("protocol", [2, pickle.HIGHEST_PROTOCOL])
def test_a_cloud_survives_a_pickle(cloud, protocol):
    restored = pickle.loads(pickle.dumps(cloud, protocol))
    assert_same(contents(restored), contents(cloud))
    assert restored.device == cloud.device
    assert len(restored.voxel_down_sample(5.0)) == len(cloud.voxel_down_sample(5.0))


def test_a_pickle_keeps_the_grid_and_an_empty_cloud(device):
    cloud = loom.PointCloud(np.zeros((6, 3)), device=device)
    cloud.grid = (2, 3)
    assert pickle.loads(pickle.dumps(cloud)).grid == (2, 3)
    empty = pickle.loads(pickle.dumps(loom.PointCloud(device=device, label=np.empty(0, np.int64))))
    assert len(empty) == 0
    assert empty["label"].dtype == np.int64


def test_deep_copies_share_nothing_and_shallow_copies_everything(cloud):
    shallow, deep = copy.copy(cloud), copy.deepcopy(cloud)
    assert_same(contents(deep), contents(cloud))
    for name in ("points", "normals", "label", "pair"):
        assert shallow.arrays[name] is cloud.arrays[name]
        assert deep.arrays[name].ptr != cloud.arrays[name].ptr
    shallow["label"] = np.zeros(200)
    assert cloud["label"].any()
    cloud.arrays["points"].fill_(0)
    assert deep.points.std() > 1


def test_a_pickle_from_a_gpu_needs_one(cloud):
    if wp.get_cuda_device_count():
        there = cloud.to("cuda:0")
        assert pickle.loads(pickle.dumps(there)).device == there.device
        state = there.__getstate__() | {"device": "cuda:7"}
        moved = loom.PointCloud.__new__(loom.PointCloud)
        moved.__setstate__(state)
        assert str(moved.device) == "cuda:0"
        return
    state = cloud.__getstate__() | {"device": "cuda:0"}
    with pytest.raises(loom.DeviceError, match=r"pickled on cuda:0.*pickle cloud\.to\('cpu'\) instead"):
        loom.PointCloud.__new__(loom.PointCloud).__setstate__(state)


def test_a_shared_cloud_pickles_as_its_own(rng):
    points = rng.random((5, 3)).astype(np.float32)
    restored = pickle.loads(pickle.dumps(loom.PointCloud.from_dlpack(points)))
    points[:] = 0
    assert restored.points.any()

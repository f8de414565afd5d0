"""Files of tensors keep attributes and types."""

import numpy as np
import pytest

import pointloom.open3d as o3d
from pointloom.core.errors import FileError

g, io = o3d.t.geometry, o3d.t.io
RNG = np.random.default_rng(0)


def cloud_of(dtype=np.float32, points=None):
    cloud = g.PointCloud((RNG.random((5, 3)) if points is None else points).astype(dtype))
    cloud.point.normals = np.tile(np.array([0, 0.6, 0.8], np.float32), (5, 1)).astype(dtype)
    cloud.point.colors = RNG.integers(0, 255, (5, 3), np.uint8)
    cloud.point["label"] = np.arange(5, dtype=np.int32)[:, None]
    cloud.point["weight"] = RNG.random((5, 1)).astype(dtype)
    return cloud


@pytest.mark.parametrize("suffix", ["ply", "pcd"])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("write_ascii", [False, True])
def test_files_keep_values_and_types_of_all_attributes(tmp_path, suffix, dtype, write_ascii):
    cloud, path = cloud_of(dtype), tmp_path / f"a.{suffix}"
    assert io.write_point_cloud(path, cloud, write_ascii=write_ascii)
    back = io.read_point_cloud(path)
    assert sorted(back.point) == sorted(cloud.point)
    for name, tensor in cloud.point.items():
        assert (back.point[name].dtype, back.point[name].shape) == (tensor.dtype, tensor.shape)
        assert np.abs(back.point[name].numpy() - tensor.numpy()).max() < 1e-7


def test_text_files_have_their_columns(tmp_path):
    cloud = cloud_of()
    cloud.point.colors = np.float32(RNG.random((5, 3)))
    for suffix, names in (("xyz", []), ("xyzn", ["normals"]), ("xyzrgb", ["colors"])):
        io.write_point_cloud(str(tmp_path / f"a.{suffix}"), cloud)
        back = io.read_point_cloud(str(tmp_path / f"a.{suffix}"))
        assert sorted(back.point) == sorted(["positions", *names])
        for name in back.point:
            assert np.abs(back.point[name].numpy() - cloud.point[name].numpy()).max() < 1e-6
    (tmp_path / "a.xyzrgb").rename(tmp_path / "a.txt")
    assert "colors" in io.read_point_cloud(tmp_path / "a.txt", format="xyzrgb").point


def test_points_that_are_not_finite_are_dropped_on_request(tmp_path):
    points = RNG.random((5, 3))
    points[1, 0], points[3, 2] = np.nan, np.inf
    path = tmp_path / "a.ply"
    io.write_point_cloud(path, cloud_of(points=points))
    assert len(io.read_point_cloud(path).point.positions) == 5
    rows = io.read_point_cloud(path, remove_nan_points=True, remove_infinite_points=True).point["label"]
    assert rows.numpy().ravel().tolist() == [0, 2, 4]


def test_a_cloud_of_positions_and_an_empty_one_are_written(tmp_path):
    io.write_point_cloud(tmp_path / "a.ply", g.PointCloud(np.zeros((2, 3))))
    io.write_point_cloud(tmp_path / "b.ply", g.PointCloud())
    assert len(io.read_point_cloud(tmp_path / "a.ply").point.positions) == 2
    assert io.read_point_cloud(tmp_path / "b.ply").is_empty()


def test_wrong_files_and_objects_are_errors(tmp_path):
    with pytest.raises(FileError, match=r"missing\.ply"):
        io.read_point_cloud(tmp_path / "missing.ply")
    with pytest.raises(ValueError, match="format"):
        io.read_point_cloud(tmp_path / "a.ply", format="pcd")
    with pytest.raises(TypeError, match="pointcloud"):
        io.write_point_cloud(tmp_path / "a.ply", np.zeros((2, 3)))
    with pytest.raises(TypeError, match="image"):
        io.write_image(tmp_path / "a.png", np.zeros((2, 3), np.uint8))


@pytest.mark.parametrize(
    "pixels", [RNG.integers(0, 255, (4, 6, 3), np.uint8), RNG.integers(0, 60000, (4, 6, 1), np.uint16)]
)
def test_images_keep_pixels_and_type(tmp_path, pixels):
    assert io.write_image(tmp_path / "a.png", g.Image(pixels))
    back = io.read_image(tmp_path / "a.png")
    assert (back.as_tensor().numpy() == pixels).all() and back.as_tensor().numpy().dtype == pixels.dtype

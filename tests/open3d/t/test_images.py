"""Images and boxes of tensors, and files: against float64 arithmetic."""

import copy

import numpy as np
import PIL.Image
import pytest

import pointloom.open3d as o3d
from pointloom.core.errors import FileError

g, core, Tensor = o3d.t.geometry, o3d.core, o3d.core.Tensor
RNG = np.random.default_rng(0)
BYTES = RNG.integers(0, 255, (6, 8, 3), np.uint8)
GRAY = RNG.random((6, 8)).astype(np.float32)
K = np.array([[20.0, 0, 4], [0, 25, 3], [0, 0, 1]])


def values_of(image):
    return image.as_tensor().numpy()


def padded(radius, values=GRAY):
    return np.pad(values.astype(np.float64), radius, mode="edge")


def correlated(kernel, values=GRAY):
    """Weighted sums over windows, by definition."""
    kernel = np.asarray(kernel, np.float64)
    source = padded(len(kernel) // 2, values)
    sums = np.zeros(values.shape)
    for i, j in np.ndindex(kernel.shape):
        sums += kernel[i, j] * source[i : i + values.shape[0], j : j + values.shape[1]]
    return sums


def test_an_image_is_a_tensor_of_rows_columns_and_channels(where):
    tensor = Tensor(GRAY, device=where)
    image = g.Image(tensor)
    assert (image.rows, image.columns, image.channels, image.device) == (6, 8, 1, where)
    assert repr(image) == f"Image[size={{6,8}}, channels=1, Float32, {where}]" and not image.is_empty()
    image.as_tensor()[0, 0] = 7.0
    assert tensor.numpy()[0, 0] == 7 and g.Image(image).as_tensor().numpy()[0, 0] == 7  # both share the memory
    copied = image.clone()
    copied.as_tensor()[0, 0] = 8.0
    assert tensor.numpy()[0, 0] == 7
    black = g.Image(2, 3, 3, core.uint8, where)
    assert values_of(black).shape == (2, 3, 3) and not values_of(black).any() and black.dtype == core.uint8
    assert image.get_min_bound().numpy().tolist() == [0, 0] and image.get_max_bound().numpy().tolist() == [6, 8]
    assert image.clear().is_empty() and g.Image().is_empty()
    legacy = g.Image(Tensor(BYTES, device=where)).to_legacy()
    assert (np.asarray(legacy) == BYTES).all()
    assert (values_of(g.Image.from_legacy(legacy, where)) == BYTES).all()
    with pytest.raises(ValueError, match="tensor"):
        g.Image(np.zeros(3))


def test_conversions_scale_bytes_for_floats_and_round_to_integers():
    row = g.Image(np.array([[0, 100, 255]], np.uint8))
    assert np.abs(values_of(row.to(core.float32)).ravel() - np.array([0, 100, 255]) / 255).max() < 1e-7
    assert values_of(row.to(core.uint16)).ravel().tolist() == [0, 100, 255]
    assert values_of(row.to(core.float32, scale=2.0, offset=1.0)).ravel().tolist() == [1, 201, 511]
    assert values_of(row.to(core.uint8, scale=2.0, offset=1.0)).ravel().tolist() == [1, 201, 255]
    floats = g.Image(np.array([[0.4, 0.5, 1.5, 2.5, -1, 300]], np.float32))
    assert values_of(floats.to(core.uint8)).ravel().tolist() == [0, 0, 2, 2, 0, 255]
    assert row.to(core.uint8) is row and row.to(core.uint8, copy=True) is not row and row.to(core.Device()) is row
    assert row.linear_transform(-0.5, 1.6) is row and values_of(row).ravel().tolist() == [2, 0, 0]


def test_filters_of_a_window_are_sums_with_its_weights():
    image = g.Image(GRAY)
    weights = np.exp(-np.add.outer(np.arange(-2.0, 3) ** 2, np.arange(-2.0, 3) ** 2) / 2)
    kernel = RNG.random((3, 3)).astype(np.float32)
    five = np.outer([1, 4, 6, 4, 1], [-1, -2, 0, 2, 1])
    for made, expected in (
        (image.filter(kernel), correlated(kernel)),
        (image.filter_gaussian(5, 1.0), correlated(weights / weights.sum())),
        (image.pyrdown(), correlated(weights / weights.sum())[::2, ::2]),
        (image.filter_sobel(3)[0], correlated(np.outer([1, 2, 1], [-1, 0, 1]))),
        (image.filter_sobel(3)[1], correlated(np.outer([-1, 0, 1], [1, 2, 1]))),
        (image.filter_sobel(5)[0], correlated(five)),
        (image.dilate(3), np.max([padded(1)[i : i + 6, j : j + 8] for i in range(3) for j in range(3)], axis=0)),
    ):
        assert made.dtype == core.float32 and np.abs(values_of(made)[..., 0] - expected).max() < 1e-5
    slope = g.Image(BYTES[..., 0]).filter_sobel(3)[0]
    expected = correlated(np.outer([1, 2, 1], [-1, 0, 1]), BYTES[..., 0])
    assert str(slope.dtype) == "Int16" and (values_of(slope)[..., 0] == expected).all()
    with pytest.raises(ValueError, match="kernel_size"):
        image.filter_sobel(4)


def bilateral(values, radius, value_sigma, dist_sigma):
    """The filter by definition, over a disc."""
    source, found = np.pad(values, ((radius,) * 2, (radius,) * 2, (0, 0)), mode="edge"), np.zeros(values.shape)
    offsets = np.array([*np.ndindex(2 * radius + 1, 2 * radius + 1)])
    far = ((offsets - radius) ** 2).sum(axis=1)
    offsets, far = offsets[far <= radius**2], far[far <= radius**2]
    for y, x in np.ndindex(values.shape[:2]):
        near = source[y + offsets[:, 0], x + offsets[:, 1]]
        change = np.abs(near - values[y, x]).sum(axis=1)
        weights = np.exp(-far / (2 * dist_sigma**2) - change**2 / (2 * value_sigma**2))
        found[y, x] = weights @ near / weights.sum()
    return found


def test_bilateral_filters_weigh_pixels_by_distance_and_difference(where):
    color = values_of(g.Image(BYTES).filter_bilateral(5, 40.0, 2.0))
    assert np.abs(color - bilateral(BYTES.astype(float), 2, 40.0, 2.0)).max() <= 0.5 + 1e-9
    depth = g.Image(Tensor(GRAY + np.float32(1), device=where)).filter_bilateral(5, 0.3, 2.0)
    inner = bilateral(GRAY[..., None] + 1.0, 2, 0.3, 2.0)[2:-2, 2:-2]
    assert depth.device == where and np.abs(values_of(depth)[2:-2, 2:-2] - inner).max() < 1e-5
    holes = np.float32([[1, np.nan, 1, 0, 1]])
    assert np.array_equal(values_of(g.Image(holes).filter_bilateral(3))[..., 0], holes, equal_nan=True)


def test_resized_images_take_the_pixels_at_their_places():
    image = g.Image(GRAY)
    assert (values_of(image.resize(0.5))[..., 0] == GRAY[::2, ::2]).all()
    assert (values_of(image.resize(2.0))[..., 0] == GRAY.repeat(2, 0).repeat(2, 1)).all()
    means = GRAY.reshape(3, 2, 4, 2).mean(axis=(1, 3))
    for kind in (g.InterpType.Linear, g.InterpType.Super):
        assert np.abs(values_of(image.resize(0.5, kind))[..., 0] - means).max() < 1e-6
    for kind in (g.InterpType.Cubic, g.InterpType.Lanczos):
        flat = g.Image(np.full((6, 8), 0.25, np.float32)).resize(1.5, kind)
        assert flat.rows == 9 and np.abs(values_of(flat) - 0.25).max() < 1e-6


def test_gray_is_the_weighted_sum_of_the_colors():
    gray = g.Image(BYTES).rgb_to_gray()
    assert (values_of(gray)[..., 0] == np.rint(BYTES @ [0.299, 0.587, 0.114])).all() and gray.dtype == core.uint8
    with pytest.raises(ValueError, match="channels"):
        gray.rgb_to_gray()


def test_depth_becomes_points_and_normals(where):
    raw = (1000 + 100 * np.arange(8)[None] + np.zeros((6, 1))).astype(np.uint16)
    raw[1, 1], raw[4, 4] = 0, 9000
    depth = g.Image(Tensor(raw, device=where)).clip_transform(1000.0, 0.1, 3.0)
    z = np.where((raw > 100) & (raw < 3000), raw / 1000, 0)
    assert depth.dtype == core.float32 and np.abs(values_of(depth)[..., 0] - z).max() < 1e-6
    v, u = np.indices(z.shape)
    expected = np.stack([(u - 4) / 20 * z, (v - 3) / 25 * z, z], axis=-1)
    points = depth.create_vertex_map(K)
    assert points.device == where and np.abs(values_of(points) - expected).max() < 1e-6
    assert (np.isinf(values_of(depth.create_vertex_map(K, np.inf))).all(axis=2) == (z == 0)).all()
    normals = values_of(points.create_normal_map())
    is_known = (z[:-1, :-1] > 0) & (z[1:, :-1] > 0) & (z[:-1, 1:] > 0)
    assert not normals[-1].any() and not normals[:, -1].any() and not normals[:-1, :-1][~is_known].any()
    across = np.cross(expected[1:, :-1] - expected[:-1, :-1], expected[:-1, 1:] - expected[:-1, :-1])
    across /= np.linalg.norm(across, axis=2, keepdims=True)
    assert np.abs(normals[:-1, :-1] - across)[is_known].max() < 1e-5 and normals[:-1, :-1][is_known][:, 2].max() < 0
    for work in (
        lambda: g.Image(BYTES).clip_transform(1, 0, 1),
        lambda: g.Image(raw).create_vertex_map(K),
        lambda: depth.create_normal_map(),
        lambda: g.Image(BYTES).colorize_depth(1, 0, 1),
    ):
        with pytest.raises(ValueError, match="image"):
            work()


def test_depth_colors_run_from_blue_to_red():
    colors = values_of(g.Image(np.array([[0, 500, 1500, 3000, 9000]], np.uint16)).colorize_depth(1000.0, 0.5, 3.0))[0]
    assert colors.dtype == np.uint8 and (colors[0] == colors[1]).all() and (colors[3] == colors[4]).all()
    assert colors[0].tolist() == [48, 18, 59] and colors[3].tolist() == [122, 4, 3]  # ends of turbo


def test_a_pair_of_images_is_of_one_size_if_aligned(where):
    pair = g.RGBDImage(g.Image(BYTES).to(where), g.Image(GRAY).to(where))
    assert pair.are_aligned() and pair.aligned_ and pair.device == where and not pair.is_empty()
    assert pair.get_max_bound().numpy().tolist() == [16, 6] and pair.get_min_bound().numpy().tolist() == [0, 0]
    legacy = pair.to_legacy()
    assert (np.asarray(legacy.color) == BYTES).all() and (np.asarray(legacy.depth) == GRAY).all()
    other = pair.clone()
    other.depth.as_tensor()[0, 0] = 9.0
    assert values_of(pair.depth)[0, 0] == GRAY[0, 0] and pair.cpu().is_cpu
    assert repr(pair).splitlines()[2] == f"Depth [size=(8,6), channels=1, format=Float32, device={where}]"
    assert not g.RGBDImage(pair.color, g.Image(), aligned=False).are_aligned() and pair.clear().is_empty()
    with pytest.raises(ValueError, match="depth"):
        g.RGBDImage(g.Image(BYTES), g.Image())


LOW, HIGH = np.array([0.0, 1, 2]), np.array([1.0, 3, 5])
R = np.array([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]])
CENTER, EXTENT = np.array([1.0, 2, 3]), np.array([2.0, 4, 6])
POINTS = np.random.default_rng(0).random((40, 3)) * 6


@pytest.fixture(params=[np.float32, np.float64])
def aligned(request, where):
    return g.AxisAlignedBoundingBox(*(Tensor(end.astype(request.param), device=where) for end in (LOW, HIGH)))


@pytest.fixture
def turned(where):
    return g.OrientedBoundingBox(*(Tensor(part, device=where) for part in (CENTER, R, EXTENT)))


def same(tensor, values, tolerance=1e-6):
    return tensor.shape == np.shape(values) and np.abs(tensor.numpy() - values).max() < tolerance


def test_an_aligned_box_has_its_measures_in_its_type(aligned, where):
    for tensor, values in (
        (aligned.min_bound, LOW),
        (aligned.max_bound, HIGH),
        (aligned.get_center(), (LOW + HIGH) / 2),
        (aligned.get_extent(), HIGH - LOW),
        (aligned.get_half_extent(), (HIGH - LOW) / 2),
        (aligned.color, [1, 1, 1]),
    ):
        assert same(tensor, values) and tensor.dtype == aligned.dtype and tensor.device == where == aligned.device
    assert (aligned.volume(), aligned.get_max_extent(), aligned.is_empty()) == (6, 3, False)
    corners = {tuple(row) for row in aligned.get_box_points().numpy().tolist()}
    assert corners == {(x, y, z) for x in (0, 1) for y in (1, 3) for z in (2, 5)}
    inside = ((POINTS >= LOW) & (POINTS <= HIGH)).all(axis=1)
    rows = aligned.get_point_indices_within_bounding_box(Tensor(POINTS, device=where))
    assert rows.numpy().tolist() == np.flatnonzero(inside).tolist() and str(rows.dtype) == "Int64"


def test_an_aligned_box_moves_in_place(aligned):
    before = copy.copy(aligned)
    assert aligned.translate([1.0, 0, 0]) is aligned and same(aligned.min_bound, np.add(LOW, [1, 0, 0]))
    assert same(aligned.translate([0.0, 0, 0], relative=False).get_center(), [0, 0, 0])
    assert same(aligned.scale(2.0).get_extent(), 2 * (HIGH - LOW))
    assert same(aligned.clone().scale(0.5, aligned.min_bound).min_bound, aligned.min_bound.numpy())
    assert same(before.min_bound, LOW)  # the copy stayed
    union = before + g.AxisAlignedBoundingBox([-1.0, 2, 2], [0.5, 9, 3])
    assert same(union.min_bound, [-1, 1, 2]) and same(union.max_bound, [1, 9, 5])
    before.set_min_bound([0.5, 1, 2])
    before.set_max_bound([0.6, 3, 5])
    before.set_color([0.0, 0.5, 1])
    assert same(before.min_bound, [0.5, 1, 2]) and same(before.max_bound, [0.6, 3, 5])
    assert same(before.color, [0, 0.5, 1]) and same(before.clear().max_bound, [0, 0, 0]) and before.is_empty()


def test_the_constructor_sorts_corners_and_setters_reject_them():
    box = g.AxisAlignedBoundingBox([1.0, 0, 0], [0.0, 1, 1])
    assert same(box.min_bound, [0, 0, 0]) and repr(box) == "AxisAlignedBoundingBox[[0 0 0] - [1 1 1], Float64, CPU:0]"
    for name, work in (
        ("min_bound", lambda: box.set_min_bound([2.0, 0, 0])),
        ("max_bound", lambda: box.set_max_bound([1.0, 2])),
        ("color", lambda: box.set_color([2.0, 0, 0])),
        ("other", lambda: box + 1),
        ("min_bound", lambda: g.AxisAlignedBoundingBox([0, 0, 0], [1, 1, 1])),
        ("min_bound", lambda: setattr(box, "min_bound", [0.0, 0, 0])),
    ):
        with pytest.raises((ValueError, TypeError, AttributeError), match=name):
            work()


def test_boxes_of_points_contain_them(where):
    tensor = Tensor(POINTS, device=where)
    box = g.AxisAlignedBoundingBox.create_from_points(tensor)
    assert same(box.min_bound, POINTS.min(axis=0)) and same(box.max_bound, POINTS.max(axis=0)) and box.device == where
    assert g.AxisAlignedBoundingBox.create_from_points(tensor[:0]).is_empty()
    smallest, principal = (
        g.OrientedBoundingBox.create_from_points(tensor, method=method)
        for method in (g.MethodOBBCreate.MINIMAL_APPROX, g.MethodOBBCreate.PCA)
    )
    assert smallest.volume() <= principal.volume() and smallest.volume() <= box.volume()
    for fitted in (smallest, principal):
        local = (POINTS - fitted.center.numpy()) @ fitted.rotation.numpy()
        assert (np.abs(local) <= fitted.extent.numpy() / 2 + 1e-5).all()
    cloud = g.PointCloud(tensor)
    assert same(cloud.get_oriented_bounding_box().extent, smallest.extent.numpy())
    assert same(cloud.get_axis_aligned_bounding_box().min_bound, POINTS.min(axis=0))


def test_an_oriented_box_moves_in_place(turned, where):
    half = EXTENT / 2
    corners = CENTER + np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * half @ R.T
    assert same(turned.get_min_bound(), corners.min(axis=0)) and same(turned.get_max_bound(), corners.max(axis=0))
    assert same(turned.get_axis_aligned_bounding_box().max_bound, corners.max(axis=0)) and turned.volume() == 48
    assert np.abs(np.sort(turned.get_box_points().numpy(), axis=0) - np.sort(corners, axis=0)).max() < 1e-6
    inside = (np.abs((POINTS - CENTER) @ R) <= half).all(axis=1)
    rows = turned.get_point_indices_within_bounding_box(Tensor(POINTS, device=where))
    assert rows.numpy().tolist() == np.flatnonzero(inside).tolist()
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, (5, 6, 7)
    assert turned.transform(T) is turned and same(turned.rotation, R @ R)
    assert same(turned.center, R @ CENTER + [5, 6, 7]) and same(turned.rotate(R.T).rotation, R)
    assert same(turned.rotate(R.T, [0.0, 0, 0]).center, CENTER + R.T @ [5, 6, 7])
    assert same(turned.translate([1.0, 1, 1], relative=False).center, [1, 1, 1])
    assert same(turned.scale(2.0, [0.0, 0, 0]).center, [2, 2, 2]) and same(turned.extent, 2 * EXTENT)
    turned.set_center(CENTER)
    turned.set_rotation(R)
    turned.set_extent(EXTENT)
    assert same(turned.center, CENTER) and same(turned.rotation, R) and same(turned.extent, EXTENT)
    with pytest.raises(ValueError, match="extent"):
        turned.set_extent([-1.0, 0, 0])
    with pytest.raises(ValueError, match="R"):
        turned.set_rotation(2 * np.eye(3))
    assert turned.clear().is_empty() and repr(turned) == f"OrientedBoundingBox[Float64, {where}]"


def test_legacy_boxes_keep_corners_axes_and_color(aligned, turned, where):
    aligned.set_color([1.0, 0, 0])
    legacy = aligned.to_legacy()
    assert legacy.min_bound.tolist() == LOW.tolist() and legacy.color.tolist() == [1, 0, 0]
    back = g.AxisAlignedBoundingBox.from_legacy(legacy, aligned.dtype, where)
    assert same(back.max_bound, HIGH) and same(back.color, [1, 0, 0]) and back.device == where
    assert same(aligned.get_oriented_bounding_box().extent, HIGH - LOW)
    box = g.OrientedBoundingBox.from_legacy(turned.to_legacy())
    assert same(box.rotation, R) and str(box.dtype) == "Float32" and str(g.OrientedBoundingBox().dtype) == "Float32"


io = o3d.t.io


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


@pytest.mark.parametrize("name", ["values", "keys", "__class__", "positions"])
def test_names_that_a_map_of_tensors_uses_itself_are_reported(tmp_path, name):
    arrays = {"points": np.zeros((2, 3)), name: np.zeros(2)}
    np.savez(tmp_path / "a.npz", **arrays)
    with pytest.raises(FileError, match=rf"a\.npz.*{name}"):
        io.read_point_cloud(tmp_path / "a.npz")


SURFACE = {"vertices": np.eye(3, dtype=np.float32), "triangles": np.array([[0, 1, 2]])}


@pytest.mark.parametrize(
    ("wrong", "expected"),
    [
        ({"vertices": np.eye(3, dtype=int)}, "vertices.*expected floats"),
        ({"vertices": np.full((3, 3), np.nan)}, "vertices, row 0.*expected finite"),
        ({"vertices": np.zeros((3, 2))}, "vertices.*expected floats"),
        ({"triangles": np.array([[0, 1, 3]])}, "triangles, row 0.*expected indices of 3"),
        ({"triangles": np.array([[0, -1, 2]])}, "triangles, row 0.*expected indices of 3"),
        ({"triangles": np.array([[0.0, 1, 2]])}, "triangles.*expected integers"),
        ({"vertex_heat": np.zeros(2)}, "vertex_heat.*expected 3 rows"),
        ({"triangle_heat": np.zeros(3)}, "triangle_heat.*expected 1 rows"),
        ({"vertex_heat": np.zeros(3, np.float16)}, "heat.*float16"),
        ({"vertex_clear": np.zeros(3)}, "clear"),
        ({"tex_albedo": np.zeros((4, 4))}, "tex_albedo"),
    ],
)
def test_wrong_arrays_of_a_mesh_are_named(tmp_path, wrong, expected):
    np.savez(tmp_path / "mesh.npz", **SURFACE)
    assert io.read_triangle_mesh(tmp_path / "mesh.npz").vertex.positions.shape[0] == 3
    np.savez(tmp_path / "mesh.npz", **(SURFACE | wrong))
    with pytest.raises(FileError, match=rf"mesh\.npz.*{expected}"):
        io.read_triangle_mesh(tmp_path / "mesh.npz")


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


def test_images_keep_pixels_and_type(tmp_path):
    for pixels in (RNG.integers(0, 255, (4, 6, 3), np.uint8), RNG.integers(0, 60000, (4, 6, 1), np.uint16)):
        assert io.write_image(tmp_path / "a.png", g.Image(pixels))
        back = values_of(io.read_image(tmp_path / "a.png"))
        assert (back == pixels).all() and back.dtype == pixels.dtype


@pytest.mark.parametrize("name", ["a.jpg", "a.png"])
@pytest.mark.parametrize("mode", ["1", "L", "LA", "P", "RGB", "RGBA", "YCbCr", "CMYK"])
@pytest.mark.parametrize("progressive", [False, True])
def test_images_of_every_mode_have_the_colors_of_pillow(tmp_path, mode, name, progressive):
    image = PIL.Image.fromarray(RNG.integers(0, 255, (4, 6, 4), np.uint8), "RGBA")
    try:
        base = image if "A" in mode else image.convert("RGB")
        base.convert(mode).save(tmp_path / name, progressive=progressive)
    except OSError:  # not in this format
        return
    with PIL.Image.open(tmp_path / name) as stored:
        expected = np.asarray(stored.convert("RGB"))
    pixels = values_of(io.read_image(tmp_path / name))
    colors = pixels[..., :3] if pixels.shape[2] > 2 else np.repeat(pixels[..., :1], 3, axis=2)
    np.testing.assert_array_equal(colors, expected)
    assert pixels.shape[2] == {"1": 1, "L": 1, "LA": 2, "RGBA": 4}.get(mode, 3)

"""Orthophotos of meshes match float64 rays from above, and files store their location."""

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom.meshing.scene import orthophoto as source
from pointloom.meshing.scene.plan_grid import MAX_CELLS

ORIGIN = np.array([500_000.0, 5_400_000.0, 431.0])
FRAME = loom.WorldFrame(48.75, 9.0, 431.0)  # on the meridian of its zone
GROUND, ROOF, WALL = (51, 153, 51), (204, 26, 26), (26, 26, 230)  # of 255
BOX = ((5.25, 3.25), (11.25, 9.25), 6.0)  # low and high x and y, top


def slope(x, y):
    return 0.3 * x - 0.1 * y


def town(origin=ORIGIN, device="cpu"):
    """A slope of 20 x 16 m with a box on it, in two colors, with float64 corners."""
    x, y = np.array([0.0, 20, 20, 0]), np.array([0.0, 0, 16, 16])
    (x0, y0), (x1, y1), top = BOX
    corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    roof = [[*corner, top] for corner in corners]
    walls = [[*corner, z] for corner in corners for z in (slope(*corner), top)]
    vertices = np.vstack([np.column_stack([x, y, slope(x, y)]), roof, walls])
    triangles = [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]]
    for k in range(4):
        a, b = 8 + 2 * k, 8 + 2 * ((k + 1) % 4)
        triangles += [[a, b, a + 1], [b, b + 1, a + 1]]
    colors = np.array([GROUND] * 4 + [ROOF] * 4 + [WALL] * 8) / 255
    return loom.TriangleMesh(vertices + origin, triangles, vertex_colors=colors, device=device)


def centers(made):
    """x and y of the cell centers, rows from the north."""
    (rows, columns), (x, y), cell = made.heights.values.shape, made.heights.corner, made.heights.cell
    return np.meshgrid(x + (np.arange(columns) + 0.5) * cell, y + (np.arange(rows)[::-1] + 0.5) * cell)


def seen_from_above(vertices, triangles, x, y):
    """The highest triangle above each position, height, weights, and the distance to the nearest edge in plan."""
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    p = np.column_stack([x.ravel(), y.ravel()])[:, None]

    def side(u, v, at):
        return (v[..., 0] - u[..., 0]) * (at[..., 1] - u[..., 1]) - (v[..., 1] - u[..., 1]) * (at[..., 0] - u[..., 0])

    area = side(a, b, c)
    with np.errstate(divide="ignore", invalid="ignore"):
        w = np.stack([side(b, c, p), side(c, a, p), side(a, b, p)], -1) / area[None, :, None]
        z = w @ np.array([1.0, 0, 0]) * a[:, 2] + w[..., 1] * b[:, 2] + w[..., 2] * c[:, 2]
    inside = (w >= 0).all(axis=-1) & (area != 0)
    plan = a[:, :2], b[:, :2], c[:, :2]
    ends = np.stack([np.linalg.norm(plan[k - 1] - plan[k - 2], axis=1) for k in range(3)], -1)
    with np.errstate(divide="ignore", invalid="ignore"):
        gaps = np.abs(w * area[None, :, None]) / ends
    near = np.where(np.isfinite(gaps), gaps, np.inf).min(axis=(1, 2))
    z = np.where(inside, z, -np.inf)
    best = z.argmax(axis=1)
    rows = np.arange(len(z))
    triangle = np.where(np.isfinite(z[rows, best]), best, -1)
    heights = np.where(triangle >= 0, z[rows, best], np.nan)
    w = np.where(inside[..., None], w, 0.0)  # of a triangle without width in plan they are infinite
    return (each.reshape(x.shape + each.shape[1:]) for each in (triangle, heights, w[rows, best], near))


def test_heights_and_colors_of_a_slope_and_a_box_are_exact(device):
    made = loom.meshing.orthophoto(town(device=device), 0.5, crs="EPSG:32632")
    assert made.bounds == (500_000.0, 5_400_000.0, 500_020.5, 5_400_016.5)
    x, y = (axis - at for axis, at in zip(centers(made), ORIGIN[:2], strict=True))
    (x0, y0), (x1, y1), top = BOX
    on_box = (x > x0) & (x < x1) & (y > y0) & (y < y1)
    on_map = (x < 20) & (y < 16)
    expected = np.where(on_box, top, slope(x, y)) + ORIGIN[2]
    gaps = np.stack([x - x0, x - x1, y - y0, y - y1])
    sure = np.abs(gaps).min(axis=0) > 1e-3
    np.testing.assert_allclose(made.heights.values[on_map & sure], expected[on_map & sure], rtol=0, atol=5e-5)
    assert np.isnan(made.heights.values[~on_map]).all()
    colors = np.where(on_box[..., None], ROOF, GROUND)
    np.testing.assert_array_equal(made.colors[on_map & sure][:, :3], colors[on_map & sure])
    np.testing.assert_array_equal(made.colors[..., 3], np.where(on_map, 255, 0))
    assert not made.colors[~on_map].any()  # cells without data stay unset


@example(seed=2266, cell=0.11, corner=0.0)  # a triangle with a repeated corner
@given(seed=st.integers(0, 10_000), cell=st.sampled_from([0.11, 0.37, 1.3]), corner=st.floats(-1, 1))
@settings(max_examples=15, deadline=None)
def test_a_map_of_any_triangles_matches_float64_rays(seed, cell, corner):
    rng = np.random.default_rng(seed)
    vertices = rng.uniform(-4, 4, (24, 3)) * (1, 1, 0.5)
    triangles, colors = rng.integers(0, 24, (14, 3)), rng.random((24, 3))
    vertices[rng.integers(0, 24), 1] = np.nan
    mesh = loom.TriangleMesh(vertices + ORIGIN, triangles, vertex_colors=colors, origin=ORIGIN)
    made = loom.meshing.orthophoto(mesh, cell, corner=(corner, 0.0))
    x, y = centers(made)
    is_finite = np.isfinite(vertices[triangles]).all(axis=(1, 2))
    stored = vertices.astype(np.float32).astype(np.float64)
    triangle, heights, weights, near = seen_from_above(stored, triangles[is_finite], x - ORIGIN[0], y - ORIGIN[1])
    sure = near > 2e-5
    assert sure.mean() > 0.8
    np.testing.assert_array_equal(np.isnan(made.heights.values)[sure], np.isnan(heights)[sure])
    assert np.isfinite(heights).any()
    steepest = 1e3  # height per meter, of nearly vertical triangles
    np.testing.assert_allclose(made.heights.values[sure], heights[sure] + ORIGIN[2], rtol=0, atol=1e-3)
    mixed = (weights[..., None] * colors[triangles[is_finite][triangle]]).sum(axis=-2)
    seen = sure & (triangle >= 0)
    assert np.abs(made.colors[seen][:, :3] - 255 * mixed[seen]).max(initial=0) < 0.5 + 255 * steepest * 1e-6 + 1e-2


def test_textures_are_interpolated_between_pixels(device):
    rng = np.random.default_rng(3)
    image = rng.integers(0, 256, (8, 12, 4)).astype(np.uint8)  # alpha of images is not read
    mesh = loom.TriangleMesh(
        np.array([[0, 0, 1], [12, 0, 1], [12, 8, 3], [0, 8, 3]]) + ORIGIN, [[0, 1, 2], [0, 2, 3]], device=device,
        triangle_uvs=[[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]], textures=[image],
        vertex_colors=np.ones((4, 3)),
    )  # fmt: skip
    area = (500_000, 5_400_000, 500_012, 5_400_008)
    full = loom.meshing.orthophoto(mesh, 1.0, bounds=area)
    np.testing.assert_array_equal(full.colors[..., :3], image[..., :3])  # one cell per pixel, first row in the north
    assert (full.colors[..., 3] == 255).all()
    finer = loom.meshing.orthophoto(mesh, 0.5, bounds=area)
    values = image[..., :3].astype(np.float64)
    expected = (9 * values[3, 4] + 3 * values[3, 5] + 3 * values[4, 4] + values[4, 5]) / 16
    assert np.abs(finer.colors[7, 9, :3] - expected).max() <= 0.51


def test_each_material_uses_its_texture(device):
    squares = np.array([[[k, 0, 0], [k + 1, 0, 0], [k + 1, 1, 0], [k, 1, 0]] for k in range(3)], float).reshape(-1, 3)
    triangles = [[4 * k + j for j in corner] for k in range(3) for corner in ((0, 1, 2), (0, 2, 3))]
    options = {"triangle_uvs": np.full((18, 2), 0.5), "triangle_material_ids": [0, 0, 1, 1, 2, 2], "device": device}
    images = [np.full((2, 2, 3), value, np.uint8) for value in (60, 90)]
    mesh = loom.TriangleMesh(squares, triangles, textures=images, **options)
    made = loom.meshing.orthophoto(mesh, 0.5, bounds=(0, 0, 3, 1))
    assert made.colors[0, ::2].tolist() == [[60] * 3 + [255], [90] * 3 + [255], [0] * 4]  # the third has no image
    assert np.isfinite(made.heights.values).all()
    mesh.vertex_colors = np.full((12, 3), 0.2)
    assert loom.meshing.orthophoto(mesh, 0.5, bounds=(0, 0, 3, 1)).colors[0, 4].tolist() == [51, 51, 51, 255]


def test_strips_of_rows_give_one_map(monkeypatch):
    full = loom.meshing.orthophoto(town(), 0.5)
    monkeypatch.setattr(source, "CELLS_PER_STRIP", 100)  # two rows and a part of one
    parts = loom.meshing.orthophoto(town(), 0.5)
    np.testing.assert_array_equal(parts.heights.values, full.heights.values)
    np.testing.assert_array_equal(parts.colors, full.colors)


def test_a_frame_georeferences_the_map_in_its_utm_zone(device, monkeypatch):
    monkeypatch.setattr(source, "VERTICES_PER_PART", 5)  # several parts of vertices
    mesh = town(np.zeros(3), device)
    made = loom.meshing.orthophoto(mesh, 0.25, frame=FRAME)
    assert made.heights.crs == "EPSG:32632"
    true = FRAME.to_utm(mesh.vertices)
    x, y = centers(made)
    triangle, heights, _, near = seen_from_above(true, np.asarray(mesh.triangles), x, y)
    sure = near > 1e-4
    np.testing.assert_allclose(made.heights.values[sure], heights[sure], rtol=0, atol=2e-4)  # float32 at 431 m
    roof = sure & np.isin(triangle, (2, 3))
    assert roof.any() and (made.colors[roof] == [*ROOF, 255]).all()
    other = loom.meshing.orthophoto(mesh, 0.25, frame=FRAME, epsg=32633)
    assert other.heights.crs == "EPSG:32633" and other.bounds[0] < 1e5  # six degrees west of that zone's meridian


def test_files_store_the_map_location(tmp_path):
    rasterio, tifffile = pytest.importorskip("rasterio"), pytest.importorskip("tifffile")
    made = loom.meshing.orthophoto(town(), 0.05, crs="EPSG:32632")
    path, dem = made.write(tmp_path / "ortho.tif"), made.heights.write(tmp_path / "dem.tif")
    with tifffile.TiffFile(path) as file:
        tags = {tag.name: tag.value for tag in file.pages[0].tags.values()}
        keys = file.geotiff_metadata
    assert tags["ModelPixelScaleTag"] == (0.05, 0.05, 0.0)
    assert tags["ModelTiepointTag"] == pytest.approx((0, 0, 0, 500_000.0, 5_400_016.05, 0))
    assert keys["GTRasterTypeGeoKey"].name == "IsArea" and keys["ProjectedCSTypeGeoKey"] == 32632
    with rasterio.open(path) as file, rasterio.open(dem) as heights:
        assert [each.name for each in file.colorinterp] == ["red", "green", "blue", "alpha"]
        assert file.crs.to_epsg() == 32632 and file.tags(ns="IMAGE_STRUCTURE")["LAYOUT"] == "COG" and file.overviews(1)
        np.testing.assert_array_equal(np.moveaxis(file.read(), 0, 2), made.colors)
        column, row = 500_008.0, 5_400_006.0  # on the roof
        row, column = map(int, file.index(column, row))  # floats in rasterio 1.4.0
        assert made.colors[row, column, :3].tolist() == [*ROOF] and heights.transform == file.transform
        np.testing.assert_array_equal(heights.read(1, masked=True).filled(np.nan), made.heights.values)
    assert sorted(each.name for each in tmp_path.iterdir()) == ["dem.tif", "ortho.tif"]


def test_a_file_that_cannot_be_written_leaves_nothing(tmp_path):
    pytest.importorskip("rasterio")
    made = loom.meshing.orthophoto(town(), 1.0, crs="no system")
    with pytest.raises(loom.FileError, match="crs:"):
        made.write(tmp_path / "a.tif")
    with pytest.raises(loom.FileError, match=r"/a\.png:"):
        made.write(tmp_path / "a.png")
    (tmp_path / "b.tif").write_text("old")
    with pytest.raises(loom.FileError, match="exists already"):
        loom.meshing.orthophoto(town(), 1.0).write(tmp_path / "b.tif", overwrite=False)
    plain = loom.meshing.orthophoto(loom.TriangleMesh.create_box(), 0.5)
    assert plain.colors is None and np.nanmax(plain.heights.values) == 1
    with pytest.raises(ValueError, match=r"^colors:"):
        plain.write(tmp_path / "c.tif")
    assert [path.name for path in tmp_path.iterdir()] == ["b.tif"]


def test_an_empty_mesh_gives_an_empty_map(device):
    nothing = loom.TriangleMesh(np.full((3, 3), np.nan), [[0, 1, 2]], device=device)
    for mesh in (loom.TriangleMesh(device=device), nothing):
        with pytest.raises(ValueError, match=r"^mesh:"):
            loom.meshing.orthophoto(mesh, 1.0)
        made = loom.meshing.orthophoto(mesh, 1.0, bounds=(0, 0, 3, 2), frame=FRAME)
        assert made.heights.values.shape == (2, 3) and np.isnan(made.heights.values).all()
    upright = loom.TriangleMesh([[0, 0, 0], [1, 1, 0], [1, 1, 2]], [[0, 1, 2]], device=device)
    assert np.isnan(loom.meshing.orthophoto(upright, 0.4).heights.values).all()  # a wall has no width from above


@pytest.mark.parametrize("cell", [1e-3, 1e-7, 1e-300])
def test_too_many_cells_are_rejected_with_a_suitable_cell_size(cell):
    with pytest.raises(ValueError, match="cell:") as caught:
        loom.meshing.orthophoto(town(), cell)
    fits = float(str(caught.value).split("a cell of ")[1].split(" fits")[0])
    assert 0.8 < 20 * 16 / fits**2 / MAX_CELLS <= 1  # and none that is much smaller does


def test_units_other_than_meters_are_rejected():
    mesh = town()
    mesh.unit = "foot"
    assert loom.meshing.orthophoto(mesh, 1.0).heights.values.shape == (17, 21)
    with pytest.raises(ValueError, match="mesh:"):
        loom.meshing.orthophoto(mesh, 1.0, frame=FRAME)
    mesh.unit = "degree"
    with pytest.raises(ValueError, match="mesh:"):
        loom.meshing.orthophoto(mesh, 1.0)

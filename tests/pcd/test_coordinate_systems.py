"""Coordinate systems of clouds and meshes: kept by operations and files, compared where two meet, converted."""

import copy
import pickle
import warnings
from functools import partial

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.coordinate_systems import CoordinateSystem
from pointloom.io.meshes.mesh_formats import MESH_FORMATS
from pointloom.io.points.formats import WRITTEN
from pointloom.io.points.header_units import WITH_SYSTEMS
from pointloom.io.points.las_wkt import LostSystemWarning
from pointloom.io.table import MeshTable, PointTable

ZONE_32 = "EPSG:25832"
CORNER = np.array([412300.0, 5651200.0, 120.0])  # in zone 32
NAMES = [".ply", ".pcd", ".npz", ".las", ".laz", ".copc.laz", ".e57"]


@pytest.fixture
def cloud(rng, device):
    points = rng.random((500, 3)) * (50, 50, 5) + CORNER
    return loom.PointCloud(points, crs=ZONE_32, quality=rng.random(500).astype(np.float32), device=device)


@pytest.fixture
def mesh(device):
    return loom.TriangleMesh.create_sphere(10.0, device=device).compute_vertex_normals().translate(CORNER)


OPERATIONS = {
    "slice": lambda cloud: cloud[::2],
    "mask": lambda cloud: cloud.select_by_mask(np.arange(len(cloud)) < 100),
    "copy": lambda cloud: cloud.copy(),
    "deepcopy": copy.deepcopy,
    "pickle": lambda cloud: pickle.loads(pickle.dumps(cloud)),
    "crop": lambda cloud: cloud.crop(cloud.get_axis_aligned_bounding_box()),
    "voxels": lambda cloud: cloud.voxel_down_sample(5.0),
    "thin": lambda cloud: cloud.thin(5.0),
    "random": lambda cloud: cloud.random_down_sample(0.5),
    "farthest": lambda cloud: cloud.farthest_point_down_sample(10),
    "normals": lambda cloud: cloud.estimate_normals(max_nn=10),
    "covariances": lambda cloud: cloud.estimate_covariances(max_nn=10),
    "without": lambda cloud: cloud.without("quality"),
    "outliers": lambda cloud: cloud.remove_statistical_outlier(10, 2.0)[0],
    "duplicates": lambda cloud: cloud.remove_duplicated_points(),
    "translate": lambda cloud: cloud.translate((0.02, 0.0, 0.0)),
    "rotate": lambda cloud: cloud.rotate(np.eye(3)),
    "transform": lambda cloud: cloud.transform(np.eye(4)),
    "paint": lambda cloud: cloud.paint_uniform_color((1, 0, 0)),
    "smooth": lambda cloud: cloud.smooth_mls(radius=10.0),
    "concatenate": lambda cloud: loom.PointCloud.concatenate([cloud, cloud]),
    "concatenate with unknown": lambda cloud: loom.PointCloud(CORNER[None]) + cloud.without("quality"),
    "ground": lambda cloud: cloud[loom.classify_ground(cloud)],
    "device": lambda cloud: cloud.to("cpu"),
}


@pytest.mark.parametrize("name", OPERATIONS)
def test_operations_keep_the_system(cloud, name):
    if name == "concatenate with unknown":
        cloud = cloud.to("cpu")
    assert OPERATIONS[name](cloud).crs == ZONE_32


MESH_OPERATIONS = {
    "crop": lambda mesh: mesh.crop(mesh.get_axis_aligned_bounding_box()),
    "simplify": lambda mesh: mesh.simplify_quadric_decimation(200),
    "clusters": lambda mesh: mesh.simplify_vertex_clustering(2.0),
    "subdivide": lambda mesh: mesh.subdivide_midpoint(),
    "smooth": lambda mesh: mesh.filter_smooth_taubin(2),
    "repair": lambda mesh: mesh.repair()[0],
    "clean": lambda mesh: loom.meshing.clean_mesh(mesh).mesh,
    "pickle": lambda mesh: pickle.loads(pickle.dumps(mesh)),
    "transform": lambda mesh: mesh.transform(np.eye(4)),
    "select": lambda mesh: mesh.select_by_index(np.arange(50)),
    "remove": lambda mesh: mesh.remove_triangles_by_index([0]),
    "clip": lambda mesh: mesh.clip_plane(CORNER, (0.0, 0.0, 1.0)),
    "sample": lambda mesh: mesh.sample_points_uniformly(10),
    "concatenate": lambda mesh: loom.TriangleMesh.concatenate([mesh, mesh]),
    "hull": lambda mesh: mesh.compute_convex_hull(),
    "device": lambda mesh: mesh.to("cpu"),
}


@pytest.mark.parametrize("name", MESH_OPERATIONS)
def test_operations_of_meshes_keep_the_system(mesh, name):
    mesh.crs = 25832
    result = MESH_OPERATIONS[name](mesh)
    assert (result[0] if isinstance(result, tuple) else result).crs == ZONE_32


def test_surfaces_and_maps_have_the_system_of_their_cloud(cloud):
    assert loom.meshing.create_surface(cloud.estimate_normals(max_nn=10), depth=4).mesh.crs == ZONE_32
    assert loom.rasterize(cloud, 5.0, "dsm").crs == ZONE_32
    with pytest.raises(ValueError, match=r"^crs, cloud: expected one coordinate system, got EPSG:25833 and EPSG:25832"):
        loom.rasterize(cloud, 5.0, "dsm", crs="EPSG:25833")


def test_a_change_of_lengths_drops_the_system(cloud):
    cloud.unit = "metre"
    assert cloud.scale(2.0).crs is None and cloud.to_unit("foot").crs is None and cloud.to_unit("metre").crs == 25832


@pytest.mark.parametrize("extension", NAMES)
def test_files_keep_the_system(cloud, tmp_path, extension):
    path = tmp_path / f"cloud{extension}"
    loom.write_point_cloud(path, cloud if extension != ".e57" else cloud.without("quality"))
    stored = loom.read_point_cloud(path).crs
    assert stored is not None and stored == 25832 and stored.epsg == 25832


def test_a_las_file_read_and_written_has_the_same_text(cloud, tmp_path):
    loom.write_point_cloud(tmp_path / "a.laz", cloud)
    once = loom.read_point_cloud(tmp_path / "a.laz")
    loom.write_point_cloud(tmp_path / "b.laz", once)
    assert loom.read_point_cloud(tmp_path / "b.laz").crs.text == once.crs.text
    assert (tmp_path / "a.laz").read_bytes() == (tmp_path / "b.laz").read_bytes()
    assert [chunk.crs for chunk in loom.read_las_chunks(tmp_path / "a.laz", 300)] == [ZONE_32, ZONE_32]


def test_stations_have_the_system_of_their_world(cloud, tmp_path):
    pose = np.eye(4)
    pose[:3, 3] = CORNER
    scan = cloud.without("quality").translate(-CORNER)
    loom.write_stations(tmp_path / "a.e57", [scan], [pose], crs=25832)
    assert loom.read_stations(tmp_path / "a.e57").crs == 25832
    assert loom.read_point_cloud(tmp_path / "a.e57").crs == 25832


@pytest.mark.parametrize("extension", WRITTEN)
def test_a_cloud_format_stores_the_system_or_warns_and_names_those_that_do(cloud, tmp_path, extension):
    full = cloud.without("quality").paint_uniform_color((1, 0, 0)).estimate_normals(max_nn=10)
    write = partial(loom.write_point_cloud, drop_unsupported=True)
    check_system(full, tmp_path / f"a{extension}", write, loom.read_point_cloud)


@pytest.mark.parametrize("extension", MESH_FORMATS)
def test_a_mesh_format_stores_the_system_or_warns_and_names_those_that_do(mesh, tmp_path, extension):
    mesh.crs = 25832
    check_system(mesh, tmp_path / f"a{extension}", loom.write_triangle_mesh, loom.read_triangle_mesh)


def check_system(shape, path, write, read):
    others = WITH_SYSTEMS[PointTable if isinstance(shape, loom.PointCloud) else MeshTable]
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", LostSystemWarning)
        write(path, shape)
    lost = [str(entry.message) for entry in caught if entry.category is LostSystemWarning]
    if path.suffix in others:
        assert not lost and read(path).crs == 25832
    else:
        named = f"{', '.join(others[:-1])} and {others[-1]}"
        assert lost == [f"{path}: the format cannot store the coordinate system EPSG:25832; {named} can"]


def test_the_argument_of_the_writer(cloud, tmp_path):
    cloud.crs = None
    loom.write_point_cloud(tmp_path / "a.las", cloud, crs="EPSG:25832")
    assert loom.read_point_cloud(tmp_path / "a.las").crs == 25832
    cloud.crs = 25833
    with pytest.raises(ValueError, match=r"^crs, cloud: expected one coordinate system, got EPSG:25832 and EPSG:25833"):
        loom.write_point_cloud(tmp_path / "b.las", cloud, crs="EPSG:25832")
    with pytest.raises(loom.FileError, match="coordinate system of the points is EPSG:25833, that of the file in like"):
        loom.write_point_cloud(tmp_path / "b.las", cloud, like=tmp_path / "a.las")


MEETINGS = {
    "concatenate": lambda a, b: a + b,
    "distance": lambda a, b: a.compute_point_cloud_distance(b),
    "metrics": lambda a, b: loom.compute_metrics(a, b),
    "change": lambda a, b: loom.m3c2(a, b, cylinder_radius=5.0, max_distance=5.0),
    "icp": lambda a, b: loom.registration.registration_icp(a, b, 1.0),
    "icp batch": lambda a, b: loom.registration.registration_icp_batch([a], [b], 1.0),
    "evaluation": lambda a, b: loom.registration.evaluate_registration(a, b, 1.0),
    "pair": lambda a, b: loom.registration.register_pair(a, b),
    "multiway": lambda a, b: loom.registration.register_multiway([a, b], voxel_size=1.0),
    "stations": lambda a, b: loom.registration.register_stations([a, b]),
    "render": lambda a, b: loom.render([a, b], size=(64, 48)),
    "mesh": lambda a, b: loom.meshing.compare_cloud_to_mesh(a, _mesh_at(b)),
    "meshes": lambda a, b: loom.meshing.compare_meshes(_mesh_at(a), _mesh_at(b)),
}


def _mesh_at(cloud):
    mesh = loom.TriangleMesh.create_box(9.0, 9.0, 9.0, device=cloud.device).translate(cloud.get_center())
    mesh.crs = cloud.crs
    return mesh


@pytest.mark.parametrize("name", MEETINGS)
def test_two_systems_that_meet_are_an_error(cloud, name):
    other = cloud.copy()
    other.crs = 25833
    with pytest.raises(ValueError, match=r"expected one coordinate system, got EPSG:25832 and EPSG:25833\. Convert"):
        MEETINGS[name](cloud, other)


def test_reprojection_agrees_with_pyproj(cloud):
    pyproj = pytest.importorskip("pyproj")
    scan = cloud.estimate_normals(max_nn=10)
    moved = scan.reproject(25833)
    way = pyproj.Transformer.from_crs(25832, 25833, always_xy=True)
    expected = np.column_stack([*way.transform(*scan.points[:, :2].T), scan.points[:, 2]])
    np.testing.assert_allclose(moved.points, expected, atol=4e-6)
    assert moved.crs == 25833 and moved.unit == "metre" and moved["quality"].tolist() == scan["quality"].tolist()
    a, b = (np.array(way.transform(*CORNER[:2] + step)) for step in np.array([[0, 0], [0, 1]]))
    scale, north = np.linalg.norm(b - a), (b - a) / np.linalg.norm(b - a)  # grid north of zone 32 in zone 33
    R = np.array([[north[1], north[0], 0], [-north[0], north[1], 0], [0, 0, 1]])
    turned = scan.normals @ R.T / (scale, scale, 1)  # heights are not scaled
    np.testing.assert_allclose(moved.normals, turned / np.linalg.norm(turned, axis=1)[:, None], atol=2e-5)
    np.testing.assert_allclose(moved.reproject(ZONE_32).points, scan.points, atol=8e-6)


def test_reprojection_to_degrees_and_of_meshes(cloud, mesh):
    degrees = cloud.reproject("EPSG:4258")
    assert degrees.unit == "degree" and np.abs(degrees.points[:, 0] - 7.75).max() < 0.01
    mesh.crs = 25832
    moved = mesh.reproject(25833)
    assert moved.crs == 25833 and len(moved) == len(mesh)
    sizes = [shape.get_axis_aligned_bounding_box().get_extent()[2] for shape in (mesh, moved)]
    assert sizes[0] == pytest.approx(sizes[1], abs=1e-5)


def test_wrong_arguments_of_reprojection(cloud):
    with pytest.raises(TypeError, match=r"^epsg: expected a coordinate system such as 25832, got None"):
        cloud.reproject(None)
    with pytest.raises(ValueError, match=r"^epsg: pyproj does not contain the coordinate system"):
        cloud.reproject(99999)
    with pytest.raises(ValueError, match=r"^epsg: x and y would be in US survey foot, and heights stay in metre"):
        cloud.reproject(2229)
    with pytest.raises(ValueError, match=r"^cloud: covariances cannot be reprojected"):
        cloud.estimate_covariances(max_nn=10).reproject(25833)
    cloud.crs = None
    with pytest.raises(ValueError, match=r"^crs: the coordinate system is unknown"):
        cloud.reproject(25833)


def test_texts_codes_and_objects_are_one_system():
    pyproj = pytest.importorskip("pyproj")
    cloud, system = loom.PointCloud(CORNER[None]), pyproj.CRS.from_epsg(25832)
    for given in (25832, "EPSG:25832", "epsg:25832", system, system.to_wkt(), system.to_wkt("WKT1_GDAL")):
        cloud.crs = given
        assert cloud.crs == 25832 and cloud.crs == ZONE_32 and cloud.crs.epsg == 25832 and cloud.crs != 25833
        assert hash(cloud.crs) == hash(CoordinateSystem(ZONE_32))
    assert "EPSG:25832" in repr(loom.PointCloud(CORNER[None], crs=25832))
    cloud.crs = "EPSG:25832+7837"
    assert cloud.crs.epsg == 25832 and (cloud + loom.PointCloud(CORNER[None], crs=25832)).crs == "EPSG:25832+7837"
    with pytest.raises(ValueError, match=r"^clouds: expected one coordinate system"):
        cloud + loom.PointCloud(CORNER[None], crs="EPSG:25832+5783")


@pytest.mark.parametrize(
    ("value", "error"), [(3.5, TypeError), (True, TypeError), ("", ValueError), ("zone", ValueError)]
)
def test_wrong_systems_are_rejected(value, error):
    with pytest.raises(error, match=r"^crs: expected a coordinate system such as 'EPSG:25832' or 25832, got"):
        loom.PointCloud(CORNER[None], crs=value)


UNNAMED = "+proj=tmerc +lat_0=1 +lon_0=9.5 +k=1 +x_0=1000 +y_0=0 +ellps=GRS80 +units=m"


@pytest.mark.parametrize("suffix", [".las", ".laz", ".copc.laz", ".ply", ".pcd", ".npz", ".e57"])
@pytest.mark.parametrize("form", ["WKT1_GDAL", "WKT2_2019"])
@pytest.mark.parametrize("given", [UNNAMED, UNNAMED + " +towgs84=1,2,3", "+proj=longlat +ellps=bessel"])
def test_a_system_that_proj_calls_unknown_is_kept(rng, tmp_path, given, form, suffix):
    pyproj = pytest.importorskip("pyproj")
    text = pyproj.CRS(given).to_wkt(form)
    assert '"unknown"' in text[:60]
    if suffix == ".e57" and "longlat" in given:
        pytest.skip("lengths in E57 are meters")
    cloud = loom.PointCloud(rng.random((9, 3)) * 1e-3 + np.array([9, 1, 0]), crs=text)
    cloud.unit = "degree" if "longlat" in given else "metre"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", loom.GeographicWarning)
        loom.write_point_cloud(tmp_path / f"a{suffix}", cloud)
        read = loom.read_point_cloud(tmp_path / f"a{suffix}").crs
    assert read is not None and pyproj.CRS(read.text) == pyproj.CRS(text)


def test_two_systems_that_proj_calls_unknown_are_different():
    pyproj = pytest.importorskip("pyproj")
    texts = [pyproj.CRS(UNNAMED.replace("9.5", lon)).to_wkt("WKT1_GDAL") for lon in ("9.5", "9.5", "12")]
    first, same, other = (loom.PointCloud([[0, 0, 0.0]], crs=text) for text in texts)
    assert (first + same).crs == first.crs != other.crs
    with pytest.raises(ValueError, match="expected one coordinate system"):
        _ = first + other


@pytest.mark.parametrize("crs", ["EPSG:25832+7837", "wkt"])
def test_rasters_of_heights_have_the_system_of_the_heights(rng, tmp_path, crs):
    pyproj = pytest.importorskip("pyproj")
    text = pyproj.CRS("EPSG:25832+7837").to_wkt("WKT1_GDAL") if crs == "wkt" else crs
    points = rng.random((2000, 3)) * [20, 20, 1] + CORNER
    cloud = loom.PointCloud(points, crs=text, classification=np.full(2000, 2, np.uint8))
    for kind in ("dtm", "dsm", "lowest"):
        path = loom.rasterize(cloud, 2.0, kind).write(tmp_path / f"{kind}.tif")
        stored = pyproj.CRS(loom.read_raster(path).crs)
        assert stored.is_compound and stored.sub_crs_list[1].to_epsg() == 7837

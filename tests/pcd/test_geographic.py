"""Degrees, UTM, and coordinates about a place: published points, PROJ's results, and the defining properties."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom.kernels.algebra.transverse_mercator import project_degrees
from pointloom.kernels.lang import vec3d
from pointloom.kernels.memory import download, upload
from pointloom.pcd.geodesy import from_utm, geocentric, geodetic, utm, utm_zone
from pointloom.pcd.geographic import mercator, utm_epsg

WGS84 = 6378137.0, 1 / 298.257223563


def transverse_mercator(longitudes, latitudes, radius, flattening, device="cpu"):
    degrees = np.stack([longitudes, latitudes, np.zeros(len(longitudes))], axis=1)
    result = download(project_degrees(upload(degrees, vec3d, device), mercator(0.0, radius, flattening)))
    return result[:, 0], result[:, 1]


def test_snyders_example():
    """Snyder 1987, "Map Projections: A Working Manual", page 269: Clarke 1866, given to 0.1 m."""
    flattening = 1 - np.sqrt(1 - 0.00676866)
    easting, northing = transverse_mercator(np.array([1.5]), np.array([40.5]), 6378206.4, flattening)
    assert abs(0.9996 * easting[0] - 127106.5) < 0.06
    assert abs(0.9996 * northing[0] - 4484124.4) < 0.06


def test_the_meridian_keeps_its_length():
    latitudes = np.array([-79.5, -33.3, 0.0, 12.25, 51.0, 84.0])
    easting, northing = transverse_mercator(np.zeros(6), latitudes, *WGS84)
    squared = WGS84[1] * (2 - WGS84[1])
    for latitude, result in zip(latitudes, northing, strict=True):
        nodes, weights = np.polynomial.legendre.leggauss(40)
        half = np.radians(latitude) / 2
        curvature = (1 - squared) / (1 - squared * np.sin(half * (nodes + 1)) ** 2) ** 1.5
        assert abs(result - WGS84[0] * half * (weights @ curvature)) < 1e-8 + 1e-14 * abs(result)
    np.testing.assert_array_equal(easting, 0)


@settings(max_examples=25, derandomize=True, deadline=None, database=None)
@given(st.floats(-30, 30), st.floats(-80, 84))
def test_projection_is_conformal(longitude, latitude):
    """With the length of the meridian this defines the projection: north and east stay orthogonal."""
    step, squared = 1e-5, WGS84[1] * (2 - WGS84[1])
    around = np.array([[step, 0], [-step, 0], [0, step], [0, -step]]) + np.array([longitude, latitude])
    east, north = transverse_mercator(around[:, 0], around[:, 1], *WGS84)
    projected = np.stack([east, north], axis=1)
    root = np.sqrt(1 - squared * np.sin(np.radians(latitude)) ** 2)
    to_east = (projected[0] - projected[1]) * root / np.cos(np.radians(latitude))
    to_north = (projected[2] - projected[3]) * root**3 / (1 - squared)
    rotated = [-to_north[0], to_north[1]]
    np.testing.assert_allclose([to_east[1], to_east[0]], rotated, rtol=0, atol=2e-7 * abs(to_north).max())


def test_longitudes_beyond_the_antimeridian_belong_to_the_zones_on_both_sides(device):
    """3.1 degrees west of 177 W is 179.9 E, and 3.1 degrees east of 177 E is 179.9 W."""
    expected = transverse_mercator(np.array([-3.1, 3.1]), np.array([10.0, -20.0]), *WGS84)
    for k, (meridian, longitude) in enumerate([(-177.0, 179.9), (177.0, -179.9)]):
        degrees = upload(np.array([[longitude, [10.0, -20.0][k], 0.0]]), vec3d, device)
        result = download(project_degrees(degrees, mercator(meridian, *WGS84)))[0]
        np.testing.assert_allclose(result[:2], [expected[0][k], expected[1][k]], rtol=0, atol=1e-6)


def test_projected_cloud_is_in_meters_with_all_attributes(device):
    tower = [-79.387139, 43.642567, 553.0]  # the CN Tower, 630084 E, 4833438 N according to the article on UTM
    cloud = loom.PointCloud([tower, [np.nan, 0, 0]], colors=[[1, 0, 0], [0, 1, 0]], ring=[3, 4], device=device)
    result = loom.project_to_utm(cloud)
    assert result["ring"].tolist() == [3, 4]
    assert result.has_colors
    assert str(result.device) == device
    assert np.isnan(result.points[1, 0])
    np.testing.assert_allclose(result.points[0], [630084, 4833438, 553], rtol=0, atol=1)
    np.testing.assert_allclose(cloud.points[0], tower, rtol=0, atol=1e-9)  # one point in degrees is not rounded


def test_the_south_counts_from_ten_million_and_a_zone_may_be_given():
    cloud = loom.PointCloud([[177.0, -0.001, 0]])
    assert utm_epsg(cloud) == 32760
    assert abs(loom.project_to_utm(cloud).points[0, 1] - (1e7 - 110.53)) < 0.01
    across = loom.PointCloud([[-179.9, -0.001, 0]])  # another zone, starting at the same meridian
    assert utm_epsg(across) == 32701
    assert loom.project_to_utm(across, epsg=32760).points[0, 0] > loom.project_to_utm(cloud).points[0, 0]
    assert utm_epsg(loom.PointCloud([[180.0, 3.0, 0]])) == 32601
    assert utm_epsg(loom.PointCloud([[359.0, 3.0, 0]])) == 32630


NM = 5e-9  # [m] five nanometers: the last digit of 10,000 km in float64 is two


def coordinates(count=200):
    rng = np.random.default_rng(0)
    return np.column_stack([rng.uniform(-80, 84, count), rng.uniform(-180, 180, count), rng.uniform(-400, 9000, count)])


def test_metres_from_the_middle_of_the_earth_are_projs_and_lead_back():
    pyproj = pytest.importorskip("pyproj")
    p = coordinates()
    true = np.column_stack(pyproj.Transformer.from_crs(4979, 4978, always_xy=True).transform(p[:, 1], p[:, 0], p[:, 2]))
    assert np.abs(geocentric(p) - true).max() < NM
    back = geodetic(geocentric(p))
    assert np.abs(back[:, :2] - p[:, :2]).max() < 1e-13
    assert np.abs(back[:, 2] - p[:, 2]).max() < NM


@pytest.mark.parametrize(("latitude", "longitude", "epsg"), [(47, 8.2, 32632), (-33, 151.2, 32756), (64, -21, 32627)])
def test_utm_is_projs_and_leads_back(latitude, longitude, epsg):
    pyproj = pytest.importorskip("pyproj")
    assert utm_zone(latitude, longitude) == epsg
    p = (coordinates() - (2, 0, 0)) / (82, 90, 10) + (latitude, longitude, 0)
    true = np.column_stack(pyproj.Transformer.from_crs(4326, epsg, always_xy=True).transform(p[:, 1], p[:, 0]))
    result = utm(p, epsg)
    assert np.abs(result[:, :2] - true).max() < NM
    assert np.abs(from_utm(result, epsg) - p).max() < 1e-12


def test_enu_coordinates_agree_with_proj():
    pyproj = pytest.importorskip("pyproj")
    way = "+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad +step +proj=cart +ellps=WGS84 +step "
    way += "+proj=topocentric +ellps=WGS84 +lon_0=8.2 +lat_0=47.5 +h_0=400"
    p = coordinates() / (8000, 18000, 100) + (47.5, 8.2, 400)
    true = np.column_stack(pyproj.Transformer.from_pipeline(way).transform(p[:, 1], p[:, 0], p[:, 2]))
    frame = loom.WorldFrame(47.5, 8.2, 400.0)
    assert np.abs(frame.to_enu(p) - true).max() < NM
    assert np.abs(frame.to_geodetic(true) - p).max() < NM


def test_the_axes_are_east_north_and_up():
    frame = loom.WorldFrame(-33.0, 151.0, 20.0)
    e, n, u = frame.to_enu([[-33.0, 151.001, 20.0], [-32.999, 151.0, 20.0], [-33.0, 151.0, 21.0]])
    assert e[0] > 90 and abs(e[1]) < 1e-3 and n[1] > 110 and abs(n[0]) < 1e-9
    np.testing.assert_allclose(u, [0, 0, 1], atol=1e-9)


def test_coordinates_outside_the_zone_are_rejected():
    with pytest.raises(ValueError, match=r"^points:.*32632"):
        from_utm(np.array([[8.25, 47.5, 400.0]]) * 1e6, 32632)
    with pytest.raises(ValueError, match="epsg:"):
        utm(np.zeros((1, 3)), 25832)


@pytest.mark.parametrize(("latitude", "longitude", "zone"), [
    (60.4, 5.3, 32), (56, 3, 32), (63.9, 11.9, 32), (55.9, 5.3, 31), (64, 5.3, 31), (60.4, 2.9, 31), (60.4, 12, 33),
    (78, 8.9, 31), (78.2, 9, 33), (78.2, 20.9, 33), (78.2, 21, 35), (78, 33, 37), (78, 41.9, 37), (78, 42, 38),
    (71.9, 9, 32), (78, -0.1, 30), (-60.4, 5.3, 31), (0, 179.9, 60), (0, -180, 1),
])  # fmt: skip
def test_zones_have_the_exceptions_of_norway(latitude, longitude, zone):
    assert loom.WorldFrame(latitude, longitude).epsg == (32600 if latitude >= 0 else 32700) + zone
    cloud = loom.PointCloud([[longitude, latitude, 1.0]], unit="degree")
    assert loom.project_to_utm(cloud).crs.epsg == loom.WorldFrame(latitude, longitude).epsg

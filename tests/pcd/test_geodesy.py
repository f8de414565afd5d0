"""Geodetic conversions agree with PROJ to a few nanometers and are inverse to each other."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.pcd.geodesy import from_utm, geocentric, geodetic, utm, utm_zone

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
    frame = loom.video.WorldFrame(47.5, 8.2, 400.0)
    assert np.abs(frame.to_enu(p) - true).max() < NM
    assert np.abs(frame.to_geodetic(true) - p).max() < NM


def test_the_axes_are_east_north_and_up():
    frame = loom.video.WorldFrame(-33.0, 151.0, 20.0)
    e, n, u = frame.to_enu([[-33.0, 151.001, 20.0], [-32.999, 151.0, 20.0], [-33.0, 151.0, 21.0]])
    assert e[0] > 90 and abs(e[1]) < 1e-3 and n[1] > 110 and abs(n[0]) < 1e-9
    np.testing.assert_allclose(u, [0, 0, 1], atol=1e-9)


def test_coordinates_outside_the_zone_are_rejected():
    with pytest.raises(ValueError, match=r"^points:.*32632"):
        from_utm(np.array([[8.25, 47.5, 400.0]]) * 1e6, 32632)
    with pytest.raises(ValueError, match="epsg:"):
        utm(np.zeros((1, 3)), 25832)

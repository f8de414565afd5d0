"""Features, thinning and comparisons with another epoch by tiles are those of one machine, whatever the tiles' size."""

from __future__ import annotations

import numpy as np
import pytest

import pointloom as loom

from .scenes import rows_of, survey, tiled, whole_cloud

SIZES = [17.3, 10.0, 100.0]


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    return survey(tmp_path_factory.mktemp("first"))


def same(found, expected, *names):
    """Hold that two clouds have the same rows, and in them the same bits of attributes; there are some."""
    assert len(expected) > 0
    tables = []
    for cloud in (found, expected):
        columns = [rows_of_all(cloud)]
        for name in names:
            values = np.asarray(cloud[name]).reshape(len(cloud), -1)
            assert np.isfinite(values.astype(np.float64)).mean() > 0.1, name
            columns.append(values.astype(np.float64).view(np.int64))
        rows = np.column_stack(columns)
        tables.append(rows[np.lexsort(rows.T)])
    np.testing.assert_array_equal(*tables)


def rows_of_all(cloud):
    places = np.rint((cloud.points - cloud.origin) / 1e-7).astype(np.int64)
    return np.column_stack([places, np.asarray(cloud["gps_time"], np.float64)[:, None].view(np.int64)])


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("search", [{"radius": 1.0, "max_nn": None}, {"max_nn": 12}], ids=["radius", "nearest"])
def test_features_of_tiles_are_those_of_one_machine(files, tmp_path, size, search):
    names = ["linearity", "planarity", "sphericity", "curvature", "verticality", "density"]
    found, plan = tiled(files, [{"step": "features", "names": names} | search], tmp_path / "job", size=size)
    expected = loom.compute_eigen_features(whole_cloud(files, np.array(plan["origin"])), **search)
    same(found, expected, *names)
    assert "omnivariance" not in found.attributes


@pytest.mark.parametrize("size", SIZES)
def test_tiles_are_thinned_as_one_machine_thins(files, tmp_path, size):
    steps = [{"step": "thin", "spacing": 0.9}, {"step": "estimate_normals", "max_nn": 8}]
    found, plan = tiled(files, steps, tmp_path / "job", size=size)
    cloud = whole_cloud(files, np.array(plan["origin"])).thin(0.9)
    assert len(cloud) < 3000
    expected = cloud.estimate_normals(max_nn=8).orient_normals_to_align_with_direction()
    np.testing.assert_array_equal(rows_of(found), rows_of(expected))


def test_names_of_features_are_checked(files, tmp_path):
    with pytest.raises(ValueError, match=r"no feature 'planar'.*planarity"):
        loom.scale.plan_tiles(files, [{"step": "features", "names": ["planar"]}], tmp_path / "job")
    with pytest.raises(ValueError, match="names: expected some of"):
        loom.scale.plan_tiles(files, [{"step": "features", "names": []}], tmp_path / "job")

"""Attributes whose names a format does not support are renamed with a warning."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.io.attribute_names import NameRules, is_word, new_names
from pointloom.io.meshes.tables import write_cloud_table
from pointloom.io.points.ply import read_ply
from pointloom.io.table import PointTable

WORDS = {"Pulse width": "Pulse_width", "größe": "gr__e", "": "_", "a\tb": "a_b"}
LONG = "Reflectance of the second return 2"  # 34 bytes


def test_names_unsupported_by_the_format_are_changed(tmp_path):
    for suffix, names in (
        (".ply", WORDS | {"x": "x_2"}),
        (".pcd", WORDS | {"x": "x_2", "": "__2", "_": "__2", "rgb": "rgb_2"}),
        (".npz", {"a/b": "a_b", "": "_", "new\nline": "new_line", "grid": "grid_2"}),
        (".las", {LONG: LONG[:32], "": "_", "new\nline": "new_line", "X": "X_2", "red": "red_2"}),
        (".copc.laz", {LONG: LONG[:32]}),
    ):
        for old, new in names.items():
            cloud = loom.PointCloud(np.eye(3), **{old: np.array([1.5, -2, 3], np.float32)})
            with pytest.warns(UserWarning, match="under other names"):
                loom.write_point_cloud(tmp_path / f"a{suffix}", cloud)
            assert loom.read_point_cloud(tmp_path / f"a{suffix}")[new].tolist() == [1.5, -2, 3]


def test_names_that_would_become_one_stay_apart(tmp_path):
    for suffix, names, changed in (
        (".ply", ["a b", "a_b", "a\tb"], ["a_b_2", "a_b", "a_b_3"]),
        (".ply", ["nx", "ny", "nz"], ["nx", "ny", "nz_2"]),  # no normals
        (".ply", ["red", "green", "blue"], ["red", "green", "blue_2"]),
        (".pcd", ["normal x", "normal_y", "normal_z"], ["normal_x_2", "normal_y", "normal_z"]),
        (".las", [LONG, LONG + "b", "b" * 32], [LONG[:32], LONG[:30] + "_2", "b" * 32]),
    ):
        cloud = loom.PointCloud(np.eye(3), **{name: np.full(3, k, np.int16) for k, name in enumerate(names)})
        with pytest.warns(UserWarning, match="under other names"):
            loom.write_point_cloud(tmp_path / f"a{suffix}", cloud)
        read = loom.read_point_cloud(tmp_path / f"a{suffix}")
        assert [read[name].tolist() for name in changed] == [[k] * 3 for k in range(3)]
        assert not read.has_normals and not read.has_colors


def test_components_take_names_too():
    pairs = np.zeros((2, 2))
    assert new_names({"a": pairs, "a_1": pairs[0]}, NameRules(is_word)) == {"a_1": "a_1_2"}
    assert new_names({"b c": pairs}, NameRules(is_word, max_bytes=4)) == {"b c": "b_"}


@pytest.mark.parametrize("suffix", [".las", ".laz"])
def test_values_out_of_range_of_a_standard_dimension_get_an_extra_one(suffix, tmp_path):
    columns = {"intensity": np.array([0.0, 0.1, 0.9]), "classification": np.array([-1, 0, 300])}
    with pytest.warns(UserWarning, match="'intensity_value', 'classification' as 'classification_value'"):
        loom.write_point_cloud(tmp_path / f"a{suffix}", loom.PointCloud(np.eye(3), **columns))
    read = loom.read_point_cloud(tmp_path / f"a{suffix}")
    for name, values in columns.items():
        np.testing.assert_array_equal(read[f"{name}_value"], values)


def test_mesh_attribute_names_are_valid_in_ply(tmp_path):
    values = np.arange(3, dtype=np.float32)
    mesh = loom.TriangleMesh(np.eye(3), [[0, 1, 2]], vertex_attributes={"a b": values, "x": values})
    mesh.triangle_attributes["vertex_indices"] = values[:1]
    with pytest.warns(UserWarning, match=r"/a\.ply:"):
        loom.write_triangle_mesh(tmp_path / "a.ply", mesh)
    read = loom.read_triangle_mesh(tmp_path / "a.ply")
    assert sorted(read.vertex_attributes) == ["a_b", "x_2"] and [*read.triangle_attributes] == ["vertex_indices_2"]


TYPES = [([2**31 - 1, -1], "i4"), ([2**32 - 1, 0], "u4"), ([2**53, -1], "f8"), ([2**53 + 1, 0], None), ([], "i4")]


@pytest.mark.parametrize(("values", "kind"), TYPES)
def test_convert_writes_64_bit_integers_to_ply_if_none_changes(values, kind, tmp_path):
    table = PointTable(np.zeros((len(values), 3)), attributes={"label": np.array(values, np.int64)})
    assert write_cloud_table(tmp_path / "a.ply", table) == ([] if kind else ["label"])
    attributes = read_ply(tmp_path / "a.ply").attributes
    expected = {"label": (np.dtype(kind), values)} if kind else {}
    assert {name: (column.dtype, column.tolist()) for name, column in attributes.items()} == expected

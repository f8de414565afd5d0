"""Boolean operations on solids: volumes, attributes, and rejected input."""

import sys

import numpy as np
import pytest

from pointloom import TriangleMesh

from .mesh_soups import BOX, BOX_SIDES, FAR

pytest.importorskip("manifold3d", exc_type=ImportError)


def box(shift=0.0, device=None, **options) -> TriangleMesh:
    return TriangleMesh(BOX + shift, BOX_SIDES, device=device, **options)


VOLUMES = {"boolean_union": 1 + 1 - 0.125, "boolean_difference": 1 - 0.125, "boolean_intersection": 0.125}


@pytest.mark.parametrize("name", VOLUMES)
@pytest.mark.parametrize("where", [np.zeros(3), FAR])
def test_booleans_of_boxes_are_closed_near_zero_and_far_away(device, name, where):
    combined = getattr(box(where, device), name)(box(where + 0.5, device))
    assert combined.is_watertight() and combined.device == box(0, device).device
    assert combined.get_volume() == pytest.approx(VOLUMES[name], rel=1e-6)  # float32 corners


def test_disjoint_and_empty_solids_are_combined(device):
    assert len(box(0, device).boolean_intersection(box(5, device))) == 0
    assert len(box(0, device).boolean_union(box(5, device))) == 24
    empty = TriangleMesh(device=device)
    assert box(0, device).boolean_union(empty).get_volume() == pytest.approx(1)
    assert len(empty.boolean_difference(box(0, device))) == 0


def test_colors_are_preserved_and_normals_recomputed_if_both_have_them(device):
    red = box(0, device, vertex_colors=np.tile([1.0, 0, 0], (8, 1))).compute_vertex_normals()
    blue = box(0.5, device, vertex_colors=np.tile([0, 0, 1.0], (8, 1))).compute_vertex_normals()
    union = red.boolean_union(blue)
    np.testing.assert_array_equal(union.vertex_colors[(union.vertices < 0.4).any(axis=1)][0], [1, 0, 0])
    np.testing.assert_array_equal(union.vertex_colors[(union.vertices > 1.4).any(axis=1)][0], [0, 0, 1])
    assert union.vertex_normals is not None
    with pytest.warns(UserWarning, match="vertex_colors are dropped, because not all meshes"):
        plain = red.boolean_union(box(0.5, device))
    assert plain.vertex_colors is None and plain.vertex_normals is None


def test_attributes_come_from_the_surface_of_their_mesh(device):
    parts = [box(0, device), box(0.5, device, origin=[1000, 0, 0])]
    for number, part in enumerate(parts):
        part.vertex_attributes["part"] = np.full(8, number, np.uint8)
        part.vertex_attributes["place"], part.triangle_attributes["part"] = part.vertices, np.full(12, number)
    for result in (parts[0].boolean_union(parts[1]), parts[0].boolean_difference(parts[1])):
        np.testing.assert_allclose(result.vertex_attributes["place"], result.vertices, atol=1e-4)
        middles = result.vertices[result.triangles].mean(axis=1)
        on_first = (np.abs(middles - 0.5).max(axis=1) > 0.5 - 1e-3) & (np.abs(middles - 1).max(axis=1) > 0.5 + 1e-3)
        assert on_first.any() and (result.triangle_attributes["part"][on_first] == 0).all()
        assert {*result.vertex_attributes["part"]} == {0, 1} == {*result.triangle_attributes["part"]}


BAD = {
    "closed": (BOX, BOX_SIDES[1:]),
    "inconsistently oriented": (BOX, np.vstack([BOX_SIDES[:1, ::-1], BOX_SIDES[1:]])),
    "faces inward": (BOX, BOX_SIDES[:, ::-1]),
    "NaN or infinite": (np.vstack([[[np.nan] * 3], BOX[1:]]), BOX_SIDES),
}


@pytest.mark.parametrize("reason", BAD)
def test_non_solids_are_rejected_with_the_reason(device, reason):
    bad = TriangleMesh(*BAD[reason], device=device)
    with pytest.raises(ValueError, match=f"boolean_union: the mesh .*{reason}"):
        bad.boolean_union(box(0, device))
    with pytest.raises(ValueError, match=f"boolean_difference: mesh: it .*{reason}"):
        box(0, device).boolean_difference(bad)


def test_a_missing_package_is_named_with_the_install_command(monkeypatch):
    monkeypatch.setitem(sys.modules, "manifold3d", None)
    with pytest.raises(ImportError, match=r'pip install "pointloom\[mesh\]"'):
        box().boolean_union(box(0.5))

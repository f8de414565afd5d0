"""Vertex and triangle attributes, texture coordinates and images follow all mesh operations."""

import copy
import inspect
import pickle

import numpy as np
import pytest

from pointloom import AxisAlignedBoundingBox, TriangleMesh
from pointloom.meshing import clean_mesh, simplify_mesh, smooth_mesh

from .mesh_soups import FAR
from .repair_scenes import SIDE_BY_SIDE, box, flipped, joined, loose, moved, partly_flipped, sphere


def labeled(device=None, mesh: TriangleMesh | None = None) -> TriangleMesh:
    """A mesh whose attributes encode each vertex position and triangle number."""
    mesh = TriangleMesh.create_sphere(1.0, 6, device=device) if mesh is None else mesh
    mesh.vertex_attributes["place"] = mesh.vertices
    mesh.vertex_attributes["number"] = np.arange(len(mesh.vertices), dtype=np.uint16)
    mesh.triangle_attributes["row"] = np.arange(len(mesh))
    mesh.triangle_attributes["middle"] = mesh.vertices[mesh.triangles].mean(axis=1).astype(np.float32)
    mesh.triangle_attributes["even"] = np.arange(len(mesh)) % 2 == 0
    return mesh


def attributes_of(mesh: TriangleMesh) -> dict[str, tuple[str, list[int]]]:
    both = dict(mesh.vertex_attributes) | dict(mesh.triangle_attributes)
    return {name: (str(values.dtype), list(values.shape[1:])) for name, values in both.items()}


KINDS = dict(
    place=("float64", [3]), number=("uint16", []), row=("int64", []), middle=("float32", [3]), even=("bool", [])
)


def test_values_keep_their_types_and_shapes(device):
    mesh = labeled(device)
    assert attributes_of(mesh) == KINDS
    names = "vertex_attributes[place, number], triangle_attributes[row, middle, even]"
    assert repr(mesh).endswith(f"{names}, {mesh.device})")
    np.testing.assert_array_equal(mesh.vertex_attributes["place"], mesh.vertices)
    for attributes in (mesh.vertex_attributes, mesh.triangle_attributes):
        for name, values in attributes.items():
            shared = attributes.array(name)
            if device == "cpu":
                assert (type(shared), shared.shape, shared.dtype) == (np.ndarray, values.shape, values.dtype)
            else:
                assert shared.device == mesh.device
    with pytest.raises(ValueError, match="read-only"):
        mesh.vertex_attributes["place"][0] = 0


def test_copies_have_independent_attributes(device):
    mesh = labeled(device)
    other = mesh.copy()
    del other.vertex_attributes["place"]
    other.triangle_attributes["row"] = np.zeros(len(mesh))
    assert attributes_of(mesh) == KINDS and list(other.vertex_attributes) == ["number"]
    for same in (pickle.loads(pickle.dumps(mesh)), copy.deepcopy(mesh), mesh.to(device)):
        assert attributes_of(same) == KINDS
        np.testing.assert_array_equal(same.triangle_attributes["row"], mesh.triangle_attributes["row"])


def test_the_constructor_accepts_attributes():
    options = {"vertex_attributes": {"a": [1, 2, 3]}, "triangle_attributes": {"b": np.array([[0.5, 1]])}}
    mesh = TriangleMesh(np.eye(3), [[0, 1, 2]], **options)
    assert mesh.vertex_attributes["a"].tolist() == [1, 2, 3] and mesh.triangle_attributes["b"].tolist() == [[0.5, 1]]


CHANGES = {
    "select": lambda m: m.select_by_index(np.arange(len(m.vertices))[::-2]),
    "crop": lambda m: m.crop(AxisAlignedBoundingBox([-2, -2, -2], [2, 2, 0.5])),
    "remove vertices": lambda m: m.remove_vertices_by_mask(m.vertices[:, 2] > 0.5),
    "remove triangles": lambda m: m.remove_triangles_by_index([0, 5, 7]).remove_unreferenced_vertices(),
    "weld": lambda m: m.remove_duplicated_vertices().merge_close_vertices(1e-3),
    "clean": lambda m: m.remove_degenerate_triangles(zero_area=True).remove_duplicated_triangles(),
    "parts": lambda m: m.remove_small_components(min_triangles=2),
    "fill": lambda m: m.remove_triangles_by_index([40]).repair()[0],
}


@pytest.mark.parametrize("name", CHANGES)
def test_remaining_elements_keep_their_attributes(device, name):
    changed = CHANGES[name](labeled(device))
    assert attributes_of(changed) == KINDS
    np.testing.assert_array_equal(changed.vertex_attributes["place"], changed.vertices)
    middles = changed.vertices[changed.triangles].mean(axis=1)
    np.testing.assert_allclose(changed.triangle_attributes["middle"], middles, atol=1e-6)


@pytest.mark.parametrize("name", ["midpoint", "trim"])
def test_new_vertices_have_interpolated_values(device, name):
    mesh = labeled(device)
    changed = mesh.subdivide_midpoint(2) if name == "midpoint" else mesh.trim(mesh.vertices @ [0.3, 0.2, 0.9], 0.1)
    assert attributes_of(changed) == KINDS and len(changed.vertices) > 6
    np.testing.assert_allclose(changed.vertex_attributes["place"], changed.vertices, atol=1e-6)
    near = mesh.vertices[changed.vertex_attributes["number"].astype(int)]
    assert np.linalg.norm(near - changed.vertices, axis=1).max() < 0.6  # an integer is copied from a neighbor
    corners = mesh.vertices[mesh.triangles[changed.triangle_attributes["row"]]]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    off = np.einsum("tc,tkc->tk", normals, changed.vertices[changed.triangles] - corners[:, :1])
    assert abs(off).max() < 1e-6  # a part of a triangle lies in it


def test_an_unused_row_gives_no_nan():
    mesh = TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
    mesh.vertex_attributes["a"] = [1.0, 2.0, 3.0, np.nan]
    values = mesh.subdivide_midpoint().vertex_attributes["a"]
    assert np.isnan(values).sum() == 3 and values[:3].tolist() == [1, 2, 3]


@pytest.mark.parametrize("name", ["decimation", "clustering"])
def test_simplified_triangles_take_values_at_their_position(name):
    mesh = labeled(mesh=TriangleMesh.create_sphere(1.0, 20))
    changed = mesh.simplify_quadric_decimation(300) if name == "decimation" else mesh.simplify_vertex_clustering(0.2)
    assert attributes_of(changed) == KINDS
    np.testing.assert_allclose(changed.vertex_attributes["place"], changed.vertices, atol=0.02)
    middles = changed.vertices[changed.triangles].mean(axis=1)
    assert np.linalg.norm(changed.triangle_attributes["middle"] - middles, axis=1).max() < 0.15


def test_operations_that_drop_attributes_warn():
    mesh, box = labeled(), TriangleMesh.create_box()
    with pytest.warns(UserWarning, match="vertex_attributes place, number:"):
        arrays = {name: box.arrays[name] for name in ("vertices", "triangles")}
        bare = mesh.with_arrays(**arrays, triangle_attributes=None)
    assert not bare.vertex_attributes and not bare.triangle_attributes


IMAGE = np.arange(4 * 5 * 3, dtype=np.uint8).reshape(4, 5, 3)


def textured(device=None) -> TriangleMesh:
    rng = np.random.default_rng(0)
    triangles = rng.permuted(np.tile(np.arange(30), (40, 1)), axis=1)[:, :3]
    return TriangleMesh(
        rng.normal(size=(32, 3)), triangles, triangle_uvs=rng.random((120, 2)),
        triangle_material_ids=rng.integers(0, 2, 40), textures=[IMAGE, IMAGE[::-1]], device=device,
    )  # fmt: skip


def corner_table(mesh: TriangleMesh) -> np.ndarray:
    """Position, texture coordinates and material of each corner: the appearance, independent of numbering."""
    assert mesh.triangle_uvs is not None and mesh.triangle_material_ids is not None
    corners, materials = mesh.vertices[mesh.triangles.reshape(-1)], np.repeat(mesh.triangle_material_ids, 3)
    return np.column_stack([corners, mesh.triangle_uvs, materials])


def test_a_reflection_preserves_texture_corners(device):
    mesh = textured(device)
    mirrored = mesh.transform(np.diag([-1.0, 1, 1, 1]))
    there = corner_table(mesh) * [-1, 1, 1, 1, 1, 1]
    np.testing.assert_array_equal(np.sort(corner_table(mirrored), axis=0), np.sort(there, axis=0))
    np.testing.assert_array_equal(corner_table(mirrored)[::3], there[::3])
    np.testing.assert_array_equal(corner_table(mirrored)[1::3], there[2::3])


def test_texture_survives_copies_pickles_and_devices(device):
    mesh = textured(device)
    for again in (mesh.copy(), copy.deepcopy(mesh), pickle.loads(pickle.dumps(mesh)), mesh.to("cpu")):
        np.testing.assert_array_equal(corner_table(again), corner_table(mesh))
        np.testing.assert_array_equal(again.textures[1], IMAGE[::-1])


def test_dropping_texture_coordinates_drops_images():
    mesh = textured()
    mesh.triangle_uvs = None
    assert mesh.triangle_uvs is None and mesh.triangle_material_ids is None and mesh.textures == ()


FILTERS = {
    "simple": lambda mesh: mesh.filter_smooth_simple(4),
    "laplacian": lambda mesh: mesh.filter_smooth_laplacian(4),
    "taubin": lambda mesh: mesh.filter_smooth_taubin(4),
    "sharpen": lambda mesh: mesh.filter_sharpen(1, 0.1),
}
CLOSE = 2e-6  # m: sums in another order, then float32


def split_at_seams(mesh: TriangleMesh, device=None) -> TriangleMesh:
    """The mesh with a texture of four charts, each with its own vertices, as in a file."""
    middles = mesh.vertices[mesh.triangles].mean(axis=1)
    piece = (middles[:, 0] > 0.1) * 2 + (middles[:, 1] > 0.1)
    keys, corners = np.unique(piece[:, None] * len(mesh.vertices) + mesh.triangles, return_inverse=True)
    split = TriangleMesh(mesh.vertices[keys % len(mesh.vertices)], corners.reshape(-1, 3), device=device)
    split.triangle_uvs = np.random.default_rng(0).random((3 * len(mesh), 2))
    split.textures = [IMAGE]
    split.vertex_colors = np.random.default_rng(1).random((len(split.vertices), 3))
    return split


def corners_of(mesh: TriangleMesh) -> np.ndarray:
    return mesh.vertices[mesh.triangles]


@pytest.mark.parametrize("name", FILTERS)
def test_filters_preserve_seams_and_texture(device, name):
    ball = sphere()
    split = split_at_seams(ball, device)
    changed = FILTERS[name](split)
    np.testing.assert_allclose(corners_of(changed), corners_of(FILTERS[name](ball)), rtol=0, atol=CLOSE)
    np.testing.assert_array_equal(changed.triangles, split.triangles)
    np.testing.assert_array_equal(changed.triangle_uvs, split.triangle_uvs)
    groups = np.unique(split.vertices, axis=0, return_inverse=True)[1]
    assert len(np.unique(np.column_stack([groups, changed.vertices]), axis=0)) == len(ball.vertices)
    assert len(np.unique(np.column_stack([groups, changed.vertex_colors]), axis=0)) == len(ball.vertices)


def test_loop_subdivision_is_smooth_across_seams(device):
    ball = sphere()
    split = split_at_seams(ball, device)
    fine = split.subdivide_loop(2)
    np.testing.assert_allclose(corners_of(fine), corners_of(ball.subdivide_loop(2)), rtol=0, atol=CLOSE)
    np.testing.assert_array_equal(fine.triangle_uvs, split.subdivide_midpoint(2).triangle_uvs)
    assert fine.is_watertight()


def test_distances_and_curvatures_are_continuous_across_seams(device):
    ball = sphere()
    split = split_at_seams(ball, device)
    index_of = {tuple(p): k for k, p in enumerate(ball.vertices.tolist())}
    numbers = [index_of[tuple(p)] for p in split.vertices.tolist()]
    source = numbers.index(0)
    wanted = ball.compute_geodesic_distances([0])[numbers]
    np.testing.assert_allclose(split.compute_geodesic_distances([source]), wanted, rtol=1e-9)
    for result, known in zip(split.compute_vertex_curvature(), ball.compute_vertex_curvature(), strict=True):
        np.testing.assert_allclose(result, known[numbers], rtol=1e-6)


def test_deformations_preserve_seams(device):
    ball = moved(sphere(), FAR)
    split = split_at_seams(ball, device)
    low, high = (int(pick(split.vertices[:, 2])) for pick in (np.argmin, np.argmax))
    targets = split.vertices[[low, high]] + [[0, 0, 0], [0, 0, 0.3]]
    bent = split.deform_as_rigid_as_possible([low, high], targets, 5)
    handles = [int(np.flatnonzero((ball.vertices == split.vertices[v]).all(axis=1))[0]) for v in (low, high)]
    wanted = ball.deform_as_rigid_as_possible(handles, targets, 5)
    np.testing.assert_allclose(corners_of(bent), corners_of(wanted), rtol=0, atol=1e-5)


def test_coincident_vertices_get_one_position(device):
    split = split_at_seams(sphere(), device)
    positions, counts = np.unique(split.vertices, axis=0, return_counts=True)
    first, second = np.flatnonzero((split.vertices == positions[counts > 1][0]).all(axis=1))[:2].tolist()
    target = split.vertices[first] + 0.1
    once = split.deform_as_rigid_as_possible([first], [target], 2)
    twice = split.deform_as_rigid_as_possible([first, second], [target, target], 2)
    np.testing.assert_array_equal(once.vertices, twice.vertices)
    with pytest.raises(ValueError, match=f"vertices {first} and {second} coincide at a seam"):
        split.deform_as_rigid_as_possible([first, second], [target, target + 1], 2)


def test_touching_solids_are_smoothed_separately(device):
    """Closed components have no boundary, so none of their edges is a seam."""
    changed = SIDE_BY_SIDE.to(device).filter_smooth_simple(2)
    alone = TriangleMesh.create_box().filter_smooth_simple(2)
    np.testing.assert_array_equal(changed.vertices[:8], alone.vertices)


UPPER = AxisAlignedBoundingBox([-2, -2, -0.5], [2, 2, 2])
TURNED = np.array([[0, 0, 1.0], [1, 0, 0], [0, 1, 0]])
TEXTURED = {"triangle_uvs", "triangle_material_ids", "textures"}
CARRIED = {"vertex_attributes", "triangle_attributes"}

# Every method that returns a mesh, with the arrays that its docstring omits from the result.
RESULTS = {
    "bake_vertex_colors": (lambda m: m.bake_vertex_colors(32), {"vertex_colors", "triangle_material_ids"}),
    "boolean_difference": (lambda m: m.boolean_difference(m.translate([0.5, 0, 0])), TEXTURED),
    "boolean_intersection": (lambda m: m.boolean_intersection(m.translate([0.5, 0, 0])), TEXTURED),
    "boolean_union": (lambda m: m.boolean_union(m.translate([0.5, 0, 0])), TEXTURED),
    "clip_plane": (lambda m: m.clip_plane([0, 0, 0.1], [0, 0, 1]), set()),
    "clip_plane, cap": (lambda m: m.clip_plane([0, 0, 0.1], [0, 0, 1], cap=True), set()),
    "compute_uvatlas": (lambda m: m.compute_uvatlas(64), {"textures", "triangle_material_ids"}),
    "compute_vertex_normals": (lambda m: m.compute_vertex_normals(), set()),
    "concatenate": (lambda m: TriangleMesh.concatenate([m, m.translate([3, 0, 0])]), set()),
    "copy": (lambda m: m.copy(), set()),
    "crop": (lambda m: m.crop(UPPER), set()),
    "deform_as_rigid_as_possible": (
        lambda m: m.deform_as_rigid_as_possible([0, 1], m.vertices[:2] + np.array([0, 0.2, 0]), 3), set(),
    ),
    "extrude_linear": (lambda m: m.crop(UPPER).extrude_linear([0, 0, 1]), TEXTURED),
    "extrude_rotation": (lambda m: m.crop(UPPER).extrude_rotation(30, [5, 0, 0], translation=0.5), TEXTURED),
    "fill_holes": (lambda m: m.remove_triangles_by_index([40]).fill_holes(), set()),
    "filter_sharpen": (lambda m: m.filter_sharpen(1, 0.1), set()),
    "filter_smooth_laplacian": (lambda m: m.filter_smooth_laplacian(), set()),
    "filter_smooth_simple": (lambda m: m.filter_smooth_simple(), set()),
    "filter_smooth_taubin": (lambda m: m.filter_smooth_taubin(), set()),
    "merge_close_vertices": (lambda m: m.merge_close_vertices(0.3), set()),
    "normalize_normals": (lambda m: m.normalize_normals(), set()),
    "orient_triangles": (lambda m: m.orient_triangles(outward=True)[0], set()),
    "paint_uniform_color": (lambda m: m.paint_uniform_color([1, 0, 0]), set()),
    "remesh_isotropic": (lambda m: m.remesh_isotropic(0.4, 3), TEXTURED),
    "remove_degenerate_triangles": (lambda m: m.remove_degenerate_triangles(), set()),
    "remove_duplicated_triangles": (lambda m: m.remove_duplicated_triangles(), set()),
    "remove_duplicated_vertices": (lambda m: m.remove_duplicated_vertices(), set()),
    "remove_non_manifold_edges": (lambda m: m.remove_non_manifold_edges(), set()),
    "remove_small_components": (lambda m: m.remove_small_components(2), set()),
    "remove_triangles_by_index": (lambda m: m.remove_triangles_by_index([3, 9]), set()),
    "remove_triangles_by_mask": (lambda m: m.remove_triangles_by_mask(np.arange(len(m)) < 9), set()),
    "remove_unreferenced_vertices": (lambda m: m.remove_unreferenced_vertices(), set()),
    "remove_vertices_by_index": (lambda m: m.remove_vertices_by_index([3, 9]), set()),
    "remove_vertices_by_mask": (lambda m: m.remove_vertices_by_mask(m.vertices[:, 2] > 0.7), set()),
    "repair": (lambda m: m.remove_triangles_by_index([40]).repair(hole_size=1.0)[0], set()),
    "rotate": (lambda m: m.rotate(TURNED), set()),
    "scale": (lambda m: m.scale(2.0), set()),
    "select_by_index": (lambda m: m.select_by_index(np.arange(30)), set()),
    "select_faces_by_mask": (lambda m: m.select_faces_by_mask(np.arange(len(m)) < 30), set()),
    "simplify_quadric_decimation": (lambda m: m.simplify_quadric_decimation(60), set()),
    "simplify_vertex_clustering": (lambda m: m.simplify_vertex_clustering(0.5), TEXTURED),
    "split_non_manifold_vertices": (lambda m: m.split_non_manifold_vertices(), set()),
    "subdivide_loop": (lambda m: m.subdivide_loop(), set()),
    "subdivide_midpoint": (lambda m: m.subdivide_midpoint(), set()),
    "to": (lambda m: m.to("cpu", arrays="warp"), set()),
    "to_unit": (lambda m: m.to_unit("mm"), set()),
    "transform": (lambda m: m.transform(np.diag([1, -2, 1, 1.0])), set()),
    "translate": (lambda m: m.translate([1, 2, 3]), set()),
    "trim": (lambda m: m.trim(m.vertices[:, 2], 0.1), set()),
    "clean_mesh": (lambda m: clean_mesh(m, hole_size=1.0).mesh, set()),
    "simplify_mesh": (lambda m: simplify_mesh(m, triangles=60).mesh, set()),
    "smooth_mesh": (lambda m: smooth_mesh(m).mesh, set()),
}  # fmt: skip
OTHER_RESULTS = {"clear", "compute_convex_hull", "compute_error_map", "reproject"}  # empty, new, painted, elsewhere


def complete(device) -> TriangleMesh:
    """A closed mesh with every kind of array, whose normals point outward."""
    mesh, rng = labeled(device), np.random.default_rng(0)
    mesh.vertex_colors = rng.random((len(mesh.vertices), 3))
    mesh.triangle_uvs, mesh.triangle_material_ids = rng.random((3 * len(mesh), 2)), np.arange(len(mesh)) % 2
    mesh.textures, mesh.up, mesh.unit = [IMAGE, IMAGE[::-1]], "y", "metre"
    return mesh.compute_vertex_normals()


def arrays_of(mesh: TriangleMesh) -> set[str]:
    arrays = {*mesh.arrays, *(kind for kind, columns in mesh.arrays.attributes.items() if columns)}
    return arrays | ({"textures"} if mesh.textures else set()) | ({"up"} if mesh.up else set())


def sides(mesh: TriangleMesh) -> np.ndarray:
    """Cosine between each normal of a used vertex and the sum of its triangles' area vectors."""
    assert mesh.vertex_normals is not None
    surface = mesh.compute_vertex_normals().vertex_normals
    return np.einsum("nc,nc->n", mesh.vertex_normals, surface)[np.unique(mesh.triangles)]


def test_the_table_has_all_methods_that_return_a_mesh():
    kinds = {name: inspect.unwrap(f) for name, f in inspect.getmembers(TriangleMesh, inspect.isfunction)}
    found = {name for name, f in kinds.items() if "Self" in str(f.__annotations__.get("return"))}
    assert {name for name in found if name[0] != "_" and name in dir(TriangleMesh)} <= {*RESULTS, *OTHER_RESULTS}


@pytest.mark.parametrize("name", RESULTS)
def test_results_keep_all_arrays_and_normals_on_the_side_of_their_triangles(device, name):
    mesh, (operation, omitted) = complete(device), RESULTS[name]
    result = operation(mesh)
    assert arrays_of(result) == arrays_of(mesh) - omitted
    if arrays_of(result) >= CARRIED:
        assert attributes_of(result) == KINDS
    assert sides(result).min() > 0


BACKWARD = {
    "reversed": lambda: flipped(sphere()),
    "partly reversed": lambda: partly_flipped(sphere()),
    "soup": lambda: loose(partly_flipped(sphere())),
    "box": lambda: partly_flipped(box()),
    "nested": lambda: joined(flipped(sphere()), sphere(3.0)),
    "two": lambda: joined(flipped(sphere()), moved(partly_flipped(sphere()), [4, 0, 0])),
}
REPAIRS = {
    "repair": lambda m: m.repair()[0],
    "clean_mesh": lambda m: clean_mesh(m).mesh,
    "orient_triangles": lambda m: m.orient_triangles(outward=True)[0],
}


@pytest.mark.parametrize("stored", ["computed", "opposite", "outward"])
@pytest.mark.parametrize("repair", REPAIRS)
@pytest.mark.parametrize("name", BACKWARD)
def test_normals_turn_with_their_triangles(device, name, repair, stored):
    mesh = BACKWARD[name]()
    centers = np.array([[4 * (name == "two") * (x > 2), 0, 0] for x in mesh.vertices[:, 0]])
    centers = mesh.vertices.mean(axis=0) if name == "box" else centers
    outward = mesh.vertices - centers
    mesh = TriangleMesh(mesh.vertices, mesh.triangles, vertex_normals=outward, device=device).normalize_normals()
    mesh = mesh if stored == "outward" else mesh.compute_vertex_normals()
    if stored == "opposite":
        mesh = TriangleMesh(mesh.vertices, mesh.triangles[:, ::-1], vertex_normals=mesh.vertex_normals, device=device)
    repaired = REPAIRS[repair](mesh)
    touched = np.ones(len(repaired.vertices), bool)
    if len(repaired.vertices) == len(mesh.vertices) and len(repaired) == len(mesh):  # same numbering
        turned = (repaired.triangles != mesh.triangles).any(axis=1)
        touched = np.isin(np.arange(len(touched)), repaired.triangles[turned])
        before, after = mesh.vertex_normals, repaired.vertex_normals
        assert before is not None and after is not None
        np.testing.assert_array_equal(after[~touched], before[~touched])
        np.testing.assert_array_equal(abs(after), abs(before))
    used = np.intersect1d(np.flatnonzero(touched), repaired.triangles)
    surface = repaired.compute_vertex_normals().vertex_normals
    assert surface is not None and repaired.vertex_normals is not None
    cosines = np.einsum("nc,nc->n", repaired.vertex_normals, surface)[used]
    assert cosines.min(initial=1) > (-1e-6 if stored != "outward" else 0)

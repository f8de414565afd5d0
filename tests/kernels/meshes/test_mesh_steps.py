"""Degenerate triangles, mixed rows, votes of parts, and Poisson-disk samples equal to those of a heap."""

import heapq

import numpy as np
import pytest

from pointloom import TriangleMesh
from pointloom.kernels.lang import float64, int32, int64, uint8, vec3, vec3d, vec3i
from pointloom.kernels.memory import download, upload
from pointloom.kernels.meshes import boundary_loops, crowded_edges, holes, poisson_disk
from pointloom.kernels.meshes.clean_triangles import join_masks, mask_repeats
from pointloom.kernels.meshes.mesh_components import has_marked
from pointloom.kernels.meshes.mesh_edges import MeshEdges, count_sharers
from pointloom.kernels.meshes.mesh_edits import repeated_positions
from pointloom.kernels.meshes.mesh_measures import measure
from pointloom.kernels.meshes.mixed_rows import MixedRows
from pointloom.kernels.meshes.part_votes import follow_majority, keep_alone
from pointloom.kernels.meshes.pseudonormals import volume_of_shell
from pointloom.kernels.meshes.sheets import OpenEdges
from pointloom.kernels.remeshing import mesh_filters, subdivision
from pointloom.kernels.search import neighbor_limits
from pointloom.kernels.search.point_tree import PointTree

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


@pytest.fixture
def put(device):
    return lambda values, kind: upload(np.asarray(values), kind, device)


def test_triangles_that_name_a_vertex_twice_repeat_their_rotations(put):
    triangles = [[1, 2, 1], [1, 1, 2], [2, 1, 1], [2, 2, 1], [3, 3, 3], [3, 3, 3], [0, 1, 2], [0, 2, 1]]
    assert download(mask_repeats(put(triangles, vec3i))).tolist() == [0, 1, 1, 0, 0, 1, 0, 0]


def test_a_triangle_that_has_an_edge_twice_counts_once(put):
    edges = MeshEdges(put([[0, 1, 0], [0, 1, 2]], vec3i), 3)
    numbers = map(download, (edges.lows, edges.highs, count_sharers(edges)))
    assert {(a, b): n for a, b, n in zip(*numbers, strict=True)} == {(0, 0): 1, (0, 1): 2, (1, 2): 1, (0, 2): 1}


def test_open_half_edges_without_length_belong_to_no_edge(put):
    edges = OpenEdges(put([[0, 1, 1], [0, 1, 2]], vec3i), 3, put([0, 1, 0, 1, 1, 1], uint8))
    assert edges.count == 3 and sorted(download(edges.half_edges)[: download(edges.starts)[3]]) == [3, 4, 5]


def test_masks_are_joined(put):
    joined = join_masks(put([1, 0, 0, 0], uint8), put([0, 1, 0, 0], uint8), put([0, 1, 1, 0], uint8))
    assert download(joined).tolist() == [1, 1, 1, 0]


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_a_triangle_with_a_corner_that_is_not_finite_adds_no_volume(put, bad):
    """The tetrahedron alone encloses a volume; with a bad triangle beside it, it still has it but encloses none."""
    corners, faces = np.vstack([CORNERS, [[bad, 0, 0]]]), np.vstack([FACES, [[4, 1, 2]]])
    assert measure(put(corners, vec3), put(faces, vec3i))[1] == pytest.approx(1 / 6)
    assert volume_of_shell(put(corners, vec3), put(faces, vec3i)) is None
    assert volume_of_shell(put(CORNERS, vec3), put(FACES, vec3i)) == pytest.approx(1 / 6)


def test_a_closed_mesh_without_area_encloses_no_volume(put):
    assert volume_of_shell(put(CORNERS * [1, 0, 0], vec3), put(FACES, vec3i)) is None


def test_values_are_weighted_sums_and_the_nearest_vertex_is_the_first_of_the_heaviest(device, rng):
    rows = rng.integers(0, 30, (100, 3)).astype(np.int32)
    weights = rng.dirichlet(np.ones(3), 100)
    weights[0], weights[1], weights[2] = [0, 0.5, 0.5], [0.5, 0.5, 0], [0, 0, 1]
    made, values = (MixedRows(upload(rows, vec3i, device), upload(weights, vec3d, device)), rng.normal(size=(30, 2)))
    expected = np.take_along_axis(rows, weights.argmax(axis=1)[:, None], axis=1)[:, 0]
    np.testing.assert_array_equal(download(made.nearest()), expected)
    result = download(made.of(upload(values, float64, device)))
    np.testing.assert_allclose(result, np.einsum("nk,nkc->nc", weights, values[rows]), rtol=0, atol=1e-14)


@pytest.mark.parametrize("other", [False, True])
def test_parts_with_a_majority_of_marks_flip(device, other):
    """Part 0 has two marks of three, part 3 one of two, part 5 none of one."""
    names = upload(np.array([0, 0, 0, 3, 3, 5]), int32, device)
    marks = upload(np.array([1, 0, 1, 1, 0, 0]), uint8, device)
    follow_majority(names, marks, other)
    majority = np.array([0, 1, 0, 1, 0, 0])
    np.testing.assert_array_equal(download(marks), 1 - majority if other else majority)


def test_marks_stay_on_isolated_triangles(device):
    names, mask = (upload(np.array([0, 1, 1, 3, 4]), int32, device), upload(np.array([1, 1, 0, 0, 1]), uint8, device))
    keep_alone(names, mask)
    assert download(mask).tolist() == [1, 0, 0, 0, 1]


def test_positions_of_repeated_rows(device, rng):
    rows = rng.permutation(np.r_[np.arange(40), rng.integers(0, 40, 60)])
    repeated = download(repeated_positions(upload(rows, int32, device), 40))
    first = np.unique(rows, return_index=True)[1]
    np.testing.assert_array_equal(repeated, np.setdiff1d(np.arange(100), first))


def test_parts_with_a_mark_among_the_first_triangles(device):
    labels, marks = (upload(np.array([0, 2, 1, 2, 3]), int64, device), upload(np.array([0, 0, 1, 1]), uint8, device))
    assert has_marked(labels, marks, 4).tolist() == [False, True, True, False]


def by_rounds(points: np.ndarray, count: int, widest: float, device: str) -> np.ndarray:
    tree = PointTree(upload(points, vec3, device))
    return download(poisson_disk.eliminate_samples(tree, count, widest)).copy()


def by_heap(points: np.ndarray, count: int, widest: float) -> np.ndarray:
    """Yuksel's algorithm as he gives it: the heaviest sample goes, of equal ones the one of the highest index."""
    points = points.astype(np.float32)
    rows = np.flatnonzero(np.isfinite(points).all(axis=1))
    narrowest = widest * 0.65 * (1 - (count / len(rows)) ** 1.5)
    gaps = points[rows][:, None] - points[rows][None]
    squares = gaps[..., 0] ** 2 + gaps[..., 1] ** 2 + gaps[..., 2] ** 2
    distances = np.sqrt(squares.astype(np.float64))
    fractions = np.clip((1 - distances / widest) / (1 - narrowest / widest), 0, 1)
    near = squares < widest**2
    weights = np.where(near, (((fractions**2) ** 2) ** 2 * 2**30).astype(np.int64), 0)
    np.fill_diagonal(weights, 0)
    total = weights.sum(axis=1)
    left = np.ones(len(rows), bool)
    heap = [(-total[i], -i) for i in range(len(rows))]
    heapq.heapify(heap)
    while left.sum() > count:
        weight, i = heapq.heappop(heap)
        i = -i
        if not left[i] or -weight != total[i]:
            continue
        left[i] = False
        total -= weights[i]
        for j in np.flatnonzero(left & (weights[i] > 0)):
            heapq.heappush(heap, (-total[j], -j))
    return rows[left]


SCENES = {
    "square": lambda rng: np.column_stack([rng.random((500, 2)), np.zeros(500)]),
    "ball": lambda rng: (points := rng.normal(size=(500, 3))) / np.linalg.norm(points, axis=1, keepdims=True),
    # every distance many times over, so that many samples weigh the same
    "grid": lambda rng: np.stack(np.meshgrid(np.arange(21), np.arange(21), [0]), -1).reshape(-1, 3) / 21.0,
    "copies": lambda rng: np.repeat(rng.random((60, 3)), 10, axis=0),
    "strays": lambda rng: rng.random((400, 3)) * 1e4,  # no two within the radius
    "nowhere": lambda rng: np.where(np.arange(400)[:, None] % 7, rng.random((400, 3)) * [1, 1, 0], np.nan),
    "crowd and strays": lambda rng: np.concatenate([rng.random((400, 3)) * [0.02, 0.02, 0], rng.random((60, 3)) * 50]),
}


@pytest.mark.parametrize(("count", "in_rounds"), [(57, False), (300, True)])
@pytest.mark.parametrize("name", SCENES)
def test_the_samples_equal_those_of_a_heap(device, rng, monkeypatch, name, count, in_rounds):
    monkeypatch.setattr(poisson_disk, "MAX_SEQUENTIAL", 0 if in_rounds else 2**16)
    points, area = SCENES[name](rng), 4 * np.pi if name == "ball" else 1.0
    widest = 2 * np.sqrt(area / count / (2 * np.sqrt(3)))
    np.testing.assert_array_equal(by_rounds(points, count, widest, device), by_heap(points, count, widest))


@pytest.mark.slow
def test_more_samples_within_the_radius_than_a_group_gathers_are_weighted_too(device, rng, monkeypatch):
    monkeypatch.setattr(neighbor_limits, "LIST_SIZE", 1)  # 512 of them
    points = rng.random((560, 3)) * [1, 1, 0]
    widest = 2 * np.sqrt(1 / 2 / (2 * np.sqrt(3)))
    np.testing.assert_array_equal(by_rounds(points, 2, widest, device), by_heap(points, 2, widest))


def test_more_pairs_than_fit_are_counted_and_refused(device, rng, monkeypatch):
    monkeypatch.setattr(poisson_disk, "MAX_PAIRS", 1000)
    monkeypatch.setattr(poisson_disk, "MAX_ROOM", 0)
    with pytest.raises(poisson_disk.CrowdedError) as caught:
        by_rounds(rng.random((100, 3)), 10, 3.0, device)
    assert caught.value.pair_count == 9900


@pytest.mark.parametrize(
    ("module", "limit", "value", "operation"),
    [
        (boundary_loops, "MAX_SERIAL_HALF_EDGES", -1, lambda mesh: mesh.fill_holes()),
        (holes, "SHORT_LOOP_VERTICES", 0, lambda mesh: mesh.fill_holes()),
        (crowded_edges, "MAX_SERIAL_TRIANGLES", 0, lambda mesh: mesh.remove_non_manifold_edges()),
        (subdivision, "MAX_SERIAL_HALF_EDGES", 0, lambda mesh: mesh.subdivide_midpoint()),
        (subdivision, "MAX_SERIAL_HALF_EDGES", 0, lambda mesh: mesh.subdivide_loop(2)),
        (mesh_filters, "MIN_REPEATED", 100, lambda mesh: mesh.filter_smooth_taubin(7)),
        (mesh_filters, "MIN_REPEATED", 100, lambda mesh: mesh.filter_smooth_simple(7)),
        (mesh_filters, "MIN_REPEATED", 100, lambda mesh: mesh.filter_sharpen(8, 0.01, "color")),
    ],
)
def test_small_meshes_have_the_results_of_the_code_for_large_ones(
    device, rng, monkeypatch, module, limit, value, operation
):
    ball = TriangleMesh.create_sphere(1.0, 12)
    torn = ball.triangles[rng.random(len(ball.triangles)) < 0.8]
    torn[::29] = torn[::29, ::-1]
    crowding = rng.integers(0, len(ball.vertices), (20, 3))
    colors = rng.random(ball.vertices.shape)
    mesh = TriangleMesh(ball.vertices, [*torn, *torn[::9, [1, 0, 2]], *crowding], vertex_colors=colors, device=device)
    small = operation(mesh)
    monkeypatch.setattr(module, limit, value)
    large = operation(mesh)
    for name in ("vertices", "triangles", "vertex_colors"):
        np.testing.assert_array_equal(getattr(small, name), getattr(large, name))

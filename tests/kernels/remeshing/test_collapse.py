"""The steps of decimation: kinds of vertices, edges chosen at once, lists after a collapse, isolated triangles."""

import numpy as np
import pytest

from pointloom.kernels.lang import int32, uint8, vec2, vec3, vec3i
from pointloom.kernels.memory import download, upload, write
from pointloom.kernels.remeshing import collapse_mesh as cm
from pointloom.kernels.remeshing.collapse_rounds import CollapseRounds
from pointloom.kernels.remeshing.decimation import Decimation
from pointloom.kernels.remeshing.edge_bins import EdgeBins

from ...meshing.simplification_scenes import bumpy_torus, grid


def started(vertices, triangles, device: str, materials=None, target=10) -> CollapseRounds:
    arrays = [upload(vertices, vec3, device)]
    ids = None if materials is None else upload(materials, int32, device)
    job = Decimation(upload(triangles, vec3i, device), arrays, [], None, ids, target, np.inf, 1.0)
    rounds = CollapseRounds(job.mesh, [], target, np.inf)
    rounds.price_edges()
    return rounds


def number(mesh: cm.CollapseMesh, index: int) -> int:
    return int(download(mesh.numbers)[index])


def note(mesh: cm.CollapseMesh, index: int, value: int) -> None:
    write(mesh.numbers[index : index + 1], np.array([value], np.int32))


def owners(job: CollapseRounds):
    """The half-edges that have a price."""
    rows = np.flatnonzero(download(job.mesh.keys) < 2**63 - 3).astype(np.int32)
    return upload(rows, int32, job.mesh.keys.device)


def ends_of(job: CollapseRounds, edges) -> np.ndarray:
    triangles, h = download(job.mesh.triangles).reshape(-1, 3), download(edges)
    return np.stack([triangles[h // 3, h % 3], triangles[h // 3, (h + 1) % 3]], axis=1)


def test_vertices_are_free_on_a_line_or_corners(device):
    """A square with three materials that meet in its middle: two lines from there to the border, one along it."""
    vertices, triangles = grid(5)
    middles = vertices[triangles].mean(axis=1)
    materials = np.where(middles[:, 0] < 2, 0, np.where(middles[:, 1] < 2, 1, 2))
    kinds = download(started(vertices, triangles, device, materials).mesh.kinds).reshape(5, 5)
    expected = np.full((5, 5), cm.FREE_VERTEX)
    expected[[0, 4], :] = expected[:, [0, 4]] = cm.LINE_VERTEX
    expected[:, 2] = expected[2, 2:] = cm.LINE_VERTEX
    expected[2, 2] = expected[0, 2] = expected[4, 2] = expected[2, 4] = cm.CORNER_VERTEX
    np.testing.assert_array_equal(kinds, expected)


@pytest.mark.parametrize("rounds", [1, 3, 40])
def test_chosen_edges_are_apart_and_in_the_end_no_other_is(device, rounds):
    vertices, triangles = bumpy_torus(24, 16)
    job, rings = started(vertices, triangles, device), [{v} for v in range(24 * 16)]
    for t in triangles:
        for v in t:
            rings[v] |= set(map(int, t))
    edges = owners(job)
    note(job.mesh, cm.EDGE_COUNT, edges.size)
    job.choice.run(job.mesh, job.twin, edges, rounds)
    chosen, ends = download(job.choice.chosen)[: edges.size] == 1, ends_of(job, edges)
    near = [rings[a] | rings[b] for a, b in ends]
    taken = np.flatnonzero(chosen)
    assert len(taken) > 5
    for i in taken:
        assert not any(set(map(int, ends[j])) & near[i] for j in taken if j != i)
    around = set().union(*(near[i] for i in taken))
    assert set(np.flatnonzero(download(job.mesh.touched)).tolist()) == around
    keys = download(job.mesh.keys)[download(edges)]
    free = [i for i in np.flatnonzero(keys < 2**63 - 3) if not set(map(int, ends[i])) & around]
    assert not free or rounds < 40
    # the cheapest edge of all that may collapse is among them
    assert chosen[np.argmin(np.where(keys < 2**63 - 3, keys, 2**63 - 1))]


def test_the_number_of_collapsed_edges_matches_the_target(device):
    vertices, triangles = grid(12)
    job = started(vertices, triangles, device)
    edges = owners(job)
    ends = np.sort(ends_of(job, edges), axis=1)
    border = ((ends % 12 == 0) | (ends % 12 == 11)).all(axis=1) & (np.ptp(ends, axis=1) == 12)
    border |= ((ends // 12 == 0) | (ends // 12 == 11)).all(axis=1) & (np.ptp(ends, axis=1) == 1)
    order = np.argsort(download(job.mesh.keys)[download(edges)])
    removed = np.cumsum(np.where(border, 1, 2)[order])
    note(job.mesh, cm.PICKED_COUNT, edges.size)
    for max_count in (1, 2, 7, 100, int(removed[-1]), len(edges) // 2, 2 * len(edges)):
        bins = EdgeBins(len(triangles) - max_count, job.mesh)
        mask = upload(np.zeros(edges.size), uint8, edges.device)
        bins.mark_cheapest(job.mesh, edges, edges.size, mask)
        expected = np.zeros(len(order), np.uint8)
        expected[order[: np.searchsorted(removed, max_count) + 1]] = 1
        np.testing.assert_array_equal(download(mask), expected)
        assert not download(bins.bins).any()


def test_keys_of_edges_stay_unique_after_renumbering(device):
    """All squares of a flat grid have equal costs, so numbers order their edges; both of two equal ones collapse."""
    vertices, triangles = grid(40)
    job = started(vertices, triangles, device)
    mesh, slot_counts = job.mesh, []
    while number(mesh, cm.TRIANGLE_COUNT) > 300:
        slot_counts.append(number(mesh, cm.SLOT_COUNT))
        job.run_round()
        assert number(mesh, cm.CHOSEN_COUNT)
        job.price_edges()
        slots = number(mesh, cm.SLOT_COUNT)
        keys = download(mesh.keys)[: 3 * slots]
        keys = keys[keys < 2**63 - 3]
        assert len(keys) == len(np.unique(keys))
        left = download(mesh.triangles).reshape(-1, 3)[:slots, 0] >= 0
        assert left.sum() == number(mesh, cm.TRIANGLE_COUNT)
    assert len(np.unique(slot_counts)) > 4


@pytest.mark.parametrize("target", [5, 40])
def test_the_mesh_that_was_given_stays(device, target):
    """Rounds write in place: to copies."""
    vertices, triangles = grid(12)
    given, materials = (upload(triangles, vec3i, device), upload(np.arange(len(triangles)) // 121, int32, device))
    uvs = upload(np.repeat(vertices[triangles].reshape(-1, 3)[:, :2], 1, axis=0), vec2, device)
    originals = [download(values).copy() for values in (given, uvs, materials)]
    job = Decimation(given, [upload(vertices, vec3, device)], [], uvs, materials, target, np.inf, 1.0)
    job.run()
    assert job.mesh.triangles.size <= target
    for values, was in zip((given, uvs, materials), originals, strict=True):
        np.testing.assert_array_equal(download(values), was)


@pytest.mark.parametrize("target", [1, 2, 3])
def test_the_smallest_isolated_triangles_are_removed_first(device, target):
    """Four lone triangles, one of them without area. One is repeated, and one more names a vertex twice."""
    sizes = np.array([3.0, 1.0, 0.0, 2.0])
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
    points = np.concatenate([corners * size + [10 * k, 0, 0] for k, size in enumerate(sizes)])
    triangles = np.vstack([np.arange(12).reshape(4, 3), [[1, 2, 0]], [[3, 4, 3]]])
    arrays = [upload(points, vec3, device)]
    decimation = Decimation(upload(triangles, vec3i, device), arrays, [], None, None, target, np.inf, 1.0)
    decimation.run()
    result, (positions, *_), _, _ = decimation.result()
    edges = download(positions)[download(result)]
    areas = np.linalg.norm(np.cross(edges[:, 1] - edges[:, 0], edges[:, 2] - edges[:, 0]), axis=1)
    np.testing.assert_allclose(np.sort(areas), np.sort(sizes**2)[-target:], rtol=1e-6)

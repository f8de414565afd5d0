"""Triangle intersections: Open3D's pairs where it is right, integer arithmetic where it is not."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom import TriangleMesh

from .open3d_meshes import in_open3d
from .surface_oracles import meeting_pairs
from .test_mesh import rough_ball
from .test_scene_distances import CUBE, FAR, torus


def open3d_pairs(o3d, vertices, triangles) -> np.ndarray:
    mesh = TriangleMesh(vertices, triangles, origin=[0, 0, 0])
    pairs = np.asarray(in_open3d(o3d, mesh).get_self_intersecting_triangles(), np.int32).reshape(-1, 2)
    pairs = np.sort(pairs, axis=1)
    return pairs[np.lexsort(pairs.T[::-1])]


def pairs_of(vertices, triangles, device=None) -> list[list[int]]:
    return TriangleMesh(vertices, triangles, device=device).get_self_intersecting_triangles().tolist()


def test_pairs_match_open3d(device, oracle):
    rng = np.random.default_rng(0)
    crowd = rng.random((240, 3)), rng.permutation(240).reshape(-1, 3)
    spread = rng.random((900, 3)) * 0.15 + rng.random((300, 3)).repeat(3, 0), np.arange(900).reshape(-1, 3)
    flat = crowd[0] * [1, 1, 0], crowd[1]
    for name, scene in (("crowd", crowd), ("spread", spread), ("flat", flat)):
        pairs = pairs_of(*scene, device)
        assert pairs == oracle(f"meshing/intersections/{name}", open3d_pairs, *scene).tolist() and len(pairs) > 10


def test_a_torus_intersects_itself_only_after_self_penetration(device, oracle):
    vertices, triangles = torus()
    assert not TriangleMesh(vertices, triangles, device=device).is_self_intersecting()
    two = np.vstack([vertices, vertices + np.array([0.5, 0, 0])]), np.vstack([triangles, triangles + len(vertices)])
    mesh = TriangleMesh(*two, device=device)
    pairs = mesh.get_self_intersecting_triangles().tolist()
    theirs = oracle("meshing/intersections/torus", open3d_pairs, *two).tolist()
    assert mesh.is_self_intersecting() and all(pair in pairs for pair in theirs)
    integers = (mesh.vertices * 2.0**40).astype(np.int64).astype(object)  # exactly
    for pair in pairs:  # pairs that touch are decided as well
        assert pair in theirs or meeting_pairs(integers, two[1][pair]) == [[0, 1]]
    assert len(pairs) > len(theirs) > 100


@pytest.mark.parametrize(
    ("last", "pairs"), [([1, 0, 0], [[0, 1]]), ([0, 0, 0], [[0, 1]]), ([1, -1, 0], []), ([-1, 0, 0], [])]
)
def test_triangles_that_touch_in_one_point_intersect(device, last, pairs):
    corners = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [-1, -3, -1], [-1, -3, 1], last]  # shared: an edge, a corner, nothing
    assert pairs_of(corners, [[0, 1, 2], [3, 4, 5]], device) == pairs


SMALL = st.integers(-2, 2)


@pytest.mark.slow
@settings(deadline=None, max_examples=60)
@given(st.lists(st.tuples(SMALL, SMALL, SMALL), min_size=6, max_size=15))
def test_touching_is_decided_exactly(points):
    vertices = np.array(points)[: len(points) // 3 * 3]  # many touch, many are flat, some are points
    triangles = np.arange(len(vertices)).reshape(-1, 3)
    assert pairs_of(vertices, triangles) == meeting_pairs(vertices, triangles)


def test_degenerate_triangles_intersect_where_their_segments_do(device):
    """Differences of these coordinates have more bits than float32, so many signs are undecided in float64."""
    axes = np.array([[1398101, 699051, 466033], [-466033, 1398101, 699051], [3, -5, 7]])
    flat = [[[-5, 0, 0], [1, 0, 0], [3, 0, 0]], [[3, 0, 0], [4, 0, 0], [5, 0, 0]], [[-4, 0, 0]] * 3]
    flat += [[[0, -2, 0], [0, 1, 0], [0, 3, 0]], [[1, 1, 0], [2, 1, 0], [3, 1, 0]]]
    flat += [[[-2, -1, 0], [2, -1, 0], [0, 2, 0]], [[-1, -2, 1], [-1, 1, 1], [-1, 3, 1]]]
    vertices, triangles = np.reshape(flat, (-1, 3)) @ axes, np.arange(3 * len(flat)).reshape(-1, 3)
    pairs = TriangleMesh(vertices, triangles, device=device, origin=[0, 0, 0]).get_self_intersecting_triangles()
    assert pairs.tolist() == meeting_pairs(vertices, triangles) and 3 < len(pairs) < 15


@pytest.mark.slow
@pytest.mark.parametrize("scale", [2.0**-20, 1.0, 2.0**20])
def test_touching_is_decided_exactly_in_slanted_planes_at_all_scales(device, scale):
    rng = np.random.default_rng(1)
    axes = np.array([[3, 1, 2], [1, -4, 5]])  # a plane in which integer coordinates are still exact
    vertices = rng.integers(-40, 40, (90, 2)) @ axes
    vertices[:30, 2] += rng.integers(0, 2, 30)
    triangles = np.arange(90).reshape(-1, 3)
    pairs = pairs_of(vertices * scale, triangles, device)
    assert pairs == meeting_pairs(vertices, triangles) and len(pairs) > 5


def open3d_counts(o3d, scenes):
    return [len(open3d_pairs(o3d, vertices, [[0, 1, 2], [3, 4, 5]])) for vertices in scenes]


def test_coplanar_disjoint_triangles_do_not_intersect_unlike_open3d(device, oracle):
    # as in Open3D's issue 5117: two adjacent coplanar triangles
    rng, pair = np.random.default_rng(2), [[0, 1, 2], [3, 4, 5]]
    scenes = [rng.integers(0, 6, (6, 3)) * [0, 1, 1] for _ in range(40)]
    result = [pairs_of(scene, pair, device) for scene in scenes]
    assert result == [meeting_pairs(scene, np.array(pair)) for scene in scenes]
    theirs, counts = oracle("meshing/intersections/plane", open3d_counts, scenes), [len(p) for p in result]
    assert sum(counts) and counts != theirs


def test_a_rough_ball_pair_is_apart_where_open3d_reports_an_intersection(device, oracle):
    ball = rough_ball(device)
    theirs = oracle("meshing/intersections/rough_ball", open3d_pairs, ball.vertices, ball.triangles).tolist()
    # exactly: float32 of this size are multiples of 2^-60
    integers = np.vectorize(int, otypes=[object])(ball.vertices * 2.0**60)
    assert len(theirs) == 1 and meeting_pairs(integers, ball.triangles[theirs[0]]) == []
    assert not ball.is_self_intersecting()


def test_one_ulp_separates_two_triangles(device):
    touching = np.array([[0, 0, 0], [3, 0, 0], [0, 3, 0], [1, 1, 0], [1, 1, 2], [2, 1, 2]], np.float32)
    apart = touching.copy()
    apart[3, 2] = np.nextafter(np.float32(0), np.float32(1)) * 2**30  # 6e-37, below the resolution of float64 sums
    triangles = [[0, 1, 2], [3, 4, 5]]
    assert pairs_of(touching, triangles, device) == [[0, 1]]
    assert pairs_of(apart, triangles, device) == []


def test_meshes_intersect_at_their_surfaces_and_not_by_containment(device):
    cube = np.array(CUBE[0], float)
    mesh = TriangleMesh(cube, CUBE[1], device=device)
    touching, inside = [([1, 0, 0], 1, True), ([1.0001, 0, 0], 1, False)], [([0.25] * 3, 0.5, False)]
    for shift, size, meets in (*touching, *inside, ([0.5] * 3, 1, True)):
        other = TriangleMesh(cube * size + shift, CUBE[1], device=device)
        assert mesh.is_intersecting(other) == other.is_intersecting(mesh) == meets
    far = TriangleMesh(cube + FAR, CUBE[1], device=device)
    assert far.is_intersecting(TriangleMesh(cube + FAR + 0.5, CUBE[1], device=device))
    assert not far.is_intersecting(mesh)


def test_impossible_pairs_do_not_intersect(device):
    nothing = TriangleMesh([], [], device=device)
    cube = TriangleMesh(*CUBE, device=device)
    assert not nothing.is_self_intersecting() and nothing.get_self_intersecting_triangles().shape == (0, 2)
    assert not cube.is_intersecting(nothing) and not nothing.is_intersecting(cube)
    broken = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [np.nan, 0, 0], [0.2, 0.2, -1], [0.2, 0.2, 1]]
    assert pairs_of(broken, [[0, 1, 2], [3, 4, 5]], device) == []
    assert pairs_of(broken, [[0, 1, 2], [0, 1, 2]], device) == []  # they share vertices
    assert pairs_of([*broken[:3], *broken[:3]], [[0, 1, 2], [3, 4, 5]], device) == [[0, 1]]
    with pytest.raises(TypeError, match="other:"):
        cube.is_intersecting("cube")


def test_a_corner_in_a_slanted_plane_touches_although_float64_disagrees(device, rng):
    for _ in range(40):
        u, v = rng.integers(-999, 1000, (2, 3))
        normal = np.cross(u, v)
        corner = rng.integers(1, 2000) * u + rng.integers(1, 2000) * v  # integers below 2^24: exact in float32
        above = np.round(1000 * normal / np.linalg.norm(normal)).astype(int)
        floor = TriangleMesh([0 * u, 4001 * u, 4001 * v], [[0, 1, 2]], device=device, origin=[0, 0, 0])
        standing = [corner, corner + above, corner + above + u]
        assert floor.is_intersecting(TriangleMesh(standing, [[0, 1, 2]], device=device, origin=[0, 0, 0]))

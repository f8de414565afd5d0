"""One image for each triangle with minimal energy, and seams where images meet."""

import itertools

import numpy as np
import pytest
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import maximum_flow

import pointloom as loom
from pointloom.kernels.lang import int32, vec3i
from pointloom.kernels.memory import download, upload
from pointloom.kernels.textures.charts import find_twins
from pointloom.kernels.textures.view_labels import MAX_IMAGE_COST, LabelGraph, choose_labels, energy_of

from ...meshing.image_scenes import CAMERA, sampled, wall_scene


def make_graph(triangles, costs, price, warp_device):
    """A graph of a mesh whose triangles may take the images with a cost of 0 or more."""
    shown = costs >= 0
    starts = np.concatenate([[0], np.cumsum(shown.sum(1))])
    twins = find_twins(upload(triangles, vec3i, warp_device), int(triangles.max()) + 1)
    numbers = (starts, np.nonzero(shown)[1], costs[shown])
    return LabelGraph(*(upload(part, int32, warp_device) for part in numbers), twins, price)


def energy_by_hand(triangles, costs, price, views):
    edges = {}
    for t, corners in enumerate(triangles.tolist()):
        for k in range(3):
            edges.setdefault(frozenset((corners[k], corners[(k + 1) % 3])), []).append(t)
    met = [pair for pair in edges.values() if len(pair) == 2]
    return sum(costs[t, v] for t, v in enumerate(views)) + price * sum(views[a] != views[b] for a, b in met), met


def grid(columns, rows):
    numbers = np.arange((columns + 1) * (rows + 1)).reshape(rows + 1, columns + 1)
    a, b, c, d = (part.ravel() for part in (numbers[:-1, :-1], numbers[:-1, 1:], numbers[1:, 1:], numbers[1:, :-1]))
    return np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])


@pytest.mark.parametrize("price", [0, 0.2, 0.6])
def test_a_strip_of_triangles_gets_the_images_of_minimal_energy(device, rng, price):
    """Its graph is a tree, on which the messages between triangles are exact."""
    triangles = np.array([(t, t + 1, t + 2) if t % 2 else (t + 1, t, t + 2) for t in range(7)])
    costs = rng.integers(0, MAX_IMAGE_COST, (7, 3))
    costs[rng.random(costs.shape) < 0.2] = -1
    costs[:, 0] = np.maximum(costs[:, 0], 0)
    graph = make_graph(triangles, costs, round(price * MAX_IMAGE_COST), device)
    labels = choose_labels(graph)
    choices = itertools.product(*(np.flatnonzero(row >= 0) for row in costs))
    best = min(energy_by_hand(triangles, costs, graph.price, views)[0] for views in choices)
    assert energy_of(graph, labels) == best
    views = download(graph.views)[download(labels)]
    assert energy_by_hand(triangles, costs, graph.price, views)[0] == best


@pytest.mark.parametrize("price", [0.1, 0.3, 0.8])
def test_two_images_of_a_grid_are_within_a_percent_of_the_minimum_cut(device, rng, price):
    triangles = grid(12, 9)
    costs = rng.integers(0, MAX_IMAGE_COST, (len(triangles), 2))
    graph = make_graph(triangles, costs, round(price * MAX_IMAGE_COST), device)
    energy = energy_of(graph, choose_labels(graph))
    count = len(triangles)
    _, met = energy_by_hand(triangles, costs, 0, np.zeros(count, int))
    capacity = np.zeros((count + 2, count + 2), np.int32)
    capacity[count, :count], capacity[:count, count + 1] = costs[:, 1], costs[:, 0]
    for a, b in met:
        capacity[a, b] = capacity[b, a] = graph.price
    min_cut = maximum_flow(csr_matrix(capacity), count, count + 1).flow_value
    assert min_cut <= energy <= 1.01 * min_cut


def test_triangles_without_an_image_stay_without_and_cost_nothing(device):
    triangles = grid(2, 1)
    costs = np.array([[5, 9], [-1, -1], [9, 5], [5, 5]])
    graph = make_graph(triangles, costs, 100, device)
    labels = choose_labels(graph)
    assert download(labels)[1] == -1 and energy_of(graph, labels) <= 5 + 9 + 5


texture, Option = loom.meshing.texture_from_images, loom.meshing.ImageTextureOption
POSITIONS = np.linspace(0.02, 0.98, 9)
HOW = {"exposures": False, "seam_leveling": False, "smoothness": 0.0, "outliers": False}


def wedges(device):
    """Three triangles about a point, and images that differ by constants, of which each is the best for one."""
    scene = wall_scene((1.0, 1.0, 1.0), device)
    around = [(0.3 * np.cos(t), 0.3 * np.sin(t), 0.0) for t in np.radians((90, 210, 330))]
    mesh = loom.TriangleMesh([(0.0, 0.0, 0.0), *around], [[0, 2, 1], [0, 3, 2], [0, 1, 3]], device=device)
    v, u = np.mgrid[: CAMERA.height, : CAMERA.width]
    angle = np.degrees(np.arctan2(v - CAMERA.cy, u - CAMERA.cx)) % 360
    images = []
    for k, level in enumerate((90, 120, 180)):
        middle = (150, 270, 30)[k]
        detail = 12.0 * (np.abs((angle - middle + 180) % 360 - 180) < 58) * ((u + v) % 4 < 2)
        images.append(np.repeat((level + detail)[..., None], 3, 2).astype(np.uint8))
    return mesh, images, [scene.extrinsics[1]] * 3


def steps_at(result, positions):
    """The steps between each two of the triangles, along the edge from the middle, in the mean of channels."""
    steps = []
    triangles = np.asarray(result.mesh.triangles)
    for a in range(3):
        b = (a + 1) % 3
        shared = next(v for v in triangles[a] if v and v in triangles[b])
        for position in positions:
            colors = []
            for row in (a, b):
                fraction = np.zeros(3)
                fraction[triangles[row] == 0], fraction[triangles[row] == shared] = 1 - position, position
                colors.append(sampled(result.mesh, row, fraction))
            steps.append(np.abs(colors[0] - colors[1]).mean())
    return np.array(steps)


def test_three_adjacent_images_have_one_color_at_their_corner(device):
    mesh, images, poses = wedges(device)
    plain = texture(mesh, images, CAMERA, poses, Option(local_leveling=False, **HOW))
    assert len(set(plain.views.tolist())) == 3 and steps_at(plain, POSITIONS).min() > 15
    result = texture(mesh, images, CAMERA, poses, Option(**HOW))
    assert steps_at(result, POSITIONS).max() < 1.5
    middle = [sampled(result.mesh, row, np.asarray(result.mesh.triangles)[row] == 0).mean() for row in range(3)]
    assert np.ptp(middle) < 1.5
    assert 126 < np.mean(middle) < 142  # 130, the mean of all three, with up to 12 of detail


def test_far_from_seams_nothing_changes(device):
    mesh, images, poses = wedges(device)
    large = loom.PinholeCameraIntrinsic(CAMERA.width * 4, CAMERA.height * 4, 360.0, 360.0, 191.5, 143.5)
    finer = [np.repeat(np.repeat(image, 4, 0), 4, 1) for image in images]
    plain = texture(mesh, finer, large, poses, Option(local_leveling=False, **HOW))
    result = texture(mesh, finer, large, poses, Option(**HOW))
    for row in range(3):
        outer = np.where(np.asarray(mesh.triangles)[row] == 0, 0.2, 0.4)
        assert np.array_equal(sampled(result.mesh, row, outer), sampled(plain.mesh, row, outer))


@pytest.mark.parametrize("price", [0.1, 0.4])
def test_after_no_messages_no_single_change_lowers_the_energy(device, rng, price):
    """The start is the cheapest view of each triangle; changes of single triangles lead to a local minimum."""
    triangles = grid(7, 5)
    costs = rng.integers(0, MAX_IMAGE_COST, (len(triangles), 3))
    graph = make_graph(triangles, costs, round(price * MAX_IMAGE_COST), device)
    views = download(graph.views)[download(choose_labels(graph, iterations=0))]
    start, _ = energy_by_hand(triangles, costs, graph.price, costs.argmin(axis=1))
    energy, _ = energy_by_hand(triangles, costs, graph.price, views)
    assert energy < start
    for triangle, view in itertools.product(range(len(triangles)), range(3)):
        changed = views.copy()
        changed[triangle] = view
        assert energy_by_hand(triangles, costs, graph.price, changed)[0] >= energy

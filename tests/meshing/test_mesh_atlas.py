"""Charts of a mesh in a texture image, and vertex colors drawn into it."""

import sys

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom import TriangleMesh

pytestmark = pytest.mark.skipif(sys.version_info >= (3, 14), reason="xatlas has no wheels for Python 3.14")


def covered(uvs: np.ndarray, size: int, slack: float = 0.0) -> np.ndarray:
    """The number of triangles that contain each texel center with a margin, or (with slack) nearly contain it."""
    counts = np.zeros((size, size), int)
    pixels = uvs.reshape(-1, 3, 2) * [size, -size] + [0, size]
    for corners in pixels:
        low = np.maximum(np.floor(corners.min(axis=0) - slack).astype(int), 0)
        high = np.minimum(np.ceil(corners.max(axis=0) + slack).astype(int), size)
        y, x = np.mgrid[low[1] : high[1], low[0] : high[0]] + 0.5
        edges = np.roll(corners, -1, axis=0) - corners
        area = edges[0, 0] * edges[1, 1] - edges[0, 1] * edges[1, 0]
        if abs(area) < 1e-9 or not x.size:
            continue
        sides = [
            (e[0] * (y - c[1]) - e[1] * (x - c[0])) * np.sign(area) / np.hypot(*e)
            for c, e in zip(corners, edges, strict=True)
        ]
        counts[low[1] : high[1], low[0] : high[0]] += np.min(sides, axis=0) > (1e-4 if slack == 0 else -slack)
    return counts


SHAPES = {
    "torus": lambda: TriangleMesh.create_torus(),
    "box": lambda: TriangleMesh.create_box(),
    "band": lambda: TriangleMesh.create_mobius(20, 4),
    "small": lambda: TriangleMesh.create_sphere(1e-6, 8),
    "large": lambda: TriangleMesh.create_sphere(1e6, 8),
}


@pytest.mark.parametrize("name", SHAPES)
def test_no_two_triangles_share_a_texel(name):
    mesh = SHAPES[name]()
    atlas = mesh.compute_uvatlas(256)
    counts = covered(atlas.triangle_uvs, 256)
    assert counts.max() == 1
    assert (counts > 0).mean() > 0.4  # large parts of the image are used
    np.testing.assert_array_equal(atlas.vertices, mesh.vertices)
    np.testing.assert_array_equal(atlas.triangles, mesh.triangles)
    np.testing.assert_array_equal(atlas.triangle_uvs, SHAPES[name]().compute_uvatlas(256).triangle_uvs)


@pytest.mark.parametrize(("size", "gutter"), [(128, 4), (512, 1)])
def test_charts_keep_their_distance(size, gutter):
    box = TriangleMesh.create_box().compute_uvatlas(size, gutter)
    charts = [covered(box.triangle_uvs[6 * k : 6 * k + 6], size, gutter / 2 - 0.01) > 0 for k in range(6)]
    sides = {tuple(np.argwhere(chart)[0]) for chart in charts}
    assert len(sides) == 6
    assert np.sum(charts, axis=0).max() == 1  # widened by half of it, no two faces of the box overlap


def test_odd_triangles_keep_their_indices(device):
    vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [2, 2, 2]]
    mesh = TriangleMesh(vertices, [[0, 1, 2], [0, 0, 1], [1, 3, 2], [4, 4, 4], [0, 1, 2]], device=device)
    mesh.vertex_colors = np.eye(5, 3)
    atlas = mesh.compute_uvatlas(64)
    corners = atlas.triangle_uvs.reshape(-1, 3, 2)
    assert (corners[[1, 3]] == 0).all() and covered(corners[:4].reshape(-1, 2), 64).max() == 1
    np.testing.assert_array_equal(atlas.vertex_colors, np.eye(5, 3))
    assert atlas.device == mesh.device


def test_invalid_atlas_input_is_rejected(monkeypatch):
    mesh = TriangleMesh.create_torus()
    for arguments, error, reason in (
        ({"size": 0}, ValueError, "size"),
        ({"size": 2**15}, ValueError, "at most 2.28 texels"),
        ({"gutter": -1}, ValueError, "gutter"),
        ({"size": 16, "gutter": 4}, ValueError, "size: 16 x 16 texels are too few for the mesh"),
        ({"size": 2.5}, TypeError, "size"),
    ):
        with pytest.raises(error, match=reason):
            mesh.compute_uvatlas(**arguments)
    broken = TriangleMesh([[0, 0, 0], [1, 0, 0], [0, np.nan, 0]], [[0, 1, 2]])
    for odd, reason in ((TriangleMesh([[0, 0, 0]]), "no triangles"), (broken, "finite vertices")):
        with pytest.raises(ValueError, match=reason):
            odd.compute_uvatlas()
    monkeypatch.setitem(sys.modules, "xatlas", None)
    with pytest.raises(ImportError, match=r'pip install "pointloom\[mesh\]"'):
        mesh.compute_uvatlas()


def colored(mesh: TriangleMesh) -> TriangleMesh:
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    mesh.vertex_colors = (mesh.vertices - low) / np.where(high > low, high - low, 1)
    return mesh


def sampled(image: np.ndarray, uvs: np.ndarray) -> np.ndarray:
    """The image at texture coordinates, bilinear, in 0..1."""
    size = len(image)
    pixels = np.clip(uvs * [size, -size] + [-0.5, size - 0.5], 0, size - 1.001)
    x, y = np.floor(pixels).astype(int).T
    s, t = (pixels - np.floor(pixels)).T[:, :, None]
    rows = image.astype(float) / 255
    upper, lower = rows[y, x] * (1 - s) + rows[y, x + 1] * s, rows[y + 1, x] * (1 - s) + rows[y + 1, x + 1] * s
    return upper * (1 - t) + lower * t


def test_a_baked_texture_shows_the_colors_of_the_surface(device):
    mesh = colored(TriangleMesh.create_torus(device=device)).compute_uvatlas(256, 4)
    baked = mesh.bake_vertex_colors(256)
    assert baked.vertex_colors is None
    (image,) = baked.textures
    rng = np.random.default_rng(0)
    weights = rng.dirichlet([0.5] * 3, (len(mesh), 8))
    uvs = np.einsum("tkc,tcx->tkx", weights, mesh.triangle_uvs.reshape(-1, 3, 2)).reshape(-1, 2)
    colors = np.einsum("tkc,tcx->tkx", weights, mesh.vertex_colors[mesh.triangles]).reshape(-1, 3)
    error = np.abs(sampled(image, uvs) - colors)
    assert error.max() < 0.03  # a texel is 1/40 of the ring; background would be off by up to 1


def test_texels_are_the_colors_at_their_centers(device):
    plane = TriangleMesh.create_plane(create_uv_map=True, device=device)
    plane.vertex_colors = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    (image,) = plane.bake_vertex_colors(16, gutter=0).textures
    centers = (np.arange(16) + 0.5) / 16
    expected = np.stack([np.tile(centers, (16, 1)), np.tile(centers[::-1, None], 16), np.zeros((16, 16))], axis=-1)
    np.testing.assert_array_equal(image, np.floor(expected * 255 + 0.5).astype(np.uint8))


def test_gutter_has_the_requested_width(device):
    mesh = TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], device=device)
    mesh.vertex_colors, mesh.triangle_uvs = [[1, 1, 1]] * 3, [[0.5, 0.5], [0.75, 0.5], [0.5, 0.75]]
    inside = covered(mesh.triangle_uvs, 32, 1e-6) > 0
    for gutter in (0, 1, 3):
        (image,) = mesh.bake_vertex_colors(32, gutter=gutter).textures
        wide = inside.copy()
        for _ in range(gutter):
            grown = np.pad(wide, 1)
            wide = np.any([grown[1 + y : 33 + y, 1 + x : 33 + x] for y in (-1, 0, 1) for x in (-1, 0, 1)], axis=0)
        np.testing.assert_array_equal(image[..., 0] == 255, wide)
        assert set(np.unique(image)) <= {0, 255}


@settings(max_examples=15, derandomize=True, deadline=None, database=None)
@given(st.integers(0, 10**6), st.integers(1, 40))
def test_triangles_of_a_texture_color_the_texels_that_they_cover(seed, size):
    rng = np.random.default_rng(seed)
    mesh = TriangleMesh(rng.random((12, 3)), np.arange(12).reshape(-1, 3))
    mesh.vertex_colors, mesh.triangle_uvs = np.ones((12, 3)), rng.random((12, 2))
    (image,) = mesh.bake_vertex_colors(size, gutter=0).textures
    surely, perhaps = covered(mesh.triangle_uvs, size) > 0, covered(mesh.triangle_uvs, size, 1e-4) > 0
    assert (image[surely] == 255).all() and (image[~perhaps] == 0).all()

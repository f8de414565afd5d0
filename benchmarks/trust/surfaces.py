"""Reliability of surfaces and meshes, compared with the mesh that the points were sampled from.

A surface is correct if 95 % of it are within 2 % of the shape's size of the ground truth and vice versa, and if its
borders are no longer than eight times that size where the ground truth has none. If points are missing, it must contain
95 % of the part with points. Points are drawn from the shapes of `surface_shapes.HELD_OUT`, on which no constant was
chosen, and real objects are scanned from several sides.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from judged import Case, Judged
from real_data import real_data
from surface_shapes import HELD_OUT, Present, Sampled, sampled, scanned

NEAR, MIN_FRACTION = 0.02, 0.95  # fraction of the diagonal; fraction of the surface
SHAPES = ("nefertiti", "cheburashka", "fandisk", "stanford-bunny")  # .obj files of the real data
SAMPLES = 3000  # on each surface
CASES, SEED = 1000, 53
SCANS = 300  # of real objects
SMOOTH, ALPHA_CASES = ("star", "hills", "rounded"), 600  # further clouds for alpha shapes, which are rarely correct
LONGEST = 8.0  # maximum border length, in diagonals


def shapes() -> dict[str, Callable[[], Any]]:
    """Functions that make meshes of size one; those of real meshes raise `DataMissingError` without data."""
    import pointloom as loom

    def real(name: str) -> Any:
        mesh = loom.read_triangle_mesh(real_data(f"mesh-common3d/{name}.obj"))
        return mesh.scale(1 / float(np.ptp(mesh.vertices, axis=0).max()), (0, 0, 0))

    made = {
        "torus": lambda: loom.TriangleMesh.create_torus(0.4, 0.12),
        "tall box": lambda: loom.TriangleMesh.create_box(0.3, 0.3, 0.9),
    }
    return made | {name: lambda name=name: real(name) for name in SHAPES}


class Truth:
    """A mesh with which surfaces are compared."""

    def __init__(self, mesh: Any) -> None:
        self.size = float(np.linalg.norm(np.ptp(mesh.vertices, axis=0)))
        self._scene, self._points, self._border = _scene_of(mesh), _points_of(mesh), _border_of(mesh)

    def is_right(self, mesh: Any, present: Present | None = None) -> tuple[bool, str]:
        """Whether a surface matches this one, or the present part of it, and the fractions within the threshold."""
        if not len(mesh) or mesh.get_surface_area() == 0:
            return False, "no surface"
        points = self._points if present is None else self._points[present(self._points)]
        pairs = (self._scene, _points_of(mesh)), (_scene_of(mesh), points)
        fractions = [float((scene.compute_distance(points) < NEAR * self.size).mean()) for scene, points in pairs]
        borders = (_border_of(mesh) - self._border) / self.size
        right = min(fractions) >= MIN_FRACTION and borders <= LONGEST
        return right, f"{fractions[0]:.0%} true, {fractions[1]:.0%} there, borders {borders:.1f} times its size"


def _scene_of(mesh: Any) -> Any:
    import pointloom as loom

    scene = loom.RaycastingScene()
    scene.add_triangles(mesh)
    return scene


def _points_of(mesh: Any) -> Any:
    return mesh.sample_points_uniformly(SAMPLES, seed=1).points.astype(np.float32)


def _border_of(mesh: Any) -> float:
    """Total length of border edges [m]."""
    triangles = mesh.triangles
    edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    edges, counts = np.unique(edges, axis=0, return_counts=True)
    ends = mesh.vertices[edges[counts == 1]]
    return float(np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).sum())


def cases() -> Iterator[Case]:
    for k in range(SCANS):
        yield Case(f"scan {k}", lambda k=k: _scans(k))
    smooth = {name: HELD_OUT[name] for name in SMOOTH}
    for k in range(CASES):
        yield Case(f"cloud {k}", lambda k=k: _surfaces(HELD_OUT, k))
    for k in range(CASES, CASES + ALPHA_CASES):
        yield Case(f"cloud {k}", lambda k=k: _surfaces(smooth, k, ("alpha",)))


def _scans(k: int) -> Iterator[Judged]:
    for points in scanned([k], SEED):
        yield from _through_points(points, area="surface of scans, {}")


def _surfaces(shapes: dict[str, Any], k: int, *methods: tuple[str, ...]) -> Iterator[Judged]:
    for points in sampled(shapes, [k], SEED):
        yield from _through_points(points, *methods)


def _through_points(
    sample: Sampled, methods: tuple[str, ...] = ("poisson", "ball", "alpha"), area: str = "surface, {}"
) -> Iterator[Judged]:
    """Surfaces through points of a shape. Every second alpha is not the default."""
    import pointloom as loom

    cloud, truth = loom.PointCloud(sample.points, normals=sample.normals), Truth(sample.truth)
    for method in methods:
        alpha = sample.alpha if method == "alpha" else None
        result = loom.meshing.create_surface(cloud, method, alpha=alpha)
        case = sample.case + ("" if alpha is None else f", alpha {alpha:.3g}")
        yield judged(area.format(method), case, result.mesh, truth, result.warnings, sample.present)


def judged(
    area: str, case: str, mesh: Any, truth: Truth, warnings: tuple[str, ...], present: Present | None = None
) -> Judged:
    right, figure = truth.is_right(mesh, present)
    return Judged(
        area, case, 1, not right, not right and not warnings, right and bool(warnings), "; ".join(warnings), figure
    )

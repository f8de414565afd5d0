"""Reliability of surfaces and meshes, compared with the mesh that the points were sampled from.

A surface is correct if 95 % of it are within 2 % of the shape's size of the ground truth and vice versa, and if its
borders are no longer than eight times that size where the ground truth has none. If points are missing, the ground
truth
is the covered part. Shapes are real and synthetic meshes; their points get noise, gaps, and opposite normals.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from judged import Judged
from real_data import DataMissingError, real_data

NEAR, MIN_SHARE = 0.02, 0.95  # fraction of the diagonal; fraction of the surface
SHAPES = ("nefertiti", "cheburashka", "fandisk", "stanford-bunny")  # .obj files of the real data
NOISES = (0.0, 0.003, 0.03)  # fractions of the diagonal
COUNT = 4000  # points of a cloud
SAMPLES = 8000  # on each surface
LONGEST = 8.0  # maximum border length, in diagonals


def shapes() -> Iterator[tuple[str, Any]]:
    """Meshes of size one, including real ones if available."""
    import pointloom as loom

    yield "torus", loom.TriangleMesh.create_torus(0.4, 0.12)
    yield "tall box", loom.TriangleMesh.create_box(0.3, 0.3, 0.9)
    for name in SHAPES:
        try:
            mesh = loom.read_triangle_mesh(real_data(f"mesh-common3d/{name}.obj"))
        except DataMissingError:
            continue
        yield name, mesh.scale(1 / float(np.ptp(mesh.vertices, axis=0).max()), (0, 0, 0))


def is_right(mesh: Any, truth: Any, is_complete: bool = True) -> tuple[bool, str]:
    """Whether a surface matches the true one, or a part of it, and the fractions of both within the threshold."""
    import pointloom as loom

    if not len(mesh) or mesh.get_surface_area() == 0:
        return False, "no surface"
    far = NEAR * float(np.linalg.norm(np.ptp(truth.vertices, axis=0)))
    shares = []
    for one, other in ((mesh, truth), (truth, mesh)):
        scene = loom.RaycastingScene()
        scene.add_triangles(other)
        points = one.sample_points_uniformly(SAMPLES, seed=1).points
        shares.append(float((scene.compute_distance(points.astype(np.float32)) < far).mean()))
    borders = (_border_of(mesh) - _border_of(truth)) / float(np.linalg.norm(np.ptp(truth.vertices, axis=0)))
    right = min(shares[: 1 + is_complete]) >= MIN_SHARE and borders <= LONGEST
    return right, f"{shares[0]:.0%} true, {shares[1]:.0%} there, borders {borders:.1f} times its size"


def _border_of(mesh: Any) -> float:
    """Total length of border edges [m]."""
    triangles = mesh.triangles
    edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    edges, counts = np.unique(edges, axis=0, return_counts=True)
    ends = mesh.vertices[edges[counts == 1]]
    return float(np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).sum())


def judge() -> Iterator[Judged]:
    for name, truth in shapes():
        yield from _through_points(name, truth)
        yield from _changed(name, truth)


def _through_points(name: str, truth: Any) -> Iterator[Judged]:
    import pointloom as loom

    size = float(np.linalg.norm(np.ptp(truth.vertices, axis=0)))
    cloud = truth.sample_points_uniformly(COUNT, seed=3)
    points, normals = cloud.points, cloud.estimate_normals(max_nn=12).normals
    rng = np.random.default_rng(5)
    clouds = {f"noise of {100 * noise:g} %": points + rng.normal(0, noise * size, points.shape) for noise in NOISES}
    clouds["half of it missing"] = points[points[:, 0] < np.median(points[:, 0])]
    clouds["a tenth of the points"] = points[::10]
    for case, chosen in clouds.items():
        for method in ("poisson", "ball", "alpha"):
            result = loom.create_surface(loom.PointCloud(chosen), method)
            is_complete = "missing" not in case
            yield _judged(f"surface, {method}", f"{name}, {case}", result.mesh, truth, result.warnings, is_complete)
    flipped = normals * rng.choice((-1.0, 1.0), (len(normals), 1))
    for method in ("poisson", "ball"):
        result = loom.create_surface(loom.PointCloud(points, normals=flipped), method)
        yield _judged(f"surface, {method}", f"{name}, normals to either side", result.mesh, truth, result.warnings)


def _changed(name: str, truth: Any) -> Iterator[Judged]:
    import pointloom as loom

    full = loom.clean_mesh(truth).mesh
    count = len(full)
    for share in (0.5, 0.1, 0.004):
        few = max(int(share * count), 4)
        simple = loom.simplify_mesh(full, triangles=few)
        yield _judged("simplified mesh", f"{name}, {few:,} of {count:,} triangles", simple.mesh, truth, simple.warnings)
    for method, iterations in (("taubin", 10), ("simple", 3), ("simple", 300), ("laplacian", 300)):
        smooth = loom.smooth_mesh(full, method, iterations)
        yield _judged("smoothed mesh", f"{name}, {method} {iterations} times", smooth.mesh, truth, smooth.warnings)
    for merge in (1e-6, 0.3):
        clean = loom.clean_mesh(full, merge_distance=merge)
        yield _judged("cleaned mesh", f"{name}, vertices merged within {merge:g}", clean.mesh, truth, clean.warnings)
    for case, other, alike in (
        ("itself", full, True),
        ("itself in other units", full.scale(1000, (0, 0, 0)), False),
        ("itself elsewhere", full.translate((0.5, 0, 0)), False),
        ("a sphere", loom.TriangleMesh.create_sphere(0.5), False),
    ):
        warnings = "; ".join(loom.compare_meshes(full, other, samples=5000).warnings)
        wrong, passed = not alike, not warnings
        yield Judged(
            "compared meshes", f"{name} and {case}", 1, wrong, wrong and passed, alike and not passed, warnings
        )


def _judged(area: str, case: str, mesh: Any, truth: Any, warnings: tuple[str, ...], is_complete: bool = True) -> Judged:
    right, figure = is_right(mesh, truth, is_complete)
    return Judged(
        area, case, 1, not right, not right and not warnings, right and bool(warnings), "; ".join(warnings), figure
    )

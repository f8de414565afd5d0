"""Reliability of surfaces and meshes, compared with the mesh that the points were drawn from.

A surface is right where 95 % of it lie within 2 % of the shape's size of the truth, as much of the truth within as much
of it, and its borders are no longer than eight times that size where the truth has none. Where points are missing, what
they show is the truth. Shapes are real meshes and made ones; their points get noise, gaps, normals to opposite sides.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from judged import Judged
from real_data import DataMissingError, real_data

NEAR, MOST = 0.02, 0.95  # share of the diagonal; share of the surface
SHAPES = ("nefertiti", "cheburashka", "fandisk", "stanford-bunny")  # of the real data, in files of .obj
NOISES = (0.0, 0.003, 0.03)  # shares of the diagonal
COUNT = 4000  # points of a cloud
SAMPLES = 8000  # on each surface
LONGEST = 8.0  # borders, of the diagonal


def shapes() -> Iterator[tuple[str, Any]]:
    """Meshes of size one, real ones where there are any."""
    import pointloom as loom

    yield "torus", loom.TriangleMesh.create_torus(0.4, 0.12)
    yield "tall box", loom.TriangleMesh.create_box(0.3, 0.3, 0.9)
    for name in SHAPES:
        try:
            mesh = loom.read_triangle_mesh(real_data(f"mesh-common3d/{name}.obj"))
        except DataMissingError:
            continue
        yield name, mesh.scale(1 / float(np.ptp(mesh.vertices, axis=0).max()), (0, 0, 0))


def is_right(mesh: Any, truth: Any, whole: bool = True) -> tuple[bool, str]:
    """Whether a surface is the true one, or a part of it, and the shares of it and of the truth within reach."""
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
    right = min(shares[: 1 + whole]) >= MOST and borders <= LONGEST
    return right, f"{shares[0]:.0%} true, {shares[1]:.0%} there, borders {borders:.1f} times its size"


def _border_of(mesh: Any) -> float:
    """Length of the edges of one triangle [m]."""
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
            found = loom.create_surface(loom.PointCloud(chosen), method)
            whole = "missing" not in case
            yield _judged(f"surface, {method}", f"{name}, {case}", found.mesh, truth, found.warnings, whole)
    turned = normals * rng.choice((-1.0, 1.0), (len(normals), 1))
    for method in ("poisson", "ball"):
        found = loom.create_surface(loom.PointCloud(points, normals=turned), method)
        yield _judged(f"surface, {method}", f"{name}, normals to either side", found.mesh, truth, found.warnings)


def _changed(name: str, truth: Any) -> Iterator[Judged]:
    import pointloom as loom

    full = loom.clean_mesh(truth).mesh
    count = len(full)
    for share in (0.5, 0.1, 0.004):
        few = max(int(share * count), 4)
        simple = loom.simplify_mesh(full, triangles=few)
        yield _judged("simplified mesh", f"{name}, {few:,} of {count:,} triangles", simple.mesh, truth, simple.warnings)
    for method, turns in (("taubin", 10), ("simple", 3), ("simple", 300), ("laplacian", 300)):
        smooth = loom.smooth_mesh(full, method, turns)
        yield _judged("smoothed mesh", f"{name}, {method} {turns} times", smooth.mesh, truth, smooth.warnings)
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


def _judged(area: str, case: str, mesh: Any, truth: Any, warnings: tuple[str, ...], whole: bool = True) -> Judged:
    right, told = is_right(mesh, truth, whole)
    return Judged(
        area, case, 1, not right, not right and not warnings, right and bool(warnings), "; ".join(warnings), told
    )

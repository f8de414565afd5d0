"""Reliability of meshes that were simplified, smoothed, cleaned or compared, with the mesh before as the truth.

A mesh is correct by the rule of surfaces.py. Shapes are those of that file, on which constants were chosen, and shapes
by seed, on which none was.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from typing import Any

import numpy as np
from judged import Case, Judged
from surfaces import Truth, judged, shapes

CHOOSING = range(100, 112)  # seeds of shapes on which constants were chosen
HELD_OUT = (*range(13), *range(200, 340))  # 300 results of each kind, correct and wrong
KINDS = ("torus", "box", "sphere", "cylinder", "cone", "bumps")
SMOOTHED = (
    ("taubin", 10),
    ("taubin", 50),
    ("simple", 1),
    ("simple", 3),
    ("simple", 300),
    ("laplacian", 30),
    ("laplacian", 300),
)


def made_shape(seed: int) -> tuple[str, Any]:
    """A mesh of random proportions and density, by seed, and its name."""
    import pointloom as loom

    rng, kind = np.random.default_rng(seed), KINDS[seed % len(KINDS)]
    a, b = rng.uniform(0.15, 0.5, 2)
    fine = int(rng.integers(16, 40))
    if kind == "torus":
        mesh = loom.TriangleMesh.create_torus(0.5, 0.5 * b, 2 * fine, fine)
    elif kind == "box":
        mesh = loom.TriangleMesh.create_box(1.0, 2 * a, 2 * b).subdivide_midpoint(3)
    elif kind == "cylinder":
        mesh = loom.TriangleMesh.create_cylinder(a, 1.0, fine, fine // 2)
    elif kind == "cone":
        mesh = loom.TriangleMesh.create_cone(a, 1.0, fine, fine // 2)
    else:
        mesh = loom.TriangleMesh.create_sphere(0.5, fine)
    if kind == "bumps":
        vertices, waves = np.asarray(mesh.vertices), rng.normal(0, 6, (4, 3))
        height = 1 + 0.05 * np.sin(vertices @ waves.T + rng.uniform(0, 6, 4)).sum(axis=1)
        mesh = loom.TriangleMesh(vertices * height[:, None], mesh.triangles)
    return f"{kind} {seed}", mesh


def cases() -> Iterator[Case]:
    """All changes of one shape."""
    for name, make in shapes().items():
        yield Case(name, lambda name=name, make=make: _on_known(name, make()))
    for seed in HELD_OUT:
        yield Case(f"shape {seed}", lambda seed=seed: _changed(*made_shape(seed)))


def _on_known(name: str, truth: Any) -> Iterator[Judged]:
    for each in _changed(name, truth):
        yield dataclasses.replace(each, held_out=False)


def _changed(name: str, mesh: Any) -> Iterator[Judged]:
    import pointloom as loom

    full, truth = loom.meshing.clean_mesh(mesh).mesh, Truth(mesh)
    count = len(full)
    for fraction in (0.7, 0.5, 0.3, 0.1, 0.03, 0.01, 0.004):
        few = max(int(fraction * count), 4)
        simple = loom.meshing.simplify_mesh(full, triangles=few)
        yield judged("simplified mesh", f"{name}, {few:,} of {count:,} triangles", simple.mesh, truth, simple.warnings)
    for method, iterations in SMOOTHED:
        smooth = loom.meshing.smooth_mesh(full, method, iterations)
        yield judged("smoothed mesh", f"{name}, {method} {iterations} times", smooth.mesh, truth, smooth.warnings)
    for merge in (1e-6, 1e-4, 0.01, 0.1, 0.3, 0.5):
        clean = loom.meshing.clean_mesh(full, merge_distance=merge)
        yield judged("cleaned mesh", f"{name}, vertices merged within {merge:g}", clean.mesh, truth, clean.warnings)
    half = loom.meshing.simplify_mesh(full, triangles=max(count // 2, 4)).mesh
    for case, other, alike in (
        ("itself", full, True),
        ("itself with half the triangles", half, truth.is_right(half)[0]),
        ("itself in other units", full.scale(1000, (0, 0, 0)), False),
        ("itself elsewhere", full.translate((0.5, 0, 0)), False),
        ("a sphere", loom.TriangleMesh.create_sphere(0.5), name.startswith("sphere")),
    ):
        warnings = "; ".join(loom.meshing.compare_meshes(full, other, samples=5000).warnings)
        wrong, passed = not alike, not warnings
        yield Judged(
            "compared meshes", f"{name} and {case}", 1, wrong, wrong and passed, alike and not passed, warnings
        )

"""Reliability of meshes that were simplified, smoothed, cleaned or compared, with the mesh before as the truth.

A mesh is correct by the rule of surfaces.py.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from judged import Judged
from surfaces import judged, shapes


def judge() -> Iterator[Judged]:
    for name, truth in shapes():
        yield from _changed(name, truth)


def _changed(name: str, truth: Any) -> Iterator[Judged]:
    import pointloom as loom

    full = loom.clean_mesh(truth).mesh
    count = len(full)
    for share in (0.5, 0.1, 0.004):
        few = max(int(share * count), 4)
        simple = loom.simplify_mesh(full, triangles=few)
        yield judged("simplified mesh", f"{name}, {few:,} of {count:,} triangles", simple.mesh, truth, simple.warnings)
    for method, iterations in (("taubin", 10), ("simple", 3), ("simple", 300), ("laplacian", 300)):
        smooth = loom.smooth_mesh(full, method, iterations)
        yield judged("smoothed mesh", f"{name}, {method} {iterations} times", smooth.mesh, truth, smooth.warnings)
    for merge in (1e-6, 0.3):
        clean = loom.clean_mesh(full, merge_distance=merge)
        yield judged("cleaned mesh", f"{name}, vertices merged within {merge:g}", clean.mesh, truth, clean.warnings)
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

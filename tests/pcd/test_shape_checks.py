"""Quality checks of fitted shapes: wrong kinds are unreliable and the warning names a better kind."""

from dataclasses import replace

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.lang import float32
from pointloom.kernels.memory import download, upload
from pointloom.kernels.segmentation.shape_alternatives import Band, count_band
from pointloom.kernels.segmentation.shape_fit import frame_of
from pointloom.kernels.segmentation.shape_models import PLANE
from pointloom.kernels.segmentation.shape_search import DetectedShape
from pointloom.pcd.segmentation import limits_of, search_of

from .made_shapes import made_shape


@pytest.mark.parametrize(
    ("kind", "fitted_kind", "warning"),
    [
        ("cylinder", "sphere", "runs on"),
        ("sphere", "cone", "runs on"),
        ("torus", "cylinder", "other kind: a torus fits better"),
        ("cylinder", "cone", "other kind: a cylinder fits as well"),
    ],
)
def test_shape_fitted_as_another_kind_is_unreliable(device, kind, fitted_kind, warning):
    points, _, _ = made_shape(kind, 3000, np.random.default_rng(100), 0.004, arc=0.25 if fitted_kind == "cone" else 1.0)
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=30)
    shape, _ = getattr(cloud, f"segment_{fitted_kind}")(0.012, 25, 2000)
    assert any(reason.startswith(warning) for reason in shape.warnings), shape


def test_bent_strip_fitted_as_a_plane_warns_of_a_cylinder(device):
    points, _, _ = made_shape("cylinder", 3000, np.random.default_rng(100), 0.004, arc=0.1)
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=30)
    (plane,) = loom.detect_shapes(cloud, 0.012, 25, kinds="plane", min_support=1000).shapes
    assert plane.kind == "plane" and not plane.reliable
    assert any("other kind" in reason and "fits better" in reason for reason in plane.warnings), plane


def test_points_beside_a_plane_are_counted_within_its_box_by_distance_and_by_normal(device, rng):
    heights = np.repeat([0.0, 0.015, 0.029, 0.04], 100)
    points = np.vstack([np.column_stack([rng.random((400, 2)), heights]), [[5.0, 5.0, 0.0]] * 3])
    normals = np.tile([0.0, 0.0, 1.0], (403, 1))
    normals[:400:4] = [1.0, 0.0, 0.0]
    search, _ = search_of(loom.PointCloud(points, normals=normals, device=device), limits_of(0.01, 20.0, 0.0, None))
    plane = np.concatenate([-search.center, [0.0, 0.0, 1.0, 1.0, 1.0]])
    detected = DetectedShape(PLANE, replace(search.fitter.fit(PLANE, plane, search.rows), shape=plane), search.rows)
    frame = frame_of(np.array([0.0, 0.0, 1.0]))
    ends = np.array([[0.0, 0.0, 0.0], [1.0, 1.0, 0.0]]) @ frame.T
    box = upload(np.concatenate([ends.min(axis=0), ends.max(axis=0)]).astype(np.float32), float32, search.device)
    band = Band(*download(count_band(search, detected, box, 0.01, 0.9)).tolist())
    assert band == Band(on=100, beside=200, on_facing=75, beside_facing=150)

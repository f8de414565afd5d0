"""Metrics of `TriangleMesh.compute_metrics` and `PointCloud.compute_metrics`."""

from __future__ import annotations

import enum
from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from ....core.checks import check_count
from ....meshing.mesh.metrics import SurfaceMetrics


class Metric(enum.Enum):
    ChamferDistance, HausdorffDistance, FScore = range(3)


ChamferDistance, HausdorffDistance, FScore = Metric


class VectorMetric(list[Metric]):
    """A list of metrics."""


class MetricParameters:
    """Radii of the F-scores [m] and number of points sampled from each mesh."""

    def __init__(self, fscore_radius: Iterable[float] = (0.01,), n_sampled_points: int = 1000):
        self.fscore_radius = [float(radius) for radius in fscore_radius]
        self.n_sampled_points = check_count("n_sampled_points", n_sampled_points)

    def __repr__(self) -> str:
        return f"MetricParameters: fscore_radius={self.fscore_radius}, n_sampled_points={self.n_sampled_points}"


def listed_metrics(measured: SurfaceMetrics, metrics: Iterable[Metric]) -> NDArray[np.float32]:
    """Results in the order of the metrics. An F-score has one value per radius."""
    values = {
        Metric.ChamferDistance: [measured.chamfer],
        Metric.HausdorffDistance: [measured.hausdorff],
        Metric.FScore: measured.fscore.tolist(),
    }
    return np.array([value for metric in metrics for value in values[Metric(metric)]], np.float32)

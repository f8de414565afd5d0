"""Files of features and pose graphs."""

from __future__ import annotations

import numpy as np

from ...core.atomic import atomic_write
from ...core.errors import FileError, FilePath
from ...core.paths import input_path
from ...registration.pose_graphs import pose_graph_files
from ..pipelines.registration import Feature, PoseGraph
from ..wrapper import unwrap

HEADER_BYTES = 8  # two int32: dimension and number of points


def read_feature(filename: FilePath) -> Feature:
    """Read Open3D's .bin: int32 dimension and point count, then one float64 column per point."""
    try:
        data = input_path(filename).read_bytes()
    except OSError as error:
        raise FileError(filename, f"cannot be read: {error.strerror or error}") from error
    if len(data) < HEADER_BYTES:
        raise FileError(filename, f"expected dimension and point count in {HEADER_BYTES} bytes, got {len(data)} bytes")
    dimension, count = np.frombuffer(data[:HEADER_BYTES], "<i4").tolist()
    if min(dimension, count) < 0 or len(data) != HEADER_BYTES + 8 * dimension * count:
        raise FileError(filename, f"expected {dimension} numbers for each of {count} points, got {len(data)} bytes")
    rows = np.frombuffer(data[HEADER_BYTES:], "<f8").reshape(count, dimension)
    if not (is_finite := np.isfinite(rows)).all():
        row, column = np.argwhere(~is_finite)[0].tolist()
        raise FileError(
            filename, f"expected finite numbers, got {rows[row, column]}", where=f"point {row}, row {column}"
        )
    made = Feature()
    made.data = rows.T
    return made


def write_feature(filename: FilePath, feature: object) -> bool:
    if not isinstance(feature, Feature):
        raise TypeError(f"feature: expected a Feature, got {type(feature).__name__}")
    with atomic_write(filename) as file:
        file.write(np.array(feature.data.shape, "<i4").tobytes() + feature.data.T.astype("<f8").tobytes())
    return True


def read_pose_graph(filename: FilePath) -> PoseGraph:
    return PoseGraph.from_native(pose_graph_files.read_pose_graph(filename))


def write_pose_graph(filename: FilePath, pose_graph: object) -> None:
    pose_graph_files.write_pose_graph(filename, unwrap(pose_graph, PoseGraph, "pose_graph"))

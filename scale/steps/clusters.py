"""Clusters that reach through any number of tiles, by labels on their borders.

Each tile finds the clusters of all that it sees; the numbers of all of them are joined (label_join.py), and what a tile
then lacks is only which cluster each point at a border takes.
"""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_count, check_positive
from ...kernels.lang import int32
from ...kernels.memory import download, full, upload
from ...kernels.segmentation.cluster_labels import NOISE, label_borders, rename_cores
from ...kernels.segmentation.dbscan import cluster_cores
from ...pcd.segmentation import ANY
from ..label_join import MOST_INT32, join_labels, leave
from .step import Part, Sight, Step

NAME = "cluster"  # of the attribute


class Clusters(Step):
    """Labels of clusters as the attribute `cluster`, int32, int64 beyond 2^31 clusters; -1 for noise.

    A tile must know the cores within its reach, and they have theirs beyond: the halo is twice as wide.
    """

    joins, hops = True, 2
    least = 1  # points within reach that make a core
    bounds = (1, 2**63 - 1)
    by_size = False

    def gather(self, part: Part, sight: Sight) -> dict[str, NDArray[Any]]:
        """The tile's clusters: those that are whole, and on the others' edges which points are theirs."""
        if part.keys is None:
            raise ValueError(f"steps: {self.name}: there are too many voxels to number them; take larger ones")
        _, labels, count = self._cores(part)
        return leave(download(labels), count, part, sight, self.bounds, self.by_size)

    def join(self, left: Any, folder: Path) -> int:
        """Number the clusters of the whole."""
        return join_labels(left, folder, self.bounds, self.by_size)

    def run(self, part: Part, plan: Any, numbers: Any) -> Part:
        """The step on a part."""
        total, names = numbers
        kind = np.int32 if total <= MOST_INT32 else np.int64
        names = np.empty(0, kind) if names is None else names
        cores, labels, count = self._cores(part)
        if count != len(names):
            raise ValueError(f"{self.name}: {count} clusters were found where {len(names)} had been")
        told = np.unique(names[names >= 0])
        if count:
            ranks = np.where(names >= 0, np.searchsorted(told, names), NOISE).astype(np.int32)
            rename_cores(cores, upload(ranks, int32, labels.device), labels)
            if self.least > 1 and len(told):
                label_borders(cores, labels)
        found = download(labels)
        cloud = part.cloud.copy()
        values = np.full(len(found), -1, kind)
        values[found >= 0] = told[found[found >= 0]]
        cloud[NAME] = values
        return dataclasses.replace(part, cloud=cloud)

    def _cores(self, part: Part) -> tuple[Any, Any, int]:
        tree = part.cloud.search_tree()
        labels = full(len(part.cloud), NOISE, int32, tree.device)
        cores, count = cluster_cores(tree, self.reach, self.least, labels)
        return cores, labels, count


class ClusterDbscan(Clusters):
    """The labels of `cluster_dbscan`."""

    name, required = "cluster_dbscan", ("eps", "min_points")

    def check(self) -> None:
        """Set the reach by the parameters."""
        self.reach = check_positive("eps", self.params["eps"])
        self.least = check_count("min_points", self.params["min_points"], **ANY)


class ClusterEuclidean(Clusters):
    """The labels of `cluster_euclidean`: connected parts, the largest first."""

    name, required, by_size = "cluster_euclidean", ("tolerance",), True
    defaults: ClassVar[dict[str, Any]] = {"min_cluster_size": 1, "max_cluster_size": None}

    def check(self) -> None:
        """Set the reach and the sizes by the parameters."""
        self.reach = check_positive("tolerance", self.params["tolerance"])
        low = check_count("min_cluster_size", self.params["min_cluster_size"], **ANY)
        most = self.params["max_cluster_size"]
        high = self.bounds[1] if most is None else check_count("max_cluster_size", most, **ANY)
        if high < low:
            raise ValueError(f"max_cluster_size: expected at least min_cluster_size = {low}, got {high}")
        self.bounds = low, high

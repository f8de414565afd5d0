"""What may be the matter where two clouds have hardly a correspondence."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.units import asked_by_user, warn_of_units
from ...kernels.linear_algebra import matmul, norm
from ...pcd.cloud import PointCloud

DOUBTFUL = 0.05  # of fitness: below it is looked at where the clouds are
APART = 5.0  # times as far from each other as the longer one is long: no start for ICP
SURELY_OTHER_UNIT = 500.0  # times as long, where some points do meet: millimetres and metres
OTHER_UNIT = 20.0  # times as long: no two scans of one scene


def doubt(result: Any, source: PointCloud, target: PointCloud, pose: NDArray[np.float64], reach: float) -> None:
    """Say where two clouds with hardly a correspondence are: most often in another unit, or far from each other."""
    hint, ratio, apart = _where(source, target, pose, reach)
    if result.fitness == 0:
        result.hint = hint
        remedy = "; init takes a pose to begin from, register_globally finds one" if apart > APART else ""
        if (remedy or ratio > OTHER_UNIT) and asked_by_user():
            warn_of_units(f"no correspondences: {hint}{remedy}")
    elif ratio > SURELY_OTHER_UNIT and asked_by_user():
        warn_of_units(f"source, target: fitness {result.fitness:.3g}: {hint}")


def _where(source: PointCloud, target: PointCloud, pose: NDArray[np.float64], reach: float) -> tuple[str, float, float]:
    """Where two clouds are, how many times as long one is as the other, and how many lengths apart."""
    said, middles, longest = [], [], []
    for name, cloud, T in (("source", source, pose), ("target", target, np.eye(4))):
        if not len(cloud):
            return f"the {name} has no points", 1.0, 0.0
        box = cloud.get_axis_aligned_bounding_box()
        middles.append(matmul(T[:3, :3], box.get_center()) + T[:3, 3])
        longest.append(box.get_max_extent())
        said.append(f"the {name} spans {' x '.join(f'{length:.3g}' for length in box.get_extent())} m")
    away = float(norm(middles[0] - middles[1]))
    unit = "; in another unit?" if max(longest) > OTHER_UNIT * min(longest) else ""
    hint = f"{', '.join(said)}, their middles {away:.3g} m apart, within {reach:g} m{unit}"
    return hint, max(longest) / min(longest) if min(longest) else 1.0, away / max(longest) if max(longest) else 0.0

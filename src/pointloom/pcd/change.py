"""Change between two epochs of a surface: `loom.change`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.argument_errors import explain_argument_errors
from ..core.array_libraries import Form, view_as
from ..core.checks import check_direction, check_finite, check_numeric, check_positive, check_rows
from ..core.devices import check_same_device
from ..core.exchange import asnumpy, hand_back, on_host
from ..core.matched_counts import why_few_matched
from ..core.reports import AssessedRecord, failed
from ..core.wording import format_fraction
from ..kernels.lang import float32, float64, vec3
from ..kernels.memory import full, upload
from ..kernels.surface.cylinder_change import Cylinder, find_flattest, measure_changes
from .cloud import PointCloud
from .point_arrays import check_cloud
from .units import common_reference

MIN_POINTS = 4  # per cylinder: a spread of fewer is unreliable
MIN_SHIFTED_POINTS = 100  # points with a distance: fewer may all be on what changed
MAX_ONE_WAY = 0.8  # fraction of points moved to one side: a shift of the whole cloud is more likely than change


@dataclass(frozen=True, eq=False)
class M3C2Result(AssessedRecord):
    """M3C2 distances at n core points.

    Attributes:
        distances: From the first to the second epoch along the direction [m], float64 (n,). NaN if undefined.
        level_of_detection: Significant change at 95% confidence [m], float64 (n,). NaN with fewer than two points.
        directions: Unit directions, float32 (n, 3). NaN if undefined.
        scales: Radius of each normal [m], float64 (n,). NaN if undefined or given.
        spreads: Standard deviations along the direction in both epochs [m], float64 (n, 2).
        counts: Points in the cylinders of both epochs, int32 (n, 2).
    """

    distances: NDArray[np.float64]
    level_of_detection: NDArray[np.float64]
    directions: NDArray[np.float32]
    scales: NDArray[np.float64]
    spreads: NDArray[np.float64]
    counts: NDArray[np.int32]

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks. Empty if the result is reliable."""
        distances = asnumpy(self.distances)
        count, measured = len(distances), int(np.isfinite(distances).sum())
        remedy = "use a larger max_distance or larger radii, and align both epochs"
        few = why_few_matched(measured, count, "core points have a distance", remedy)
        return failed(few, why_shifted(distances, asnumpy(self.is_significant)))

    @property
    def is_significant(self) -> NDArray[np.bool_]:
        """True where the distance exceeds the level of detection with at least 4 points per epoch, bool (n,)."""
        distances, limits = asnumpy(self.distances), asnumpy(self.level_of_detection)
        with np.errstate(invalid="ignore"):
            changed = (np.abs(distances) > limits) & (asnumpy(self.counts).min(axis=1) >= MIN_POINTS)
        return hand_back(changed, self.distances)

    def __repr__(self) -> str:
        valid_count, changed = int(np.isfinite(asnumpy(self.distances)).sum()), int(asnumpy(self.is_significant).sum())
        return f"M3C2Result({len(self.distances)} core points, {valid_count} with a distance, {changed} significant)"


def why_shifted(distances: NDArray[np.float64], is_significant: NDArray[np.bool_]) -> str | None:
    """Why two epochs are probably not registered: nearly all points with a distance moved to one side. Else None."""
    if np.isfinite(distances).sum() < MIN_SHIFTED_POINTS:
        return None
    for side, word in ((distances > 0, "forward"), (distances < 0, "backward")):
        moved = is_significant & side
        fraction = float(moved.sum()) / max(int(np.isfinite(distances).sum()), 1)
        if fraction > MAX_ONE_WAY:
            return (
                f"{format_fraction(fraction)} of the points have moved {word}, by {np.median(distances[moved]):.3g} "
                "(median): probably a shift of the whole cloud, not change; register the epochs first, or pass "
                "registration_error"
            )
    return None


@explain_argument_errors
def m3c2(
    first: PointCloud,
    second: PointCloud,
    *,
    normal_radii: ArrayLike | None = None,
    cylinder_radius: float,
    max_distance: float,
    core_points: PointCloud | None = None,
    registration_error: float = 0.0,
    orientation: ArrayLike = (0.0, 0.0, 1.0),
    directions: ArrayLike | None = None,
) -> M3C2Result:
    """Distance between two epochs along the surface normal, with its level of detection (M3C2).

    Normals use the scale where the first epoch is flattest. The mean positions of both epochs in a cylinder along the
    normal are compared; spread, number and registration error give the 95% level of detection. 130 B per core point.
    Bitwise reproducible on one device. Lague, Brodu and Leroux, "Accurate 3D comparison of complex topography with
    terrestrial laser scanner", ISPRS 2013, without medians. Assumes normal, independent errors.

    Args:
        first, second: The earlier and the later epoch, on the same device.
        normal_radii: Exclusive radii for normals [m], one or several: 20 to 25 times the roughness.
        cylinder_radius: Inclusive radius of the cylinders [m], for about 20 points.
        max_distance: Half length of the cylinders [m], more than the largest change.
        core_points: Points to measure at, on the same device. If None: the first epoch. Thin with `voxel_down_sample`.
        registration_error: Standard deviation of the registration [m].
        orientation: Direction of the normals' side, shape (3,). Distances are positive there.
        directions: Unit directions instead of normals, shape (n, 3) or (3,).

    Raises:
        TypeError: If an epoch is not a cloud, or an argument is not numeric.
        ValueError: If a length is not positive, neither radii nor directions are given, or a shape is wrong.
        DeviceError: If the clouds are on different devices.

    Warns:
        UnitWarning: If the clouds have different units.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> rng = np.random.default_rng(0)
        >>> before, after = (rng.random((20_000, 3)) * (10, 10, 0.02) for _ in range(2))
        >>> after[after[:, 0] > 5, 2] += 0.1
        >>> found = loom.m3c2(
        ...     loom.PointCloud(before), loom.PointCloud(after), core_points=loom.PointCloud([[2, 5, 0], [8, 5, 0]]),
        ...     normal_radii=0.5, cylinder_radius=0.5, max_distance=1,
        ... )
        >>> found.distances.round(2).tolist(), found.is_significant.tolist()
        ([0.0, 0.1], [False, True])
    """
    check_cloud("first", first)
    check_cloud("second", second)
    cores = first if core_points is None else core_points
    check_cloud("core_points", cores)
    check_same_device("second", first.device, second.device)
    check_same_device("core_points", first.device, cores.device)
    common_reference("first, second, core_points", (first, second, cores))
    radius, half_length = (
        check_positive("cylinder_radius", cylinder_radius),
        check_positive("max_distance", max_distance),
    )
    error = check_positive("registration_error", registration_error, allow_zero=True)
    upwards = check_direction("orientation", orientation)
    radii = check_radii(normal_radii, directions)
    core_positions, tree = cores.arrays.about(first.origin), first.search_tree()
    if directions is not None:
        given = upload(_check_directions(directions, len(cores)), vec3, first.device)
        scales = full(len(cores), np.nan, float64, first.device)
    else:
        given, scales = find_flattest(tree, core_positions, radii, upwards)
    changes = measure_changes(
        tree, _tree_about(second, first), core_positions, given, Cylinder(radius, half_length), error
    )
    results = {
        "distances": changes.distances,
        "level_of_detection": changes.limits,
        "directions": view_as(given, float32, (len(cores), 3)),
        "scales": scales,
        "spreads": changes.spreads,
        "counts": changes.counts,
    }
    return M3C2Result(**Form(cores.array_library, False).hand_out_all(results, {}))


def _tree_about(cloud: PointCloud, other: PointCloud) -> Any:
    if (cloud.origin == other.origin).all():
        return cloud.search_tree()
    return PointCloud(cloud.points, origin=other.origin, device=cloud.device).search_tree()


def check_radii(radii: object, directions: object) -> NDArray[np.float64]:
    """Ascending normal radii, empty if directions are given. ValueError if neither is valid."""
    if directions is not None:
        return np.empty(0)
    if radii is None:
        raise ValueError("normal_radii: expected the radii for normal estimation, got None. Pass them or normals")
    values = np.atleast_1d(check_finite("normal_radii", check_numeric("normal_radii", radii))).astype(np.float64)
    if values.ndim != 1 or not len(values) or (values <= 0).any():
        raise ValueError(f"normal_radii: expected one or more lengths > 0, got {radii!r}")
    return np.sort(values)


def _check_directions(directions: object, count: int) -> NDArray[np.float32]:
    values = check_numeric("directions", on_host("directions", directions))
    if values.ndim == 1:
        return np.tile(check_direction("directions", values), (count, 1)).astype(np.float32)
    rows = check_rows("directions", values, 3, rows=count).astype(np.float64)
    with np.errstate(invalid="ignore", divide="ignore"):
        rows /= np.abs(rows).max(axis=1, keepdims=True, initial=0)  # their squares do not overflow
        return (rows / np.linalg.norm(rows, axis=1, keepdims=True)).astype(np.float32)

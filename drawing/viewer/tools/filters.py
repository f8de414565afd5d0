"""Which points are seen by what is known of them: ranges of values, classes, times, and those without a value."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....core.checks import check_name, check_number
from ....kernels.memory import download
from ....pcd.cloud import PointCloud
from ...render.coloring import name_labels

BINS = 64
MOST_CLASSES = 64  # whole numbers with more different values are shown as a range
CLASSES, VALUES, TIMES = "classes", "values", "times"
_AXES = {"x": 0, "y": 1, "height": 2}
_TIMES = ("time", "times", "timestamp", "timestamps", "gps_time", "gpstime", "t")
_BLOCK = 4_000_000  # values looked at together
_SAMPLE = 1_000_000  # values that the ends of a histogram come from
_TAIL, _FAR = 0.001, 1.5  # of the values at either end, which lie beyond where the range is so many times the others'


@dataclasses.dataclass(frozen=True)
class Filter:
    """A rule for one thing that is known of points; clouds that do not have it are left as they are.

    Args:
        by: "x", "y", "height" (in the world), or the name of an attribute with one number a point.
        low, high: What lies between them is seen, both ends too.
        classes: Which whole numbers are seen; None leaves it to the range.
        missing: Whether points whose value is not finite are seen.

    Raises:
        ValueError: NaN, or low above high.

    Example:
        >>> rule = Filter("intensity", low=0.25, missing=False)
        >>> rule.keep([0.1, 0.25, float("nan"), 9.0]).tolist()
        [False, True, False, True]
        >>> Filter("classification", classes=frozenset({2, 6})).keep([2, 5, 6]).tolist()
        [True, False, True]
    """

    by: str
    low: float = -math.inf
    high: float = math.inf
    classes: frozenset[int] | None = None
    missing: bool = True

    def __post_init__(self) -> None:
        check_name("by", self.by)
        low, high = (check_number(name, getattr(self, name), allow_infinite=True) for name in ("low", "high"))
        if low > high:
            raise ValueError(f"low, high: expected low <= high, got {low:g} and {high:g}")

    @property
    def cuts(self) -> bool:
        """Whether it may hide anything."""
        return self.classes is not None or not self.missing or self.low > -math.inf or self.high < math.inf

    def keep(self, values: Any) -> NDArray[np.bool_]:
        """Which values are seen, bool [n]."""
        given = np.asarray(values)
        if given.dtype.kind in "biu":
            if self.classes is not None:
                return np.isin(given, np.fromiter(self.classes, np.int64, len(self.classes)))
            return (given >= self.low) & (given <= self.high)
        is_there = np.isfinite(given)
        with np.errstate(invalid="ignore"):
            kept = (given >= self.low) & (given <= self.high)
            if self.classes is not None:
                kept &= np.isin(given, np.fromiter(self.classes, np.float64, len(self.classes)))
        return np.where(is_there, kept, self.missing)

    def keep_of(self, cloud: PointCloud, places: NDArray[np.float64], indices: Any) -> NDArray[np.bool_] | None:
        """Which of some points of a cloud are seen; None where it does not have such a thing.

        Args:
            cloud: The cloud.
            places: Where they are in the world, shape [k, 3].
            indices: Their numbers in the cloud, shape [k], or a slice; None for all of them in their order.
        """
        if not self.cuts:
            return None
        if self.by in _AXES and self.by not in cloud.attributes:
            return self.keep(places[:, _AXES[self.by]])
        values = column_of(cloud, self.by)
        return None if values is None else self.keep(values if indices is None else values[indices])

    def in_words(self) -> str:
        """What is seen, such as "0.2 to 5, or no value"."""
        if self.classes is not None:
            named = name_labels(sorted(self.classes), self.by).values()
            told = ", ".join(named) or "nothing"
        elif self.low > -math.inf and self.high < math.inf:
            told = f"{self.low:.6g} to {self.high:.6g}"
        elif self.low > -math.inf:
            told = f"from {self.low:.6g} on"
        else:
            told = f"up to {self.high:.6g}" if self.high < math.inf else "any value"
        return told if self.missing else f"{told}; not those without a value"


def column_of(cloud: PointCloud, by: str) -> NDArray[Any] | None:
    """The values of an attribute with one number a point, [n]; None where a cloud has no such thing."""
    if by not in cloud.attributes:
        return None
    values = download(cloud.device_array(by))
    return values if values.ndim == 1 else None


def filters_of(cloud: PointCloud) -> list[str]:
    """What the points of a cloud can be filtered by."""
    return [*(name for name in cloud.attributes if len(cloud.device_array(name).shape) == 1), *reversed(_AXES)]


@dataclasses.dataclass(frozen=True, eq=False)
class Census:
    """How often values occur, over all points.

    Attributes:
        by: Of what.
        kind: "classes", "values" or "times".
        counts: Of 64 parts between the ends, int64; the first and the last count what lies beyond as well.
        low, high: The ends: all values, or without few that lie far from the rest.
        classes: Of classes, how many points have each whole number, ascending.
        missing: Points whose value is not finite.
        total: All points.
    """

    by: str
    kind: str
    counts: NDArray[np.int64]
    low: float
    high: float
    classes: dict[int, int]
    missing: int
    total: int

    def names(self) -> dict[int, str]:
        """The names of the classes: the standard's for those of LAS."""
        return name_labels(list(self.classes), self.by)


def take_census(by: str, columns: list[NDArray[Any]]) -> Census:
    """Count the values of one thing in some clouds, in blocks.

    Args:
        by: What it is.
        columns: The values of each cloud, shape [n].

    Notes:
        Two passes over whole numbers, three over others; 32 MB at a time.

    Example:
        >>> import numpy as np
        >>> found = take_census("intensity", [np.array([0.0, 1.0, np.nan, 4.0])])
        >>> found.low, found.high, found.missing, found.counts.sum()
        (0.0, 4.0, 1, 3)
    """
    total = sum(len(column) for column in columns)
    classes = _count_classes(columns)
    low, high = _ends(columns)
    counts, seen = np.zeros(BINS, np.int64), 0
    scale = BINS / (high - low)
    for block in _blocks(columns):
        finite = block[np.isfinite(block)]
        seen += len(finite)
        at = np.clip((finite.astype(np.float64) - low) * scale, 0, BINS - 1).astype(np.int64)
        counts += np.bincount(at, minlength=BINS)
    kind = CLASSES if classes is not None else TIMES if by.lower() in _TIMES else VALUES
    return Census(by, kind, counts, low, high, classes or {}, total - seen, total)


def column_in_world(cloud: PointCloud, by: str, pose: Any = None) -> NDArray[Any] | None:
    """The values of a cloud by which a filter would look at it: coordinates are those of the world."""
    if by not in _AXES or by in cloud.attributes:
        return column_of(cloud, by)
    rows, axis = download(cloud.device_array("points")).reshape(-1, 3), _AXES[by]
    T = np.eye(4) if pose is None else np.asarray(pose, np.float64)
    start = float(T[axis, :3] @ cloud.origin + T[axis, 3])
    values = np.empty(len(rows))
    for first in range(0, len(rows), _BLOCK):
        values[first : first + _BLOCK] = rows[first : first + _BLOCK].astype(np.float64) @ T[axis, :3] + start
    return values


def _blocks(columns: list[NDArray[Any]]) -> Any:
    return (column[at : at + _BLOCK] for column in columns for at in range(0, len(column), _BLOCK))


def _count_classes(columns: list[NDArray[Any]]) -> dict[int, int] | None:
    """How many points have each whole number; None where they are no whole numbers or too many different ones."""
    if not columns or any(column.dtype.kind not in "biu" for column in columns):
        return None
    found: dict[int, int] = {}
    for block in _blocks(columns):
        labels, counts = np.unique(block, return_counts=True)
        if len(labels) > MOST_CLASSES:
            return None
        for label, count in zip(labels.tolist(), counts.tolist(), strict=True):
            found[int(label)] = found.get(int(label), 0) + count
        if len(found) > MOST_CLASSES:
            return None
    return dict(sorted(found.items()))


def _ends(columns: list[NDArray[Any]]) -> tuple[float, float]:
    """Ends of a histogram, never equal."""
    total = sum(map(len, columns))
    step = max(1, total // _SAMPLE)
    some = np.concatenate([np.asarray(column[::step], np.float64) for column in columns]) if columns else np.zeros(0)
    some = some[np.isfinite(some)]
    ends = [(float(b.min()), float(b.max())) for block in _blocks(columns) if len(b := block[np.isfinite(block)])]
    if not ends or not len(some):
        return 0.0, 1.0
    low, high = min(a for a, _ in ends), max(b for _, b in ends)
    first, last = np.quantile(some, (_TAIL, 1 - _TAIL)).tolist()
    if high - low > _FAR * (last - first) > 0:
        low, high = first, last
    if not high - low > 1e-12 * max(abs(low), abs(high)):
        pad = 0.5 * max(abs(low), 1.0) * (1e-3 if low else 1.0)
        return low - pad, high + pad
    return low, high

"""Ground control input: known points, their image observations, and known lengths."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_finite, check_list, check_name, check_numeric, check_positive, shown
from ...core.escaped_text import escaped
from ...core.records import digest_of
from ...registration.stations.observations import ControlPoint, check_sigma
from .control_systems import to_geodetic

Array = NDArray[np.float64]

BAR_SIGMA = 0.002  # [m] default
MIN_POINTS = 3  # minimum points
MIN_LATERAL_EXTENT = 0.02  # ratio of lateral extent below which points are collinear


@dataclass(frozen=True, eq=False)
class ControlMark:
    """Image observation of a point.

    Args:
        point: Point name.
        image: Image file name or number.
        pixel: Column and row, shape [2] [px], with integer pixel centers.
        where: Its origin, for errors.

    Raises:
        TypeError, ValueError: Names that are not strings, or pixels that are not finite or not [2].

    Example:
        >>> import pointloom as loom
        >>> from pointloom.photogrammetry.video.ground_control import ControlMark
        >>> ControlMark("A", "IMG_0012.jpg", (320.25, 240.5)).pixel.tolist()
        [320.25, 240.5]
    """

    point: str
    image: str
    pixel: Array
    where: str = ""

    def __post_init__(self):
        for name in ("point", "image"):
            if not check_name(name, getattr(self, name)):
                raise ValueError(f"{name}: expected a name, got an empty one")
        check_name("where", self.where)
        pixel = check_finite("pixel", check_numeric("pixel", self.pixel)).astype(np.float64)
        if pixel.shape != (2,) or not (np.abs(pixel) < 1e6).all():
            raise ValueError(f"pixel: expected column and row [px], got {shown(self.pixel)}")
        object.__setattr__(self, "pixel", pixel)


@dataclass(frozen=True)
class ScaleBar:
    """A known length between two points.

    Args:
        a, b: Point names.
        meters: The length [m].
        sigma: Its standard deviation [m].

    Raises:
        TypeError, ValueError: Names that are not strings, a length that is not positive, or identical ends.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.photogrammetry.video.ground_control import ScaleBar
        >>> ScaleBar("A", "B", 1.5).sigma
        0.002
    """

    a: str
    b: str
    meters: float
    sigma: float = BAR_SIGMA

    def __post_init__(self):
        if not check_name("a", self.a) or not check_name("b", self.b) or self.a == self.b:
            raise ValueError(f"b: expected the names of two points, got {shown(self.a)} and {shown(self.b)}")
        object.__setattr__(self, "meters", check_positive("meters", self.meters, maximum=1e6))
        object.__setattr__(self, "sigma", check_sigma("sigma", self.sigma))

    def __str__(self) -> str:
        return escaped(f"{self.a} to {self.b}")


@dataclass(frozen=True, eq=False)
class GroundControl:
    """Known points, their image observations, and known lengths.

    Args:
        points: `registration.ControlPoint`s with easting, northing and height, or longitude, latitude [degrees] and
            height if `crs` is in degrees. Empty with scale bars only.
        marks: Image observations of these points, and of the ends of scale bars.
        bars: Known lengths.
        crs: Coordinate system, such as "EPSG:32632"; "" for a local frame in meters, z up.
        checks: Names of check points, which are not used in the fit.
        path: The source file, for errors.

    Raises:
        TypeError: Wrong types in the lists.
        ValueError: A duplicate name or mark, a bar to an unmarked point, a missing check point, or an invalid system.
        FileError: pyproj is required and missing.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.photogrammetry.video.ground_control import ControlMark
        >>> from pointloom.photogrammetry.video.ground_control import GroundControl
        >>> a = loom.registration.ControlPoint("A", [447000.0, 5260000.0, 410.0], sigma=0.01)
        >>> marks = [ControlMark("A", name, (320.0, 240.0)) for name in ("a.jpg", "b.jpg")]
        >>> GroundControl([a], marks, crs="EPSG:32632")
        GroundControl(1 point, 2 marks, EPSG:32632)
    """

    points: tuple[ControlPoint, ...]
    marks: tuple[ControlMark, ...]
    bars: tuple[ScaleBar, ...] = ()
    crs: str = ""
    checks: tuple[str, ...] = ()
    path: str = field(default="control", compare=False)

    def __post_init__(self):
        check_name("crs", self.crs)
        check_name("path", self.path)
        for name, of in (("points", ControlPoint), ("marks", ControlMark), ("bars", ScaleBar), ("checks", str)):
            values = tuple(check_list(name, getattr(self, name), f"{of.__name__}s"))
            for value in values:
                if not isinstance(value, of):
                    raise TypeError(f"{name}: expected {of.__name__}s, got {shown(value)}")
            object.__setattr__(self, name, values)
        names = [point.name for point in self.points]
        _check_once("points", names)
        _check_once("marks", [f"{mark.point} in {mark.image}" for mark in self.marks])
        _check_once("bars", ["{} to {}".format(*sorted((bar.a, bar.b))) for bar in self.bars])
        if missing := [name for name in self.checks if name not in names]:
            raise ValueError(f"checks: expected names of points, got {missing[0]!r}")
        shown_names = {mark.point for mark in self.marks}
        for bar in self.bars:
            if missing := [end for end in (bar.a, bar.b) if end not in shown_names]:
                raise ValueError(f"bars: {bar}: no image has a mark of {missing[0]!r}; mark it in two or more")
        if self.crs and self.points:
            to_geodetic(self.positions, self.crs, self.path)

    def __repr__(self) -> str:
        counts = [(len(self.points), "point"), (len(self.marks), "mark"), (len(self.bars), "scale bar")]
        parts = [f"{count} {what}{'s' * (count != 1)}" for count, what in counts if count or what != "scale bar"]
        return escaped(f"GroundControl({', '.join(parts)}, {self.crs or 'local'})")

    @property
    def positions(self) -> Array:
        """Coordinates of the points as given, [n, 3]."""
        return np.array([point.position for point in self.points], np.float64).reshape(-1, 3)

    @property
    def fitted(self) -> tuple[ControlPoint, ...]:
        """The points that are not check points."""
        return tuple(point for point in self.points if point.name not in self.checks)

    def digest(self) -> str:
        """Digest of everything that affects the result."""
        content: list[Any] = [self.crs, sorted(self.checks)]
        content += [[p.name, np.asarray(p.position).tolist(), np.asarray(p.sigma).tolist()] for p in self.points]
        content += [[m.point, m.image, m.pixel.tolist()] for m in self.marks]
        content += [[bar.a, bar.b, bar.meters, bar.sigma] for bar in self.bars]
        return digest_of(content)

    def why_open(self) -> str:
        """Why the points do not determine a similarity; "" if they do."""
        fitted = self.fitted
        if len(fitted) < MIN_POINTS:
            checks = f" and {len(self.checks)} check points" if self.checks else ""
            return (
                f"{len(fitted)} control points{checks}: {MIN_POINTS} or more that are not collinear determine "
                "scale, rotation "
                "and position; add some, or scale bars for the scale only"
            )
        if is_straight(np.array([point.position for point in fitted])):
            names = ", ".join(point.name for point in fitted[:5])
            return f"the control points {names} are collinear, so a rotation is undetermined; add one off the line"
        return ""


def is_straight(points: Array) -> bool:
    """True if points are identical or nearly collinear, which leaves a rotation undetermined."""
    if len(points) < MIN_POINTS:
        return True
    spread = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    return not (math.isfinite(float(spread[0])) and spread[1] > MIN_LATERAL_EXTENT * spread[0])


def _check_once(name: str, values: list[str]) -> None:
    seen: set[str] = set()
    for value in values:
        if value in seen:
            raise ValueError(f"{name}: {value!r} is duplicated")
        seen.add(value)

"""Conversion of detected shapes to world coordinates, with quality checks."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ..kernels.array_types import AnyArray
from ..kernels.arrays.side_by_side import read_together
from ..kernels.segmentation.shape_alternatives import Band, Rival, RivalStarts, count_band
from ..kernels.segmentation.shape_fit import FlatFit, ShapeFit, flat_fit
from ..kernels.segmentation.shape_models import CONE, CYLINDER, PLANE, SPHERE, TORUS
from ..kernels.segmentation.shape_search import (
    BAND_COUNT,
    SECTOR_COUNT,
    DetectedShape,
    ShapeLimits,
    ShapeSearch,
    spread_of,
)
from .shape import KINDS, Shape

POSITION_ROUNDING = 2e-6  # of the cloud's size: float32 rounding of positions
AS_FLAT = 1.15  # maximum rms ratio of a plane that explains the points as well
MAX_RELATIVE_DEVIATION = 0.1  # of a radius: a larger standard deviation leaves it undetermined
MIN_ANGLE_DEVIATIONS = 3.0  # standard deviations between a cone's half angle and a cylinder
MIN_SURFACE_RATIO = 1.0  # points on a surface per point beside it, up to three times as far: 0.5 by chance
RUNS_ON = 0.15  # fraction of nearby points with equal normal: contact strips 0.2 to 0.7, half-distance noise 0.05
NORMAL_LIMIT_FACTOR = 1.6  # times the normal limit: surfaces that branch off turn away
BETTER_DEVIATION_RATIO = 0.85  # deviation ratio of a better kind. By chance 0.95 and more
AS_WELL = 1.1  # deviation ratio up to which a simpler kind is preferred
RULED_OUT = {  # kinds simpler than another, or as simple and not a special case
    SPHERE: (PLANE,),
    CYLINDER: (PLANE, SPHERE),
    CONE: (PLANE, SPHERE, CYLINDER),
    TORUS: (PLANE, SPHERE, CYLINDER, CONE),
    PLANE: (),
}
MIN_COVERAGE = 0.15  # of a round surface: slightly bent surfaces share a smaller part

# A half rotation about u changes the unknowns: shifts along v and the axis change sign, and so does the tilt
# toward u, while that toward v keeps its sign, since v is rotated too.
SIGN_FLIPS = {PLANE: [-1, -1, 1], CYLINDER: [1, -1, -1, 1, 1], TORUS: [1, -1, -1, -1, 1, 1, 1]}


def shape_of(
    search: ShapeSearch,
    candidate: DetectedShape,
    limits: ShapeLimits,
    origin: NDArray[np.float64],
    every: ShapeSearch | None = None,
) -> Shape:
    """Shape found among other points, with failed checks; `every` searches all points. Three syncs."""
    every = every or search
    extremes, box, cells = search.spread_unread(candidate)
    wider = np.cos(min(NORMAL_LIMIT_FACTOR * np.arccos(min(limits.cosine, 1.0)), np.pi / 2))
    band = count_band(every, candidate, box, limits.distance, max(float(wider), 0.0))
    return _checked_shape(search, candidate, limits, origin, every, (extremes, cells, band))


def fitted_shape(
    search: ShapeSearch, candidate: DetectedShape, limits: ShapeLimits, origin: NDArray[np.float64]
) -> Shape:
    """Shape fitted to all points, with failed checks. Three syncs."""
    extremes, _, cells = search.spread_unread(candidate)
    return _checked_shape(search, candidate, limits, origin, search, (extremes, cells))


def _checked_shape(
    search: ShapeSearch,
    candidate: DetectedShape,
    limits: ShapeLimits,
    origin: NDArray[np.float64],
    every: ShapeSearch,
    statistics: Sequence[AnyArray],
) -> Shape:
    """Shape with the checks of its points, nearby points and other kinds; `statistics` are on the device."""
    starts = RivalStarts(search, candidate, limits)
    given = [*statistics, search.fitter.add_moments(candidate.rows)]
    values = read_together([*given, *starts.unread])  # sync
    values, drawn = values[: len(given)], values[len(given) :]
    shape = _shape_in_world(search, candidate, origin, *spread_of(candidate.kind, values[0], values[1]))
    if candidate.fit.reason:
        return replace(shape, warnings=(_undetermined(shape, candidate.fit),))
    messages = _fit_warnings(search, candidate, shape, flat_fit(values[-1], candidate.rows.size))
    if len(statistics) > 2:
        messages += _strip_warnings(Band(*(int(count) for count in values[2])))
    return replace(shape, warnings=(*messages, *_rival_warnings(candidate, starts.find(drawn, every))))


def _undetermined(shape: Shape, fit: ShapeFit) -> str:
    return f"{fit.reason}: the {shape.kind} is not unique"


def _shape_in_world(
    search: ShapeSearch,
    candidate: DetectedShape,
    origin: NDArray[np.float64],
    bounds: NDArray[np.float64],
    coverage: float,
) -> Shape:
    """Shape in world coordinates without checks. Bounds of its points are in its own frame."""
    kind, fit = candidate.kind, candidate.fit
    position, frame, axis, covariance = fit.shape[:3], fit.frame, fit.shape[3:6], fit.covariance
    if kind == SPHERE:
        axis = np.array([0.0, 0.0, 1.0])
    elif kind != CONE and axis[np.argmax(np.abs(axis))] < 0:
        axis, frame = -axis, frame * [[1], [-1], [-1]]
        covariance = covariance * np.outer(SIGN_FLIPS[kind], SIGN_FLIPS[kind])
        bounds = np.array([[bounds[0, 0], -bounds[1, 1], -bounds[1, 2]], [bounds[1, 0], -bounds[0, 1], -bounds[0, 2]]])
    if kind == SPHERE:
        bounds = np.array([[-1.0] * 3, [1.0] * 3]) * fit.shape[6]
    nan = float("nan")
    radius = float(fit.shape[6]) if kind in (SPHERE, CYLINDER, TORUS) else nan
    return Shape(
        kind=KINDS[kind],
        center=position + search.center + origin,
        axis=axis + 0.0,
        radius=radius,
        minor_radius=float(fit.shape[7]) if kind == TORUS else nan,
        half_angle=math.atan2(fit.shape[7], fit.shape[6]) if kind == CONE else nan,
        extent=bounds,
        support=int(candidate.rows.size),
        rms=fit.rms,
        coverage=coverage,
        covariance=covariance,
        frame=frame,
        warnings=(),
    )


def _fit_warnings(search: ShapeSearch, candidate: DetectedShape, shape: Shape, plane: FlatFit) -> list[str]:
    messages, kind, sigma = [], candidate.kind, shape.sigma
    if kind != PLANE and is_flat(search, candidate, plane):
        messages.append(f"flat: a plane fits the points as well (rms {plane.rms:.3g} m)")
    for name in ("radius", "minor_radius"):
        if name in sigma and sigma[name] > MAX_RELATIVE_DEVIATION * getattr(shape, name):
            part = f"points cover {100 * shape.coverage:.0f} % of it"
            messages.append(f"{name} open: {getattr(shape, name):.4g} ± {sigma[name]:.2g} m, as the {part}")
    if kind == CONE and is_open(candidate, shape.extent[1, 2] - shape.extent[0, 2]):
        messages.append(
            f"half_angle open: {shape.half_angle:.3g} ± {sigma['half_angle']:.2g} rad; a cylinder fits as well"
        )
    if is_small_part(kind, shape):
        sizes = [name for name in ("radius", "minor_radius", "half_angle") if name in sigma]
        known = ", ".join(f"{name} {getattr(shape, name):.4g} ± {sigma[name]:.2g}" for name in sizes)
        messages.append(
            f"small part: points cover {100 * shape.coverage:.0f} % of it ({known} if it is a {shape.kind})"
        )
    return messages


def _strip_warnings(band: Band) -> list[str]:
    if band.on < MIN_SURFACE_RATIO * band.beside:
        return [f"chance: {band.on:,} points are on the surface, and {band.beside:,} beside it"]
    if band.beside_facing > RUNS_ON * band.on_facing:
        counts = f"{band.beside_facing:,} points beside the surface have its normals, {band.on_facing:,} are on it"
        return [f"runs on: {counts}: it may touch another along a strip, or distance_threshold is below the noise"]
    return []


def _rival_warnings(candidate: DetectedShape, rivals: Sequence[Rival]) -> list[str]:
    """Check for a kind that fits better, or as well and is simpler."""
    better = min(rivals, key=lambda rival: rival.ratio, default=None)
    if better is not None and better.ratio < BETTER_DEVIATION_RATIO:
        fits = f"fits better (rms {better.fit.rms:.3g} m), with {better.support:,} points in all"
        return [f"other kind: a {KINDS[better.kind]} {fits}"]
    for rival in rivals:
        if rival.kind in RULED_OUT[candidate.kind] and rival.ratio < AS_WELL:
            return [f"other kind: a {KINDS[rival.kind]} fits as well (rms {rival.fit.rms:.3g} m) and is simpler"]
    return []


def is_small_part(kind: int, shape: Shape) -> bool:
    """True if points cover too little of a round surface to determine its kind."""
    if kind == PLANE:
        return False
    cells = SECTOR_COUNT if kind in (CYLINDER, CONE) else SECTOR_COUNT * BAND_COUNT
    return bool(shape.coverage < MIN_COVERAGE * -np.expm1(-shape.support / cells))


def is_flat(search: ShapeSearch, candidate: DetectedShape, plane: FlatFit) -> bool:
    return plane.rms <= AS_FLAT * candidate.fit.rms + POSITION_ROUNDING * search.size


def is_open(candidate: DetectedShape, length: float) -> bool:
    """True if a cone may be a cylinder: half angle within its error, or taper below the noise."""
    angle = math.atan2(candidate.fit.shape[7], candidate.fit.shape[6])
    return bool(
        MIN_ANGLE_DEVIATIONS * np.sqrt(candidate.fit.covariance[-1, -1]) > angle
        or math.tan(angle) * length < candidate.fit.rms
    )


def plane_of(search: ShapeSearch, candidate: DetectedShape) -> FlatFit:
    return search.fitter.fit_plane(candidate.rows)

"""What is found on the device as a Shape in world coordinates, and what speaks against it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ..kernels.array_types import AnyArray
from ..kernels.arrays.side_by_side import read_together
from ..kernels.segmentation.shape_fit import FlatFit, ShapeFit, flat_fit
from ..kernels.segmentation.shape_models import CONE, CYLINDER, PLANE, SPHERE, TORUS
from ..kernels.segmentation.shape_rivals import Band, Rival, RivalStarts, count_band
from ..kernels.segmentation.shape_search import BANDS, SECTORS, Found, ShapeLimits, ShapeSearch, spread_of
from .shape import KINDS, Shape

ROUNDING = 2e-6  # of the size of the cloud: what float32 positions leave of exact ones
AS_FLAT = 1.15  # a plane whose rms is as many times the shape's explains the points as well
UNKNOWN = 0.1  # of a radius: a larger standard deviation leaves it open
CERTAIN = 3.0  # standard deviations that a cone's half angle is from that of a cylinder
BESIDE = 1.0  # points on a surface for each that lies beside it, up to three times as far: chance gives a half
RUNS_ON = 0.15  # of them that lie beside it and face alike: a strip of contact has 0.2 to 0.7, noise of half of d 0.05
WIDER = 1.6  # times the limit of normals: what parts from a surface turns away from it
BETTER = 0.85  # of the deviations: a rival kind whose own are so much smaller is meant; chance left 0.95 and more
AS_WELL = 1.1  # a simpler kind whose deviations are no larger explains the points
RULED_OUT = {  # kinds that are simpler than another, or as simple and no case of it
    SPHERE: (PLANE,),
    CYLINDER: (PLANE, SPHERE),
    CONE: (PLANE, SPHERE, CYLINDER),
    TORUS: (PLANE, SPHERE, CYLINDER, CONE),
    PLANE: (),
}
COVERED = 0.15  # of a round surface: any that is a little bent has a smaller part in common with some

# What a turn by half about u makes of the unknowns: shifts along v and the axis change sign, and so does the tilt
# towards u, while that towards v keeps its own, since v has turned too.
TURNED = {PLANE: [-1, -1, 1], CYLINDER: [1, -1, -1, 1, 1], TORUS: [1, -1, -1, -1, 1, 1, 1]}


def shape_of(
    search: ShapeSearch,
    found: Found,
    limits: ShapeLimits,
    origin: NDArray[np.float64],
    every: ShapeSearch | None = None,
) -> Shape:
    """A shape found among other points, with what speaks against it; `every` searches all points of the cloud.

    Three syncs.
    """
    every = every or search
    extremes, box, cells = search.spread_unread(found)
    wider = np.cos(min(WIDER * np.arccos(min(limits.cosine, 1.0)), np.pi / 2))
    band = count_band(every, found, box, limits.distance, max(float(wider), 0.0))
    return _looked_over(search, found, limits, origin, every, (extremes, cells, band))


def fitted_shape(search: ShapeSearch, found: Found, limits: ShapeLimits, origin: NDArray[np.float64]) -> Shape:
    """A shape that was fitted to all points, with what speaks against it; three syncs."""
    extremes, _, cells = search.spread_unread(found)
    return _looked_over(search, found, limits, origin, search, (extremes, cells))


def _looked_over(
    search: ShapeSearch,
    found: Found,
    limits: ShapeLimits,
    origin: NDArray[np.float64],
    every: ShapeSearch,
    asked: Sequence[AnyArray],
) -> Shape:
    """A shape with what its points, those beside it and other kinds say.

    `asked` are the extremes and cells of its points, and, where they were counted, the points beside it.
    """
    starts = RivalStarts(search, found, limits)
    given = [*asked, search.fitter.add_places(found.rows)]
    told = read_together([*given, *starts.unread])  # sync
    told, drawn = told[: len(given)], told[len(given) :]
    shape = _shape_in_world(search, found, origin, *spread_of(found.kind, told[0], told[1]))
    if found.fit.reason:
        return replace(shape, reasons=(_undetermined(shape, found.fit),))
    said = _from_fit(search, found, shape, flat_fit(told[-1], found.rows.size))
    if len(asked) > 2:
        said += _beside(Band(*(int(count) for count in told[2])))
    return replace(shape, reasons=(*said, *_against(found, starts.find(drawn, every))))


def _undetermined(shape: Shape, fit: ShapeFit) -> str:
    return f"{fit.reason}: the {shape.kind} is one of many that fit"


def _shape_in_world(
    search: ShapeSearch, found: Found, origin: NDArray[np.float64], bounds: NDArray[np.float64], coverage: float
) -> Shape:
    """A found shape in world coordinates without reasons; bounds are of its points in its own frame."""
    kind, fit = found.kind, found.fit
    place, frame, axis, covariance = fit.shape[:3], fit.frame, fit.shape[3:6], fit.covariance
    if kind == SPHERE:
        axis = np.array([0.0, 0.0, 1.0])
    elif kind != CONE and axis[np.argmax(np.abs(axis))] < 0:
        axis, frame = -axis, frame * [[1], [-1], [-1]]
        covariance = covariance * np.outer(TURNED[kind], TURNED[kind])
        bounds = np.array([[bounds[0, 0], -bounds[1, 1], -bounds[1, 2]], [bounds[1, 0], -bounds[0, 1], -bounds[0, 2]]])
    if kind == SPHERE:
        bounds = np.array([[-1.0] * 3, [1.0] * 3]) * fit.shape[6]
    nan = float("nan")
    radius = float(fit.shape[6]) if kind in (SPHERE, CYLINDER, TORUS) else nan
    return Shape(
        kind=KINDS[kind],
        center=place + search.center + origin,
        axis=axis + 0.0,
        radius=radius,
        minor_radius=float(fit.shape[7]) if kind == TORUS else nan,
        half_angle=math.atan2(fit.shape[7], fit.shape[6]) if kind == CONE else nan,
        extent=bounds,
        support=int(found.rows.size),
        rms=fit.rms,
        coverage=coverage,
        covariance=covariance,
        frame=frame,
        reasons=(),
    )


def _from_fit(search: ShapeSearch, found: Found, shape: Shape, plane: FlatFit) -> list[str]:
    """What its own points say against a shape."""
    said, kind, sigma = [], found.kind, shape.sigma
    if kind != PLANE and is_flat(search, found, plane):
        said.append(f"flat: a plane fits the points as well (rms {plane.rms:.3g} m)")
    for name in ("radius", "minor_radius"):
        if name in sigma and sigma[name] > UNKNOWN * getattr(shape, name):
            part = f"points cover {100 * shape.coverage:.0f} % of it"
            said.append(f"{name} open: {getattr(shape, name):.4g} ± {sigma[name]:.2g} m, as the {part}")
    if kind == CONE and is_open(found, shape.extent[1, 2] - shape.extent[0, 2]):
        said.append(f"half_angle open: {shape.half_angle:.3g} ± {sigma['half_angle']:.2g} rad; a cylinder fits as well")
    if is_small_part(kind, shape):
        sizes = [name for name in ("radius", "minor_radius", "half_angle") if name in sigma]
        known = ", ".join(f"{name} {getattr(shape, name):.4g} ± {sigma[name]:.2g}" for name in sizes)
        said.append(f"small part: points cover {100 * shape.coverage:.0f} % of it ({known} if it is a {shape.kind})")
    return said


def _beside(band: Band) -> list[str]:
    """What the points next to a shape say against it."""
    if band.on < BESIDE * band.beside:
        return [f"chance: {band.on:,} points lie on the surface, and {band.beside:,} beside it"]
    if band.beside_facing > RUNS_ON * band.on_facing:
        said = f"{band.beside_facing:,} points beside the surface face as it does, {band.on_facing:,} lie on it"
        return [f"runs on: {said}: it may touch another along a strip, or distance_threshold is below the noise"]
    return []


def _against(found: Found, rivals: Sequence[Rival]) -> list[str]:
    """The kind that fits the points of a shape better, or as well and is simpler."""
    better = min(rivals, key=lambda rival: rival.ratio, default=None)
    if better is not None and better.ratio < BETTER:
        fits = f"fits better (rms {better.fit.rms:.3g} m), with {better.support:,} points in all"
        return [f"other kind: a {KINDS[better.kind]} {fits}"]
    for rival in rivals:
        if rival.kind in RULED_OUT[found.kind] and rival.ratio < AS_WELL:
            return [f"other kind: a {KINDS[rival.kind]} fits as well (rms {rival.fit.rms:.3g} m) and is simpler"]
    return []


def is_small_part(kind: int, shape: Shape) -> bool:
    """Whether points are near too little of a round surface to tell its kind, by what as many would cover of all."""
    if kind == PLANE:
        return False
    cells = SECTORS if kind in (CYLINDER, CONE) else SECTORS * BANDS
    return bool(shape.coverage < COVERED * -np.expm1(-shape.support / cells))


def is_flat(search: ShapeSearch, found: Found, plane: FlatFit) -> bool:
    """Whether a plane fits the points of a shape as well."""
    return plane.rms <= AS_FLAT * found.fit.rms + ROUNDING * search.size


def is_open(found: Found, length: float) -> bool:
    """Whether a cone may as well be a cylinder: by its half angle's error, or as it tapers by less than the noise."""
    angle = math.atan2(found.fit.shape[7], found.fit.shape[6])
    return bool(CERTAIN * np.sqrt(found.fit.covariance[-1, -1]) > angle or math.tan(angle) * length < found.fit.rms)


def plane_of(search: ShapeSearch, found: Found) -> FlatFit:
    """The plane of least squares through the points of a shape."""
    return search.fitter.fit_plane(found.rows)

"""Georeferencing and scale of SfM models: by a factor, a distance, known positions, or ground control."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.image_names import matching_images
from ...cameras.pose_text import read_lines
from ...core.checks import check_positive, shown
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ...core.records import digest_of, digest_of_file
from ...core.reports import Assessed, failed, quality
from ...core.wording import few_of
from ...io.models.sfm_model import SfmModel
from ...pcd.geodesy import WorldFrame
from ...registration.trajectories.similarity import fit_to_positions, read_positions, scale_from_known
from ...registration.trajectories.up_direction import UpDirection, up_direction, upright_rotation
from ..sfm.image_positions import ImagePositions
from .control import fit_control
from .control_files import ground_of
from .control_report import ControlFit
from .georeference import NotSettledError, PlacesFit, attitudes_of, fit_image_positions, positions_by_image
from .ground_control import GroundControl

MIN_POSITIONS = 3  # minimum positions for a similarity
MAX_RELATIVE_RMS = 0.05  # maximum RMS residual relative to the extent
MAX_WRONG = 1 / 3  # maximum outlier fraction: near 1/2 RANSAC fails

ARBITRARY = "arbitrary"
METRES = "meters"
OF_POSES = "of the poses given"
UNKNOWN = "arbitrary: give --scale, --known or --align for meters"

EXIF, NONE = "exif", "none"  # keywords of `align`


@dataclass(frozen=True, eq=False)
class VideoUnits:
    """Known scale or position of a reconstruction: at most one of scale, known, align, and control.

    If nothing is given, image positions (GPS in EXIF and XMP) are used if they determine scale and rotation. Else the
    model is leveled if its cameras determine the up direction.

    Attributes:
        scale: Meters per model unit.
        known: Two image names, and the distance of their cameras [m].
        align: File of camera positions: poses (of `read_trajectory`, by image number) or lines `name x y z`; "exif" for
            image positions (unreliable if insufficient); "none" for the model's frame.
        places: Image positions; None: `reconstruct_video` reads them from the folder.
        control: GroundControl, or its file (docs/video.md), with three points or more. GPS is only compared.
        scale_bars: File of known lengths between marked points. Without `control` they determine the scale only.

    Raises:
        TypeError: Not numbers, or not two names.
        ValueError: A length that is not positive, conflicting options, or too few or collinear control points.
        FileError: A file cannot be read.

    Example:
        >>> import pointloom as loom
        >>> loom.photogrammetry.VideoUnits(scale=2.5).settings
        {'scale': 2.5, 'known': None, 'align': None}
    """

    scale: float | None = None
    known: tuple[str, str, float] | None = None
    align: FilePath | None = None
    places: ImagePositions | None = None
    control: FilePath | GroundControl | None = None
    scale_bars: FilePath | None = None
    ground: GroundControl | None = field(default=None, init=False, repr=False)

    def __post_init__(self):
        names = ("scale", "known", "align", "control", "scale_bars")
        given = [name for name in names if getattr(self, name) is not None]
        given = [name for name in given if name != "scale_bars" or "control" not in given]
        given = [name for name in given if name != "align" or self._word != NONE]
        if len(given) > 1:
            raise ValueError(f"{given[1]}: {given[0]} is also given, but each of them determines the unit; give one")
        if self.scale is not None:
            object.__setattr__(self, "scale", check_positive("scale", self.scale))
        if self.known is not None:
            first, second, meters = _check_known(self.known)
            object.__setattr__(self, "known", (first, second, check_positive("known", meters)))
        if self.file is not None:
            read_lines(self.file)
        if not isinstance(self.places, ImagePositions | None):
            raise TypeError(f"places: expected ImagePositions, got {type(self.places).__name__}")
        object.__setattr__(self, "ground", ground_of(self.control, self.scale_bars))

    @property
    def _word(self) -> str | None:
        return self.align if isinstance(self.align, str) and self.align in (EXIF, NONE) else None

    @property
    def file(self) -> FilePath | None:
        """`align` if it is a file."""
        return None if self._word is not None else self.align

    @property
    def uses_places(self) -> bool:
        """True if image positions may determine the unit."""
        return self._word == EXIF or all(x is None for x in (self.align, self.scale, self.known, self.ground))

    @property
    def may_place(self) -> bool:
        """True if image positions may georeference the model."""
        if self.ground is not None:
            return bool(self.ground.crs) and not self.ground.why_open()
        return self.uses_places and self.places is not None and len(self.places.places) >= MIN_POSITIONS

    @property
    def settings(self) -> dict[str, Any]:
        """The settings that affect the result, as JSON types."""
        align = self._word if self.file is None else digest_of_file(self.file)
        record = {"scale": self.scale, "known": None if self.known is None else list(self.known), "align": align}
        if self.places is not None and (self.places.places or self.places.attitudes) and align in (None, EXIF):
            record["places"] = digest_of(self.places.to_dict())
        return record if self.ground is None else record | {"control": self.ground.digest()}

    def check_names(self, names: Sequence[str]) -> None:
        """Check that the images named by `known` and `align` exist.

        Raises:
            ValueError: Missing or identical images in `known`, or too few positions for "exif".
            FileError: Too few images of `align` exist, or a malformed line.
        """
        if self.file is not None:
            _positions(self.file, names, "that were taken")
        if self._word == EXIF:
            _check_image_positions(self.places, names)
        if self.known is None:
            return
        first, second = (image_named(name, names) for name in self.known[:2])
        if first == second:
            raise ValueError(
                f"known: {shown(self.known[0])} and {shown(self.known[1])} are the same image, {shown(names[first])}"
            )


@dataclass(frozen=True)
class KnownPlaces:
    """Agreement with known camera positions: outliers (`left_out`), RMS residual, and bounding box diagonal [m]."""

    count: int
    left_out: tuple[str, ...]
    rms_m: float
    extent_m: float


@dataclass(frozen=True, eq=False)
class Fit(Assessed):
    """Position and scale of the model in the world.

    Attributes:
        T_world_model: Similarity, float64 [4, 4].
        units: "meters", "arbitrary", or "of the poses given".
        scale: Meters per model unit. 1 if unknown.
        by: Source: "scale", "known", "align", "exif", "control", "scale_bars", "cameras", or None.
        known_positions: Agreement with the positions of `align`.
        warnings: Failed quality checks. Empty if the fit is reliable.
        gps: Agreement with the image positions if used.
        up: The up direction if estimated.
        notes: Remarks.
        control: Agreement with ground control and scale bars if used.
    """

    T_world_model: NDArray[np.float64]
    units: str
    scale: float
    by: str | None
    known_positions: KnownPlaces | None = None
    warnings: tuple[str, ...] = ()
    gps: PlacesFit | None = None
    up: UpDirection | None = None
    notes: tuple[str, ...] = ()
    control: ControlFit | None = None

    @property
    def frame(self) -> WorldFrame | None:
        if self.control is not None:
            return self.control.frame
        return None if self.gps is None else self.gps.frame

    @property
    def is_upright(self) -> bool:
        if self.control is not None and self.control.is_georeferenced:
            return True
        return self.gps is not None or (self.up is not None and self.up.direction is not None)

    @property
    def comments(self) -> list[str]:
        lines = [f"units {self.units}", *([] if self.frame is None else [f"frame {self.frame}"])]
        if self.control is not None and self.control.origin.any():
            lines.append(f"origin {' '.join(f'{value:.10g}' for value in self.control.origin)}")
        return lines

    def to_dict(self) -> dict[str, Any]:
        record: dict[str, Any] = {"units": self.units, "scale": self.scale, "by": self.by}
        if self.gps is not None:
            record["gps"] = self.gps.to_dict()
        if self.control is not None:
            record["control"] = self.control.to_dict()
        if self.up is not None and self.up.direction is not None:
            record["up"] = {"by": self.up.by, "sigma_degrees": self.up.sigma}
        if self.notes:
            record["notes"] = list(self.notes)
        if (known := self.known_positions) is not None:
            record |= {"places": known.count, "left_out": list(known.left_out)}
            record |= {"rms_m": known.rms_m, "extent_m": known.extent_m}
        return record | quality(self)

    def __str__(self) -> str:
        first, *more = self._line().split("\n")
        return escaped("\n".join([first + ", upright" * self.is_upright, *more, *self.notes]), lines=True)

    def _line(self) -> str:
        if self.units == ARBITRARY:
            return UNKNOWN
        if self.units == OF_POSES:
            return "those of the poses that were given"
        if self.control is not None:
            return str(self.control)
        if (gps := self.gps) is not None:
            line = f"meters by GPS of {len(gps.names)} images, {gps.horizontal_rms:.3g} m off in plan"
            line += "" if math.isnan(gps.vertical_rms) else f" and {gps.vertical_rms:.3g} m in height"
            line += f" (rms); size to {100 * gps.scale_sigma:.2g} %, up to {gps.tilt_sigma:.2g} degrees"
            line += f"; without {', '.join(gps.left_out)}" if gps.left_out else ""
            return f"{line}\n{gps.frame}"
        line = f"meters by --{self.by}: {self.scale:.6g} m a unit of the model"
        if (known := self.known_positions) is not None:
            line += f"; {known.count} positions, {known.rms_m:.3g} m off (rms)"
            line += f", without {', '.join(known.left_out)}" if known.left_out else ""
        return line


def fit_units(units: VideoUnits, model: SfmModel) -> Fit:
    if (path := units.file) is not None:
        return _aligned(path, model)
    if units.ground is not None:
        return _by_ground(units, units.ground, model)
    if units.align == NONE:
        return _of_lengths(units, model)
    attitudes = {} if units.places is None else attitudes_of(units.places, model.names)
    up = up_direction(model, attitudes)
    if units.uses_places and units.places is not None and len(units.places):
        try:
            gps = fit_image_positions(model, units.places, up)
            problem = gps.problem()
        except NotSettledError as error:
            gps, problem = None, str(error)
        notes = tuple(units.places.notes())
        if gps is not None and (problem is None or units.align == EXIF):
            known: dict[str, Any] = {"warnings": failed(problem), "gps": gps, "up": up, "notes": notes}
            return Fit(gps.T_world_model, METRES, gps.scale, EXIF, **known)
        note = f"GPS of the images is not used: {problem}"
        warnings = (note,) if units.align == EXIF else ()
        return _upright(replace(_of_lengths(units, model), warnings=warnings, notes=(*notes, note)), up)
    return _upright(_of_lengths(units, model), up)


def _by_ground(units: VideoUnits, ground: GroundControl, model: SfmModel) -> Fit:
    """Fit by control points or scale bars. If insufficient, by other data and unreliable."""
    try:
        control_fit = fit_control(model, ground, units.places)
    except NotSettledError as error:
        without = fit_units(replace(units, control=None, scale_bars=None), model)
        return replace(without, warnings=(f"ground control is not used: {error}", *without.warnings))
    by = "control" if control_fit.is_georeferenced else "scale_bars"
    fit = Fit(control_fit.T_world_model, METRES, control_fit.scale, by, warnings=control_fit.warnings)
    fit = replace(fit, control=control_fit)
    if control_fit.is_georeferenced or units.align == NONE:
        return fit
    return _upright(fit, up_direction(model, {} if units.places is None else attitudes_of(units.places, model.names)))


def _upright(fit: Fit, up: UpDirection) -> Fit:
    if up.direction is None:
        return replace(fit, up=up)
    rotation = np.eye(4)
    rotation[:3, :3] = upright_rotation(up.direction)
    return replace(fit, T_world_model=rotation @ fit.T_world_model, up=up)


def _of_lengths(units: VideoUnits, model: SfmModel) -> Fit:
    if units.known is not None:
        first, second, meters = units.known
        a, b = (model.names[image_named(name, model.names, " in the model")] for name in (first, second))
        try:
            return _scaled(scale_from_known(model, a, b, meters), "known", METRES)
        except ValueError:
            pair = f"{shown(first)} and {shown(second)}"
            raise ValueError(f"known: {pair} have the same position; give two images that are apart") from None
    if units.scale is not None:
        return _scaled(units.scale, "scale", METRES)
    return _scaled(1.0, None, ARBITRARY)


def fit_as_given(fit: Fit) -> Fit:
    """The fit for given poses: their frame and unit, unless more is known."""
    return replace(fit, units=OF_POSES, by="cameras") if fit.units == ARBITRARY else fit


def image_named(name: str, names: Sequence[str], where: str = "") -> int:
    matches = matching_images(name, names)
    if len(matches) != 1:
        what = "matches no image" if not matches else f"matches {len(matches)} images"
        some = few_of(names, 3)
        raise ValueError(f"known: {name!r} {what}{where}; expected the name or number of one of {some}")
    return matches[0]


def _check_known(known: Any) -> tuple[str, str, Any]:
    parts = known if isinstance(known, tuple | list) else ()
    if len(parts) != 3 or not all(isinstance(part, str | int) for part in parts[:2]):
        raise TypeError(f"known: expected (image, image, meters), got {shown(known)}")
    return str(parts[0]), str(parts[1]), parts[2]


def _scaled(scale: float, by: str | None, units: str) -> Fit:
    return Fit(np.diag([scale, scale, scale, 1.0]), units, scale, by)


def _aligned(path: FilePath, model: SfmModel) -> Fit:
    positions = _positions(path, model.names, "in the model")
    try:
        alignment = fit_to_positions(model, positions)
    except ValueError as error:
        raise FileError(path, str(error), remedy="Add positions off the line, or use --known or --scale") from None
    known = np.array([positions[name] for name in alignment.names])
    left_out = tuple(name for name, fits in zip(alignment.names, alignment.inliers, strict=True) if not fits)
    agreement = KnownPlaces(
        len(alignment.names), left_out, alignment.rmse, float(np.linalg.norm(np.ptp(known, axis=0)))
    )
    warnings = failed(_problem(agreement, path), *alignment.warnings)
    return Fit(alignment.transformation, METRES, alignment.scale, "align", agreement, warnings)


def _problem(agreement: KnownPlaces, path: FilePath) -> str | None:
    if not (
        agreement.rms_m > MAX_RELATIVE_RMS * agreement.extent_m or len(agreement.left_out) > MAX_WRONG * agreement.count
    ):
        return None
    return (
        f"the known and the estimated positions differ by {agreement.rms_m:.3g} m over "
        f"{agreement.extent_m:.3g} m, without "
        f"{len(agreement.left_out)} outliers of {agreement.count}; check {path}"
    )


def _positions(path: FilePath, names: Sequence[str], where: str) -> dict[str, NDArray[np.float64]]:
    positions = read_positions(path, tuple(names))
    if len(positions) < MIN_POSITIONS:
        reason = (
            f"contains the positions of {len(positions)} images {where}; {MIN_POSITIONS} or more "
            "determine scale and position"
        )
        raise FileError(path, reason, remedy=f"Use the names of the images, such as {names[0]}")
    return positions


def _check_image_positions(image_positions: ImagePositions | None, names: Sequence[str]) -> None:
    if image_positions is None:
        raise ValueError('align: "exif" requires a folder of photographs; a video has no GPS positions')
    count = len(positions_by_image(image_positions, tuple(names)))
    if count < MIN_POSITIONS:
        refused = "; ".join(image_positions.notes())
        raise ValueError(
            f'align: "exif": {count} of {len(names)} images have a GPS position; {MIN_POSITIONS} or more '
            "determine scale "
            f"and position{'. ' + refused if refused else ''}"
        )

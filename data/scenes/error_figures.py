"""How far what was made of pictures lies from the truth, as figures."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

from ...core.wording import format_share


@dataclass(frozen=True)
class ErrorFigures:
    """Some errors in one unit."""

    rmse: float
    median: float
    max: float


@dataclass(frozen=True)
class CameraErrors:
    """Errors of cameras after the similarity that fits their centres best.

    Attributes:
        compared: How many cameras.
        scale: Metres in a unit of the poses.
        transformation: The similarity, rows of [4, 4].
        extent_m: Diagonal of the box around the true centres [m].
        m, percent: Of the centres [m], and in hundredths of the extent.
        deg: Of the orientations [degrees].
    """

    compared: int
    scale: float
    transformation: list[list[float]]
    extent_m: float
    m: ErrorFigures
    percent: ErrorFigures
    deg: ErrorFigures

    def to_json(self) -> dict[str, Any]:
        """The same in JSON's types."""
        return asdict(self)

    def __str__(self) -> str:
        return (
            f"off by {self.m.rmse * 1000:.2f} mm root mean square ({self.percent.rmse:.3f} % of "
            f"{self.extent_m:.2f} m), {self.m.max * 1000:.2f} at most; {self.deg.rmse:.3f} degrees"
        )


@dataclass(frozen=True)
class DepthErrors:
    """How complete and how exact depth maps are; means over the pictures, as if each were asked alone.

    Attributes:
        pictures: How many.
        kept: Share of the pixels that have depth, of those with a true one.
        median_relative, p90_relative: Of the kept pixels' errors, over the true depth; NaN where none is kept.
        within: Share of the kept pixels whose error is within a bound.
        complete: Share of all true pixels that is kept and within.
    """

    pictures: int
    kept: float
    median_relative: float
    p90_relative: float
    within: float
    complete: float

    def to_json(self) -> dict[str, Any]:
        """The same in JSON's types."""
        return asdict(self)

    def __str__(self) -> str:
        return (
            f"{format_share(self.kept)} of the pixels kept, off by {100 * self.median_relative:.2f} % in the "
            f"median, {format_share(self.within)} within 1 %"
        )


@dataclass(frozen=True)
class MeshErrors:
    """How far a mesh lies from the true surface [m], and how much of it that covers.

    Attributes:
        vertices: How many.
        median, rmse, p95, largest: Of their distances from the surface [m].
        within: Share of them that is nearer than a bound.
        covered: Share of what was seen that the mesh is so near to; NaN where nothing was.
    """

    vertices: int
    median: float
    rmse: float
    p95: float
    largest: float
    within: float
    covered: float

    def to_json(self) -> dict[str, Any]:
        """The same in JSON's types."""
        return asdict(self)

    def __str__(self) -> str:
        return (
            f"off by {self.median * 1000:.2f} mm in the median, {format_share(self.within)} of "
            f"{self.vertices:,} vertices within 2 cm; covers {format_share(self.covered)} of what was seen"
        )

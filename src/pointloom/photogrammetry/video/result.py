"""Result of a video reconstruction, as JSON types and as terminal output."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from ...core.escaped_text import escaped
from ...core.reports import Assessed, Fields, in_columns, quality
from ...core.stages import StageResult
from ...core.wording import format_bounds, format_bytes, format_fraction
from ...io.models.sfm_model import SfmModel
from ...meshing.mesh.mesh import TriangleMesh
from ...pcd.cloud import PointCloud
from ..sfm.model_quality import ModelQuality
from ..sfm.training_folder import TrainingFolder
from .units import ARBITRARY, UNKNOWN, Fit

MIN_CONFIRMED = 0.2  # minimum fraction of confirmed pixels


@dataclass(frozen=True)
class VideoFigures:
    """Figures of a result from the stage records. None for stages not reached.

    Attributes:
        frame_count: Frames of the video, or images of the folder.
        image_count: Selected images.
        notes: Hints for better recordings.
        quality: Quality of the SfM model.
        cameras: The estimated lenses, in words.
        only_rotated: True if the camera only rotated, so that depth is undetermined.
        image_size: Width and height of the first depth map [px].
        confirmed_fraction: Fraction of pixels with confirmed depth.
        point_count: Fused points.
        vertex_count, triangle_count: Of the mesh.
        floater_count: Removed triangles of small floating parts.
        bounds: Lowest and highest corner of the mesh, "min" and "max". None without vertices.
        frame_warnings: Failed checks of the recording: a damaged or truncated video, or images that cannot be read.
    """

    frame_count: int
    image_count: int
    notes: tuple[str, ...]
    quality: ModelQuality
    cameras: tuple[str, ...]
    only_rotated: bool
    image_size: tuple[int, int] | None = None
    confirmed_fraction: float | None = None
    point_count: int | None = None
    vertex_count: int | None = None
    triangle_count: int | None = None
    floater_count: int | None = None
    bounds: dict[str, Any] | None = None
    frame_warnings: tuple[str, ...] = ()

    @classmethod
    def of_stages(cls, made: Mapping[str, StageResult]) -> VideoFigures:
        frames, model = made["frames"].report, made["model"].report
        quality = ModelQuality.from_json(model)
        features = made["features"].report.get("notes", ()) if "features" in made else ()
        taken = (
            frames["frames"],
            frames["kept"],
            (*frames["notes"], *features, *model.get("notes", ()), *quality.notes),
        )
        model_fields = quality, tuple(model["cameras"]), model["turned"]
        damage = tuple(frames.get("warnings", ()))  # missing in older records
        if "mesh" not in made:
            return cls(*taken, *model_fields, frame_warnings=damage)
        width, height = made["undistorted"].report["sizes"][0]
        fused, mesh = made["fused"].report, made["mesh"].report
        depth = (width, height), fused["fraction"], fused["points"]
        surface = mesh["vertices"], mesh["triangles"], mesh["floaters"], mesh["bounds"]
        return cls(*taken, *model_fields, *depth, *surface, frame_warnings=damage)

    @property
    def is_hopeless(self) -> bool:
        return not self.quality.registered_count or self.only_rotated

    def model_warnings(self) -> list[str]:
        reasons = [*self.quality.warnings, *self.frame_warnings]
        if self.is_hopeless:
            wrong = self.quality.poses is not None and self.quality.poses.are_wrong
            if not wrong and not any("only rotating" in reason for reason in reasons):
                reasons.append("depth is unknown: move instead of only rotating")
            reasons.append("nothing was written")
        return reasons

    def depth_warnings(self) -> list[str]:
        fraction = self.confirmed_fraction
        if fraction is None or fraction >= MIN_CONFIRMED:
            return []
        return [
            f"other images confirm the depth of only {format_fraction(fraction)} of the pixels: surfaces without "
            "texture, or with reflections, cannot be matched; move closer, take more images, or add texture"
        ]


@dataclass(frozen=True)
class StageReport:
    """Report of a stage: `is_reused` from an earlier run, `cost`, `record` (JSON), `outdated` versions if run again."""

    is_reused: bool
    cost: Mapping[str, float]
    record: Mapping[str, Any]
    outdated: str = ""


@dataclass(frozen=True, eq=False)
class VideoResult(Assessed):
    """Result of `reconstruct_video`.

    Attributes:
        source: The video or folder.
        device: Compute device.
        mesh: The surface, or None.
        cloud: The fused points, or None.
        model: Poses, lenses and sparse points, or None. Mesh, cloud and model share one frame and the unit of `fit`.
        fit: Source of the unit, and the similarity from the original model. None without `model`.
        figures: The VideoFigures.
        warnings: Failed quality checks, each with its remedy. Empty if the result is reliable.
        stages: The record of each stage, None if not reached.
        files: Written files.
        work: Folder of stage files.
        peak_bytes: Peak memory of this process or its children [B].
        training: The training folder and its coordinate offset. None without one.
    """

    source: str
    device: str
    mesh: TriangleMesh | None
    cloud: PointCloud | None
    model: SfmModel | None
    fit: Fit | None
    figures: VideoFigures
    warnings: tuple[str, ...]
    stages: Mapping[str, StageReport | None]
    files: tuple[str, ...]
    work: str
    peak_bytes: int
    training: TrainingFolder | None = None

    @property
    def units(self) -> str:
        """ "meters", "arbitrary" or "of the poses given"."""
        return ARBITRARY if self.fit is None else self.fit.units

    @property
    def reached(self) -> dict[str, StageReport]:
        """The stages that ran, by name."""
        return {name: stage for name, stage in self.stages.items() if stage is not None}

    def to_dict(self) -> dict[str, Any]:
        return {
            "command": "video",
            "source": self.source,
            "device": self.device,
            "stages": {
                name: {
                    "kept": stage.is_reused,
                    **stage.cost,
                    **({"outdated": stage.outdated} if stage.outdated else {}),
                }
                for name, stage in self.reached.items()
            },
            **{name: None if stage is None else dict(stage.record) for name, stage in self.stages.items()},
            "units": self.units,
            "fit": None if self.fit is None else self.fit.to_dict(),
            "files": list(self.files),
            "training": None if self.training is None else self.training.to_dict(),
            "peak_bytes": self.peak_bytes,
            **quality(self),
            "work": self.work,
        }

    def fields(self) -> Fields:
        figures = self.figures
        return [
            ("images", "\n".join([self._images_line(), *figures.notes])),
            *([("camera", _camera_line(figures))] if figures.quality.point_count else []),
            *([("depth", _depth_line(figures))] if figures.image_size else []),
            *([("mesh", _mesh_line(figures))] if figures.vertex_count is not None else []),
            ("units", UNKNOWN if self.fit is None else str(self.fit)),
            *([("bounds", format_bounds(figures.bounds))] if figures.vertex_count is not None else []),
            *([("made again", again)] if (again := self._again_line()) else []),
            ("seconds", self._seconds_line()),
            ("memory", f"{format_bytes(self.peak_bytes)} at most"),
            ("stages", self.work),
            ("files", ", ".join(self.files) or "none"),
        ]

    def __str__(self) -> str:
        return f"{escaped(self.source)}\n{in_columns(self.fields())}"

    def _images_line(self) -> str:
        chosen = f"chosen from {self.figures.frame_count:,}, on {self.device}"
        return f"{self.figures.quality.registered_count} of {self.figures.image_count} registered, {chosen}"

    def _again_line(self) -> str:
        whys: dict[str, list[str]] = {}
        for name, stage in self.reached.items():
            if stage.outdated:
                whys.setdefault(stage.outdated, []).append(name)
        return "\n".join(f"{', '.join(names)}: {why}" for why, names in whys.items())

    def _seconds_line(self) -> str:
        stages = self.reached
        parts = [f"{name} kept" if s.is_reused else f"{name} {s.cost['seconds']:.1f}" for name, s in stages.items()]
        return ", ".join([*parts, f"all {sum(s.cost['seconds'] for s in stages.values() if not s.is_reused):.1f}"])


def _camera_line(figures: VideoFigures) -> str:
    quality = figures.quality
    seen = f"seen under {quality.angle:.1f} degrees (median)"
    return f"{'; '.join(figures.cameras)}\n{quality.point_count:,} points to {quality.error:.2f} px, {seen}"


def _depth_line(figures: VideoFigures) -> str:
    assert figures.image_size is not None and figures.confirmed_fraction is not None
    size, confirmed = "{} x {}".format(*figures.image_size), format_fraction(figures.confirmed_fraction)
    return f"of {size} pixels, {confirmed} confirmed by others; {figures.point_count:,} points"


def _mesh_line(figures: VideoFigures) -> str:
    loose = f", {figures.floater_count:,} in small parts left out" if figures.floater_count else ""
    return f"{figures.vertex_count:,} vertices, {figures.triangle_count:,} triangles{loose}"

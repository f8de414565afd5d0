"""What becomes of a video: the mesh, and what is to be told of it, in JSON's types and in lines for the terminal."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from ...core.reports import Assessed, Fields, in_columns, quality
from ...core.stages import Made
from ...core.wording import format_bounds, format_bytes, format_share
from ...files.models.sfm_model import SfmModel
from ...meshing.mesh.mesh import TriangleMesh
from ...pcd.cloud import PointCloud
from ..sfm.model_quality import ModelQuality
from ..sfm.training_folder import TrainingFolder
from .units import ARBITRARY, UNKNOWN, Fit

LEAST_KEPT = 0.2  # share of the pixels whose depth other pictures confirm


@dataclass(frozen=True)
class VideoFigures:
    """The figures of a result, as the stages told them; None where it did not come to that.

    Attributes:
        frame_count: Frames of the video, or pictures of the folder, that there were.
        picture_count: Pictures that were taken of them.
        notes: What whoever films should know.
        quality: Quality of the model of structure from motion.
        cameras: The lenses that were found, in words.
        only_turned: The camera turned without moving, so that nothing is known of depth.
        picture_size: Width and height of the first picture that depth was found in [px].
        confirmed_share: Share of the pixels whose depth other pictures confirm.
        point_count: Fused points.
        vertex_count, triangle_count: Of the mesh.
        floater_count: Triangles of small parts in the air, which were left out.
        bounds: The lowest and highest corner of the mesh, "min" and "max"; None of one without vertices.
    """

    frame_count: int
    picture_count: int
    notes: tuple[str, ...]
    quality: ModelQuality
    cameras: tuple[str, ...]
    only_turned: bool
    picture_size: tuple[int, int] | None = None
    confirmed_share: float | None = None
    point_count: int | None = None
    vertex_count: int | None = None
    triangle_count: int | None = None
    floater_count: int | None = None
    bounds: dict[str, Any] | None = None

    @classmethod
    def of_stages(cls, made: Mapping[str, Made]) -> VideoFigures:
        """The figures in what the stages told, which is what their records hold."""
        frames, model = made["frames"].told, made["model"].told
        quality = ModelQuality.from_json(model)
        features = made["features"].told.get("notes", ()) if "features" in made else ()
        taken = (
            frames["frames"],
            frames["kept"],
            (*frames["notes"], *features, *model.get("notes", ()), *quality.notes),
        )
        placed = quality, tuple(model["cameras"]), model["turned"]
        if "mesh" not in made:
            return cls(*taken, *placed)
        width, height = made["undistorted"].told["sizes"][0]
        fused, mesh = made["fused"].told, made["mesh"].told
        depth = (width, height), fused["share"], fused["points"]
        return cls(*taken, *placed, *depth, mesh["vertices"], mesh["triangles"], mesh["floaters"], mesh["bounds"])

    @property
    def is_hopeless(self) -> bool:
        """Whether no depth can come of the model: no picture is placed, or the camera only turned."""
        return not self.quality.registered_count or self.only_turned

    def model_warnings(self) -> list[str]:
        """Failed checks of the model, each with its remedy."""
        reasons = [*self.quality.warnings]
        if self.is_hopeless:
            wrong = self.quality.poses is not None and self.quality.poses.are_wrong
            if not wrong and not any("only turn" in reason for reason in reasons):
                reasons.append("nothing is known of depth: move, do not only turn")
            reasons.append("nothing was written")
        return reasons

    def depth_warnings(self) -> list[str]:
        """A warning if too little of the depth is confirmed, with the remedy."""
        share = self.confirmed_share
        if share is None or share >= LEAST_KEPT:
            return []
        return [
            f"other pictures confirm the depth of {format_share(share)} of the pixels: surfaces without texture, or "
            "that shine, cannot be matched; move closer, take more pictures, or put texture on what is plain"
        ]


@dataclass(frozen=True)
class StageReport:
    """What a stage told, and what it cost.

    Attributes:
        kept: Whether an earlier run made it; then its cost is of that run.
        cost: "seconds", "cpu_seconds", and "peak_bytes", the most memory that was held by its end.
        told: What it says of itself, in JSON's types, as its record holds it.
        outdated: The versions by which an earlier run's was not kept, in words; empty where none were others.
    """

    kept: bool
    cost: Mapping[str, float]
    told: Mapping[str, Any]
    outdated: str = ""


@dataclass(frozen=True, eq=False)
class VideoResult(Assessed):
    """What became of a video, or of a folder of pictures; printed, it is what `pointloom video` says.

    Attributes:
        source: The video or folder.
        device: Where it was computed.
        mesh: The surface; None where there is none.
        cloud: The points that several pictures agree on; None where it did not come to that.
        model: Where the pictures were taken, their lenses and the sparse points; None where nothing is known of depth.
            Mesh, cloud and model lie in one frame, in the unit that `fit` tells.
        fit: How the unit was settled, and the similarity from the model that was found; None where `model` is.
        figures: How many pictures were placed, how well, how much of the depth was confirmed, how large the mesh is.
        warnings: Failed quality checks, each with its remedy; empty if the result is reliable.
        stages: What each stage told and cost, None where it was not reached.
        files: Those that were written.
        work: The folder of the stages' files, where one was asked for.
        peak_bytes: The most memory that this process, or one that it waited for, has held [B].
        training: What the folder to train from holds, and what was taken from its coordinates; None without one.
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
    work: str | None
    peak_bytes: int
    training: TrainingFolder | None = None

    @property
    def units(self) -> str:
        """ "metres", "arbitrary" or "of the poses given"."""
        return ARBITRARY if self.fit is None else self.fit.units

    @property
    def reached(self) -> dict[str, StageReport]:
        """The stages that were reached, in their order."""
        return {name: stage for name, stage in self.stages.items() if stage is not None}

    def to_dict(self) -> dict[str, Any]:
        """The report that the command writes, in JSON's types; without mesh, cloud and model."""
        return {
            "command": "video",
            "source": self.source,
            "device": self.device,
            "stages": {
                name: {"kept": stage.kept, **stage.cost, **({"outdated": stage.outdated} if stage.outdated else {})}
                for name, stage in self.reached.items()
            },
            **{name: None if stage is None else dict(stage.told) for name, stage in self.stages.items()},
            "units": self.units,
            "fit": None if self.fit is None else self.fit.to_dict(),
            "files": list(self.files),
            "training": None if self.training is None else self.training.to_dict(),
            "peak_bytes": self.peak_bytes,
            **quality(self),
            "work": self.work,
        }

    def fields(self) -> Fields:
        """What was done as labels and values for the terminal."""
        found = self.figures
        return [
            ("pictures", "\n".join([self._pictures_line(), *found.notes])),
            *([("camera", _camera_line(found))] if found.quality.point_count else []),
            *([("depth", _depth_line(found))] if found.picture_size else []),
            *([("mesh", _mesh_line(found))] if found.vertex_count is not None else []),
            ("units", UNKNOWN if self.fit is None else str(self.fit)),
            *([("bounds", format_bounds(found.bounds))] if found.vertex_count is not None else []),
            *([("made again", again)] if (again := self._again_line()) else []),
            ("seconds", self._seconds_line()),
            ("memory", f"{format_bytes(self.peak_bytes)} at most"),
            *([("stages", self.work)] if self.work else []),
            ("files", ", ".join(self.files) or "none"),
        ]

    def __str__(self) -> str:
        return f"{self.source}\n{in_columns(self.fields())}"

    def _pictures_line(self) -> str:
        chosen = f"chosen from {self.figures.frame_count:,}, on {self.device}"
        return f"{self.figures.quality.registered_count} of {self.figures.picture_count} placed, {chosen}"

    def _again_line(self) -> str:
        """Which stages were made again since another version had made them."""
        whys: dict[str, list[str]] = {}
        for name, stage in self.reached.items():
            if stage.outdated:
                whys.setdefault(stage.outdated, []).append(name)
        return "\n".join(f"{', '.join(names)}: {why}" for why, names in whys.items())

    def _seconds_line(self) -> str:
        stages = self.reached
        parts = [f"{name} kept" if s.kept else f"{name} {s.cost['seconds']:.1f}" for name, s in stages.items()]
        return ", ".join([*parts, f"all {sum(s.cost['seconds'] for s in stages.values() if not s.kept):.1f}"])


def _camera_line(found: VideoFigures) -> str:
    quality = found.quality
    seen = f"seen under {quality.angle:.1f} degrees (median)"
    return f"{'; '.join(found.cameras)}\n{quality.point_count:,} points to {quality.error:.2f} px, {seen}"


def _depth_line(found: VideoFigures) -> str:
    assert found.picture_size is not None and found.confirmed_share is not None
    size, kept = "{} x {}".format(*found.picture_size), format_share(found.confirmed_share)
    return f"of {size} pixels, {kept} confirmed by others; {found.point_count:,} points"


def _mesh_line(found: VideoFigures) -> str:
    loose = f", {found.floater_count:,} in small parts left out" if found.floater_count else ""
    return f"{found.vertex_count:,} vertices, {found.triangle_count:,} triangles{loose}"

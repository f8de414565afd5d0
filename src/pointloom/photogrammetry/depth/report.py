"""Reports of monocular depth estimation, as JSON types and as terminal output."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.escaped_text import escaped
from ...core.reports import Assessed, Fields, in_columns, quality
from ...core.wording import format_bytes, format_fraction, format_seconds
from .estimation import ARBITRARY, DepthEstimate, estimate_warnings

FEW_POINTS = 0.2  # fraction of the pixels


@dataclass(frozen=True, eq=False)
class ImageDepth(Assessed):
    """Figures of one image as in `DepthEstimate`. Sizes are (width, height), `depth_range` may be None."""

    image: str
    size: tuple[int, int]
    input_size: tuple[int, int]
    unit: str
    is_metric: bool
    scale: float
    shift: float
    references: int
    inlier_fraction: float | None
    tiles: tuple[int, int] | None
    depth_range: tuple[float, float] | None
    intrinsic: PinholeCameraIntrinsic
    intrinsic_source: str
    point_count: int
    depth_fraction: float
    files: tuple[str, ...]

    @classmethod
    def of(cls, estimate: DepthEstimate, image: str, point_count: int, files: tuple[str, ...]) -> ImageDepth:
        height, width = estimate.depth.shape
        seen = estimate.depth[estimate.depth > 0]
        return cls(
            image=image,
            size=(width, height),
            input_size=(estimate.input_size[1], estimate.input_size[0]),
            unit=estimate.unit,
            is_metric=estimate.is_metric,
            scale=estimate.scale,
            shift=estimate.shift,
            references=estimate.references,
            inlier_fraction=estimate.inlier_fraction,
            tiles=estimate.tiles,
            depth_range=(float(seen.min()), float(seen.max())) if len(seen) else None,
            intrinsic=estimate.intrinsic,
            intrinsic_source=estimate.intrinsic_source,
            point_count=point_count,
            depth_fraction=len(seen) / estimate.depth.size,
            files=files,
        )

    @property
    def point_fraction(self) -> float:
        return self.point_count / (self.size[0] * self.size[1])

    @property
    def warnings(self) -> tuple[str, ...]:
        reasons = [*estimate_warnings(self.inlier_fraction, self.references, self.intrinsic_source)]
        if self.point_fraction < FEW_POINTS:
            reasons.append(f"only {self.point_fraction:.1%} of the pixels became points: keep edges, or align")
        return tuple(reasons)

    def to_dict(self) -> dict[str, Any]:
        camera, (nearest, farthest) = self.intrinsic, self.depth_range or (None, None)
        return {
            "width": self.size[0],
            "height": self.size[1],
            "input": {"width": self.input_size[0], "height": self.input_size[1]},
            "unit": self.unit,
            "is_metric": self.is_metric,
            "scale": self.scale,
            "shift": self.shift,
            "references": self.references,
            "inlier_fraction": self.inlier_fraction,
            "tiles": None if self.tiles is None else {"used": self.tiles[0], "count": self.tiles[1]},
            "nearest": nearest,
            "farthest": farthest,
            "camera": {
                **{name: getattr(camera, name) for name in ("fx", "fy", "cx", "cy", "width", "height")},
                "source": self.intrinsic_source,
            },
            "points": self.point_count,
            "depth_fraction": self.depth_fraction,
            "kept_fraction": self.point_fraction,
            "files": list(self.files),
            "image": self.image,
            **quality(self),
        }

    def fields(self) -> Fields:
        camera = self.intrinsic
        seen = f"{camera.width} x {camera.height}, f {camera.fx:.6g} {camera.fy:.6g}, from {self.intrinsic_source}"
        size = "{} x {}, {} x {} for the network".format(*self.size, *self.input_size)
        if self.tiles is not None:
            size += "\n{} of {} tiles agree with the map of the complete image".format(*self.tiles)
        points = f"{self.point_count:,}, {format_fraction(self.point_fraction)} of the pixels"
        return [("image", size), ("camera", seen), ("depth", self._depth_line()), ("points", points)]

    def __str__(self) -> str:
        line = f"{self.point_count:,} points, {self._depth_line().splitlines()[0]}"
        return f"{line}; {self._agreement()}" if self.references else line

    def _depth_line(self) -> str:
        line_range = "none" if self.depth_range is None else "{:.4g} to {:.4g}".format(*self.depth_range)
        if self.unit == "m":
            line = f"{line_range} m"
        elif self.unit == ARBITRARY:
            line = f"{line_range}, units arbitrary: the nearest pixel is at 1; --align gives meters"
        else:
            line = f"{line_range} in the unit of the sparse model"
        if self.references:
            line += f"\n1 / z = {self.scale:.6g} d + {self.shift:.6g}, {self._agreement()}"
        return line

    def _agreement(self) -> str:
        if self.inlier_fraction is None:
            return f"from {self.references} distances, unchecked: one more distance allows a check"
        return f"{format_fraction(self.inlier_fraction)} of {self.references:,} references agree within 10%"


@dataclass(frozen=True)
class DepthFailure:
    """An image without result; `refused` if its references do not fit, else a file could not be read."""

    image: str
    reason: str
    refused: bool


@dataclass(frozen=True, eq=False)
class DepthReport(Assessed):
    """Result of `depth_of_images`.

    Attributes:
        source: The image or folder.
        is_folder: True if it is a folder.
        model: The network file.
        preset, license: The type of network, and the license of its published weights.
        provider: The onnxruntime provider.
        device: Device of the clouds.
        images: Images with a cloud.
        failures: Images without one.
        seconds: Time of each stage [s].
        peak_bytes: Peak memory of this process [B].
        notes: What could not be verified in the network file.
    """

    source: str
    is_folder: bool
    model: str
    preset: str
    license: str
    provider: str
    device: str
    images: tuple[ImageDepth, ...]
    failures: tuple[DepthFailure, ...]
    seconds: dict[str, float]
    peak_bytes: int
    notes: tuple[str, ...] = ()

    @property
    def files(self) -> tuple[str, ...]:
        return tuple(file for each in self.images for file in each.files)

    @property
    def warnings(self) -> tuple[str, ...]:
        reasons = []
        if self.failures:
            first = self.failures[0].reason
            many = f"{len(self.failures)} of {len(self.failures) + len(self.images)} images failed: "
            where = " for them" if self.is_folder else ""
            reasons.append(f"{many if self.is_folder else ''}{first}; nothing was written{where}")
        for each in self.images:
            name = f"{Path(each.image).name}: " if self.is_folder else ""
            reasons += [f"{name}{reason}" for reason in each.warnings]
        return tuple(reasons)

    def to_dict(self) -> dict[str, Any]:
        return {
            "command": "depth",
            "source": self.source,
            "model": self.model,
            "preset": self.preset,
            "license": self.license,
            "provider": self.provider,
            "device": self.device,
            "images": [each.to_dict() for each in self.images],
            "failures": [asdict(each) for each in self.failures],
            "seconds": self.seconds,
            "peak_bytes": self.peak_bytes,
            "files": list(self.files),
            **quality(self),
            "notes": list(self.notes),
        }

    def fields(self) -> Fields:
        network = f"{self.model}, preset {self.preset} ({self.license})"
        fields = [("network", "\n".join([network, *self.notes])), ("ran on", self.provider)]
        if len(self.images) == 1 and not self.failures:
            fields += self.images[0].fields()
        else:
            fields += [(Path(each.image).name, str(each)) for each in self.images]
            fields += [(Path(each.image).name, each.reason) for each in self.failures]
        return [
            *fields,
            ("seconds", format_seconds(self.seconds)),
            ("memory", f"{format_bytes(self.peak_bytes)} at most"),
            ("files", ", ".join(self.files) or "none"),
        ]

    def __str__(self) -> str:
        return f"{escaped(self.source)}\n{in_columns(self.fields())}"

"""What the job says of its result: verdicts with their remedies, and lines for the terminal."""

from __future__ import annotations

from typing import Any

from ..console import format_bounds, format_bytes, format_share
from .units import ARBITRARY

LEAST_KEPT = 0.2  # share of the pixels whose depth other pictures confirm


def is_hopeless(model: dict[str, Any]) -> bool:
    """Whether no depth can come of a model: no picture is placed, or the camera only turned."""
    return not model["registered_count"] or model["turned"]


def why_model_poor(model: dict[str, Any]) -> list[str]:
    """What is wrong with a model, and what to do about it."""
    reasons = [*model["reasons"]]
    if is_hopeless(model):
        if not any("only turn" in reason for reason in reasons):
            reasons.append("nothing is known of depth: move, do not only turn")
        reasons.append("nothing was written")
    return reasons


def why_depth_poor(fused: dict[str, Any]) -> str | None:
    """Whether too little of the depth is left, or nothing."""
    share = fused["share"]
    if share >= LEAST_KEPT:
        return None
    return (
        f"other pictures confirm the depth of {format_share(share)} of the pixels: surfaces without texture, or that "
        "shine, cannot be matched; move closer, take more pictures, or put texture on what is plain"
    )


def video_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """What was done as labels and values for the terminal."""
    return [
        ("pictures", "\n".join([_pictures_line(report), *report["frames"]["remarks"]])),
        *([("camera", _camera_line(report["model"]))] if report["model"] and report["model"]["point_count"] else []),
        *([("depth", _depth_line(report))] if report["fused"] else []),
        *([("mesh", _mesh_line(report["mesh"]))] if report["mesh"] else []),
        ("units", _units_line(report)),
        *([("bounds", format_bounds(report["mesh"]["bounds"]))] if report["mesh"] else []),
        ("seconds", _seconds_line(report["stages"])),
        ("memory", f"{format_bytes(report['peak_bytes'])} at most"),
        *([("stages", report["work"])] if report["work"] else []),
        ("files", ", ".join(report["files"]) or "none"),
    ]


def _pictures_line(report: dict[str, Any]) -> str:
    frames, model = report["frames"], report["model"]
    chosen = f"chosen from {frames['frames']:,}, on {report['device']}"
    return f"{model['registered_count'] if model else 0} of {frames['kept']} placed, {chosen}"


def _camera_line(model: dict[str, Any]) -> str:
    lenses = "; ".join(model["cameras"])
    seen = (
        f"{model['point_count']:,} points to {model['error']:.2f} px, seen under {model['angle']:.1f} degrees (median)"
    )
    return f"{lenses}\n{seen}"


def _depth_line(report: dict[str, Any]) -> str:
    width, height = report["undistorted"]["sizes"][0]
    kept = format_share(report["fused"]["share"])
    return f"of {width} x {height} pixels, {kept} confirmed by others; {report['fused']['points']:,} points"


def _mesh_line(mesh: dict[str, Any]) -> str:
    loose = f", {mesh['floaters']:,} in small parts left out" if mesh["floaters"] else ""
    return f"{mesh['vertices']:,} vertices, {mesh['triangles']:,} triangles{loose}"


def _units_line(report: dict[str, Any]) -> str:
    if report["units"] == ARBITRARY:
        return "arbitrary: give --scale, --known or --align for metres"
    fit = report["fit"]
    line = f"metres by --{fit['by']}: {fit['scale']:.6g} m a unit of the model"
    if fit["by"] == "align":
        line += f"; {fit['places']} places, {fit['rms_m']:.3g} m off (rms)"
        line += f", without {', '.join(fit['left_out'])}" if fit["left_out"] else ""
    return line


def _seconds_line(stages: dict[str, Any]) -> str:
    parts = [f"{name} kept" if stage["kept"] else f"{name} {stage['seconds']:.1f}" for name, stage in stages.items()]
    return ", ".join([*parts, f"all {sum(s['seconds'] for s in stages.values() if not s['kept']):.1f}"])

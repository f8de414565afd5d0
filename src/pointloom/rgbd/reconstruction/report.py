"""Report of the reconstruction system: `SystemReport`."""

from __future__ import annotations

import itertools
import os
from dataclasses import dataclass
from typing import Any, NamedTuple

from ...core.escaped_text import escaped
from ...core.reports import Assessed, Fields, Report, failed, quality
from ...core.wording import format_bytes, format_seconds, plain
from .fragments import Fragment, FragmentSet
from .frames import LostFrame
from .placement import Placement
from .scene import Scene

_MAX_LISTED_RUNS = 5  # listed runs of lost frames


@dataclass(frozen=True)
class LostRun:
    """Consecutive frames that are not in the model, with the stage that lost them and the reason."""

    first: str
    last: str
    first_index: int
    count: int
    stage: str
    reason: str

    def __str__(self) -> str:
        ends = self.first if self.count == 1 else f"{self.first} to {self.last} ({self.count})"
        return escaped(f"{ends}: {self.reason}")


@dataclass(frozen=True)
class LoopCount:
    tried: int
    aligned: int
    kept: int


@dataclass(frozen=True)
class FragmentSummary:
    """Summary of a fragment; `broke`: reason for the gap before it, `joined`: linked by odometry to an earlier one."""

    number: int
    frames: int
    first: str
    last: str
    placed: bool
    broke: str
    joined: bool
    loops: LoopCount


@dataclass(frozen=True)
class SystemReport(Report, Assessed):
    """Result of `run_reconstruction_system`.

    Attributes:
        folder: Job folder.
        frames: Number of source frames.
        lost: Runs of frames that are not in the model, in order.
        fragments: All fragments, in order.
        edges: Edges of the fragment pose graph.
        loops: Its loop closures, which may be removed.
        mesh: `Scene.figures`, or None.
        trajectory_error: rmse, median and max [m] if true poses are known.
        resumed: Number of fragments reused from an earlier run.
        files: The mesh and the trajectory files.
        warnings: Failed quality checks. Empty if the result is reliable.
        slac: `BentPlacement.figures`. None if not requested.
        seconds: Time of each stage [s].
        peak_bytes: Peak memory [B].
    """

    folder: str
    frames: int
    lost: tuple[LostRun, ...]
    fragments: tuple[FragmentSummary, ...]
    edges: int
    loops: int
    mesh: dict[str, Any] | None
    trajectory_error: dict[str, float] | None
    resumed: int
    files: tuple[str, ...]
    warnings: tuple[str, ...]
    slac: dict[str, Any] | None
    seconds: dict[str, float]
    peak_bytes: int

    @property
    def used(self) -> int:
        """Number of frames in the scene."""
        return self.frames - sum(run.count for run in self.lost)

    def to_dict(self) -> dict[str, Any]:
        return plain(
            {
                "command": "reconstruct",
                "method": "fragments",
                "folder": self.folder,
                "frames": self.frames,
                "used": self.used,
                "lost": self.lost,
                "fragments": self.fragments,
                "edges": self.edges,
                "loops": self.loops,
                "mesh": self.mesh,
                "trajectory_error": self.trajectory_error,
                "resumed": {"fragments": self.resumed},
                "files": self.files,
                **quality(self),
                "slac": self.slac,
                "seconds": self.seconds,
                "peak_bytes": self.peak_bytes,
            }
        )

    def parts(self, where: str = "") -> Fields:
        """Names and values of frames and fragments."""
        joined = sum(fragment.placed for fragment in self.fragments)
        fragments = f"{joined} of {len(self.fragments)} joined, {self.loops} loops"
        if self.resumed:
            fragments += f"; {self.resumed} reused from an earlier run"
        fields = [("frames", f"{self.used} of {self.frames} in the model{where}"), ("fragments", fragments)]
        if self.lost:
            runs = [str(run) for run in self.lost[:_MAX_LISTED_RUNS]]
            fields.append(("lost", "\n".join([*runs, *(["and more"] if len(self.lost) > _MAX_LISTED_RUNS else [])])))
        if self.slac:
            fields.append(("slac", _slac_line(self.slac)))
        return fields

    def fields(self) -> Fields:
        memory = f"{format_bytes(self.peak_bytes)} at most"
        cost = [("seconds", format_seconds(self.seconds)), ("memory", memory)]
        return [*self.parts(), *cost, ("files", ", ".join(self.files) or "none")]


class Cost(NamedTuple):
    """Seconds of each stage, and the maximum memory."""

    seconds: dict[str, float]
    peak_bytes: int


def report_of(
    folder: str,
    frame_count: int,
    fragment_set: FragmentSet,
    placement: Placement | None,
    scene: Scene | None,
    *,
    slac: dict[str, Any] | None,
    cost: Cost,
    source_warnings: tuple[str, ...] = (),
) -> SystemReport:
    registered = [False] * len(fragment_set.fragments) if placement is None else placement.placed.tolist()
    lost = _lost_frames(fragment_set, registered, scene)
    edges = [] if placement is None else placement.pose_graph.edges
    written = () if scene is None else (scene.mesh_path, scene.trajectory_path, scene.cloud_path)
    files = [path for path in written if path is not None]
    figures = {} if scene is None else dict(scene.figures)
    error = figures.pop("trajectory_error", None)
    return SystemReport(
        folder=folder,
        frames=frame_count,
        lost=tuple(lost),
        fragments=tuple(map(_summary_of, fragment_set.fragments, registered)),
        edges=len(edges),
        loops=sum(edge.uncertain for edge in edges),
        mesh=figures or None,
        trajectory_error=error,
        resumed=fragment_set.resumed,
        files=tuple(os.fspath(path) for path in files),
        warnings=(*_warnings(lost, placement, scene, frame_count), *_graph_warnings(placement, slac), *source_warnings),
        slac=slac,
        seconds=cost.seconds,
        peak_bytes=cost.peak_bytes,
    )


def _summary_of(f: Fragment, is_registered: bool) -> FragmentSummary:
    numbers, loops = (f.number, len(f), f.names[0], f.names[-1]), LoopCount(*f.loops)
    return FragmentSummary(*numbers, is_registered, f.broke, f.joint is not None, loops)


def _lost_frames(fragment_set: FragmentSet, registered: list[bool], scene: Scene | None) -> list[LostRun]:
    entries = [(frame, "make_fragments") for frame in fragment_set.lost]
    for fragment, is_registered in zip(fragment_set.fragments, registered, strict=True):
        if not is_registered:
            reason = f"fragment {fragment.number} could not be joined with the others"
            frames = zip(fragment.indices.tolist(), fragment.names, strict=True)
            entries += [(LostFrame(i, name, reason), "register_fragments") for i, name in frames]
    if scene is not None:
        entries += [(frame, "integrate_scene") for frame in scene.lost]
    entries.sort(key=lambda entry: entry[0].index)
    runs = []
    # the key is constant over consecutive frames with the same reason
    keys = ((frame.index - k, stage, frame.reason) for k, (frame, stage) in enumerate(entries))
    for (_, stage, reason), run in itertools.groupby(zip(keys, entries, strict=True), key=lambda pair: pair[0]):
        frames = [entry[0] for _, entry in run]
        runs.append(LostRun(frames[0].name, frames[-1].name, frames[0].index, len(frames), stage, reason))
    return runs


def _warnings(
    lost: list[LostRun], placement: Placement | None, scene: Scene | None, frame_count: int
) -> tuple[str, ...]:
    if placement is None:
        return (f"no two of the {frame_count} frames overlap; {lost[0].reason}",)
    reasons = []
    if scene is not None and scene.mesh_path is None:
        reasons.append("the mesh is empty: no voxel was seen often enough; use more frames")
    if lost:
        count = sum(run.count for run in lost)
        where = f"from {lost[0].first} on" if len(lost) == 1 else f"{len(lost)} runs, the first at {lost[0].first}"
        reasons.append(f"{count} of {frame_count} frames are not in the model ({where}): {lost[0].reason}")
    return tuple(reasons)


def _graph_warnings(placement: Placement | None, slac: dict[str, Any] | None) -> tuple[str, ...]:
    report = None if placement is None else placement.pose_graph.report
    return failed(*getattr(report, "warnings", ()), _slac_line(slac) if slac and not slac["edges"] else None)


def _slac_line(figures: dict[str, Any]) -> str:
    if not figures["edges"]:
        return "nothing to align: no two fragments overlap; set fewer frames per fragment (--config) for more fragments"
    apart = f"{figures['rmse_before'] * 1000:.1f} to {figures['rmse'] * 1000:.1f} mm apart"
    bent = f", {figures['anchors']:,} anchors moved by {figures['bent_m'] * 1000:.1f} mm" if figures["anchors"] else ""
    return f"fragments {apart} on {figures['used']} of {figures['edges']} overlaps{bent}"

"""Split RGB-D frames into fragments: odometry, loop closures within a fragment, pose graph, and point cloud.

A pair that odometry cannot align ends the fragment. The frame after the gap is also aligned with one of the last frames
of the previous fragment, since an occlusion may have ended.
"""

from __future__ import annotations

import contextlib
from collections.abc import Generator, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.checks import check_progress
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FileError, FilePath
from ...core.json_fields import (
    Checks,
    below,
    has_fields,
    is_ascending,
    is_count,
    is_flag,
    is_pose,
    is_text,
    list_of,
    optional,
    row_of,
)
from ...core.progress import ReportProgress
from ...core.records import digest_of, files_below, read_record, write_record
from ...io.frames.frames import FrameSource
from ...io.points.point_cloud import read_point_cloud, write_point_cloud
from ...kernels.linear_algebra import matmul
from ...meshing.volume.tsdf import TSDFVolume
from ...pcd.cloud import PointCloud
from ...registration.pose_graphs.pose_graph import PoseGraph, PoseGraphEdge, PoseGraphNode
from ...registration.pose_graphs.pose_graph_files import write_pose_graph
from ...registration.pose_graphs.pose_graph_optimization import GlobalOptimizationOption, global_optimization
from ...registration.rigid import adjoint_of, invert_pose
from ..odometry.alignment import align_frames
from ..odometry.frames import OdometryFrame
from ..odometry.results import OdometryResult
from .config import ReconstructionConfig
from .frames import Frames, LostFrame, ReadFrame
from .job_files import JobFiles
from .volumes import cloud_of, fuse_frames

Matrix = NDArray[np.float64]

STAGE = "fragment"
MIN_LOOP_CONFIDENCE = 0.25  # confidence at which a loop closure is removed, as in Open3D
SETTINGS = (
    *("depth_min", "depth_max", "depth_diff_max", "odometry_method", "n_frames_per_fragment", "n_frames_least"),
    *("n_keyframes_per_n_frame", "preference_loop_closure_odometry"),
)


@dataclass(frozen=True, eq=False)
class Fragment:
    """Connected frames and their point cloud.

    Attributes:
        number: Index of the fragment.
        indices, names: Indices of its frames in the source, int64 [n], and their names.
        poses: T_fragment_frame, float64 [n, 4, 4], relative to its first frame.
        joint: Odometry link to an earlier fragment. None if there is none.
        broke: Reason for the gap before this fragment. Empty if there is none.
        loops: Number of keyframe pairs tried, aligned, and kept by the pose graph.
        colored: True if all frames have color.
        cloud_path: The file of its cloud.
        made_from: Digest of its inputs.
    """

    number: int
    indices: NDArray[np.int64]
    names: list[str]
    poses: Matrix
    joint: Joint | None
    broke: str
    loops: tuple[int, int, int]
    colored: bool
    cloud_path: Path
    made_from: str

    def __len__(self) -> int:
        return len(self.indices)

    def read_cloud(self, device: DeviceLike = None) -> PointCloud:
        return read_point_cloud(self.cloud_path, device=device)

    def T_earlier(self, earlier: Fragment) -> Matrix:
        assert self.joint is not None
        return matmul(earlier.poses[-1], self.joint.T_last_first)


@dataclass(frozen=True, eq=False)
class FragmentSet:
    """All `fragments` in frame order, the `lost` frames, and the number of fragments `resumed` from an earlier run."""

    fragments: list[Fragment]
    lost: list[LostFrame]
    resumed: int


def make_fragments(
    source: FrameSource,
    config: ReconstructionConfig,
    folder: FilePath,
    *,
    resume: bool = False,
    device: DeviceLike = None,
    progress: ReportProgress | None = None,
) -> FragmentSet:
    """Split frames into fragments, and write a pose graph and a point cloud for each.

    Consecutive frames are aligned by odometry. A pair that fails ends the fragment. Keyframes with overlapping views
    are aligned as loop closures, and a pose graph gives the poses. The cloud is from a TSDF volume.

    Args:
        source: Frames with random access. Each is read at least twice.
        config: The ReconstructionConfig.
        folder: Job folder; created if missing.
        resume: Keep finished fragments whose frames, configuration and files are unchanged.
        device: Compute device; None: the CPU.
        progress: Called with ("frames", done, all).

    Returns:
        The fragments, and the frames in none of them with the reason (no depth, unreadable, too few connected frames).
        If all runs are too short, the longest is kept.

    Raises:
        TypeError: Wrong type of source or configuration.
        ValueError: No frame.
        FileError: A file cannot be written. Finished fragments stay, and `resume` continues.
        DeviceError: No such device.

    Notes:
        Keeps one fragment's keyframes in memory. Files are written atomically. Bitwise reproducible, resumed or not.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.datasets.scenes.room import room_sequence
        >>> frames = room_sequence(300, width=80, height=60)
        >>> config = loom.rgbd.ReconstructionConfig(n_frames_per_fragment=6, depth_max=4.0)
        >>> class First:
        ...     intrinsic, depth_scale, read = frames.intrinsic, frames.depth_scale, frames.read
        ...     def __len__(self): return 9
        >>> from pointloom.rgbd.reconstruction.fragments import make_fragments
        >>> found = make_fragments(First(), config, "room")
        >>> [len(fragment) for fragment in found.fragments], found.lost
        ([6, 3], [])
    """
    job, where = JobFiles.make(folder, config), resolve_device(device)
    frames, report_progress = Frames(source, config), check_progress(progress)
    settings = _settings_of(frames)
    fragments, lost = _read_done(job, frames, settings) if resume else ([], [])
    resumed, start = len(fragments), Start()
    if fragments:
        last = fragments[-1]
        velocity = _result_of(job, last.number)["velocity"]
        start = Start(last.number + 1, int(last.indices[-1]) + 1, np.array(velocity), last.made_from)
    _forget(job, resumed)
    builder = DraftBuilder(frames, settings, where, start, report_progress)
    with contextlib.closing(builder.drafts()) as drafts:
        for draft in drafts:
            before = [frame for frame in builder.lost if frame.index < draft.indices[-1]]
            fragments.append(_finish(draft, frames, job, where, before))
    everything = sorted([*lost, *builder.lost], key=lambda frame: frame.index)
    return FragmentSet(fragments, everything, resumed)


def _settings_of(frames: Frames) -> dict[str, Any]:
    config, camera = frames.config, frames.intrinsic
    sizes = {name: getattr(config, name) for name in SETTINGS}
    lens = [camera.width, camera.height, camera.fx, camera.fy, camera.cx, camera.cy]
    return sizes | {"voxel": config.fragment_voxel, "depth_scale": frames.depth_scale, "camera": lens}


def _finish(draft: Draft, frames: Frames, job: JobFiles, device: DeviceLike, lost: Sequence[LostFrame]) -> Fragment:
    """Close the loops of a draft, fuse its frames, and write its files, the record last."""
    graph, tried = _close_loops(draft, frames)
    solved = _optimize(graph, frames.config)
    aligned = sum(edge.uncertain for edge in graph.edges)
    loops = tried, aligned, sum(edge.uncertain for edge in solved.edges)
    poses = np.array([node.pose for node in solved.nodes])
    volume = TSDFVolume(voxel_size=frames.config.fragment_voxel, color=draft.colored, device=device)
    fuse_frames(frames, draft.indices, poses, volume)  # frames that are now unreadable: their neighbors saw the same
    cloud, number = cloud_of(volume), draft.number
    paths = job.fragment_graph(number), job.fragment_graph_optimized(number), job.fragment_cloud(number)
    write_pose_graph(paths[0], graph)
    write_pose_graph(paths[1], solved)
    write_point_cloud(paths[2], cloud)
    fragment = Fragment(
        number,
        np.array(draft.indices, np.int64),
        draft.names,
        poses,
        draft.joint,
        draft.broke,
        loops,
        draft.colored,
        paths[2],
        draft.made_from,
    )
    result = _to_json(fragment) | {"velocity": draft.velocity.tolist()}
    result |= {"lost": [[frame.index, frame.name, frame.reason] for frame in lost]}
    write_record(job.record(STAGE, number), STAGE, draft.made_from, files_below(job.root, paths), result)
    return fragment


def _close_loops(draft: Draft, frames: Frames) -> tuple[PoseGraph, int]:
    edges = [
        make_edge(i + 1, i, result.transformation, result.information, uncertain=False)
        for i, result in enumerate(draft.motions)
    ]
    candidates = find_candidates(draft.keyframes, draft.poses, frames.intrinsic)
    for source, target, T in candidates:
        b, a = draft.keyframes[source], draft.keyframes[target]
        result = align(frames.config, b.frame, a.frame, T)
        if result.reliable:
            edges.append(make_edge(b.index, a.index, result.transformation, result.information, uncertain=True))
    draft.keyframes.clear()  # frees their pyramids
    return PoseGraph([PoseGraphNode(pose) for pose in draft.poses], edges), len(candidates)


def make_edge(source: int, target: int, T_target_source: Matrix, information: Matrix, *, uncertain: bool) -> Any:
    """A pose graph edge from a registration, whose information refers to the target."""
    A = adjoint_of(T_target_source)  # the edge's matrix is in source coordinates
    matrix = matmul(A.T, information, A)
    return PoseGraphEdge(source, target, T_target_source, (matrix + matrix.T) / 2, uncertain)


def _optimize(graph: PoseGraph, config: ReconstructionConfig) -> PoseGraph:
    option = GlobalOptimizationOption(
        max_correspondence_distance=config.depth_diff_max,
        edge_prune_threshold=MIN_LOOP_CONFIDENCE,
        preference_loop_closure=config.preference_loop_closure_odometry,
        reference_node=0,
    )
    return global_optimization(graph, option=option)


def _to_json(fragment: Fragment) -> dict[str, Any]:
    joint = fragment.joint
    hung = None if joint is None else [joint.fragment, joint.T_last_first.tolist(), joint.skipped]
    return {
        "frames": fragment.indices.tolist(),
        "names": fragment.names,
        "poses": fragment.poses.tolist(),
        "joint": hung,
        "broke": fragment.broke,
        "loops": list(fragment.loops),
        "colored": fragment.colored,
    }


is_lost = row_of(is_count, is_text, is_text)  # index, name and reason of a lost frame


def _is_result(number: int, value: Any) -> bool:
    """True for the result in the record of a fragment."""
    is_joint = optional(row_of(below(number), is_pose, is_count))
    checks: Checks = {
        "frames": is_ascending, "names": list_of(is_text), "poses": list_of(is_pose), "joint": is_joint,
        "broke": is_text, "loops": list_of(is_count, 3), "colored": is_flag, "velocity": is_pose,
        "lost": list_of(is_lost),
    }  # fmt: skip
    return has_fields(checks)(value) and 0 < len(value["frames"]) == len(value["names"]) == len(value["poses"])


def _read_result(job: JobFiles, number: int) -> dict[str, Any] | None:
    return read_record(job.record(STAGE, number), STAGE, job.root, partial(_is_result, number))


def _result_of(job: JobFiles, number: int) -> dict[str, Any]:
    result = _read_result(job, number)
    assert result is not None  # it was read just now
    return result


def read_fragments(job: JobFiles) -> list[Fragment]:
    fragments = []
    while True:
        number = len(fragments)
        result = _read_result(job, number)
        if result is None or (fragments and result["frames"][0] <= fragments[-1].indices[-1]):
            return fragments
        fragments.append(_from_json(number, result, job))


def digest_of_all(fragments: Sequence[Fragment]) -> str:
    return digest_of([fragment.made_from for fragment in fragments])


def fragments_in(job: JobFiles) -> list[Fragment]:
    fragments = read_fragments(job)
    if not fragments:
        raise FileError(job.root, "contains no fragments", remedy="Run make_fragments with this folder first")
    return fragments


def _from_json(number: int, result: dict[str, Any], job: JobFiles) -> Fragment:
    joint = result["joint"]
    return Fragment(
        number,
        np.array(result["frames"], np.int64),
        result["names"],
        np.array(result["poses"]),
        None if joint is None else Joint(joint[0], np.array(joint[1]), joint[2]),
        result["broke"],
        (result["loops"][0], result["loops"][1], result["loops"][2]),
        result["colored"],
        job.fragment_cloud(number),
        result["made_from"],
    )


def _read_done(job: JobFiles, frames: Frames, settings: dict[str, Any]) -> tuple[list[Fragment], list[LostFrame]]:
    done, lost, before, first = [], [], "", 0
    for fragment in read_fragments(job):
        last = int(fragment.indices[-1])
        if last >= frames.count:
            break
        digests = [frames.digest(i) for i in range(first, last + 1)]
        digests.append(frames.digest(last + 1) if last + 1 < frames.count else "")
        if digest_of_fragment(settings, before, digests) != fragment.made_from:
            break
        done.append(fragment)
        lost_entries = _result_of(job, fragment.number)["lost"]
        lost += [LostFrame(*entry) for entry in lost_entries if first <= entry[0] <= last]
        before, first = fragment.made_from, last + 1
    return done, lost


def _forget(job: JobFiles, number: int) -> None:
    """Remove outdated fragments from a number on, their records first."""
    for record in sorted(job.record(STAGE, 0).parent.glob(f"{STAGE}_*.json"), reverse=True):
        digits = record.stem.removeprefix(f"{STAGE}_")
        if digits.isdecimal() and int(digits) >= number:
            record.unlink()
            old = int(digits)
            for path in (job.fragment_cloud(old), job.fragment_graph(old), job.fragment_graph_optimized(old)):
                path.unlink(missing_ok=True)


MAX_LINK_FRAMES = 30  # maximum frames between two linked fragments: a second


@dataclass(frozen=True, eq=False)
class Joint:
    """Odometry link from the last frame of an earlier fragment to the first of this one, across `skipped` frames."""

    fragment: int
    T_last_first: Matrix
    skipped: int


@dataclass(eq=False)
class Draft:
    """Consecutive frames before loop closure; `motions` are the alignments, `velocity` the predicted next motion."""

    number: int
    indices: list[int] = field(default_factory=list)
    names: list[str] = field(default_factory=list)
    poses: list[Matrix] = field(default_factory=list)
    motions: list[OdometryResult] = field(default_factory=list)
    keyframes: list[Keyframe] = field(default_factory=list)
    colored: bool = True
    joint: Joint | None = None
    broke: str = ""
    made_from: str = ""
    velocity: Matrix = field(default_factory=lambda: np.eye(4))

    def __len__(self) -> int:
        return len(self.indices)


@dataclass(frozen=True, eq=False)
class Start:
    """The state after the last finished fragment, where processing continues."""

    number: int = 0
    index: int = 0
    velocity: Matrix = field(default_factory=lambda: np.eye(4))
    made_from: str = ""


def digest_of_fragment(settings: dict[str, Any], before: str, digests: list[str]) -> str:
    return digest_of([settings, before, digests])


class DraftBuilder:
    """Iterates through frames and yields drafts of fragments; `lost` grows meanwhile."""

    def __init__(
        self,
        frames: Frames,
        settings: dict[str, Any],
        device: DeviceLike,
        start: Start,
        report_progress: ReportProgress,
    ):
        self.frames, self.settings, self.device, self.start = frames, settings, device, start
        self.report_progress = report_progress
        self.config: ReconstructionConfig = frames.config
        self.lost: list[LostFrame] = []
        self.number, self.made_from, self._first = start.number, start.made_from, start.index
        self._digests: dict[int, str] = {}  # frames after the last fragment
        self._draft: Draft | None = None
        self._previous: tuple[OdometryFrame, int] | None = None  # the previous frame, if it can be aligned
        self._anchor: tuple[OdometryFrame, int, int] | None = None  # last frame of the last fragment, its index, number
        self._velocity = start.velocity
        self._spare: Draft | None = None  # the longest run that is too short, while there is no fragment

    def drafts(self) -> Generator[Draft, None, None]:
        begin, count = self.start.index, self.frames.count
        if self.start.number:
            last = self.prepare(self.frames.read(begin - 1))
            self._previous, self._anchor = (last, begin - 1), (last, begin - 1, self.start.number - 1)
        self.report_progress("frames", begin, count)
        with self.frames.closing(range(begin, count)) as frames:
            for frame in frames:
                self._digests[frame.index] = frame.digest
                yield from self._take(frame)
                self.report_progress("frames", frame.index + 1, count)
        yield from self._close("the frames end")
        if self._spare is not None:
            draft, self._spare = self._spare, None
            self.lost = [lost for lost in self.lost if lost.index not in draft.indices]
            yield self._finished(draft)

    def prepare(self, frame: ReadFrame) -> OdometryFrame:
        assert frame.depth is not None
        return OdometryFrame(
            frame.depth, self.frames.intrinsic, color=frame.color, depth_max=self.config.depth_max, device=self.device
        )

    def _take(self, frame: ReadFrame) -> Generator[Draft, None, None]:
        """Add a frame to the open draft, or close the draft and begin another."""
        if frame.depth is None:
            self.lost.append(LostFrame(frame.index, frame.name, frame.reason))
            yield from self._close(f"{frame.name}: {frame.reason}")
            self._previous = None
            return
        current = self.prepare(frame)
        result, reason = None, "there is no previous frame"
        if self._previous is not None:
            result = self._follow(current, self._previous[0])
            reason = "; ".join(result.warnings)
        if result is not None and result.reliable and self._draft and len(self._draft) < self._limit:
            self._append(frame, current, result)
        else:
            succeeded = result is not None and result.reliable
            yield from self._close("" if succeeded else f"{frame.name} cannot be aligned with it: {reason}")
            self._begin(frame, current, result if succeeded else None, reason)
        self._previous = current, frame.index

    @property
    def _limit(self) -> int:
        return self.config.n_frames_per_fragment

    def _follow(self, current: OdometryFrame, previous: OdometryFrame) -> OdometryResult:
        """Align with the previous frame, starting from the predicted motion or else from no motion."""
        result = align(self.config, current, previous, self._velocity)
        if not result.reliable and not np.array_equal(self._velocity, np.eye(4)):
            result = align(self.config, current, previous, np.eye(4))
        return result

    def _append(self, frame: ReadFrame, current: OdometryFrame, result: OdometryResult) -> None:
        draft = self._draft
        assert draft is not None
        self._velocity = np.asarray(result.transformation)
        draft.motions.append(result)
        self._add(draft, frame, current, matmul(draft.poses[-1], result.transformation))

    def _add(self, draft: Draft, frame: ReadFrame, current: OdometryFrame, pose: Matrix) -> None:
        if len(draft) % self.config.n_keyframes_per_n_frame == 0:
            assert frame.depth is not None
            draft.keyframes.append(Keyframe.make(len(draft), current, frame.depth, self.frames.intrinsic))
        draft.indices.append(frame.index)
        draft.names.append(frame.name)
        draft.poses.append(pose)
        draft.colored = draft.colored and frame.color is not None

    def _begin(self, frame: ReadFrame, current: OdometryFrame, result: OdometryResult | None, reason: str) -> None:
        """Begin a draft, linked to the previous fragment if odometry succeeded."""
        draft = Draft(self.number, broke="" if result is not None else reason)
        if result is not None and self._anchor is not None and self._anchor[1] == frame.index - 1:
            self._velocity = np.asarray(result.transformation)
            draft.joint = Joint(self._anchor[2], self._velocity, 0)
        else:
            self._velocity = np.eye(4)
            draft.joint = self._bridge(frame, current)
        self._add(draft, frame, current, np.eye(4))
        self._draft = draft

    def _bridge(self, frame: ReadFrame, current: OdometryFrame) -> Joint | None:
        """Align a frame with the end of the previous fragment across skipped frames."""
        if self._anchor is None or not 1 < frame.index - self._anchor[1] <= MAX_LINK_FRAMES:
            return None
        result = align(self.config, current, self._anchor[0], np.eye(4))
        if not result.reliable:
            return None
        return Joint(self._anchor[2], np.asarray(result.transformation), frame.index - self._anchor[1] - 1)

    def _close(self, reason: str) -> Generator[Draft, None, None]:
        draft, self._draft = self._draft, None
        if draft is None:
            return
        draft.velocity = self._velocity
        if len(draft) >= self.config.n_frames_least:
            self._spare = None
            if self._previous is not None:
                self._anchor = self._previous[0], draft.indices[-1], draft.number
            yield self._finished(draft)
            return
        few = f"{len(draft)} frame{'s' * (len(draft) > 1)} unconnected, {self.config.n_frames_least} needed"
        before = f"; {draft.broke}" if draft.broke else ""
        behind = f"; {reason}" if reason else ""
        for index, name in zip(draft.indices, draft.names, strict=True):
            self.lost.append(LostFrame(index, name, f"{few}{before}{behind}"))
        if self.number == 0 and (self._spare is None or len(draft) > len(self._spare)):
            self._spare = draft

    def _finished(self, draft: Draft) -> Draft:
        last = draft.indices[-1]
        decided = [self._digests[i] for i in range(self._first, last + 1)] + [self._digests.get(last + 1, "")]
        draft.made_from = self.made_from = digest_of_fragment(self.settings, self.made_from, decided)
        self._first = last + 1
        self._digests = {index: digest for index, digest in self._digests.items() if index > last}
        self.number += 1
        return draft


def align(
    config: ReconstructionConfig, source: OdometryFrame, target: OdometryFrame, T_target_source: Matrix
) -> OdometryResult:
    """Odometry between two frames with the configured method. Depth only if one has no color."""
    method = config.odometry_method if source.has_color and target.has_color else "point_to_plane"
    return align_frames(source, target, T_target_source, method=method.replace("_", "-"))


SAMPLED_PIXELS = 300  # sampled depth pixels per keyframe
MIN_SHARED_FRACTION = 0.35  # minimum common fraction. Open3D uses 0.3 between fragments
SAME_DEPTH = 0.1  # relative depth difference beyond which a sample is occluded
MAX_LOOPS = 3  # per keyframe: the most distant in time, and its neighbor


@dataclass(frozen=True, eq=False)
class Keyframe:
    """A candidate for loop closures, with sampled `points`, float64 [k, 3] [m], and `depths` at every `step` pixels."""

    index: int
    frame: Any
    points: Matrix
    depths: NDArray[np.float32]
    step: int

    @classmethod
    def make(cls, index: int, frame: object, depth: NDArray[np.float32], intrinsic: PinholeCameraIntrinsic) -> Keyframe:
        step = max(1, min(depth.shape) // 60)
        depths = depth[::step, ::step].copy()
        rows, columns = np.nonzero(depths)
        chosen = slice(None, None, max(1, len(rows) // SAMPLED_PIXELS))
        rows, columns = rows[chosen], columns[chosen]
        z = depths[rows, columns].astype(np.float64)
        x = (columns * step - intrinsic.cx) / intrinsic.fx * z
        y = (rows * step - intrinsic.cy) / intrinsic.fy * z
        return cls(index, frame, np.stack([x, y, z], axis=1), depths, step)

    def fraction_seen_by(self, other: Keyframe, T_other_self: Matrix, intrinsic: PinholeCameraIntrinsic) -> float:
        """Fraction of the points that another keyframe sees without occlusion."""
        points = matmul(self.points, T_other_self[:3, :3].T) + T_other_self[:3, 3]
        points = points[points[:, 2] > 0]
        z = points[:, 2]
        column = np.rint((points[:, 0] / z * intrinsic.fx + intrinsic.cx) / other.step).astype(np.int64)
        row = np.rint((points[:, 1] / z * intrinsic.fy + intrinsic.cy) / other.step).astype(np.int64)
        height, width = other.depths.shape
        inside = (column >= 0) & (column < width) & (row >= 0) & (row < height)
        there = other.depths[row[inside], column[inside]]
        seen = (there > 0) & (np.abs(z[inside] - there) <= SAME_DEPTH * there)
        return float(seen.sum()) / max(len(self.points), 1)


def find_candidates(
    keyframes: list[Keyframe], poses: list[Matrix], intrinsic: PinholeCameraIntrinsic
) -> list[tuple[int, int, Matrix]]:
    candidates = []
    for b, source in enumerate(keyframes):
        chosen = []
        for a, target in enumerate(keyframes[:b]):
            T = matmul(invert_pose(poses[target.index]), poses[source.index])
            if source.index - target.index < 2:
                continue  # the pair of odometry
            if min(_fractions(source, target, T, intrinsic)) >= MIN_SHARED_FRACTION:
                chosen.append((b, a, T))
        candidates += chosen if len(chosen) <= MAX_LOOPS else [*chosen[: MAX_LOOPS - 1], chosen[-1]]
    return candidates


def _fractions(source: Keyframe, target: Keyframe, T: Matrix, intrinsic: PinholeCameraIntrinsic) -> tuple[float, float]:
    back = target.fraction_seen_by(source, invert_pose(T), intrinsic)
    return source.fraction_seen_by(target, T, intrinsic), back

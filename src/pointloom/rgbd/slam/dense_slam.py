"""Dense RGB-D SLAM without given poses: camera trajectory and surface."""

from __future__ import annotations

import dataclasses
import operator
from collections import deque
from collections.abc import Iterable
from typing import Any, NoReturn

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.depth_range import DEPTH_MAX, DEPTH_SCALE
from ...cameras.frame_check import FrameCheck
from ...cameras.trajectory import Trajectory
from ...core.checks import check_count, check_progress, check_rigid, check_seed
from ...core.devices import DeviceLike
from ...core.observers import report, unwatched
from ...core.progress import ReportProgress
from ...core.serialized import Serialized
from ...kernels.linear_algebra import matmul
from ...kernels.memory import download
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.volume.tsdf import RayCast, TSDFVolume
from ...pcd.cloud import PointCloud
from ...registration.pose_errors import PoseCovariance
from ...registration.rigid import invert_pose
from .camera_check import FocalCheck, assess_camera, view_of
from .fixed_parts import FixedParts
from .foreground import Foreground
from .frame_checks import MIN_DEPTH, depth_fraction, is_determined, judge_drift
from .frames import SensorFrame
from .keyframes import Keyframes
from .loop_closure import LoopClosure
from .loops import close_loops, corrected_trajectory, fuse_submaps
from .map_joins import MapJoin
from .map_merging import Joining
from .maps import FusedFrame, Maps, SlamMap, map_sizes
from .model import SlamModel
from .results import TrackingResult, with_pose
from .stream_check import DOUBTFUL, STALE, WINDOW_FRAMES, StreamCheck
from .submaps import SubmapRecorder
from .tracker import Tracker, clean_pose

Pose = NDArray[np.float64]

# Fused frames that can be withdrawn, 2 MB each at 640 x 480. A time offset is detected after 20 to 25 frames with
# rotation. Streams of moving cameras were known to be synchronized at most 63 frames ago, cameras at rest are not.
MAX_UNCHECKED = 90
REMAINS = f"it remains in the model: only the last {MAX_UNCHECKED} fused frames can be removed"
MAX_RESTART_FRAMES = 60  # frames in which a model with moving objects restarts: two seconds at 30 Hz


class DenseSLAM(Serialized):
    """Frame-to-model tracking with a status for each frame and relocalization of a lost camera.

    Each frame is aligned by surface and brightness with the model rendered at the constant-velocity prediction. Only
    tracked frames are fused. A lost camera is relocalized from similar keyframes or by shape.

    Args:
        intrinsic: The camera of all frames.
        voxel_size: Voxel edge [m].
        truncation: Truncation distance [m]; None: 4 voxels.
        T_init: T_world_camera of the first camera; None: the identity.
        depth_scale: Integer depth units per meter.
        depth_max: Maximum depth used [m].
        leave_out_moving: Exclude pixels of objects that appeared within the last second from the model.
        submap_frames: Frames per submap (typically 100). None keeps no submaps, and `close_loops` raises.
        seed: Seed of the keyframe recognition.
        device: "cpu", "cuda:0", "auto"; None: the CPU.

    Attributes:
        results: A TrackingResult for each frame, in order. Its `map` is the number of the map that the pose refers to.
        stream: The StreamCheck of color against depth; `stream.problem` is the reason if the last
            frame's do not match, `stream.problems` those of all frames.
        foreground: The Foreground: detection of near objects that move independently and are excluded.
        fixed_parts: The FixedParts: detection of objects fixed to the camera, which are excluded.
        images: The FrameCheck of depth and color: `images.warnings` reports mirrored or unregistered images and a wrong
            depth scale of the frames so far.

    Raises:
        ValueError: A size is not positive, or a pose is not rigid.
        TypeError: `intrinsic` has another type.

    Notes:
        A camera that is lost for long starts a new map with its own coordinates. Maps are joined when the camera moves
        from one into another, or by `join_maps`; until then `trajectory`, `volume` and the surface are those of the
        largest map.
        Bitwise reproducible for any number of threads. Newcombe et al., "KinectFusion", ISMAR 2011; relocalization:
        Glocker et al. 2015.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> v, u = np.mgrid[:48, :64]
        >>> frame = loom.RGBDImage(np.zeros((48, 64), np.uint8), 1.0 + 0.1 * np.sin(u / 5) * np.cos(v / 7))
        >>> slam = loom.rgbd.DenseSLAM(camera, voxel_size=0.02)
        >>> [result.status for result in slam.run([frame, frame, frame])]
        ['tracked', 'tracked', 'tracked']
        >>> slam.trajectory
        Trajectory(3 poses, ids)
    """

    def __init__(
        self,
        intrinsic: PinholeCameraIntrinsic,
        *,
        voxel_size: float = 0.01,
        truncation: float | None = None,
        T_init: ArrayLike | None = None,
        depth_scale: float = DEPTH_SCALE,
        depth_max: float = DEPTH_MAX,
        leave_out_moving: bool = True,
        submap_frames: int | None = None,
        seed: int = 0,
        device: DeviceLike = None,
    ):
        sizes: dict[str, Any] = {
            "voxel_size": voxel_size, "truncation": truncation, "depth_max": depth_max, "device": device
        }  # fmt: skip
        self._model_options = {**sizes, "depth_scale": depth_scale, "leave_out_moving": leave_out_moving}
        self._intrinsic, self._T_init, self._sizes = intrinsic, T_init, sizes
        self._seed, self._submap_frames = check_seed(seed), submap_frames
        if submap_frames is not None:
            check_count("submap_frames", submap_frames, minimum=2)
        self.results: list[TrackingResult] = []
        self.stream, self.foreground, self.fixed_parts = StreamCheck(), Foreground(), FixedParts()
        self._latest: tuple[Any, SensorFrame] | None = None
        self._unchecked: deque[FusedFrame] = deque(maxlen=MAX_UNCHECKED)
        self._doubted: dict[int, FusedFrame | None] = {}  # frames that wait for the comparison of later ones
        self._maps = Maps(self._new_map)
        self.images = FrameCheck(intrinsic, depth_scale)
        self._joining = Joining(self._maps, self.results, self._seed)

    def _new_map(self, number: int) -> SlamMap:
        T_init = None if number else self._T_init
        model = SlamModel(self._intrinsic, T_init=T_init, **self._model_options)
        return SlamMap(number, model, Keyframes(model.device, self._seed), self._new_recorder(model))

    def _new_recorder(self, model: SlamModel) -> SubmapRecorder | None:
        if self._submap_frames is None:
            return None
        sizes = {**self._sizes, "truncation": model.volume.truncation, "depth_max": model.depth_max}
        return SubmapRecorder(self._intrinsic, **sizes, depth_scale=1.0, frames=self._submap_frames)

    def __repr__(self) -> str:
        counts = ", ".join(f"{n} {status}" for status, n in self.status_counts.items() if n)
        return f"DenseSLAM({counts or 'no frames'}, {len(self.keyframes)} keyframes, {self.volume!r})"

    def __reduce__(self) -> NoReturn:
        raise TypeError("DenseSLAM cannot be copied or pickled: keep its results (system.trajectory, system.volume)")

    @property
    def model(self) -> SlamModel:
        """The Model of the current map."""
        return self._maps.here.model

    @property
    def keyframes(self) -> Keyframes:
        """The Keyframes of the current map."""
        return self._maps.here.keyframes

    @property
    def _tracker(self) -> Tracker:
        return self._maps.here.tracker

    @property
    def joins(self) -> list[MapJoin]:
        """For each pair of maps with a relative pose: the evidence, and the reason if it was rejected."""
        return self._joining.judged

    @property
    def map_sizes(self) -> dict[int, int]:
        """Number of frames with a pose in each map, by map number, the largest first."""
        return map_sizes(self.results)

    @property
    def volume(self) -> TSDFVolume:
        """The volume of the largest map, to which `trajectory` and the surface refer."""
        return self._largest.model.surface_volume

    @property
    def _largest(self) -> SlamMap:
        sizes = self.map_sizes
        return max(self._maps.searchable, key=lambda known: (sizes.get(known.number, 0), -known.number))

    @property
    def status_counts(self) -> dict[str, int]:
        """Number of tracked, uncertain and lost frames."""
        statuses = [result.status for result in self.results]
        return {status: statuses.count(status) for status in ("tracked", "uncertain", "lost")}

    @property
    def trajectory(self) -> Trajectory:
        """The poses of the frames of the largest map that are not lost. See `trajectory_of` for other maps.

        Its ids are (frame number, frame number, 1 if tracked or 0 if uncertain). Timestamps if all frames have them.
        """
        return self.trajectory_of(next(iter(self.map_sizes), 0))

    def trajectory_of(self, number: int) -> Trajectory:
        """`trajectory` of one map in its own coordinates. Empty if there is no such map.

        Raises:
            TypeError, ValueError: `number` is not an integer >= 0.
        """
        check_count("number", number, minimum=0)
        results = [result for result in self.results if result.pose is not None and result.map == number]
        poses = np.array([result.pose for result in results]).reshape(-1, 4, 4)
        ids = np.array([(r.index, r.index, int(r.is_tracked)) for r in results], np.int64).reshape(-1, 3)
        times = [result.timestamp for result in results]
        return Trajectory(poses, None if None in times or not times else np.array(times, np.float64), ids)

    @property
    def pose_covariances(self) -> tuple[PoseCovariance, ...]:
        """Covariance of each pose of `trajectory` relative to the first pose of its map, as accumulated by tracking.

        The order is rotation [rad], translation [m], along the axes of the map. The center is the camera. The first
        pose has zero. `close_loops` moves the covariances with the poses but does not reduce them: the pose graph has
        no marginal covariances. Lost frames have no pose. See `TrackingResult.pose_covariance` for all frames.
        """
        largest = next(iter(self.map_sizes), 0)
        found = [result.pose_covariance for result in self.results if result.map == largest]
        return tuple(covariance for covariance in found if covariance is not None)

    def track(self, frame: object) -> TrackingResult:
        """Estimate the pose of a frame without changing the model. The next frame is expected to follow this one.

        Args:
            frame: Object with `depth`, optional `color`, `timestamp` [s], `name`. The first with depth is at T_init.

        Raises:
            TypeError: No depth, or a wrong element type.
            ValueError: The image size is not the camera's.
        """
        prepared = self.model.prepare(frame)
        self.images.add(getattr(frame, "depth", None), getattr(frame, "color", None))
        with unwatched():  # a lost camera may be found by registration
            result = self._track(prepared)
        if result.warnings == (DOUBTFUL,):
            self._doubted[len(self.results)] = None
        self.results.append(result)
        self._latest = frame, prepared
        report("track", slam=self, result=result)
        return result

    def integrate(self, frame: object) -> bool:
        """Fuse the last tracked frame if its pose is accepted. Returns True if it was fused.

        Raises:
            ValueError: No frame was tracked yet, or the last one was fused already.
        """
        if not self.results or self.results[-1].fused or self._doubted.get(self.results[-1].index):
            raise ValueError(
                "frame: expected the last tracked frame, which can be integrated once; call track with it first"
            )
        assert self._latest is not None
        given, prepared = self._latest
        if given is not frame:  # the same images in another array
            prepared = self.model.prepare(frame)
        result = self.results[-1]
        is_doubtful = result.index in self._doubted
        if result.pose is None or not (result.is_tracked or result.has_drifted or is_doubtful):
            return False
        depth, pixels = self.model.fuse(prepared, result.pose)
        here = self._maps.here
        fused = FusedFrame(result.index, here, depth, pixels, result.pose)
        if here.recorder is not None:
            with unwatched():
                record_frame(here.recorder, prepared, depth, pixels, result)
        if is_doubtful:  # only tracking uses it until the next frames are compared
            here.withdraw(fused)
            self._doubted[result.index] = fused
            return False
        if prepared.pixels is not None:  # without color the streams cannot be compared
            self._unchecked.append(fused)
        is_new = self.keyframes.is_new_view(result.pose)
        if is_new:
            self.keyframes.add(prepared.pyramid, result.pose, result.index)
            self._tracker.drift.keep(prepared.pyramid)
        if self.keyframes.views.is_new(result.pose):
            self.keyframes.views.add(result.pose, result.index, view_of(prepared, self.stream.view))
        self.results[-1] = dataclasses.replace(result, fused=True)
        if self._maps.others and not self._maps.is_on_trial:
            with unwatched():
                self._joining.look(prepared, result.pose, is_new)
        return True

    def step(self, frame: object) -> TrackingResult:
        """Track a frame, and fuse it if it is tracked.

        Raises:
            TypeError, ValueError: As `track`.
        """
        self.track(frame)
        self.integrate(frame)
        return self.results[-1]

    def run(self, source: Iterable[Any], *, progress: ReportProgress | None = None) -> list[TrackingResult]:
        """Process all frames of a source in order.

        Args:
            source: Iterable of frames as of `track`: a data set, a live source, a list, a generator.
            progress: Called with ("tracking", frames done, frames in total or 0 if unknown).

        Returns:
            The results of these frames.

        Raises:
            TypeError, ValueError: As `track`. Earlier frames stay processed.
        """
        report_progress, first = check_progress(progress), len(self.results)
        try:
            frames = iter(source)
            count = operator.length_hint(source, 0)
        except TypeError as error:
            kind = type(source).__name__
            raise TypeError(f"source: expected an iterable of frames, got {kind}") from error
        for frame in frames:
            self.step(frame)
            report_progress("tracking", len(self.results) - first, count)
        return self.results[first:]

    def close_loops(self, *, progress: ReportProgress | None = None) -> LoopClosure:
        """Close loops between submaps, and correct poses, keyframes and the model; may be called during or after a run.

        Maps are joined first (`join_maps`). Each model is fused again from its submaps.

        Args:
            progress: Called with (stage, steps done, steps in total).

        Returns:
            The accepted and rejected loops of the largest map.

        Raises:
            ValueError: No submaps were kept (`submap_frames`), or no frame was fused yet.
        """
        if self._submap_frames is None:
            raise ValueError("submap_frames: no submaps were recorded; create the DenseSLAM with submap_frames=100")
        if not self.volume.frame_count:
            raise ValueError("submap_frames: no frame was fused yet, so there is no submap; call run or step first")
        report_progress = check_progress(progress)
        self.join_maps()
        self._unchecked.clear()  # the poses change
        self._doubted = dict.fromkeys(self._doubted)
        largest = self._largest
        with unwatched():
            for other in self._maps.searchable:
                if other is not largest and other.model.surface_volume.frame_count:
                    close_and_correct(other, self.results, report_progress)
            closed = close_and_correct(largest, self.results, report_progress)
        report("loops", slam=self, closure=closed)
        return closed

    def join_maps(self) -> list[MapJoin]:
        """Estimate the relative poses of the maps, and join them.

        Submaps, or complete maps if no submaps are kept, are registered without an initial pose. A pose is accepted if
        `registration` accepts it and both maps agree as seen from the cameras of either. Joined maps get the lower
        number, and poses in `results` are updated.

        Returns:
            The attempts of this call, each with the reason if rejected. Empty if there is one map.
        """
        with unwatched():
            return self._joining.search()

    def check_camera(self) -> FocalCheck | None:
        """Check whether stored views of the largest map fit better with another camera. See `check_focal`.

        Returns:
            None if the camera rotated too little, or the surfaces do not determine its focal length.
        """
        views = self._largest.keyframes.views
        return assess_camera(views.cells, views.poses, self._intrinsic)

    def render(self, T_world_camera: ArrayLike) -> RayCast:
        """Render the current map from a pose in that map. See `SlamModel.render`."""
        return self.model.render(check_rigid("T_world_camera", T_world_camera))

    def extract_triangle_mesh(self, weight_threshold: float = 3.0) -> TriangleMesh:
        """The surface of the largest map as a mesh. See `TSDFVolume.extract_triangle_mesh`."""
        return self._largest.model.extract_triangle_mesh(weight_threshold)

    def extract_point_cloud(self, weight_threshold: float = 3.0) -> PointCloud:
        """The surface of the largest map as points. See `TSDFVolume.extract_point_cloud`."""
        return self._largest.model.extract_point_cloud(weight_threshold)

    def _track(self, frame: SensorFrame) -> TrackingResult:
        known = {"index": len(self.results), "name": frame.name, "timestamp": frame.timestamp}
        maps, warning = self._maps, self.stream.look(frame)
        if maps.is_failing() or (maps.is_on_trial and not self.model.frame_count):
            maps.give_up(self.results)
        if warning == STALE and self.model.frame_count:
            self.stream.lag.add(None, frame.timestamp)
            self._tracker.motion.missed += 1
            return TrackingResult(None, "lost", (warning,), map=maps.here.number, **known)
        is_new = self._restarts(frame) or not self.model.frame_count
        warning = self.stream.compare(frame)
        self._note_offset()
        if is_new:
            return self._begin(frame, known)
        if warning == STALE:
            self._tracker.motion.missed += 1
            return TrackingResult(None, "lost", (warning,), map=maps.here.number, **known)
        attempt, is_anew = self._tracker.locate(frame)
        attempt = attempt.with_warning(warning)
        if attempt.status == "lost":
            maps.here.tracker.motion.missed += 1
            if maps.is_on_trial:
                maps.give_up(self.results)
            elsewhere = maps.find_elsewhere(frame)
            if elsewhere is None:
                self._set_pose(None)
                lost = TrackingResult(None, "lost", attempt.warnings, map=maps.here.number, **attempt.measures, **known)
                return self._begin_anew(frame, known, lost)
            attempt, is_anew = elsewhere, True
        maps.note_tracked()
        motion, is_tracked = maps.here.tracker.motion, attempt.status == "tracked"
        self._set_pose(attempt.pose if is_tracked else None)
        has_velocity = not is_anew and is_determined(attempt.result)
        if is_tracked:
            motion.learn(attempt.result)
        motion.advance(attempt.pose, frame, is_tracked=is_tracked, is_continuous=has_velocity)
        fields = {**attempt.measures, **known, "relocalized": is_anew, "covariance": attempt.covariance}
        fields["error_covariance"] = attempt.error_covariance
        result = TrackingResult(attempt.pose, attempt.status, attempt.warnings, map=maps.here.number, **fields)
        return judge_drift(result, self.model.volume.truncation)

    def _set_pose(self, pose: Pose | None) -> None:
        self.foreground.set_pose(pose)
        self.fixed_parts.set_pose(pose)

    def _note_offset(self) -> None:
        """Withdraw earlier frames whose color and depth turn out to be apart in time, and mark them as uncertain."""
        apart = self.stream.lag.current
        first = self.stream.lag.synchronized if apart is None else apart.first
        while self._unchecked and self._unchecked[0].number < first:
            self._unchecked.popleft()
        if apart is None:
            self._clear_doubts()
            return
        withdrawn = [frame.number for frame in self._unchecked if frame.owner in self._maps.searchable]
        for frame in self._unchecked:
            if frame.number in withdrawn:
                frame.owner.withdraw(frame)
                self.results[frame.number] = dataclasses.replace(self.results[frame.number], fused=False)
        self._unchecked.clear()
        self._doubted.clear()
        for i in range(first, len(self.results)):
            if (result := self.results[i]).is_tracked or result.warnings == (DOUBTFUL,):
                warnings = (str(apart), REMAINS) if result.fused else (str(apart),)
                self.results[i] = dataclasses.replace(result, status="uncertain", warnings=warnings)

    def _clear_doubts(self) -> None:
        """Accept suspect frames if the comparison of the frames after them found no problem."""
        if self.stream.lag.is_doubtful:
            return
        for number in [n for n in self._doubted if n <= len(self.results) - WINDOW_FRAMES]:
            fused, result = self._doubted.pop(number), self.results[number]
            if result.warnings != (DOUBTFUL,):  # of a map that was discarded
                continue
            is_kept = fused is not None and fused.owner in self._maps.searchable
            accepted = dataclasses.replace(result, status="tracked", warnings=(), fused=is_kept)
            self.results[number] = judge_drift(accepted, self.model.volume.truncation)
            if fused is not None and is_kept:
                fused.owner.withdraw(fused, is_restored=True)
                known = sorted([*self._unchecked, fused], key=lambda frame: frame.number)
                self._unchecked = deque(known, MAX_UNCHECKED)

    def _restarts(self, frame: SensorFrame) -> bool:
        """True if near pixels move independently while a young model contains them, which must then restart."""
        motion = self._tracker.motion
        if not self.model.leave_out_moving or self.stream.view is None:
            return False
        expected = None if motion.pose is None or motion.missed else motion.expected(frame)
        pose = self.fixed_parts.remove(frame, self.stream.view, expected)
        layers = self.foreground.part(frame, self.stream.view, expected)
        if layers is not None and pose is None:
            pose = layers.pose
        if pose is None or self.model.frame_count > MAX_RESTART_FRAMES:
            return False
        self._maps.here.begin_again(clean_pose(pose), self._new_recorder(self.model))
        self._unchecked.clear()
        self._doubted.clear()
        return True

    def _begin(self, frame: SensorFrame, known: dict[str, Any]) -> TrackingResult:
        """The first frame with depth of a map defines the map's world."""
        here = self._maps.here
        if depth_fraction(frame.pyramid) < MIN_DEPTH:
            return TrackingResult(None, "lost", ("the image is blank, and there is no model yet",), **known)
        pose = here.model.current_frame_pose
        here.tracker.motion.advance(pose, frame, is_tracked=True, is_continuous=False)
        self._set_pose(pose)
        return TrackingResult(pose, "tracked", fitness=1.0, overlap=1.0, map=here.number, **known)

    def _begin_anew(self, frame: SensorFrame, known: dict[str, Any], lost: TrackingResult) -> TrackingResult:
        """Handle a frame that no map matches: lost, or the first of a new map if the camera was lost for long."""
        if depth_fraction(frame.pyramid) < MIN_DEPTH or not self._maps.lost():
            return lost
        self._maps.begin()
        return self._begin(frame, known)


def record_frame(
    recorder: SubmapRecorder,
    frame: SensorFrame,
    depth: NDArray[Any],
    pixels: NDArray[Any] | None,
    result: TrackingResult,
) -> None:
    height, width = frame.intrinsic.height, frame.intrinsic.width
    color = None if pixels is None else pixels.reshape((height, width, 3))
    image = depth.reshape((height, width))
    if not frame.device.is_cuda:
        image, color = download(image), None if color is None else download(color)
    recorder.add(image, result.pose, color, result.index)


def close_and_correct(known: SlamMap, results: list[TrackingResult], progress: ReportProgress) -> LoopClosure:
    """Close loops among the submaps of a map, and update everything that depends on their poses."""
    recorder, model, keyframes, motion = known.recorder, known.model, known.keyframes, known.tracker.motion
    assert recorder is not None
    submaps, seed = recorder.finish(), keyframes.seed
    closure = close_loops(submaps, seed=seed, progress=progress)
    numbers, poses = corrected_trajectory(submaps, closure.T_world_submap)
    map_results = [result for result in results if result.map == known.number]
    before = {result.index: result.pose for result in map_results if result.pose is not None}
    corrections = {n: matmul(pose, invert_pose(before[n])) for n, pose in zip(numbers.tolist(), poses, strict=True)}

    def corrected(pose: Pose, number: int) -> Pose:
        index = max(int(np.searchsorted(numbers, number, side="right")) - 1, 0)
        return clean_pose(matmul(corrections[int(numbers[index])], pose))

    for i, result in enumerate(results):
        if result.pose is not None and result.map == known.number:
            results[i] = with_pose(result, corrected(result.pose, result.index))
    for views in (keyframes, keyframes.views):
        views.poses = [corrected(T, n) for T, n in zip(views.poses, views.numbers, strict=True)]
    if motion.pose is not None:
        motion.pose = corrected(motion.pose, len(results))
    recorder.submaps = [
        dataclasses.replace(submap, T_world_submap=T) for submap, T in zip(submaps, closure.T_world_submap, strict=True)
    ]
    model._replace_volume(fuse_submaps(recorder.submaps))
    model.current_frame_pose = corrected(model.current_frame_pose, len(results))
    return closure

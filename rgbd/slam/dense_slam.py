"""A moving depth camera without poses: where it was, and the surface that it saw."""

from __future__ import annotations

import dataclasses
import operator
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.trajectory import Trajectory
from ...core.checks import check_count, check_progress, check_rigid, check_seed
from ...core.progress import ReportProgress
from ...core.watching import report, unwatched
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.volume.tsdf import RayCast, TSDFVolume
from ...pcd.cloud import PointCloud
from .corrections import close_and_correct, record_frame
from .frames import SensorFrame
from .keyframes import Keyframes
from .loops import LoopClosure
from .model import Model
from .results import TrackingResult
from .submaps import SubmapRecorder
from .tracker import Attempt, Tracker
from .verdicts import LEAST_DEPTH, depth_share, is_determined, judge_drift

Pose = NDArray[np.float64]


class DenseSLAM:
    """Frame-to-model tracking with a verdict on each frame, and recovery where the camera was lost.

    Each frame is aligned with the model as seen from where constant velocity puts the camera, by surface and
    brightness. A frame that is not firmly on the model is not fused into it. A lost camera is found again from the
    keyframes that its picture looks like or by its shape, once the model itself agrees.

    Args:
        intrinsic: The camera of all frames.
        voxel_size: Edge of a voxel [m].
        truncation: Distance at which signed distances are cut [m]; None for 4 voxels.
        T_init: The first camera's pose, T_world_camera; None for the identity.
        depth_scale: Integer units a metre.
        depth_max: Farthest depth used [m].
        leave_out_moving: Whether pixels are left out of the model that show what was not there a second ago.
        submap_frames: Frames of a submap, 100 are usual; None keeps none, and `close_loops` has nothing to close.
        seed: Chooses the tests by which keyframes are recognised.
        device: "cpu", "cuda:0", "auto"; None for the CPU.

    Attributes:
        model: The Model.
        keyframes: The Keyframes.
        results: A TrackingResult for each frame so far, in order.

    Raises:
        ValueError: Sizes that are not positive, a pose that is no rigid motion.
        TypeError: An intrinsic of another type.

    Notes:
        The same bits from run to run, for any number of threads. Newcombe et al. 2011, "KinectFusion"; Glocker et al.
        2015 for the way back.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> v, u = np.mgrid[:48, :64]
        >>> frame = loom.RGBDImage(np.zeros((48, 64), np.uint8), 1.0 + 0.1 * np.sin(u / 5) * np.cos(v / 7))
        >>> slam = loom.slam.DenseSLAM(camera, voxel_size=0.02)
        >>> [result.verdict for result in slam.run([frame, frame, frame])]
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
        depth_scale: float = 1000.0,
        depth_max: float = 4.0,
        leave_out_moving: bool = True,
        submap_frames: int | None = None,
        seed: int = 0,
        device: Any = None,
    ):
        self.model = Model(
            intrinsic, voxel_size=voxel_size, truncation=truncation, T_init=T_init, depth_scale=depth_scale,
            depth_max=depth_max, leave_out_moving=leave_out_moving, device=device,
        )  # fmt: skip
        self.keyframes = Keyframes(self.model.device, check_seed(seed))
        self.results: list[TrackingResult] = []
        self._tracker = Tracker(self.model, self.keyframes)
        self._latest: tuple[Any, SensorFrame] | None = None
        self._recorder: SubmapRecorder | None = None
        if submap_frames is not None:
            sizes: dict[str, Any] = {"voxel_size": self.volume.voxel_size, "truncation": self.volume.truncation}
            count = check_count("submap_frames", submap_frames, minimum=2)
            self._recorder = SubmapRecorder(
                intrinsic, **sizes, depth_scale=1.0, depth_max=self.model.depth_max, frames=count, device=device
            )

    def __repr__(self) -> str:
        counts = ", ".join(f"{n} {verdict}" for verdict, n in self.verdict_counts.items() if n)
        return f"DenseSLAM({counts or 'no frames'}, {len(self.keyframes)} keyframes, {self.volume!r})"

    @property
    def volume(self) -> TSDFVolume:
        """The model's volume."""
        return self.model.volume

    @property
    def verdict_counts(self) -> dict[str, int]:
        """How many frames were tracked, uncertain and lost."""
        verdicts = [result.verdict for result in self.results]
        return {verdict: verdicts.count(verdict) for verdict in ("tracked", "uncertain", "lost")}

    @property
    def trajectory(self) -> Trajectory:
        """The poses of the frames that are not lost.

        Its ids are (number of the frame, the same, 1 where it is tracked and 0 where it is uncertain); it has
        timestamps where all those frames have them.
        """
        found = [result for result in self.results if result.pose is not None]
        poses = np.array([result.pose for result in found]).reshape(-1, 4, 4)
        ids = np.array([(r.index, r.index, int(r.is_tracked)) for r in found], np.int64).reshape(-1, 3)
        times = [result.timestamp for result in found]
        return Trajectory(poses, None if None in times or not times else np.array(times, np.float64), ids)

    def track(self, frame: Any) -> TrackingResult:
        """Where a frame was taken. The model stays as it is; the next frame is expected to follow this one.

        Args:
            frame: Anything with `depth` and, where it has them, `color`, `timestamp` [s] and `name`. The first frame
                with depth stands at T_init.

        Raises:
            TypeError: No depth, or wrong element types.
            ValueError: Pictures whose size is not the camera's.
        """
        prepared = self.model.prepare(frame)
        with unwatched():  # a lost camera may be found by the registration of shapes
            result = self._track(prepared)
        self.results.append(result)
        self._latest = frame, prepared
        report("track", slam=self, result=result)
        return result

    def integrate(self, frame: Any) -> bool:
        """Fuse the frame that was tracked last, where it may be; whether it was.

        Raises:
            ValueError: No frame was tracked yet, or the last one was fused already.
        """
        if not self.results or self.results[-1].fused:
            raise ValueError("frame: track it first; only the frame that was tracked last can be integrated, once")
        assert self._latest is not None
        given, prepared = self._latest
        if given is not frame:  # the same pictures in another place
            prepared = self.model.prepare(frame)
        result = self.results[-1]
        if result.pose is None or not (result.is_tracked or result.has_drifted):
            return False
        depth, pixels = self.model.fuse(prepared, result.pose)
        if self._recorder is not None:
            with unwatched():
                record_frame(self._recorder, prepared, depth, pixels, result)
        if self.keyframes.is_new_view(result.pose):
            self.keyframes.add(prepared.pyramid, result.pose, result.index)
            self._tracker.drift.keep(prepared.pyramid)
        self.results[-1] = dataclasses.replace(result, fused=True)
        return True

    def step(self, frame: Any) -> TrackingResult:
        """Track a frame, and fuse it where it is tracked.

        Raises:
            TypeError, ValueError: As `track`.
        """
        self.track(frame)
        self.integrate(frame)
        return self.results[-1]

    def run(self, source: Iterable[Any], *, progress: ReportProgress | None = None) -> list[TrackingResult]:
        """Take all frames of a source, one after the other.

        Args:
            source: Frames, as of `track`: a data set, a live source, a list, a generator.
            progress: Called with "tracking", how many frames are done, and how many there are, 0 where the source does
                not know.

        Returns:
            The results of these frames.

        Raises:
            TypeError, ValueError: As `track`; the frames before stay taken.
        """
        tell, first = check_progress(progress), len(self.results)
        try:
            frames = iter(source)
            count = operator.length_hint(source, 0)
        except TypeError as error:
            kind = type(source).__name__
            raise TypeError(f"source: expected frames that can be iterated over, got {kind}") from error
        for frame in frames:
            self.step(frame)
            tell("tracking", len(self.results) - first, count)
        return self.results[first:]

    def close_loops(self, *, progress: ReportProgress | None = None) -> LoopClosure:
        """Bring places that were seen twice together, and move poses, keyframes and the model accordingly.

        The model is fused anew from its submaps. It may be called at the end of a run or within it.

        Args:
            progress: Called with the stage, how many of its steps are done, and how many there are.

        Returns:
            What was closed, and what was refused and why.

        Raises:
            ValueError: No submaps were kept (`submap_frames`), or no frame was fused yet.
        """
        if self._recorder is None:
            raise ValueError("submap_frames: no submaps were kept; make the DenseSLAM with submap_frames=100")
        if not self.model.frame_count:
            raise ValueError("submap_frames: no frame was fused yet, so that there is no submap")
        tell, motion = check_progress(progress), self._tracker.motion
        seed = self.keyframes.seed
        with unwatched():
            closed = close_and_correct(self._recorder, self.model, self.keyframes, motion, self.results, seed, tell)
        report("loops", slam=self, closure=closed)
        return closed

    def render(self, T_world_camera: ArrayLike) -> RayCast:
        """What the camera would see of the model from a pose; see `Model.render`."""
        return self.model.render(check_rigid("T_world_camera", T_world_camera))

    def extract_triangle_mesh(self, weight_threshold: float = 3.0) -> TriangleMesh:
        """The surface as a mesh; see `TSDFVolume.extract_triangle_mesh`."""
        return self.model.extract_triangle_mesh(weight_threshold)

    def extract_point_cloud(self, weight_threshold: float = 3.0) -> PointCloud:
        """The surface as points; see `TSDFVolume.extract_point_cloud`."""
        return self.model.extract_point_cloud(weight_threshold)

    def _track(self, frame: SensorFrame) -> TrackingResult:
        known = {"index": len(self.results), "name": frame.name, "timestamp": frame.timestamp}
        motion = self._tracker.motion
        if not self.model.frame_count:
            return self._begin(frame, known)
        attempt, is_anew = self._tracker.locate(frame)
        if attempt.verdict == "lost":
            motion.missed += 1
            return TrackingResult(None, "lost", attempt.reason, **_measures(attempt), **known)
        is_tracked = attempt.verdict == "tracked"
        tells_velocity = not is_anew and is_determined(attempt.result)
        if is_tracked:
            motion.learn(attempt.result)
        motion.advance(attempt.pose, frame, is_tracked=is_tracked, is_continuous=tells_velocity)
        said = {**_measures(attempt), **known, "relocalized": is_anew, "covariance": attempt.covariance}
        found = TrackingResult(attempt.pose, attempt.verdict, attempt.reason, **said)
        return judge_drift(found, self.volume.truncation)

    def _begin(self, frame: SensorFrame, known: dict[str, Any]) -> TrackingResult:
        """The first frame: where the world begins, once one has depth."""
        if depth_share(frame.pyramid) < LEAST_DEPTH:
            return TrackingResult(None, "lost", "the picture is blank, and there is no model yet", **known)
        pose = self.model.current_frame_pose
        self._tracker.motion.advance(pose, frame, is_tracked=True, is_continuous=False)
        return TrackingResult(pose, "tracked", fitness=1.0, overlap=1.0, **known)


def _measures(attempt: Attempt) -> dict[str, Any]:
    """The numbers of an attempt, as a TrackingResult names them."""
    names = ("fitness", "overlap", "inlier_rmse", "intensity_rmse", "smallest_eigenvalue", "iterations")
    return {name: getattr(attempt.result, name) for name in names}

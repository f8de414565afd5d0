"""A moving depth camera without poses: where it was, and the surface that it saw.

Whether colour and depth of a camera were taken at the same time: their motions, one against the other.

What the camera does moves both pictures alike. The shifts of one are held against those of the other some frames
earlier or later; where the two go together then and not when they came together, one of them is late. Slow sweeps go
together at any time, so that what counts is the tremble of a hand, after a running mean is taken away.

Whether the pictures of a depth camera are of one moment: a depth picture that came twice, colours that came late.

A stalled stream hands out its last depth picture again, bit for bit, beside colours that go on; a sensor that measures
never does so, since its noise differs. Where the colours stand still too, nothing is wrong: so do made-up frames.
"""

from __future__ import annotations

import dataclasses
import math
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
from ...kernels.linear_algebra import matmul, norm
from ...kernels.memory import download
from ...kernels.rgbd import stream_views as at
from ...kernels.rgbd.stream_views import StreamView, compare_views, view_stream
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.volume.tsdf import RayCast, TSDFVolume
from ...pcd.cloud import PointCloud
from ...registration.rigid import invert_pose
from .foreground import Foreground
from .frames import SensorFrame
from .joins import MapJoin
from .keyframes import Keyframes
from .loops import LoopClosure, close_loops, corrected_trajectory, fuse_submaps
from .map_merging import Joining
from .maps import Maps, SlamMap, map_sizes
from .model import Model
from .movers import Movers
from .results import TrackingResult
from .submaps import SubmapRecorder
from .tracker import Tracker, clean_pose
from .verdicts import LEAST_DEPTH, depth_share, is_determined, judge_drift

Pose = NDArray[np.float64]

YOUNG = 60  # frames of a model that begins again where it holds what moves: two seconds at 30 a second


class DenseSLAM:
    """Frame-to-model tracking with a status of each frame, and recovery where the camera was lost.

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

    A camera that is lost for long begins a new map, with coordinates of its own. Maps are joined where the camera comes
    from one into another, or by `join_maps`; until then their poses do not lie relative to each other, and
    `trajectory`, `volume` and the surface are of the largest map alone.

    Attributes:
        results: A TrackingResult for each frame so far, in order. `map` says which map a pose is of.
        stream: The StreamCheck: whether colour and depth are of one moment, `stream.problem` says why not.
        foreground: The Foreground: whether what is near moves by itself, and is left out.

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
        sizes: dict[str, Any] = {
            "voxel_size": voxel_size, "truncation": truncation, "depth_max": depth_max, "device": device
        }  # fmt: skip
        self._model_options = {**sizes, "depth_scale": depth_scale, "leave_out_moving": leave_out_moving}
        self._intrinsic, self._T_init, self._sizes = intrinsic, T_init, sizes
        self._seed, self._submap_frames = check_seed(seed), submap_frames
        if submap_frames is not None:
            check_count("submap_frames", submap_frames, minimum=2)
        self.results: list[TrackingResult] = []
        self.stream, self.foreground = StreamCheck(), Foreground()
        self._latest: tuple[Any, SensorFrame] | None = None
        self._maps = Maps(self._new_map)
        self._joining = Joining(self._maps, self.results, self._seed)

    def _new_map(self, number: int) -> SlamMap:
        """An empty map; all but the first begin at the identity, since nobody knows where they lie."""
        T_init = None if number else self._T_init
        model = Model(self._intrinsic, T_init=T_init, **self._model_options)
        return SlamMap(number, model, Keyframes(model.device, self._seed), self._new_recorder(model))

    def _new_recorder(self, model: Model) -> SubmapRecorder | None:
        if self._submap_frames is None:
            return None
        sizes = {**self._sizes, "truncation": model.volume.truncation, "depth_max": model.depth_max}
        return SubmapRecorder(self._intrinsic, **sizes, depth_scale=1.0, frames=self._submap_frames)

    def __repr__(self) -> str:
        counts = ", ".join(f"{n} {verdict}" for verdict, n in self.verdict_counts.items() if n)
        return f"DenseSLAM({counts or 'no frames'}, {len(self.keyframes)} keyframes, {self.volume!r})"

    @property
    def model(self) -> Model:
        """The Model of the map that the camera is in."""
        return self._maps.here.model

    @property
    def keyframes(self) -> Keyframes:
        """The Keyframes of the map that the camera is in."""
        return self._maps.here.keyframes

    @property
    def _tracker(self) -> Tracker:
        return self._maps.here.tracker

    @property
    def joins(self) -> list[MapJoin]:
        """For each two maps that a pose was found for: what spoke for it, and why it was refused."""
        return self._joining.judged

    @property
    def map_sizes(self) -> dict[int, int]:
        """How many frames have a pose in each map, the largest first, by the map's number."""
        return map_sizes(self.results)

    @property
    def volume(self) -> TSDFVolume:
        """The volume of the largest map, which is what `trajectory` and the surface are of."""
        return self._largest.model.volume

    @property
    def _largest(self) -> SlamMap:
        sizes = self.map_sizes
        return max(self._maps.kept, key=lambda known: (sizes.get(known.number, 0), -known.number))

    @property
    def verdict_counts(self) -> dict[str, int]:
        """How many frames were tracked, uncertain and lost."""
        verdicts = [result.verdict for result in self.results]
        return {verdict: verdicts.count(verdict) for verdict in ("tracked", "uncertain", "lost")}

    @property
    def trajectory(self) -> Trajectory:
        """The poses of the frames that are not lost, of the largest map.

        Those of another map do not lie relative to them (`trajectory_of`). Its ids are (number of the frame, the same,
        1 where it is tracked and 0 where it is uncertain); it has timestamps where all those frames have them.
        """
        return self.trajectory_of(next(iter(self.map_sizes), 0))

    def trajectory_of(self, number: int) -> Trajectory:
        """`trajectory` of the map of a number, in its own coordinates; empty where there is none.

        Raises:
            TypeError, ValueError: No whole number from 0 on.
        """
        check_count("number", number, minimum=0)
        found = [result for result in self.results if result.pose is not None and result.map == number]
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
        here = self._maps.here
        if here.recorder is not None:
            with unwatched():
                record_frame(here.recorder, prepared, depth, pixels, result)
        is_new = self.keyframes.is_new_view(result.pose)
        if is_new:
            self.keyframes.add(prepared.pyramid, result.pose, result.index)
            self._tracker.drift.keep(prepared.pyramid)
        self.results[-1] = dataclasses.replace(result, fused=True)
        if self._maps.others and not self._maps.is_on_trial:
            with unwatched():
                self._joining.look(prepared, result.pose, is_new)
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

        Maps are joined first (`join_maps`). Each model is fused anew from its submaps. It may be called at the end of a
        run or within it.

        Args:
            progress: Called with the stage, how many of its steps are done, and how many there are.

        Returns:
            What was closed in the largest map, and what was refused and why.

        Raises:
            ValueError: No submaps were kept (`submap_frames`), or no frame was fused yet.
        """
        if self._submap_frames is None:
            raise ValueError("submap_frames: no submaps were kept; make the DenseSLAM with submap_frames=100")
        if not self.volume.frame_count:
            raise ValueError("submap_frames: no frame was fused yet, so that there is no submap")
        tell = check_progress(progress)
        self.join_maps()
        largest = self._largest
        with unwatched():
            for other in self._maps.kept:
                if other is not largest and other.model.frame_count:
                    close_and_correct(other, self.results, tell)
            closed = close_and_correct(largest, self.results, tell)
        report("loops", slam=self, closure=closed)
        return closed

    def join_maps(self) -> list[MapJoin]:
        """Find how maps lie to each other, where the camera was lost for long and began new ones, and join them.

        Their submaps are registered with each other from no guess, or the whole of them where no submaps are kept. A
        pose is taken if `registration` accepts it and the maps show the same from the cameras of either. Maps that
        are joined take the lower number: poses in `results` are then of one map.

        Returns:
            What was tried just now, each with the reason where it was refused; empty where there is one map. `joins`
            has those of the whole run.
        """
        with unwatched():
            return self._joining.search()

    def render(self, T_world_camera: ArrayLike) -> RayCast:
        """What the camera would see of the map that it is in from a pose in that map; see `Model.render`."""
        return self.model.render(check_rigid("T_world_camera", T_world_camera))

    def extract_triangle_mesh(self, weight_threshold: float = 3.0) -> TriangleMesh:
        """The surface of the largest map as a mesh; see `TSDFVolume.extract_triangle_mesh`."""
        return self._largest.model.extract_triangle_mesh(weight_threshold)

    def extract_point_cloud(self, weight_threshold: float = 3.0) -> PointCloud:
        """The surface of the largest map as points; see `TSDFVolume.extract_point_cloud`."""
        return self._largest.model.extract_point_cloud(weight_threshold)

    def _track(self, frame: SensorFrame) -> TrackingResult:
        known = {"index": len(self.results), "name": frame.name, "timestamp": frame.timestamp}
        maps, doubt = self._maps, self.stream.look(frame)
        if maps.is_failing() or (maps.is_on_trial and not self.model.frame_count):
            maps.give_up(self.results)
        if doubt == STALE and self.model.frame_count:
            self._tracker.motion.missed += 1
            return TrackingResult(None, "lost", doubt, map=maps.here.number, **known)
        if self._restarts(frame) or not self.model.frame_count:
            return self._begin(frame, known)
        attempt, is_anew = self._tracker.locate(frame)
        attempt = attempt.doubted(doubt)
        if attempt.verdict == "lost":
            maps.here.tracker.motion.missed += 1
            if maps.is_on_trial:
                maps.give_up(self.results)
            elsewhere = maps.find_elsewhere(frame)
            if elsewhere is None:
                self.foreground.place(None)
                lost = TrackingResult(None, "lost", attempt.reason, map=maps.here.number, **attempt.measures, **known)
                return self._begin_anew(frame, known, lost)
            attempt, is_anew = elsewhere, True
        maps.found()
        motion, is_tracked = maps.here.tracker.motion, attempt.verdict == "tracked"
        self.foreground.place(attempt.pose if is_tracked else None)
        tells_velocity = not is_anew and is_determined(attempt.result)
        if is_tracked:
            motion.learn(attempt.result)
        motion.advance(attempt.pose, frame, is_tracked=is_tracked, is_continuous=tells_velocity)
        said = {**attempt.measures, **known, "relocalized": is_anew, "covariance": attempt.covariance}
        found = TrackingResult(attempt.pose, attempt.verdict, attempt.reason, map=maps.here.number, **said)
        return judge_drift(found, self.model.volume.truncation)

    def _restarts(self, frame: SensorFrame) -> bool:
        """Whether the near part of the pictures is found to move by itself while the model, which holds it, is young.

        Then the model begins again, without it, where the rest of the frame puts the camera.
        """
        motion = self._tracker.motion
        if not self.model.leave_out_moving or self.stream.view is None:
            return False
        expected = None if motion.pose is None or motion.missed else motion.expected(frame)
        layers = self.foreground.part(frame, self.stream.view, expected)
        if layers is None or layers.pose is None or self.model.frame_count > YOUNG:
            return False
        self._maps.here.begin_again(clean_pose(layers.pose), self._new_recorder(self.model))
        return True

    def _begin(self, frame: SensorFrame, known: dict[str, Any]) -> TrackingResult:
        """The first frame of a map: where its world begins, once one has depth."""
        here = self._maps.here
        if depth_share(frame.pyramid) < LEAST_DEPTH:
            return TrackingResult(None, "lost", "the picture is blank, and there is no model yet", **known)
        pose = here.model.current_frame_pose
        here.tracker.motion.advance(pose, frame, is_tracked=True, is_continuous=False)
        self.foreground.place(pose)
        return TrackingResult(pose, "tracked", fitness=1.0, overlap=1.0, map=here.number, **known)

    def _begin_anew(self, frame: SensorFrame, known: dict[str, Any], lost: TrackingResult) -> TrackingResult:
        """A frame that no map knows: lost, or the first of a new map where the camera was lost for long."""
        if depth_share(frame.pyramid) < LEAST_DEPTH or not self._maps.lost():
            return lost
        self._maps.begin()
        return self._begin(frame, known)


def record_frame(recorder: SubmapRecorder, frame: SensorFrame, depth: Any, pixels: Any, result: TrackingResult) -> None:
    """A fused frame goes into the submap being recorded, with the depth and colour that the model took."""
    height, width = frame.intrinsic.height, frame.intrinsic.width
    color = None if pixels is None else pixels.reshape((height, width, 3))
    picture = depth.reshape((height, width))
    if not frame.device.is_cuda:
        picture, color = download(picture), None if color is None else download(color)
    recorder.add(picture, result.pose, color, result.index)


def close_and_correct(known: SlamMap, results: list[TrackingResult], progress: ReportProgress) -> LoopClosure:
    """Close loops among the submaps of a map so far, and move everything that stands on their poses."""
    recorder, model, keyframes, motion = known.recorder, known.model, known.keyframes, known.tracker.motion
    assert recorder is not None
    submaps, seed = recorder.finish(), keyframes.seed
    closure = close_loops(submaps, seed=seed, progress=progress)
    numbers, poses = corrected_trajectory(submaps, closure.T_world_submap)
    own = [result for result in results if result.map == known.number]
    before = {result.index: result.pose for result in own if result.pose is not None}
    corrections = {n: matmul(pose, invert_pose(before[n])) for n, pose in zip(numbers.tolist(), poses, strict=True)}

    def corrected(pose: Pose, number: int) -> Pose:
        place = max(int(np.searchsorted(numbers, number, side="right")) - 1, 0)
        return clean_pose(matmul(corrections[int(numbers[place])], pose))

    for i, result in enumerate(results):
        if result.pose is not None and result.map == known.number:
            results[i] = dataclasses.replace(result, pose=corrected(result.pose, result.index))
    keyframes.poses = [corrected(T, n) for T, n in zip(keyframes.poses, keyframes.numbers, strict=True)]
    if motion.pose is not None:
        motion.pose = corrected(motion.pose, len(results))
    recorder.submaps = [
        dataclasses.replace(submap, T_world_submap=T) for submap, T in zip(submaps, closure.T_world_submap, strict=True)
    ]
    model.volume, model.movers = fuse_submaps(recorder.submaps), Movers()
    model.current_frame_pose = corrected(model.current_frame_pose, len(results))
    return closure


STALE = "its depth picture is the last one's"
STALLED = 3  # frames: cameras repeat one now and then, as real recordings show, and a tenth of a second costs little
STALLED_SECONDS = 0.12  # the same where the times are known
LEAST_CELLS = 0.02  # share of the cells that are measured, below which a depth picture says nothing
MOVED = 0.1  # [cells] the colours went since the depth came: a tenth of a degree; noise alone some 0.01
CHANGED = 0.03  # or this, the root mean square of what differs in a cell's brightness: noise of a camera 0.01


class StreamCheck:
    """What the frames so far say of the camera's two streams.

    Attributes:
        stalled: Frames in a row, up to the last, whose depth picture is an older one's and whose colours moved since.
        lag: The StreamLag.
        view: The StreamView of the last frame; None before the first.
    """

    def __init__(self) -> None:
        self.stalled, self.lag = 0, StreamLag()
        self.view: StreamView | None = None
        self._fresh: tuple[StreamView | None, float | None] = None, None

    def look(self, frame: SensorFrame) -> str:
        """What speaks against a frame; empty where nothing does. One wait for the device, two where depth is repeated.

        Args:
            frame: The next one of the stream.
        """
        view = view_stream(frame.depth, frame.pixels, frame.intrinsic.width, frame.intrinsic.height)
        last, self.view = self.view, view
        if last is None or frame.pixels is None:
            self._fresh, self.stalled = (view, frame.timestamp), 0
            return ""
        sums = motion_between(view, last)
        is_repeated = sums[at.OTHER] == 0 and sums[at.MEASURED] > LEAST_CELLS * view.columns * view.rows
        if not is_repeated:
            self._fresh, self.stalled = (view, frame.timestamp), 0
            self.lag.add(shift_of(sums, at.BRIGHT), shift_of(sums, at.NEAR), frame.timestamp)
            return self.problem or ""
        self.lag.add(shift_of(sums, at.BRIGHT), np.full(2, math.nan), frame.timestamp)
        fresh, since = self._fresh
        assert fresh is not None
        if has_moved(motion_between(view, fresh), view):
            self.stalled += 1
        age = frame.seconds_since(since)
        is_old = self.stalled > STALLED if math.isnan(age) else age > STALLED_SECONDS
        return STALE if self.stalled and is_old else self.problem or ""

    @property
    def problem(self) -> str | None:
        """Why color and depth do not belong together; None if they do."""
        if self.lag.frames is None:
            return None
        apart = f"{self.lag.seconds:.1f} s" if not math.isnan(self.lag.seconds) else f"{abs(self.lag.frames)} frames"
        return f"color and depth seem to be {apart} apart"


def motion_between(now: StreamView, before: StreamView) -> NDArray[np.float64]:
    """The sums of two views, float64 [13]."""
    sums: Any = download(compare_views(now, before))  # sync
    return np.asarray(sums, np.float64).reshape(-1)


def shift_of(sums: NDArray[np.float64], first: int) -> NDArray[np.float64]:
    """The shift of a picture [cells], float64 [2]; NaN where its slopes do not fix it."""
    a, b, c, d, e = sums[first : first + 5]
    determinant = a * c - b * b
    if determinant <= 1e-6 * (a + c) ** 2 or a + c <= 0.0:
        return np.full(2, math.nan)
    return np.array([b * e - c * d, b * d - a * e]) / determinant


def has_moved(sums: NDArray[np.float64], view: StreamView) -> bool:
    """Whether the colours of two views differ by more than noise."""
    shift = shift_of(sums, at.BRIGHT)
    changed = math.sqrt(sums[at.SHADES] / (view.columns * view.rows))
    return bool(norm(shift) > MOVED) or changed > CHANGED


Shifts = NDArray[np.float64]

KEPT = 120  # frames that are held against each other: four seconds at 30 a second
FARTHEST = 45  # frames that one may be late
FEWEST = 25  # pairs that a lag is told from
EVERY = 5  # frames from one look to the next
SWEEP = 4  # frames to either side, whose mean is taken away
CLIPPED = 3.0  # deviations: one jerk is not the whole of a motion
TOGETHER = 0.6  # correlation: right lags of a hand-held camera 0.75 to 0.95 | the best of 90 wrong ones 0.4
BESIDE = 0.3  # by which it is to be above that of no lag: right streams 0 | a second apart 0.55 and more
NO_LAG = 3  # frames: a tenth of a second at 30 a second costs millimetres
SHORT = 0.15  # [s] as NO_LAG where the times are known
AGREED = 2  # looks in a row that tell the same lag, to a frame


class StreamLag:
    """Holds the motion of the colours against that of the depth.

    Attributes:
        frames: How many frames the colours are later than the depth of the same moment, below 0 where the depth is
            later; None while nothing says that they are apart.
        seconds: The same [s]; NaN without times.
        correlation: Of the two motions so.
    """

    def __init__(self) -> None:
        self.frames: int | None = None
        self.seconds, self.correlation = math.nan, 0.0
        self._bright: list[Shifts] = []
        self._near: list[Shifts] = []
        self._times: list[float | None] = []
        self._told: list[int] = []
        self._count = 0

    def add(self, bright: Shifts, near: Shifts, time: float | None) -> None:
        """The shifts [cells] of a frame's two pictures from the frame before, NaN where one has none."""
        self._bright, self._near = [*self._bright[1 - KEPT :], bright], [*self._near[1 - KEPT :], near]
        self._times = [*self._times[1 - KEPT :], time]
        self._count += 1
        if self._count % EVERY == 0 and len(self._bright) > FEWEST:
            self._look()

    def _look(self) -> None:
        bright, near = tremble(np.array(self._bright)), tremble(np.array(self._near))
        farthest = min(FARTHEST, len(bright) - FEWEST)
        lags = np.arange(-farthest, farthest + 1)
        together = correlations(bright, near)[lags + len(bright) - 1]
        step = self._step()
        is_short = abs(lags) <= NO_LAG if math.isnan(step) else (abs(lags) < 2) | (abs(lags) * step < SHORT)
        best, beside = int(np.argmax(together)), float(together[is_short].max())
        lag = int(lags[best])
        if not is_short[best] and together[best] > max(TOGETHER, beside + BESIDE):
            self._told = [*self._told[1 - AGREED :], lag]
            if len(self._told) == AGREED and np.ptp(self._told) <= 1:
                self.frames, self.seconds, self.correlation = lag, abs(lag) * step, float(together[best])
        elif together[best] > TOGETHER:  # they go together as they come; what moves too little tells nothing new
            self._told, self.frames = [], None

    def _step(self) -> float:
        """The usual time from frame to frame [s]; NaN where frames have none."""
        times = [time for time in self._times if time is not None]
        return float(np.median(np.diff(times))) if len(times) == len(self._times) > 1 else math.nan


def tremble(shifts: Shifts) -> Shifts:
    """Shifts [n, 2] less their running mean, in deviations, NaN where they are."""
    known = np.isfinite(shifts)
    sums = np.cumsum(np.vstack([np.zeros((1, 2)), np.where(known, shifts, 0.0)]), axis=0)
    counts = np.cumsum(np.vstack([np.zeros((1, 2)), known]), axis=0)
    at = np.arange(len(shifts))
    low, high = np.maximum(at - SWEEP, 0), np.minimum(at + SWEEP + 1, len(shifts))
    rest = shifts - (sums[high] - sums[low]) / np.maximum(counts[high] - counts[low], 1)
    squares = np.where(known, rest, 0.0) ** 2
    spread = np.sqrt(squares.sum(axis=0) / np.maximum(known.sum(axis=0), 1))
    return np.clip(rest / np.maximum(spread, 1e-9), -CLIPPED, CLIPPED)


def correlations(bright: Shifts, near: Shifts) -> Shifts:
    """The correlations of two trembles [n, 2], both axes together, at all lags from 1 - n to n - 1.

    Returns:
        Of the colours' taken so many frames later, float64 [2 n - 1]; 0 where too few frames have both.
    """
    told: Any = np.isfinite(bright).all(axis=1)
    shown: Any = np.isfinite(near).all(axis=1)
    first_known, second_known = told.astype(np.float64), shown.astype(np.float64)
    a, b = np.where(told[:, None], bright, 0.0), np.where(shown[:, None], near, 0.0)

    def at_lags(x: Any, y: Any) -> Shifts:
        return np.correlate(x, y, "full")

    count = at_lags(first_known, second_known)
    shared, first, second = (np.zeros(2 * len(a) - 1) for _ in range(3))
    for axis in (0, 1):
        x, y = a[:, axis], b[:, axis]
        sums = at_lags(x, second_known), at_lags(first_known, y)
        shared += at_lags(x, y) - sums[0] * sums[1] / np.maximum(count, 1)
        first += at_lags(x * x, second_known) - sums[0] ** 2 / np.maximum(count, 1)
        second += at_lags(first_known, y * y) - sums[1] ** 2 / np.maximum(count, 1)
    scale = np.sqrt(np.maximum(first, 0.0) * np.maximum(second, 0.0))
    return np.where((count > FEWEST - 0.5) & (scale > 1e-9), shared / np.maximum(scale, 1e-9), 0.0)

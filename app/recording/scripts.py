"""What a recording shows of each algorithm: from the events that they report to frames."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.memory import download
from ...pcd.cloud import PointCloud
from ...pcd.coordinates import finite_box
from ...pcd.line_set import LineSet
from ..pictures.coloring import label_color
from ..pictures.frustum import CameraFrustum
from ..pictures.pair_picture import BLUE, ORANGE, usual_look
from ..pictures.parts import Matrix, Triple
from ..surface_weights import least_weight
from .shapes import spread_rows

if TYPE_CHECKING:
    from .recorder import Recorder

Look = tuple[Triple, Triple]  # the direction of a view, and what is up
Data = dict[str, Any]

GREY, RED, PATH = (0.6, 0.6, 0.6), (0.86, 0.1, 0.1), (0.1, 0.35, 0.75)
SURFACE_EVERY, SURFACES = 5, 20  # frames between two surfaces; after so many of these, twice as many frames
SURFACE_SHARE, SCAN_SHARE = 8, 4  # of max_points: that part of it for each surface on the way, for each scan
MOST_CORNERS = 2_000  # of a path
MOST_TURNS = 100  # frames in which clusters appear
LOOKED_AT = 20_000  # points that a view is chosen by
TILT = (0.35, 0.55)  # of a view over the shoulder of a camera: to the right, down


class Scripts:
    """Turns events into steps of a recorder.

    Args:
        recorder: The Recorder.

    Attributes:
        look: A direction and what is up, by the first algorithm that was seen; None before.
    """

    def __init__(self, recorder: Recorder):
        self.look: Look | None = None
        self._stage = ""
        scripts = [kind(Stage(recorder)) for kind in (Registration, Fusion, Drive, Clusters, Planes, Fragments)]
        self._scripts = {event: script for script in scripts for event in script.EVENTS}
        self._active: Script | None = None

    def take(self, event: str, data: Data) -> None:
        """Show an event; one that nothing is known of is nothing."""
        if event == "stage":
            self._stage = data["name"]
            return
        script = self._scripts.get(event)
        if script is None:
            return
        if script is not self._active:
            self.finish()
            self._active = script
            script.begin()
        script.stage.prefix = self._stage
        script.EVENTS[event](script, **data)
        if self.look is None:
            self.look = script.look

    def finish(self) -> None:
        """Let the algorithm that was shown last come to its end."""
        if self._active is not None:
            self._active.finish()


class Stage:
    """A recorder as one kind of algorithm sees it: what it shows goes once another kind shows something.

    Attributes:
        recorder: The Recorder.
        prefix: Of the labels.
    """

    def __init__(self, recorder: Recorder):
        self.recorder, self.prefix = recorder, ""

    @property
    def max_points(self) -> int:
        """As of the recorder."""
        return self.recorder.max_points

    def show(self, name: str, geometry: Any, *, share: int = 1, **style: Any) -> None:
        """Show a geometry, of a part of the points that may be drawn."""
        self.recorder._show(name, [(geometry, style)], max(self.max_points // share, 1), self)

    def show_all(self, name: str, drawn: Sequence[tuple[Any, Data]], total: int) -> None:
        """Show several geometries under one name, which are what is left of so many points."""
        self.recorder._show(name, drawn, self.max_points, self, total)

    def set_pose(self, name: str, pose: Matrix) -> None:
        """Move what is shown, unless the user took it away."""
        if name in self.recorder.names:
            self.recorder.set_pose(name, pose)

    def step(self, label: str, values: Data | None = None) -> None:
        """Make a frame."""
        for name, value in (values or {}).items():
            self.recorder.plot(name, value)
        self.recorder.step(f"{self.prefix}: {label}" if self.prefix else label)


class Script:
    """How one kind of algorithm is shown."""

    EVENTS: dict[str, Callable[..., None]] = {}

    def __init__(self, stage: Stage):
        self.stage = stage
        self.look: Look | None = None

    def begin(self) -> None:
        """Nothing is shown, or nothing any more."""

    def finish(self) -> None:
        """Show what is still to be shown at the end."""


class Registration(Script):
    """Two clouds: the target blue, the source orange under each pose."""

    def __init__(self, stage: Stage):
        super().__init__(stage)
        self._pair: tuple[Any, Any] | None = None
        self._pose: Matrix | None = None

    def begin(self) -> None:
        """As of Script."""
        self._pair = self._pose = None

    def icp(self, source: PointCloud, target: PointCloud, iteration_index: int, **data: Any) -> None:
        """A turn of ICP."""
        if iteration_index == 0 or self._pair is None or self._pair[0] is not source or self._pair[1] is not target:
            self._take(source, target)
        voxels = f", voxels of {data['voxel_size']:g} m" if data.get("voxel_size") else ""
        fit = {"fitness": data["fitness"], "inlier rmse [m]": data["inlier_rmse"]}
        self._at(data["transformation"], f"ICP{voxels}, iteration {iteration_index}", fit)

    def registration(self, source: PointCloud, target: PointCloud, result: Any, **data: Any) -> None:
        """The result of any registration; that of ICP was its last turn's already."""
        if self._pose is not None and np.array_equal(self._pose, result.transformation):
            return
        if self._pair is None or self._pair[0] is not source or self._pair[1] is not target:
            self._take(source, target)
            self._at(np.eye(4), "as the clouds lie", {})
        fit = {"fitness": result.fitness, "inlier rmse [m]": result.inlier_rmse}
        self._at(result.transformation, f"registered: {result.reason}", fit)

    def _take(self, source: PointCloud, target: PointCloud) -> None:
        self._pair = source, target
        self.look = self.look or look_at(target)
        self.stage.show("target", target, color=BLUE)
        self.stage.show("source", source, color=ORANGE)

    def _at(self, pose: Matrix, label: str, values: Data) -> None:
        self._pose = np.array(pose)
        self.stage.set_pose("source", pose)
        self.stage.step(label, values)

    EVENTS = {"icp": icp, "registration": registration}


class Travel(Script):
    """Something that moves on a path."""

    def __init__(self, stage: Stage):
        super().__init__(stage)
        self.path: list[NDArray[np.float64]] = []

    def go(self, pose: Matrix) -> None:
        """Draw the path up to a pose."""
        self.path.append(pose[:3, 3].copy())
        self.draw_path()

    def draw_path(self) -> None:
        """Draw the path so far."""
        if len(self.path) < 2:
            return
        corners = np.array(self.path)[spread_rows(len(self.path), MOST_CORNERS)]
        corners = np.vstack([corners, self.path[-1]])
        count = np.arange(len(corners) - 1)
        lines = np.column_stack([count, count + 1])
        self.stage.show("path", LineSet(corners, lines), color=PATH, line_width=2.0)


class Fusion(Travel):
    """A depth camera and the surface that grows from its frames, with or without tracking."""

    def __init__(self, stage: Stage):
        super().__init__(stage)
        self._volume: Any = None
        self._slam: Any = None
        self._camera: Any = None
        self._image: Any = None  # the last one that odometry moved, and where
        self._pose = np.eye(4)
        self._count, self._shown, self._surfaces, self._every = 0, (0, 0), 0, SURFACE_EVERY

    def begin(self) -> None:
        """As of Script."""
        self._camera, self._shown = None, (0, 0)

    def integrate(self, volume: Any, intrinsic: Any, T_world_camera: Matrix, **_: Any) -> None:
        """A frame went into a volume."""
        if volume is not self._volume:
            self._begin(volume)
        self._count += 1
        is_tracked = self._slam is not None and volume is self._slam.volume
        if not is_tracked:
            self._move(intrinsic, T_world_camera)
        if self._count % self._every == 1:
            self._draw_surface(share=SURFACE_SHARE)
            self._surfaces += 1
            self._every *= 2 if self._surfaces % SURFACES == 0 else 1
        if not is_tracked:
            self.stage.step(f"frame {self._count}", {"blocks": volume.block_count})

    def track(self, slam: Any, result: Any, **_: Any) -> None:
        """A frame was tracked, or lost."""
        if slam is not self._slam:
            self._slam = slam
            self._begin(slam.volume)
        if result.pose is not None:
            self._move(slam.model.intrinsic, result.pose)
        values = {"fitness": result.fitness, "inlier rmse [m]": result.inlier_rmse} if result.iterations else {}
        self.stage.step(f"frame {result.index}: {result.verdict}", values)

    def loops(self, slam: Any, **_: Any) -> None:
        """The path and the model were corrected."""
        if slam is not self._slam:
            self._slam = slam
            self._begin(slam.volume)
        self.path = [result.pose[:3, 3].copy() for result in slam.results if result.pose is not None]
        self._volume = slam.volume
        self._draw_surface()
        self.draw_path()
        self.stage.step("loops closed")

    def odometry(self, source: Any, target: Any, intrinsic: Any, result: Any, **_: Any) -> None:
        """A frame was aligned with another one; where that was the last one's, the path goes on."""
        if target is not self._image:
            self._pose = np.eye(4)
            if self._volume is None:  # else it is the volume that tells the path
                self.path = []
                self._move(intrinsic, self._pose)
        if result.success:
            self._pose = self._pose @ result.transformation
        self._image = source
        cloud = PointCloud.from_rgbd_image(source, intrinsic)
        self.stage.show("frame", cloud, share=SCAN_SHARE, pose=self._pose)
        if self._volume is None:
            self._move(intrinsic, self._pose)
        self.stage.step("aligned" if result.success else result.reason or "not aligned")

    def finish(self) -> None:
        """The surface of all frames, at last in full."""
        if self._count and self._shown != (self._count, 1):
            self._draw_surface()
            self.stage.step(f"the surface of {self._count} frames")

    def _begin(self, volume: Any) -> None:
        self.finish()
        self.path, self._volume, self._camera = [], volume, None
        self._count, self._shown, self._surfaces, self._every = 0, (0, 0), 0, SURFACE_EVERY

    def _move(self, intrinsic: Any, pose: Matrix) -> None:
        if self._camera is not intrinsic:
            self._camera = intrinsic
            self.stage.show("camera", CameraFrustum(intrinsic, np.eye(4), scale=0.2))
        self.stage.set_pose("camera", pose)
        self.go(pose)
        if self.look is None:
            right, down, forward = pose[:3, :3].T
            x, y, z = (forward + TILT[0] * right + TILT[1] * down).tolist()
            self.look = (x, y, z), tuple((-down).tolist())

    def _draw_surface(self, share: int = 1) -> None:
        self._shown = self._count, share
        mesh = self._volume.extract_triangle_mesh(least_weight(self._volume.frame_count))
        if len(mesh):
            self.stage.show("surface", mesh, share=share)

    EVENTS = {"integrate": integrate, "track": track, "loops": loops, "rgbd_odometry": odometry}


class Drive(Travel):
    """LiDAR odometry: the scan orange on the grey map."""

    def __init__(self, stage: Stage):
        super().__init__(stage)
        self._odometry: Any = None
        self._every, self._scans, self._shown = SURFACE_EVERY, 0, 0

    def scan(self, odometry: Any, scan: PointCloud, step: Any, **_: Any) -> None:
        """A scan was registered."""
        if odometry is not self._odometry:
            self._odometry, self.path, self._every = odometry, [], SURFACE_EVERY
        self._scans = step.index + 1
        if step.index % self._every == 0:
            self._draw_map()
            self._every *= 2 if step.index >= SURFACES * self._every else 1
        self.stage.show("scan", scan, share=SCAN_SHARE, color=ORANGE, pose=step.pose)
        self.go(step.pose)
        self.look = self.look or look_at(scan)
        values = {"fitness": step.fitness, "inlier rmse [m]": step.inlier_rmse} if step.iterations else {}
        self.stage.step(f"scan {step.index}: {step.reason}", values)

    def finish(self) -> None:
        """The map at last in full."""
        if self._odometry is not None and self._scans != self._shown:
            self._shown = self._scans
            self._draw_map(share=1)
            self.stage.step(f"the map of {self._scans} scans")

    def _draw_map(self, share: int = SCAN_SHARE) -> None:
        found = self._odometry.map
        if len(found):
            self.stage.show("map", found, share=share, color=GREY)

    EVENTS = {"scan": scan}


class Clusters(Script):
    """Clusters that take their colours one after another, by their numbers; an algorithm has no such steps."""

    def clusters(self, cloud: PointCloud, labels: Any, **_: Any) -> None:
        """The labels of a cloud."""
        rows = spread_rows(len(cloud), self.stage.max_points)
        chosen, found = cloud.select_by_index(rows), download(labels)[rows]
        self.look = self.look or look_at(chosen)
        count = int(found.max(initial=-1)) + 1
        turn = -(-max(count, 1) // MOST_TURNS)  # clusters that appear in one frame
        groups = [(chosen.select_by_mask(found < 0), {"color": label_color(-1)})]
        painted: list[tuple[Any, Data]] = []
        for first in range(0, count, turn):
            part = chosen.select_by_mask((found >= first) & (found < first + turn))
            groups.append((part, {"color": GREY}))
            kinds, each = np.unique(found[(found >= first) & (found < first + turn)], return_inverse=True)
            shades = np.array([label_color(int(label)) for label in kinds]).reshape(-1, 3)[each]
            painted.append((_painted(part, shades), {}))
        plural = "" if count == 1 else "s"
        self.stage.show_all("cloud", groups, len(cloud))
        self.stage.step("the cloud")
        for k, part in enumerate(painted):
            groups[k + 1] = part
            self.stage.show_all("cloud", groups, len(cloud))
            self.stage.step(f"{min((k + 1) * turn, count)} of {count} cluster{plural}")

    EVENTS = {"clusters": clusters}


class Planes(Script):
    """Planes that take their colours as they are found."""

    def __init__(self, stage: Stage):
        super().__init__(stage)
        self._cloud: Any = None
        self._found: list[NDArray[np.int32]] = []

    def plane(self, cloud: PointCloud, inliers: Any, model: Any, number: int | None = None, **_: Any) -> None:
        """The points of a plane; without a number it is the only one that is looked for."""
        if cloud is not self._cloud or not number:
            self._cloud, self._found = cloud, []
            self.look = self.look or look_at(cloud)
            self.stage.show("cloud", cloud)
            self.stage.step("the cloud")
        self._found.append(download(inliers))
        rows = spread_rows(len(cloud), self.stage.max_points)
        taken = np.full(len(cloud), -1)
        for k, found in enumerate(self._found):
            taken[found] = k
        taken, chosen = taken[rows], cloud.select_by_index(rows)
        drawn: list[tuple[Any, Data]] = [(chosen.select_by_mask(taken < 0), {"color": GREY})]
        for k in range(len(self._found)):
            color = RED if number is None else label_color(k)
            drawn.append((chosen.select_by_mask(taken == k), {"color": color}))
        self.stage.show_all("cloud", drawn, len(cloud))
        a, b, c, d = model
        self.stage.step(f"{len(self._found[-1]):,} points on {a:.3f} x + {b:.3f} y + {c:.3f} z + {d:.3f} = 0")

    EVENTS = {"plane": plane}


class Fragments(Script):
    """Clouds of one scene, brought into one frame."""

    def fragments(self, clouds: Sequence[PointCloud], poses: Matrix, placed: NDArray[np.bool_], **_: Any) -> None:
        """Where they lie; they come one after another."""
        share, count = max(len(clouds), 1), int(placed.sum())
        for k, number in enumerate(np.flatnonzero(placed).tolist()):
            look = look_at(clouds[number])
            self.look = self.look or look
            color = label_color(number)
            self.stage.show(f"cloud {number}", clouds[number], share=share, color=color, pose=poses[number])
            self.stage.step(f"{k + 1} of {count} clouds placed, {len(clouds)} in all")

    EVENTS = {"fragments": fragments}


def _painted(cloud: PointCloud, colors: NDArray[np.float64]) -> PointCloud:
    painted = cloud.copy()
    painted.colors = colors
    return painted


def look_at(cloud: PointCloud) -> Look | None:
    """A direction to look at a cloud along, and what is up; None of one without finite points."""
    some = cloud.select_by_index(spread_rows(len(cloud), LOOKED_AT)).points
    points = some[np.isfinite(some).all(axis=1)]
    low, high = finite_box(points)
    return usual_look(points) if len(points) and (high > low).any() else None

"""Scripts that convert the reported events of each algorithm into frames of a recording."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...core.units import symbol_of
from ...kernels.linear_algebra import matmul
from ...kernels.memory import download
from ...meshing.volume.surface_weights import min_weight
from ...pcd.cloud import PointCloud
from ...pcd.line_set import LineSet
from ..render.coloring import label_color
from ..render.frustum import CameraFrustum
from ..render.pair_picture import SOURCE_COLOR, TARGET_COLOR
from ..render.parts import Matrix
from .script import PLAIN_COLOR, Data, FrameTarget, Look, Script, Stage, look_at
from .shapes import spread_rows

if TYPE_CHECKING:
    from ...cameras.camera import PinholeCameraIntrinsic
    from ...cameras.images import RGBDImage
    from ...kernels.array_types import Indices
    from ...meshing.volume.tsdf import TSDFVolume
    from ...registration.lidar.lidar_odometry import LidarOdometry


class Scripts:
    """Converts events into steps of a recorder."""

    def __init__(self, recorder: FrameTarget, show: Callable[..., None]):
        self._stage = ""
        scripts = [kind(Stage(recorder, show)) for kind in (Registration, Fusion, Drive, Clusters, Planes, Fragments)]
        self._shown_by = {event: (script, show) for script in scripts for event, show in script.events().items()}
        self._first: Script | None = None
        self._active: Script | None = None

    def take(self, event: str, data: dict[str, Any]) -> None:
        """Show an event. Unknown ones are ignored."""
        if event == "stage":
            self._stage = data["name"]
            return
        if event not in self._shown_by:
            return
        script, show = self._shown_by[event]
        if script is not self._active:
            self.finish()
            self._active = script
            script.begin()
        script.stage.prefix = self._stage
        show(**data)
        self._first = self._first or script

    @property
    def look(self) -> Look | None:
        """View direction and up axis, from the first algorithm. None before its first event."""
        return None if self._first is None else self._first.look

    def finish(self) -> None:
        if self._active is not None:
            self._active.finish()


class Registration(Script):
    """A registration of two clouds: the target in blue, and the source in orange at each pose."""

    def __init__(self, stage: Stage):
        super().__init__(stage)
        self._pair: tuple[Any, Any] | None = None
        self._pose: Matrix | None = None

    def begin(self) -> None:
        self._pair = self._pose = None

    def events(self) -> dict[str, Callable[..., None]]:
        return {"icp": self.icp, "registration": self.registration}

    def icp(self, source: PointCloud, target: PointCloud, iteration_index: int, **data: Any) -> None:
        if iteration_index == 0 or self._pair is None or self._pair[0] is not source or self._pair[1] is not target:
            self._take(source, target)
        m = symbol_of(source.unit)
        voxels = f", voxels of {data['voxel_size']:g} {m}" if data.get("voxel_size") else ""
        fit = {"fitness": data["fitness"], f"inlier rmse [{m}]": data["inlier_rmse"]}
        self._at(data["transformation"], f"ICP{voxels}, iteration {iteration_index}", fit)

    def registration(self, source: PointCloud, target: PointCloud, result: Any, **data: Any) -> None:
        """Show the result of a registration, unless the last iteration of ICP has the same pose."""
        if self._pose is not None and np.array_equal(self._pose, result.transformation):
            return
        if self._pair is None or self._pair[0] is not source or self._pair[1] is not target:
            self._take(source, target)
            self._at(np.eye(4), "initial poses", {})
        fit = {"fitness": result.fitness, f"inlier rmse [{symbol_of(source.unit)}]": result.inlier_rmse}
        state = "converged" if result.converged else "not converged"
        self._at(result.transformation, f"registered: {state}", fit)

    def _take(self, source: PointCloud, target: PointCloud) -> None:
        self._pair = source, target
        self.look = self.look or look_at(target)
        self.stage.show("target", target, color=TARGET_COLOR)
        self.stage.show("source", source, color=SOURCE_COLOR)

    def _at(self, pose: Matrix, label: str, values: Data) -> None:
        self._pose = np.array(pose)
        self.stage.set_pose("source", pose)
        self.stage.step(label, values)


UNASSIGNED_COLOR = (0.86, 0.1, 0.1)
MAX_CLUSTER_FRAMES = 100  # maximum number of frames in which clusters appear


class Clusters(Script):
    """Clusters, colored one after another by number. The algorithm itself has no such steps."""

    def events(self) -> dict[str, Callable[..., None]]:
        return {"clusters": self.clusters}

    def clusters(self, cloud: PointCloud, labels: Indices, **_: Any) -> None:
        rows = spread_rows(len(cloud), self.stage.max_points)
        chosen, cluster_labels = cloud.select_by_index(rows), download(labels)[rows]
        self.look = self.look or look_at(chosen)
        count = int(cluster_labels.max(initial=-1)) + 1
        per_frame = -(-max(count, 1) // MAX_CLUSTER_FRAMES)  # number of clusters that appear in one frame
        groups = [(chosen.select_by_mask(cluster_labels < 0), {"color": label_color(-1)})]
        painted: list[tuple[Any, Data]] = []
        for first in range(0, count, per_frame):
            part = chosen.select_by_mask((cluster_labels >= first) & (cluster_labels < first + per_frame))
            groups.append((part, {"color": PLAIN_COLOR}))
            kinds, each = np.unique(
                cluster_labels[(cluster_labels >= first) & (cluster_labels < first + per_frame)], return_inverse=True
            )
            shades = np.array([label_color(int(label)) for label in kinds]).reshape(-1, 3)[each]
            painted.append((_painted(part, shades), {}))
        plural = "" if count == 1 else "s"
        self.stage.show_all("cloud", groups, len(cloud))
        self.stage.step("the cloud")
        for k, part in enumerate(painted):
            groups[k + 1] = part
            self.stage.show_all("cloud", groups, len(cloud))
            self.stage.step(f"{min((k + 1) * per_frame, count)} of {count} cluster{plural}")


class Planes(Script):
    """Planes, colored in the order in which they are found."""

    def __init__(self, stage: Stage):
        super().__init__(stage)
        self._cloud: Any = None
        self._inliers: list[NDArray[np.int32]] = []

    def events(self) -> dict[str, Callable[..., None]]:
        return {"plane": self.plane}

    def plane(self, cloud: PointCloud, inliers: object, model: Any, number: int | None = None, **_: Any) -> None:
        """Color the points of a plane. Without a number it is the only plane."""
        if cloud is not self._cloud or not number:
            self._cloud, self._inliers = cloud, []
            self.look = self.look or look_at(cloud)
            self.stage.show("cloud", cloud)
            self.stage.step("the cloud")
        self._inliers.append(download(inliers))
        rows = spread_rows(len(cloud), self.stage.max_points)
        taken = np.full(len(cloud), -1)
        for k, indices in enumerate(self._inliers):
            taken[indices] = k
        taken, chosen = taken[rows], cloud.select_by_index(rows)
        drawn: list[tuple[Any, Data]] = [(chosen.select_by_mask(taken < 0), {"color": PLAIN_COLOR})]
        for k in range(len(self._inliers)):
            color = UNASSIGNED_COLOR if number is None else label_color(k)
            drawn.append((chosen.select_by_mask(taken == k), {"color": color}))
        self.stage.show_all("cloud", drawn, len(cloud))
        a, b, c, d = model
        self.stage.step(f"{len(self._inliers[-1]):,} points on {a:.3f} x {b:+.3f} y {c:+.3f} z {d:+.3f} = 0")


class Fragments(Script):
    """Clouds of one scene, moved one after another into the common coordinate system."""

    def events(self) -> dict[str, Callable[..., None]]:
        return {"fragments": self.fragments}

    def fragments(self, clouds: Sequence[PointCloud], poses: Matrix, placed: NDArray[np.bool_], **_: Any) -> None:
        fraction, count = max(len(clouds), 1), int(placed.sum())
        for k, number in enumerate(np.flatnonzero(placed).tolist()):
            look = look_at(clouds[number])
            self.look = self.look or look
            color = label_color(number)
            self.stage.show(f"cloud {number}", clouds[number], fraction=fraction, color=color, pose=poses[number])
            self.stage.step(f"{k + 1} of {count} clouds placed, {len(clouds)} in all")


def _painted(cloud: PointCloud, colors: NDArray[np.float64]) -> PointCloud:
    painted = cloud.copy()
    painted.colors = colors
    return painted


PATH_COLOR = (0.1, 0.35, 0.75)
# Frames between two surfaces. After MAX_EVEN_SURFACES surfaces the interval doubles.
SURFACE_EVERY, MAX_EVEN_SURFACES = 5, 20
SURFACE_FRACTION, SCAN_FRACTION = 8, 4  # divisors of max_points for each intermediate surface and each scan
MAX_CORNERS = 2_000  # maximum number of corners of a drawn path
MIN_DIRECTION_SUM = 0.3  # relative to the number of cameras: a shorter sum of their directions has no meaning
VIEW_TILT = (0.35, 0.55)  # tilt of the view over the shoulder: to the right and down


class Travel(Script):
    """A sensor moving along a path."""

    def __init__(self, stage: Stage):
        super().__init__(stage)
        self.path: list[NDArray[np.float64]] = []

    def go(self, pose: Matrix) -> None:
        self.path.append(pose[:3, 3].copy())
        self.draw_path()

    def draw_path(self) -> None:
        if len(self.path) < 2:
            return
        corners = np.array([*(self.path[k] for k in spread_rows(len(self.path) - 1, MAX_CORNERS)), self.path[-1]])
        count = np.arange(len(corners) - 1, dtype=np.int32)
        lines = np.column_stack([count, count + 1])
        self.stage.show("path", LineSet(corners, lines), color=PATH_COLOR, line_width=2.0)


class Fusion(Travel):
    """A depth camera and the surface fused from its frames, with or without tracking."""

    def __init__(self, stage: Stage):
        super().__init__(stage)
        self._volume: Any = None
        self._slam: Any = None
        self._camera: Any = None
        self._axes = np.zeros((3, 3))  # sum over all cameras
        self._image: Any = None  # the last image that odometry moved, and its pose
        self._pose, self._images = np.eye(4), 0
        self._count, self._shown, self._surfaces, self._every = 0, (0, 0), 0, SURFACE_EVERY

    def begin(self) -> None:
        self._camera, self._shown = None, (0, 0)

    def events(self) -> dict[str, Callable[..., None]]:
        return {"integrate": self.integrate, "track": self.track, "loops": self.loops, "rgbd_odometry": self.odometry}

    def integrate(self, volume: Any, intrinsic: PinholeCameraIntrinsic, T_world_camera: Matrix, **_: Any) -> None:
        if volume is not self._volume:
            self._begin(volume)
        self._count += 1
        is_tracked = self._slam is not None and volume is self._slam.model.volume
        if not is_tracked:
            self._move(intrinsic, T_world_camera)
        if self._count % self._every == 1:
            self._draw_surface(fraction=SURFACE_FRACTION)
            self._surfaces += 1
            self._every *= 2 if self._surfaces % MAX_EVEN_SURFACES == 0 else 1
        if not is_tracked:
            self.stage.step(f"frame {self._count}", {"blocks": volume.block_count})

    def track(self, slam: Any, result: Any, **_: Any) -> None:
        """Show a frame that was tracked or lost."""
        if slam is not self._slam:
            self._slam = slam
            self._begin(slam.model.volume)
        if result.pose is not None:
            self._move(slam.model.intrinsic, result.pose)
        values = {"fitness": result.fitness, "inlier rmse [m]": result.inlier_rmse} if result.iterations else {}
        self.stage.step(f"frame {result.index}: {result.status}", values)

    def loops(self, slam: Any, closure: Any, **_: Any) -> None:
        """Show the path and the model after a loop closure."""
        if not closure.loops:
            return
        if slam is not self._slam:
            self._slam = slam
            self._begin(slam.model.volume)
        self.path = [result.pose[:3, 3].copy() for result in slam.results if result.pose is not None]
        self._volume = slam.model.volume
        self._draw_surface()
        self.draw_path()
        count = len(closure.loops)
        self.stage.step(f"{count} loop{'' if count == 1 else 's'} closed")

    def odometry(self, source: Any, target: RGBDImage, intrinsic: Any, result: Any, **_: Any) -> None:
        """Show a frame that was aligned with another. The path continues if the other is the last one of the path."""
        if target is not self._image:
            self._pose = np.eye(4)
            if self._volume is None:  # otherwise the volume defines the path
                self.path = []
                self._move(intrinsic, self._pose)
        if result.reliable:
            self._pose = matmul(self._pose, result.transformation)
        self._image = source
        cloud = PointCloud.create_from_rgbd_image(source, intrinsic)
        self.stage.show("frame", cloud, fraction=SCAN_FRACTION, pose=self._pose)
        if self._volume is None:
            self._move(intrinsic, self._pose)
        self._images += 1
        self.stage.step(f"frame {self._images}: {'; '.join(result.warnings) or 'aligned'}")

    def finish(self) -> None:
        """Show the final surface in full resolution."""
        if self._count and self._shown != (self._count, 1):
            self._draw_surface()
            self.stage.step(f"the surface of {self._count} frames")

    def _begin(self, volume: TSDFVolume) -> None:
        self.finish()
        self.path, self._volume, self._camera = [], volume, None
        self._count, self._shown, self._surfaces, self._every = 0, (0, 0), 0, SURFACE_EVERY

    def _move(self, intrinsic: Any, pose: Matrix) -> None:
        if self._camera is not intrinsic:
            self._camera = intrinsic
            self.stage.show("camera", CameraFrustum(intrinsic, np.eye(4), scale=0.2))
        self.stage.set_pose("camera", pose)
        self.go(pose)
        self._axes += pose[:3, :3]
        self.look = look_over(self._axes, pose[:3, :3])

    def _draw_surface(self, fraction: int = 1) -> None:
        self._shown = self._count, fraction
        mesh = self._volume.extract_triangle_mesh(min_weight(self._volume.frame_count))
        if len(mesh):
            self.stage.show("surface", mesh, fraction=fraction, back_faces=False)


class Drive(Travel):
    """LiDAR odometry: the scan in orange on the map in gray."""

    def __init__(self, stage: Stage):
        super().__init__(stage)
        self._odometry: Any = None
        self._every, self._scans, self._shown = SURFACE_EVERY, 0, 0

    def events(self) -> dict[str, Callable[..., None]]:
        return {"scan": self.scan}

    def scan(self, odometry: LidarOdometry, scan: PointCloud, step: Any, **_: Any) -> None:
        if odometry is not self._odometry:
            self._odometry, self.path, self._every = odometry, [], SURFACE_EVERY
        self._scans = step.index + 1
        if step.index % self._every == 0:
            self._draw_map()
            self._every *= 2 if step.index >= MAX_EVEN_SURFACES * self._every else 1
        self.stage.show("scan", scan, fraction=SCAN_FRACTION, color=SOURCE_COLOR, pose=step.pose)
        self.go(step.pose)
        self.look = self.look or look_at(scan)
        values = {"fitness": step.fitness, "inlier rmse [m]": step.inlier_rmse} if step.iterations else {}
        self.stage.step(f"scan {step.index}: {step.status}", values)

    def finish(self) -> None:
        """Show the final map in full resolution."""
        if self._odometry is not None and self._scans != self._shown:
            self._shown = self._scans
            self._draw_map(fraction=1)
            self.stage.step(f"the map of {self._scans} scans")

    def _draw_map(self, fraction: int = SCAN_FRACTION) -> None:
        cloud = self._odometry.map
        if len(cloud):
            self.stage.show("map", cloud, fraction=fraction, color=PLAIN_COLOR)


def look_over(axes: Matrix, last: Matrix) -> Look:
    """View over the shoulder of the cameras, from the sum of their axes. Of the last one if they look everywhere."""
    (_, down, forward), count = axes.T, np.linalg.norm(axes, axis=0).max()
    if (
        np.linalg.norm(forward) < MIN_DIRECTION_SUM * count
        or np.linalg.norm(np.cross(forward, down)) < MIN_DIRECTION_SUM * count**2
    ):
        _, down, forward = last.T
    down, forward = down / np.linalg.norm(down), forward / np.linalg.norm(forward)
    x, y, z = (forward + VIEW_TILT[0] * np.cross(down, forward) + VIEW_TILT[1] * down).tolist()
    return (x, y, z), tuple((-down).tolist())

"""What a recording shows of cameras and scanners that move, and of what they see."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...meshing.volume.surface_weights import least_weight
from ...pcd.cloud import PointCloud
from ...pcd.line_set import LineSet
from ..render.frustum import CameraFrustum
from ..render.pair_picture import ORANGE
from ..render.parts import Matrix
from .script import GREY, Look, Script, Stage, look_at
from .shapes import spread_rows

PATH = (0.1, 0.35, 0.75)
SURFACE_EVERY, SURFACES = 5, 20  # frames between two surfaces; after so many of these, twice as many frames
SURFACE_SHARE, SCAN_SHARE = 8, 4  # of max_points: that part of it for each surface on the way, for each scan
MOST_CORNERS = 2_000  # of a path
ASTRAY = 0.3  # of the cameras' number: a shorter sum of their directions tells nothing
TILT = (0.35, 0.55)  # of a view over the shoulder of a camera: to the right, down


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
        corners = np.array([*(self.path[k] for k in spread_rows(len(self.path) - 1, MOST_CORNERS)), self.path[-1]])
        count = np.arange(len(corners) - 1, dtype=np.int32)
        lines = np.column_stack([count, count + 1])
        self.stage.show("path", LineSet(corners, lines), color=PATH, line_width=2.0)


class Fusion(Travel):
    """A depth camera and the surface that grows from its frames, with or without tracking."""

    def __init__(self, stage: Stage):
        super().__init__(stage)
        self._volume: Any = None
        self._slam: Any = None
        self._camera: Any = None
        self._axes = np.zeros((3, 3))  # the sum of all cameras'
        self._image: Any = None  # the last one that odometry moved, and where
        self._pose, self._images = np.eye(4), 0
        self._count, self._shown, self._surfaces, self._every = 0, (0, 0), 0, SURFACE_EVERY

    def begin(self) -> None:
        """As of Script."""
        self._camera, self._shown = None, (0, 0)

    def events(self) -> dict[str, Callable[..., None]]:
        """As of Script."""
        return {"integrate": self.integrate, "track": self.track, "loops": self.loops, "rgbd_odometry": self.odometry}

    def integrate(self, volume: Any, intrinsic: Any, T_world_camera: Matrix, **_: Any) -> None:
        """A frame went into a volume."""
        if volume is not self._volume:
            self._begin(volume)
        self._count += 1
        is_tracked = self._slam is not None and volume is self._slam.model.volume
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
            self._begin(slam.model.volume)
        if result.pose is not None:
            self._move(slam.model.intrinsic, result.pose)
        values = {"fitness": result.fitness, "inlier rmse [m]": result.inlier_rmse} if result.iterations else {}
        self.stage.step(f"frame {result.index}: {result.verdict}", values)

    def loops(self, slam: Any, closure: Any, **_: Any) -> None:
        """The path and the model were corrected, where there was a loop."""
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

    def odometry(self, source: Any, target: Any, intrinsic: Any, result: Any, **_: Any) -> None:
        """A frame was aligned with another one; where that was the last one's, the path goes on."""
        if target is not self._image:
            self._pose = np.eye(4)
            if self._volume is None:  # else it is the volume that tells the path
                self.path = []
                self._move(intrinsic, self._pose)
        if result.reliable:
            self._pose = self._pose @ result.transformation
        self._image = source
        cloud = PointCloud.create_from_rgbd_image(source, intrinsic)
        self.stage.show("frame", cloud, share=SCAN_SHARE, pose=self._pose)
        if self._volume is None:
            self._move(intrinsic, self._pose)
        self._images += 1
        self.stage.step(f"frame {self._images}: {'; '.join(result.warnings) or 'aligned'}")

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
        self._axes += pose[:3, :3]
        self.look = look_over(self._axes, pose[:3, :3])

    def _draw_surface(self, share: int = 1) -> None:
        self._shown = self._count, share
        mesh = self._volume.extract_triangle_mesh(least_weight(self._volume.frame_count))
        if len(mesh):
            self.stage.show("surface", mesh, share=share, back_faces=False)


class Drive(Travel):
    """LiDAR odometry: the scan orange on the grey map."""

    def __init__(self, stage: Stage):
        super().__init__(stage)
        self._odometry: Any = None
        self._every, self._scans, self._shown = SURFACE_EVERY, 0, 0

    def events(self) -> dict[str, Callable[..., None]]:
        """As of Script."""
        return {"scan": self.scan}

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


def look_over(axes: Matrix, last: Matrix) -> Look:
    """A view over the shoulder of cameras, from the sum of their axes; of those that look all around, of the last."""
    (_, down, forward), count = axes.T, np.linalg.norm(axes, axis=0).max()
    if np.linalg.norm(forward) < ASTRAY * count or np.linalg.norm(np.cross(forward, down)) < ASTRAY * count**2:
        _, down, forward = last.T
    down, forward = down / np.linalg.norm(down), forward / np.linalg.norm(forward)
    x, y, z = (forward + TILT[0] * np.cross(down, forward) + TILT[1] * down).tolist()
    return (x, y, z), tuple((-down).tolist())

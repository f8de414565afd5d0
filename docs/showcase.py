"""Draw the images of the README and of the first page of the site: `python docs/showcase.py [NAME ...]`.

Writes docs/showcase/NAME.jpg, 1600 pixels wide, and docs/showcase/all.jpg. Only data whose license permits published
images is used. The folder that POINTLOOM_DATA names contains the real data. The image of the viewer needs Chromium.
"""

from __future__ import annotations

import functools
import io
import os
import shutil
import sys
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

import pointloom as loom
from pointloom.visualization.change.pictures import paint_change
from pointloom.visualization.render.canvas import Canvas

FOLDER = Path(__file__).with_name("showcase")
DATA = Path(os.environ.get("POINTLOOM_DATA", "."))
ROOM = DATA / "rgbd-cupoch-redwood5"
SIZE = (1600, 900)  # [px] of a rendered view
STRIP = 70  # [px] below it, for title and source
BORDER = 3  # [px]
QUALITY = 72  # of JPEG: the seven files together have about 1 MB
THUMBNAIL = (800, 485)  # [px] of one of six in the composition
ORANGE, BLUE, DARK, GRAY = (1.0, 0.706, 0.0), (0.0, 0.651, 0.929), (0.1, 0.1, 0.1), (0.45, 0.45, 0.45)

Pixels = NDArray[np.uint8]


@dataclass(frozen=True)
class Picture:
    """An image, and the lines below it."""

    draw: Callable[[], Pixels]
    title: str
    source: str


@functools.cache
def living_room_mesh() -> loom.TriangleMesh:
    """Fuse five RGB-D frames with the poses of their odometry."""
    volume = loom.TSDFVolume(voxel_size=0.006, truncation=0.03)
    for index, T in enumerate(living_room_poses()):
        color = loom.read_color(ROOM / f"color/{index:05}.jpg")
        depth = loom.read_depth(ROOM / f"depth/{index:05}.png")
        volume.integrate(depth, loom.PinholeCameraIntrinsic.prime_sense_default(), np.linalg.inv(T), color,
                         depth_scale=1000.0, depth_max=4.0)  # fmt: skip
    return volume.extract_triangle_mesh(weight_threshold=1.0)


def living_room_poses() -> NDArray[np.float64]:
    """The poses of the five cameras."""
    return np.array(loom.read_trajectory(ROOM / "trajectory.log").poses)


def living_room() -> Pixels:
    """Show the mesh from a position 25 cm behind the third camera."""
    T = living_room_poses()[2]
    T[:3, 3] -= 0.25 * T[:3, 2]
    wide = loom.PinholeCameraIntrinsic(*SIZE, 1150.0, 1150.0, 800.0, 450.0)
    return render({"geometry": living_room_mesh(), "shaded": False}, loom.View(wide, T))


def city() -> Pixels:
    """Color an airborne scan by height above the ground."""
    cloud = loom.read_point_cloud(DATA / "lidar-pcl-terrain/samp12-utm.pcd").remove_statistical_outlier(20, 3.0)[0]
    cloud["classification"] = np.where(loom.classify_ground(cloud, max_window=40.0), 2, 1).astype(np.uint8)
    cloud["height above ground"] = loom.height_above_ground(cloud, reach=60.0)
    scene = {"geometry": cloud.estimate_normals(radius=3.0, max_nn=15), "color_by": "height above ground",
             "limits": (-8.0, 26.0), "colormap": "turbo", "point_size": 2.3, "metric": True}  # fmt: skip
    return render(scene, {"front": [0.1, -0.55, 0.8], "up": [0, 0, 1], "zoom": 0.36})


def registration() -> Pixels:
    """Register two views of a depth camera, before on the left and after on the right."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the files have the identity as viewpoint
        views = [loom.read_point_cloud(DATA / f"pcl-data-tutorials/pairwise/capture000{k}.pcd") for k in (1, 4)]
    target, source = (cloud.remove_non_finite_points().estimate_normals(radius=0.06, max_nn=60)
                      .orient_normals_towards_camera_location() for cloud in views)  # fmt: skip
    thin = [cloud.voxel_down_sample(0.02) for cloud in (source, target)]
    result = loom.registration.register_globally(*thin, voxel_size=0.05)
    moved = source.transform(result.transformation)
    width, height = SIZE[0] // 2, SIZE[1]
    view = loom.View.fit(target.points, direction=(0.15, 0.3, 1.0), up=(0, -1, 0), width=width, height=height)
    style = {"shaded": True, "point_size": 2.5}
    sides = [
        loom.render([{"geometry": target, "color": BLUE, **style}, {"geometry": cloud, "color": ORANGE, **style}], view,
                    (width, height))
        for cloud in (source, moved)
    ]  # fmt: skip
    return np.concatenate([np.asarray(side) for side in sides], axis=1)


def viewer() -> Pixels:
    """Take a screenshot of the viewer in Chromium."""
    from playwright.sync_api import sync_playwright

    shown = loom.draw({"geometry": living_room_mesh(), "shaded": False}, port=0, block=False, open_browser=False,
                      front=(-living_room_poses()[2, :3, 2] + [0.0, 0.3, 0.35]).tolist(), up=[0, 1, 0],
                      zoom=0.5)  # fmt: skip
    assert isinstance(shown, loom.Viewer)
    with sync_playwright() as playwright:
        flags = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
        path = os.environ.get("POINTLOOM_CHROMIUM") or shutil.which("chromium")
        browser = playwright.chromium.launch(executable_path=path, args=flags, chromium_sandbox=False)
        page = browser.new_page(viewport={"width": SIZE[0], "height": SIZE[1]})
        page.goto(shown.url)
        page.evaluate("async () => { await pointloom.ready(); }")
        page.locator("#progress").wait_for(state="hidden")  # shown until the last level of detail is sent
        page.evaluate("async () => { await pointloom.ready(); }")
        screenshot = page.screenshot()
        browser.close()
    shown.close()
    return np.asarray(Image.open(io.BytesIO(screenshot)).convert("RGB"))


def photographs() -> Pixels:
    """Reconstruct a textured figure from 24 photographs with known poses."""
    shots = loom.datasets.photographs(24)
    camera = shots.intrinsic.scaled(0.5)
    posed = [loom.photogrammetry.PosedCamera(camera, np.linalg.inv(T)) for T in shots.poses]
    small = [np.asarray(Image.fromarray(image).resize((camera.width, camera.height), Image.Resampling.BOX))
             for image in shots.images]  # fmt: skip
    maps = loom.photogrammetry.filter_depth_maps(loom.photogrammetry.estimate_depth_maps(small, posed))
    mesh = loom.photogrammetry.fuse_depth_maps(maps, small, to="tsdf")
    cloth = loom.AxisAlignedBoundingBox([-0.4, -0.4, -1.0], [0.4, 0.4, 1.0])
    frusta = [loom.CameraFrustum(camera, T, scale=0.05, color=(0.85, 0.35, 0.1)) for T in shots.poses]
    camera_view = loom.View.fit(shots.poses[:, :3, 3], direction=(-0.2, 1.0, -0.5), width=SIZE[0], height=SIZE[1])
    return render([{"geometry": mesh.crop(cloth), "shaded": False}, *frusta], camera_view)


def change() -> Pixels:
    """Measure the change of a slope between two surveys."""
    rng = np.random.default_rng(0)

    def survey(slide: float) -> loom.PointCloud:
        x, y = rng.random((2, 600_000)) * [[200], [140]]
        z = 0.004 * (y - 70) ** 2 + 3 * np.sin(x / 25) + np.cos(x / 6 + y / 9)
        scar = np.exp(-(((x - 80) / 22) ** 2) - ((y - 105) / 12) ** 2)
        tongue = np.exp(-(((x - 85 - 3 * np.sin(y / 7)) / 15) ** 2) - ((y - 60) / 20) ** 2)
        return loom.PointCloud(np.column_stack([x, y, z + slide * (0.8 * tongue - 1.2 * scar)
                                                + 0.03 * rng.normal(size=len(x))]))  # fmt: skip

    before, after = survey(0), survey(1)
    cores = before.thin(0.4)
    result = loom.m3c2(before, after, core_points=cores, normal_radii=[1.5, 3.0], cylinder_radius=1.0,
                       max_distance=3.0, registration_error=0.01)  # fmt: skip
    painted = paint_change(cores, result).estimate_normals(radius=2.0, max_nn=20)
    return render({"geometry": painted.orient_normals_to_align_with_direction(), "shaded": True},
                  {"front": [-0.25, -0.75, 0.6], "up": [0, 0, 1], "zoom": 0.36})  # fmt: skip


def render(scene: Any, camera: object, **options: Any) -> Pixels:
    """Render with the size of all images."""
    return np.asarray(loom.render(scene, camera, SIZE, **options))


PICTURES = {
    "living_room": Picture(living_room, "RGB-D frames to a mesh", "Data: Redwood (Choi, Zhou, Koltun 2015), CC BY"),
    "city": Picture(city, "Airborne LiDAR of a city, colored by height above ground",
                    "Data: ISPRS filter test, in the test data of PCL, BSD"),
    "registration": Picture(registration, "Two scans before and after registration",
                            "Data: tutorials of PCL (pairwise registration), BSD"),
    "viewer": Picture(viewer, "The viewer in a browser", "Data: Redwood (Choi, Zhou, Koltun 2015), CC BY"),
    "photographs": Picture(photographs, "24 photographs to a mesh", "Data: synthetic, loom.datasets.photographs"),
    "change": Picture(change, "Change of a slope: loss blue, gain red", "Data: synthetic, from docs/change.md"),
}  # fmt: skip


def framed(picture: Picture) -> Pixels:
    """The view with a border, and title and source below it."""
    width, height = SIZE
    sheet = Canvas.blank(width, height + STRIP, (1, 1, 1), "cpu")
    sheet.image(picture.draw(), 0, 0)
    sheet.rectangle(0, 0, width, height + STRIP, outline=GRAY, line_width=BORDER)
    sheet.rectangle(0, height, width, BORDER, fill=GRAY)
    sheet.text(picture.title, 24, height + STRIP / 2, size=30, color=DARK)
    sheet.text(picture.source, width - 24, height + STRIP / 2, size=22, color=GRAY, anchor="right")
    return sheet.to_numpy()


def compose() -> Image.Image:
    """All images, two in a row."""
    width, height = THUMBNAIL
    sheet = Image.new("RGB", (2 * width, height * -(-len(PICTURES) // 2)), "white")
    for k, name in enumerate(PICTURES):
        image = Image.open(FOLDER / f"{name}.jpg").resize(THUMBNAIL, Image.Resampling.LANCZOS)
        sheet.paste(image, ((k % 2) * width, (k // 2) * height))
    return sheet


def main() -> None:
    """Draw the named images, or all of them."""
    FOLDER.mkdir(exist_ok=True)
    for name in sys.argv[1:] or PICTURES:
        Image.fromarray(framed(PICTURES[name])).save(FOLDER / f"{name}.jpg", quality=QUALITY, optimize=True)
    if all((FOLDER / f"{name}.jpg").exists() for name in PICTURES):
        compose().save(FOLDER / "all.jpg", quality=QUALITY, optimize=True)


if __name__ == "__main__":
    main()

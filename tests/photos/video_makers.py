"""Videos and photographs that go wrong, made of the demo's room: what structure from motion meets in the world.

Each writes one thing and gives what is known of it. Pictures are small unless a size is given; all have the same bits
from run to run up to what ffmpeg does.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

import pointloom as loom
from pointloom.data.scenes.room import room_views
from pointloom.data.scenes.room_paths import look_along
from pointloom.data.scenes.room_video import room_video_poses
from pointloom.drawing.recording.video import write_mp4
from pointloom.files.pictures.image_files import write_png

SIZE = (320, 240)
DENSE = 240  # frames of a round that are as near to each other as those of a video


def camera_of(size=SIZE, focal=None):
    """A pinhole camera with the field of view of the demo's, 63 degrees, unless a focal length [px] is given."""
    width, height = size
    focal = 525.0 * width / 640 if focal is None else focal
    return loom.PinholeCameraIntrinsic(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2)


def pictures_from(poses, size=SIZE, **options: Any) -> list[np.ndarray]:
    """What cameras at these places see, uint8 [h, w, 3] each."""
    return [frame.color for frame in room_views(poses, camera_of(size), **options)]


def round_pictures(count, size=SIZE, *, first=0, of=DENSE) -> list[np.ndarray]:
    """Frames of the walk through the room; 240 in a round are as dense as a video, 30 as photographs."""
    return pictures_from(room_video_poses(of)[first : first + count], size)


def write_video(path: Path, pictures, *, fps=10.0) -> Path:
    """An MP4 by ffmpeg, its index at the front."""
    with path.open("wb") as file:
        write_mp4(file, iter(pictures), fps, path)
    return path


def write_jpegs(folder: Path, pictures, *, orientations=None) -> Path:
    """000.jpg and so on; with EXIF orientations (1 to 8) pixels are stored so that a viewer shows them upright."""
    folder.mkdir()
    stored = {
        1: lambda a: a,
        2: lambda a: a[:, ::-1],
        3: lambda a: a[::-1, ::-1],
        4: lambda a: a[::-1],
        5: lambda a: a.swapaxes(0, 1),
        6: lambda a: np.rot90(a),
        7: lambda a: a[::-1, ::-1].swapaxes(0, 1),
        8: lambda a: np.rot90(a, -1),
    }
    for k, picture in enumerate(pictures):
        exif = Image.Exif()
        turn = 1 if orientations is None else orientations[k % len(orientations)]
        if orientations is not None:
            exif[0x0112] = turn
        pixels = np.ascontiguousarray(stored[turn](picture))
        Image.fromarray(pixels).save(folder / f"{k:03d}.jpg", quality=95, subsampling=0, exif=exif)
    return folder


# ---------------------------------------------------------------------------------------------------- ways to film


def turning_poses(count=60, *, degrees=120.0, tremble=0.0, seed=0) -> np.ndarray:
    """A camera that only turns; `tremble` [m] is what a hand that tries to hold it adds."""
    shift = np.random.default_rng(seed).normal(0, 1, (count, 3)) * tremble
    yaw = np.radians(np.linspace(0, degrees, count)) + 0.3
    return np.array(
        [
            look_along(np.array([2.4, 2.0, 1.5]) + s, (np.cos(a), np.sin(a), -0.1))
            for a, s in zip(yaw, shift, strict=True)
        ]
    )


def two_places_poses(count=12) -> np.ndarray:
    """`count` places along each of two opposite walls, looking at it: the two halves share nothing that is seen."""
    along = np.linspace(-0.6, 0.6, count)
    first = [look_along(np.array([2.2, 2.0 + a, 1.4]), (1.0, -0.12 * a, -0.1)) for a in along]
    second = [look_along(np.array([2.8, 2.0 - a, 1.4]), (-1.0, 0.12 * a, -0.1)) for a in along]
    return np.array(first + second)


def arc_poses(count=12, *, radius=1.6) -> np.ndarray:
    """Places on an arc about the sofa's corner of the room, all looking at one point: each sees what the next does."""
    target = np.array([1.2, 3.2, 0.8])
    angles = np.radians(np.linspace(-70, 10, count))
    eyes = [target + radius * np.array([np.cos(a), np.sin(a), 0.45]) for a in angles]
    return np.array([look_along(eye, tuple(target - eye)) for eye in eyes])


def blur_pictures(pictures, blurred, *, length=9) -> list[np.ndarray]:
    """Some pictures as a hand that jerks takes them: each row is the mean of `length` columns side by side."""
    made = [picture.copy() for picture in pictures]
    for k in blurred:
        wide = np.pad(made[k].astype(np.float64), ((0, 0), (length // 2, length // 2), (0, 0)), mode="edge")
        sums = np.cumsum(np.concatenate([np.zeros_like(wide[:, :1]), wide], axis=1), axis=1)
        made[k] = np.rint((sums[:, length:] - sums[:, :-length]) / length).astype(np.uint8)
    return made


def blacken_pictures(pictures, black) -> list[np.ndarray]:
    """Some pictures as a covered lens takes them: black, with the noise of the sensor."""
    rng = np.random.default_rng(0)
    made = [picture.copy() for picture in pictures]
    for k in black:
        made[k] = np.clip(np.rint(rng.normal(0, 2, made[k].shape)), 0, 255).astype(np.uint8)
    return made


def truncate(path: Path, share=0.5) -> Path:
    """Cut the end off a file, as a transfer that broke does; an MP4 of `write_video` still says how long it was."""
    data = path.read_bytes()
    path.write_bytes(data[: int(len(data) * share)])
    return path


# ---------------------------------------------------------------------------------------------- other photographs


def write_grey_pngs(folder: Path, pictures, *, bits=8) -> Path:
    """Greyscale PNGs of 8 or 16 bits; those of 16 have 256 steps between two of 8, and start at 000.png too."""
    folder.mkdir()
    for k, picture in enumerate(pictures):
        grey = picture.astype(np.float64) @ (0.299, 0.587, 0.114)
        scaled = np.rint(grey * (257.0 if bits == 16 else 1.0))
        write_png(folder / f"{k:03d}.png", scaled.astype(np.uint16 if bits == 16 else np.uint8))
    return folder


def write_mixed_sizes(folder: Path, poses, sizes=((320, 240), (240, 320), (400, 300))) -> Path:
    """JPEGs of several sizes, as of several cameras, one after the other."""
    folder.mkdir()
    for k, pose in enumerate(poses):
        picture = pictures_from([pose], sizes[k % len(sizes)])[0]
        Image.fromarray(picture).save(folder / f"{k:03d}.jpg", quality=95, subsampling=0)
    return folder


def distorted_pictures(poses, camera, *, finer=2) -> list[np.ndarray]:
    """What a camera with a lens sees: a CameraModel of any kind that unprojects all its pixels.

    The room is rendered through a pinhole that sees as far as the corners, `finer` times as dense, and read between
    its pixels along the rays of the lens.
    """
    v, u = np.mgrid[: camera.height, : camera.width].reshape(2, -1)
    rays = np.asarray(camera.unproject(np.column_stack([u, v]).astype(np.float64)))
    assert np.isfinite(rays).all(), "the lens does not unproject all its pixels"
    reach = np.abs(rays[:, :2] / rays[:, 2:]).max(axis=0) * 1.02
    focal = finer * float(camera.params[0])
    size = tuple(int(2 * np.ceil(r * focal)) for r in reach)
    wide = camera_of(size, focal)
    x = rays[:, 0] / rays[:, 2] * focal + wide.cx
    y = rays[:, 1] / rays[:, 2] * focal + wide.cy
    i, j = np.clip(np.floor(x).astype(int), 0, size[0] - 2), np.clip(np.floor(y).astype(int), 0, size[1] - 2)
    fx, fy = (x - i)[:, None], (y - j)[:, None]
    made = []
    for k, frame in enumerate(room_views(poses, wide, color_noise=0)):
        c = frame.color.astype(np.float64)
        upper, lower = ((c[row, i] * (1 - fx) + c[row, i + 1] * fx) for row in (j, j + 1))
        light = upper * (1 - fy) + lower * fy + np.random.default_rng(k).normal(0, 2, (len(u), 3))
        made.append(np.clip(np.rint(light), 0, 255).astype(np.uint8).reshape(camera.height, camera.width, 3))
    return made


def strong_lens(size=SIZE, model="OPENCV"):
    """A lens that bends straight lines clearly, by 8 to 20 % at the corners; parameters as COLMAP stores them."""
    width, height = size
    focal = 0.7 * width
    params = {
        "SIMPLE_RADIAL": [focal, width / 2, height / 2, -0.12],
        "RADIAL": [focal, width / 2, height / 2, -0.28, 0.06],
        "OPENCV": [focal, focal, width / 2, height / 2, -0.28, 0.06, 0.001, -0.001],
        "OPENCV_FISHEYE": [0.5 * width, 0.5 * width, width / 2, height / 2, 0.02, -0.01, 0.0, 0.0],
    }
    return loom.CameraModel(model, width, height, params[model])


def spheres_from(poses, height=256, *, finer=2) -> list[np.ndarray]:
    """What cameras at these places see in all directions, equirectangular, uint8 [height, 2 height, 3] each.

    Six pinholes of 90 degrees are rendered, `finer` times as dense, and read between their pixels.
    """
    side = finer * height // 2
    faces = loom.Panorama(2 * height, height, side=side)
    v, u = np.mgrid[:height, : 2 * height].reshape(2, -1)
    longitude, latitude = (u + 0.5) / height * np.pi - np.pi, np.pi / 2 - (v + 0.5) / height * np.pi
    across = np.cos(latitude)
    rays = np.column_stack([across * np.sin(longitude), -np.sin(latitude), across * np.cos(longitude)])
    made = []
    for k, pose in enumerate(np.asarray(poses)):
        light = np.random.default_rng(k).normal(0, 2, (len(u), 3))
        forward = np.stack([rays @ turn[:, 2] for turn in faces.turns])
        nearest = forward.argmax(axis=0)
        for n, turn in enumerate(faces.turns):
            mine = np.flatnonzero(nearest == n)
            T = np.array(pose, np.float64)
            T[:3, :3] = pose[:3, :3] @ turn
            face = next(iter(room_views([T], faces.intrinsic, color_noise=0))).color.astype(np.float64)
            seen = rays[mine] @ turn
            x = seen[:, 0] / seen[:, 2] * faces.intrinsic.fx + faces.intrinsic.cx
            y = seen[:, 1] / seen[:, 2] * faces.intrinsic.fy + faces.intrinsic.cy
            i, j = (np.clip(np.floor(each).astype(int), 0, side - 2) for each in (x, y))
            fx, fy = np.clip(x - i, 0, 1)[:, None], np.clip(y - j, 0, 1)[:, None]
            upper, lower = ((face[row, i] * (1 - fx) + face[row, i + 1] * fx) for row in (j, j + 1))
            light[mine] += upper * (1 - fy) + lower * fy
        made.append(np.clip(np.rint(light), 0, 255).astype(np.uint8).reshape(height, 2 * height, 3))
    return made

"""Reliability of structure from motion: are wrong focal lengths reported, and correct ones accepted?

    python benchmarks/trust/images.py [CASE ...]      the cases, or those with this in their name, as rows

Synthetic images of the furnished room and of terrain, with exact cameras, and real sets with known cameras. A result is
wrong if a focal length is off by more than 5 %, the camera centers by more than 1 % of their extent (RMS after the best
similarity), or fewer than 60 % of the images are registered.
"""

from __future__ import annotations

import shutil
import sys
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import image_scenes as scenes
import numpy as np
from image_scenes import FOCAL, Shots
from judged import Case, Judged, table
from real_data import DataMissingError, real_data
from sfm_accuracy import camera_errors

import pointloom as loom

AREA = "focal length"
WRONG_FOCAL, WRONG_CENTERS, MIN_REGISTERED = 0.05, 0.01, 0.6
FEATURES = 1000
COUNT = 12  # images of the room: 66 pairs

Truth = dict[str, tuple[np.ndarray | None, float]]  # by name: pose, if known, and focal length relative to the width


@dataclass(frozen=True)
class ImageSet:
    """A set of images and the reconstruction options.

    Attributes:
        name: A short description.
        make: Writes the images into a folder and returns their ground truth.
        options: Fields of `loom.photogrammetry.SfmSettings`.
        held_out: True if no constant was chosen on it.
    """

    name: str
    make: Callable[[Path], Truth]
    options: dict[str, Any] = field(default_factory=dict)
    held_out: bool = True


def made(shots: Callable[[], Shots]) -> Callable[[Path], Truth]:
    """A case function for synthetic images."""

    def write(folder: Path) -> Truth:
        written = shots().write(folder)
        return {name: (pose, camera.params[0] / camera.width) for name, (pose, camera) in written.items()}

    return write


def with_exif(shots: Shots) -> Shots:
    """The same, with EXIF as written by a telephone: 35 mm equivalent in integer millimeters."""
    film_lengths = [scenes.film_length(camera) for camera in shots.cameras]
    shots.exif = [("Made 1", round(0.15 * film, 2), film) for film in film_lengths]
    return shots


def zoomed(factor: float) -> Shots:
    """The room, with another focal length in every second image."""
    return scenes.room(scenes.straight_path(COUNT), [FOCAL * (factor if k % 2 else 1.0) for k in range(COUNT)])


def plain_room(poses: np.ndarray, **options: Any) -> Shots:
    return scenes.room(poses, [FOCAL] * len(poses), **options)


def separate_groups() -> Shots:
    """Two parts of the room without overlap."""
    path = scenes.straight_path(60, 1 / 60)
    return plain_room(np.concatenate([path[:6], path[30:36]]))


def one_image() -> Shots:
    """The same image repeated, with camera noise."""
    first, rng = plain_room(scenes.straight_path(1)), np.random.default_rng(0)
    light = first.images[0].astype(np.float64)
    images = [np.clip(np.rint(light + rng.normal(0, 2, light.shape)), 0, 255).astype(np.uint8) for _ in range(COUNT)]
    return Shots(np.repeat(first.poses, COUNT, axis=0), first.cameras * COUNT, images)


def flight(relief: float, *, lens: bool, tilt: float = 0.0, tremble: float = 1.5) -> Shots:
    """A flight over terrain, with a lens that differs from COLMAP's default model and a rolling shutter, or without
    these.
    """
    bent = [500.0, 500.0, 324.0, 237.0, -0.05, 0.04, 0.0008, -0.0006]
    camera = loom.CameraModel("OPENCV", 640, 480, bent) if lens else scenes.pinhole(500.0)
    poses = scenes.flight(columns=5, tilt=tilt, tremble=tremble)
    return scenes.flown(scenes.ground(relief), poses, camera, rolled=0.25 if lens else 0.0)


def given(focal: float) -> dict[str, Any]:
    return {"intrinsic": loom.PinholeCameraIntrinsic(640, 480, focal, focal, 319.5, 239.5)}


def real(
    folder: str, pattern: str, focal: float, *, stride: int = 1, stop: int | None = None
) -> Callable[[Path], Truth]:
    """A case function for real images with known focal length relative to the width, reduced to at most 1000 pixels."""

    def write(folder_of_set: Path) -> Truth:
        with tempfile.TemporaryDirectory() as name:
            for path in sorted(real_data(folder).glob(pattern))[:stop:stride]:
                shutil.copy(path, name)
            choice = loom.photogrammetry.choose_frames(name, folder_of_set, max_size=1000)
        return dict.fromkeys(choice.names, (None, focal))

    return write


def all_cases() -> list[ImageSet]:
    """The room and the flights whose wrong results were once accepted, and correct cases."""
    path, used = scenes.straight_path(COUNT), {"held_out": False}
    flat = lambda: flight(0.4, lens=True, tremble=0.4)  # noqa: E731
    return [
        ImageSet("room", made(lambda: plain_room(path)), **used),
        ImageSet("room, every second image at 1.5 times the focal length", made(lambda: zoomed(800 / FOCAL)), **used),
        ImageSet("the same with EXIF", made(lambda: with_exif(zoomed(800 / FOCAL))), **used),
        ImageSet("room, every second image at 1.2 times the focal length", made(lambda: zoomed(1.2))),
        ImageSet("room, given 600 px for 525", made(lambda: plain_room(path)), given(600.0), **used),
        ImageSet("room, given 700 px for 525", made(lambda: plain_room(path)), given(700.0), **used),
        ImageSet("room, given 490 px for 525", made(lambda: plain_room(path)), given(490.0)),
        ImageSet("room, given 525 px", made(lambda: plain_room(path)), given(525.0)),
        ImageSet("room, zoomed, given 525 px", made(lambda: zoomed(800 / FOCAL)), given(525.0)),
        ImageSet("straight ahead", made(lambda: plain_room(scenes.dolly())), **used),
        ImageSet("straight ahead with EXIF", made(lambda: with_exif(plain_room(scenes.dolly())))),
        ImageSet("along a wall without turning", made(lambda: plain_room(scenes.sideways(COUNT)))),
        ImageSet("flight over low hills, a lens with errors", made(flat)),
        ImageSet("flight over low hills with EXIF", made(lambda: with_exif(flat()))),
        ImageSet("flight over hills, a pinhole", made(lambda: flight(1.5, lens=False)), **used),
        ImageSet("flight over flat ground, a pinhole that sways", made(lambda: flight(0.0, lens=False)), **used),
        ImageSet(
            "flight over flat ground, tilted to and fro", made(lambda: flight(0.0, lens=False, tilt=25.0)), **used
        ),
        ImageSet("two rooms", made(separate_groups), **used),
        ImageSet("turning only", made(lambda: plain_room(scenes.turning(COUNT))), **used),
        ImageSet("one image twelve times", made(one_image), **used),
        ImageSet("room without texture", made(lambda: plain_room(path, texture=False, color_noise=2.0)), **used),
        ImageSet("temple", real("mvs-temple", "*.png", 1520.4 / 640)),
        ImageSet("Sceaux", real("mvs-sceaux/images", "*.JPG", 2905.88 / 2832)),
        ImageSet("fountain", real("mvs-fountain-p11/images", "*.jpg", 2761.0 / 3072)),
        ImageSet("kitchen", real("rgbd-7scenes-redkitchen", "*.color.jpg", 525.0 / 640, stride=15, stop=300)),
    ]


def judge_case(case: ImageSet) -> Judged:
    """Create the images of a case, reconstruct them, and compare with the ground truth."""
    with tempfile.TemporaryDirectory() as name:
        truth = case.make(Path(name) / "images")
        settings = loom.photogrammetry.SfmSettings(**{"max_features": FEATURES} | case.options)
        result = loom.photogrammetry.reconstruct_images(Path(name) / "images", Path(name) / "work", settings)
    wrong, error = errors_of(result.model, truth)
    refused = not result.reliable
    notes = "; ".join(filter(None, ["; ".join(result.warnings), *result.quality.notes]))
    return Judged(
        AREA, case.name, 1, wrong, wrong and not refused, refused and not wrong, notes, error, "", case.held_out
    )


def errors_of(model: loom.SfmModel | None, truth: Truth) -> tuple[int, str]:
    """Whether a model is wrong, and its errors."""
    if model is None or len(model) < MIN_REGISTERED * len(truth):
        return 1, f"{0 if model is None else len(model)} of {len(truth)} placed"
    differences = [
        camera.params[0] / camera.width / truth[name][1] - 1
        for name, camera in zip(model.names, model.cameras, strict=True)
    ]
    worst, centers = max(differences, key=abs), 0.0
    message = f"focal length {100 * worst:+.1f} %"
    if all(truth[name][0] is not None for name in model.names):
        centers = camera_errors(model, {name: truth[name][0] for name in model.names})["fraction_of_extent"]
        message += f", centers {100 * centers:.2f} %"
    return int(abs(worst) > WRONG_FOCAL or centers > WRONG_CENTERS), message


def cases() -> Iterator[Case]:
    for each in all_cases():
        yield Case(each.name, lambda each=each: [judge_case(each)])


def main() -> None:
    names = sys.argv[1:]
    print(*table([])[:2], sep="\n", flush=True)
    for case in cases():
        if not names or any(word in case.name for word in names):
            try:
                print(table(case.judge())[-1], flush=True)
            except DataMissingError as error:
                print(f"{case.name}: left out, {error}", file=sys.stderr)


if __name__ == "__main__":
    main()

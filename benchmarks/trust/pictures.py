"""Reliability of structure from motion: are wrong focal lengths reported, and correct ones accepted?

    python benchmarks/trust/pictures.py [CASE ...]      the cases, or those with this in their name, as rows

Made pictures of the furnished room and of ground from above, with exact cameras, and real sets whose cameras are known.
A result is wrong if a focal length is more than 5 % off, the centers of the cameras more than 1 % of their extent
(root mean square, after the similarity that fits best), or fewer than 60 % of the pictures are placed.
"""

from __future__ import annotations

import shutil
import sys
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import picture_scenes as scenes
from judged import Judged, table
from picture_scenes import FOCAL, Shots
from real_data import DataMissingError, real_data
from sfm_accuracy import camera_errors

import pointloom as loom

AREA = "focal length"
WRONG_FOCAL, WRONG_CENTERS, MIN_PLACED = 0.05, 0.01, 0.6
FEATURES = 1000
COUNT = 12  # pictures of the room: 66 pairs

Truth = dict[str, tuple[np.ndarray | None, float]]  # pose, where it is known, and focal length over the width, by name


@dataclass(frozen=True)
class Case:
    """A set of pictures, and how it is given.

    Attributes:
        name: In a few words.
        make: Writes the pictures into a folder, and gives what is true of them.
        options: Of `loom.sfm.reconstruct`.
        held_out: Whether it chose no constant.
    """

    name: str
    make: Callable[[Path], Truth]
    options: dict[str, Any] = field(default_factory=dict)
    held_out: bool = True


def made(shots: Callable[[], Shots]) -> Callable[[Path], Truth]:
    """Of made pictures."""

    def write(folder: Path) -> Truth:
        written = shots().write(folder)
        return {name: (pose, camera.params[0] / camera.width) for name, (pose, camera) in written.items()}

    return write


def with_exif(shots: Shots) -> Shots:
    """The same, with EXIF as a telephone writes it: whole millimeters in terms of 35 mm film."""
    said = [scenes.film_length(camera) for camera in shots.cameras]
    shots.exif = [("Made 1", round(0.15 * film, 2), film) for film in said]
    return shots


def zoomed(factor: float) -> Shots:
    """The room, every second picture with another focal length."""
    return scenes.room(scenes.walk(COUNT), [FOCAL * (factor if k % 2 else 1.0) for k in range(COUNT)])


def plain_room(poses: np.ndarray, **options: Any) -> Shots:
    return scenes.room(poses, [FOCAL] * len(poses), **options)


def two_rooms() -> Shots:
    """Two parts of the room that have nothing in common."""
    walk = scenes.walk(60, 1 / 60)
    return plain_room(np.concatenate([walk[:6], walk[30:36]]))


def one_picture() -> Shots:
    """One picture again and again, with the noise of a camera."""
    first, rng = plain_room(scenes.walk(1)), np.random.default_rng(0)
    light = first.pictures[0].astype(np.float64)
    pictures = [np.clip(np.rint(light + rng.normal(0, 2, light.shape)), 0, 255).astype(np.uint8) for _ in range(COUNT)]
    return Shots(np.repeat(first.poses, COUNT, axis=0), first.cameras * COUNT, pictures)


def flight(relief: float, *, lens: bool, tilt: float = 0.0, tremble: float = 1.5) -> Shots:
    """A flight over ground, by a lens that COLMAP's usual model does not quite fit and a shutter that rolls, or not."""
    bent = [500.0, 500.0, 324.0, 237.0, -0.05, 0.04, 0.0008, -0.0006]
    camera = loom.CameraModel("OPENCV", 640, 480, bent) if lens else scenes.pinhole(500.0)
    poses = scenes.flight(columns=5, tilt=tilt, tremble=tremble)
    return scenes.flown(scenes.ground(relief), poses, camera, rolled=0.25 if lens else 0.0)


def given(focal: float) -> dict[str, Any]:
    return {"intrinsic": loom.PinholeCameraIntrinsic(640, 480, focal, focal, 319.5, 239.5)}


def real(
    folder: str, pattern: str, focal: float, *, stride: int = 1, most: int | None = None
) -> Callable[[Path], Truth]:
    """Of real pictures whose focal length over the width is known, made at most 1000 pixels wide."""

    def write(place: Path) -> Truth:
        with tempfile.TemporaryDirectory() as name:
            for path in sorted(real_data(folder).glob(pattern))[:most:stride]:
                shutil.copy(path, name)
            choice = loom.sfm.choose_frames(name, place, max_size=1000)
        return dict.fromkeys(choice.names, (None, focal))

    return write


def all_cases() -> list[Case]:
    """The room and the flights whose wrong results were accepted once, and correct cases beside them."""
    walk, used = scenes.walk(COUNT), {"held_out": False}
    flat = lambda: flight(0.4, lens=True, tremble=0.4)  # noqa: E731
    return [
        Case("room", made(lambda: plain_room(walk)), **used),
        Case("room, every second picture at 1.5 times the focal length", made(lambda: zoomed(800 / FOCAL)), **used),
        Case("the same with EXIF", made(lambda: with_exif(zoomed(800 / FOCAL))), **used),
        Case("room, every second picture at 1.2 times the focal length", made(lambda: zoomed(1.2))),
        Case("room, given 600 px for 525", made(lambda: plain_room(walk)), given(600.0), **used),
        Case("room, given 700 px for 525", made(lambda: plain_room(walk)), given(700.0), **used),
        Case("room, given 490 px for 525", made(lambda: plain_room(walk)), given(490.0)),
        Case("room, given 525 px", made(lambda: plain_room(walk)), given(525.0)),
        Case("room, zoomed, given 525 px", made(lambda: zoomed(800 / FOCAL)), given(525.0)),
        Case("straight ahead", made(lambda: plain_room(scenes.dolly())), **used),
        Case("straight ahead with EXIF", made(lambda: with_exif(plain_room(scenes.dolly())))),
        Case("along a wall without turning", made(lambda: plain_room(scenes.sideways(COUNT)))),
        Case("flight over low hills, a lens with errors", made(flat)),
        Case("flight over low hills with EXIF", made(lambda: with_exif(flat()))),
        Case("flight over hills, a pinhole", made(lambda: flight(1.5, lens=False)), **used),
        Case("flight over flat ground, a pinhole that sways", made(lambda: flight(0.0, lens=False)), **used),
        Case("flight over flat ground, tilted to and fro", made(lambda: flight(0.0, lens=False, tilt=25.0)), **used),
        Case("two rooms", made(two_rooms), **used),
        Case("turning only", made(lambda: plain_room(scenes.turning(COUNT))), **used),
        Case("one picture twelve times", made(one_picture), **used),
        Case("room without texture", made(lambda: plain_room(walk, texture=False, color_noise=2.0)), **used),
        Case("temple", real("mvs-temple", "*.png", 1520.4 / 640)),
        Case("Sceaux", real("mvs-sceaux/images", "*.JPG", 2905.88 / 2832)),
        Case("fountain", real("mvs-fountain-p11/images", "*.jpg", 2761.0 / 3072)),
        Case("kitchen", real("rgbd-7scenes-redkitchen", "*.color.jpg", 525.0 / 640, stride=15, most=300)),
    ]


def judge_case(case: Case) -> Judged:
    """Make the pictures of a case, find where they were taken, and hold that against the truth."""
    with tempfile.TemporaryDirectory() as name:
        truth = case.make(Path(name) / "pictures")
        options = {"max_features": FEATURES} | case.options
        result = loom.sfm.reconstruct(Path(name) / "pictures", Path(name) / "work", **options)
    wrong, error = errors_of(result.model, truth)
    refused = not result.reliable
    said = "; ".join(filter(None, ["; ".join(result.warnings), *result.quality.notes]))
    return Judged(
        AREA, case.name, 1, wrong, wrong and not refused, refused and not wrong, said, error, "", case.held_out
    )


def errors_of(model: loom.SfmModel | None, truth: Truth) -> tuple[int, str]:
    """Whether a model is wrong, and by how much."""
    if model is None or len(model) < MIN_PLACED * len(truth):
        return 1, f"{0 if model is None else len(model)} of {len(truth)} placed"
    off = [
        camera.params[0] / camera.width / truth[name][1] - 1
        for name, camera in zip(model.names, model.cameras, strict=True)
    ]
    worst, centers = max(off, key=abs), 0.0
    said = f"focal length {100 * worst:+.1f} %"
    if all(truth[name][0] is not None for name in model.names):
        centers = camera_errors(model, {name: truth[name][0] for name in model.names})["share_of_extent"]
        said += f", centers {100 * centers:.2f} %"
    return int(abs(worst) > WRONG_FOCAL or centers > WRONG_CENTERS), said


def judge() -> Iterator[Judged]:
    """All cases, one after the other; those whose data are missing are left out with a line on standard error."""
    yield from judged_cases(all_cases())


def judged_cases(cases: list[Case]) -> Iterator[Judged]:
    for case in cases:
        try:
            yield judge_case(case)
        except DataMissingError as error:
            print(f"{case.name}: left out, {error}", file=sys.stderr)


def main() -> None:
    wanted = sys.argv[1:]
    chosen = [case for case in all_cases() if not wanted or any(word in case.name for word in wanted)]
    print(*table([])[:2], sep="\n", flush=True)
    for each in judged_cases(chosen):
        print(table([each])[-1], flush=True)


if __name__ == "__main__":
    main()

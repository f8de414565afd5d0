"""From the arbitrary unit and frame of structure from motion to metres: by a factor, a distance, or known places."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...pcd.checks import check_positive, shown
from ...pcd.errors import FileError
from ...pcd.io.trajectory import read_lines, read_trajectory
from ...registration.rigid import fit_pose
from ..reconstruction.records import digest_of_file

FilePath = str | os.PathLike[str]

FEWEST = 3  # known places that settle a similarity
FLAT = 1e-3  # of the places' extent along a line: below, the turn about that line is anybody's guess
DOUBTED = 0.05  # of the places' extent, between the places known and those found

ARBITRARY = "arbitrary"
METRES = "metres"


@dataclass(frozen=True, eq=False)
class Units:
    """What is known of the size of things; at most one of the three.

    Args:
        scale: Metres in a unit of the model.
        known: Two pictures, and the distance of their cameras [m].
        align: File of known camera places: poses (.log, .txt, .tum: by the pictures' numbers), or lines `name x y z`.

    Raises:
        TypeError: Not numbers, or not two names.
        ValueError: A length that is not positive, or more than one of the three.
        FileError: A file that cannot be read.
    """

    scale: float | None = None
    known: tuple[str, str, float] | None = None
    align: FilePath | None = None

    def __post_init__(self):
        given = [name for name in ("scale", "known", "align") if getattr(self, name) is not None]
        if len(given) > 1:
            raise ValueError(f"{given[1]}: {given[0]} is given too, and each of them settles the unit; give one")
        if self.scale is not None:
            object.__setattr__(self, "scale", check_positive("scale", self.scale))
        if self.known is not None:
            first, second, metres = _check_known(self.known)
            object.__setattr__(self, "known", (first, second, check_positive("known", metres)))
        if self.align is not None:
            read_places(self.align)

    @property
    def settings(self) -> dict[str, Any]:
        """What decides the outcome, in JSON's types."""
        align = None if self.align is None else digest_of_file(self.align)
        return {"scale": self.scale, "known": None if self.known is None else list(self.known), "align": align}

    def check_names(self, names: Sequence[str]) -> None:
        """Hold that the pictures that `known` names are there.

        Raises:
            ValueError: One is not, or both are the same.
        """
        if self.known is None:
            return
        first, second = (picture_named(name, names) for name in self.known[:2])
        if first == second:
            raise ValueError(f"known: {self.known[0]} and {self.known[1]} are the same picture, {names[first]}")


@dataclass(frozen=True, eq=False)
class Fit:
    """Where the model lies in the world.

    Attributes:
        T_world_model: A similarity, float64 [4, 4].
        told: "units" ("metres" or "arbitrary"), "scale", "by", and with `align` "places", "rms_m" and "extent_m".
        poor: Why it is doubted, or None.
    """

    T_world_model: NDArray[np.float64]
    told: dict[str, Any]
    poor: str | None = None

    @property
    def scale(self) -> float:
        """Metres in a unit of the model."""
        return float(self.told["scale"])


def fit_units(units: Units, names: Sequence[str], centers: NDArray[np.float64]) -> Fit:
    """Where a model lies, by what is known.

    Args:
        units: What is known.
        names: Of the pictures in the model.
        centers: Where they were taken, float64 [n, 3].

    Raises:
        ValueError: A picture that is not in the model, or that is at the place of the other.
        FileError: Too few known places, or all of them on a line.
    """
    if units.align is not None:
        return _aligned(units.align, names, centers)
    if units.known is not None:
        first, second, metres = units.known
        a, b = (picture_named(name, names, " in the model") for name in (first, second))
        distance = float(np.linalg.norm(centers[a] - centers[b]))
        if not distance > 0:
            raise ValueError(f"known: {first} and {second} were taken at one place; give two that lie apart")
        return _scaled(metres / distance, "known", METRES)
    if units.scale is not None:
        return _scaled(units.scale, "scale", METRES)
    return _scaled(1.0, None, ARBITRARY)


def picture_named(said: str, names: Sequence[str], where: str = "") -> int:
    """The place of a picture that somebody names: by its file, without the ending, or by the number in it.

    Pictures of a folder may have a number before the name that they came with ("0003_garden.jpg").

    Raises:
        ValueError: There is none, or there are several.
    """
    found = [k for k, name in enumerate(names) if name == said]
    found = found or [k for k, name in enumerate(names) if Path(name).stem == said]
    found = found or [k for k, name in enumerate(names) if _own_stem(name) in (said, Path(said).stem)]
    if not found and re.fullmatch(r"\d+", said):
        found = [k for k, name in enumerate(names) if number_of(name) == int(said)]
    if len(found) != 1:
        what = "is no picture" if not found else f"is {len(found)} pictures"
        some = ", ".join(names[:3]) + (", ..." if len(names) > 3 else "")
        raise ValueError(f"known: {said!r} {what}{where}; expected the name or number of one of {some}")
    return found[0]


def number_of(name: str) -> int | None:
    """The number at the end of a picture's name."""
    match = re.search(r"(\d+)$", Path(name).stem)
    return int(match[1]) if match else None


def _own_stem(name: str) -> str:
    return re.sub(r"^\d{4,}_(?=.)", "", Path(name).stem)


def read_places(path: FilePath) -> dict[str, NDArray[np.float64]]:
    """Known places by picture: its name, or its number as text.

    Raises:
        FileError: Neither poses nor lines `name x y z`, fewer than three, or a picture twice.
    """
    places: dict[str, NDArray[np.float64]] = {}
    for said, place in _poses(path) if _holds_poses(path) else _lines(path):
        name = str(int(said)) if re.fullmatch(r"\d+", said) else said
        if name in places:
            raise FileError(path, f"gives two places for picture {name}")
        places[name] = place
    if len(places) < FEWEST:
        raise FileError(path, f"gives {len(places)} places; {FEWEST} or more settle size and position")
    return places


def _check_known(known: Any) -> tuple[str, str, Any]:
    parts = known if isinstance(known, tuple | list) else ()
    if len(parts) != 3 or not all(isinstance(part, str | int) for part in parts[:2]):
        raise TypeError(f"known: expected (picture, picture, metres), got {shown(known)}")
    return str(parts[0]), str(parts[1]), parts[2]


def _scaled(scale: float, by: str | None, units: str) -> Fit:
    return Fit(np.diag([scale, scale, scale, 1.0]), {"units": units, "scale": scale, "by": by})


def _aligned(path: FilePath, names: Sequence[str], centers: NDArray[np.float64]) -> Fit:
    places = read_places(path)
    pairs = [(centers[k], place) for k, name in enumerate(names) if (place := _place_of(name, places)) is not None]
    if len(pairs) < FEWEST:
        some = ", ".join(list(places)[:3])
        reason = f"{len(pairs)} of its {len(places)} places ({some}, ...) belong to pictures in the model"
        raise FileError(path, reason, remedy=f"Name {FEWEST} or more as the pictures are named, such as {names[0]}")
    found, known = (np.array(side) for side in zip(*pairs, strict=True))
    for side, what in ((known, "the places in it"), (found, "the pictures that it names")):
        spread = np.linalg.svd(side - side.mean(axis=0), compute_uv=False)
        if not spread[1] > FLAT * spread[0]:
            raise FileError(path, f"{what} lie on one line", remedy="Add places beside it, or use --known or --scale")
    T = fit_pose(found, known, with_scaling=True)
    rms = float(np.sqrt(np.mean(np.sum((found @ T[:3, :3].T + T[:3, 3] - known) ** 2, axis=1))))
    extent = float(np.linalg.norm(np.ptp(known, axis=0)))
    told = {"units": METRES, "scale": float(np.cbrt(np.linalg.det(T[:3, :3]))), "by": "align"}
    told |= {"places": len(pairs), "rms_m": rms, "extent_m": extent}
    poor = None
    if rms > DOUBTED * extent:
        poor = f"the known places and those found differ by {rms:.3g} m over {extent:.3g} m; check {path}"
    return Fit(T, told, poor)


def _place_of(name: str, places: dict[str, NDArray[np.float64]]) -> NDArray[np.float64] | None:
    number = number_of(name)
    keys = (name, Path(name).stem, _own_stem(name), *([] if number is None else [str(number)]))
    return next((places[key] for key in keys if key in places), None)


def _holds_poses(path: FilePath) -> bool:
    """Whether a file is a trajectory: .log, or rows of eight numbers as TUM's."""
    if Path(path).suffix.lower() in (".log", ".tum"):
        return True
    rows = read_lines(path)
    return bool(rows) and all(len(columns) == 8 for _, columns in rows)


def _poses(path: FilePath) -> list[tuple[str, NDArray[np.float64]]]:
    trajectory = read_trajectory(path)
    if trajectory.ids is not None:
        keys = trajectory.ids[:, 0].tolist()
    else:
        times = np.arange(len(trajectory)) if trajectory.timestamps is None else trajectory.timestamps
        if not (times == np.round(times)).all():
            reason = "gives times, and pictures are known by their numbers"
            raise FileError(path, reason, remedy="Write a line `name x y z` for each picture, or poses as .log")
        keys = times.astype(np.int64).tolist()
    return [(str(key), pose[:3, 3]) for key, pose in zip(keys, trajectory.poses, strict=True)]


def _lines(path: FilePath) -> list[tuple[str, NDArray[np.float64]]]:
    places = []
    for number, columns in read_lines(path):
        try:
            place = np.array([float(column) for column in columns[-3:]])
        except ValueError:
            place = np.full(3, np.nan)
        if len(columns) < 4 or not np.isfinite(place).all():
            reason = f"expected `name x y z`, got {shown(' '.join(columns))}"
            raise FileError(path, reason, where=f"line {number}")
        places.append((" ".join(columns[:-3]), place))
    return places

"""Ground control held against the pictures before the long work: names that are there, marks inside of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from ...cameras.picture_names import meant_pictures
from ...core.errors import FileError, FilePath
from ...core.known_names import nearest_name
from ...core.stages import Made
from ...core.wording import few_of
from ...files.pictures.image_files import read_picture_header
from .ground_control import ControlMark, GroundControl
from .motion import PICTURES, picture_names


def check_control(control: GroundControl | None, frames: Made, source: FilePath) -> None:
    """Hold that the marks are of pictures that are there, and lie in them.

    Raises:
        FileError: One is not; the error has its line.
    """
    if control is None:
        return
    place = Path(source)
    offered = sorted(path.name for path in place.iterdir()) if place.is_dir() else []
    names = picture_names(frames)
    marked = {k for mark in control.marks for k in meant_pictures(mark.picture, names)}
    headers = {names[k]: read_picture_header(frames.folder / PICTURES / names[k]) for k in sorted(marked)}
    sizes = {name: (header.width, header.height) for name, header in headers.items()}
    check_marks(control, names, sizes, offered)


def check_marks(
    control: GroundControl, names: Sequence[str], sizes: Mapping[str, tuple[int, int]], offered: Sequence[str] = ()
) -> None:
    """The same of pictures by name.

    Args:
        control: The marks.
        names: Pictures that were taken.
        sizes: Width and height of those that are marked [px].
        offered: Pictures that there were: marks of those that were not taken are passed over.

    Raises:
        FileError: A picture that is not there, a name that may mean several, a mark outside of its picture.
    """
    for mark in control.marks:
        meant = meant_pictures(mark.picture, names)
        if not meant and meant_pictures(mark.picture, offered):
            continue
        if len(meant) != 1:
            what = "is none of the pictures" if not meant else f"may mean {len(meant)} pictures"
            near = nearest_name(mark.picture, names).removeprefix("; ")
            some = few_of(names, 3)
            raise _error(control, mark, f"{mark.picture!r} {what}", f"{near} " * bool(near) + f"They are called {some}")
        width, height = sizes[names[meant[0]]]
        column, row = (mark.pixel + 0.5).tolist()
        if not (0 <= column <= width and 0 <= row <= height):
            reason = f"{mark.point!r} is marked at {column:g}, {row:g}, outside of {mark.picture} of {width} x {height}"
            remedy = "Columns come first, and count in the picture as it was taken: not turned, not made smaller"
            raise _error(control, mark, reason, remedy)


def _error(control: GroundControl, mark: ControlMark, reason: str, remedy: str) -> FileError:
    path, _, line = mark.where.rpartition(" (")
    return FileError(path or control.path, reason, where=line.rstrip(")") if path else "", remedy=remedy)

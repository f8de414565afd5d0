"""Pictures of all directions, cut into faces of a cube that structure from motion takes for pictures of six cameras."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from ...cameras.panoramas import Panorama
from ...core.errors import FileError
from ...core.progress import ReportProgress
from ...files.pictures.image_files import read_color, read_picture_header, write_png
from .frame_picker import is_blank, thumbnail
from .masks import mask_file
from .picture_writing import write_picture


def cut_spheres(
    spheres: Path, names: Sequence[str], pictures: Path, masks: tuple[Path, Path] | None, say: ReportProgress
) -> list[str]:
    """Write the faces of pictures of all directions, IMG_1_front.jpg and so on of IMG_1.jpg; blank ones are left out.

    Args:
        spheres: The folder of the pictures.
        names: Theirs.
        pictures: A new folder for the faces.
        masks: Folders of the masks of the pictures, and for those of the faces.
        say: Told how many are cut.

    Returns:
        The names of the faces.

    Raises:
        FileError: A picture that is not twice as wide as high.
    """
    pictures.mkdir()
    if masks is not None:
        masks[1].mkdir()
    cutters: dict[tuple[int, int], Panorama] = {}
    written = []
    for done, name in enumerate(names):
        say("faces", done, len(names))
        header = read_picture_header(spheres / name)
        size = header.width, header.height
        try:
            cutter = cutters.get(size) or cutters.setdefault(size, Panorama(*size))
        except ValueError as error:
            raise FileError(spheres / name, str(error), remedy="Leave out --panorama for pictures of a lens") from error
        given = None if masks is None else mask_file(masks[0], name)
        hidden = cutter.apply(read_color(given)[..., 0]) if given is not None and given.is_file() else None
        for k, face in enumerate(cutter.apply(read_color(spheres / name))):
            if is_blank(thumbnail(face[..., 1])):
                continue
            written.append(f"{Path(name).stem}_{cutter.names[k]}.jpg")
            if hidden is not None and masks is not None:
                kept = hidden[k] >= 128
                if not kept.any():
                    written.pop()
                    continue
                write_png(mask_file(masks[1], written[-1]), np.where(kept, 255, 0).astype(np.uint8))
            write_picture(pictures / written[-1], face)
    say("faces", len(names), len(names))
    return written

"""Panoramas as cube faces, which structure from motion treats as images of six cameras."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from ...cameras.panoramas import FACES, ROTATIONS, Panorama
from ...core.errors import FileError
from ...core.progress import ReportProgress
from ...io.images.image_files import read_color, read_image_header, write_png
from ...io.models.sfm_model import SfmModel
from .frame_picker import is_blank, thumbnail
from .image_writing import write_image
from .masks import mask_file


def cut_spheres(
    spheres: Path, names: Sequence[str], images: Path, masks: tuple[Path, Path] | None, report: ReportProgress
) -> list[str]:
    """Write the cube faces (IMG_1_front.jpg and so on) of panoramas and masks without blank ones. Their names."""
    images.mkdir()
    if masks is not None:
        masks[1].mkdir()
    cutters: dict[tuple[int, int], Panorama] = {}
    written = []
    for done, name in enumerate(names):
        report("faces", done, len(names))
        header = read_image_header(spheres / name)
        size = header.width, header.height
        try:
            cutter = cutters.get(size) or cutters.setdefault(size, Panorama(*size))
        except ValueError as error:
            raise FileError(
                spheres / name, str(error), remedy="Leave out --panorama for images of a normal lens"
            ) from error
        given = None if masks is None else mask_file(masks[0], name)
        hidden = cutter.apply(read_color(given)[..., 0]) if given is not None and given.is_file() else None
        for k, face in enumerate(cutter.apply(read_color(spheres / name))):
            if is_blank(thumbnail(face[..., 1])):
                continue
            written.append(f"{Path(name).stem}_{cutter.names[k]}.jpg")
            if hidden is not None and masks is not None:
                visible = hidden[k] >= 128
                if not visible.any():
                    written.pop()
                    continue
                write_png(mask_file(masks[1], written[-1]), np.where(visible, 255, 0).astype(np.uint8))
            write_image(images / written[-1], face)
    report("faces", len(names), len(names))
    return written


def with_all_faces(model: SfmModel, names: Sequence[str]) -> tuple[SfmModel, list[str]]:
    """Add unregistered faces, such as those straight down, from the registered face with most points. Their names."""
    counts = np.bincount(model.observations[:, 0], minlength=len(model))
    best: dict[str, int] = {}
    for k in np.argsort(-counts, kind="stable").tolist():
        best.setdefault(_sphere_and_face(model.names[k])[0], k)
    registered = set(model.names)
    added = [name for name in names if name not in registered and _sphere_and_face(name)[0] in best]
    poses = []
    for name in added:
        sphere, face = _sphere_and_face(name)
        known = best[sphere]
        T = np.eye(4)
        T[:3, :3] = (
            ROTATIONS[face].T @ ROTATIONS[_sphere_and_face(model.names[known])[1]] @ model.T_camera_world[known, :3, :3]
        )
        T[:3, 3] = -T[:3, :3] @ model.centers[known]
        poses.append(T)
    if not added:
        return model, []
    cameras = [model.cameras[best[_sphere_and_face(name)[0]]] for name in added]
    complete = replace(
        model,
        names=(*model.names, *added),
        cameras=(*model.cameras, *cameras),
        T_camera_world=np.concatenate([model.T_camera_world, poses]),
    )
    return complete, added


def _sphere_and_face(name: str) -> tuple[str, int]:
    sphere, _, face = Path(name).stem.rpartition("_")
    return sphere, FACES.index(face)

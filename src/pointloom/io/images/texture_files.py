"""Texture images beside a mesh file: find, read and write them."""

from __future__ import annotations

import contextlib
import re
import warnings
from collections.abc import Iterator, Mapping
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import IO, TypeVar

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ...core.paths import path_of
from ..source import open_source
from .image_files import decode_texture, encode_png, texture_size

# Maximum pixels of a mesh's textures: 16 pages of 8192 x 8192, 3 GiB as RGB.
TOTAL_PIXELS = 2**30

OUTSIDE = "is outside of its folder (copy it there, or pass outside_files=True)"

_Key = TypeVar("_Key")


def leads_outside(name: str) -> bool:
    if PurePosixPath(name).is_absolute() or PureWindowsPath(name).anchor:
        return True
    depth = 0
    for part in PurePosixPath(name.replace("\\", "/")).parts:
        depth += -1 if part == ".." else 1
        if depth < 0:
            return True
    return False


def find_beside(path: FilePath, name: str, *, outside_files: bool = False) -> Path | None:
    """A file named relative to a mesh file, or None. Names and links to files outside its folder require
    `outside_files`."""
    if not name or (leads_outside(name) and not outside_files):
        return None
    candidate = _existing(path, name)
    return candidate if outside_files or not _is_link_outside(path, candidate) else None


def _existing(path: FilePath, name: str) -> Path | None:
    try:
        candidate = path_of(path).parent / name.replace("\\", "/")
        return candidate if candidate.is_file() else None
    except (OSError, ValueError):  # too long, or with a zero byte
        return None


def _is_link_outside(path: FilePath, candidate: Path | None) -> bool:
    """True if symbolic links lead from a file beside a mesh file to one outside of the folder."""
    return candidate is not None and not candidate.resolve().is_relative_to(path_of(path).parent.resolve())


def why_missing(path: FilePath, name: str, *, outside_files: bool) -> str:
    """Why `find_beside` returned None, as the end of a sentence."""
    is_outside = leads_outside(name) or _is_link_outside(path, _existing(path, name))
    return OUTSIDE if is_outside and not outside_files else "is not beside it"


def read_textures(path: FilePath, names: list[str], *, outside_files: bool = False) -> tuple[NDArray[np.uint8], ...]:
    """Read textures beside a mesh file, each once. None, with a warning, if one is unreadable or all are too large."""
    texture_paths = [find_beside(path, name, outside_files=outside_files) for name in names]
    missing = [name for name, texture_path in zip(names, texture_paths, strict=True) if texture_path is None]
    if missing:
        reason = why_missing(path, missing[0], outside_files=outside_files)
        warn_left_behind(path, f"its image {missing[0]!r} {reason}")
        return ()
    files = {texture_path: texture_path.resolve() for texture_path in texture_paths if texture_path is not None}
    given = {file: (texture_path, open_source(texture_path)[:]) for texture_path, file in reversed(files.items())}
    try:
        images = decode_textures(path, {file: given[file] for file in dict.fromkeys(files.values())})
    except FileError as error:
        warn_left_behind(path, str(error))
        return ()
    return tuple(images[files[texture_path]] for texture_path in texture_paths if texture_path is not None)


def decode_textures(
    path: FilePath, given: Mapping[_Key, tuple[FilePath, bytes | memoryview]]
) -> dict[_Key, NDArray[np.uint8]]:
    """Decode images by key, each once, read-only. Raises `FileError` before decoding if the total is too large."""
    sizes = [texture_size(name, data) for name, data in given.values()]
    total = sum(width * height for width, height in sizes)
    if total > TOTAL_PIXELS:
        reason = f"its {len(sizes)} images have {total:,} pixels in total, more than {TOTAL_PIXELS:,}"
        raise FileError(path, reason, remedy="Reduce them, or split the mesh into several files")
    images = {}
    for key, (name, data) in given.items():
        images[key] = decode_texture(name, bytes(data))
        images[key].flags.writeable = False
    return images


def alpha_mode(image: NDArray[np.uint8]) -> str:
    """The glTF mode of an image: OPAQUE, MASK if alpha is only 0 or 255, else BLEND."""
    if image.shape[2] < 4 or (image[..., 3] == 255).all():
        return "OPAQUE"
    return "MASK" if np.isin(image[..., 3], (0, 255)).all() else "BLEND"


def drop_alpha(image: NDArray[np.uint8], cutoff: float = 0.0) -> NDArray[np.uint8]:
    """Drop alpha, or threshold it to 0 and 255 if a `cutoff` in 0..1 is given. Read-only."""
    alpha = image[..., 3] if image.shape[2] == 4 else np.full(image.shape[:2], 255, np.uint8)
    shown = alpha / np.float32(255) >= cutoff
    result = np.ascontiguousarray(image[..., :3])
    if not shown.all():
        result = np.dstack([result, np.where(shown, 255, 0).astype(np.uint8)])
    result.flags.writeable = False
    return result


def warn_left_behind(path: FilePath, reason: str) -> None:
    warnings.warn(escaped(f"{path}: the textures are dropped, because {reason}"), UserWarning, stacklevel=5)


def derived_name(path: FilePath, ending: str) -> str:
    """A file name derived from a mesh file, without characters that separate names in lists."""
    return re.sub(r"[^A-Za-z0-9._-]", "_", Path(path).stem) + ending


def image_names(path: FilePath, count: int) -> list[str]:
    return [derived_name(path, f"_{k}.png") for k in range(count)]


@contextlib.contextmanager
def write_with(path: FilePath, beside: dict[str, bytes | NDArray[np.uint8]], *, overwrite: bool) -> Iterator[IO[bytes]]:
    """A binary file with dependent files (bytes, or images as PNG) that appear before it, each atomically."""
    with contextlib.ExitStack() as files:
        main = files.enter_context(atomic_write(path, overwrite=overwrite))
        for name, content in beside.items():
            other = files.enter_context(atomic_write(Path(path).parent / name, overwrite=overwrite))
            other.write(content if isinstance(content, bytes) else encode_png(content))
        yield main

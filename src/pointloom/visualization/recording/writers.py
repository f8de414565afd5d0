"""Write recordings as files: `check_recording` before the recording, `write_recording` after it.

Animated GIFs are assembled here frame by frame, with one palette. Pillow only compresses images. Pillow's own
animations merge equal frames and round each delay separately, which would drop steps and change the speed.
"""

from __future__ import annotations

import contextlib
import io
import shutil
import struct
import subprocess
import tempfile
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.atomic import atomic_write, check_writable
from ...core.checks import check_color
from ...core.devices import DeviceLike
from ...core.errors import FileError
from ...core.progress import ReportProgress
from ...io.file_formats import listed
from ..render.parts import Triple
from ..render.view import View
from .exports import PACKAGES, check_package, export
from .extensions import RECORDINGS
from .film import Film
from .page import write_page
from .shapes import spread_rows
from .timeline import Timeline

FASTEST_GIF = 50.0  # [1/s] viewers slow down delays below 2/100 s
PALETTE_FRAMES = 12  # frames that define the colors of a GIF


def check_recording(path: str | Path, *, fps: float, background: ArrayLike, overwrite: bool) -> None:
    """Check format, path and ffmpeg before any work. Raises FileError or ValueError."""
    suffix = Path(path).suffix.lower()
    if suffix not in RECORDINGS:
        remedy = f"Use a file name that ends in {listed(RECORDINGS)}"
        raise FileError(path, f"unknown recording format: {suffix or 'a name without a suffix'}", remedy=remedy)
    if suffix == ".gif" and fps > FASTEST_GIF:
        raise ValueError(f"fps: expected at most {FASTEST_GIF:g} frames per second for .gif, got {fps:g}; use .mp4")
    check_color("background", background)
    check_writable(path, overwrite=overwrite)
    if suffix == ".mp4":
        find_ffmpeg(path)
    if suffix in PACKAGES:
        check_package(path)


def write_recording(
    path: str | Path,
    timeline: Timeline,
    *,
    view: View,
    size: tuple[int, int],
    background: Triple,
    overwrite: bool,
    report_progress: ReportProgress,
    device: DeviceLike = None,
) -> None:
    """Write a recording atomically in the format of the suffix. Raises FileError."""
    suffix = Path(path).suffix.lower()
    if suffix == ".html":
        write_page(path, timeline, view=view, background=background, overwrite=overwrite)
        return
    if suffix in PACKAGES:
        with atomic_write(path, overwrite=overwrite) as file:
            file.write(export(path, timeline))
        return
    width, height = size if suffix != ".mp4" else (size[0] + size[0] % 2, size[1] + size[1] % 2)
    film = Film(timeline, view, width, height, background, device)
    ground = tuple(np.rint(255 * np.array(background)).astype(int).tolist())
    writers: dict[str, Callable[[IO[bytes]], int]] = {
        ".gif": lambda file: write_gif(file, film.frames(report_progress), _palette_of(film, ground), timeline.fps),
        ".mp4": lambda file: write_mp4(file, film.frames(report_progress), timeline.fps, path),
    }
    with atomic_write(path, overwrite=overwrite) as file:
        writers[suffix](file)


def _palette_of(film: Film, background: Any) -> Any:
    return make_palette([film.draw(int(k)) for k in spread_rows(len(film), PALETTE_FRAMES)], background)


Picture = NDArray[np.uint8]

TICKS_PER_SECOND = 100  # GIF's time unit
GIF_COLORS = 256
_FIXED_ENTRIES = 2  # background and black
_PALETTE_IMAGE_SIZE = 160  # [px] longer side of the images that define the palette
_HEADER_BYTES, _TABLE_BYTES = 13, 3 * GIF_COLORS  # bytes before the color table, and of the table


def make_palette(images: Sequence[Picture], background: tuple[int, int, int]) -> NDArray[np.uint8]:
    """Palette for all frames from a sample of them: background first, black second, shape (256, 3)."""
    from PIL import Image

    step = max(1, max(images[0].shape[:2]) // _PALETTE_IMAGE_SIZE)
    pixels = np.concatenate([picture[::step, ::step].reshape(-1, 3) for picture in images])
    pixels = pixels[(pixels != np.array(background, np.uint8)).any(axis=1)]
    palette = np.zeros((GIF_COLORS, 3), np.uint8)
    palette[0] = background
    if len(pixels):
        image = Image.fromarray(pixels[None])
        colors = np.array(image.quantize(GIF_COLORS - _FIXED_ENTRIES, Image.Quantize.MEDIANCUT).getpalette(), np.uint8)
        colors = colors.reshape(-1, 3)[: GIF_COLORS - _FIXED_ENTRIES]
        palette[_FIXED_ENTRIES : _FIXED_ENTRIES + len(colors)] = colors
    return palette


def write_gif(file: IO[bytes], images: Iterable[Picture], palette: NDArray[np.uint8], fps: float) -> int:
    """Write images (h, w, 3), uint8, as a looping animation. Returns the number of frames.

    At most 50 `fps`. Delays are multiples of 1/100 s, chosen so that the total time is correct.
    """
    from PIL import Image

    holder = Image.new("P", (1, 1))
    holder.putpalette(palette.tobytes())
    before: Picture | None = None
    count = 0
    for count, picture in enumerate(images, 1):
        marks = _indices(picture, palette, holder)
        height, width = marks.shape
        if before is None:
            file.write(b"GIF89a" + struct.pack("<HHBBB", width, height, 0xF7, 0, 0) + palette.tobytes())
            file.write(b"\x21\xff\x0bNETSCAPE2.0\x03\x01\x00\x00\x00")
        left, top, right, bottom = changed_box(marks, before)
        delay = round(count * TICKS_PER_SECOND / fps) - round((count - 1) * TICKS_PER_SECOND / fps)
        file.write(b"\x21\xf9\x04" + struct.pack("<BHB", 1 << 2, delay, 0) + b"\x00")
        file.write(b"\x2c" + struct.pack("<HHHHB", left, top, right - left, bottom - top, 0))
        file.write(_packed(marks[top:bottom, left:right], palette))
        before = marks
    file.write(b"\x3b")
    return count


def changed_box(picture: NDArray[Any], before: NDArray[Any] | None) -> tuple[int, int, int, int]:
    """Left, top, right and bottom of the difference to the previous image. One pixel if equal."""
    if before is None:
        return 0, 0, picture.shape[1], picture.shape[0]
    differs = picture != before
    if differs.ndim == 3:
        differs = differs.any(axis=2)
    rows, columns = np.flatnonzero(differs.any(axis=1)), np.flatnonzero(differs.any(axis=0))
    if not len(rows):
        return 0, 0, 1, 1
    return int(columns[0]), int(rows[0]), int(columns[-1]) + 1, int(rows[-1]) + 1


def _indices(picture: Picture, palette: NDArray[np.uint8], holder: Any) -> NDArray[np.uint8]:
    """Nearest palette entry of each pixel. Exact for the background."""
    from PIL import Image

    image = Image.fromarray(picture).quantize(palette=holder, dither=Image.Dither.NONE)
    marks = np.array(image, np.uint8)
    marks[(picture == palette[0]).all(axis=2)] = 0
    return marks


def _packed(marks: NDArray[np.uint8], palette: NDArray[np.uint8]) -> bytes:
    """Compressed pixels in the format after an image descriptor."""
    from PIL import Image

    image = Image.frombytes("P", (marks.shape[1], marks.shape[0]), marks.tobytes())
    image.putpalette(palette.tobytes())
    buffer = io.BytesIO()
    image.save(buffer, "GIF", optimize=False, interlace=0)
    data = buffer.getvalue()
    offset = _HEADER_BYTES + _TABLE_BYTES
    while data[offset] == 0x21:  # extensions: a label, then blocks preceded by their length
        offset += 2
        while data[offset]:
            offset += data[offset] + 1
        offset += 1
    if data[offset] != 0x2C or data[offset + 9] & 0x80 or data[10] & 0x87 != 0x87 or data[-1] != 0x3B:
        raise RuntimeError("Pillow wrote a GIF of unknown structure")
    return data[offset + 10 : -1]


# Encoders of H.264 and MPEG-4 in builds of ffmpeg, best first, with quality options.
_ENCODERS = (("libx264", ("-crf", "18", "-preset", "medium")), ("libopenh264", ()), ("mpeg4", ("-q:v", "3")))
_LAST_LINES = 3  # of ffmpeg's error message
_AT_ONCE = 2**20  # bytes
_EXIT_TIMEOUT = 2.0  # [s] time for ffmpeg to end after its input


def find_ffmpeg(path: str | Path) -> str:
    """Path of ffmpeg. Raises FileError."""
    program = shutil.which("ffmpeg")
    if program is None:
        remedy = "Install ffmpeg, or use a file name that ends in .html or .gif"
        raise FileError(path, "writing videos requires the program ffmpeg, which is not on the path", remedy=remedy)
    return program


def write_mp4(file: IO[bytes], images: Iterable[Picture], fps: float, path: str | Path) -> int:
    """Write images of one even size as a video. Returns the number of frames. Raises FileError with ffmpeg's output."""
    program, count = find_ffmpeg(path), 0
    with tempfile.TemporaryDirectory(prefix="pointloom-") as folder:  # writing MP4 requires a seekable file
        made = Path(folder) / "video.mp4"
        with (Path(folder) / "ffmpeg.log").open("w+b") as log:
            process: subprocess.Popen[bytes] | None = None
            try:
                for picture in images:
                    count += 1
                    if process is None:
                        line = _command(program, picture.shape[1], picture.shape[0], fps, made)
                        process = subprocess.Popen(line, stdin=subprocess.PIPE, stdout=log, stderr=log)
                    assert process.stdin is not None
                    process.stdin.write(np.ascontiguousarray(picture).data)
                if process is not None:
                    process.communicate()
            except BrokenPipeError:  # ffmpeg ended early: its message gives the reason
                pass
            finally:
                if process is not None:
                    _end(process)
            if process is None or process.returncode or not made.exists():
                log.seek(0)
                lines = log.read().decode(errors="replace").strip().splitlines()[-_LAST_LINES:]
                raise FileError(path, f"ffmpeg failed: {' '.join(lines) or 'it printed no message'}")
        with made.open("rb") as video:
            shutil.copyfileobj(video, file, _AT_ONCE)
    return count


def _end(process: subprocess.Popen[bytes]) -> None:
    """Wait for a process and kill it if it does not end."""
    if process.stdin is not None:
        with contextlib.suppress(OSError):
            process.stdin.close()
    try:
        process.wait(_EXIT_TIMEOUT)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def _command(program: str, width: int, height: int, fps: float, output: Path) -> list[str]:
    encoder, options = _encoder(program)
    given = ["-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{width}x{height}", "-r", f"{fps:g}", "-i", "-"]
    made = ["-c:v", encoder, *options, "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-an", str(output)]
    return [program, "-hide_banner", "-loglevel", "error", "-y", *given, *made]


def _encoder(program: str) -> tuple[str, tuple[str, ...]]:
    """Name and options of the best encoder of this ffmpeg."""
    command = [program, "-hide_banner", "-encoders"]
    output = subprocess.run(command, capture_output=True, encoding="utf-8", errors="replace", check=False).stdout
    names = {line.split()[1] for line in output.splitlines() if len(line.split()) > 1}
    return next((entry for entry in _ENCODERS if entry[0] in names), _ENCODERS[-1])

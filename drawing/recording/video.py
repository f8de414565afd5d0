"""MP4 by an ffmpeg program: frames go to it through a pipe."""

from __future__ import annotations

import contextlib
import shutil
import subprocess
import tempfile
from collections.abc import Iterable
from pathlib import Path
from typing import IO

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError

Picture = NDArray[np.uint8]

# The encoders of H.264 and MPEG-4 that builds of ffmpeg have, the best first, and how good they are to be.
_ENCODERS = (("libx264", ("-crf", "18", "-preset", "medium")), ("libopenh264", ()), ("mpeg4", ("-q:v", "3")))
_LAST_LINES = 3  # of what ffmpeg says when it fails
_AT_ONCE = 2**20  # bytes
_PATIENCE = 2.0  # seconds that a program without input is given to end


def find_ffmpeg(path: str | Path) -> str:
    """Where ffmpeg is.

    Raises:
        FileError: Nowhere on the path.
    """
    found = shutil.which("ffmpeg")
    if found is None:
        remedy = "Install ffmpeg, or give a name that ends in .html or .gif"
        raise FileError(path, "videos are made by the program ffmpeg, which is not on the path", remedy=remedy)
    return found


def write_mp4(file: IO[bytes], pictures: Iterable[Picture], fps: float, path: str | Path) -> int:
    """Write pictures as a video.

    Args:
        file: Open for writing.
        pictures: Each [h, w, 3], uint8, of one size with even sides.
        fps: Pictures a second.
        path: What errors call the file.

    Returns:
        The number of frames.

    Raises:
        FileError: No ffmpeg, or it failed; says what it said.
    """
    program, count = find_ffmpeg(path), 0
    with tempfile.TemporaryDirectory(prefix="pointloom-") as folder:  # MP4 is not written from front to back
        made = Path(folder) / "video.mp4"
        with (Path(folder) / "said.txt").open("w+b") as said:
            process: subprocess.Popen[bytes] | None = None
            try:
                for picture in pictures:
                    count += 1
                    if process is None:
                        line = _command(program, picture.shape[1], picture.shape[0], fps, made)
                        process = subprocess.Popen(line, stdin=subprocess.PIPE, stdout=said, stderr=said)
                    assert process.stdin is not None
                    process.stdin.write(np.ascontiguousarray(picture).data)
                if process is not None:
                    process.communicate()
            except BrokenPipeError:  # it ended before: what it said tells why
                pass
            finally:
                if process is not None:
                    _end(process)
            if process is None or process.returncode or not made.exists():
                said.seek(0)
                lines = said.read().decode(errors="replace").strip().splitlines()[-_LAST_LINES:]
                raise FileError(path, f"ffmpeg failed: {' '.join(lines) or 'it said nothing'}")
        with made.open("rb") as video:
            shutil.copyfileobj(video, file, _AT_ONCE)
    return count


def _end(process: subprocess.Popen[bytes]) -> None:
    """See a process out, by force where it still runs."""
    if process.stdin is not None:
        with contextlib.suppress(OSError):
            process.stdin.close()
    try:
        process.wait(_PATIENCE)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def _command(program: str, width: int, height: int, fps: float, output: Path) -> list[str]:
    encoder, options = _encoder(program)
    given = ["-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{width}x{height}", "-r", f"{fps:g}", "-i", "-"]
    made = ["-c:v", encoder, *options, "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-an", str(output)]
    return [program, "-hide_banner", "-loglevel", "error", "-y", *given, *made]


def _encoder(program: str) -> tuple[str, tuple[str, ...]]:
    """The first encoder that this ffmpeg has, and its options."""
    said = subprocess.run([program, "-hide_banner", "-encoders"], capture_output=True, text=True, check=False).stdout
    names = {line.split()[1] for line in said.splitlines() if len(line.split()) > 1}
    return next((entry for entry in _ENCODERS if entry[0] in names), _ENCODERS[-1])

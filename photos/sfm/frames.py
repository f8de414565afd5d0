"""The pictures that structure from motion works on, from a video or from a folder of photographs."""

from __future__ import annotations

import contextlib
import dataclasses
import os
from collections import Counter
from typing import Any

from ...core.checks import check_count, check_positive, check_progress, shown
from ...core.errors import FileError, FilePath
from ...core.progress import ReportProgress
from ...core.timing import Clock
from .frame_choice import FrameChoice
from .frame_picker import ANALYSIS_SIZE, FramePicker, spaced
from .limited_process import check_limits
from .masks import MakeMask, check_masks, mask_folder, write_masks
from .picture_choice import choose_pictures
from .picture_folder import check_place
from .picture_writing import KINDS, Wanted, counted, new_folder, some_of, write_picture
from .video_files import READERS, VideoFile, VideoFrames, open_video

_DIGITS = 6


def choose_video_frames(
    video: VideoFile, picker: FramePicker, wanted: Wanted, limits: dict[str, Any], say: ReportProgress
) -> FrameChoice:
    """Write the frames of a video that are worth it.

    Raises:
        FileError: The video cannot be decoded, nothing is to be seen in it, or the place cannot be written.
    """
    count, said, peak = _look(video, picker, limits, say)
    numbers = spaced(picker.chosen, wanted.max_count)
    if not numbers:
        reason = f"none of {counted(count, 'frame')} shows anything: {len(picker.blank)} are black or blank"
        raise FileError(video.path, reason, remedy="Give another video")
    names, sizes, peak_of_writing = _write(video, numbers, wanted, limits, say)
    return FrameChoice(
        source=os.fspath(video.path),
        kind="video",
        reader=video.reader,
        names=tuple(names),
        numbers=tuple(numbers),
        sizes=dict(sizes.most_common()),
        frame_count=count,
        frames_promised=video.promised,
        blurred_count=picker.blurred,
        left_out={str(number): "black, or all of one brightness" for number in picker.blank},
        notes=tuple(_notes(video, picker, count, len(numbers), said)),
        peak_bytes=max(peak, peak_of_writing),
    )


def _look(video: VideoFile, picker: FramePicker, limits: dict[str, Any], say: ReportProgress) -> tuple[int, str, int]:
    """Show the picker each frame; gives their number, what the decoder complained of, and its memory [B]."""
    with VideoFrames(video, max_size=ANALYSIS_SIZE, grey=True, **limits) as frames:
        for grey in frames:
            picker.add(grey)
            say("look", frames.count, max(video.promised or 0, frames.count))
        picker.end()
        return frames.count, frames.said, frames.peak_bytes


def _write(
    video: VideoFile, numbers: list[int], wanted: Wanted, limits: dict[str, Any], say: ReportProgress
) -> tuple[list[str], Counter[tuple[int, int]], int]:
    names, sizes = [], Counter[tuple[int, int]]()
    with VideoFrames(video, max_size=wanted.max_size, numbers=numbers, **limits) as frames:
        for number, pixels in zip(numbers, frames, strict=False):
            names.append(f"frame_{number:0{_DIGITS}d}.{wanted.kind}")
            write_picture(wanted.folder / names[-1], pixels)
            sizes[pixels.shape[1], pixels.shape[0]] += 1
            say("write", len(names), len(numbers))
        if len(names) < len(numbers):
            reason = f"frame {numbers[len(names)]} came once and not again: {frames.said or 'the file was changed'}"
            raise FileError(video.path, reason, remedy="See that nobody writes to the video meanwhile")
        return names, sizes, frames.peak_bytes


def _notes(video: VideoFile, picker: FramePicker, count: int, chosen: int, said: str) -> list[str]:
    notes, said = [], said.split(" / ")[0]
    promised = video.promised or 0
    # A duration times a mean rate is off by a frame or two in videos that are whole.
    if count < promised - (0 if video.is_counted else 2):
        complaint = f" ({said})" if said else ""
        notes.append(f"the video is damaged or cut off: {count} of {promised} frames came{complaint}")
    elif said:
        notes.append(f"the video is damaged: {said}")
    if picker.blank:
        numbers = some_of([str(number) for number in picker.blank])
        notes.append(f"{counted(len(picker.blank), 'frame')} black or blank and left out: {numbers}")
    if picker.still:
        told = f"the camera stood still for some {picker.still * picker.max_gap} frames, which show nothing new"
        notes.append(f"{told}; they are left out")
    if len(picker.chosen) > chosen:
        notes.append(f"{chosen} of {len(picker.chosen)} frames that are worth it are taken, evenly (max_frames)")
    return notes


MAX_FRAMES = 150

_LONGEST_SIDE = 2**16


def choose_frames(
    source: FilePath,
    folder: FilePath,
    *,
    max_frames: int = MAX_FRAMES,
    max_size: int | None = None,
    min_movement: float = 0.04,
    max_gap: int = 30,
    kind: str = "jpg",
    reader: str = "auto",
    masks: FilePath | MakeMask | None = None,
    max_seconds: float | None = None,
    max_memory: int | None = None,
    progress: ReportProgress | None = None,
) -> FrameChoice:
    """Take frames of a video that show the scene sharply and from different places, and write them as pictures.

    A folder of photographs is taken as it is: in natural order, turned as EXIF says, 16-bit grey made 8-bit; what is
    in order already is copied. Names are kept where they sort as the pictures do, else a number comes before them.

    Args:
        source: A video that ffmpeg or OpenCV can read, or a folder of PNG, JPEG, TIFF and WebP pictures, of HEIC and
            DNG with `pip install "pointloom[photos]"`.
        folder: Where to write; new, or empty. Frames are called frame_000012.jpg after their number in the video.
        max_frames: At most so many; where more fit, they are taken evenly.
        max_size: The longer side is scaled down to this [px]; None keeps the size.
        min_movement: Of a video: how far the picture moves from one frame to the next, as a share of its longer side.
        max_gap: Of a video: at most so many frames from one to the next, unless the camera stands still.
        kind: Of files: "jpg" (quality 95, 4:4:4) or "png", which loses nothing and takes several times the space.
        reader: What decodes a video: "ffmpeg" and "ffprobe" on the path, "opencv" (opencv-python-headless), or "auto"
            for the first of them that is there. Both run in a process of their own.
        masks: What of pictures is left out: a folder of masks (IMG_1.jpg.png or IMG_1.png of IMG_1.jpg, black is left
            out, of the picture's size), "alpha" for what is transparent in the pictures themselves, or a function of a
            picture's RGB [h, w, 3], upright, and its name that gives a mask [h, w], bool or uint8, or None. They are
            written beside `folder`, under its name with _masks behind. Pictures that theirs hide are left out.
        max_seconds: Each of the two passes over a video is given up after this time [s]; None for no limit.
        max_memory: Of the process that decodes [B]; None for nine tenths of what is free.
        progress: Called with the stage ("look", "write"), how many of its steps are done, and how many there are.

    Returns:
        What was taken, what was left out and why, and notes: a video with fewer frames than it promises, black
        frames, pictures of several sizes.

    Raises:
        FileError: No video or no picture, nothing to read it with, nothing in it to be seen, a folder that is not
            empty, a disk that is full. What was written until then is removed.
        TypeError, ValueError: An argument out of range.

    Notes:
        A video is decoded twice: small and grey to choose, then the frames that are kept. Memory does not grow with
        its length. The same files from run to run with one build of ffmpeg. Laplacian variance below 0.6 of the
        median of the 7 frames on both sides counts as blurred; movement is measured by phase correlation.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pathlib import Path
        >>> from PIL import Image
        >>> Path("photographs").mkdir()
        >>> for number in (1, 2, 10):
        ...     pixels = np.random.default_rng(number).integers(0, 256, (24, 32, 3), dtype=np.uint8)
        ...     Image.fromarray(pixels).save(f"photographs/{number}.png")
        >>> choice = loom.sfm.choose_frames("photographs", "frames")
        >>> choice.names, choice.sizes
        (('0000_1.png', '0001_2.png', '0002_10.png'), {(32, 24): 3})
    """
    clock, say = Clock(), check_progress(progress)
    check_count("max_frames", max_frames)
    if max_size is not None:
        check_count("max_size", max_size, minimum=16, maximum=_LONGEST_SIDE, because="no camera has more pixels")
    check_positive("min_movement", min_movement, maximum=1.0)
    check_count("max_gap", max_gap)
    check_option("kind", kind, KINDS)
    check_option("reader", reader, READERS)
    limits = check_limits(max_seconds, max_memory)
    place, target = check_place("source", source), check_place("folder", folder)
    given = check_masks(masks)
    wanted = Wanted(target, max_frames, max_size, kind)
    with contextlib.ExitStack() as undo:
        if given is not None:
            undo.enter_context(new_folder(mask_folder(target)))
        undo.enter_context(new_folder(target))
        if place.is_dir():
            found = choose_pictures(place, wanted, say)
        else:
            picker = FramePicker(min_movement=float(min_movement), max_gap=max_gap)
            found = choose_video_frames(open_video(place, reader=reader), picker, wanted, limits, say)
        if given is not None:
            found = write_masks(found, place, target, given)
    clock.stop("frames")
    return dataclasses.replace(found, seconds=clock.seconds["frames"])


def check_option(name: str, value: Any, known: tuple[str, ...]) -> str:
    """One of a few words."""
    if not isinstance(value, str) or value not in known:
        raise (ValueError if isinstance(value, str) else TypeError)(
            f"{name}: expected one of {', '.join(known)}, got {shown(value)}"
        )
    return value

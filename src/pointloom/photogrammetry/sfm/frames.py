"""Selection of SfM images from a video or a folder of photographs."""

from __future__ import annotations

import contextlib
import dataclasses
import os
from collections import Counter
from typing import Any

from ...core.checks import check_count, check_positive, check_progress, shown
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ...core.progress import ReportProgress
from ...core.reports import failed
from ...core.timing import Clock
from .frame_choice import FrameChoice
from .frame_picker import ANALYSIS_SIZE, FramePicker, spaced
from .image_choice import choose_images
from .image_folder import check_path
from .image_writing import KINDS, Wanted, counted, new_folder, some_of, write_image
from .limited_process import check_limits
from .masks import MakeMask, check_masks, mask_folder, write_masks
from .video_files import READERS, VideoFile, VideoFrames, open_video

_FRAME_DIGITS = 6


def choose_video_frames(
    video: VideoFile, picker: FramePicker, wanted: Wanted, limits: dict[str, Any], report: ReportProgress
) -> FrameChoice:
    count, decoder_message, peak = _look(video, picker, limits, report)
    numbers = spaced(picker.chosen, wanted.max_count)
    if not numbers:
        reason = f"none of {counted(count, 'frame')} has content: {len(picker.blank)} are black or blank"
        raise FileError(video.path, reason, remedy="Give another video")
    names, sizes, peak_of_writing = _write(video, numbers, wanted, limits, report)
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
        left_out={str(number): "black, or of one brightness" for number in picker.blank},
        notes=tuple(_notes(picker, len(numbers))),
        peak_bytes=max(peak, peak_of_writing),
        warnings=failed(_why_damaged(video, count, decoder_message)),
    )


def _look(
    video: VideoFile, picker: FramePicker, limits: dict[str, Any], report: ReportProgress
) -> tuple[int, str, int]:
    """Feed all frames to the picker. Returns their number, the decoder's messages, and its memory [B]."""
    with VideoFrames(video, max_size=ANALYSIS_SIZE, gray=True, **limits) as frames:
        for gray in frames:
            picker.add(gray)
            report("look", frames.count, max(video.promised or 0, frames.count))
        picker.end()
        return frames.count, frames.message, frames.peak_bytes


def _write(
    video: VideoFile, numbers: list[int], wanted: Wanted, limits: dict[str, Any], report: ReportProgress
) -> tuple[list[str], Counter[tuple[int, int]], int]:
    names, sizes = [], Counter[tuple[int, int]]()
    with VideoFrames(video, max_size=wanted.max_size, numbers=numbers, **limits) as frames:
        for number, pixels in zip(numbers, frames, strict=False):
            names.append(f"frame_{number:0{_FRAME_DIGITS}d}.{wanted.kind}")
            write_image(wanted.folder / names[-1], pixels)
            sizes[pixels.shape[1], pixels.shape[0]] += 1
            report("write", len(names), len(numbers))
        if len(names) < len(numbers):
            reason = (
                f"frame {numbers[len(names)]} was decoded once, but not again: "
                f"{frames.message or 'the file was changed'}"
            )
            raise FileError(video.path, reason, remedy="Make sure that no other program writes to the video")
        return names, sizes, frames.peak_bytes


def _why_damaged(video: VideoFile, count: int, decoder_message: str) -> str | None:
    message = escaped(decoder_message.split(" / ")[0])
    promised = video.promised or 0
    # Duration times mean rate is off by a frame or two in intact videos.
    if count < promised - (0 if video.is_counted else 2):
        complaint = f" ({message})" if message else ""
        return f"the video is damaged or truncated: {count} of {promised} frames were decoded{complaint}"
    return f"the video is damaged: {message}" if message else None


def _notes(picker: FramePicker, chosen: int) -> list[str]:
    notes = []
    if picker.blank:
        numbers = some_of([str(number) for number in picker.blank])
        notes.append(f"{counted(len(picker.blank), 'frame')} black or blank and left out: {numbers}")
    if picker.still:
        message = f"the camera was stationary for about {picker.still * picker.max_gap} frames, which show nothing new"
        notes.append(f"{message}; they are left out")
    if len(picker.chosen) > chosen:
        notes.append(f"{chosen} of {len(picker.chosen)} suitable frames are used, evenly spaced (max_frames)")
    return notes


MAX_FRAMES = 150

_LONGEST_SIDE = 2**16


@dataclasses.dataclass(frozen=True)
class VideoSampling:
    """How `choose_frames` decodes and samples a video.

    Attributes:
        min_movement: Minimum image shift between frames, relative to the longer side.
        max_gap: Maximum number of frames between selected ones, unless the camera is still.
        reader: "ffmpeg" (with "ffprobe"), "opencv" (opencv-python-headless), or "auto": the first available.
        max_seconds: Time limit per pass over the video [s]; None: no limit.
        max_memory: Memory limit of the decoder [B]; None: nine tenths of the free memory.

    Raises:
        TypeError, ValueError: One is out of range; named in the message.

    Example:
        >>> import pointloom as loom
        >>> loom.photogrammetry.VideoSampling(max_gap=10).reader
        'auto'
    """

    min_movement: float = 0.04
    max_gap: int = 30
    reader: str = "auto"
    max_seconds: float | None = None
    max_memory: int | None = None

    def __post_init__(self):
        check_positive("min_movement", self.min_movement, maximum=1.0)
        check_count("max_gap", self.max_gap)
        check_option("reader", self.reader, READERS)
        check_limits(self.max_seconds, self.max_memory)


def choose_frames(
    source: FilePath,
    folder: FilePath,
    *,
    max_frames: int = MAX_FRAMES,
    max_size: int | None = None,
    kind: str = "jpg",
    masks: FilePath | MakeMask | None = None,
    sampling: VideoSampling | None = None,
    progress: ReportProgress | None = None,
) -> FrameChoice:
    """Select sharp video frames from different positions, and write them as images.

    Folders of photographs are taken completely: in natural order, rotated by EXIF, 16-bit gray converted to 8 bit,
    copied if possible. A number is prepended to names that would not sort in this order.

    Args:
        source: A video for ffmpeg or OpenCV, or a folder of PNG, JPEG, TIFF and WebP images, and HEIC and DNG with `pip
            install "pointloom[photos]"`.
        folder: Output folder, new or empty. Frames are named frame_000012.jpg by their number in the video.
        max_frames: Maximum number, evenly selected.
        max_size: Maximum image side [px]; None: original size.
        kind: "jpg" (quality 95, 4:4:4) or "png" (lossless, several times larger).
        masks: Excluded pixels: a folder of masks of the image size (IMG_1.jpg.png or IMG_1.png for IMG_1.jpg, black is
            excluded), "alpha" for transparency, or a function of an upright RGB image [h, w, 3] and its name that
            returns a mask [h, w], bool or uint8, or None. Written to `folder` + "_masks".
        sampling: Decoder and distance of the frames of a video; None: the defaults. No effect on photographs.
        progress: Called with (stage, steps done, steps in all), stages "look" and "write".

    Returns:
        The selected and the excluded images with reasons, and notes: missing or black frames, several image sizes.

    Raises:
        FileError: No video or image, no decoder, only blank frames, a folder that is not empty, or a full disk.
        TypeError, ValueError: An argument is out of range.

    Notes:
        A video is decoded twice: small and gray for the selection, then the selected frames. Memory is constant.
        Reproducible with one build of ffmpeg. Blurred: Laplacian variance below 0.6 of the median of the 7 frames on
        both sides; movement by phase correlation.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pathlib import Path
        >>> from PIL import Image
        >>> Path("photographs").mkdir()
        >>> for number in (1, 2, 10):
        ...     pixels = np.random.default_rng(number).integers(0, 256, (24, 32, 3), dtype=np.uint8)
        ...     Image.fromarray(pixels).save(f"photographs/{number}.png")
        >>> choice = loom.photogrammetry.choose_frames("photographs", "frames")
        >>> choice.names, choice.sizes
        (('0000_1.png', '0001_2.png', '0002_10.png'), {(32, 24): 3})
    """
    clock, report = Clock(), check_progress(progress)
    check_count("max_frames", max_frames)
    if max_size is not None:
        check_count("max_size", max_size, minimum=16, maximum=_LONGEST_SIDE, because="no camera has more pixels")
    check_option("kind", kind, KINDS)
    if not isinstance(sampling, VideoSampling | None):
        raise TypeError(f"sampling: expected a VideoSampling, got {type(sampling).__name__}")
    sampling = sampling or VideoSampling()
    source_path, target = check_path("source", source), check_path("folder", folder)
    given = check_masks(masks)
    wanted = Wanted(target, max_frames, max_size, kind)
    with contextlib.ExitStack() as undo:
        if given is not None:
            undo.enter_context(new_folder(mask_folder(target)))
        undo.enter_context(new_folder(target))
        if source_path.is_dir():
            choice = choose_images(source_path, wanted, report)
        else:
            picker = FramePicker(min_movement=float(sampling.min_movement), max_gap=sampling.max_gap)
            limits = check_limits(sampling.max_seconds, sampling.max_memory)
            video = open_video(source_path, reader=sampling.reader)
            choice = choose_video_frames(video, picker, wanted, limits, report)
        if given is not None:
            choice = write_masks(choice, source_path, target, given)
    clock.stop("frames")
    return dataclasses.replace(choice, seconds=clock.seconds["frames"])


def check_option(name: str, value: object, known: tuple[str, ...]) -> str:
    if not isinstance(value, str) or value not in known:
        raise (ValueError if isinstance(value, str) else TypeError)(
            f"{name}: expected one of {', '.join(known)}, got {shown(value)}"
        )
    return value

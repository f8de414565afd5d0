"""A video, from which frames are chosen and written: decoded small and grey to choose, and again to be written."""

from __future__ import annotations

import os
from collections import Counter
from typing import Any

from ...core.errors import FileError
from ...core.progress import ReportProgress
from .frame_choice import FrameChoice
from .frame_picker import ANALYSIS_SIZE, FramePicker, spaced
from .picture_writing import Wanted, counted, some_of, write_picture
from .video_files import VideoFile, VideoFrames

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

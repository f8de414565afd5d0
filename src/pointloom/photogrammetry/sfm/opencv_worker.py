"""Worker process that decodes a video with OpenCV if there is no ffmpeg: `opencv_worker.py < job.json > frames.ppm`.

It only imports cv2, whose decoders crash on some files and whose libraries conflict with others. The JSON job has
"path", "container" (ffmpeg's name), and "probe": true for a JSON description of the video, or "max_size", "gray" and
"numbers" (null: all) for frames as PGM or PPM images.
"""

from __future__ import annotations

import json
import os
import sys
from types import ModuleType
from typing import Any


def main() -> int:
    job = json.load(sys.stdin)
    try:
        import cv2
    except ImportError as error:
        print(f"missing: {error}", file=sys.stderr)
        return 3
    name = job["container"]  # never guessed, so that no other file is opened
    if not name:
        return 1
    options = f"input_format;{name}|format_whitelist;{name}|protocol_whitelist;file"
    os.environ["OPENCV_FFMPEG_CAPTURE_OPTIONS"] = options
    video = cv2.VideoCapture(job["path"], cv2.CAP_FFMPEG)
    if not video.isOpened():
        print("OpenCV cannot open it", file=sys.stderr)
        return 1
    if job.get("probe"):
        names = {"width": "WIDTH", "height": "HEIGHT", "frames": "COUNT"}
        properties = {name: int(video.get(getattr(cv2, f"CAP_PROP_FRAME_{key}"))) for name, key in names.items()}
        print(json.dumps(properties | {"fps": video.get(cv2.CAP_PROP_FPS)}))
        return 0
    write_frames(cv2, video, job)
    return 0


def write_frames(cv2: ModuleType, video: Any, job: dict[str, Any]) -> None:
    numbers = None if job["numbers"] is None else set(job["numbers"])
    last = None if numbers is None else max(numbers, default=-1)
    number, aspect = -1, pixel_aspect(cv2, video)
    while (last is None or number < last) and video.grab():
        number += 1
        if numbers is not None and number not in numbers:
            continue
        _, frame = video.retrieve()
        height, width = frame.shape[0] * max(1.0, 1.0 / aspect), frame.shape[1] * max(1.0, aspect)
        factor = min(1.0, job["max_size"] / max(width, height)) if job["max_size"] else 1.0
        width, height = max(1, round(width * factor)), max(1, round(height * factor))
        if (height, width) != frame.shape[:2]:
            frame = cv2.resize(frame, (width, height), interpolation=cv2.INTER_AREA)
        frame = cv2.cvtColor(frame, cv2.COLOR_BGR2GRAY if job["gray"] else cv2.COLOR_BGR2RGB)
        sys.stdout.buffer.write(f"P{5 if job['gray'] else 6}\n{width} {height}\n255\n".encode())
        sys.stdout.buffer.write(frame.tobytes())
    sys.stdout.buffer.flush()


def pixel_aspect(cv2: ModuleType, video: Any) -> float:
    """Pixel width over height, after rotation by the file's tag."""
    width, height = video.get(cv2.CAP_PROP_SAR_NUM), video.get(cv2.CAP_PROP_SAR_DEN)
    if not (width > 0 and height > 0):
        return 1.0
    is_on_its_side = round(video.get(cv2.CAP_PROP_ORIENTATION_META)) % 180 == 90
    return height / width if is_on_its_side else width / height


if __name__ == "__main__":
    sys.exit(main())

"""Scraper for sphinx-gallery: images and playable recordings of a script.

A cell shows every new global variable that is an image of `loom.render`, in order of definition, and the recording at
the path in the global `page`. All recordings share one player.
"""

from __future__ import annotations

import html
import os
from pathlib import Path
from typing import Any

import pointloom as loom
from pointloom.visualization.recording.film import Film, view_frames
from pointloom.visualization.recording.recorder import Recorder
from pointloom.visualization.recording.shared_player import share_player
from pointloom.visualization.render.picture import Picture

MADE = Path(__file__).parents[1] / "made"  # copied to the _static folder of the site
RECORDINGS, SHOWN = "recordings", "_pointloom_shown"
PAGE, STILL = "page", (960, 640)

IMAGE = """
.. image-sg:: /{path}
   :alt: {alt}
   :srcset: /{path}
   :class: sphx-glr-single-img

"""
FRAME = """
.. raw:: html

   <div class="loom-recording"><iframe src="{path}" title="{title}" loading="lazy" allowfullscreen></iframe>
   <p><a href="{path}">Open on a separate page</a> · drag to rotate, wheel to zoom, H for shortcuts</p></div>

"""


def show_results(block: Any, script: dict[str, Any], gallery: dict[str, Any]) -> str:
    """Scraper that sphinx-gallery calls after each cell."""
    shown: dict[int, Any] = script.setdefault(SHOWN, {})  # keeps the values alive, so that their ids stay unique
    text = ""
    for name, value in list(script["example_globals"].items()):
        if id(value) in shown or name.startswith("_"):
            continue
        if isinstance(value, Picture) and value._is_image():
            shown[id(value)] = value
            text += show_image(name, value, script, gallery)
        elif name == PAGE and isinstance(value, Path) and value.suffix == ".html" and value.exists():
            shown[id(value)] = value
            text += show_recording(value, script, gallery)
    return text


def show_image(name: str, image: Picture, script: dict[str, Any], gallery: dict[str, Any]) -> str:
    """Save an image at the path given by sphinx-gallery."""
    path = next(script["image_path_iterator"])
    loom.write_image(path, image)
    alt = f"{Path(script['src_file']).stem.removeprefix('plot_').replace('_', ' ')}: {name.replace('_', ' ')}"
    return IMAGE.format(path=os.path.relpath(path, gallery["src_dir"]), alt=alt)


def show_recording(page: Path, script: dict[str, Any], gallery: dict[str, Any]) -> str:
    """Add a recording without its player to the site. It gives the thumbnail if there is no image before it."""
    source = Path(script["src_file"])
    folder = MADE / RECORDINGS
    folder.mkdir(parents=True, exist_ok=True)
    count = sum(isinstance(value, Path) for value in script[SHOWN].values())
    name = f"{source.parent.name}_{source.stem.removeprefix('plot_')}_{count}.html"
    share_player(page, folder / name, "../")
    if source.parent in page.resolve().parents:  # leave the folder of the script unchanged
        page.unlink()
    if len(script["image_path_iterator"]) == 0:
        save_still(script)
    up = "../" * (len(Path(os.path.relpath(script["target_file"], gallery["src_dir"])).parts) - 1)
    return FRAME.format(path=f"{up}_static/{RECORDINGS}/{name}", title=html.escape(source.stem.replace("_", " ")))


def save_still(script: dict[str, Any]) -> None:
    """Save the last frame of the recording as the first image, if a global variable is the recorder."""
    recorders = [value for value in script["example_globals"].values() if isinstance(value, Recorder)]
    timeline = recorders[-1].timeline if recorders else None
    if timeline is None or not timeline.frames:
        return
    view = view_frames(timeline, None, *STILL)
    film = Film(timeline, view, *STILL, (1.0, 1.0, 1.0))
    loom.write_image(next(script["image_path_iterator"]), film.draw(len(timeline.frames) - 1))

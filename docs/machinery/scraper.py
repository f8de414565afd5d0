"""What a page of the gallery shows of what its script made: pictures, and recordings that play in the page.

A cell shows every new global that is a picture of `loom.render`, in the order in which names came, and the recording
whose path a global named `page` holds. The player of all recordings lies once in the site.
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

MADE = Path(__file__).parents[1] / "made"  # what lies in the site's _static folder
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
   <p><a href="{path}">On a page of its own</a> · drag to turn, wheel to come nearer, H for the keys</p></div>

"""


def show_results(block: Any, script: dict[str, Any], gallery: dict[str, Any]) -> str:
    """The scraper, as sphinx-gallery calls it after each cell."""
    shown: dict[int, Any] = script.setdefault(SHOWN, {})  # values are kept, so that no other one gets their id
    text = ""
    for name, value in list(script["example_globals"].items()):
        if id(value) in shown or name.startswith("_"):
            continue
        if isinstance(value, Picture) and value._is_image():
            shown[id(value)] = value
            text += show_picture(name, value, script, gallery)
        elif name == PAGE and isinstance(value, Path) and value.suffix == ".html" and value.exists():
            shown[id(value)] = value
            text += show_recording(value, script, gallery)
    return text


def show_picture(name: str, picture: Picture, script: dict[str, Any], gallery: dict[str, Any]) -> str:
    """Save a picture where sphinx-gallery wants it."""
    path = next(script["image_path_iterator"])
    loom.save_picture(path, picture)
    alt = f"{Path(script['src_file']).stem.removeprefix('plot_').replace('_', ' ')}: {name.replace('_', ' ')}"
    return IMAGE.format(path=os.path.relpath(path, gallery["src_dir"]), alt=alt)


def show_recording(page: Path, script: dict[str, Any], gallery: dict[str, Any]) -> str:
    """Put a recording among the site's, without its player; where no picture came before it gives the thumbnail."""
    source = Path(script["src_file"])
    folder = MADE / RECORDINGS
    folder.mkdir(parents=True, exist_ok=True)
    count = sum(isinstance(value, Path) for value in script[SHOWN].values())
    name = f"{source.parent.name}_{source.stem.removeprefix('plot_')}_{count}.html"
    share_player(page, folder / name, "../")
    if source.parent in page.resolve().parents:  # a script's folder stays as it was
        page.unlink()
    if len(script["image_path_iterator"]) == 0:
        save_still(script)
    up = "../" * (len(Path(os.path.relpath(script["target_file"], gallery["src_dir"])).parts) - 1)
    return FRAME.format(path=f"{up}_static/{RECORDINGS}/{name}", title=html.escape(source.stem.replace("_", " ")))


def save_still(script: dict[str, Any]) -> None:
    """The last frame of the script's recording as its first image; there is none where no global is the recorder."""
    recorders = [value for value in script["example_globals"].values() if isinstance(value, Recorder)]
    timeline = recorders[-1].timeline if recorders else None
    if timeline is None or not timeline.frames:
        return
    view = view_frames(timeline, None, *STILL)
    film = Film(timeline, view, *STILL, (1.0, 1.0, 1.0))
    loom.save_picture(next(script["image_path_iterator"]), film.draw(len(timeline.frames) - 1))

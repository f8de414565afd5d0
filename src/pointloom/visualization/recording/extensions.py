"""The extensions of recordings. Nothing heavy is imported here, so that `--help` stays quick."""

from __future__ import annotations

#: Extension -> what displays the file, if not any viewer of images or videos.
RECORDINGS = {".html": "page with player", ".gif": "", ".mp4": "", ".rrd": "Rerun", ".mcap": "Foxglove"}

"""The extensions of recordings. Nothing heavy is imported here, so that `--help` stays quick."""

from __future__ import annotations

RECORDINGS = (".html", ".gif", ".mp4", ".rrd", ".mcap")

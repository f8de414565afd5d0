"""Formats of trajectories by extension. Nothing expensive is imported here, so that `--help` stays fast."""

from __future__ import annotations

#: Names of the formats of an extension. Of several, the number of columns determines which one is read, and commands
#: write the first.
TRAJECTORY_FORMATS = {
    ".log": ("log",),
    ".tum": ("tum",),
    ".txt": ("tum", "kitti"),
    ".kitti": ("kitti",),
    ".json": ("json",),
}

EUROC = ".csv"  # ground truth of EuRoC (ASL), which is only read

FORMATS = tuple(dict.fromkeys(name for names in TRAJECTORY_FORMATS.values() for name in names))

#: Formats of text with a frame number or time per pose, which commands write, by extension.
NUMBERED = {extension: names[0] for extension, names in TRAJECTORY_FORMATS.items() if names[0] in ("log", "tum")}


def extensions_of(format: str) -> tuple[str, ...]:
    """The extensions of a format."""
    return tuple(extension for extension, names in TRAJECTORY_FORMATS.items() if format in names)

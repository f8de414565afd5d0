"""What kind of file system a folder is on: SQLite's log wants memory that processes share, which machines do not."""

from __future__ import annotations

import re
from pathlib import Path

MOUNTS = Path("/proc/self/mountinfo")  # of Linux; elsewhere folders count as local
OVER_NETWORKS = {
    "9p", "afs", "beegfs", "ceph", "cifs", "coda", "davfs", "glusterfs", "gpfs", "juicefs", "lustre", "ncpfs", "nfs",
    "nfs4", "ocfs2", "orangefs", "panfs", "pvfs2", "rclone", "s3fs", "smb3", "smbfs", "sshfs", "vboxsf", "virtiofs",
    "wekafs",
}  # fmt: skip


def is_shared(folder: Path) -> bool:
    """Whether other machines may have the folder at the same time, by the type of its file system."""
    try:
        lines = MOUNTS.read_text().splitlines()
        place = folder.resolve()
    except OSError:
        return False
    found, deepest = "", -1
    for line in lines:
        before, _, after = line.partition(" - ")
        mount, kind = Path(_unescaped(before.split()[4])), after.split()[0]
        if place.is_relative_to(mount) and len(mount.parts) >= deepest:  # of two at one place the later one is seen
            found, deepest = kind, len(mount.parts)
    return found.removeprefix("fuse.") in OVER_NETWORKS


def _unescaped(text: str) -> str:
    """A path of the table of mounts, which holds blanks as \\040."""
    return re.sub(r"\\([0-7]{3})", lambda code: chr(int(code[1], 8)), text)

"""Archives cut into the folders of calls: in the order in which they are needed, as much in each as a call carries."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

SPARE = 1 << 20  # bytes of a call that are left free: what a file costs beside its content
LEAST = 1 << 20  # that a part has, but for the last
LIST = "pieces.txt"


class Piece(NamedTuple):
    """An archive by its short name; None where it was not made."""

    name: str
    path: Path | None


def lay_out(out: Path, pieces: Sequence[Piece], calls: int, room: int) -> list[str]:
    """Write the folders 1 to `calls`; what was done, in words.

    Args:
        out: Where the folders are made anew.
        pieces: In the order in which they are needed.
        calls: How many folders there are.
        room: Bytes that a call carries beside the working tree.
    """
    room -= SPARE
    said = [f"beside the working tree {room / 2**20:.1f} MiB a call can be carried"]
    if room < LEAST:
        return [*said, "too little: a call has to carry more, or the tree less"]
    folders = [out / str(k + 1) for k in range(calls)]
    for folder in folders:
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
    call, free, listed = 0, room, []
    for piece in pieces:
        if piece.path is None:
            said.append(f"{piece.name}: not made, left out")
            continue
        data, at, part = piece.path.read_bytes(), 0, 0
        missing = len(data) - free - room * (calls - call - 1)
        if missing > 0:
            said.append(f"{piece.name}: {missing / 2**20:.1f} MiB more than {calls} calls carry; left out")
            continue
        while at < len(data):
            if free < min(LEAST, len(data) - at):
                call, free = call + 1, room
            size = min(free, len(data) - at)
            (folders[call] / f"{piece.path.name}.part{part:03d}").write_bytes(data[at : at + size])
            at, part, free = at + size, part + 1, free - size
        listed.append(f"{piece.path.name} {part}\n")
        said.append(f"{piece.name}: {len(data) / 2**20:.1f} MiB, whole with call {call + 1}")
    for folder in folders:
        (folder / LIST).write_text("".join(listed))
    return said

"""Split archives into the folders of calls: in the order of need, each filled up to the size limit of a call."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from gpu_kit.steps import Call

SPARE = 1 << 20  # bytes per call left free for per-file overhead
MIN_BYTES = 1 << 20  # minimum size of a part, except for the last
LIST, PLAN = "pieces.txt", "plan.txt"


class Piece(NamedTuple):
    """An archive with its short name; None if it was not built."""

    name: str
    path: Path | None


def lay_out(out: Path, pieces: Sequence[Piece], planned: Sequence[Call], run: int, room: int) -> list[str]:
    """Write a folder for each call; returns a report.

    Args:
        out: Output folder, whose folders of calls are replaced.
        pieces: Archives in the order of need.
        planned: The calls of the run.
        run: Number of the run.
        room: Bytes that a call can carry in addition to the working tree.
    """
    room -= SPARE
    report = [f"each call can carry {room / 2**20:.1f} MiB in addition to the working tree"]
    if room < MIN_BYTES:
        return [*report, "not enough: increase the limit of a call, or reduce the working tree"]
    calls, folders = len(planned), [out / str(call.number) for call in planned]
    for folder in folders:
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
    call, free, listed = 0, room, []
    for piece in pieces:
        if piece.path is None:
            report.append(f"{piece.name}: not built, skipped")
            continue
        data, at, part = piece.path.read_bytes(), 0, 0
        missing = len(data) - free - room * (calls - call - 1)
        if missing > 0:
            report.append(f"{piece.name}: {missing / 2**20:.1f} MiB more than {calls} calls can carry; skipped")
            continue
        while at < len(data):
            if free < min(MIN_BYTES, len(data) - at):
                call, free = call + 1, room
            size = min(free, len(data) - at)
            (folders[call] / f"{piece.path.name}.part{part:03d}").write_bytes(data[at : at + size])
            at, part, free = at + size, part + 1, free - size
        listed.append(f"{piece.path.name} {part}\n")
        report.append(f"{piece.name}: {len(data) / 2**20:.1f} MiB, complete with call {call + 1}")
    for folder, each in zip(folders, planned, strict=True):
        (folder / LIST).write_text("".join(listed))
        (folder / PLAN).write_text(" ".join([str(each.seconds), str(run), *(step.name for step in each.steps)]) + "\n")
        report.append(f"call {each.number}, {each.seconds} s: {each.command}")
    return report

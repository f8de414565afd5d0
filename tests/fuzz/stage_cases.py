"""Jobs that are resumed from records, and the databases and networks of photogrammetry.

One file of a finished job is damaged, and the job is resumed: it must compute the damaged stage again, or name the
file. Values of COLMAP's databases are also changed by SQL, since a file with damaged pages is rejected by SQLite.
"""

from __future__ import annotations

import contextlib
import random
import shutil
import sqlite3
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import mutations
import numpy as np
from folder_cases import made, member
from job_cases import anything, arrays, values
from PIL import Image
from public_cases import array

import pointloom as loom
from pointloom.datasets.scenes.room import write_room_sequence
from pointloom.photogrammetry.mvs.plane_search import PlaneFiles

_CONFIG = loom.rgbd.ReconstructionConfig(n_frames_per_fragment=3, tsdf_voxel_size=0.04, depth_max=4.0)
_SQL: list[Any] = [None, 0, -1, 1, 7, 2**31, 2**62, -(2**63), 1e300, -0.5, "", "x", "../x", "a\x1b[31m", b"", b"\0" * 7]


def frames(folder: Path) -> None:
    write_room_sequence(folder, frame_count=6, width=80, height=60)


def system(folder: Path) -> None:
    """A finished job of the reconstruction system."""
    run_reconstruction_system(folder)


def run_reconstruction_system(folder: Path) -> Any:
    source = loom.open_frames(made(frames))
    loom.rgbd.run_reconstruction_system(
        source, _CONFIG, folder, resume=folder.exists(), stages=("refine", "slac", "integrate")
    )
    return (folder / "scene" / "integrated.ply").read_bytes()


def images(folder: Path) -> None:
    """Six images of a camera that moves sideways, with four boards at different depths in front of a wall."""
    rng = np.random.default_rng(16)
    noise = (rng.integers(0, 256, (size, size), np.uint8) for size in (60, 120) for _ in range(5))
    fine = [Image.fromarray(each).resize((480, 480), Image.Resampling.BICUBIC) for each in noise]
    wall, *boards = (np.asarray(Image.blend(*pair, 0.5)) for pair in zip(fine[:5], fine[5:], strict=True))
    folder.mkdir()
    for k in range(6):
        image = wall[:180, 6 * k : 6 * k + 240].copy()
        for i, board in enumerate(boards):
            x, y = 150 - (9 + 2 * i) * k + 40 * (i % 2), 20 + 80 * (i // 2)
            image[y : y + 60, x - 70 : x] = board[:60, :70]
        Image.fromarray(image).save(folder / f"{k}.png")


def video(folder: Path) -> None:
    """A finished job from images to a mesh."""
    run_video(folder)


def run_video(folder: Path) -> Any:
    settings = loom.photogrammetry.VideoSettings(max_features=500, max_size=80)
    resume = folder.exists()
    loom.photogrammetry.reconstruct_video(made(images), settings, work=folder, resume=resume, device="cpu")
    return (folder / "mesh" / "mesh.ply").read_bytes()


def resumed(name: str, make: Callable[[Path], Any], file: str, mutate: mutations.Mutation, run: Any) -> tuple[Any, ...]:
    """A case: one file of a finished job is damaged. The resumed job must give the same result."""

    def find_difference(path: Path, result: bytes) -> str | None:
        return None if result == run(made(make)) else "the resumed job gives another result"

    return *member(name, make, file, mutate, run)[:-1], find_difference


def features(folder: Path) -> None:
    folder.mkdir()
    loom.photogrammetry.find_features(made(images), folder / "x.db", loom.photogrammetry.SfmSettings(max_features=300))


def matches(folder: Path) -> None:
    folder.mkdir()
    settings = loom.photogrammetry.SfmSettings(pairs="exhaustive")
    loom.photogrammetry.match_features(made(features) / "x.db", folder / "x.db", settings)


def read_features(path: Path) -> Any:
    """Match the images of a damaged database, half of them by retrieval."""
    pairs = "retrieval" if zlib.crc32(path.read_bytes()) % 2 else "exhaustive"
    try:
        settings = loom.photogrammetry.SfmSettings(pairs=pairs)
        return loom.photogrammetry.match_features(path, path.with_name("out.db"), settings)
    except ValueError as error:
        if str(error).startswith("pairs:"):  # the features are of another kind by the database
            raise loom.FileError(path, str(error)) from error
        raise


def read_matches(path: Path) -> Any:
    shutil.rmtree(path.with_name("model"), ignore_errors=True)
    return loom.photogrammetry.map_images(made(images), path, path.with_name("model")).to_dict()


def cells(rng: random.Random, data: bytes) -> bytes:
    """A database with one to three changed cells, rows or tables."""
    with contextlib.closing(sqlite3.connect(":memory:")) as base:
        base.deserialize(data)
        for _ in range(rng.choice([1, 1, 2, 3])):
            with contextlib.suppress(sqlite3.Error):
                _change(rng, base)
        base.commit()
        return base.serialize()


def _change(rng: random.Random, base: sqlite3.Connection) -> None:
    names = "SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT LIKE 'sqlite_%' ORDER BY name"
    tables = [name for (name,) in base.execute(names) if base.execute(f"SELECT count(*) FROM {name}").fetchone()[0]]
    table = rng.choice(tables)
    columns = [row[1] for row in base.execute(f"PRAGMA table_info({table})")]
    column, kind = rng.choice(columns), rng.random()
    where = f"WHERE rowid IN (SELECT rowid FROM {table} LIMIT {rng.choice([1, 1, 99])})"
    if kind < 0.06:
        base.execute(f"DROP TABLE {table}")
    elif kind < 0.12:
        base.execute(f"ALTER TABLE {table} RENAME COLUMN {column} TO other")
    elif kind < 0.2:
        base.execute(f"DELETE FROM {table} {where}")
    else:
        value = rng.choice(_SQL)
        if rng.random() < 0.3:
            (old,) = base.execute(f"SELECT {column} FROM {table} {where}").fetchone()
            value = mutations.binary(rng, old) if isinstance(old, bytes) else value
        base.execute(f"UPDATE {table} SET {column} = ? {where}", (value,))


def checkpoints() -> list[bytes]:
    """The planes of an image during a search of depth maps."""
    return [array(np.random.default_rng(18).random((48, 4), np.float32))]


def read_checkpoint(path: Path) -> Any:
    """Read the planes, or None for a damaged file, whose phase is then repeated."""
    shutil.copyfile(path, path.with_name("0-000000.npy"))
    planes = PlaneFiles(path.parent).read(0, 0, loom.PinholeCameraIntrinsic(8, 6, 5.0, 5.0, 3.5, 2.5))
    return None if planes is None else planes.read()


def of_database(name: str, make: Callable[[Path], Any], mutate: mutations.Mutation, read: Any) -> tuple[Any, ...]:
    return name, ".db", lambda: [(made(make) / "x.db").read_bytes()], mutate, read, anything


RECORD = "records/{}.json"

# name, suffix, seeds, mutate, read, oracle: as in cases.Case
STAGES = [
    *(resumed(f"reconstruction, record {name}", system, RECORD.format(name), values, run_reconstruction_system)
      for name in ("fragment_000", "register", "refine", "slac", "integrate")),
    resumed("reconstruction, configuration", system, "config.json", values, run_reconstruction_system),
    resumed("reconstruction, graph", system, "fragments/fragment_000.json", values, run_reconstruction_system),
    resumed("reconstruction, cloud", system, "fragments/fragment_000.ply", mutations.binary, run_reconstruction_system),
    resumed("reconstruction, grid", system, "slac/control_grid.npz", arrays, run_reconstruction_system),
    resumed("reconstruction, mesh", system, "scene/integrated.ply", mutations.binary, run_reconstruction_system),
    *(resumed(f"video, record {name}", video, RECORD.format(name), values, run_video)
      for name in ("frames", "features", "matches", "model", "undistorted", "depth", "fused", "mesh")),
    resumed("video, marker", video, "video.json", values, run_video),
    resumed("video, report", video, "report.json", values, run_video),
    resumed("video, model", video, "model/sparse/images.bin", mutations.binary, run_video),
    resumed("video, depth", video, "depth/maps/000000.npz", arrays, run_video),
    resumed("video, mesh", video, "mesh/mesh.ply", mutations.binary, run_video),
    ("checkpoint of a search", ".npy", checkpoints, mutations.binary, read_checkpoint, anything),
    of_database("features, bytes", features, mutations.binary, read_features),
    of_database("features, cells", features, cells, read_features),
    of_database("matches, bytes", matches, mutations.binary, read_matches),
    of_database("matches, cells", matches, cells, read_matches),
]  # fmt: skip

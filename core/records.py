"""Records beside results: what a stage was made from and which files it left, so that a later run may keep them.

A record is written last, when the files that it names are whole. A run that is interrupted before leaves files that no
record speaks for, and they are made again. Records hold digests: a file that was changed or cut off is made again too.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from .atomic import atomic_write
from .errors import FileError, FilePath
from .json_files import read_json_object
from .paths import path_of

RECORDS = "records"  # the folder below a job's that they lie in
VERSION = 1  # raised where a stage begins to make something else of the same inputs
DIGEST_BYTES = 16
CHUNK = 1 << 20  # [B]


def digest_of(values: Any) -> str:
    """A digest of values in JSON's types."""
    text = json.dumps(values, sort_keys=True, allow_nan=False)
    return hashlib.blake2b(text.encode(), digest_size=DIGEST_BYTES).hexdigest()


def digest_of_bytes(parts: Iterable[Any]) -> str:
    """A digest of arrays or bytes, one after the other."""
    digest = hashlib.blake2b(digest_size=DIGEST_BYTES)
    for part in parts:
        digest.update(part)
    return digest.hexdigest()


def digest_of_file(path: FilePath) -> str:
    """A digest of what a file holds, read in pieces.

    Raises:
        OSError: It cannot be read.
    """
    with path_of(path).open("rb") as file:
        return digest_of_bytes(iter(lambda: file.read(CHUNK), b""))


def record_file(root: Path, stage: str, number: int | None = None) -> Path:
    """Where the record of a stage of the job in `root` lies, or of one of the parts that the stage makes one by one."""
    return root / RECORDS / (f"{stage}.json" if number is None else f"{stage}_{number:03d}.json")


def write_record(
    path: Path, stage: str, made_from: str, root: Path, files: Sequence[Path], result: dict[str, Any]
) -> None:
    """Say what a stage made, once its files are whole.

    Args:
        path: The record.
        stage: Of which stage it is.
        made_from: Digest of its inputs.
        root: Folder that the files lie below.
        files: What it wrote.
        result: What else later stages want to know, in JSON's types.

    Raises:
        FileError: It cannot be written, or a file of the stage cannot be read.
    """
    try:
        digests = {file.relative_to(root).as_posix(): digest_of_file(file) for file in files}
    except OSError as error:
        raise FileError(error.filename or path, f"cannot be read: {error.strerror or error}") from error
    content = {"version": VERSION, "stage": stage, "made_from": made_from, "files": digests, "result": result}
    text = json.dumps(content, indent=1, allow_nan=False) + "\n"
    with atomic_write(path) as file:
        file.write(text.encode())


def read_record(path: Path, stage: str, root: Path, made_from: str | None = None) -> dict[str, Any] | None:
    """The result in a record, or None where there is none that still fits.

    Args:
        path: The record.
        stage: Of which stage it should be.
        root: Folder that its files lie below.
        made_from: Digest of the inputs that it should be made from; None takes any.
    """
    try:
        content = read_json_object(path)
    except FileError:
        return None
    expected = {"version": VERSION, "stage": stage} | ({} if made_from is None else {"made_from": made_from})
    if any(content.get(key) != value for key, value in expected.items()):
        return None
    files, result = content.get("files"), content.get("result")
    if not isinstance(files, dict) or not isinstance(result, dict):
        return None
    try:
        fits = all(digest_of_file(root / name) == digest for name, digest in files.items())
    except OSError:
        return None
    return result | {"made_from": content.get("made_from")} if fits else None

"""Records of job stages: digests of inputs and output files, so that later runs can reuse results.

A record is written last, with a digest of itself. Files without a valid record, or with another digest, are recomputed.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from .atomic import atomic_write
from .errors import FileError, FilePath
from .json_fields import Check, is_text
from .json_files import read_json_object
from .paths import input_path

RECORDS = "records"  # name of the subfolder of a job
RECORD_VERSION = 1  # incremented if a stage's output for equal inputs changes
DIGEST_BYTES = 16
CHUNK_BYTES = 1 << 20  # [B]
_DIGEST = "digest"  # of all other entries of a record


def digest_of(values: object) -> str:
    text = json.dumps(values, sort_keys=True, allow_nan=False)
    return hashlib.blake2b(text.encode(), digest_size=DIGEST_BYTES).hexdigest()


def digest_of_bytes(parts: Iterable[Any]) -> str:
    digest = hashlib.blake2b(digest_size=DIGEST_BYTES)
    for part in parts:
        digest.update(part)
    return digest.hexdigest()


def digest_of_file(path: FilePath) -> str:
    with input_path(path).open("rb") as file:
        return digest_of_bytes(iter(lambda: file.read(CHUNK_BYTES), b""))


def record_file(root: Path, stage: str, number: int | None = None) -> Path:
    return root / RECORDS / (f"{stage}.json" if number is None else f"{stage}_{number:03d}.json")


def files_below(root: Path, files: Iterable[Path]) -> dict[str, Path]:
    """Files by their names in a record."""
    return {file.relative_to(root).as_posix(): file for file in files}


def write_record(path: Path, stage: str, made_from: str, files: Mapping[str, Path], result: dict[str, Any]) -> None:
    try:
        digests = {name: digest_of_file(file) for name, file in files.items()}
    except OSError as error:
        raise FileError(error.filename or path, f"cannot be read: {error.strerror or error}") from error
    content = {"version": RECORD_VERSION, "stage": stage, "made_from": made_from, "files": digests, "result": result}
    content = json.loads(json.dumps(content, allow_nan=False))  # tuples become lists, as when it is read
    text = json.dumps(content | {_DIGEST: digest_of(content)}, indent=1) + "\n"
    with atomic_write(path) as file:
        file.write(text.encode())


def read_record(
    path: Path, stage: str, root: Path, is_result: Check, made_from: str | None = None
) -> dict[str, Any] | None:
    """The result in a valid record, or None; `is_result` checks its fields, `made_from` None accepts any inputs."""
    try:
        content = read_json_object(path)
    except FileError:
        return None
    if content.pop(_DIGEST, None) != digest_of(content):  # changed after it was written
        return None
    expected = {"version": RECORD_VERSION, "stage": stage} | ({} if made_from is None else {"made_from": made_from})
    if any(content.get(key) != value for key, value in expected.items()):
        return None
    files, result = content.get("files"), content.get("result")
    if not isinstance(files, dict) or not isinstance(result, dict) or not is_text(content.get("made_from")):
        return None
    if not is_result(result):
        return None
    try:
        fits = all(digest_of_file(root / name) == digest for name, digest in files.items())
    except (OSError, ValueError):  # also a name that the system rejects
        return None
    return result | {"made_from": content["made_from"]} if fits else None

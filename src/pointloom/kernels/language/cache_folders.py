"""Folder of compiled kernels: the user's cache folder, or a temporary one if that is not usable.

Compiled kernels run in this process, so files that other users can write to are not used silently. Each file has a
digest, since a full disk or a killed process can truncate it. A mismatch causes recompilation.
"""

from __future__ import annotations

import atexit
import contextlib
import hashlib
import os
import shutil
import stat
import struct
import tempfile
from pathlib import Path

MIN_FREE_BYTES = 8 << 20  # [B] free space required to compile a module: LLVM ends the process if the disk is full
_DIGEST = ".sha256"  # suffix of the file name
_ELF = struct.Struct("<4s36xQ10xHH")  # of a 64-bit ELF file: magic, offset, size and number of its section headers


class CacheError(RuntimeError): ...


def is_writable(folder: str | os.PathLike[str], size: int = 0) -> bool:
    """True if a file of `size` bytes can be written to a folder, which need not exist yet."""
    path = Path(folder)
    try:
        path.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=path) as file:
            for _ in range(0, size, 1 << 20):
                file.write(bytes(1 << 20))
            file.flush()
            return True
    except OSError:
        return False


def can_be_written(folder: Path) -> bool:
    """True if this user may write to a folder, or create it. Creates nothing."""
    existing = next((path for path in (folder, *folder.absolute().parents) if path.exists()), folder)
    return existing.is_dir() and os.access(existing, os.W_OK | os.X_OK)


def cache_folder() -> Path:
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")


def temporary_cache() -> str:
    folder = tempfile.mkdtemp(prefix="pointloom-kernels-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder


def other_writers(folder: Path) -> str:
    """Describe other users who can write to a folder or its contents. Empty if none."""
    if not hasattr(os, "getuid"):
        return ""
    try:
        inner = [*folder.iterdir()]  # one folder for each version of the compiler
    except OSError:
        inner = []
    for path in (folder, *inner):
        with contextlib.suppress(OSError):
            status = path.stat()
            if stat.S_ISDIR(status.st_mode) and (writers := _writers_of(status)):
                return f"{path} {writers}"
    for path in folder.absolute().parents:
        with contextlib.suppress(OSError):
            mode = path.stat().st_mode
            if mode & stat.S_IWOTH and not mode & stat.S_ISVTX:
                return f"{path} can be written to by all users"
    return ""


def is_intact(*files: Path) -> bool:
    """True if files match their digests (or have a complete end) and no other user can have written them."""
    try:
        return all(_is_intact(file) for file in files)
    except OSError:
        return False


def seal(*files: Path) -> None:
    with contextlib.suppress(OSError):
        for file in files:
            write_atomically(file.with_name(file.name + _DIGEST), _digest_of(file.read_bytes()))


def discard(*files: Path) -> bool:
    """Remove files and their digests. False if one cannot be removed."""
    try:
        for file in files:
            file.unlink(missing_ok=True)
            file.with_name(file.name + _DIGEST).unlink(missing_ok=True)
    except OSError:
        return False
    return True


def write_atomically(path: Path, content: bytes) -> None:
    part = path.with_name(f".{path.name}.{os.urandom(8).hex()}.part")
    try:
        with part.open("xb") as file:
            file.write(content)
        part.replace(path)
    except BaseException:
        with contextlib.suppress(OSError):
            part.unlink()
        raise


def _writers_of(status: os.stat_result) -> str:
    if status.st_uid not in (0, os.getuid()):
        return f"belongs to user {status.st_uid}"
    if status.st_mode & stat.S_IWOTH:
        return "can be written to by all users"
    if status.st_mode & stat.S_IWGRP and not _is_own_group(status.st_gid):
        return f"can be written to by group {status.st_gid}"
    return ""


def _is_own_group(group: int) -> bool:
    import grp
    import pwd

    try:
        user, entry = pwd.getpwuid(os.getuid()), grp.getgrgid(group)
    except KeyError:
        return False
    return entry.gr_name == user.pw_name and set(entry.gr_mem) <= {user.pw_name}


def _is_intact(file: Path) -> bool:
    if hasattr(os, "getuid") and _writers_of(file.stat()):
        return False
    content = file.read_bytes()
    try:
        return file.with_name(file.name + _DIGEST).read_bytes() == _digest_of(content)
    except FileNotFoundError:
        return _has_end(content)


def _digest_of(content: bytes) -> bytes:
    return hashlib.sha256(content).hexdigest().encode()


def _has_end(content: bytes) -> bool:
    """True if the end of the file exists: section headers of machine code, or the last brace of PTX and JSON."""
    if content[:4] == b"\x7fELF" and len(content) >= _ELF.size:
        _, begin, size, count = _ELF.unpack_from(content)
        return bool(begin) and begin + size * count <= len(content)
    return content.rstrip(b"\0 \n").endswith(b"}")

"""Where the compilers keep compiled kernels: the user's cache folder, or a temporary one where that cannot be used.

Compiled kernels are code that runs in this process. So a folder or file that other users can write to is not used
silently. Each file has a digest beside it, because a full disk, a failure of power or a killed process can leave a part
of a file. A file that does not match its digest is compiled again.
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

ROOM = 8 << 20  # [B] that must be free before a module is compiled: LLVM ends the process if the disk is full
_DIGEST = ".sha256"  # follows the name of the file
_ELF = struct.Struct("<4s36xQ10xHH")  # of a file of 64 bits: magic, place, size and number of its section headers


class CacheError(RuntimeError):
    """No folder for compiled kernels can be written to."""


def is_writable(folder: str | os.PathLike[str], size: int = 0) -> bool:
    """True if a file of some bytes can be written in a folder, which need not exist yet."""
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


def cache_folder() -> Path:
    """The user's cache folder."""
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")


def temporary_cache() -> str:
    """A folder that is removed when the program ends."""
    folder = tempfile.mkdtemp(prefix="pointloom-kernels-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder


def other_writers(folder: Path) -> str:
    """Which other users can write to a folder or to one in it; empty if none can, or the system has no such users."""
    if not hasattr(os, "getuid"):
        return ""
    try:
        inner = [*folder.iterdir()]  # one folder for each version of the compiler
    except OSError:
        inner = []
    for place in (folder, *inner):
        with contextlib.suppress(OSError):
            status = place.stat()
            if stat.S_ISDIR(status.st_mode) and (found := _writers_of(status)):
                return f"{place} {found}"
    for place in folder.absolute().parents:
        with contextlib.suppress(OSError):
            mode = place.stat().st_mode
            if mode & stat.S_IWOTH and not mode & stat.S_ISVTX:
                return f"{place} can be written to by all users"
    return ""


def is_intact(*files: Path) -> bool:
    """True if files have their digests and no other user can have written them.

    A file without a digest, as an earlier version or a killed process leaves it, is examined for its end.
    """
    try:
        return all(_is_intact(file) for file in files)
    except OSError:
        return False


def seal(*files: Path) -> None:
    """Write the digests of files, if the folder can be written to."""
    with contextlib.suppress(OSError):
        for file in files:
            write_atomically(file.with_name(file.name + _DIGEST), _digest_of(file.read_bytes()))


def discard(*files: Path) -> bool:
    """Remove files and their digests; False if one cannot be removed."""
    try:
        for file in files:
            file.unlink(missing_ok=True)
            file.with_name(file.name + _DIGEST).unlink(missing_ok=True)
    except OSError:
        return False
    return True


def write_atomically(path: Path, content: bytes) -> None:
    """Write a file so that other processes see all of it or nothing."""
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
    """True if a group has only this user, as many systems create one for each user."""
    import grp
    import pwd

    try:
        user, found = pwd.getpwuid(os.getuid()), grp.getgrgid(group)
    except KeyError:
        return False
    return found.gr_name == user.pw_name and set(found.gr_mem) <= {user.pw_name}


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
    """True if the end of a file is there: the section headers of machine code, or the last brace of PTX and JSON."""
    if content[:4] == b"\x7fELF" and len(content) >= _ELF.size:
        _, begin, size, count = _ELF.unpack_from(content)
        return bool(begin) and begin + size * count <= len(content)
    return content.rstrip(b"\0 \n").endswith(b"}")

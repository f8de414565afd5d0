"""Public sets from their hosts or a mirror to the disk, by pooch: checked, whole or not at all."""

from __future__ import annotations

import json
import os
import shutil
import stat
import zipfile
from pathlib import Path, PurePosixPath
from typing import Any

from ...core.atomic import part_name
from ...core.checks import check_name
from ...core.errors import FileError
from ...core.known_names import nearest_name
from ...core.paths import path_of
from ..kept import data_folder
from .sets import SETS, PublicFile, PublicSet

MIRROR = "POINTLOOM_DATA_MIRROR"
LISTING = ".files.json"  # what a set's folder holds, by which a later call knows it whole
TIMEOUT = 30.0  # [s] without a byte


def fetch(name: str, folder: str | os.PathLike[str] | None = None) -> Path:
    """The folder or file of a public set, downloaded when it is first asked for.

    Each file is checked against its published checksum, archives are unpacked, and the set takes its name when all of
    it is there. A mirror comes first where the environment variable POINTLOOM_DATA_MIRROR names one: an address or a
    folder that holds `<set>/<file>`. Needs the extra `pip install "pointloom[data]"` unless the set is there already.

    Args:
        name: One of `public_sets()`.
        folder: Where sets are kept; None for `pointloom/data/public` in the user's cache folder.

    Returns:
        The file of a set that is one plain file; else the folder `<folder>/<name>`.

    Raises:
        TypeError, ValueError: No such set; the message has the nearest name.
        FileError: It cannot be downloaded, which says what to put where by hand; a file with another checksum; an
            archive with names that lead out of its folder; a folder that cannot be written to; no pooch.

    Example:
        >>> import pointloom as loom
        >>> loom.data.fetch("buny")
        Traceback (most recent call last):
            ...
        ValueError: name: no public set 'buny'; did you mean 'bunny'? There are armadillo, bunny, ...
    """
    if check_name("name", name) not in SETS:
        raise ValueError(f"name: no public set {name!r}{nearest_name(name, SETS)} There are {', '.join(SETS)}")
    wanted = SETS[name]
    home = data_folder() / "public" if folder is None else path_of(folder, "folder")
    place = home / name
    if not _is_whole(place):
        _bring(wanted, home, place)
    plain = [file for file in wanted.files if file.unpack is None]
    return place / plain[0].name if len(wanted.files) == len(plain) == 1 else place


def _is_whole(place: Path) -> bool:
    """Whether all files of a set are there, in their sizes."""
    try:
        sizes = json.loads((place / LISTING).read_text())
        return bool(sizes) and all((place / name).stat().st_size == size for name, size in sizes.items())
    except (OSError, ValueError, AttributeError):
        return False


def _bring(wanted: PublicSet, home: Path, place: Path) -> None:
    """Download and unpack a set beside its place, then give it its name."""
    downloads = home / "downloads"
    try:
        downloads.mkdir(parents=True, exist_ok=True)
        part = part_name(home / wanted.name)
        part.mkdir()
    except OSError as error:
        raise FileError(home, f"cannot be written: {error.strerror or error}", remedy="Give another folder") from error
    try:
        for file in wanted.files:
            archive = _download(wanted, file, downloads)
            if file.unpack is None:
                shutil.copyfile(archive, part / file.name)
            else:
                _unpack(archive, part / file.unpack)
        files = sorted(path for path in part.rglob("*") if path.is_file())
        sizes = {path.relative_to(part).as_posix(): path.stat().st_size for path in files}
        (part / LISTING).write_text(json.dumps(sizes, indent=0))
        _settle(part, place)
    except OSError as error:
        raise FileError(place, f"cannot be written: {error.strerror or error}") from error
    finally:
        shutil.rmtree(part, ignore_errors=True)
    for file in wanted.files:
        _download_path(wanted, file, downloads).unlink(missing_ok=True)


def _settle(part: Path, place: Path) -> None:
    """Give a whole set its name, in place of one that is damaged; another process may have been quicker."""
    if place.exists() and not _is_whole(place):
        shutil.rmtree(place)
    try:
        part.rename(place)
    except OSError:
        if not _is_whole(place):
            raise


def _download_path(wanted: PublicSet, file: PublicFile, downloads: Path) -> Path:
    return downloads / f"{wanted.name}-{file.name}"


def _download(wanted: PublicSet, file: PublicFile, downloads: Path) -> Path:
    """A file of a set, from where it was put by hand, from the mirror or from its host; with its checksum."""
    pooch, path = _pooch(), _download_path(wanted, file, downloads)
    reasons = []
    for source in _sources(wanted, file):
        try:
            if "://" in source:
                loader = pooch.HTTPDownloader(timeout=TIMEOUT, progressbar=False)
                pooch.retrieve(source, file.checksum, path.name, downloads, downloader=loader)
                return path
            if _matches(pooch, path, file):
                return path
            if _matches(pooch, Path(source), file):
                return Path(source)
            missing = not Path(source).exists()
            reasons.append(f"{source} " + ("is not there" if missing else "has another checksum"))
        except (ValueError, OSError) as error:  # pooch's word for another checksum; all that requests raises
            reasons.append(f"{source}: {_brief(error)}")
    remedy = (
        f"Download {file.url} by hand and put it at {path}, or name a mirror (an address or a folder that holds "
        f"{wanted.name}/{file.name}) by {MIRROR}"
    )
    raise FileError(path, "cannot be downloaded: " + "; ".join(reasons), remedy=remedy)


def _sources(wanted: PublicSet, file: PublicFile) -> list[str]:
    """Addresses and paths where a file may be, in order."""
    mirror = os.environ.get(MIRROR, "").rstrip("/")
    return [f"{mirror}/{wanted.name}/{file.name}", file.url] if mirror else [file.url]


def _matches(pooch: Any, path: Path, file: PublicFile) -> bool:
    """Whether a file is there with the checksum."""
    kind, _, wanted = file.checksum.partition(":")
    return path.is_file() and pooch.file_hash(str(path), alg=kind) == wanted


def _brief(error: Exception) -> str:
    """An error in one line of some words."""
    lines = str(error).strip().splitlines()
    text = lines[0] if lines else type(error).__name__
    return text if len(text) <= 200 else text[:197] + "..."


def _pooch() -> Any:
    try:
        import pooch
    except ImportError as error:
        reason = "public sets are fetched by the package pooch, which is not installed"
        raise FileError("pooch", reason, remedy='pip install "pointloom[data]"') from error
    pooch.get_logger().setLevel("WARNING")
    return pooch


def _unpack(archive: Path, folder: Path) -> None:
    """Unpack a ZIP archive; names that lead out of the folder, and links, are refused before anything is written."""
    try:
        with zipfile.ZipFile(archive) as file:
            for member in file.infolist():
                name = member.filename
                parts = PurePosixPath(name.replace("\\", "/"))
                is_link = stat.S_ISLNK(member.external_attr >> 16)
                if parts.is_absolute() or ".." in parts.parts or ":" in name or is_link or "\0" in name:
                    raise FileError(archive, f"holds {name!r}, which leads out of its folder or is a link")
            folder.mkdir(parents=True, exist_ok=True)
            file.extractall(folder)
    except (zipfile.BadZipFile, EOFError, NotImplementedError) as error:
        raise FileError(archive, f"cannot be unpacked: {error}") from error

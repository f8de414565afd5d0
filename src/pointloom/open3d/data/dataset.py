"""`Dataset`: the folder of a sample data set, and the paths of its files."""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

from ...core.attribute_hints import KnownNames
from ...core.errors import FileError

VARIABLE = "POINTLOOM_SAMPLES"  # a folder of sample data sets
open3d_downloads_prefix = "https://github.com/isl-org/open3d_downloads/releases/download/"


@dataclass
class DataDescriptor:
    """Addresses and checksum of a file for `DownloadDataset`."""

    urls: Any
    md5: str = ""
    extract_in_subdir: str = ""


class Dataset(KnownNames):
    """A data set in the folder `prefix` or `extract/prefix` of `data_root`.

    Without `data_root`, the folder in the environment variable POINTLOOM_SAMPLES is searched first, then that in
    OPEN3D_DATA_ROOT or ~/open3d_data, where Open3D stores its downloads. An attribute of a missing file raises
    FileError.
    """

    _similar: ClassVar[str] = ""  # code that makes similar data
    _public: ClassVar[str] = ""  # name of the data for `loom.datasets.fetch`

    def __init__(self, prefix: str, data_root: str | os.PathLike[str] = ""):
        if not prefix:
            raise ValueError("prefix: expected the name of a data set, got ''")
        self._prefix, roots = prefix, _roots(data_root)
        folders = {root / part: root for root in roots for part in (f"extract/{prefix}", prefix)}
        existing = [folder for folder in folders if folder.is_dir()]
        self._folder = (existing or list(folders))[0]
        self._root = folders[self._folder]

    @property
    def data_root(self) -> str:
        """The folder of all data sets."""
        return str(self._root)

    @property
    def prefix(self) -> str:
        return self._prefix

    @property
    def download_dir(self) -> str:
        """The folder of Open3D's downloads. Unused here."""
        return str(self._root / "download" / self._prefix)

    @property
    def extract_dir(self) -> str:
        """The folder of the files."""
        return str(self._folder)

    def _path(self, name: str) -> str:
        """The path of an existing file. Raises FileError."""
        path = self._folder / name
        if not path.is_file():
            remedies = [f"Put the file there, or set {VARIABLE} to a folder that contains {self._prefix}/{name}"]
            remedies += [f'loom.datasets.fetch("{self._public}") downloads this data'] if self._public else []
            remedies += [f"loom.datasets.{self._similar} makes similar data"] if self._similar else []
            reason = f"the file {name} of the data set {self._prefix} is missing, and nothing is downloaded"
            raise FileError(path, reason, remedy=". ".join(remedies))
        return str(path)

    def _paths(self, pattern: str, numbers: Iterable[int]) -> list[str]:
        return [self._path(pattern.format(number)) for number in numbers]

    def __repr__(self) -> str:
        return f"{type(self).__name__}({str(self._folder)!r})"


class SampleDataset(Dataset):
    """A data set whose name is that of its class; `similar` and `public` of subclasses are those of `Dataset`."""

    def __init_subclass__(cls, similar: str = "", public: str = ""):
        cls._similar, cls._public = similar or cls._similar, public or cls._public

    def __init__(self, data_root: str | os.PathLike[str] = ""):
        super().__init__(type(self).__name__, data_root)


class DownloadDataset(Dataset):
    """A data set of the caller. Raises FileError if its folder does not exist, since nothing is downloaded."""

    def __init__(self, prefix: str, data_descriptor: Any = None, data_root: str | os.PathLike[str] = ""):
        super().__init__(prefix, data_root)
        if not self._folder.is_dir():
            given = "does not exist, and nothing is downloaded"
            raise FileError(self._folder, given, remedy="Make the folder and put the files there")


def _roots(data_root: str | os.PathLike[str]) -> list[Path]:
    if os.fspath(data_root):
        return [Path(data_root).expanduser()]
    samples, own = os.environ.get(VARIABLE), os.environ.get("OPEN3D_DATA_ROOT")
    return [*([Path(samples).expanduser()] if samples else []), Path(own or "~/open3d_data").expanduser()]


def file(name: str) -> Any:
    """An attribute with the path of a file."""
    return property(lambda self: self._path(name))


def files(pattern: str, numbers: Iterable[int]) -> Any:
    """An attribute with the paths of numbered files."""
    return property(lambda self: self._paths(pattern, numbers))


def files_in(folder: str, suffix: str) -> Any:
    """An attribute with the sorted paths of all files of a folder. Raises FileError if there are none."""

    def read(self: Dataset) -> list[str]:
        found = sorted(path.name for path in (self._folder / folder).glob(f"*{suffix}"))
        return [self._path(f"{folder}/{name}") for name in found or [f"*{suffix}"]]

    return property(read)


def path_map(**names: str) -> Any:
    """An attribute with the paths of files by key."""
    return property(lambda self: {key: self._path(name) for key, name in names.items()})

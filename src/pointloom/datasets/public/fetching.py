"""Download public data sets with pooch: checksums, licenses, citations.

Checksums are those published by the hosts. Open3D's are MD5, which detects damage but not forgery.
"""

from __future__ import annotations

import dataclasses
import json
import os
import shutil
import stat
import zipfile
from pathlib import Path, PurePosixPath
from types import ModuleType
from typing import Any

from ...core.atomic import part_name
from ...core.attribute_hints import nearest_name
from ...core.checks import check_name
from ...core.errors import FileError, FilePath
from ...core.paths import path_of
from ..array_cache import data_folder

MIRROR = "POINTLOOM_DATA_MIRROR"
LISTING = ".files.json"  # list of a set's files, by which later calls recognize it as complete
TIMEOUT_SECONDS = 30.0  # [s] timeout without a byte


def fetch(name: str, folder: FilePath | None = None) -> Path:
    """The folder or file of a public data set, downloaded on first use.

    Files are verified by checksum, archives are unpacked, and the set appears atomically. If POINTLOOM_DATA_MIRROR is
    set to an address or folder with `<set>/<file>`, it is tried first. Downloads require `pip install
    "pointloom[data]"`.

    Args:
        name: Name of a set, such as "bunny". The error of an unknown name lists all.
        folder: Folder of the sets. None for `pointloom/datasets/public` in the user's cache folder.

    Returns:
        The file of a set that is one plain file. Else the folder `<folder>/<name>`.

    Raises:
        TypeError, ValueError: No such set. The message suggests the nearest name.
        FileError: Download failed (with instructions for manual download), wrong checksum, an archive with names
            outside its folder, a folder that is not writable, or pooch is missing.

    Example:
        >>> import pointloom as loom
        >>> loom.datasets.fetch("buny")
        Traceback (most recent call last):
            ...
        ValueError: name: no public set 'buny'; did you mean 'bunny'? There are armadillo, bunny, ...
    """
    if check_name("name", name) not in SETS:
        raise ValueError(f"name: no public set {name!r}{nearest_name(name, SETS)} There are {', '.join(SETS)}")
    wanted = SETS[name]
    home = data_folder() / "public" if folder is None else path_of(folder, "folder")
    target = home / name
    if not _is_complete(target):
        _bring(wanted, home, target)
    plain = [file for file in wanted.files if file.unpack is None]
    return target / plain[0].name if len(wanted.files) == len(plain) == 1 else target


def _is_complete(folder: Path) -> bool:
    try:
        sizes = json.loads((folder / LISTING).read_text(encoding="utf-8"))
        return bool(sizes) and all((folder / name).stat().st_size == size for name, size in sizes.items())
    except (OSError, ValueError, AttributeError):
        return False


def _bring(wanted: PublicSet, home: Path, target: Path) -> None:
    """Download and unpack a set beside its final location, then rename it."""
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
        (part / LISTING).write_text(json.dumps(sizes, indent=0), encoding="utf-8")
        _publish(part, target)
    except OSError as error:
        raise FileError(target, f"cannot be written: {error.strerror or error}") from error
    finally:
        shutil.rmtree(part, ignore_errors=True)
    for file in wanted.files:
        _download_path(wanted, file, downloads).unlink(missing_ok=True)


def _publish(part: Path, target: Path) -> None:
    """Rename a complete set, replacing a damaged one. Another process may have done so already."""
    if target.exists() and not _is_complete(target):
        shutil.rmtree(target)
    try:
        part.rename(target)
    except OSError:
        if not _is_complete(target):
            raise


def _download_path(wanted: PublicSet, file: PublicFile, downloads: Path) -> Path:
    return downloads / f"{wanted.name}-{file.name}"


def _download(wanted: PublicSet, file: PublicFile, downloads: Path) -> Path:
    """A file of a set with a valid checksum: placed manually, from the mirror, or from its host."""
    pooch, path = _pooch(), _download_path(wanted, file, downloads)
    reasons = []
    for source in _sources(wanted, file):
        try:
            if "://" in source:
                loader = pooch.HTTPDownloader(timeout=TIMEOUT_SECONDS, progressbar=False)
                pooch.retrieve(source, file.checksum, path.name, downloads, downloader=loader)
                return path
            if _matches(pooch, path, file):
                return path
            if _matches(pooch, Path(source), file):
                return Path(source)
            missing = not Path(source).exists()
            reasons.append(f"{source} " + ("is not there" if missing else "has a different checksum"))
        except (ValueError, OSError) as error:  # pooch's error for a wrong checksum. All errors of requests
            reasons.append(f"{source}: {_brief(error)}")
    remedy = (
        f"Download {file.url} manually to {path}, or set a mirror (a URL or a folder that contains "
        f"{wanted.name}/{file.name}) by {MIRROR}"
    )
    raise FileError(path, "cannot be downloaded: " + "; ".join(reasons), remedy=remedy)


def _sources(wanted: PublicSet, file: PublicFile) -> list[str]:
    mirror = os.environ.get(MIRROR, "").rstrip("/")
    return [f"{mirror}/{wanted.name}/{file.name}", file.url] if mirror else [file.url]


def _matches(pooch: ModuleType, path: Path, file: PublicFile) -> bool:
    kind, _, wanted = file.checksum.partition(":")
    return path.is_file() and pooch.file_hash(str(path), alg=kind) == wanted


def _brief(error: Exception) -> str:
    lines = str(error).strip().splitlines()
    text = lines[0] if lines else type(error).__name__
    return text if len(text) <= 200 else text[:197] + "..."


def _pooch() -> Any:
    try:
        import pooch
    except ImportError as error:
        reason = "downloading public data sets needs the package pooch, which is not installed"
        raise FileError("pooch", reason, remedy='pip install "pointloom[data]"') from error
    pooch.get_logger().setLevel("WARNING")
    return pooch


def _unpack(archive: Path, folder: Path) -> None:
    """Unpack a ZIP archive; links and names outside the folder raise before anything is written."""
    try:
        with zipfile.ZipFile(archive) as file:
            for member in file.infolist():
                name = member.filename
                parts = PurePosixPath(name.replace("\\", "/"))
                is_link = stat.S_ISLNK(member.external_attr >> 16)
                if parts.is_absolute() or ".." in parts.parts or ":" in name or is_link or "\0" in name:
                    raise FileError(archive, f"contains {name!r}, which is a link or outside of its folder")
            folder.mkdir(parents=True, exist_ok=True)
            file.extractall(folder)
    except (zipfile.BadZipFile, EOFError, NotImplementedError) as error:
        raise FileError(archive, f"cannot be unpacked: {error}") from error


_OPEN3D = "https://github.com/isl-org/open3d_downloads/releases/download/"
_SCIKIT_IMAGE = "https://gitlab.com/scikit-image/data/-/raw/5c090b56df3988d988ff97928e2ef2d2cbe38e1b/"

_STANFORD = "Stanford Computer Graphics Laboratory: free for research, cite; no commercial use without permission"
_REDWOOD = "Redwood, CC BY 3.0 according to Open3D's documentation"
_SCENES = "not stated by its host; ask its authors (qianyi.info/scenedata.html) before any use other than research"
_CHOI = "Choi, Zhou and Koltun, Robust Reconstruction of Indoor Scenes, CVPR 2015"
_ZHOU = "Zhou and Koltun, Dense Scene Reconstruction with Points of Interest, SIGGRAPH 2013"


@dataclasses.dataclass(frozen=True)
class PublicFile:
    """A file of a public set.

    Attributes:
        url: Address at its host.
        checksum: "sha256:..." or "md5:...", as published.
        unpack: Subfolder where a ZIP archive is unpacked ("" for the set's folder). None for a plain file.
    """

    url: str
    checksum: str
    unpack: str | None = None

    @property
    def name(self) -> str:
        return self.url.rpartition("/")[2]


@dataclasses.dataclass(frozen=True)
class PublicSet:
    """A public data set.

    Attributes:
        name: Its name for `fetch`.
        contents: Description.
        license: License terms, as far as stated.
        citation: What to cite.
        files: Its files.
    """

    name: str
    contents: str
    license: str
    citation: str
    files: tuple[PublicFile, ...]

    def __str__(self) -> str:
        return f"{self.name}: {self.contents}\n  license: {self.license}\n  cite: {self.citation}"


def _open3d(path: str, md5: str, unpack: str | None = None) -> PublicFile:
    return PublicFile(_OPEN3D + path, f"md5:{md5}", unpack)


def _scikit_image(name: str, sha256: str) -> PublicFile:
    return PublicFile(_SCIKIT_IMAGE + name, f"sha256:{sha256}")


_SETS = (
    PublicSet(
        "armadillo",
        "the Stanford armadillo, a mesh (PLY)",
        _STANFORD,
        "Krishnamurthy and Levoy, Fitting Smooth Surfaces to Dense Polygon Meshes, SIGGRAPH 1996",
        (_open3d("20220201-data/ArmadilloMesh.ply", "9e68ff1b1cc914ed88cd84f6a8235021"),),
    ),
    PublicSet(
        "bunny",
        "the Stanford bunny, a mesh (PLY)",
        _STANFORD,
        "Turk and Levoy, Zippered Polygon Meshes from Range Images, SIGGRAPH 1994",
        (_open3d("20220201-data/BunnyMesh.ply", "568f871d1a221ba6627569f1e6f9a3f2"),),
    ),
    PublicSet(
        "icp-clouds",
        "three clouds of a living room (PCD, meters) and rough transformations between them (init.log)",
        _REDWOOD,
        _CHOI,
        (_open3d("20220301-data/DemoICPPointClouds.zip", "596cffe5f9c587045e7397ad70754de9", ""),),
    ),
    PublicSet(
        "indoor-fragment",
        "a part of a living room, 113,662 points with colors and normals (PCD, meters)",
        _REDWOOD,
        _CHOI,
        (
            PublicFile(
                _OPEN3D + "20220201-data/fragment.pcd",
                "sha256:24ae338fca9f1b1e1e22a87077ee7c5f4f1e2681e2e014a927960b3761de3aa2",
            ),
        ),
    ),
    PublicSet(
        "living-room",
        "2,870 RGB-D frames of a synthetic living room (color/, depth/ in millimeters), true trajectory and true cloud",
        _REDWOOD,
        _CHOI,
        (
            _open3d("augmented-icl-nuim/livingroom1-color.zip", "c23481094ca3859b204d2fcbb4e435a4", "color"),
            _open3d("augmented-icl-nuim/livingroom1-depth-clean.zip", "6867ddac0e7aafe828a218b385f61985", "depth"),
            _open3d("augmented-icl-nuim/livingroom1-traj.txt", "601ac4b51aba2455a90aed8aa1158c6a"),
            _open3d("augmented-icl-nuim/livingroom.ply.zip", "841f32ff6294bb52d5f9574834e0925e", ""),
        ),
    ),
    PublicSet(
        "living-room-fragments",
        "57 clouds of the living room, each of 50 frames (PLY, meters)",
        _REDWOOD,
        _CHOI,
        (_open3d("redwood/livingroom1-fragments-ply.zip", "36e0eb23a66ccad6af52c05f8390d33e", ""),),
    ),
    PublicSet(
        "lounge",
        "3,000 RGB-D frames of a lounge (color/, depth/ in millimeters), a trajectory and a mesh made of them",
        _SCENES,
        _ZHOU,
        (_open3d("20220301-data/LoungeRGBDImages.zip", "cdd307caef898519a8829ce1b6ab9f75", ""),),
    ),
    PublicSet(
        "redwood-frames",
        "five RGB-D frames of the living room (color/, depth/ in millimeters) with their poses",
        _REDWOOD,
        _CHOI,
        (_open3d("20220301-data/SampleRedwoodRGBDImages.zip", "43971c5f690c9cfc52dda8c96a0140ee", ""),),
    ),
    PublicSet(
        "stereo-motorcycle",
        "a rectified stereo pair, 741 x 500 (PNG), and its true disparity (NPZ)",
        "Middlebury College: cite",
        "Scharstein et al., High-Resolution Stereo Datasets with Subpixel-Accurate Ground Truth, GCPR 2014",
        (
            _scikit_image("motorcycle_left.png", "db18e9c4157617403c3537a6ba355dfeafe9a7eabb6b9b94cb33f6525dd49179"),
            _scikit_image("motorcycle_right.png", "5fc913ae870e42a4b662314bc904d1786bcad8e2f0b9b67dba5a229406357797"),
            _scikit_image("motorcycle_disp.npz", "2e49c8cebff3fa20359a0cc6880c82e1c03bbb106da81a177218281bc2f113d7"),
        ),
    ),
    PublicSet(
        "tum-frame",
        "an RGB-D frame of an office desk, depth in 1/5000 m (PNG)",
        "TUM, CC BY 4.0",
        "Sturm et al., A Benchmark for the Evaluation of RGB-D SLAM Systems, IROS 2012",
        (_open3d("20220201-data/SampleTUMRGBDImage.zip", "91758d42b142dbad7b0d90e857ad47a8", ""),),
    ),
)

SETS: dict[str, PublicSet] = {one.name: one for one in _SETS}


def public_sets() -> list[PublicSet]:
    """The data sets of `fetch`. Print one to read its contents, license and citation.

    Example:
        >>> from pointloom.datasets.public.fetching import public_sets
        >>> [one.name for one in public_sets()][:2]
        ['armadillo', 'bunny']
    """
    return list(SETS.values())

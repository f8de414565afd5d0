"""The public sets that can be fetched: addresses, checksums, what is in them, and whose they are.

Each checksum was published by those who host the file: in the registry of scikit-image, and in the library of Open3D,
which has MD5 alone. MD5 tells a file that was damaged on its way; it does not tell one that somebody forged.
"""

from __future__ import annotations

import dataclasses

_OPEN3D = "https://github.com/isl-org/open3d_downloads/releases/download/"
_SCIKIT_IMAGE = "https://gitlab.com/scikit-image/data/-/raw/5c090b56df3988d988ff97928e2ef2d2cbe38e1b/"

_STANFORD = "Stanford Computer Graphics Laboratory: free for research, cite; no commercial use without permission"
_REDWOOD = "Redwood, CC BY 3.0 as Open3D's pages say"
_SCENES = "not stated by its host; ask its authors (qianyi.info/scenedata.html) before anything but research"
_CHOI = "Choi, Zhou and Koltun, Robust Reconstruction of Indoor Scenes, CVPR 2015"
_ZHOU = "Zhou and Koltun, Dense Scene Reconstruction with Points of Interest, SIGGRAPH 2013"


@dataclasses.dataclass(frozen=True)
class PublicFile:
    """A file of a public set.

    Attributes:
        url: Where its host has it.
        checksum: "sha256:..." or "md5:...", as published.
        unpack: Where in the set's folder a ZIP archive is unpacked ("" for the folder itself); None for a plain file.
    """

    url: str
    checksum: str
    unpack: str | None = None

    @property
    def name(self) -> str:
        """Its file name."""
        return self.url.rpartition("/")[2]


@dataclasses.dataclass(frozen=True)
class PublicSet:
    """A public set.

    Attributes:
        name: By which `fetch` knows it.
        contents: What it is.
        licence: Under which terms, as far as they are stated.
        citation: What to cite.
        files: Its files.
    """

    name: str
    contents: str
    licence: str
    citation: str
    files: tuple[PublicFile, ...]

    def __str__(self) -> str:
        return f"{self.name}: {self.contents}\n  licence: {self.licence}\n  cite: {self.citation}"


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
        "three clouds of a living room (PCD, metres) and rough transformations between them (init.log)",
        _REDWOOD,
        _CHOI,
        (_open3d("20220301-data/DemoICPPointClouds.zip", "596cffe5f9c587045e7397ad70754de9", ""),),
    ),
    PublicSet(
        "indoor-fragment",
        "a part of a living room, 113,662 points with colours and normals (PCD, metres)",
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
        "2,870 RGB-D frames of a made living room (color/, depth/ in millimetres), their true path and the true cloud",
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
        "57 clouds of the living room, each of 50 frames (PLY, metres)",
        _REDWOOD,
        _CHOI,
        (_open3d("redwood/livingroom1-fragments-ply.zip", "36e0eb23a66ccad6af52c05f8390d33e", ""),),
    ),
    PublicSet(
        "lounge",
        "3,000 RGB-D frames of a lounge (color/, depth/ in millimetres), a path and a mesh made of them",
        _SCENES,
        _ZHOU,
        (_open3d("20220301-data/LoungeRGBDImages.zip", "cdd307caef898519a8829ce1b6ab9f75", ""),),
    ),
    PublicSet(
        "redwood-frames",
        "five RGB-D frames of the living room (color/, depth/ in millimetres) with their poses",
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
    """The public sets that `fetch` knows; print one to read what it is, its licence and what to cite.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.data.public.sets import public_sets
        >>> [one.name for one in public_sets()][:2]
        ['armadillo', 'bunny']
    """
    return list(SETS.values())

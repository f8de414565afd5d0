"""Entries of the tables of file formats. Nothing expensive is imported here, so that `--help` stays fast.

Help texts, completion, pipes, error messages, docs/files.md and the fuzz cases are derived from the tables:
io/points/formats.py (clouds), io/meshes/mesh_formats.py, io/splats/splat_files.py, io/images/image_formats.py,
cameras/trajectory_formats.py, core/paths.py (recordings of robots) and visualization/recording/extensions.py.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal, NamedTuple

#: Encoding of written files: one of the two, or the choice of the caller (`ascii`).
Encoding = Literal["text", "binary", "either"]


class CloudCodec(NamedTuple):
    """Reader and writer of a format of clouds.

    Attributes:
        read: Called with the path. Raises only `FileError` for invalid content.
        write: Called with path, table and `WriteOptions`. None if clouds are not written in this format.
        name_rules: The allowed attribute names of a table. None: all, or those of `storable`.
        storable: Removes what the format cannot store. Returns a table and the names of the removed arrays. None: the
            format stores everything.
        read_columns: Reads a file whose columns are named. None: `read`, with the names.
    """

    read: Callable[..., Any]
    write: Callable[..., None] | None = None
    name_rules: Callable[..., Any] | None = None
    storable: Callable[..., tuple[Any, list[str]]] | None = None
    read_columns: Callable[..., Any] | None = None


class MeshCodec(NamedTuple):
    """Reader and writer of a format of meshes.

    Attributes:
        read: Called with the path, and `outside_files` if the format names files. Raises only `FileError` for invalid
            content.
        write: Called with path, mesh and `overwrite`, and `ascii` if the encoding is "either".
        storable: Removes what the format cannot store. Returns a mesh and the names of the removed parts. None: the
            format stores everything.
    """

    read: Callable[..., Any]
    write: Callable[..., None]
    storable: Callable[..., tuple[Any, list[str]]] | None = None


@dataclass(frozen=True)
class CloudFormat:
    """A format of clouds.

    Attributes:
        name: Name in messages.
        load: Imports the module of the format and returns its reader and writer.
        stores: The arrays that the format can store: "normals", "colors", "labels" (integer attributes of any name).
        is_written: False if clouds are only read.
        encoding: Text, binary, or either.
        has_named_columns: True if the reader accepts the names of all columns.
        has_scans: True if a file can contain several scans with poses.
        stores_viewpoint: True if the format has a field for the viewpoint.
        stores_crs: True if the format stores the coordinate system.
        has_8_bit_colors: True if colors are rounded to 8 bits.
        may_be_other: True for files that often are notes, times or poses, which are not used among other scans.
    """

    name: str
    load: Callable[[], CloudCodec]
    stores: tuple[str, ...] = ("normals", "colors", "labels")
    is_written: bool = True
    encoding: Encoding = "binary"
    has_named_columns: bool = False
    has_scans: bool = False
    stores_viewpoint: bool = False
    stores_crs: bool = False
    has_8_bit_colors: bool = False
    may_be_other: bool = False

    @cached_property
    def codec(self) -> CloudCodec:
        return self.load()


@dataclass(frozen=True)
class MeshFormat:
    """A format of meshes.

    Attributes:
        name: Name in messages.
        load: Imports the module of the format and returns its reader and writer.
        stores: What the format stores besides vertices and triangles: "colors" (of vertices), "textures".
        encoding: Text, binary, or either.
        names_files: True if files of this format name textures or other files.
        is_upright: True if the format defines the up axis, y, and the unit, meters.
        stores_reference: True if the format stores unit and coordinate system.
    """

    name: str
    load: Callable[[], MeshCodec]
    stores: tuple[str, ...] = ()
    encoding: Encoding = "binary"
    names_files: bool = False
    is_upright: bool = False
    stores_reference: bool = False

    @cached_property
    def codec(self) -> MeshCodec:
        return self.load()


def listed(extensions: Any, last: str = "or") -> str:
    """Extensions in a sentence: ".ply, .obj or .stl"."""
    *others, end = extensions
    return f"{', '.join(others)} {last} {end}" if others else end

"""Formats of meshes by extension. Readers and writers are imported when they are used, so that `--help` stays fast."""

from __future__ import annotations

from ..file_formats import MeshCodec, MeshFormat
from ..points.formats import CLOUD_FORMATS


def _ply() -> MeshCodec:
    from . import ply_mesh

    return MeshCodec(ply_mesh.read_ply, ply_mesh.write_ply)


def _obj() -> MeshCodec:
    from . import obj

    return MeshCodec(obj.read_obj, obj.write_obj, obj.storable_in_obj)


def _stl() -> MeshCodec:
    from . import stl

    return MeshCodec(stl.read_stl, stl.write_stl, stl.storable_in_stl)


def _off() -> MeshCodec:
    from . import off

    return MeshCodec(off.read_off, off.write_off, off.storable_in_off)


def _vtk() -> MeshCodec:
    from . import vtk_mesh

    return MeshCodec(vtk_mesh.read_vtk_mesh, vtk_mesh.write_vtk_mesh, vtk_mesh.storable_in_vtk)


def _glb() -> MeshCodec:
    from ..points.header_units import is_metric
    from . import glb, glb_writer

    return MeshCodec(is_metric(glb.read_glb), glb_writer.write_glb, glb_writer.storable_in_gltf)


def _gltf() -> MeshCodec:
    from . import glb_writer

    return _glb()._replace(write=glb_writer.write_gltf)


_ALL = ("colors", "textures")

MESH_FORMATS = {
    ".ply": MeshFormat("PLY", _ply, _ALL, encoding="either", names_files=True, stores_reference=True),
    ".obj": MeshFormat("OBJ", _obj, _ALL, encoding="text", names_files=True),
    ".stl": MeshFormat("STL", _stl),
    ".off": MeshFormat("OFF", _off, ("colors",), encoding="text"),
    ".vtk": MeshFormat("VTK", _vtk, ("colors",), encoding="either", stores_reference=True),
    ".vtp": MeshFormat("VTP", _vtk, ("colors",), stores_reference=True),
    ".glb": MeshFormat("GLB", _glb, _ALL, names_files=True, is_upright=True),
    ".gltf": MeshFormat("glTF", _gltf, _ALL, encoding="text", names_files=True, is_upright=True),
}

#: Formats with a defined up axis.
UPRIGHT = tuple(extension for extension, format in MESH_FORMATS.items() if format.is_upright)
UPS = ("y", "z")

#: Formats of clouds and meshes that are written as text or binary.
WITH_TEXT_FORM = tuple(
    dict.fromkeys(
        extension
        for extension, format in (*CLOUD_FORMATS.items(), *MESH_FORMATS.items())
        if format.encoding == "either"
    )
)


def storing(part: str) -> tuple[str, ...]:
    """The extensions of formats that store a part, see `MeshFormat.stores`."""
    return tuple(extension for extension, format in MESH_FORMATS.items() if part in format.stores)

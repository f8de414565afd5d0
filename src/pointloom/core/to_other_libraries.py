"""Make clouds and meshes of trimesh, PyVista and meshio. The libraries are imported when they are used."""

from __future__ import annotations

import importlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .other_geometry import CRS, MAX_BYTE, UNIT, OtherGeometry
from .units import text_of

NORMALS, COLORS, UVS = "Normals", "RGB", "Texture Coordinates"  # names of VTK's arrays per point


def import_library(name: str) -> Any:
    """An optional package. Raises `ImportError` with the command that installs it."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise ImportError(f"the package {name} is required: pip install {name}") from error


def to_trimesh(given: OtherGeometry) -> Any:
    """A `trimesh.Trimesh`, or a `trimesh.PointCloud` if there are no faces. Texture coordinates are per point."""
    trimesh = import_library("trimesh")
    attributes, uvs = dict(given.attributes), given.attributes.get(UVS)
    colors = None if given.colors is None else _with_alpha(given.colors, attributes)
    metadata: dict[str, Any] = _reference_of(given)
    if given.corners is None:
        given.left_out += [*(["normals"] if given.normals is not None else []), *attributes]
        given.warn()
        return trimesh.PointCloud(given.points, colors=colors, metadata=metadata)
    attributes.pop(UVS, None)
    face_attributes = dict(given.face_attributes)
    face_colors = face_attributes.pop("colors", None) if colors is None and uvs is None else None
    visual = _trimesh_texture(given, trimesh, uvs) if uvs is not None else None
    given.warn()
    return trimesh.Trimesh(
        given.points,
        given.corners.reshape(-1, 3),
        vertex_normals=given.normals,
        vertex_colors=colors if visual is None else None,
        face_colors=None if face_colors is None else colors_as_bytes(face_colors),
        vertex_attributes=attributes if visual is None or colors is None else {**attributes, "colors": colors},
        face_attributes=face_attributes,
        visual=visual,
        metadata=metadata,
        process=False,
        validate=False,
    )


def _trimesh_texture(given: OtherGeometry, library: object, uvs: NDArray[Any]) -> Any:
    trimesh: Any = library
    if len(given.textures) != 1:
        given.left_out += ["textures"] if given.textures else []
        return trimesh.visual.TextureVisuals(uv=uvs)
    image = import_library("PIL.Image").fromarray(given.textures[0])
    return trimesh.visual.TextureVisuals(uv=uvs, image=image)


def to_pyvista(given: OtherGeometry) -> Any:
    """A `pyvista.PolyData` with faces, or with a vertex per point if there are none."""
    pyvista = import_library("pyvista")
    if given.corners is None:
        shape = pyvista.PolyData(given.points)
    else:
        rows = given.corners.reshape(-1, 3)
        faces = np.column_stack([np.full(len(rows), 3, np.int64), rows]).reshape(-1)
        shape = pyvista.PolyData(given.points, faces) if len(rows) else pyvista.PolyData(given.points)
    for name, values in _named(given).items():
        shape.point_data[name] = values
    for name, values in _face_values(given).items():
        shape.cell_data[name] = values
    if given.normals is not None:
        shape.point_data.active_normals_name = NORMALS
    if UVS in given.attributes:
        shape.point_data.active_texture_coordinates_name = UVS
    for name, text in _reference_of(given).items():
        shape.field_data[name] = [text]
    given.left_out += ["textures (pass pyvista.Texture(image) to the plotter)"] if given.textures else []
    given.warn()
    return shape


def to_meshio(given: OtherGeometry) -> Any:
    """A `meshio.Mesh` of triangles, or of vertices if there are none."""
    meshio = import_library("meshio")
    if given.corners is None:
        cells = [("vertex", np.arange(len(given.points)).reshape(-1, 1))]
    else:
        cells = [("triangle", given.corners.reshape(-1, 3))]
    given.left_out += ["textures"] if given.textures else []
    given.warn()
    of_cells = {name: [values] for name, values in _face_values(given).items()}
    info = _reference_of(given) or None
    return meshio.Mesh(given.points, cells, point_data=_named(given), cell_data=of_cells, info=info)


def _named(given: OtherGeometry) -> dict[str, NDArray[Any]]:
    """All arrays per point under VTK's names."""
    attributes = dict(given.attributes)
    named = {} if given.normals is None else {NORMALS: given.normals}
    if given.colors is not None:
        named[COLORS] = _with_alpha(given.colors, attributes)
    return named | attributes


def _face_values(given: OtherGeometry) -> dict[str, NDArray[Any]]:
    """Arrays per face under VTK's names."""
    named = dict(given.face_attributes)
    colors = named.pop("colors", None)
    return named if colors is None else {COLORS: colors_as_bytes(colors), **named}


def colors_as_bytes(colors: NDArray[Any]) -> NDArray[np.uint8]:
    """Colors in 0..1 as uint8, rounded. Colors outside are clamped."""
    return np.rint(np.clip(np.nan_to_num(colors), 0, 1) * MAX_BYTE).astype(np.uint8)


def _with_alpha(colors: NDArray[Any], attributes: dict[str, NDArray[Any]]) -> NDArray[np.uint8]:
    """Colors as uint8, with the attribute "alpha" of 8 bits, which is removed, as the fourth column."""
    alpha = attributes.get("alpha")
    if alpha is None or alpha.dtype != np.uint8 or alpha.ndim != 1:
        return colors_as_bytes(colors)
    return np.column_stack([colors_as_bytes(colors), attributes.pop("alpha")])


def _reference_of(given: OtherGeometry) -> dict[str, str]:
    """The unit and the coordinate system as texts."""
    texts = {} if given.unit is None else {UNIT: text_of(given.unit)}
    return texts if given.crs is None else texts | {CRS: given.crs.text}

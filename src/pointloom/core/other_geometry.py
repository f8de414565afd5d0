"""Clouds and meshes of trimesh, Open3D, PyVista, VTK and meshio as NumPy arrays.

An object is found by the names of its class and its attributes, so nothing is imported. Arrays are views where the
library allows. What pointloom cannot store is listed in `left_out`, from which one warning is made.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .coordinate_systems import CoordinateSystem, check_crs
from .units import LengthUnit, unit_by_name, unit_of_text, warn_of_units

UNIT, CRS = "unit", "crs"  # keys of metadata that `to_trimesh`, `to_pyvista` and `to_meshio` write
MAX_BYTE, MAX_SHORT = 255, 65535  # largest values of colors in 8 and 16 bits
MAX_UNIT_COLOR = 2.0  # largest float color of the range 0..1, as in the readers of files (io/columns.py)
COLOR_ROUNDING = 1e-3  # excess over 1 that is rounding, as in `check_colors`

# Names of arrays, in lower case, that are normals and colors. A tuple is one array per component.
_NORMALS: tuple[Any, ...] = ("normals", "obj:vn", "vertex_normals", ("nx", "ny", "nz"))
_COLORS: tuple[Any, ...] = ("rgb", "rgba", "colors", "color", "vertex_colors", ("red", "green", "blue"))
_UVS = ("obj:vt", "texture coordinates", "tcoords", "texture_coordinates")
_TAKEN = ("points", "normals", "colors", "vertices")  # names that no attribute can have

# Metadata that trimesh derives from a shape or a file and writes by itself.
_DERIVED = {"shape", "extents", "transform", "radius", "height", "file_path", "file_name", "processed", "name", "node"}
_MAPS = ("normalTexture", "emissiveTexture", "occlusionTexture", "metallicRoughnessTexture")


@dataclass
class OtherGeometry:
    """A cloud or a mesh of another library.

    Attributes:
        source: Package and class, for messages.
        points: Positions (n, 3).
        normals, colors: Per point, or None. Colors in 0..1.
        attributes: Other values per point.
        corners: Point indices of all faces in order. None: a cloud.
        lengths: Corners of each face. None: three.
        face_attributes: Values per face. "colors" in 0..1.
        uvs: Texture coordinates, a row per corner.
        material_ids: Texture index of each face.
        textures: Images, uint8, top row first.
        device: Device of the arrays, if it is a GPU.
        left_out: Names of parts that pointloom does not store.
    """

    source: str
    points: NDArray[Any]
    normals: NDArray[Any] | None = None
    colors: NDArray[Any] | None = None
    attributes: dict[str, NDArray[Any]] = field(default_factory=dict)
    corners: NDArray[Any] | None = None
    lengths: NDArray[Any] | None = None
    face_attributes: dict[str, NDArray[Any]] = field(default_factory=dict)
    uvs: NDArray[Any] | None = None
    material_ids: NDArray[Any] | None = None
    textures: list[NDArray[np.uint8]] = field(default_factory=list)
    unit: LengthUnit | None = None
    crs: CoordinateSystem | None = None
    device: str | None = None
    left_out: list[str] = field(default_factory=list)

    @property
    def face_count(self) -> int:
        if self.corners is None:
            return 0
        return len(self.corners) // 3 if self.lengths is None else len(self.lengths)

    def warn(self) -> None:
        """Warn of everything that is left out."""
        if self.left_out:
            warn_of_units(f"{self.source}: left out: {', '.join(dict.fromkeys(self.left_out))}", UserWarning)

    def take_points(self, named: Mapping[Any, Any]) -> None:
        """Sort arrays per point into normals, colors, texture coordinates and attributes."""
        rest = self._numeric(named, len(self.points), "")
        self.normals = _pop(rest, _NORMALS, 3)
        self.colors = self.pop_colors(rest)
        uvs = _pop(rest, _UVS, 2)
        if uvs is not None and self.corners is not None:
            self.uvs = uvs[self.corners]
        elif uvs is not None:
            self.left_out.append("texture coordinates")
        self.attributes |= self._free(rest, "")

    def take_faces(self, named: Mapping[Any, Any]) -> None:
        """Sort arrays per face into colors and attributes. Normals are dropped, since they follow from the corners."""
        rest = self._numeric(named, self.face_count, "face ")
        _pop(rest, _NORMALS, 3)
        colors = self.pop_colors(rest)
        self.face_attributes |= ({} if colors is None else {"colors": colors}) | self._free(rest, "face ")

    def take_metadata(self, given: Mapping[Any, Any], known: set[str] | None = None) -> None:
        """Read the unit and the coordinate system. List all other keys, except the known ones, as left out."""
        for key, value in given.items():
            text = _text(value)
            if key == UNIT and text is not None and (unit := unit_of_text(text) or unit_by_name(text)):
                self.unit = unit
            elif key == CRS and text is not None and (crs := _crs_of(text)):
                self.crs = crs
            elif key not in (known or ()):
                self.left_out.append(f"metadata {key!r}")

    def scaled_colors(self, colors: NDArray[Any]) -> NDArray[Any] | None:
        """Colors in 0..1. Integers are 0..255, or 0..65535 in uint16. Floats are 0..255 if one is above 2, else 0..1.

        Floats between 1 and 2 are clamped, which is listed. Colors that fit no range are left out: None.
        """
        low, top = float(colors.min(initial=0)), float(colors.max(initial=0))
        is_integer, is_short = colors.dtype.kind in "iu", colors.dtype == np.uint16
        full = MAX_SHORT if is_short else MAX_BYTE if is_integer or top > MAX_UNIT_COLOR else 1
        if not (low >= 0 and top <= max(full, MAX_UNIT_COLOR)):  # also NaN
            self.left_out.append("colors (not in 0..1 or 0..255)")
            return None
        if not is_integer and full == 1:
            if top > 1 + COLOR_ROUNDING:
                self.left_out.append("colors above 1 (clamped)")
            return np.minimum(colors, 1) if top > 1 else colors
        return colors.astype(np.float32) / np.float32(full)

    def _numeric(self, named: Mapping[Any, Any], count: int, of: str) -> dict[str, NDArray[Any]]:
        """Numeric arrays with a row per element, of at most two axes."""
        kept: dict[str, NDArray[Any]] = {}
        for name, values in named.items():
            array = np.asarray(values)
            is_numeric = array.dtype.kind in "biuf" and array.dtype.itemsize <= 8
            if isinstance(name, str) and name and is_numeric and array.ndim and len(array) == count:
                kept[name] = array if array.ndim < 3 else array.reshape(count, -1)
            else:
                self.left_out.append(f"{of}{name}")
        return kept

    def pop_colors(self, rest: dict[str, NDArray[Any]]) -> NDArray[Any] | None:
        """Colors of three columns. A fourth one is the attribute "alpha", unless it is opaque."""
        found = _pop(rest, _COLORS, 3, 4)
        if found is None:
            return None
        alpha = found[:, 3] if found.shape[1] == 4 else None
        if alpha is not None and len(alpha) and not (alpha == (MAX_BYTE if alpha.dtype.kind in "iu" else 1)).all():
            rest.setdefault("alpha", np.ascontiguousarray(alpha))
        return self.scaled_colors(np.ascontiguousarray(found[:, :3]))

    def _free(self, rest: dict[str, NDArray[Any]], of: str) -> dict[str, NDArray[Any]]:
        """Attributes, without those whose name has another meaning here."""
        taken = () if of else _TAKEN
        self.left_out += [f"{of}{name}" for name in rest if name in taken]
        return {name: values for name, values in rest.items() if name not in taken}


def read_other(given: object) -> OtherGeometry | None:
    """The arrays of an object of another library. None for other objects, such as arrays."""
    if isinstance(given, OtherGeometry):
        return given
    reader = _reader_of(given)
    return None if reader is None else reader(given)


def read_or_refuse(name: str, given: object, expected: str = "") -> OtherGeometry | None:
    """`read_other`. Raises `TypeError` with a conversion for other objects that have points, but are no array.

    `expected` is "cloud" or "mesh" if only that is accepted.
    """
    other = read_other(given)
    if other is None and not hasattr(given, "__array__") and (remedy := conversion_of(given, expected=expected)):
        accepted = f"an array or a {expected}" if expected else "an array, a cloud or a mesh"
        raise TypeError(f"{name}: expected {accepted}, got {name_of(given)}{remedy}")
    return other


def is_other(given: object) -> bool:
    """True for objects that `read_other` reads."""
    return _reader_of(given) is not None


def name_of(given: object) -> str:
    """Package and class of an object, as `trimesh.Trimesh`."""
    package = type(given).__module__.partition(".")[0]
    return type(given).__name__ if package in ("builtins", "__main__") else f"{package}.{type(given).__name__}"


def conversion_of(given: object, name: str = "x", *, expected: str = "") -> str:
    """How to make an object of pointloom from another object, as the end of a message, or "".

    `expected` is "cloud" or "mesh" if only that is accepted.
    """
    if is_other(given):
        own = f"loom.from_any({name})"
        is_cloud = expected == "mesh" and hasattr(given, "estimate_normals")
        return f". Use loom.meshing.create_surface({own})" if is_cloud else f". Convert it with {own}"
    for vertices, faces in (("vertices", "faces"), ("vertices", "triangles"), ("verts_packed", "faces_packed")):
        if hasattr(given, vertices) and hasattr(given, faces):
            call = "()" if vertices.endswith("packed") else ""
            mesh = f"loom.TriangleMesh({name}.{vertices}{call}, {name}.{faces}{call})"
            if expected != "cloud":
                return f". Use {mesh}"
            is_own = hasattr(given, "sample_points_uniformly")
            second = f"{name}.sample_points_uniformly(100_000) for its surface" if is_own else f"{mesh} for a mesh"
            return f". Use loom.PointCloud({name}.{vertices}{call}) for its vertices, or {second}"
    if hasattr(given, "extract_surface"):
        return f". Use loom.from_any({name}.extract_surface())"
    for points in ("points", "vertices", "points_packed"):
        if hasattr(given, points):
            array = f"{name}.{points}{'()' if points.endswith('packed') else ''}"
            cloud = name if hasattr(given, "estimate_normals") else f"loom.PointCloud({array})"
            if expected == "mesh":
                surface = f"loom.meshing.create_surface({cloud}) for a surface through its points"
                return f". Use {surface}, or loom.TriangleMesh({array}, triangles) for known triangles"
            return f". Use {cloud}"
    return ""


def _reader_of(given: object) -> Callable[[object], OtherGeometry] | None:
    if isinstance(given, np.ndarray | list | tuple | str | type):
        return None
    for kind in type(given).__mro__:
        if kind.__module__.startswith("pointloom.") and not kind.__module__.startswith("pointloom.open3d."):
            return None
        name = "vtkPolyData" if kind.__module__.startswith("vtkmodules.") else kind.__name__  # also named PolyData
        for attributes, reader in _READERS.get(name, ()):
            if all(hasattr(given, attribute) for attribute in attributes):
                return reader
    return None


def _pop(rest: dict[str, NDArray[Any]], names: tuple[Any, ...], *widths: int) -> NDArray[Any] | None:
    """The first array with one of these names and one of these widths, which is removed. None if there is none."""
    lower = {name.lower(): name for name in rest}
    for name in names:
        if isinstance(name, tuple):
            parts = [rest[lower[part]] for part in name if part in lower]
            if len(parts) == len(name) and all(part.ndim == 1 for part in parts):
                for part in name:
                    del rest[lower[part]]
                return np.stack(parts, axis=1)
        elif name in lower and rest[lower[name]].ndim == 2 and rest[lower[name]].shape[1] in widths:
            return rest.pop(lower[name])
    return None


def _text(value: object) -> str | None:
    """A text, also as the only element of an array."""
    if isinstance(value, str):
        return value
    array = np.asarray(value)
    return str(array.reshape(-1)[0]) if array.dtype.kind == "U" and array.size == 1 else None


def _crs_of(text: str) -> CoordinateSystem | None:
    try:
        return check_crs(CRS, text)
    except ValueError:
        return None


# ------------------------------------------------------------------------------------------------ trimesh


def _trimesh(given: object) -> OtherGeometry:
    mesh: Any = given
    result = OtherGeometry(name_of(mesh), np.asarray(mesh.vertices), corners=np.asarray(mesh.faces).reshape(-1))
    cache = getattr(getattr(mesh, "_cache", None), "cache", {"vertex_normals": None})
    if "vertex_normals" in cache and len(getattr(mesh, "vertex_normals", ())) == len(result.points):
        result.normals = np.asarray(mesh.vertex_normals)  # given or computed before, else trimesh would compute them
    result.take_points(_without_normals(result, getattr(mesh, "vertex_attributes", {})))
    result.take_faces(getattr(mesh, "face_attributes", {}))
    _trimesh_visual(result, getattr(mesh, "visual", None))
    _trimesh_metadata(result, mesh)
    return result


def _without_normals(result: OtherGeometry, named: Mapping[Any, Any]) -> Mapping[Any, Any]:
    """Attributes per vertex, with the normals that were found elsewhere."""
    return named if result.normals is None else {"normals": result.normals, **named}


def _trimesh_cloud(given: object) -> OtherGeometry:
    cloud: Any = given
    result = OtherGeometry(name_of(cloud), np.asarray(cloud.vertices))
    colors = np.asarray(getattr(cloud, "colors", ()))
    attributes = dict(getattr(cloud, "vertex_attributes", {}))
    result.take_points({"colors": colors, **attributes} if len(colors) else attributes)
    _trimesh_metadata(result, cloud)
    return result


def _trimesh_visual(result: OtherGeometry, given: object) -> None:
    """Colors of vertices or faces, or one texture."""
    visual: Any = given
    kind = getattr(visual, "kind", None)
    if kind == "vertex":
        rest = {"colors": np.asarray(visual.vertex_colors)}
        result.colors = result.pop_colors(rest)
        result.attributes |= rest
    elif kind == "face":
        colors = np.asarray(visual.face_colors)
        is_opaque = colors.shape[1] == 3 or (colors[:, 3] == MAX_BYTE).all()
        scaled = result.scaled_colors(colors[:, :3] if is_opaque else colors)
        result.face_attributes |= {} if scaled is None else {"colors": scaled}
    elif kind == "texture" and visual.uv is not None and result.corners is not None:
        result.uvs = np.asarray(visual.uv)[result.corners]
        material = visual.material
        image = getattr(material, "image", None) or getattr(material, "baseColorTexture", None)
        if image is None:
            result.left_out.append("the color of the material")
        else:
            mode = "RGBA" if "A" in image.getbands() else "RGB"
            result.textures = [np.asarray(image.convert(mode))]
        result.left_out += [name for name in _MAPS if getattr(material, name, None) is not None]


def _trimesh_metadata(result: OtherGeometry, given: object) -> None:
    shape: Any = given
    metadata = dict(getattr(shape, "metadata", {}))
    units = metadata.pop("units", getattr(shape, "units", None))
    result.take_metadata(metadata, _DERIVED)
    if units is not None and result.unit is None:
        result.take_metadata({UNIT: str(units).removesuffix("s") if unit_by_name(str(units)) is None else str(units)})


# ------------------------------------------------------------------------------------------------ Open3D


def _open3d_cloud(given: object) -> OtherGeometry:
    cloud: Any = given
    result = OtherGeometry(name_of(cloud), np.asarray(cloud.points))
    names = ("normals", "colors", "covariances")
    named = {name: np.asarray(getattr(cloud, name)) for name in names if len(getattr(cloud, name, ()))}
    result.take_points(named)
    return result


def _open3d_mesh(given: object) -> OtherGeometry:
    mesh: Any = given
    corners = np.asarray(mesh.triangles).reshape(-1)
    result = OtherGeometry(name_of(mesh), np.asarray(mesh.vertices), corners=corners)
    names = ("vertex_normals", "vertex_colors")
    result.take_points({name: np.asarray(getattr(mesh, name)) for name in names if len(getattr(mesh, name, ()))})
    uvs, ids = (np.asarray(getattr(mesh, name, ())) for name in ("triangle_uvs", "triangle_material_ids"))
    if len(uvs):
        images = [np.asarray(image) for image in getattr(mesh, "textures", ())]
        stored = [k for k, image in enumerate(images) if image.ndim == 3 and image.size]
        result.uvs = uvs
        result.textures = [np.flipud(images[k]) for k in stored]  # Open3D has the lowest row first
        numbers = np.full(max(len(images), int(ids.max(initial=0)) + 1), len(stored), np.int32)  # no texture
        numbers[stored] = np.arange(len(stored))
        if len(ids) and (len(stored) > 1 or (numbers[ids] != 0).any()):
            result.material_ids = numbers[ids]
    return result


def _open3d_tensor_cloud(given: object) -> OtherGeometry:
    cloud: Any = given
    named = _tensors(cloud.point)
    result = OtherGeometry(name_of(cloud), named.pop("positions", np.empty((0, 3), np.float32)))
    result.device = _open3d_device(cloud)
    result.take_points(named)
    return result


def _open3d_tensor_mesh(given: object) -> OtherGeometry:
    mesh: Any = given
    vertex, triangle = _tensors(mesh.vertex), _tensors(mesh.triangle)
    corners = triangle.pop("indices", np.empty((0, 3), np.int64)).reshape(-1)
    points = vertex.pop("positions", np.empty((0, 3), np.float32))
    result = OtherGeometry(name_of(mesh), points, corners=corners, device=_open3d_device(mesh))
    result.take_points(vertex)
    if (uvs := triangle.pop("texture_uvs", None)) is not None:
        result.uvs = uvs.reshape(-1, 2)
    if (ids := triangle.pop("material_ids", None)) is not None:
        result.material_ids = ids.reshape(-1)
    result.take_faces(triangle)
    if getattr(mesh, "has_valid_material", bool)():
        maps = mesh.material.texture_maps
        for name in maps:
            if name == "albedo" and result.uvs is not None:
                result.textures = [_tensors({name: maps[name].as_tensor()})[name]]
            else:
                result.left_out.append(f"texture map {name}")
    return result


def _tensors(given: object) -> dict[str, NDArray[Any]]:
    """Tensors by name on the host."""
    tensors: Any = given
    return {name: tensors[name].cpu().numpy() for name in tensors}


def _open3d_device(given: object) -> str | None:
    shape: Any = given
    device = getattr(shape, "device", None)
    is_cuda = str(device).upper().startswith("CUDA")
    return f"cuda:{str(device).partition(':')[2]}" if is_cuda else None


# ------------------------------------------------------------------------------------------------ PyVista, VTK, meshio


def _pyvista(given: object) -> OtherGeometry:
    shape: Any = given
    points = np.asarray(shape.points)
    lengths, corners = _vtk_faces(np.asarray(getattr(shape, "faces", ())))
    strips = np.asarray(getattr(shape, "strips", ()))
    if len(strips):
        raise ValueError(f"{name_of(shape)}: triangle strips are not supported. Use shape.triangulate() first")
    result = OtherGeometry(name_of(shape), points)
    if len(lengths):
        result.corners, result.lengths = corners, lengths
    line_count, vertex_count = (_cell_count(np.asarray(getattr(shape, name, ()))) for name in ("lines", "verts"))
    if line_count:
        result.left_out.append(f"{line_count} lines")
    if line_count and not len(lengths) and not vertex_count:
        raise ValueError(f"{name_of(shape)}: it has lines only. loom.LineSet(points, lines) takes them")
    result.take_points(_under_roles(shape.point_data))
    if len(lengths):
        first = line_count + vertex_count  # VTK orders the cells so
        cells = {name: np.asarray(values)[first:] for name, values in _named(shape.cell_data).items()}
        result.take_faces(cells)
    else:
        result.left_out += [f"cell data {name}" for name in _named(shape.cell_data)]
    result.take_metadata(_named(getattr(shape, "field_data", {})))
    return result


def _under_roles(given: object) -> dict[str, Any]:
    """Arrays per point. The active normals and texture coordinates get their usual names."""
    data: Any = given
    roles = {
        getattr(data, "active_normals_name", None): _NORMALS[0],
        getattr(data, "active_texture_coordinates_name", None): _UVS[1],
    }
    return {roles.get(name, name): values for name, values in _named(data).items()}


def _named(given: object) -> dict[str, Any]:
    """Arrays by name of PyVista, whose active ones can be None."""
    data: Any = given
    return {name: data[name] for name in data.keys()}  # noqa: SIM118


def _cell_count(cells: NDArray[Any]) -> int:
    return len(_vtk_faces(cells)[0])


def _vtk_faces(cells: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
    """Lengths and corners of cells, stored as the length of each followed by its corners."""
    cells = cells.astype(np.int64, copy=False).reshape(-1)
    if len(cells) and cells[0] > 0 and len(cells) % (cells[0] + 1) == 0 and (cells[:: cells[0] + 1] == cells[0]).all():
        rows = cells.reshape(-1, cells[0] + 1)
        return rows[:, 0], rows[:, 1:].reshape(-1)
    starts, at = [], 0
    while at < len(cells):
        if not 0 <= cells[at] < len(cells) - at:
            raise ValueError(f"faces: expected the length of each face before its corners, got {cells[at]}")
        starts.append(at)
        at += int(cells[at]) + 1
    is_corner = np.ones(len(cells), bool)
    is_corner[starts] = False
    return cells[starts], cells[is_corner]


def _vtk(given: object) -> OtherGeometry:
    """A vtkPolyData that PyVista did not make, through VTK's own views of its arrays."""
    to_numpy = importlib.import_module("vtkmodules.util.numpy_support").vtk_to_numpy

    def arrays_of(part: object) -> dict[str, Any]:
        data: Any = part
        arrays = [data.GetAbstractArray(k) for k in range(data.GetNumberOfArrays())]
        return {array.GetName() or f"array {k}": values_of(array) for k, array in enumerate(arrays)}

    def values_of(given: object) -> Any:
        array: Any = given
        is_numeric = hasattr(array, "GetTuple")
        return (
            to_numpy(array) if is_numeric else np.array([array.GetValue(k) for k in range(array.GetNumberOfValues())])
        )

    def cells_of(part: object) -> NDArray[Any]:
        cells: Any = part
        if not cells.GetNumberOfCells():
            return np.empty(0, np.int64)
        offsets, corners = to_numpy(cells.GetOffsetsArray()), to_numpy(cells.GetConnectivityArray())
        return np.insert(corners, offsets[:-1], np.diff(offsets))

    data: Any = given
    points = data.GetPoints()
    normals, uvs = data.GetPointData().GetNormals(), data.GetPointData().GetTCoords()
    roles = {
        None if array is None else array.GetName(): name for array, name in ((normals, _NORMALS[0]), (uvs, _UVS[1]))
    }
    named = {roles.get(name, name): values for name, values in arrays_of(data.GetPointData()).items()}
    parts = SimpleNamespace(
        points=np.empty((0, 3), np.float32) if points is None else to_numpy(points.GetData()),
        point_data=named,
        cell_data=arrays_of(data.GetCellData()),
        field_data=arrays_of(data.GetFieldData()),
        verts=cells_of(data.GetVerts()),
        lines=cells_of(data.GetLines()),
        faces=cells_of(data.GetPolys()),
        strips=cells_of(data.GetStrips()),
    )
    result = _pyvista(parts)
    result.source = name_of(given)
    return result


def _meshio(given: object) -> OtherGeometry:
    mesh: Any = given
    result = OtherGeometry(name_of(mesh), np.asarray(mesh.points))
    is_face = [block.type in ("triangle", "quad", "polygon") for block in mesh.cells]
    others = [b.type for b, is_used in zip(mesh.cells, is_face, strict=True) if not is_used and b.type != "vertex"]
    if others and not any(is_face):
        raise ValueError(f"{result.source}: it has {', '.join(dict.fromkeys(others))} cells only, but no triangles")
    result.left_out += [f"{kind} cells" for kind in others]
    faces = [block for block, is_used in zip(mesh.cells, is_face, strict=True) if is_used]
    if faces:
        rows = [np.asarray(row, np.int64).reshape(-1) for block in faces for row in block.data]
        result.corners = np.concatenate([np.empty(0, np.int64), *rows])
        result.lengths = np.array([len(row) for row in rows], np.int64)
    result.take_points(mesh.point_data)
    cells = {name: [np.asarray(values) for values, is_used in zip(blocks, is_face, strict=True) if is_used]
             for name, blocks in mesh.cell_data.items()}  # fmt: skip
    result.take_faces({name: np.concatenate(values) for name, values in cells.items() if values})
    result.left_out += [f"cell data {name}" for name, values in cells.items() if not values]
    for name in ("point_sets", "cell_sets", "field_data"):
        result.left_out += [f"{name} {key!r}" for key in getattr(mesh, name, None) or ()]
    result.take_metadata(getattr(mesh, "info", None) or {})
    return result


# By name of a class: attributes that an object has, and its reader.
_READERS: dict[str, tuple[tuple[tuple[str, ...], Callable[[object], OtherGeometry]], ...]] = {
    "Trimesh": ((("vertices", "faces"), _trimesh),),
    "PointCloud": (
        (("point", "point_normals"), _open3d_tensor_cloud),
        (("point", "to_legacy"), _open3d_tensor_cloud),
        (("points", "colors"), _open3d_cloud),
        (("vertices", "colors"), _trimesh_cloud),
    ),
    "TriangleMesh": ((("vertex", "triangle"), _open3d_tensor_mesh), (("vertices", "triangles"), _open3d_mesh)),
    "PolyData": ((("points", "point_data", "faces"), _pyvista),),
    "PointSet": ((("points", "point_data"), _pyvista),),
    "vtkPolyData": ((("GetPoints", "GetPolys"), _vtk),),
    "Mesh": ((("points", "cells", "point_data"), _meshio),),
}

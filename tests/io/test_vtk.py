"""VTK files: every encoding of VTK's own writers, round trips, rejected files, and files of other libraries."""

import base64
import itertools
import tracemalloc
import zlib
from contextlib import nullcontext

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.io.meshes.tables import is_mesh_file, read_table
from pointloom.io.meshes.vtk_mesh import read_vtk_mesh
from pointloom.io.points.vtk_points import read_vtk_points, write_vtk_points
from pointloom.io.table import PointTable

from .point_tables import assert_same_table, table_of

HEAD = "# vtk DataFile Version 4.2\ntest\nASCII\nDATASET POLYDATA\n"
SQUARE = "POINTS 4 float\n0 0 0 1 0 0 1 1 0 0 1 0\n"
GRID = HEAD.replace("POLYDATA", "UNSTRUCTURED_GRID") + SQUARE + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n{}\n"
NEW, BINARY = HEAD.replace("4.2", "5.1") + SQUARE, HEAD.replace("ASCII", "BINARY")
XML = """<VTKFile type="PolyData" byte_order="LittleEndian"><PolyData><Piece NumberOfPoints="3" NumberOfPolys="1">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0</DataArray></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">3</DataArray></Polys></Piece></PolyData></VTKFile>"""


def write(path, text):
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return path


@pytest.mark.parametrize(("name", "ascii"), [("a.vtk", False), ("a.vtk", True), ("a.vtp", False)])
@pytest.mark.parametrize(("count", "dtype"), [(0, "f4"), (1, "f8"), (500, "f8")])
def test_every_array_survives_a_round_trip_to_the_bit(tmp_path, name, ascii, count, dtype):
    table = table_of(count, dtype, wide=np.arange(3 * count, dtype=np.int64).reshape(-1, 3), long=np.arange(count))
    write_vtk_points(tmp_path / name, table, ascii=ascii)
    assert_same_table(read_vtk_points(tmp_path / name), table)


@pytest.mark.parametrize("name", ["a.vtk", "a.vtp"])
def test_unit_and_coordinate_system_are_kept(tmp_path, name):
    text = 'PROJCS["a long one, über 64 bytes, so that its length has four bytes in binary files ............"]'
    for crs in ("EPSG:25832", text):
        cloud = loom.PointCloud([[4e5, 5e6, 100.0]], unit="US survey foot", crs=crs)
        loom.write_point_cloud(tmp_path / name, cloud)
        back = loom.read_point_cloud(tmp_path / name)
        assert (back.unit, back.crs.text) == (cloud.unit, cloud.crs.text)
        np.testing.assert_array_equal(back.points, cloud.points)


@pytest.mark.parametrize(("name", "ascii"), [("a.vtk", False), ("a.vtk", True), ("a.vtp", False)])
def test_a_mesh_keeps_all_but_its_texture(tmp_path, name, ascii):
    mesh = loom.TriangleMesh.create_sphere(1.0, 4).translate([4e5, 5e6, 100]).compute_vertex_normals()
    rng = np.random.default_rng(0)
    mesh.vertex_colors = rng.integers(0, 256, (len(mesh.vertices), 3), np.uint8)
    mesh.vertex_attributes["heat map"] = rng.random((len(mesh.vertices), 2))
    mesh.triangle_attributes["part"] = np.arange(len(mesh), dtype=np.int16)
    mesh.triangle_attributes["colors"] = rng.integers(0, 256, (len(mesh), 3)).astype(np.float32) / np.float32(255)
    mesh.unit, mesh.crs = "foot", 25832
    loom.write_triangle_mesh(tmp_path / name, mesh, write_ascii=ascii)
    back = loom.read_triangle_mesh(tmp_path / name)
    for key in ("vertices", "triangles", "vertex_normals", "vertex_colors"):
        np.testing.assert_array_equal(getattr(back, key), getattr(mesh, key))
    np.testing.assert_array_equal(back.vertex_attributes["heat map"], mesh.vertex_attributes["heat map"])
    for key in ("part", "colors"):
        np.testing.assert_array_equal(back.triangle_attributes[key], mesh.triangle_attributes[key])
    assert (back.unit, back.crs) == (mesh.unit, mesh.crs)


def test_texture_coordinates_are_kept_and_the_image_is_named(tmp_path):
    uvs = np.random.default_rng(0).random((36, 2)).astype(np.float32)
    box = loom.TriangleMesh.create_box()
    mesh = loom.TriangleMesh(box.vertices, box.triangles, triangle_uvs=uvs, textures=[np.zeros((2, 2, 3), np.uint8)])
    for name in ("a.vtk", "a.vtp"):
        with pytest.warns(UserWarning, match="textures left out"):
            loom.write_triangle_mesh(tmp_path / name, mesh)
        back = loom.read_triangle_mesh(tmp_path / name)
        np.testing.assert_array_equal(back.triangle_uvs, uvs)
        np.testing.assert_array_equal(back.vertices[back.triangles], mesh.vertices[mesh.triangles])


def sphere():
    """A vtkPolyData with normals, texture coordinates, and arrays of points, of cells and of texts."""
    pytest.importorskip("vtkmodules")
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkStringArray
    from vtkmodules.vtkFiltersSources import vtkSphereSource

    source = vtkSphereSource()
    source.SetThetaResolution(30)
    source.SetPhiResolution(30)
    source.Update()
    data = source.GetOutput()
    for part, name, values in (
        (data.GetPointData(), "x y", np.arange(data.GetNumberOfPoints())),
        (data.GetCellData(), "c", np.arange(2.0 * data.GetNumberOfCells()).reshape(-1, 2)),
    ):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        part.AddArray(array)
    uvs = numpy_to_vtk(np.random.default_rng(0).random((data.GetNumberOfPoints(), 2)), deep=True)
    uvs.SetName("uv")
    data.GetPointData().SetTCoords(uvs)
    crs = vtkStringArray()
    crs.SetName("crs")
    crs.InsertNextValue("EPSG:25832")
    data.GetFieldData().AddArray(crs)
    return data


def assert_same_as_vtk(path, reader):
    """Compare a mesh with what VTK reads from the same file."""
    reader.SetFileName(str(path))
    reader.Update()
    expected, mesh = loom.from_any(reader.GetOutput()), loom.read_triangle_mesh(path)
    np.testing.assert_array_equal(mesh.vertices, expected.vertices)
    np.testing.assert_array_equal(mesh.triangles, expected.triangles)
    np.testing.assert_array_equal(mesh.vertex_normals, expected.vertex_normals)
    np.testing.assert_array_equal(mesh.vertex_attributes["x y"], expected.vertex_attributes["x y"])
    np.testing.assert_array_equal(mesh.triangle_attributes["c"], expected.triangle_attributes["c"])
    assert mesh.triangle_uvs is not None
    assert mesh.crs.epsg == 25832


@pytest.mark.parametrize("compressor", ["None", "ZLib", "LZMA"])
@pytest.mark.parametrize("mode", ["Ascii", "Binary", "Appended", "Encoded"])
def test_files_of_vtks_xml_writer_are_read_as_vtk_reads_them(tmp_path, compressor, mode):
    data = sphere()
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

    for header, order in itertools.product(("UInt32", "UInt64"), ("Little", "Big")):
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(str(tmp_path / "a.vtp"))
        writer.SetInputData(data)
        writer.SetBlockSize(3072)
        getattr(writer, f"SetCompressorTypeTo{compressor}")()
        getattr(writer, f"SetDataModeTo{mode.replace('Encoded', 'Appended')}")()
        writer.SetEncodeAppendedData(mode == "Encoded")
        getattr(writer, f"SetHeaderTypeTo{header}")()
        getattr(writer, f"SetByteOrderTo{order}Endian")()
        writer.Write()
        assert_same_as_vtk(tmp_path / "a.vtp", vtkXMLPolyDataReader())


@pytest.mark.parametrize("version", [42, 51])
@pytest.mark.parametrize("kind", [1, 2])
def test_files_of_vtks_legacy_writer_are_read_as_vtk_reads_them(tmp_path, version, kind):
    data = sphere()
    from vtkmodules.vtkIOLegacy import vtkPolyDataReader, vtkPolyDataWriter

    writer = vtkPolyDataWriter()
    writer.SetFileName(str(tmp_path / "a.vtk"))
    writer.SetInputData(data)
    writer.SetFileVersion(version)
    writer.SetFileType(kind)
    writer.Write()
    assert_same_as_vtk(tmp_path / "a.vtk", vtkPolyDataReader())


@pytest.mark.parametrize(("name", "ascii"), [("a.vtk", False), ("a.vtk", True), ("a.vtp", False)])
def test_vtk_reads_our_files(tmp_path, name, ascii):
    pytest.importorskip("vtkmodules")
    from vtkmodules.vtkIOLegacy import vtkPolyDataReader
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

    table = table_of(50, "f8", wide=np.arange(150.0).reshape(-1, 3))
    write_vtk_points(tmp_path / name, table, ascii=ascii)
    reader = vtkXMLPolyDataReader() if name.endswith("vtp") else vtkPolyDataReader()
    reader.SetFileName(str(tmp_path / name))
    reader.Update()
    data = reader.GetOutput()
    assert data.GetNumberOfVerts() == 50
    back = loom.from_any(data)
    np.testing.assert_array_equal(back.points, loom.PointCloud(table.points).points)
    np.testing.assert_array_equal(back.normals, table.normals)
    np.testing.assert_array_equal(back.colors, table.colors)
    np.testing.assert_array_equal(back["wide"], table.attributes["wide"])
    np.testing.assert_array_equal(back["time"], table.attributes["time"])


@pytest.mark.parametrize("format", ["vtk42", "vtk51"])
@pytest.mark.parametrize("binary", [True, False])
def test_grids_of_meshio_are_read(tmp_path, format, binary):
    meshio = pytest.importorskip("meshio")
    points = np.random.default_rng(0).random((7, 3))
    cells = [("triangle", [[0, 1, 2]]), ("quad", [[3, 4, 5, 6]])]
    mesh = meshio.Mesh(points, cells, point_data={"h": np.arange(7.0)}, cell_data={"k": [np.array([1]), np.array([2])]})
    meshio.write(tmp_path / "a.vtk", mesh, file_format=format, binary=binary)
    table = read_vtk_mesh(tmp_path / "a.vtk")
    np.testing.assert_array_equal(table.vertices, points)
    assert table.triangle_attributes["k"].tolist() == [1, 2, 2]
    assert table.attributes["h"].tolist() == [*range(7)]


def test_all_kinds_of_legacy_attributes_are_read(tmp_path):
    text = HEAD + SQUARE + (
        "POLYGONS 1 5\n4 0 1 2 3\nMETADATA\nINFORMATION 0\n\nCELL_DATA 1\nSCALARS k int 1\nLOOKUP_TABLE default\n7\n"
        "POINT_DATA 4\nSCALARS a%20b short\nLOOKUP_TABLE t\n1 2 3 4\nSCALARS pair float 2\n1 2 3 4 5 6 7 8\n"
        "LOOKUP_TABLE t 1\n0 0 0 1\nVECTORS v double\n0 0 0 1 1 1 2 2 2 3 3 3\nNORMALS n float\n"
        "0 0 1 0 0 1 0 0 1 0 0 1\nTEXTURE_COORDINATES uv 2 float\n0 0 1 0 1 1 0 1\n"
        "COLOR_SCALARS c 3\n0 0 0 1 1 1 0.5 0.5 0.5 0 0 1\nFIELD FieldData 1\nwide 2 4 unsigned_char\n0 1 2 3 4 5 6 7\n"
    )  # fmt: skip
    table = read_vtk_mesh(write(tmp_path / "a.vtk", text))
    assert table.triangle_attributes["k"].tolist() == [7, 7]
    assert {name: values.shape for name, values in table.attributes.items()} == {
        "a b": (4,), "pair": (4, 2), "v": (4, 3), "wide": (4, 2),
    }  # fmt: skip
    assert table.vertex_colors[2].tolist() == [0.5, 0.5, 0.5]
    assert table.vertex_normals[0].tolist() == [0, 0, 1]
    assert table.triangle_uvs.shape == (6, 2)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("ply\n", "does not begin with"),
        (HEAD, "no vertices|no faces|contains no"),
        (HEAD.replace("POLYDATA", "STRUCTURED_POINTS"), "STRUCTURED_POINTS is not supported"),
        (HEAD + "POINTS 4 float\n0 0 0 1", "truncated"),
        (HEAD + "POINTS 99999999999 float\n0 0 0 1", "truncated"),
        (HEAD + "POINTS -4 float\n", "expected a count"),
        (HEAD + "POINTS 1 float\n0 zero 0\n", "not a number"),
        (HEAD + "POINTS 1 bit\n0 0 0\n", "not supported"),
        (HEAD + SQUARE + "POLYGONS 1 4\n3 0 1 9\n", "refers to point 9"),
        (HEAD + SQUARE + "POLYGONS 1 4\n2 0 1 9\n", "cells"),
        (HEAD + SQUARE + "POLYGONS 1 3\n2 0 1\n", "fewer than 3 corners"),
        (HEAD + SQUARE + "POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 3\nSCALARS a int\n1 2 3\n", "4 points, got 3"),
        (HEAD + SQUARE + "POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 4\nSCALARS a char\n1 2 3 400\n", "type char"),
        (HEAD + SQUARE + "POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 4\n" + 2 * "SCALARS a int\n1 2 3 4\n", "'a' is duplicated"),
        (HEAD + SQUARE + "POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 4\nFIELD F 1\na 0 4 int\n", "'a' has no columns"),
        (HEAD + SQUARE + "POLYGONS 2 4\n3 0 1 2\n", "the 2 cells do not fit into 4 numbers"),
        (HEAD + SQUARE + "POLYGONS 1 4\n-3 0 1 2\n", "the 1 cells do not fit into 4 numbers"),
        (GRID.format("9"), None),
        (GRID.format("99"), "cells of the type 99 are not supported"),
        (GRID.replace("TYPES 1", "TYPES 2").format("9 9"), "expected the types of 1 cells"),
        (HEAD.split("DATASET")[0], "contains no data set"),
        (HEAD + SQUARE + "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\n", "strips"),
        (HEAD + SQUARE + "POLYGONS 1 4\n3 0 1 2\nNONSENSE\n", "unexpected word"),
        (HEAD + SQUARE + "POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 4\nNONSENSE a int\n", "unexpected word 'NONSENSE'"),
        (HEAD + "POINTS 4", r"byte 63\): is truncated"),
        (HEAD + "POINTS 2 float\n10 20 30 40", "truncated: 6 numbers are expected, but 4 are left"),
        (HEAD + "FIELD f 1\nnote 1 2 string\na\nb", "is truncated in a text"),
        (NEW + "POLYGONS 2 4\nOFFSET int\n0 4\n", "expected OFFSETS, got 'OFFSET'"),
        (NEW + "POLYGONS 2 4\nOFFSETS int\n0 4\nCONNECTIVITY int\n0 1 2 3\n", None),
        (NEW + "POLYGONS 2 4\nOFFSETS int\n1 4\nCONNECTIVITY int\n0 1 2 3\n", "the offsets of the cells are damaged"),
        (NEW + "POLYGONS 2 4\nOFFSETS int\n0 3\nCONNECTIVITY int\n0 1 2 3\n", "the offsets of the cells are damaged"),
        (NEW + "POLYGONS 0 4\nOFFSETS int\n\nCONNECTIVITY int\n0 1 2 3\n", "the offsets of the cells are damaged"),
        (NEW + "POLYGONS 4 6\nOFFSETS int\n0 4 2 6\nCONNECTIVITY int\n0 1 2 3 0 1\n", "the offsets of the cells are"),
        (BINARY + "POINTS 1 float 7\n" + 12 * "0", "expected the end of the line before binary numbers"),
        (BINARY + "POINTS 1 float" + 12 * "0", "type 'float000000000000' is not supported"),
        (BINARY + "POINTS 1 float\n" + 11 * "0", "truncated: 3 numbers need 12 bytes, but 11 are left"),
        (BINARY + "FIELD f 1\nnote 1 1 string\n\x01\x01ab", "is truncated in a text"),
    ],
)
def test_damaged_legacy_files_are_rejected_with_the_reason(tmp_path, text, words):
    with pytest.raises((FileError, ValueError), match=words) if words else nullcontext():
        read_vtk_mesh(write(tmp_path / "a.vtk", text))


BYTES = '<DataArray type="UInt8" Name="a" format="ascii">1 2 3</DataArray>'
COORDINATES = 'format="ascii">0 0 0 1 0 0 0 1 0<'


def binary(declared, count):
    return f'format="binary">{base64.b64encode(declared.to_bytes(4, "little") + bytes(count)).decode()}<'


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("PolyData", "ImageData", "polygonal"), ("0 1 2<", "0 1 3<", "refers to point 3"),
        ("0 1 0</", "0 1</", "expected 3 x 3 numbers, got 8"), ("Float64", "Float65", "not supported"),
        ("<VTKFile ", '<!DOCTYPE x [<!ENTITY a "b">]><VTKFile ', "document type"), ("</Piece>", "", "XML"),
        (">3<", ">4<", "expected 4 x 1 numbers"), ('format="ascii"', 'format="morse"', "morse"),
        ('byte_order=', 'compressor="vtkLZ4DataCompressor" byte_order=', "LZ4"),
        ('"3" NumberOfPolys', '"x" NumberOfPolys', "count"),
        ('Name="offsets"', 'Name="ends"', "Polys: connectivity or offsets are missing"),
        ("<PolyData>", "<PolyData><Piece/>", "expected one piece, got 2"),
        (">3<", ">-3<", "the offsets are damaged"), ("Points>", "Pts>", "contains no points"),
        ("<Polys>", f"<PointData>{2 * BYTES}</PointData><Polys>", "the array 'a' is duplicated"),
        (COORDINATES, binary(72, 71), "the array '' is damaged: 1 bytes are missing"),
        (COORDINATES, binary(71, 71), "the array '' has 71 bytes, which are no numbers of float64"),
    ],
)  # fmt: skip
def test_damaged_xml_files_are_rejected_with_the_reason(tmp_path, old, new, words):
    assert old in XML
    assert len(read_vtk_mesh(write(tmp_path / "a.vtp", XML)).triangles) == 1
    with pytest.raises(FileError, match=words):
        read_vtk_mesh(write(tmp_path / "a.vtp", XML.replace(old, new)))


@pytest.mark.parametrize("types", [[5, 3, 5], [5, 1, 3], [3, 5, 5], [5, 5, 1]], ids=str)
def test_arrays_of_a_grid_follow_its_faces_between_cells_of_other_kinds(tmp_path, types):
    cells = {1: "1 0\n", 3: "2 0 1\n", 5: "3 0 1 2\n"}
    rows = "".join(cells[number] for number in types)
    text = HEAD.replace("POLYDATA", "UNSTRUCTURED_GRID") + SQUARE + f"CELLS 3 {len(rows.split())}\n{rows}CELL_TYPES 3\n"
    arrays = "SCALARS k int 1\nLOOKUP_TABLE default\n10 20 30\nFIELD f 1\nwide 2 3 int\n1 2 3 4 5 6\n"
    path = write(tmp_path / "a.vtk", f"{text}{' '.join(map(str, types))}\nCELL_DATA 3\n{arrays}")
    with pytest.warns(UserWarning, match="left out"):
        table = read_vtk_mesh(path)
    faces = np.flatnonzero(np.array(types) == 5)
    np.testing.assert_array_equal(table.triangle_attributes["k"], 10 + 10 * faces)
    np.testing.assert_array_equal(table.triangle_attributes["wide"], np.arange(1, 7).reshape(3, 2)[faces])


def test_faces_decide_between_cloud_and_mesh(tmp_path):
    mesh, cloud = write(tmp_path / "m.vtp", XML), tmp_path / "c.vtp"
    write_vtk_points(cloud, PointTable(np.zeros((2, 3), np.float32)))
    assert is_mesh_file(mesh)
    assert not is_mesh_file(cloud)
    assert isinstance(read_table(cloud), PointTable)
    with pytest.raises(FileError, match="read_triangle_mesh"):
        loom.read_point_cloud(mesh)
    with pytest.raises(FileError, match="read_point_cloud"):
        loom.read_triangle_mesh(cloud)


def test_lines_and_texts_that_are_left_out_are_named_once(tmp_path):
    text = HEAD + "FIELD FieldData 1\nauthor 1 1 string\nme\n" + SQUARE + "LINES 1 3\n2 0 1\nPOLYGONS 1 4\n3 0 1 2\n"
    with pytest.warns(UserWarning, match="left out: metadata 'author', 1 lines"):
        read_vtk_mesh(write(tmp_path / "a.vtk", text))


LONG = "0." + "0" * 60_000  # one such word among 9,000 took 540 MB
WORDS = " ".join(["1"] * 8_999 + [LONG])
LONG_WORDS = {
    "numbers.vtk": f"{HEAD}POINTS 3000 float\n{WORDS}\n",
    "texts.vtk": f"{HEAD}FIELD f 1\nnote 1 9000 string\n" + "\n" * 8_999 + f"{LONG}\nPOINTS 1 float\n1 2 3\n",
    "numbers.vtp": XML.replace('"3" NumberOfPolys="1"', '"3000"').replace("0 0 0 1 0 0 0 1 0", WORDS),
    "integers.vtk": f"{HEAD}POINTS 1 float\n1 2 3\nFIELD f 1\nnote 1 9000 int\n" + "1 " * 8_999 + "0" * 60_000 + "\n",
}  # fmt: skip


@pytest.mark.parametrize("name", LONG_WORDS)
@pytest.mark.filterwarnings("ignore:.*left out")
def test_a_long_word_does_not_multiply_the_memory(tmp_path, name):
    path = write(tmp_path / name, LONG_WORDS[name])
    tracemalloc.start()
    try:
        try:
            loom.read_point_cloud(path)
        except FileError as error:
            assert "memory" not in str(error)
        assert tracemalloc.get_traced_memory()[1] < 1 << 25
    finally:
        tracemalloc.stop()


def blocks_of(raw, count=None):
    """An array as one block of a compressed file that declares `count` bytes."""
    body = zlib.compress(raw)
    header = (1, len(raw) if count is None else count, 0, len(body))
    return b"".join(number.to_bytes(4, "little") for number in header) + body


def compressed_file(rows, field=b"", point=None):
    """A file of one point with an attribute of `rows` bytes and a text."""
    parts = [blocks_of(bytes(12)) if point is None else point, blocks_of(bytes(rows)), blocks_of(field)]
    at = np.cumsum([0, *map(len, parts)])
    array = '<{}Array type="{}" Name="{}" NumberOfComponents="{}" format="appended" offset="{}"/>'
    text = '<VTKFile type="PolyData" compressor="vtkZLibDataCompressor"><PolyData><FieldData>'
    text += array.format("", "String", "unit", 1, at[2]) + '</FieldData><Piece NumberOfPoints="1"><PointData>'
    text += array.format("Data", "UInt8", "a", 1, at[1]) + "</PointData><Points>"
    text += (
        array.format("Data", "Float32", "p", 3, at[0]) + '</Points></Piece></PolyData><AppendedData encoding="raw">_'
    )
    return text.encode() + b"".join(parts) + b"</AppendedData></VTKFile>"


POINT = blocks_of(bytes(12))
OTHER_POINT = {
    POINT[:-1] + b"\2": "Error -3 while decompressing data: incorrect data check",
    POINT[:12] + (len(POINT) - 20).to_bytes(4, "little") + POINT[16:-4]: "block 0 is truncated",
    blocks_of(bytes(8), 12): "block 0 has 8 bytes, not 12",
    blocks_of(bytes(13), 12): "block 0 has more than 12 bytes, not 12",
    bytes(4): "expected 1 x 3 numbers, got 0",
}


@pytest.mark.parametrize(("point", "words"), OTHER_POINT.items(), ids=OTHER_POINT.values())
def test_damaged_blocks_of_an_array_are_rejected(tmp_path, point, words):
    body = compressed_file(1, b"meter\0", point)
    with pytest.raises(FileError, match=words):
        loom.read_point_cloud(write(tmp_path / "a.vtp", body))
    with pytest.raises(FileError, match=r"/b\.vtp: is truncated: the appended data have no end"):
        loom.read_point_cloud(write(tmp_path / "b.vtp", body.replace(b"</AppendedData>", b"")))


def test_arrays_of_another_size_are_not_decompressed(tmp_path):
    assert loom.read_point_cloud(write(tmp_path / "a.vtp", compressed_file(1, b"meter\0")))["a"].tolist() == [0]
    for body in (compressed_file(1 << 27), compressed_file(1, bytes(1 << 27))):
        path = write(tmp_path / "b.vtp", body)
        tracemalloc.start()
        try:
            with pytest.raises(FileError, match="its blocks have 134217728 bytes"):
                loom.read_point_cloud(path)
            assert tracemalloc.get_traced_memory()[1] < 1 << 25
        finally:
            tracemalloc.stop()


def test_arrays_that_share_bytes_are_rejected(tmp_path):
    body = compressed_file(1, b"meter\0")
    path = write(tmp_path / "a.vtp", body.replace(b"<PointData>", b"<PointData>" + 30 * (
        b'<DataArray type="UInt8" Name="%d" NumberOfComponents="12" format="appended" offset="0"/>')
        % (*range(30),)))  # fmt: skip
    with pytest.raises(FileError, match="overlaps other arrays"):
        loom.read_point_cloud(path)


def test_more_cells_than_numbers_are_rejected(tmp_path):
    path = write(tmp_path / "a.vtk", f"{HEAD}{SQUARE}VERTICES 9999999999 2\n1 0\n")
    with pytest.raises(FileError, match="do not fit into 2 numbers"):
        loom.read_point_cloud(path)

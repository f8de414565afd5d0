"""The unit of LAS files: read from text and keys, never guessed, and preserved in copies."""

import struct

import laspy
import pytest

import pointloom as loom
from pointloom.core.units import LengthUnit
from pointloom.io.points.las import open_las
from pointloom.io.points.las_crs import GeographicWarning
from pointloom.io.points.las_units import units_of

from .las_files import write_raw

DEGREES = 'UNIT["degree",0.0174532925199433]'
GEO = f'GEOGCS["NAD83",DATUM["x",SPHEROID["y",6378137,298.25]],PRIMEM["Greenwich",0],{DEGREES}]'
US = 'UNIT["US survey foot",0.304800609601219,AUTHORITY["EPSG","9003"]]'
PLANE = f'PROJCS["Oregon",{GEO},PROJECTION["x"],PARAMETER["false_easting",2500000],{US},AXIS["X",EAST]]'
NEW_BASE = 'BASEGEOGCRS["NAD83",DATUM["x",ELLIPSOID["y",6378137,298.2,LENGTHUNIT["metre",1]]]]'
NEW = (
    f'PROJCRS["UTM",{NEW_BASE},CONVERSION["c",METHOD["m"],PARAMETER["False easting",5e5,LENGTHUNIT["metre",1]]],'
    'CS[Cartesian,2],AXIS["e",east,ORDER[1],LENGTHUNIT["foot",0.3048]],AXIS["n",north,LENGTHUNIT["foot",0.3048]]]'
)


def keys(*entries, doubles=()):
    """GeoTIFF records: keys with their values, and the numbers that they may refer to."""
    parts = [(key, 0, 1, value) if isinstance(value, int) else (key, *value) for key, value in entries]
    flat = [number for part in parts for number in part]
    records = {34735: struct.pack(f"<{4 + len(flat)}H", 1, 1, 0, len(entries), *flat)}
    return records | ({34736: struct.pack(f"<{len(doubles)}d", *doubles)} if doubles else {})


def write(path, records, *, wkt_flag=False):
    return write_raw(path, [[0] * 3, [100] * 3, [1000] * 3], records, wkt_flag=wkt_flag)


@pytest.mark.parametrize(
    ("text", "plane", "height"),
    [
        (PLANE, "US survey foot", None),
        (PLANE.replace("[", "(").replace("]", ")"), "US survey foot", None),
        (f'COMPD_CS["both",{PLANE},VERT_CS["h",VERT_DATUM["d",2005],{US}]]', "US survey foot", "US survey foot"),
        (f'COMPD_CS["both",{PLANE},VERT_CS["h",VERT_DATUM["d",2005],UNIT["metre",1]]]', "US survey foot", "metre"),
        (NEW, "foot", None),
        (NEW.replace("Cartesian,2", "Cartesian,3")[:-1] + ',AXIS["h",up,LENGTHUNIT["metre",1]]]', "foot", "metre"),
        (f'COMPOUNDCRS["c",{NEW},VERTCRS["v",CS[vertical,1],AXIS["h",up],LENGTHUNIT["metre",1]]]', "foot", "metre"),
        (f'BOUNDCRS[SOURCECRS[{NEW}],TARGETCRS[GEOGCRS["WGS 84"]]]', "foot", None),
        ('LOCAL_CS["site",LOCAL_DATUM["x",0],UNIT["Gold Coast foot",0.304799710181508]]', "Gold Coast foot", None),
        (GEO, "degree", None),
        (f'GEOGCRS["WGS 84",CS[ellipsoidal,2],AXIS["lat",north],AXIS["lon",east],ANGLE{DEGREES}]', "degree", None),
        (GEO.replace(DEGREES, 'UNIT["grad",0.015707963267949]'), None, None),
        ('GEOCCS["earth",DATUM["x"],UNIT["metre",1]]', "metre", None),
        # a missing or incomplete unit is no unit: neither the base system nor a name defines it
        (f'PROJCS["NAD83 / Oregon (ft)",{GEO},PROJECTION["x"]]', None, None),
        (PLANE[:-1], None, None),
        (PLANE + "]", None, None),
        (PLANE + PLANE, None, None),
        (PLANE.replace("0.304800609601219", "0.3O48"), None, None),
        (PLANE.replace("0.304800609601219", "0"), None, None),
        (PLANE.replace("0.304800609601219", "1"), None, None),
        (PLANE.replace(US, f'{US},UNIT["metre",1]'), None, None),
        (PLANE.replace(US, 'UNIT["US survey foot"]'), None, None),
        (PLANE.replace('"Oregon"', '"Oregon'), None, None),
        (NEW.replace('north,LENGTHUNIT["foot",0.3048]', 'north,LENGTHUNIT["metre",1]'), None, None),
        ("\xff[", None, None), ("", None, None), ("[" * 50_000, None, None), ("A[" * 20_000, None, None),
    ],
)  # fmt: skip
def test_unit_is_read_from_well_known_text(text, plane, height, tmp_path):
    units = units_of(open_las(write(tmp_path / "a.las", {2112: text})).header)
    assert (units.plane, units.height) == (plane, height)


@pytest.mark.parametrize(
    ("records", "plane", "height"),
    [
        (keys((1024, 1), (3072, 2992), (3076, 9002)), "foot", None),
        (keys((1024, 1), (3076, 9003), (4099, 9003)), "US survey foot", "US survey foot"),
        (keys((1024, 1), (3076, 9001), (4099, 9002)), "metre", "foot"),
        (keys((1024, 1), (3076, 32767), (3077, (34736, 1, 1)), doubles=(1.5, 0.3048)), "foot", None),
        (keys((1024, 1), (3076, 32767), (3077, (34736, 1, 2)), doubles=(1.5, 0.3048)), None, None),
        (keys((1024, 1), (3076, 32767)), None, None),
        (keys((1024, 1), (3072, 2992)), None, None),
        (keys((1024, 1), (3076, 65000)), None, None),
        (keys((1024, 2), (3076, 9001)), "degree", None),
        (keys((1024, 2), (2054, 9105)), None, None),
        (keys((1024, 3), (2052, 9001)), "metre", None),
        ({34735: b"\1\0\1"}, None, None),
    ],
)
def test_unit_is_read_from_geokeys(records, plane, height, tmp_path):
    units = units_of(open_las(write(tmp_path / "a.las", records)).header)
    assert (units.plane, units.height) == (plane, height)


def test_heights_in_another_unit_than_meters_or_degrees_warn(tmp_path):
    path = write(tmp_path / "a.las", keys((1024, 1), (3076, 9002), (4099, 9001)))
    with pytest.warns(loom.UnitWarning, match=r"/a\.las:.*3\.280839895") as caught:
        cloud = loom.read_point_cloud(path)
    assert cloud.unit == "foot" and caught[0].filename == __file__
    with pytest.warns(loom.UnitWarning) as caught:
        parts = list(loom.read_las_chunks(path, 1))
    assert [part.unit for part in parts] == ["foot"] * 3 and len(caught) == 1
    path = write(tmp_path / "degrees.las", keys((1024, 2), (4099, 9003)))
    with pytest.warns(loom.UnitWarning, match=r"/degrees\.las:"), pytest.warns(GeographicWarning):
        cloud = loom.read_point_cloud(path)
    assert cloud.unit == "degree" and loom.project_to_utm(cloud).unit == "metre"


@pytest.mark.parametrize(("wkt_flag", "unit"), [(True, "US survey foot"), (False, "metre")])
def test_conflicting_text_and_keys_warn_and_follow_the_header(wkt_flag, unit, tmp_path):
    path = write(tmp_path / "a.las", {2112: PLANE} | keys((1024, 1), (3076, 9001)), wkt_flag=wkt_flag)
    if wkt_flag:  # LAS 1.4: the keys are ignored
        assert loom.read_point_cloud(path).unit == unit
        return
    with pytest.warns(loom.UnitWarning, match=r"/a\.las:"):
        assert loom.read_point_cloud(path).unit == unit


def test_real_files_have_the_units_of_their_records(shipped_file):
    units = {"laz/autzen_trim.laz": "foot", "autzen/autzen-thin-srs.las": "foot", "autzen/autzen-utm.las": "metre"}
    for name, unit in units.items():
        assert loom.read_point_cloud(shipped_file(f"lidar-pdal/{name}")).unit == unit, name
    assert loom.read_point_cloud(shipped_file("lidar-pdal/las/1.2-with-color.las")).unit is None


@pytest.mark.parametrize("name", ["a.las", "a.laz"])
@pytest.mark.parametrize("unit", ["foot", "US survey foot", "metre", LengthUnit('5" ell', "el", 0.5)], ids=str)
def test_written_file_stores_the_unit_of_the_cloud(name, unit, tmp_path):
    cloud = loom.PointCloud([[0, 0, 0], [1, 2, 3]], unit=unit)
    loom.write_point_cloud(tmp_path / name, cloud)
    back = loom.read_point_cloud(tmp_path / name)
    assert back.unit.meters == cloud.unit.meters and back.unit.name == cloud.unit.name
    assert back.points.tolist() == cloud.points.tolist() and laspy.read(tmp_path / name).header.global_encoding.wkt


def test_like_keeps_the_system_and_warns_of_another_unit(tmp_path):
    path = write(tmp_path / "a.las", {2112: PLANE})
    cloud = loom.read_point_cloud(path)
    loom.write_point_cloud(tmp_path / "b.las", cloud, like=path)
    assert loom.read_point_cloud(tmp_path / "b.las").unit == "US survey foot"
    with pytest.warns(loom.UnitWarning, match=r"/c\.las:.*cloud\.to_unit"):
        loom.write_point_cloud(tmp_path / "c.las", cloud.to_unit("metre"), like=path)

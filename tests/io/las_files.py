"""LAS files written by laspy, and replacement of their bytes."""

import struct

import laspy
import numpy as np

FILES = {"autzen/autzen-utm.las": 1065, "autzen/autzen-thin-srs.las": 10653, "las/1.2-with-color.las": 1065}
FILES["laz/autzen_trim.laz"] = 110_000
# Excerpts of two of them are shipped.
SHIPPED_FILES = FILES | {"autzen/autzen-thin-srs.las": 1066, "laz/autzen_trim.laz": 5000}


def fill(layout, count, rng):
    """A record of laspy's with random values in every dimension."""
    steps = {"scales": [0.01, 0.02, 0.001], "offsets": [5e5, -3.5, 0]}
    record = laspy.ScaleAwarePointRecord.zeros(count, point_format=layout, **steps)
    for name in record.array.dtype.names:
        column = record.array[name]
        if column.dtype.kind == "f":
            column[...] = rng.normal(size=column.shape)
        else:
            info = np.iinfo(column.dtype)
            column[...] = rng.integers(info.min, info.max, column.shape, column.dtype, endpoint=True)
    return record


def write_raw(path, raw, records, *, scales=(0.01,) * 3, offsets=(0, 0, 0), wkt_flag=None):
    """A file of points with these stored integers (n, 3) and records of its coordinate system by number."""
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales, header.offsets = scales, offsets
    for number, content in records.items():
        content = content.encode() if isinstance(content, str) else content
        header.vlrs.append(laspy.VLR("LASF_Projection", number, "", content))
    record = laspy.ScaleAwarePointRecord.zeros(len(raw), header=header)
    record.X, record.Y, record.Z = np.transpose(raw)
    with laspy.open(path, mode="w", header=header, do_compress=path.suffix == ".laz") as writer:
        writer.write_points(record)
    if wkt_flag is not None:  # laspy before 2.7 sets the flag itself
        content = bytearray(path.read_bytes())
        content[6] = content[6] & ~16 | 16 * wkt_flag
        path.write_bytes(content)
    return path


def make(path, point_format, count, rng, extra=(), version=None):
    """A file of random points by laspy; returns its record."""
    version = version or {0: "1.2", 4: "1.3", 6: "1.4"}[max(k for k in (0, 4, 6) if k <= point_format)]
    header = laspy.LasHeader(point_format=point_format, version=version)
    header.add_extra_dims(list(extra))
    record = fill(header.point_format, count, rng)
    header.scales, header.offsets = record.scales, record.offsets
    with laspy.open(path, mode="w", header=header, do_compress=path.suffix == ".laz") as writer:
        writer.write_points(record)
    return record


def edited(path, *edits):
    """The file with bytes replaced, each edit (position, format of struct, values)."""
    content = bytearray(path.read_bytes())
    for at, form, *values in edits:
        struct.pack_into(form, content, at, *values)
    path.write_bytes(content)
    return path

"""LAS files written by laspy, and replacement of their bytes."""

from __future__ import annotations

import struct

import laspy
import numpy as np

FILES = {
    "autzen/autzen-utm.las": 1065,
    "autzen/autzen-thin-srs.las": 10653,
    "las/1.2-with-color.las": 1065,
    "laz/autzen_trim.laz": 110_000,
}
# Excerpts of two of them are shipped.
SHIPPED_FILES = FILES | {"autzen/autzen-thin-srs.las": 1066, "laz/autzen_trim.laz": 5000}


def fill(layout, count, rng):
    """A record of laspy's with random values in every dimension."""
    record = laspy.ScaleAwarePointRecord.zeros(
        count, point_format=layout, scales=[0.01, 0.02, 0.001], offsets=[5e5, -3.5, 0]
    )
    for name in record.array.dtype.names:
        column = record.array[name]
        if column.dtype.kind == "f":
            column[...] = rng.normal(size=column.shape)
        else:
            info = np.iinfo(column.dtype)
            column[...] = rng.integers(info.min, info.max, column.shape, column.dtype, endpoint=True)
    return record


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

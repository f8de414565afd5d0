"""Cameras of Agisoft Metashape: the XML of File > Export > Export Cameras.

Poses are relative to a chunk or component (world = scale R x + t). Geographic projects are geocentric (ECEF) [m]. P1
and P2 are swapped relative to OpenCV. The principal point is relative to the image center. Document types are rejected.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera_models import CameraModel
from ...core.checks import check_rigid
from ...core.errors import FileError, FilePath
from ...core.paths import path_of
from ...kernels.linear_algebra import cube_root, det, matmul
from ..source import open_source
from ..xml_elements import LimitedBuilder
from .colmap_records import camera_of
from .sfm_model import SfmModel

MAX_XML_BYTES = 1 << 28  # [B] about 100,000 cameras. The parsed tree takes ten times as much

FRAME, FISHEYE = ("frame",), ("fisheye", "equidistant_fisheye")
NUMBERS = ("f", "cx", "cy", "k1", "k2", "k3", "k4", "p1", "p2", "b1", "b2")
NOT_READ = ("p3", "p4", "fx", "fy", "skew")  # parameters of other lens versions

_EXPORT = "In Metashape: File > Export > Export Cameras, format Agisoft XML"


def read_metashape_cameras(path: FilePath) -> SfmModel:
    """Read poses and lenses exported by Agisoft Metashape.

    Args:
        path: The file of File > Export > Export Cameras, format Agisoft XML.

    Returns:
        A model without points, named by camera labels, which often lack extensions. Disabled or unaligned cameras are
        listed in `left_out`. Lenses use COLMAP's models if equivalent, else METASHAPE or METASHAPE_FISHEYE.

    Raises:
        FileError: Missing, invalid XML, no aligned camera, several chunks, a lens that is neither frame nor
            (equidistant) fisheye, duplicate labels, invalid numbers.

    Notes:
        Geographic projects have geocentric positions, far from the origin. See `SfmModel.transform`.

    Example:
        >>> import pathlib, pointloom as loom
        >>> from pointloom.io.models.metashape import read_metashape_cameras
        >>> _ = pathlib.Path("cameras.xml").write_text('''<document version="2.0.0"><chunk label="Chunk 1">
        ... <sensors><sensor id="0" type="frame"><resolution width="640" height="480"/>
        ... <calibration type="frame" class="adjusted"><resolution width="640" height="480"/>
        ... <f>500</f><cx>1.5</cx><cy>-2</cy><k1>-0.1</k1></calibration></sensor></sensors>
        ... <cameras><camera id="0" sensor_id="0" label="IMG_1">
        ... <transform>1 0 0 2 0 1 0 0 0 0 1 0 0 0 0 1</transform></camera>
        ... <camera id="1" sensor_id="0" label="IMG_2"/></cameras></chunk></document>''')
        >>> model = read_metashape_cameras("cameras.xml")
        >>> model.centers.tolist(), model.left_out, model.cameras[0].model
        ([[2.0, 0.0, 0.0]], ('IMG_2: not aligned',), 'SIMPLE_RADIAL')
    """
    path = path_of(path)
    chunk = _chunk_of(path)
    lenses = {_name(path, sensor, "id"): sensor for sensor in chunk.findall("sensors/sensor")}
    chunk_transform = _transform_of(path, chunk, "the chunk")
    parts = {
        _name(path, part, "id"): _transform_of(path, part, f"component {part.get('id')}")
        for part in chunk.findall("components/component")
    }
    cameras: dict[str, CameraModel] = {}
    names, models, poses, left_out = [], [], [], []
    for camera in _cameras(chunk):
        label = camera.get("label") or f"camera {_name(path, camera, 'id')}"
        reason = _why_left_out(camera)
        if reason:
            left_out.append(f"{label}: {reason}")
            continue
        sensor = _name(path, camera, "sensor_id")
        if sensor not in lenses:
            raise FileError(path, f"camera {label!r} refers to sensor {sensor!r}, which is missing")
        if sensor not in cameras:
            cameras[sensor] = _lens_of(path, lenses[sensor], sensor)
        T = _numbers(path, camera.findtext("transform") or "", 16, f"transform of camera {label!r}").reshape(4, 4)
        component = parts.get(camera.get("component_id") or "")
        names.append(label)
        models.append(cameras[sensor])
        poses.append(_pose(path, label, T, component if component is not None else chunk_transform))
    if not names:
        remedy = "Align the photos first" if left_out else _EXPORT
        raise FileError(
            path, f"contains no aligned camera ({len(left_out)} are disabled or not aligned)", remedy=remedy
        )
    try:
        return SfmModel(tuple(names), tuple(models), np.array(poses), left_out=tuple(left_out))
    except ValueError as error:
        remedy = "Rename cameras in Metashape so that each has a label of its own" if "duplicated" in str(error) else ""
        raise FileError(path, str(error), remedy=remedy) from error


def _cameras(chunk: ET.Element) -> list[ET.Element]:
    group = chunk.find("cameras")
    return [] if group is None else list(group.iter("camera"))  # including groups


def _why_left_out(camera: ET.Element) -> str:
    if (camera.get("enabled") or "true").lower() in ("false", "0"):
        return "disabled"
    if camera.find("transform") is None:
        return "of a multi-camera system" if camera.get("master_id") else "not aligned"
    return ""


def _transform_of(path: Path, element: ET.Element, what: str) -> NDArray[np.float64] | None:
    """World transform of a chunk or component, shape (4, 4), or None."""
    transform = element.find("transform")
    if transform is None:
        return None
    T = np.eye(4)
    rotation, translation, scale = (transform.findtext(name) for name in ("rotation", "translation", "scale"))
    factor = 1.0 if scale is None else float(_numbers(path, scale, 1, f"scale of {what}")[0])
    if not 1e-30 < factor < 1e30:
        raise FileError(path, f"the scale of {what} is {factor:g}; expected a positive number")
    if rotation is not None:
        T[:3, :3] = _numbers(path, rotation, 9, f"rotation of {what}").reshape(3, 3)
    _check_rigid(path, T, f"the rotation of {what}")
    T[:3, :3] *= factor
    if translation is not None:
        T[:3, 3] = _numbers(path, translation, 3, f"translation of {what}")
    return T


def _pose(path: Path, label: str, T: NDArray[np.float64], transform: NDArray[np.float64] | None) -> NDArray[np.float64]:
    """T_camera_world from a camera's pose in its chunk."""
    _check_rigid(path, T, f"the transform of camera {label!r}")
    if transform is not None:
        scale = cube_root(float(det(transform[:3, :3])))
        center = matmul(transform[:3, :3], T[:3, 3]) + transform[:3, 3]
        T[:3, :3] = matmul(transform[:3, :3] / scale, T[:3, :3])
        T[:3, 3] = center
    pose = np.eye(4)
    pose[:3, :3] = T[:3, :3].T
    pose[:3, 3] = -matmul(T[:3, :3].T, T[:3, 3])
    return pose


def _check_rigid(path: Path, T: NDArray[np.float64], what: str) -> None:
    try:
        check_rigid(what, T)
    except ValueError as error:
        raise FileError(path, str(error)) from error


def _lens_of(path: Path, sensor: ET.Element, number: str) -> CameraModel:
    where = f"sensor {number}"
    given = sensor.findall("calibration")
    chosen = [c for c in given if c.get("class") == "adjusted"] or given
    if not chosen:
        raise FileError(path, "has no calibration", where=where, remedy="Align the photos, then export the cameras")
    calibration = chosen[0]
    kind = calibration.get("type") or sensor.get("type") or "frame"
    if kind not in FRAME + FISHEYE:
        reason = f"the lens is {kind[:40]!r}; supported are frame and (equidistant) fisheye"
        raise FileError(path, reason, where=where, remedy="Export undistorted photos from Metashape")
    for name in NOT_READ:
        if float(_numbers(path, calibration.findtext(name) or "0", 1, f"{name} of {where}")[0]) != 0:
            raise FileError(
                path, f"{name} is not supported", where=where, remedy=f"Optimize the cameras without it. {_EXPORT}"
            )
    values = {
        name: float(_numbers(path, calibration.findtext(name) or "0", 1, f"{name} of {where}")[0]) for name in NUMBERS
    }
    sides = calibration.find("resolution")
    sides = sensor.find("resolution") if sides is None else sides
    if sides is None:
        raise FileError(path, "has no resolution", where=where)
    width, height = (_side(path, sides.get(name), where) for name in ("width", "height"))
    values["cx"], values["cy"] = values["cx"] + width / 2, values["cy"] + height / 2
    model, params = _as_colmap(values, kind in FISHEYE)
    return camera_of(path, where, model, width, height, params)


def _as_colmap(v: dict[str, float], is_fisheye: bool) -> tuple[str, list[float]]:
    focal, center, tangential = [v["f"] + v["b1"], v["f"]], [v["cx"], v["cy"]], [v["p2"], v["p1"]]
    if v["b2"] or (v["k4"] and not is_fisheye):
        return "METASHAPE_FISHEYE" if is_fisheye else "METASHAPE", [v[name] for name in NUMBERS]
    if is_fisheye:
        if any(tangential):
            numbers = [v["k1"], v["k2"], *tangential, v["k3"], v["k4"], 0.0, 0.0]
            return "THIN_PRISM_FISHEYE", [*focal, *center, *numbers]
        return "OPENCV_FISHEYE", [*focal, *center, v["k1"], v["k2"], v["k3"], v["k4"]]
    if v["k3"]:
        return "FULL_OPENCV", [*focal, *center, v["k1"], v["k2"], *tangential, v["k3"], 0.0, 0.0, 0.0]
    if any(tangential) or (v["b1"] and (v["k1"] or v["k2"])):
        return "OPENCV", [*focal, *center, v["k1"], v["k2"], *tangential]
    if v["b1"]:
        return "PINHOLE", [*focal, *center]
    if v["k2"]:
        return "RADIAL", [v["f"], *center, v["k1"], v["k2"]]
    return ("SIMPLE_RADIAL", [v["f"], *center, v["k1"]]) if v["k1"] else ("SIMPLE_PINHOLE", [v["f"], *center])


def _side(path: Path, text: str | None, where: str) -> int:
    if not (text and text.isascii() and text.isdigit() and len(text) < 10):
        raise FileError(path, f"expected a resolution in whole pixels, got {str(text)[:40]!r}", where=where)
    return int(text)


def _chunk_of(path: Path) -> ET.Element:
    data = open_source(path)
    if len(data) > MAX_XML_BYTES:
        raise FileError(
            path, f"has {len(data):,} bytes; expected at most {MAX_XML_BYTES:,}", remedy="Export fewer cameras"
        )
    parser = ET.XMLParser(target=LimitedBuilder())
    try:
        parser.feed(data[:])
        root = parser.close()
    except ET.ParseError as error:
        line, column = error.position
        raise FileError(path, f"no XML: {error.msg}", where=f"line {line}, column {column}", remedy=_EXPORT) from error
    except (ValueError, LookupError) as error:  # raised by the builder, or an unknown encoding
        raise FileError(path, f"not read: {error}", remedy=_EXPORT) from error
    chunks = root.findall("chunk") if root.tag == "document" else []
    if len(chunks) != 1:
        contents = f"{len(chunks)} chunks" if root.tag == "document" else f"an element {root.tag[:40]!r}"
        raise FileError(path, f"expected a document with one chunk, got {contents}", remedy=_EXPORT)
    return chunks[0]


def _name(path: Path, element: ET.Element, attribute: str) -> str:
    value = element.get(attribute)
    if value is None:
        raise FileError(path, f"an element {element.tag!r} has no {attribute}")
    return value


def _numbers(path: Path, text: str, count: int, what: str) -> NDArray[np.float64]:
    words = text.split()
    try:
        values = np.array([float(word) for word in words if "_" not in word])
    except ValueError:
        values = np.zeros(0)
    if len(words) != count or len(values) != count or not (np.abs(values) <= 1e100).all():
        raise FileError(path, f"{what}: expected {count} finite numbers, got {text[:80]!r}")
    return values

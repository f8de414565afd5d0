"""What `pointloom depth` says of its work in a terminal."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from ..console import format_bytes, format_seconds, format_share


def depth_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """What was done as labels and values for the terminal."""
    pictures = report["pictures"]
    fields = [("network", f"{report['model']}, preset {report['preset']} ({report['licence']})")]
    fields.append(("ran on", report["provider"]))
    if len(pictures) == 1 and not report["failures"]:
        fields += _picture_fields(pictures[0])
    else:
        fields += [(Path(each["picture"]).name, _one_line(each)) for each in pictures]
        fields += [(Path(each["picture"]).name, each["reason"]) for each in report["failures"]]
    return [
        *fields,
        ("seconds", format_seconds(report["seconds"])),
        ("memory", f"{format_bytes(report['peak_bytes'])} at most"),
        ("files", ", ".join(report["files"]) or "none"),
    ]


def _picture_fields(each: dict[str, Any]) -> list[tuple[str, str]]:
    camera = each["camera"]
    seen = f"{camera['width']} x {camera['height']}, f {camera['fx']:.6g} {camera['fy']:.6g}, from {camera['source']}"
    if camera["source"].startswith("assumed"):
        seen += "\nshapes are stretched if the lens was another: give --intrinsic"
    size = f"{each['width']} x {each['height']}, {each['input']['width']} x {each['input']['height']} for the network"
    if each["tiles"] is not None:
        size += f"\n{each['tiles']['used']} of {each['tiles']['count']} tiles agree with the whole"
    points = f"{each['points']:,}, {format_share(each['kept_share'])} of the pixels"
    return [("picture", size), ("camera", seen), ("depth", _depth_line(each)), ("points", points)]


def _depth_line(each: dict[str, Any]) -> str:
    unit, near, far = each["unit"], each["nearest"], each["farthest"]
    reach = "none" if near is None else f"{near:.4g} to {far:.4g}"
    if unit == "m":
        line = f"{reach} m"
    elif unit == "arbitrary":
        line = f"{reach}, units arbitrary: the nearest pixel is at 1; --align gives metres"
    else:
        line = f"{reach} in the unit of the sparse model"
    if each["references"]:
        line += f"\n1 / z = {each['scale']:.6g} d + {each['shift']:.6g}, {_agreement(each)}"
    return line


def _agreement(each: dict[str, Any]) -> str:
    if each["inlier_share"] is None:
        return f"from {each['references']} distances without a check: one more would tell"
    return f"{format_share(each['inlier_share'])} of {each['references']:,} references agree within 10 %"


def _one_line(each: dict[str, Any]) -> str:
    line = f"{each['points']:,} points, {_depth_line(each).splitlines()[0]}"
    return f"{line}; {_agreement(each)}" if each["references"] else line

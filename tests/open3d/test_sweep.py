"""Signatures and results of all methods of geometries agree with those of Open3D, except for the listed differences."""

import inspect
import re
from ast import literal_eval
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

import pointloom.open3d as bridge

MODULES = ("geometry", "utility", "camera", "io", "pipelines.registration", "pipelines.odometry")
MODULES += ("pipelines.integration", "pipelines.color_map")


def functions_of(package) -> Iterator[tuple[str, Any]]:
    """The public functions and methods of a package by path."""
    for module in MODULES:
        home = package
        for part in module.split("."):
            home = getattr(home, part)
        for name in dir(home):
            value = getattr(home, name)
            if inspect.isclass(value):
                yield from ((f"{module}.{name}.{key}", getattr(value, key)) for key in dir(value) if key[0] != "_")
            elif name[0] != "_":
                yield f"{module}.{name}", value


def signatures(o3d) -> dict[str, list[list[str]]]:
    """The parameters of each overload in Open3D's docstrings: "name", or "name=value" for plain defaults."""
    found = {}
    for path, function in functions_of(o3d):
        start = rf"^(?:\d+\. )?{path.rpartition('.')[2]}"
        lines = re.findall(rf"{start}\((.*?)\)(?: -> .*)?$", getattr(function, "__doc__", None) or "", re.M)
        lines = [re.sub(r"\([^()]*\)", "", line) for line in lines]
        plain = r"(?:: [\w.]+ = (-?[\d.]+(?:e-?\d+)?|True|False)(?=, |$))?"
        parts = [re.findall(rf"(?:^|, )(\w+)(?=: |, | = |$){plain}", line) for line in lines]
        texts = [[f"{name}={value}" if value else name for name, value in part if name != "self"] for part in parts]
        if texts and callable(function) and "args" not in lines[0] and "arg0" not in lines[0]:
            found[path] = texts
    return found


def test_signatures_agree_with_open3d(oracle):
    stored = oracle("open3d/signatures", signatures)
    assert len(stored) > 400
    for path, function in functions_of(bridge):
        if path not in stored:
            continue
        given = [p for p in inspect.signature(function).parameters.values() if p.kind is not p.VAR_KEYWORD]
        names = [p.name for p in given if p.name != "self"]
        overloads = [[text.partition("=")[0] for text in texts] for texts in stored[path]]
        assert names in overloads or any(p.kind is p.VAR_POSITIONAL for p in given), (path, stored[path])
        texts = stored[path][overloads.index(names)] if names in overloads else []
        defaults = dict(text.split("=") for text in texts if "=" in text)
        actual = {p.name: p.default for p in given if p.name in defaults}
        assert actual == pytest.approx({k: literal_eval(v) for k, v in defaults.items()}, rel=1e-6), path

"""docs/migration.md and the errors of unknown names state the new name of each renamed one."""

import importlib
import re
from pathlib import Path

import pytest

import pointloom as loom
from pointloom.core.renamed_names import RENAMED

PAGE = (Path(__file__).parents[1] / "docs" / "migration.md").read_text()


def found(name):
    value = loom
    for part in name.split(".")[1:]:
        value = getattr(value, part)
    return value


def test_the_page_has_the_table():
    rows = dict(re.findall(r"^\| `(loom[\w.]+)` \| (.+?) \|", PAGE, flags=re.MULTILINE))
    assert {old: row.replace("`", "") for old, row in rows.items()} == RENAMED


@pytest.mark.parametrize("old", RENAMED)
def test_the_old_name_is_gone_and_its_error_states_the_new_one(old):
    for new in re.split(r", | or ", RENAMED[old]):
        assert found(new) is not None
    with pytest.raises(AttributeError) as caught:
        found(old)
    if old.count(".") == 1 or hasattr(loom, old.split(".")[1]):
        assert RENAMED[old] in str(caught.value)


@pytest.mark.parametrize(
    ("package", "name", "new"),
    [
        ("rgbd", "Model", "loom.rgbd.SlamModel"),
        ("photogrammetry", "match", "loom.photogrammetry.match_features"),
        ("photogrammetry", "fuse", "loom.photogrammetry.fuse_depth_maps"),
        ("meshing", "texture_from_pictures", "loom.meshing.texture_from_images"),
    ],
)
def test_an_old_name_in_the_new_package_is_an_error_with_the_new_name(package, name, new):
    with pytest.raises(AttributeError, match=re.escape(new)):
        getattr(importlib.import_module(f"pointloom.{package}"), name)

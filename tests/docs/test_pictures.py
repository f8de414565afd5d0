"""Pictures of operations in the reference: each is drawn, its code runs alone, and results without one are found."""

import inspect
import itertools
import re

import numpy as np
import pytest
from machinery import pictures, public

import pointloom as loom

from .conftest import DOCS

OPERATIONS = pictures.operations()
pytestmark = pytest.mark.usefixtures("names_of_torch")


@pytest.mark.nightly  # with the gallery: some seconds together
@pytest.mark.parametrize("name", OPERATIONS)
def test_each_picture_shows_its_panels(name):
    """Each panel shows something, in another place or color than the panel before it: the operation is visible."""
    operation = OPERATIONS[name]
    drawn = np.asarray(pictures.draw(operation, (320, 200)))[pictures.TITLE :]
    count = len(operation.panels())
    width = (320 - pictures.GAP * (count - 1)) // count
    panels = [drawn[:, left : left + width] for left in range(0, 320, width + pictures.GAP)][:count]
    for panel in panels:
        covered = (panel != 255).any(axis=2).mean()
        assert covered > 0.05 and len(np.unique(panel.reshape(-1, 3), axis=0)) > 3  # lines have 5 shades
    for before, after in itertools.pairwise(panels):
        assert (before != after).any(axis=2).mean() > 0.005


@pytest.mark.nightly
@pytest.mark.parametrize("name", OPERATIONS)
def test_the_code_of_a_picture_runs_alone(name):
    exec(OPERATIONS[name].code, {"np": np, "loom": loom})


@pytest.mark.parametrize("name", OPERATIONS)
def test_the_code_of_a_picture_is_short_and_uses_its_operation(name):
    operation = OPERATIONS[name]
    assert 2 <= len(operation.code.splitlines()) <= 8
    first = operation.names[0].rpartition(".")[2]
    assert first in operation.code or inspect.isclass(getattr(loom, operation.names[0], None)), first


def test_pictures_have_public_names_and_reused_ones_a_page():
    members = {f"{name}.{key}" for name, each in public.all_names().items() if inspect.isclass(each.value)
               for key in public.members_of(name)}  # fmt: skip
    assert set(pictures.pictures()) <= members | set(public.all_names())
    for page, image, _ in pictures.REUSED:
        script = DOCS / "examples" / page.removeprefix("gallery/")
        path = DOCS / f"{page}.md" if isinstance(image, str) else script.with_suffix(".py")
        assert path.exists(), page
        assert not isinstance(image, str) or f"({image})" in path.read_text(encoding="utf-8")


def test_visible_results_without_picture_or_reason_are_found(monkeypatch):
    known = pictures.pictures()
    monkeypatch.setattr(pictures, "pictures", lambda: {n: known[n] for n in known if not n.endswith(".thin")})
    assert "pointloom.PointCloud.thin" in pictures.without_picture()
    assert not {"pointloom.PointCloud.copy", "pointloom.PointCloud.crop"} & {*pictures.without_picture()}


def test_reasons_for_no_picture_apply_to_operations():
    last = {name.rpartition(".")[2] for name in pictures.visible() if name not in pictures.pictures()}
    for reason, pattern in pictures.NEEDS_NONE.items():
        assert any(re.fullmatch(pattern, name) for name in last), reason


def test_a_picture_appears_once_on_a_page(monkeypatch):
    monkeypatch.setattr(pictures.Path, "exists", lambda path: True)
    names = ["pointloom.PointCloud.random_down_sample", "pointloom.PointCloud.thin"]
    first, second = ("\n".join(pictures.picture_of(name)) for name in names)
    assert ".. figure:: /reference/pictures/down_sample.jpg" in first and "random_down_sample(0.04" in first
    assert second.strip() == "Picture: :py:obj:`~pointloom.PointCloud.random_down_sample`"
    assert "From :doc:`/terrain`" in "\n".join(pictures.picture_of("pointloom.profile"))
    assert pictures.picture_of("pointloom.PointCloud.copy") == []

"""Every example in a docstring of the package runs and gives the result that it shows."""

from __future__ import annotations

import doctest
import importlib
import importlib.util

import pytest

from .test_imports import PACKAGE, PACKAGES

MODULES = sorted(
    ".".join(("pointloom", *path.relative_to(PACKAGE).with_suffix("").parts)).removesuffix(".__init__")
    for folder in PACKAGES
    for path in (PACKAGE / folder).rglob("*.py")
    if ">>> " in path.read_text(encoding="utf-8")
)
# Over a second of CPU; tests of the same names check the same.
SLOW = {
    "pointloom.datasets.made.objects", "pointloom.datasets.made.photographs", "pointloom.datasets.made.room",
    "pointloom.datasets.made.terrain", "pointloom.meshing.volume.splat_fusion",
    "pointloom.registration.deformable.nonrigid", "pointloom.tiling.jobs.fusion",
}  # fmt: skip


def test_slow_entries_exist():
    assert {*MODULES} >= SLOW


@pytest.mark.parametrize("name", [pytest.param(name, marks=[pytest.mark.slow] * (name in SLOW)) for name in MODULES])
def test_the_examples_of_a_module_run(name, tmp_path, monkeypatch):
    if name.startswith("pointloom.torch") and importlib.util.find_spec("torch") is None:
        pytest.skip("torch is not installed. `make test-torch` runs these examples")
    monkeypatch.chdir(tmp_path)  # for examples that write files
    module = importlib.import_module(name)
    result = doctest.testmod(module, optionflags=doctest.ELLIPSIS)
    assert result.failed == 0, f"{result.failed} of {result.attempted} examples of {name} failed; see the output"


def test_every_public_name_has_an_example():
    import pointloom as loom
    from pointloom.public_names import results_of

    finder = doctest.DocTestFinder()
    for name in sorted(set(loom.__all__) - results_of("pointloom")):
        if name.endswith("Error"):
            continue
        assert any(test.examples for test in finder.find(getattr(loom, name))), name

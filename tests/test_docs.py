"""Every page is reached from the README, every link leads somewhere, and examples import public names alone."""

import re

import pytest

from .test_imports import ROOT

COPIES = ROOT / "docs" / "project"  # what `make docs` puts there
PAGES = sorted(
    path.relative_to(ROOT).as_posix()
    for path in [*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")]
    if COPIES not in path.parents
)
PAGES += ["src/pointloom/kernels/README.md", "benchmarks/README.md", "tests/emulated_cuda/README.md"]
PAGES += ["benchmarks/gpu_kit/README.md", "changes/README.md"]


def links_of(page: str) -> list[str]:
    """The targets of a page's relative links, as paths from the root."""
    text = re.sub(r"```.*?```", "", (ROOT / page).read_text(), flags=re.DOTALL)
    targets = [target.split("#")[0] for target in re.findall(r"\]\(([^)\s]+)\)", text) if "://" not in target]
    folder = (ROOT / page).parent
    return [(folder / target).resolve().relative_to(ROOT).as_posix() for target in targets if target]


@pytest.mark.parametrize("page", PAGES)
def test_every_link_leads_somewhere(page):
    assert [target for target in links_of(page) if not (ROOT / target).exists()] == []


def test_every_page_is_reached_from_the_readme():
    reached, waiting = {"README.md"}, ["README.md"]
    while waiting:
        for target in links_of(waiting.pop()):
            if target.endswith(".md") and target not in reached and (ROOT / target).exists():
                reached.add(target)
                waiting.append(target)
    assert set(PAGES) - reached == set()


@pytest.mark.parametrize("page", PAGES)
def test_examples_import_only_public_names(page):
    blocks = re.findall(r"```python\n(.*?)```", (ROOT / page).read_text(), flags=re.DOTALL)
    imports = re.findall(r"from (pointloom[\w.]*) import|import (pointloom[\w.]+)", "\n".join(blocks))
    packages = ("registration", "rgbd", "meshing", "photogrammetry", "open3d")
    public = {"pointloom", *(f"pointloom.{name}" for name in packages)}
    assert {first or second for first, second in imports} <= public

"""What the site is made from: names and their examples, commands, links, pictures and recordings of scripts."""

import ast
import re
from pathlib import Path

import click
import numpy as np
import pytest
from machinery import check_links, commands, galleries, pages, public, reference, scraper, texts, usage

import pointloom as loom
from pointloom.app.shell.cli import cli
from pointloom.drawing.recording.shared_player import write_player

from .conftest import DOCS

pytestmark = pytest.mark.slow  # needs Sphinx, which `make test` does not install


def used(text: str) -> frozenset[str]:
    return usage.names_used(ast.parse(text))


def test_every_name_of_the_stub_has_a_page_and_a_place_in_the_index():
    listed = set(re.findall(r"^   ([\w.]+)$", reference.index_page(), flags=re.MULTILINE))
    for module in public.public_modules():
        if module != "pointloom":
            listed |= set(re.findall(r"^   ([\w.]+)$", reference.module_page(module), flags=re.MULTILINE))
    assert listed >= {*public.all_names(), *public.public_modules()} - {"pointloom"}
    stub = (DOCS.parent / "src/pointloom/__init__.pyi").read_text()
    names = {line.rsplit(" ", 1)[1] for line in stub.splitlines() if line.startswith("from ")}
    assert listed >= {f"pointloom.{name}" for name in names}


def test_methods_are_found_through_results_tuples_loops_and_attributes():
    text = """
import pointloom as loom
cloud, kept = loom.read_point_cloud("a.ply").remove_statistical_outlier(20, 2.0)
mesh = loom.fuse(loom.open_dataset("b"), voxel_size=0.01).mesh
mesh.compute_vertex_normals()
print(cloud.points)
"""
    assert used(text) >= {
        "pointloom.read_point_cloud",
        "pointloom.PointCloud.remove_statistical_outlier",
        "pointloom.PointCloud.points",
        "pointloom.TriangleMesh.compute_vertex_normals",
    }


def test_a_module_by_another_name_is_followed():
    text = "import pointloom as loom\nreg = loom.registration\nreg.registration_icp(a, b, 0.1, T, reg.L1Loss())"
    assert used(text) >= {"pointloom.registration.registration_icp", "pointloom.registration.L1Loss"}


def test_a_method_that_several_classes_have_counts_for_none_of_them_where_the_object_is_not_known():
    assert used("import pointloom as loom\nthing.transform(pose)\nthing.cluster_dbscan(1, 2)") == {
        "pointloom.PointCloud",
        "pointloom.PointCloud.cluster_dbscan",
    }


@pytest.mark.parametrize("name", sorted(cli.commands))
def test_the_page_of_a_command_says_all_that_its_help_says(name):
    command = cli.commands[name]
    text = commands.page_of(name, command)
    for option in command.params:
        if isinstance(option, click.Option) and not option.hidden:
            assert all(spelling in text for spelling in option.opts)
            assert texts.plain(option.help or "").split("\n")[0] in text
    assert "\b" not in text


def test_every_page_beside_the_guides_stands_in_one_of_the_sites_lists():
    lists = (DOCS / "guides.md").read_text() + (DOCS / "index.md").read_text() + "versions\nREADME\nindex\n"
    assert {path.stem for path in DOCS.glob("*.md")} - set(re.findall(r"^[\w-]+$", lists, flags=re.MULTILINE)) == set()


@pytest.mark.parametrize(
    ("page", "text", "expected"),
    [
        ("gpu", "[a](../CONTRIBUTING.md#test)", "[a](project/contributing.md#test)"),
        ("project/kernels", "[a](../CONTRIBUTING.md)", "[a](contributing.md)"),
        ("project/changelog", "[a](docs/gpu.md) ![b](docs/room.png)", "[a](../gpu.md) ![b](../room.png)"),
        ("adr/README", "[`a`](../README.md)", "[`a`](../guides.md)"),
        ("gpu", "[a](../pyproject.toml) [b](#part) [c](https://x.y)", "a [b](#part) [c](https://x.y)"),
        ("gpu", "```\n[a](../README.md)\n```", "```\n[a](../README.md)\n```"),
    ],
)
def test_links_between_pages_of_the_repository_stay_links_in_the_site(page, text, expected):
    assert pages.rewrite_links(page, text) == expected


def test_with_an_address_links_to_files_lead_into_the_repository(monkeypatch):
    monkeypatch.setitem(pages.PLACE, "repository", "https://host/owner/name")
    assert pages.rewrite_links("gpu", "[a](../Makefile)") == "[a](https://host/owner/name/blob/main/Makefile)"


def test_a_broken_link_a_missing_part_and_what_comes_from_elsewhere_are_found(tmp_path):
    (tmp_path / "a.html").write_text('<a href="b.html#x">1</a><a href="c.html">2</a><a href="https://x.y">3</a>')
    (tmp_path / "b.html").write_text('<p id="y"></p><script src="https://x.y/z.js"></script><a href="a.html">4</a>')
    faults, elsewhere = check_links.faults_of(tmp_path)
    assert faults == [
        "a.html: b.html#x has no such part",
        "a.html: c.html is not there",
        "b.html: loads https://x.y/z.js from elsewhere",
    ]
    assert elsewhere == ["https://x.y", "https://x.y/z.js"]


@pytest.fixture
def script(tmp_path, monkeypatch):
    """What sphinx-gallery hands to a scraper."""
    monkeypatch.setattr(scraper, "MADE", tmp_path / "made")

    class Paths:
        paths: list[Path]

        def __init__(self):
            self.paths = []

        def __len__(self):
            return len(self.paths)

        def __next__(self):
            self.paths.append(tmp_path / "images" / f"{len(self.paths) + 1}.png")
            return str(self.paths[-1])

    (tmp_path / "images").mkdir()
    source = tmp_path / "examples" / "clouds" / "plot_a_thing.py"
    target = tmp_path / "gallery" / "clouds" / "plot_a_thing.py"
    return {"example_globals": {}, "image_path_iterator": Paths(), "src_file": str(source), "target_file": str(target)}


def show(script, tmp_path):
    return scraper.show_results(None, script, {"src_dir": str(tmp_path)})


def test_each_new_picture_of_a_cell_is_shown_once_in_the_order_of_its_making(script, tmp_path):
    ball = loom.TriangleMesh.create_sphere(1.0)
    script["example_globals"] = {"first": loom.render(ball, size=(64, 48)), "count": 3}
    assert "images/1.png" in (text := show(script, tmp_path)) and ":alt: a thing: first" in text
    script["example_globals"]["second"] = loom.render(ball, size=(80, 48))
    text = show(script, tmp_path)
    assert "images/2.png" in text and "images/1.png" not in text
    assert loom.read_color(tmp_path / "images" / "2.png").shape == (48, 80, 3)
    assert show(script, tmp_path) == ""


def test_a_recording_is_shown_without_its_player_and_gives_the_thumbnail(script, tmp_path):
    cloud = loom.PointCloud(np.random.default_rng(0).random((500, 3)))
    with loom.record(tmp_path / "a.html") as recorder:
        recorder.add("cloud", cloud)
        recorder.step("once")
    script["example_globals"] = {"page": tmp_path / "a.html", "recorder": recorder}
    text = show(script, tmp_path)
    assert 'src="../../_static/recordings/clouds_a_thing_1.html"' in text
    write_player(tmp_path / "made")
    shared = (tmp_path / "made" / "recordings" / "clouds_a_thing_1.html").read_text()
    assert 'src="../pointloom-player.js"' in shared
    assert loom.read_color(tmp_path / "images" / "1.png").min() < 250


def test_a_sections_page_becomes_a_part_of_the_gallerys():
    page = ":orphan:\n\nClouds\n======\n\nText.\n\n.. raw:: html\n\n  <div>\n\n.. toctree::\n   :hidden:\n\n   /a\n\n"
    assert galleries.thumbnails(page).strip() == "Clouds\n------\n\nText.\n\n.. raw:: html\n\n  <div>"

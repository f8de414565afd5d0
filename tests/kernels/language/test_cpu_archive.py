"""CPU kernels that were compiled ahead: used without compiling, or replaced by compiling."""

import hashlib
import json
import logging
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from pointloom.kernels.language import cpu_archive, cpu_code
from pointloom.kernels.language.pool_code import PoolCode

MODULES = ["pointloom.kernels.language.pool_code", "pointloom.kernels.arrays.bounds"]
SCRIPT = """
import logging, sys
logging.basicConfig(level=logging.INFO, format="%(message)s", stream=sys.stdout)
import numpy as np
from pointloom.kernels.arrays.bounds import find_box
from pointloom.kernels.language.pool_code import is_usable
from pointloom.kernels.memory import download, upload
from pointloom.kernels.lang import vec3
points = np.random.default_rng(0).random((5000, 3), np.float32)
print("box", download(find_box(upload(points, vec3, "cpu"))).tolist(), is_usable())
"""
POINTS = np.random.default_rng(0).random((5000, 3), np.float32)
BOX = f"box {[*POINTS.min(0).tolist(), *POINTS.max(0).tolist()]} True"
pytestmark = pytest.mark.skipif(not cpu_archive.level_of_processor(), reason="no Linux on x86-64-v2")


@pytest.fixture(scope="module")
def compiled(tmp_path_factory):
    folder = tmp_path_factory.mktemp("compiled")
    options = ["--output", str(folder), "--levels", cpu_archive.level_of_processor(), "--only", *MODULES]
    command = [sys.executable, "-m", "pointloom.kernels.cpu_kernels", *options]
    subprocess.run(command, check=True, stdout=subprocess.PIPE)
    return folder


@pytest.fixture
def archive(compiled, tmp_path):
    return Path(shutil.copytree(compiled, tmp_path / "compiled")) / cpu_archive.level_of_processor()


def run(archive: Path, home: Path) -> tuple[list[str], list[Path]]:
    """Lines of the script's output with an archive, and the files that it left in an empty home folder."""
    home.mkdir()
    settings = {cpu_archive.VARIABLE: str(archive.parent), "HOME": str(home), "XDG_CACHE_HOME": str(home / "cache")}
    command = [sys.executable, "-c", SCRIPT]
    done = subprocess.run(command, env=os.environ | settings, check=True, capture_output=True, text=True)
    assert done.stderr == ""
    return done.stdout.splitlines(), list(home.rglob("*"))


@pytest.mark.slow
def test_nothing_is_compiled_or_written(archive, tmp_path):
    assert run(archive, tmp_path / "home") == ([BOX], [])


DAMAGES = ["cut off", "flipped", "not JSON", "other kernels"]
PARTS = ["Warp", "flags", "header", "sources of kernels"]


def damage_code(archive: Path, damage: str) -> None:
    code, table = archive / "arrays.bounds.o", archive / "arrays.bounds.json"
    if damage in ("cut off", "flipped"):
        content = code.read_bytes()
        code.write_bytes(content[:-100] if damage == "cut off" else content[:-100] + bytes(100))
    else:
        table.write_text("{" if damage == "not JSON" else '{"sha256": ""}')


def change_manifest(archive: Path, name: str) -> None:
    manifest = archive / cpu_archive.MANIFEST
    manifest.write_text(json.dumps(json.loads(manifest.read_text()) | {name: "other"}))


@pytest.fixture
def stored(tmp_path, monkeypatch, caplog):
    """An archive with the entry of one kernel, whose machine code is not run, and the messages that it causes."""
    archive = tmp_path / "compiled" / cpu_archive.level_of_processor()
    archive.mkdir(parents=True)
    content = bytes(range(1, 201))
    (archive / "arrays.bounds.o").write_bytes(content)
    table = {"sha256": hashlib.sha256(content).hexdigest(), "kernels": {"a_kernel": [[], "a", "P", "symbol"]}}
    (archive / "arrays.bounds.json").write_text(json.dumps(table))
    (archive / cpu_archive.MANIFEST).write_text(json.dumps(cpu_archive.made_from()))
    monkeypatch.setenv(cpu_archive.VARIABLE, str(archive.parent))
    caplog.set_level(logging.INFO, "pointloom")

    def find():
        for cached in (cpu_archive._folder, cpu_archive._read):
            cached.cache_clear()
        caplog.clear()
        return cpu_archive.entry_of(MODULES[1], "a_kernel"), caplog.messages

    yield archive, find
    monkeypatch.undo()
    for cached in (cpu_archive._folder, cpu_archive._read):
        cached.cache_clear()


def test_the_entry_of_a_kernel_names_its_machine_code(stored):
    archive, find = stored
    assert find() == ([[], "a", "P", "symbol", str(archive / "arrays.bounds.o")], [])


@pytest.mark.parametrize("damage", DAMAGES)
def test_damaged_code_has_no_entry_and_one_log_record(stored, damage):
    archive, find = stored
    damage_code(archive, damage)
    entry, messages = find()
    assert entry is None and len(messages) == 1 and "damaged" in messages[0]


@pytest.mark.parametrize("name", PARTS)
def test_code_made_from_other_sources_has_no_entry(stored, name):
    archive, find = stored
    change_manifest(archive, name)
    entry, messages = find()
    assert entry is None and len(messages) == 1 and f"made from other {name}:" in messages[0]


@pytest.mark.slow
@pytest.mark.parametrize("damage", DAMAGES)
def test_damaged_code_is_compiled_with_one_log_record(archive, damage, tmp_path):
    damage_code(archive, damage)
    lines, files = run(archive, tmp_path / "home")
    assert ["damaged" in line for line in lines].count(True) == 1 and lines[-1] == BOX and files


@pytest.mark.slow
@pytest.mark.parametrize("name", PARTS)
def test_code_made_from_other_sources_is_not_used(archive, name, tmp_path):
    change_manifest(archive, name)
    lines, files = run(archive, tmp_path / "home")
    assert f"made from other {name}" in lines[0] and lines[-1] == BOX and files


@pytest.mark.parametrize(
    ("system", "machine", "features", "level"),
    [
        ("linux", "x86_64", cpu_archive.LEVELS["x86-64-v4"] | {"sse2"}, "x86-64-v4"),
        ("linux", "x86_64", cpu_archive.LEVELS["x86-64-v4"] - {"avx512vl"}, "x86-64-v3"),
        ("linux", "x86_64", cpu_archive.LEVELS["x86-64-v3"] - {"fma"}, "x86-64-v2"),
        ("linux", "x86_64", cpu_archive.LEVELS["x86-64-v2"] - {"popcnt"}, ""),
        ("linux", "x86_64", set(), ""),
        ("linux", "aarch64", cpu_archive.LEVELS["x86-64-v3"], ""),
        ("darwin", "x86_64", cpu_archive.LEVELS["x86-64-v3"], ""),
        ("win32", "AMD64", cpu_archive.LEVELS["x86-64-v3"], ""),
    ],
)
def test_the_level_follows_the_features_of_the_processor(system, machine, features, level, monkeypatch):
    monkeypatch.setattr(cpu_archive.sys, "platform", system)
    monkeypatch.setattr(cpu_archive.platform, "machine", lambda: machine)
    monkeypatch.setattr(cpu_archive, "_features", lambda: features)
    assert cpu_archive.level_of_processor() == level


@pytest.mark.parametrize("is_other", [False, True])
def test_code_for_another_processor_is_not_run(monkeypatch, is_other):
    """It may contain instructions that this processor lacks, such as those of AVX-512."""
    runs: list[int] = []
    monkeypatch.setattr(cpu_code, "FLAGS", cpu_code.FLAGS)
    monkeypatch.setattr(PoolCode, "_load", lambda *_: None)
    monkeypatch.setattr(PoolCode, "_compile", lambda code, *_: setattr(code, "_trial", lambda *_: runs.append(1)))
    if is_other:
        cpu_code.set_target("x86-64-v4")
        PoolCode()
    else:
        with pytest.raises(RuntimeError, match="part of a launch"):  # the code that ran has no effect
            PoolCode()
    assert len(runs) == (0 if is_other else 1)

"""Kernels compiled ahead: the selection for a GPU, the contents of the wheel, and interrupted builds."""

import base64
import hashlib
import importlib.metadata
import io
import json
import lzma
import os
import signal
import subprocess
import sys
import textwrap
import zipfile
from pathlib import Path
from types import SimpleNamespace

import pytest
import warp as wp

from pointloom.kernels import cuda_cache
from pointloom.kernels.language import compiled_ahead
from pointloom.kernels.language.compiled_ahead import choose

from ..sigint import sigint_enabled

SRC = str(Path(__file__).parents[2] / "src")
ALL = [f"sm{a}.cubin" for a in cuda_cache.ALL_ARCHITECTURES]
SELECT = "pointloom.kernels.arrays.select"


def gpu(architecture, output="ptx"):
    return SimpleNamespace(arch=architecture, get_cuda_output_format=lambda: output)


@pytest.mark.parametrize(
    ("binaries", "architecture", "chosen"),
    [
        (ALL, gpu(90), "sm90.cubin"), (ALL, gpu(75), "sm75.cubin"),
        (ALL, gpu(103), "sm100.cubin"), (ALL, gpu(121), "sm120.cubin"),  # a later one of the same generation
        (["sm80.cubin", "sm86.cubin"], gpu(89), "sm86.cubin"),
        (["sm89.cubin"], gpu(86), None),  # an earlier one
        (ALL, gpu(70), None),
        (ALL, gpu(110), None),  # a generation that is not there
        (ALL, gpu(87), None),  # boards are another kind
        (["sm87.cubin"], gpu(87), "sm87.cubin"),
        (["sm75.cubin", "sm75.ptx"], gpu(110), "sm75.ptx"),
        (["sm75.cubin", "sm75.ptx"], gpu(110, "cubin"), None),  # a driver older than the compiler of the PTX
        (["sm120.ptx"], gpu(90), None), (["sm75.ptx", "sm90.ptx"], gpu(100), "sm90.ptx"),
        (["sm90.ptx", "sm90.cubin"], gpu(90), "sm90.cubin"), ([], gpu(90), None),
    ],
)  # fmt: skip
def test_a_gpu_gets_code_that_it_runs_or_none(binaries, architecture, chosen):
    assert choose(binaries, architecture) == chosen


@pytest.mark.parametrize("manifest", [[], {"made from": 1, "architectures": [], "modules": {}}, {"made from": {}}])
def test_a_damaged_archive_is_not_used_and_doctor_names_it(manifest, tmp_path, monkeypatch):
    path = tmp_path / "kernels.zip"
    with zipfile.ZipFile(path, "w") as file:
        file.writestr("manifest.json", json.dumps(manifest))
    monkeypatch.setenv(compiled_ahead.VARIABLE, str(path))
    monkeypatch.setattr(compiled_ahead, "_Search", type("_Search", (), {"done": False, "result": None}))
    assert compiled_ahead.described().startswith(f"none: {path}: cannot be read")


@pytest.fixture
def built():
    code = cuda_cache.Code(7, lzma.compress(b"machine"), 1.5)
    codes, meta = {"sm90.cubin": code, "sm100.cubin": code}, {"copy_kernel_smem_bytes": 0}
    return [cuda_cache.Built("pointloom.kernels.made_up", "ab" * 32, 3, meta, codes)]


def test_an_archive_lists_its_sources_and_is_reproducible(built, tmp_path):
    content = cuda_cache.archive_of(built)
    assert cuda_cache.archive_of(list(reversed(built))) == content
    path = tmp_path / "kernels.zip"
    path.write_bytes(content)
    archive = compiled_ahead.Archive(path)
    assert archive.mismatch() == ""
    assert archive.architectures == ["sm90.cubin", "sm100.cubin"]
    assert archive.modules["ab" * 32]["name"] == "pointloom.kernels.made_up"


def test_the_wheel_records_its_files_and_requires_the_same_versions(built):
    version = importlib.metadata.version("pointloom")
    name, content = cuda_cache.wheel_of(cuda_cache.archive_of(built), version)
    assert name == f"pointloom_cuda_kernels-{version}-py3-none-any.whl"
    with zipfile.ZipFile(io.BytesIO(content)) as wheel:
        info = f"pointloom_cuda_kernels-{version}.dist-info"
        metadata = wheel.read(f"{info}/METADATA").decode()
        recorded = [line.split(",") for line in wheel.read(f"{info}/RECORD").decode().splitlines()]
        assert {line[0] for line in recorded} == set(wheel.namelist())
        for path, digest, size in recorded[:-1]:
            data = wheel.read(path)
            encoded = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            assert (f"sha256={encoded}", str(len(data))) == (digest, size)
    assert f"Requires-Dist: pointloom=={version}\n" in metadata
    assert f"Requires-Dist: warp-lang=={wp.__version__}\n" in metadata


COMPILE_FAR_CONSTANTS = """
import hashlib, sys
from pathlib import Path
from pointloom.kernels import cuda_cache
import far_constants
import warp as wp

wp.config.kernel_cache_dir = sys.argv[1]
module = wp.get_module(far_constants.far_kernel.cuda.module.name)
built = cuda_cache._compile(module, Path(sys.argv[1]), [(90, True)])
print(built.key, hashlib.sha256(built.code["sm90.ptx"].packed).hexdigest())
"""


@pytest.mark.slow
def test_a_constant_outside_the_hash_of_warp_is_recompiled(tmp_path):
    """Warp's hash counts the low 32 bits of a whole number, so both modules have one folder."""
    source = """
        from pointloom.kernels.lang import *

        FAR = {value}

        @kernel
        def far_kernel(out: array(dtype=int64)):
            i = tid()
            out[i] = int64(FAR)
        """
    (tmp_path / "kept").mkdir()
    keys, texts = [], []
    environment = os.environ | {"PYTHONPATH": f"{SRC}:{tmp_path}"}
    for value in (2**40 + 1, 2**50 + 1):  # of different lengths: Python keeps bytecode by a file's size and second
        (tmp_path / "far_constants.py").write_text(textwrap.dedent(source.format(value=value)))
        # a process each: within one, Warp takes the first kernel for both for as long as it is not collected
        program = [sys.executable, "-c", COMPILE_FAR_CONSTANTS, str(tmp_path / "kept")]
        done = subprocess.run(program, env=environment, check=True, stdout=subprocess.PIPE, text=True)
        keys.append(done.stdout.split()[0])
        texts.append(done.stdout.split()[1])
    assert keys[0] == keys[1], "else the folder need not be looked at"
    assert texts[0] != texts[1]


def command(folder, *options):
    folders = ["--work", str(folder / "work"), "--output", str(folder / "dist")]
    program = [sys.executable, "-m", "pointloom.kernels.cuda_cache", *folders, *options]
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    with sigint_enabled():
        return subprocess.Popen(program, env=os.environ | {"PYTHONPATH": SRC}, **pipes)


@pytest.mark.slow
def test_an_interrupted_build_writes_nothing_and_can_be_continued(tmp_path):
    build = command(tmp_path, "--architectures", "90", "--only", SELECT, "pointloom.kernels.surface.normals")
    assert build.stdout.readline().startswith("[1/2] ")
    build.send_signal(signal.SIGINT)
    _, errors = build.communicate(timeout=120)
    assert (build.returncode, errors) == (130, "interrupted: what is compiled is kept, run it again to go on\n")
    assert list((tmp_path / "dist").iterdir()) == []
    (cubin,) = (tmp_path / "work").glob(f"wp_{SELECT}_*/*.cubin")
    written = cubin.stat().st_mtime_ns
    again = command(tmp_path, "--architectures", "90", "--only", SELECT)
    output, errors = again.communicate(timeout=120)
    assert (again.returncode, errors) == (0, "")
    assert cubin.stat().st_mtime_ns == written
    (archive,) = (tmp_path / "dist").glob("*.zip")
    with zipfile.ZipFile(archive) as file:
        (module,) = json.loads(file.read("manifest.json"))["modules"].values()
    assert module["name"] == SELECT and "sm90.cubin" in output


@pytest.mark.parametrize(
    ("options", "message"),
    [(["--architectures", "33"], "does not compile for sm_33"), (["--architectures"], "no architecture")],
)
def test_an_architecture_that_is_none_is_refused_by_name(capsys, options, message):
    with pytest.raises(SystemExit):
        cuda_cache.main(options)
    assert message in capsys.readouterr().err


@pytest.mark.parametrize("name", ["pointloom.kernels.not_there", "kernels.arrays", "pointloom.kernels.arrays"])
def test_a_name_that_is_no_file_of_kernels_is_refused_and_nothing_is_written(name, tmp_path, capsys):
    folders = ["--work", str(tmp_path / "work"), "--output", str(tmp_path / "dist")]
    assert cuda_cache.main([*folders, "--architectures", "90", "--only", SELECT, name]) == 1
    assert capsys.readouterr().err.startswith(f"--only: {name}: no file of kernels")
    assert not (tmp_path / "dist").exists()

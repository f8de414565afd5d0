"""The command line: imports, exit codes, stdout, stderr and files."""

import ctypes
import json
import os
import re
import signal
import subprocess
import sys
import warnings
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom
from pointloom.cli.jobs.clouds import ConvertReport
from pointloom.cli.jobs.job import Done
from pointloom.cli.shell import doctor
from pointloom.cli.shell.cli import cli
from pointloom.core import cuda_driver, verbosity
from pointloom.core.threads import get_num_threads
from pointloom.core.wording import format_bytes
from pointloom.io.images.image_files import write_png
from pointloom.io.points import ply
from pointloom.kernels.language import cpu_archive
from pointloom.kernels.language.environment import setting

from ..sigint import sigint_enabled
from .commands import answer, names_in, output_of, refusal, run, unreliable

ROOT = Path(__file__).resolve().parents[2]
COMMANDS = (
    "change", "clean", "clean-mesh", "cluster", "compare-meshes", "completion", "contours", "convert", "crop",
    "demo", "depth", "docs", "doctor", "downsample", "dtm", "evaluate", "fuse", "ground", "info", "map", "merge",
    "mesh", "multiway", "normals", "odometry", "plane", "reconstruct", "register", "sample-mesh", "simplify",
    "smooth-mesh", "split", "stations", "texture", "tile", "track", "transform", "video", "view", "volume",
)  # fmt: skip


def start(program: str, *words: object) -> subprocess.Popen:
    setup = f"import sys; sys.path[:0] = [{str(ROOT / 'src')!r}]; sys.argv[1:] = {[str(word) for word in words]!r}\n"
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    with sigint_enabled():
        return subprocess.Popen([sys.executable, "-c", setup + program], **pipes)


def test_help_imports_no_heavy_packages():
    program = f"""
import json
from pointloom.cli.shell.cli import cli
for words in ([], *([name] for name in {COMMANDS!r})):
    try:
        cli.main([*words, "--help"])
    except SystemExit as stop:
        assert not stop.code
heavy = {{"numpy", "scipy", "warp", "taichi", "PIL", "rich"}}
print(json.dumps(sorted(heavy & {{name.partition(".")[0] for name in sys.modules}})), file=sys.stderr)
"""
    process = start(program)
    stdout, stderr = process.communicate(timeout=300)
    assert process.returncode == 0, stderr
    assert json.loads(stderr) == [] and stdout.count("Usage: pointloom") == 1 + len(COMMANDS)


def test_every_command_has_help_and_accepts_json():
    assert sorted(cli.commands) == sorted(COMMANDS)
    result = run()
    assert (result.exit_code, "Commands:" in result.stdout, result.stderr) == (0, True, "")
    assert run("--version").stdout.split()[-1] == loom.__version__
    listing = run("--help").stdout
    for name in COMMANDS:
        assert f"  {name} " in listing
        printed = run(name, "-h").stdout
        assert "--json" in printed and printed.isascii()
        assert f"\n  pointloom {name}" in printed  # an example


def test_every_command_with_an_output_has_the_option_o():
    for name, command in cli.commands.items():
        if any(one.name in ("output", "named_output") for one in command.params):
            assert any({"-o", "--output"} <= set(one.opts) for one in command.params), name


def test_a_damaged_frame_is_named_and_nothing_is_written(frames, tmp_path):
    for name, content, location in (
        ("frame-000004.depth.png", b"\x89PNG\r\n\x1a\n", "frame-000004.depth.png (byte"),
        ("frame-000002.pose.txt", b"2 0 0 0\n0 2 0 0\n0 0 2 0\n0 0 0 1\n", "frame-000002.pose.txt (line 1)"),
        ("frame-000001.pose.txt", None, "frame-000001.pose.txt"),
    ):
        (frames / name).unlink()
        if content is not None:
            (frames / name).write_bytes(content)
        message = refusal("fuse", frames, "-o", tmp_path / "out.ply", "--voxel", "0.1")
        assert message.startswith("error: ") and location in message and names_in(tmp_path) == ["frames"]


def test_fuse_rejects_invalid_options(frames, tmp_path):
    for options, reason in (
        ("--layout tum", "depth.txt: missing"),
        ("--layout redwood", "missing"),
        ("--device cuda:99", "got 'cuda:99'"),
        ("--intrinsic camera.json", "camera.json"),
        ("--voxel 0.1 --truncation 0.01", "truncation"),
        ("--picture out.jpg", "ends in .png"),
    ):
        assert reason in refusal("fuse", frames, "-o", tmp_path / "out.ply", *options.split())
    assert names_in(tmp_path) == ["frames"]


def test_existing_outputs_are_not_overwritten_without_force(scene, mesh, frames, tmp_path):
    output = tmp_path / "out.ply"
    commands = (
        *(["convert", scene], ["downsample", scene, "--voxel", 0.5], ["normals", scene], ["clean", scene]),
        *(["cluster", scene, "--radius", 0.2], ["plane", scene, "--distance", 0.01], ["clean-mesh", mesh]),
        *(["crop", scene, "--box", 0, 0, 0, 1, 1, 1], ["fuse", frames, "--voxel", 0.1]),
    )
    for words in commands:
        output.write_bytes(b"kept")
        refused = refusal(*words, "-o", output)
        assert "out.ply: exists already" in refused and "overwrite" not in refused
        assert "Give another name, or --force to replace it" in refused and output.read_bytes() == b"kept"
        output_of(*words, "-o", output, "--force")
        assert output.read_bytes().startswith(b"ply")


def test_an_unwritable_output_is_rejected_before_the_input_is_read(cloud, tmp_path, monkeypatch):
    assert "Make the folder first" in run("convert", "missing.ply", tmp_path / "no" / "out.ply").stderr
    monkeypatch.setattr("os.access", lambda *_: False)
    result = run("convert", "missing.ply", tmp_path / "out.ply")
    assert result.exit_code == 1 and "is not writable" in result.stderr


def test_errors_with_json_are_one_object():
    for words, code in ((["downsample", "no.ply", "out.ply", "--voxel", "1"], 1), (["fuse", "--every", "x"], 2)):
        result = run(*words, "--json")
        assert result.exit_code == code
        report = json.loads(result.stdout)
        assert report["exit_code"] == code and f"error: {report['error']}" in result.stderr


def fault(error):
    def raise_it(*_args, **_options):
        raise error

    return raise_it


@pytest.mark.parametrize(
    ("error", "message"),
    [
        (IndexError("list index"), "error: unexpected IndexError: list index. This is a bug in pointloom"),
        (MemoryError(), "error: out of memory. A larger --voxel"),
        (OSError(28, "No space left on device", "out.ply"), "error: out.ply: No space left on device"),
        (ValueError("voxel_size: too small"), "error: voxel_size: too small"),
        (RuntimeError("POINTLOOM_CPU: expected warp or taichi"), "error: POINTLOOM_CPU: expected"),
    ],
)
def test_every_exception_is_reported_in_one_line(error, message, monkeypatch):
    monkeypatch.setattr("pointloom.cli.jobs.clouds.convert_file", fault(error))
    monkeypatch.delenv("POINTLOOM_TRACEBACK", raising=False)
    result = run("convert", "a.ply", "b.ply")
    assert result.exit_code == 1 and result.stderr.startswith(message) and len(result.stderr.splitlines()) == 1


WRONG = {
    "POINTLOOM_VERBOSITY": ("quiet", "error, warning, info or debug"),
    "POINTLOOM_CPU_THREADS": ("abc", "a whole number from 1 to 1024"),
    "POINTLOOM_CPU": ("gcc", "warp or taichi"),
    "POINTLOOM_DRAW": ("file", "page or picture"),
    "POINTLOOM_INLINE": ("yes", "0 or 1"),
    "POINTLOOM_TRACEBACK": ("no", "0 or 1"),
}


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_environment_variable_ends_a_command_and_its_first_use(name, monkeypatch):
    value, expected = WRONG[name]
    monkeypatch.setenv(name, value)
    message = f"{name}: expected {expected}, got {value!r}. Change or unset the variable"
    result = run("info", "a.ply")
    assert (result.exit_code, result.stderr) == (1, f"error: {message}\n")
    with pytest.raises(ValueError, match=re.escape(message)):
        setting(name)
    monkeypatch.setenv(name, "")
    assert setting(name) == "" and "a.ply" in run("info", "a.ply").stderr


def test_a_wrong_verbosity_is_an_error_at_import(monkeypatch):
    monkeypatch.setenv("POINTLOOM_VERBOSITY", "quiet")
    with pytest.raises(ValueError, match="POINTLOOM_VERBOSITY: expected error, warning, info or debug, got 'quiet'"):
        verbosity.start()
    monkeypatch.setenv("POINTLOOM_VERBOSITY", "Warning")
    verbosity.start()


def test_a_missing_folder_of_compiled_kernels_is_an_error(monkeypatch, tmp_path):
    monkeypatch.setenv("POINTLOOM_CPU_KERNELS", str(tmp_path / "none"))
    with pytest.raises(ValueError, match="POINTLOOM_CPU_KERNELS: expected an existing folder, got"):
        cpu_archive.folder()
    monkeypatch.setenv("POINTLOOM_CPU_KERNELS", "")
    assert cpu_archive.folder() is None


@pytest.mark.parametrize("name", WRONG)
def test_variables_with_few_values_are_read_in_one_place(name):
    reads = re.compile(rf"""environ(\.get\(|\[)["']{name}["']""")
    files = [path for path in (ROOT / "src").rglob("*.py") if reads.search(path.read_text(encoding="utf-8"))]
    assert files == []


def test_the_traceback_is_printed_on_request(monkeypatch):
    monkeypatch.setattr("pointloom.cli.jobs.clouds.convert_file", fault(IndexError("list index")))
    monkeypatch.setenv("POINTLOOM_TRACEBACK", "1")
    result = run("convert", "a.ply", "b.ply")
    assert "Traceback (most recent call last)" in result.stderr and "raise_it" in result.stderr


def test_a_warning_is_one_line_on_stderr(cloud, tmp_path, monkeypatch):
    def warn(*_args, **_options):
        with warnings.catch_warnings(action="always"):
            warnings.warn("one core only", RuntimeWarning, stacklevel=1)
        return ConvertReport(Done("convert", "a.ply", {}, (), (), ()), "mesh", 0, 0)

    monkeypatch.setattr("pointloom.cli.jobs.clouds.convert_file", warn)
    result = run("convert", cloud, tmp_path / "out.ply", "--json")
    assert result.stderr == "warning: one core only\n" and json.loads(result.stdout)["reliable"]
    assert run("convert", cloud, tmp_path / "out.ply", "-q").stderr == ""


def test_an_interruption_while_writing_leaves_nothing(cloud, tmp_path, monkeypatch):
    before = names_in(tmp_path)
    monkeypatch.setattr(ply, "_write_columns", fault(KeyboardInterrupt()))
    result = run("convert", cloud, tmp_path / "out.ply")
    assert result.exit_code == 130 and result.stderr.split() == ["interrupted"] and names_in(tmp_path) == before


@pytest.mark.slow
@pytest.mark.parametrize(("number", "code"), [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_a_signal_while_writing_leaves_nothing(cloud, tmp_path, number, code):
    before = names_in(tmp_path)
    program = """
import time
from pointloom.cli.shell.cli import main
from pointloom.io.points import ply
from pointloom.kernels.language import cpu_archive
from pointloom.kernels.language.environment import setting
from pointloom.io.images.image_files import write_png
def stall(*_args, **_options):
    print("writing", file=sys.stderr, flush=True)
    time.sleep(60)
ply._write_columns = stall
main()
"""
    process = start(program, "convert", cloud, tmp_path / "out.ply")
    with process:
        assert process.stderr.readline() == "writing\n"
        assert len(names_in(tmp_path)) == len(before) + 1  # the part under its temporary name
        process.send_signal(number)
        stdout, stderr = process.communicate(timeout=300)
    assert process.returncode == code and stdout == "" and "Traceback" not in stderr and names_in(tmp_path) == before


def test_ctrl_c_while_the_command_is_loaded_is_one_line(tmp_path):
    (tmp_path / "click.py").write_text("import sys, time\nprint('loading', flush=True)\ntime.sleep(60)\n")
    program = f"""
sys.path.insert(0, {str(tmp_path)!r})
import runpy
runpy.run_module("pointloom", run_name="__main__", alter_sys=True)
"""
    process = start(program, "--version")
    with process:
        assert process.stdout.readline() == "loading\n"
        process.send_signal(signal.SIGINT)
        _, stderr = process.communicate(timeout=300)
    assert (process.returncode, stderr) == (130, "interrupted\n")


def test_ctrl_c_between_commands_of_click_is_one_line():
    program = """
from pointloom.cli.shell import cli, group
def interrupt(*_args, **_options):
    raise KeyboardInterrupt
group.Notices.__enter__ = interrupt
cli.main()
"""
    process = start(program, "--version")
    _, stderr = process.communicate(timeout=300)
    assert (process.returncode, stderr) == (130, "interrupted\n")


def test_fuse_reports_the_camera(frames, tmp_path):
    words = ["fuse", frames, "--voxel", "0.1", "-o", tmp_path / "out.ply", "--force"]
    report = answer(*words)["camera"]
    K = np.reshape(json.loads((frames / "camera-intrinsics.json").read_text())["intrinsic_matrix"], (3, 3)).T
    assert [report[name] for name in ("fx", "fy", "cx", "cy")] == [K[0, 0], K[1, 1], K[0, 2], K[1, 2]]
    assert report["source"] == "camera-intrinsics.json"
    other = tmp_path / "other.json"
    (frames / "camera-intrinsics.json").rename(other)
    assert answer(*words, "--intrinsic", other)["camera"]["source"] == str(other)
    np.savetxt(frames / "intrinsics.K.txt", K)
    assert f"from {frames / 'intrinsics.K.txt'}" in output_of(*words)


def test_a_camera_that_contradicts_the_images_is_unreliable(frames, tmp_path):
    (frames / "camera-intrinsics.json").unlink()
    (frames / "intrinsics.K.txt").write_text("525 0 320\n0 525 240\n0 0 1\n")  # of 640 x 480; these are 160 x 120
    message = "; ".join(unreliable("fuse", frames, "--voxel", "0.1", "-o", tmp_path / "out.ply")["warnings"])
    assert f"the camera may be wrong ({frames / 'intrinsics.K.txt'}): its principal point (320, 240) is far" in message
    assert "images of 160 x 120; it may be for 640 x 480" in message


def test_fuse_reports_unmatched_frames(tmp_path):
    folder = tmp_path / "tum"
    (folder / "depth").mkdir(parents=True)
    for time in (1, 2, 3):
        write_png(folder / "depth" / f"{time}.png", np.full((480, 640), 5000, np.uint16))
    (folder / "depth.txt").write_text("".join(f"{time} depth/{time}.png\n" for time in (1, 2, 3)))
    (folder / "groundtruth.txt").write_text("".join(f"{time} 0 0 0 0 0 0 1\n" for time in (1, 3)))
    result = run("fuse", folder, "-o", tmp_path / "out.ply", "--voxel", "0.05")
    assert "1 left out, the first depth/2.png: no pose within 0.02 s" in result.stdout
    assert result.exit_code == 3 and "the camera may be wrong (the default of tum)" in result.stderr


def test_doctor_runs_a_kernel_and_reports_the_number_of_threads(monkeypatch):
    monkeypatch.setenv("POINTLOOM_CPU_THREADS", "3")
    loom.set_num_threads(None)
    report = answer("doctor")
    assert [t["ok"] for t in report["trials"] if t["device"] == "cpu"] == [True]
    assert (report["cpu_compiler"], report["why"]) == ("warp", "3 threads (POINTLOOM_CPU_THREADS)")
    assert report["reliable"] and "healthy" in run("doctor").stdout
    monkeypatch.delenv("POINTLOOM_CPU_THREADS")
    loom.set_num_threads(None)
    count = get_num_threads()
    assert answer("doctor")["why"] == ("1 thread" if count == 1 else f"{count} threads")
    monkeypatch.setenv("POINTLOOM_CPU_THREADS", "many")
    loom.set_num_threads(None)
    expected = "CPU kernels do not run: POINTLOOM_CPU_THREADS: expected a whole number"
    assert expected in "; ".join(unreliable("doctor")["warnings"])
    monkeypatch.delenv("POINTLOOM_CPU_THREADS")
    monkeypatch.setattr(doctor, "get_num_threads", lambda: 1)
    monkeypatch.setattr(doctor, "sys", SimpleNamespace(platform="darwin"))
    expected = "1 thread, since more are not tested on this system; set POINTLOOM_CPU_THREADS to use more"
    assert answer("doctor")["why"] == expected


def test_doctor_explains_a_warp_limited_to_one_core(monkeypatch):
    monkeypatch.setattr(doctor, "pool_code", SimpleNamespace(is_usable=lambda: False))
    result = run("doctor")
    assert result.exit_code == 3 and "warp: one core only, since Warp" in result.stdout
    assert "does not support cpu_access.h; install the tested version: pip install warp-lang==1.19.0" in result.stderr


def test_doctor_names_packages_newer_than_the_tested_ones(monkeypatch):
    assert not answer("doctor")["untested"] and "untested" not in run("doctor").stdout
    versions = {"pointloom": "0.1.0", "numpy": "2.99.1", "scipy": "1.11.0", "warp-lang": "2.0.0rc1"}
    monkeypatch.setattr(doctor, "_versions", lambda: versions)
    assert answer("doctor")["untested"] == ["numpy 2.99.1", "warp-lang 2.0.0rc1"]
    assert "numpy 2.99.1, warp-lang 2.0.0rc1: newer than the tested versions" in output_of("doctor")


def test_doctor_reports_an_outdated_driver(monkeypatch, tmp_path):
    (tmp_path / "version").write_text("NVRM version: NVIDIA UNIX x86_64 Kernel Module  470.57.02  Tue Jul 13\n")
    monkeypatch.setattr(cuda_driver, "PROC", tmp_path / "version")
    monkeypatch.setattr(doctor, "_gpus", list)
    result = run("doctor")
    assert result.exit_code == 3 and "no GPU is usable: driver 470.57.02 is too old; Warp" in result.stderr
    assert "driver       470.57.02, needed for GPUs: " in result.stdout


@pytest.mark.parametrize(("count", "shown"), [(0, "0 B"), (1023, "1023 B"), (1024, "1.0 KiB"), (3 << 19, "1.5 MiB")])
def test_memory_sizes_use_binary_units(count, shown):
    assert format_bytes(count) == shown


def test_doctor_reports_the_memory_of_the_machine_on_windows(monkeypatch):
    """MEMORYSTATUSEX has 64 bytes, the first 4 its size; the memory is at byte 8."""
    assert doctor._memory_bytes() == os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")

    def fill(status):
        assert bytes(status._obj)[:8] == b"\x40" + bytes(7)
        ctypes.memmove(ctypes.byref(status._obj, 8), (5 << 30).to_bytes(8, "little"), 8)

    libraries = {"kernel32": SimpleNamespace(GlobalMemoryStatusEx=fill)}
    monkeypatch.setattr(ctypes, "WinDLL", libraries.__getitem__, raising=False)
    monkeypatch.setattr(doctor, "sys", SimpleNamespace(platform="win32"))
    monkeypatch.delattr(os, "sysconf")
    assert doctor._memory_bytes() == 5 << 30

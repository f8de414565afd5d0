"""`pointloom video --control`: early rejection, report, and resumed runs."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.photogrammetry.video import motion

from ...cli.commands import answer, refusal, run, unreliable
from .test_video_command import output

__all__ = ["output"]

POSITIONS = np.array(
    [[0.5, 0.2, 4.0], [1.5, -1.1, 5.0], [2.5, 0.2, 4.5], [3.0, -0.8, 6.0], [1.0, -0.5, 3.5], [2, 0, 3]]
)


@pytest.fixture
def pictured(quick, film, tmp_path, monkeypatch):
    """The fast stages with pictures of the size of the lens, and control in a frame twice as large."""
    from PIL import Image

    from pointloom.photogrammetry.video import chain

    make = chain.STAGES["frames"]

    def take_frames(folder, report, *, source, max_frames):
        contents = make(folder, report, source=source, max_frames=max_frames)
        for path in (folder / motion.PICTURES).iterdir():
            Image.new("RGB", (64, 48)).save(path)
        return contents

    monkeypatch.setitem(chain.STAGES, "frames", take_frames)
    camera = loom.CameraModel("PINHOLE", 64, 48, [50, 50, 32, 24])
    lines = ["local"]
    for name, position in zip("ABCDEF", POSITIONS, strict=True):
        for k in range(8):
            center = np.array([0.5 * k, -(1.0 - k % 2), 0.0])  # of the poses of the fast stage `model`
            pixel = camera.project((position - center)[None])[0] + 0.5
            if (pixel > 0).all() and (pixel < (64, 48)).all():
                lines.append(" ".join(f"{value:.6f}" for value in (*(2 * position), *pixel)) + f" {10 * k} {name}")
    path = tmp_path / "gcp.txt"
    path.write_text("\n".join(lines))
    return path


def test_control_is_reported_and_remakes_only_the_mesh(pictured, quick, film, output, tmp_path):
    args = ("video", film, "-o", output, "--work", tmp_path / "work", "--force")
    answer(*args)
    quick.ran.clear()
    report = answer(*args[:-1], "--force", "--resume", "--control", pictured)
    assert quick.ran == ["mesh"]
    assert (report["fit"]["by"], report["units"], report["reliable"]) == ("control", "meters", True)
    assert abs(report["fit"]["scale"] - 2) < 1e-4 and len(report["fit"]["control"]["points"]) == 6
    assert report["fit"]["control"]["control_rms_m"] < 1e-4
    quick.ran.clear()
    pictured.write_text(pictured.read_text().replace(" E", " CHK-E"))
    result = run(*args[:-1], "--force", "--resume", "--control", pictured)
    assert quick.ran == ["mesh"] and "5 control points" in result.stdout and "1 check point" in result.stdout


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (lambda text: text.replace(" 10 A", " 11 A"), "'11' matches no image"),
        (lambda text: text + "\n1 2 9 70 20 30 G", "outside of 30 of 64 x 48"),
    ],
)
def test_impossible_marks_are_rejected_early(pictured, quick, film, output, change, reason):
    pictured.write_text(change(pictured.read_text()))
    message = refusal("video", film, "-o", output, "--control", pictured)
    assert reason in message and "gcp.txt (line " in message
    assert quick.ran == ["frames"]


def test_a_blunder_has_exit_code_3_and_its_name(pictured, film, output):
    text = pictured.read_text()
    first = next(line for line in text.splitlines() if line.endswith(" C"))
    coordinates = " ".join(first.split()[:3])
    pictured.write_text(text.replace(coordinates, f"{float(first.split()[0]) + 40} {' '.join(first.split()[1:3])}"))
    assert "C by 40" in str(unreliable("video", film, "-o", output, "--control", pictured)["warnings"])


def test_scale_bars_alone_set_the_size(pictured, film, output, tmp_path):
    bars = tmp_path / "bars.txt"
    marks = [line.split() for line in pictured.read_text().splitlines()[1:]]
    length = 2 * np.linalg.norm(POSITIONS[0] - POSITIONS[3])
    bars.write_text("\n".join([*(f"mark {w[6]} {w[5]} {w[3]} {w[4]}" for w in marks), f"bar A D {length}"]))
    report = answer("video", film, "-o", output, "--scale-bars", bars)
    assert report["fit"]["by"] == "scale_bars" and abs(report["fit"]["scale"] - 2) < 1e-3

"""Reliability of structure from motion along facades whose windows repeat.

    python benchmarks/trust/facades.py [choosing]       the held-out facades, or those that chose constants, as rows

A model is wrong if fewer than 60 % of the images are registered, if a camera center is off by more than 0.3 periods
after the best similarity, or if the directions are off by more than 5 degrees (mean). The camera is given, so that only
its poses are unknown.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterable, Iterator
from pathlib import Path

import facade_scenes as scenes
from judged import Case, Judged, rates, table
from sfm_accuracy import camera_errors

import pointloom as loom

AREA = "facades, held out"
CHOOSING, HELD_OUT = range(48), range(1000, 1120)  # seeds: all constants of the check were chosen on the first
WRONG_PERIODS, WRONG_DEGREES, MIN_REGISTERED = 0.3, 5.0, 0.6
FEATURES = 500


def judge_seed(seed: int) -> Judged:
    """Create the images of a facade, reconstruct them, and compare with the ground truth."""
    facade = scenes.facade(seed)
    camera = loom.PinholeCameraIntrinsic(
        *scenes.SIZE, scenes.FOCAL, scenes.FOCAL, scenes.SIZE[0] / 2, scenes.SIZE[1] / 2
    )
    with tempfile.TemporaryDirectory() as name:
        images = Path(name) / "images"
        truth = {each: pose for each, (pose, _) in scenes.render(facade).write(images).items()}
        result = loom.photogrammetry.reconstruct_images(
            images, Path(name) / "work", loom.photogrammetry.SfmSettings(intrinsic=camera, max_features=FEATURES)
        )
    return judged(facade, result.model, truth, result.warnings, held_out=seed in HELD_OUT)


def judged(
    facade: scenes.Facade, model: loom.SfmModel | None, truth: dict, warnings: tuple, *, held_out: bool
) -> Judged:
    """Compare a model with the ground truth."""
    wrong, error = True, f"{0 if model is None else len(model)} of {len(truth)} placed"
    if model is not None and len(model) >= MIN_REGISTERED * len(truth):
        errors = camera_errors(model, {name: truth[name] for name in model.names})
        periods, degrees = errors["worst"] / facade.period[0], errors["mean_degrees"]
        wrong = periods > WRONG_PERIODS or degrees > WRONG_DEGREES
        error = f"{periods:.2f} periods, {degrees:.1f} degrees"
    accepted = not warnings
    return Judged(
        AREA,
        facade.name,
        1,
        wrong,
        wrong and accepted,
        not wrong and not accepted,
        "; ".join(warnings),
        error,
        "",
        held_out,
    )


def cases(seeds: Iterable[int] = HELD_OUT) -> Iterator[Case]:
    for seed in seeds:
        yield Case(scenes.facade(seed).name, lambda seed=seed: [judge_seed(seed)])


def main() -> None:
    print(*table([])[:2], sep="\n", flush=True)
    judged_cases = []
    for case in cases(CHOOSING if "choosing" in sys.argv[1:] else HELD_OUT):
        judged_cases += case.judge()
        print(table(judged_cases)[-1], flush=True)
    print("\n".join(rates(judged_cases)))


if __name__ == "__main__":
    main()

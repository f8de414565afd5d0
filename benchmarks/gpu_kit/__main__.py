"""Run all measurements that need a GPU: python benchmarks/gpu_kit [--seconds N] [--dry].

    make gpu-run                                  all steps of steps.py; the next run continues
    make gpu-run ARGS="--run 1 --seconds 600"     the steps of the first run, within ten minutes
    make gpu-run ARGS="--steps profile --again profile"
    make gpu-run ARGS=--dry                       the same on the emulated device, small, without results
    make gpu-run ARGS="--take call4.tar.gz"       import the results of a machine that ran call.sh

Results are written to benchmarks/results/gpu-run-CHIP-DATE-COMMIT.json.
"""

from __future__ import annotations

import argparse
import shutil
import sys
import tarfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from gpu_kit.device import ROOT, EmulatedDeviceError
from gpu_kit.documents import keep
from gpu_kit.runner import Run
from gpu_kit.steps import RUNS, STEPS, steps_of

HOUR = 3600.0


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="make gpu-run", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    names = [step.name for step in STEPS]
    parser.add_argument("--seconds", type=float, default=HOUR, metavar="N", help="total time limit (default: one hour)")
    parser.add_argument(
        "--steps", nargs="+", choices=names, default=names, metavar="STEP", help=f"of {', '.join(names)}"
    )
    parser.add_argument("--run", type=int, choices=RUNS, help="only the steps of a run of 900 s (README.md)")
    parser.add_argument("--again", nargs="+", choices=names, default=[], metavar="STEP", help="steps to run again")
    parser.add_argument("--state", type=Path, help="folder for marks, logs and parts (build/gpu-run)")
    parser.add_argument("--dry", action="store_true", help="test the kit on the emulated device")
    parser.add_argument("--pieces", nargs="*", metavar="PIECE", help="archives that are available; for call.sh")
    parser.add_argument("--no-keep", action="store_true", help="write no results: they are imported on another machine")
    parser.add_argument("--take", nargs="+", type=Path, metavar="FILE", help="run nothing: import returned archives")
    return parser.parse_args()


def main() -> int:
    """Run the steps. Returns the exit code: 1 if a step failed."""
    options = _options()
    state = options.state or ROOT / "build" / ("gpu-run-dry" if options.dry else "gpu-run")
    if options.take:
        _unpack(options.take, state)
        return _conclude(state)
    if options.dry and options.state is None:
        shutil.rmtree(state, ignore_errors=True)
    run = Run(state, options.seconds, dry=options.dry)
    for step in STEPS:
        if step.name in options.again:
            run.forget(step)
    steps = [step for step in (steps_of(options.run) if options.run else STEPS) if step.name in options.steps]
    failed = run.all(steps, options.pieces)
    if options.dry:
        return 1 if failed else _conclude_dry(state)
    if not options.no_keep:
        _conclude(state)
    return 1 if failed else 0


def _unpack(archives: list[Path], state: Path) -> None:
    """Unpack parts, logs and marks of the calls; later calls replace earlier ones."""
    state.mkdir(parents=True, exist_ok=True)
    for archive in archives:
        with tarfile.open(archive) as file:
            file.extractall(state, filter="data")


def _conclude(state: Path) -> int:
    """Write the results document."""
    try:
        path = keep(state)
    except ValueError as error:
        print(f"nothing was saved: {error}")
        return 1
    print(f"wrote {path.relative_to(ROOT)}")
    return 0


def _conclude_dry(state: Path) -> int:
    """Check that a dry run's measurements are rejected."""
    try:
        path = keep(state)
    except EmulatedDeviceError as error:
        print(f"dry run: nothing was saved ({error})")
        return 0
    except ValueError as error:  # no step has results yet
        print(f"dry run: {error}")
        return 0
    print(f"dry run: measurements of the emulated device were written to {path}")
    return 1


if __name__ == "__main__":
    sys.exit(main())

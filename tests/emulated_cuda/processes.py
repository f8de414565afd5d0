"""Programs on an emulated device, in processes of their own."""

import json
import os
import subprocess
import sys
from collections.abc import Collection
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
START = f"""
import json, os, sys
sys.path[:0] = [{str(ROOT / "src")!r}, {str(ROOT / "tests")!r}]
from emulated_cuda.install import install, installed
install()
import numpy as np
import pointloom as loom

def attempt(action):
    try:
        action()
    except Exception as error:
        return [type(error).__name__, str(error)]
    return ["none", ""]
"""


def run(*program: str, unset: Collection[str] = (), **environment: str) -> Any:
    """What a program prints last, as JSON. It gets the variables of this process but some, and others."""
    variables = {name: value for name, value in os.environ.items() if name not in unset} | environment
    command = [sys.executable, *program]
    done = subprocess.run(command, env=variables, capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stderr[-3000:]
    return json.loads(done.stdout.splitlines()[-1])

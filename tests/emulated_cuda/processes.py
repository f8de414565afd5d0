"""Programs on an emulated device, in processes of their own."""

import json
import os
import subprocess
import sys
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
"""


def run(*program: str, **environment: str) -> Any:
    """What a program prints last, as JSON."""
    command, variables = [sys.executable, *program], os.environ | environment
    done = subprocess.run(command, env=variables, capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stderr[-3000:]
    return json.loads(done.stdout.splitlines()[-1])

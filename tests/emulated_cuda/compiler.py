"""NVRTC, counted; or refused, where a run is to show that kernels compiled ahead leave nothing to compile."""

import ctypes

from .findings import Findings
from .settings import settings

REFUSED = 1
LINK_COUNT = 16  # position of the one argument that is no int
OWN = b"wp_pointloom.", b"wp_cast_"  # not the kernels that tests make up


class Compiler:
    def __init__(self, real: ctypes.CDLL, findings: Findings):
        self.real, self.findings = real, findings

    def wp_cuda_compile_program(self, source, name, *rest):
        if not settings.compiler and name.startswith(OWN):
            self.findings.refuse(f"{name.decode()} would be compiled")
            return REFUSED
        self.findings.counts["modules compiled"] += 1
        before, link_count, after = rest[:LINK_COUNT], ctypes.c_size_t(rest[LINK_COUNT]), rest[LINK_COUNT + 1 :]
        return self.real.wp_cuda_compile_program(source, name, *before, link_count, *after)

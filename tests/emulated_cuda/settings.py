"""All settings, each from the environment's EMULATED_CUDA_<NAME>; tests set them on `settings`."""

import os
from dataclasses import dataclass, fields
from enum import IntEnum

PREFIX = "EMULATED_CUDA_"


class Order(IntEnum):
    FORWARD = 0
    BACKWARD = 1
    SHUFFLED = 2
    INTERLEAVED = 3  # shuffled, and many threads under way at once, switched between memory accesses


@dataclass
class Settings:
    order: int = Order.FORWARD
    seed: int = 1  # of orders 2 and 3
    lazy: bool = True  # a launch runs when something waits for it; False: at once
    races: bool = False  # note accesses of two threads to the same bytes
    uninitialized: bool = True  # note reads of uninitialized bytes
    memory: int = 8 << 30  # bytes of the device
    apart: bool = True  # each small array is an allocation, so that kernels that leave one are seen
    devices: int = 1  # the number of devices; they share the memory, and none can access another's
    compiler: bool = True  # 0: a kernel of pointloom's that would be compiled is a fault
    coverage: str = ""  # a file of marks that kernels set, %p is the process: kernel_coverage.py
    contexts: str = ""  # a folder for the marks that each test sets: plugin.py, with `coverage`
    report: str = ""  # a file for faults, notes and launches as JSON; %p is the process
    cache: str = ""  # where compiled modules are kept, if not in the user's cache folder

    @classmethod
    def from_environment(cls) -> "Settings":
        values = {}
        for field in fields(cls):
            text = os.environ.get(PREFIX + field.name.upper())
            if text is None:
                continue
            kind, name = type(field.default), PREFIX + field.name.upper()
            try:
                values[field.name] = text if kind is str else kind(int(text))
            except ValueError:
                expected = f"0 to {max(Order):d}" if kind is Order else "a whole number"
                raise ValueError(f"{name}: expected {expected}, got {text!r}") from None
        return cls(**values)


settings = Settings.from_environment()

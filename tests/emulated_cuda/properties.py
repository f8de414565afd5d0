"""Properties of the emulated device: one or several H100-like devices with a driver as new as Warp's toolkit."""

import ctypes

from .memory import Memory
from .settings import settings
from .streams import CONTEXT

ARCHITECTURE = 90
MULTIPROCESSORS = 132
STATIC_SHARED, OPT_IN_SHARED = 48 << 10, 232448  # bytes a block: without asking, and at most


class Properties:
    """Answers that never change, and how full the memory is."""

    _CONSTANT = {  # noqa: RUF012
        "wp_cuda_driver_is_initialized": True,
        "wp_cuda_device_get_name": b"Emulated CUDA device",
        "wp_cuda_device_get_arch": ARCHITECTURE,
        "wp_cuda_device_get_sm_count": MULTIPROCESSORS,
        "wp_cuda_device_get_max_shared_memory": OPT_IN_SHARED,
        "wp_cuda_get_max_shared_memory": OPT_IN_SHARED,
        "wp_cuda_device_is_uva": 1,
        "wp_cuda_device_is_mempool_supported": 1,
        "wp_cuda_device_get_pci_bus_id": 1,
        "wp_cuda_device_graph_mem_trim": None,
        "wp_cuda_context_is_primary": 1,
        "wp_cuda_stream_register": None,
    }
    _ZERO = (
        *("wp_cuda_device_get_pageable_memory_access", "wp_cuda_device_get_direct_managed_mem_access_from_host"),
        *("wp_cuda_device_get_host_native_atomic_supported", "wp_cuda_device_get_managed_memory_supported"),
        *("wp_cuda_device_get_concurrent_managed_access_supported", "wp_cuda_device_is_ipc_supported"),
        *("wp_cuda_device_get_pci_domain_id", "wp_cuda_device_get_pci_device_id", "wp_cuda_is_peer_access_enabled"),
        *("wp_cuda_device_get_graph_mem_current", "wp_cuda_is_peer_access_supported", "wp_cuda_context_check"),
        "wp_cuda_is_mempool_access_enabled",
    )

    def __init__(self, real: ctypes.CDLL, memory: Memory):
        self.real, self.memory = real, memory
        for name, value in (self._CONSTANT | dict.fromkeys(self._ZERO, 0)).items():
            setattr(self, name, lambda *_, value=value: value)

    def wp_cuda_device_get_count(self):
        return settings.devices

    def wp_cuda_device_get_primary_context(self, ordinal):
        return CONTEXT + ordinal

    def wp_cuda_driver_version(self):
        return self.real.wp_cuda_toolkit_version()

    def wp_cuda_device_get_uuid(self, _, out):
        ctypes.memset(out, 0xE3, 16)

    def wp_cuda_device_set_mempool_release_threshold(self, _, threshold):
        self.memory.threshold = threshold
        return 1

    def wp_cuda_device_get_mempool_release_threshold(self, _):
        return self.memory.threshold

    def wp_cuda_device_get_mempool_used_mem_current(self, _):
        return self.memory.used

    def wp_cuda_device_get_mempool_used_mem_high(self, _):
        return self.memory.peak

    def wp_cuda_device_get_memory_info(self, _, free, total):
        if free is not None:
            free._obj.value = self.memory.room - self.memory.reserved
        if total is not None:
            total._obj.value = self.memory.room

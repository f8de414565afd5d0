"""A pytest plugin of dry runs, `-p gpu_kit.dry_plugin`: the emulated device is there before Warp starts."""

from gpu_kit.device import start

start()

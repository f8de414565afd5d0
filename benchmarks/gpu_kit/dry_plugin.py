"""A pytest plugin for dry runs, `-p gpu_kit.dry_plugin`: installs the emulated device before Warp starts."""

from gpu_kit.device import start

start()

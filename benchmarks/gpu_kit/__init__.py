"""GPU measurement kit: ordered steps within a time limit; the next run continues.

Run `make gpu-run` on a machine with a GPU. README.md describes machines that are used one command at a time. A dry run
uses the emulated device and writes no measurements.
"""

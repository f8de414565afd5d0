"""What a GPU is asked in its first half-hour, in order and within a time limit; the next run goes on where one ended.

`make gpu-run` on a machine with a GPU; README.md beside this file for one that is reached one command at a time. A dry
run does the same on the emulated device, and can write no figure.
"""

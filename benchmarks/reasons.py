"""Reasons of several benchmarks why a target is not reached, or why a baseline is faster."""

CALL = "The fixed cost of a call: its arrays, checks and launches take 0.1 to 2 ms of Python."
ROUNDS = "Launches of many dependent rounds: each costs the host about 10 us, and the work of a round is smaller."
SPREAD = "{} in another run on the same processor. Two runs differ by up to a fifth."
PROCESSOR = "Not profiled on this processor. On an AMD EPYC (commit 714f22aa, 26 November 2026) the factor was {}."

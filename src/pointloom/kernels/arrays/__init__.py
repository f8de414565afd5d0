"""Primitives over whole arrays: sorting, prefix sums, selection, runs, hashing, random numbers."""

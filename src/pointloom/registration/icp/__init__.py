"""Poses from nearest points: the ICP family."""

"""Strict readers and whole-or-nothing writers."""

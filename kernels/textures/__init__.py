"""Colours for surfaces from pictures."""

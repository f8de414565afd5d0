"""Fragments bent by a lattice (SLAC)."""

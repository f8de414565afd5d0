"""Strict readers, which never invent data, and writers, which write whole or not at all."""

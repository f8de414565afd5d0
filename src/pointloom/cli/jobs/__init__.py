"""Implementation of commands on files."""

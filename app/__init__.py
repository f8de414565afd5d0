"""The command line: what it parses, runs and prints."""

"""The command line: what it parses, runs and prints; its demos and made-up scenes."""

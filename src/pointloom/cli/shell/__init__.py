"""The commands: options, help, pipes."""

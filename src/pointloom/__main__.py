"""`python -m pointloom` is the command `pointloom`."""

from .app.cli import main

main()

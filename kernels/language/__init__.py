"""The compiler front of the kernel language: rules, types, structures and loops, and the two compilers."""

"""What every house stands on: checks, errors, devices, arrays of other libraries, progress, stages that resume."""

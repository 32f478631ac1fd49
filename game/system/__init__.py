"""The operating system: command line, signals, output, files, window, errors."""

"""The operating system: command line, files, window, errors."""

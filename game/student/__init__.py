"""A student's own functions in place of the source's. Their file runs in a child process, asked one question at a time."""

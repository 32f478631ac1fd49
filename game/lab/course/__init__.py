"""The guided course: the scenes in the order of the slides, each with a question, and exercises whose goals are checked."""

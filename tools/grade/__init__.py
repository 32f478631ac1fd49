"""Grading: a student's implementation of the source's functions, in any language, against the conformance vectors."""

"""Conformance vectors: inputs and expected results of every function of the source, for an implementation in any language."""

"""The inputs of the vectors: for each function and each trap, arguments that are simple numbers."""

"""The fuzzer on the compiled engine: many games of every random arena, each tick held against the oracle, compiled, too."""

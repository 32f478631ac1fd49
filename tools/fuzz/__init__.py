"""The fuzzer: random arenas, every tick checked against a geometry that shares no code with the physics."""

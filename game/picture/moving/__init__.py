"""What moves over the arena, as primitives: the same for both views and for every painter."""

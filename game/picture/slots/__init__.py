"""What stands in the slots of the rings: one description, which both views draw."""

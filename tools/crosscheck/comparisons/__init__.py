"""What is compared with pymunk, one question a file."""

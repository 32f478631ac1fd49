"""What a scene is made of: parameters, handles, marks, cited lines."""

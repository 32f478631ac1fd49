"""The solid view: the same rings as prisms under a tilted camera."""

"""The picture of a scene, flat or solid; the modules here serve both views."""

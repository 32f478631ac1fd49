"""The part of cffi that pymunk needs, on top of ctypes, since cffi has no wheel for the browser.

cffi writes tables of all types and functions into the libraries that it builds. This package reads them, and calls the
functions.
"""

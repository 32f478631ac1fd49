"""What pymunk needs of cffi, for the browser, which has no wheel of it: cffi's module `_cffi_backend` over ctypes.

cffi writes tables of all types and functions into the libraries that it builds. They are read here, and the functions called.
"""

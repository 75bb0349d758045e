// Nothing but the precompiled header of this target, which test programs reuse: see shared_headers.cmake.
